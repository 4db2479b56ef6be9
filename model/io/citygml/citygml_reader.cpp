#include "model/io/citygml/citygml_reader.h"

#include <algorithm>
#include <cmath>

#include "model/io/citygml/citygml_numbers.h"

namespace lodestone::citygml {
namespace {

/// Properties whose elements are thematic surfaces, whatever an ADE calls them.
bool holdsSurfaces(std::string_view property) {
  return property == "boundedBy" || property == "boundary" || property == "opening" ||
         property == "fillingSurface";
}

bool holdsMembers(std::string_view property) {
  return property.ends_with("Member") || property.ends_with("Members") || property == "member";
}

}  // namespace

Reader::Reader(Knowledge& knowledge, AppearanceTable& table, Reports& reports, Purpose purpose)
    : knowledge_(knowledge),
      reports_(reports),
      purpose_(purpose),
      geometry_(pool_, reports, [this] { return objectId(); }),
      appearance_(table, reports) {
  reports_.setLine([this] { return line(); });
}

Reader::~Reader() {
  reports_.setLine({});
}

void Reader::startElement(const char* name, const char** pairs) {
  const Tag tag = table_.resolve(name);
  const XmlAttributes attributes(pairs);
  if (geometry_.depth() > 0) {
    collecting_ = geometry_.startElement(tag, attributes);
    if (collecting_) text_.clear();
    return;
  }
  if (version.empty() && tag.space == Space::CityGml) noteVersion(tag);
  collecting_ = false;
  Step step;
  step.kind = tag.kind;
  step.name = static_cast<std::uint32_t>(names_.size());
  step.thematic = thematic_;
  step.type = geometry_.surfaceType();
  step.object = object_;
  step.place = placeOf(tag, attributes, step);
  if (collecting_) text_.clear();
  steps_.push_back(step);
}

Reader::Place Reader::placeOf(const Tag& tag, const XmlAttributes& attributes, Step& step) {
  if (steps_.empty()) return startInMember(tag, attributes, step);
  switch (steps_.back().place) {
    case Place::Collection:
      return startInCollection(tag, attributes, step);
    case Place::Member:
      return startInMember(tag, attributes, step);
    case Place::Object:
    case Place::Surface:
      return startProperty(tag, attributes, step);
    case Place::Property:
      return startInProperty(tag, attributes, step);
    case Place::Tree:
      growTree(tag, attributes);
      return Place::Tree;
    case Place::Implicit:
      return startInImplicit(tag, attributes);
    case Place::Relative:
      return GeometryReader::isGeometry(tag.kind) ? startGeometry(tag, attributes) : Place::Skipped;
    case Place::ReferencePoint:
      collecting_ = tag.kind == Kind::Pos;
      return collecting_ ? Place::Text : Place::ReferencePoint;
    case Place::Appearance:
      names_ += tag.local;
      appearance_.startElement(tag, attributes);
      collecting_ = true;
      return Place::Appearance;
    case Place::Skipped:
      // What an ADE wraps may be linked to from standard content.
      if (object_ != kNothing && GeometryReader::isGeometry(tag.kind)) return startGeometry(tag, attributes);
      return Place::Skipped;
    case Place::Geometry:
    case Place::Text:
    case Place::Envelope:
      return Place::Skipped;
  }
  return Place::Skipped;
}

Reader::Place Reader::startInCollection(const Tag& tag, const XmlAttributes& attributes, Step& step) {
  if (tag.space == Space::Gml && tag.local == "name") {
    collecting_ = true;
    return Place::Text;
  }
  // WFS answers and CityGML 0.4 may put features where properties stand.
  if (tag.kind == Kind::Object) return startInMember(tag, attributes, step);
  step.used = holdsMembers(tag.local);
  return Place::Member;
}

Reader::Place Reader::startInMember(const Tag& tag, const XmlAttributes& attributes, Step& step) {
  switch (tag.kind) {
    case Kind::Object:
      return startObject(tag.objectType(), tag, attributes, step);
    case Kind::Surface:
      // A thematic surface on its own hangs on an object without a type.
      (void)startObject(ObjectType::Other, tag, attributes, step);
      geometry_.setSurfaceType(tag.surfaceType());
      return Place::Object;
    case Kind::Transparent:
      return Place::Collection;
    case Kind::Envelope:
      readEnvelope(attributes);
      return Place::Envelope;
    case Kind::Appearance:
      return startAppearance(tag, attributes);
    case Kind::Unknown:
      if (steps_.empty()) return Place::Collection;
      if (steps_.back().used && (tag.space == Space::CityGml || tag.space == Space::Other)) {
        return startObject(ObjectType::Other, tag, attributes, step);
      }
      return Place::Skipped;
    default:
      return Place::Skipped;
  }
}

Reader::Place Reader::startObject(ObjectType type, const Tag& tag, const XmlAttributes& attributes, Step&) {
  PoolObject object;
  object.parent = object_;
  object.object.type = type;
  object.object.id = attributes.gmlId();
  if (object.object.id.empty()) {
    object.object.id = std::string(tag.local) + "@" + std::to_string(line());
    ++unnamed;
  }
  object_ = static_cast<std::uint32_t>(pool_.objects.size());
  pool_.objects.push_back(std::move(object));
  thematic_ = false;
  geometry_.setSurfaceType(SurfaceType::Unknown);
  return Place::Object;
}

Reader::Place Reader::startSurface(SurfaceType type, const Tag& tag, const XmlAttributes& attributes,
                                   Step& step) {
  if (object_ == kNothing) return startInMember(tag, attributes, step);
  thematic_ = true;
  geometry_.setSurfaceType(type);
  return Place::Surface;
}

Reader::Place Reader::startProperty(const Tag& tag, const XmlAttributes& attributes, Step&) {
  if (tag.space == Space::Other) return Place::Skipped;
  names_ += tag.local;
  href_ = attributes.href();
  propertyAttributes_.clear();
  if (!thematic_) copyAttributes(attributes, propertyAttributes_);
  collecting_ = true;
  return Place::Property;
}

Reader::Place Reader::startInProperty(const Tag& tag, const XmlAttributes& attributes, Step& step) {
  Step& property = steps_.back();
  property.used = true;
  const std::string_view name = nameOf(property);
  switch (tag.kind) {
    case Kind::Aggregate:
    case Kind::Solid:
    case Kind::Polygon:
      if (property.draft == kNothing) {
        property.draft = openDraft(tag.kind == Kind::Aggregate ? tag.geometryKind()
                                   : tag.kind == Kind::Solid   ? GeometryKind::Solid
                                                               : GeometryKind::MultiSurface);
      }
      return startGeometry(tag, attributes);
    case Kind::Implicit:
      property.draft = openDraft(GeometryKind::MultiSurface);
      pool_.drafts.back().placement = static_cast<std::int32_t>(pool_.placements.size());
      pool_.placements.emplace_back();
      return Place::Implicit;
    case Kind::Curve:
      // Where a building cuts the ground is told by its walls as well.
      if (name.find("TerrainIntersection") == std::string_view::npos) {
        reports_.once(Code::GeometryUnsupported, std::string(tag.local), objectId());
      }
      return Place::Skipped;
    case Kind::Envelope:
      readEnvelope(attributes);
      return Place::Envelope;
    case Kind::Appearance:
      return startAppearance(tag, attributes);
    case Kind::Object:
      return startObject(tag.objectType(), tag, attributes, step);
    case Kind::Surface:
      return startSurface(tag.surfaceType(), tag, attributes, step);
    case Kind::Ignored:
      return Place::Skipped;
    default:
      // Some writers put boundary surfaces into a geometry property.
      if (holdsSurfaces(tag.local)) return startProperty(tag, attributes, step);
      if (holdsSurfaces(name)) return startSurface(guessSurfaceType(tag.local), tag, attributes, step);
      return tag.space == Space::Other || thematic_ ? Place::Skipped : startTree(tag, attributes);
  }
}

Reader::Place Reader::startInImplicit(const Tag& tag, const XmlAttributes& attributes) {
  switch (tag.kind) {
    case Kind::TransformationMatrix:
      collecting_ = true;
      return Place::Text;
    case Kind::ReferencePoint:
      return Place::ReferencePoint;
    case Kind::RelativeGeometry:
      if (const auto href = attributes.href(); !href.empty()) geometry_.addLink(href);
      return Place::Relative;
    case Kind::LibraryObject:
      reports_.once(Code::GeometryUnsupported, "libraryObject of an ImplicitGeometry: a file of its own",
                    objectId());
      return Place::Skipped;
    default:
      return Place::Skipped;
  }
}

Reader::Place Reader::startGeometry(const Tag& tag, const XmlAttributes& attributes) {
  (void)geometry_.startElement(tag, attributes);
  return Place::Geometry;
}

Reader::Place Reader::startAppearance(const Tag& tag, const XmlAttributes& attributes) {
  if (purpose_ == Purpose::Fetch) return Place::Skipped;
  const bool ofModel = object_ == kNothing;
  if (ofModel) {
    if (knowledge_.appearancesKnown) return Place::Skipped;
    appearancesLate = appearancesLate || !model.buildings.empty() || !model.others.empty();
  }
  appearance_.begin(ofModel ? knowledge_.appearances : ownAppearances_);
  names_ += tag.local;
  appearance_.startElement(tag, attributes);
  return Place::Appearance;
}

Reader::Place Reader::startTree(const Tag& tag, const XmlAttributes& attributes) {
  if (branch_.empty()) {
    tree_ = XmlTree{std::string(nameOf(steps_.back())), {}, propertyAttributes_, {}};
    branch_.assign(1, &tree_);
  }
  growTree(tag, attributes);
  return Place::Tree;
}

void Reader::growTree(const Tag& tag, const XmlAttributes& attributes) {
  XmlTree& child = branch_.back()->children.emplace_back();
  child.local = tag.local;
  copyAttributes(attributes, child.attributes);
  branch_.push_back(&child);
  collecting_ = true;
}

void Reader::readEnvelope(const XmlAttributes& attributes) {
  if (const auto srs = attributes.find("srsName"); model.crs.source.empty() && !srs.empty())
    model.crs.source = srs;
}

void Reader::noteVersion(const Tag& tag) {
  version = tag.version == 0 ? "0.4" : std::to_string(tag.version) + ".0";
  if (tag.version == 0 || tag.version > 3) reports_.once(Code::VersionUnsupported, "CityGML " + version);
}

std::uint32_t Reader::openDraft(GeometryKind kind) {
  const std::string_view name = nameOf(steps_.back());
  Draft draft;
  draft.lod = lodOfProperty(name);
  draft.object = object_;
  draft.begin = static_cast<std::uint32_t>(pool_.items.size());
  draft.kind = kind;
  draft.thematic = thematic_;
  // Footprints and roof edges are told apart by the type that such a surface would have.
  if (name == "lod0FootPrint") geometry_.setSurfaceType(SurfaceType::Ground);
  if (name == "lod0RoofEdge") geometry_.setSurfaceType(SurfaceType::Roof);
  draft.type = geometry_.surfaceType();
  pool_.drafts.push_back(std::move(draft));
  return static_cast<std::uint32_t>(pool_.drafts.size() - 1);
}

std::string Reader::objectId() const {
  return object_ == kNothing ? std::string() : pool_.objects[object_].object.id;
}

}  // namespace lodestone::citygml
