// Attributes of CityGML features: plain ones, generic ones of all kinds, and structured ones kept as JSON.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/attributes.h"
#include "model/io/citygml/citygml_names.h"

namespace lodestone::citygml {

/// An element with all below it, namespaces dropped.
struct XmlTree {
  std::string local;
  std::string text;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlTree> children;

  [[nodiscard]] const XmlTree* child(std::string_view name) const;
  [[nodiscard]] std::string_view attribute(std::string_view name) const;
};

/// Copies the attributes of an element, without namespaces, schema hints and gml:id.
void copyAttributes(const XmlAttributes& from, std::vector<std::pair<std::string, std::string>>& to);

/// JSON of a subtree: text alone is a string, repeated children are lists, text beside attributes is "value".
[[nodiscard]] std::string toJson(const XmlTree& tree);

/// A property with text alone. Counts, years and heights become numbers, a measure's unit stands in
/// "NAME.uom", and a repeated property becomes a JSON list.
void addTextAttribute(Attributes& attributes, std::string_view local, std::string_view text,
                      std::string_view uom);

/// A property with elements in it: generic attributes and sets of CityGML 1–3, heights of CityGML 3 (which
/// also give measuredHeight), and anything else as JSON.
void addTreeAttribute(Attributes& attributes, const XmlTree& property);

}  // namespace lodestone::citygml
