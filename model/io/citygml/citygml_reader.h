// One pass over a CityGML document: the state machine above GML geometry.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "model/city_model.h"
#include "model/io/citygml/citygml_appearance.h"
#include "model/io/citygml/citygml_assembly.h"
#include "model/io/citygml/citygml_attributes.h"
#include "model/io/citygml/citygml_geometry.h"
#include "model/io/citygml/citygml_names.h"
#include "model/io/citygml/citygml_pool.h"
#include "model/io/citygml/citygml_reports.h"
#include "model/io/citygml/citygml_xml.h"
#include "model/io/placed_templates.h"

namespace lodestone::citygml {

/// What one pass finds out for the next. Most files need one pass: a second one is for appearances that come
/// after what they colour, and for links across top-level objects, whose targets are kept from nobody's
/// memory but fetched when they are known to be wanted.
struct Knowledge {
  AppearanceLinks appearances;    ///< of the city model
  bool appearancesKnown = false;  ///< all of them, from a pass before
  SharedGeometry shared;          ///< templates, and targets of links across objects
};

enum class Purpose {
  Build,  ///< make the model
  Fetch,  ///< put the wanted geometry into Knowledge::shared, and make nothing
};

class Reader final : public XmlHandler {
 public:
  Reader(Knowledge& knowledge, AppearanceTable& table, Reports& reports, Purpose purpose);
  ~Reader() override;
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  void startElement(const char* name, const char** attributes) override;
  void endElement() override;

  /// Links that this pass is to fetch, or that it found leading out of their object.
  std::unordered_set<std::uint64_t> wanted;
  CityModel model;
  std::string version;  ///< of the first CityGML namespace: "2.0"; empty: none was seen
  std::string title;
  /// Appearances of the city model came after objects that they may colour.
  bool appearancesLate = false;
  std::size_t unnamed = 0;  ///< objects without an id

 private:
  enum class Place : std::uint8_t {
    Collection,
    Member,
    Object,
    Surface,
    Property,
    Tree,
    Geometry,
    Implicit,
    Relative,
    ReferencePoint,
    Text,
    Envelope,
    Appearance,
    Skipped,
  };
  struct Step {
    Place place = Place::Skipped;
    Kind kind = Kind::Unknown;
    bool used = false;      ///< a property that had a child
    bool thematic = false;  ///< to return to, as are the next two
    SurfaceType type = SurfaceType::Unknown;
    std::uint32_t object = kNothing;
    std::uint32_t draft = kNothing;  ///< of a property
    std::uint32_t name = 0;          ///< begin of a property's name in names_
  };

  [[nodiscard]] Place placeOf(const Tag& tag, const XmlAttributes& attributes, Step& step);
  [[nodiscard]] Place startInCollection(const Tag& tag, const XmlAttributes& attributes, Step& step);
  [[nodiscard]] Place startInMember(const Tag& tag, const XmlAttributes& attributes, Step& step);
  [[nodiscard]] Place startProperty(const Tag& tag, const XmlAttributes& attributes, Step& step);
  [[nodiscard]] Place startInProperty(const Tag& tag, const XmlAttributes& attributes, Step& step);
  [[nodiscard]] Place startInImplicit(const Tag& tag, const XmlAttributes& attributes);
  [[nodiscard]] Place startGeometry(const Tag& tag, const XmlAttributes& attributes);
  [[nodiscard]] Place startAppearance(const Tag& tag, const XmlAttributes& attributes);
  [[nodiscard]] Place startTree(const Tag& tag, const XmlAttributes& attributes);
  [[nodiscard]] Place startObject(ObjectType type, const Tag& tag, const XmlAttributes& attributes,
                                  Step& step);
  [[nodiscard]] Place startSurface(SurfaceType type, const Tag& tag, const XmlAttributes& attributes,
                                   Step& step);
  void growTree(const Tag& tag, const XmlAttributes& attributes);
  void readEnvelope(const XmlAttributes& attributes);
  void noteVersion(const Tag& tag);

  std::uint32_t openDraft(GeometryKind kind);
  void endProperty(const Step& step);
  void endText(const Step& step);
  void endImplicit();
  void endObject(const Step& step);
  void finishTopLevel();
  void fetchWanted();
  void placeInModel(CityObject object);
  void reportDuplicate(const CityObject& object);
  [[nodiscard]] bool looksGeographic() const;

  [[nodiscard]] std::string_view nameOf(const Step& step) const {
    return std::string_view(names_).substr(step.name);
  }
  [[nodiscard]] std::string objectId() const;

  Knowledge& knowledge_;
  Reports& reports_;
  Purpose purpose_;
  NameTable table_;
  GeometryPool pool_;
  GeometryReader geometry_;
  AppearanceReader appearance_;
  AppearanceLinks ownAppearances_;  ///< of the top-level object being read
  std::vector<Step> steps_;
  std::string names_;                ///< names of the open properties, one after the other
  std::uint32_t object_ = kNothing;  ///< being read
  bool thematic_ = false;            ///< inside a thematic surface
  std::vector<std::pair<std::string, std::string>> propertyAttributes_;
  std::string href_;
  XmlTree tree_;
  std::vector<XmlTree*> branch_;  ///< from the root of tree_ to the element being read
  std::vector<double> numbers_;
  std::vector<Target> templates_;  ///< of the top-level object being read
  std::unordered_set<std::uint64_t> ids_;
  PlacedTemplates placed_;
};

}  // namespace lodestone::citygml
