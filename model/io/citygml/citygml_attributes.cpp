#include "model/io/citygml/citygml_attributes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "model/io/citygml/citygml_numbers.h"
#include "model/io/json_writing.h"

namespace lodestone::citygml {
namespace {

constexpr std::array<std::string_view, 6> kRealNames{"measuredHeight", "averageHeight", "height",
                                                     "trunkDiameter",  "crownDiameter", "rootBallDiameter"};
constexpr std::array<std::string_view, 4> kWholeNames{"storeysAboveGround", "storeysBelowGround",
                                                      "yearOfConstruction", "yearOfDemolition"};

template <std::size_t N>
bool isOneOf(const std::array<std::string_view, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::optional<std::int64_t> parseWhole(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string asJson(const AttributeValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return jsonQuoted(*text);
  return toText(value);
}

/// A second value under a name makes a list of both.
void append(Attributes& attributes, std::string_view name, AttributeValue value) {
  const AttributeValue* present = attributes.find(name);
  if (!present) return attributes.set(name, std::move(value));
  const auto* list = std::get_if<JsonText>(present);
  if (list && list->text.starts_with('[')) {
    attributes.set(name, JsonText{list->text.substr(0, list->text.size() - 1) + "," + asJson(value) + "]"});
  } else {
    attributes.set(name, JsonText{"[" + asJson(*present) + "," + asJson(value) + "]"});
  }
}

/// What a generic attribute's kind ("intAttribute", "IntAttribute") makes of its text.
AttributeValue genericValue(std::string_view kind, std::string_view text) {
  if (kind.ends_with("ntAttribute")) {
    if (const auto whole = parseWhole(text)) return *whole;
  } else if (kind.ends_with("oubleAttribute") || kind.ends_with("easureAttribute")) {
    if (const auto number = parseNumber(text)) return *number;
  }
  return std::string(text);
}

bool isGeneric(std::string_view local) {
  constexpr std::array<std::string_view, 7> kKinds{"tringAttribute", "ntAttribute", "oubleAttribute",
                                                   "ateAttribute",   "riAttribute", "easureAttribute",
                                                   "odeAttribute"};
  return std::any_of(kKinds.begin(), kKinds.end(), [&](std::string_view kind) {
    return local.size() == kind.size() + 1 && local.ends_with(kind);
  });
}

bool isGenericSet(std::string_view local) {
  return local == "genericAttributeSet" || local == "GenericAttributeSet";
}

/// CityGML 1 and 2 name a generic attribute in an XML attribute, CityGML 3 in an element.
std::string_view genericName(const XmlTree& tree) {
  if (const auto name = tree.attribute("name"); !name.empty()) return name;
  const XmlTree* name = tree.child("name");
  return name ? std::string_view(name->text) : std::string_view();
}

std::string setAsJson(const XmlTree& set);

std::string genericAsJson(const XmlTree& tree) {
  if (isGenericSet(tree.local)) return setAsJson(tree);
  const XmlTree* value = tree.child("value");
  if (!value) return "null";
  const std::string json = asJson(genericValue(tree.local, value->text));
  const auto uom = value->attribute("uom");
  return uom.empty() ? json : fmt::format("{{\"value\":{},\"uom\":{}}}", json, jsonQuoted(uom));
}

std::string setAsJson(const XmlTree& set) {
  std::string out = "{";
  for (const XmlTree& child : set.children) {
    const XmlTree& member =
        child.local == "genericAttribute" && !child.children.empty() ? child.children[0] : child;
    if (!isGeneric(member.local) && !isGenericSet(member.local)) continue;
    if (out.size() > 1) out += ',';
    out += jsonQuoted(genericName(member)) + ":" + genericAsJson(member);
  }
  return out + "}";
}

void addGeneric(Attributes& attributes, const XmlTree& tree) {
  const std::string name(genericName(tree));
  if (name.empty()) return;
  if (isGenericSet(tree.local)) return append(attributes, name, JsonText{setAsJson(tree)});
  const XmlTree* value = tree.child("value");
  if (!value) return;
  append(attributes, name, genericValue(tree.local, value->text));
  if (const auto uom = value->attribute("uom"); !uom.empty()) attributes.set(name + ".uom", std::string(uom));
}

/// CityGML 3's con:height says from where to where; its figure is what CityGML 2 called measuredHeight.
void addHeight(Attributes& attributes, const XmlTree& property) {
  const XmlTree* height = property.child("Height");
  const XmlTree* value = height ? height->child("value") : nullptr;
  const auto number = value ? parseNumber(value->text) : std::nullopt;
  if (number && !attributes.find("measuredHeight")) {
    attributes.set("measuredHeight", *number);
    if (const auto uom = value->attribute("uom"); !uom.empty())
      attributes.set("measuredHeight.uom", std::string(uom));
  }
  append(attributes, property.local, JsonText{toJson(height ? *height : property)});
}

}  // namespace

const XmlTree* XmlTree::child(std::string_view name) const {
  const auto it =
      std::find_if(children.begin(), children.end(), [&](const XmlTree& c) { return c.local == name; });
  return it == children.end() ? nullptr : &*it;
}

std::string_view XmlTree::attribute(std::string_view name) const {
  for (const auto& [key, value] : attributes) {
    if (key == name) return value;
  }
  return {};
}

void copyAttributes(const XmlAttributes& from, std::vector<std::pair<std::string, std::string>>& to) {
  to.clear();
  for (const char** pair = from.pairs(); *pair; pair += 2) {
    std::string_view name(pair[0]);
    const std::size_t separator = name.find(kSeparator);
    const std::string_view local = separator == std::string_view::npos ? name : name.substr(separator + 1);
    const bool schemaHint = name.starts_with("http://www.w3.org/2001/XMLSchema-instance");
    if (schemaHint || local == "id" || local == "codeSpace") continue;
    to.emplace_back(local, pair[1]);
  }
}

std::string toJson(const XmlTree& tree) {
  if (tree.children.empty() && tree.attributes.empty()) return jsonQuoted(tree.text);
  std::string out = "{";
  const auto field = [&](std::string_view name, const std::string& json) {
    if (out.size() > 1) out += ',';
    out += jsonQuoted(name) + ":" + json;
  };
  for (const auto& [name, value] : tree.attributes) field(name, jsonQuoted(value));
  if (!tree.text.empty()) field("value", jsonQuoted(tree.text));
  std::vector<bool> written(tree.children.size());
  for (std::size_t i = 0; i < tree.children.size(); ++i) {
    if (written[i]) continue;
    std::string json;
    std::size_t count = 0;
    for (std::size_t j = i; j < tree.children.size(); ++j) {
      if (tree.children[j].local != tree.children[i].local) continue;
      written[j] = true;
      json += (count++ == 0 ? "" : ",") + toJson(tree.children[j]);
    }
    field(tree.children[i].local, count == 1 ? json : "[" + json + "]");
  }
  return out + "}";
}

void addTextAttribute(Attributes& attributes, std::string_view local, std::string_view text,
                      std::string_view uom) {
  if (isOneOf(kRealNames, local)) {
    if (const auto number = parseNumber(text)) {
      append(attributes, local, *number);
      if (!uom.empty()) attributes.set(std::string(local) + ".uom", std::string(uom));
      return;
    }
  } else if (isOneOf(kWholeNames, local)) {
    if (const auto whole = parseWhole(text)) return append(attributes, local, *whole);
  } else if (local == "dateOfConstruction" && !attributes.find("yearOfConstruction")) {
    if (const auto year = parseWhole(text.substr(0, text.find('-'))))
      attributes.set("yearOfConstruction", *year);
  }
  append(attributes, local, std::string(text));
}

void addTreeAttribute(Attributes& attributes, const XmlTree& property) {
  if (isGeneric(property.local) || isGenericSet(property.local)) return addGeneric(attributes, property);
  if (property.local == "genericAttribute" && !property.children.empty()) {
    return addGeneric(attributes, property.children.front());
  }
  if (property.local == "height") return addHeight(attributes, property);
  append(attributes, property.local, JsonText{toJson(property)});
}

}  // namespace lodestone::citygml
