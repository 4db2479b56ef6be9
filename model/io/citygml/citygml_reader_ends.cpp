// The part of the Reader that closes elements: properties become attributes, top-level objects become the
// model's.
#include <array>
#include <cmath>

#include "model/io/citygml/citygml_numbers.h"
#include "model/io/citygml/citygml_reader.h"

namespace lodestone::citygml {

void Reader::endElement() {
  collecting_ = false;
  if (geometry_.depth() > 0) {
    geometry_.endElement(text_);
    if (geometry_.depth() > 0) return;
  }
  const Step step = steps_.back();
  steps_.pop_back();
  switch (step.place) {
    case Place::Property:
      endProperty(step);
      break;
    case Place::Tree:
      if (branch_.back()->children.empty()) branch_.back()->text = trimmed(text_);
      branch_.pop_back();
      break;
    case Place::Text:
      endText(step);
      break;
    case Place::Appearance:
      appearance_.endElement(nameOf(step), trimmed(text_));
      text_.clear();
      break;
    case Place::Implicit:
      endImplicit();
      break;
    case Place::Relative:
      if (!pool_.targets.empty()) templates_.push_back(pool_.targets.back());
      break;
    case Place::Object:
      endObject(step);
      break;
    case Place::Surface:
      thematic_ = step.thematic;
      geometry_.setSurfaceType(step.type);
      break;
    default:
      break;
  }
  names_.resize(step.name);
}

void Reader::endProperty(const Step& step) {
  const std::string_view name = nameOf(step);
  Attributes& attributes = pool_.objects[object_].object.attributes;
  const bool isLink = !step.used && !href_.empty() && (!lodOfProperty(name).empty() || name == "tin");
  if (isLink) {
    steps_.push_back(step);  // openDraft() reads the name of the property that is open
    const std::uint32_t draft =
        openDraft(name.ends_with("Solid") ? GeometryKind::Solid : GeometryKind::MultiSurface);
    steps_.pop_back();
    geometry_.addLink(href_);
    pool_.drafts[draft].end = static_cast<std::uint32_t>(pool_.items.size());
  } else if (step.draft != kNothing) {
    pool_.drafts[step.draft].end = static_cast<std::uint32_t>(pool_.items.size());
  } else if (!branch_.empty()) {
    addTreeAttribute(attributes, tree_);
    branch_.clear();
  } else if (!step.used && !thematic_) {
    const std::string_view text = trimmed(text_);
    std::string_view uom;
    for (const auto& [key, value] : propertyAttributes_) {
      if (key == "uom") uom = value;
    }
    if (!text.empty() || !href_.empty()) addTextAttribute(attributes, name, text.empty() ? href_ : text, uom);
  }
  geometry_.setSurfaceType(step.type);
}

void Reader::endText(const Step& step) {
  const std::string_view text = trimmed(text_);
  if (step.kind != Kind::TransformationMatrix && step.kind != Kind::Pos) {
    if (title.empty() && steps_.size() == 1) title = text;
    return;
  }
  numbers_.clear();
  const bool good = parseNumbers(text, numbers_);
  Placement& placement = pool_.placements.back();
  if (good && step.kind == Kind::TransformationMatrix && numbers_.size() == placement.matrix.size()) {
    std::copy(numbers_.begin(), numbers_.end(), placement.matrix.begin());
  } else if (good && step.kind == Kind::Pos && numbers_.size() >= 2) {
    placement.reference = Vec3(numbers_[0], numbers_[1], numbers_.size() > 2 ? numbers_[2] : 0);
  } else {
    reports_.add(Code::CoordinateBad, "placement of an ImplicitGeometry", objectId());
  }
}

bool Reader::looksGeographic() const {
  constexpr std::array<std::string_view, 9> kGeographic{"4326", "4979",  "4258", "4937", "6697",
                                                        "6668", "CRS84", "4269", "7844"};
  const Vec3& at = pool_.placements.back().reference;
  if (std::abs(at.x()) > 180 || std::abs(at.y()) > 180) return false;
  const std::string& srs = model.crs.source.empty() ? geometry_.srsName() : model.crs.source;
  return std::any_of(kGeographic.begin(), kGeographic.end(),
                     [&](std::string_view code) { return srs.find(code) != std::string::npos; });
}

void Reader::endImplicit() {
  // Metres about a point in degrees: only the georeference could tell what they mean, and it comes later.
  const bool geographic = looksGeographic();
  if (geographic)
    reports_.once(Code::GeometryUnsupported, "ImplicitGeometry in a geographic coordinate system",
                  objectId());
  const bool tooMany = placed_.full();
  if (tooMany) reports_.once(Code::CountImplausible, PlacedTemplates::kTooOften, objectId());
  if (!geographic && !tooMany) return;
  pool_.drafts.pop_back();
  steps_.back().draft = kNothing;
}

void Reader::endObject(const Step& step) {
  object_ = step.object;
  thematic_ = step.thematic;
  geometry_.setSurfaceType(step.type);
  if (object_ == kNothing) finishTopLevel();
}

void Reader::finishTopLevel() {
  if (purpose_ == Purpose::Fetch) {
    fetchWanted();
  } else {
    const std::string id = pool_.objects.front().object.id;
    ownAppearances_.apply(pool_, reports_, id);
    knowledge_.appearances.apply(pool_, reports_, id);
    Assembler assembler(pool_, knowledge_.shared, reports_);
    for (const Target& target : templates_) {
      if (!knowledge_.shared.contains(target.id))
        knowledge_.shared.emplace(target.id, assembler.extract(target));
    }
    for (CityObject& object : assembler.assemble()) placeInModel(std::move(object));
    wanted.insert(assembler.missing().begin(), assembler.missing().end());
    placed_.add(assembler.placed());
  }
  if (model.crs.source.empty()) model.crs.source = geometry_.srsName();
  pool_.clear();
  ownAppearances_.clear();
  templates_.clear();
}

void Reader::fetchWanted() {
  Assembler assembler(pool_, knowledge_.shared, reports_);
  for (std::size_t i = 0; i < pool_.targets.size(); ++i) {
    const Target target = pool_.targets[i];
    if (!wanted.contains(target.id) || knowledge_.shared.contains(target.id)) continue;
    knowledge_.shared.emplace(target.id, assembler.extract(target));
  }
}

void Reader::placeInModel(CityObject object) {
  forEachObject(object, [&](const CityObject& o) { reportDuplicate(o); });
  if (object.type != ObjectType::Building) {
    model.others.push_back(std::move(object));
    return;
  }
  Building& building = model.buildings.emplace_back();
  building.object = std::move(object);
}

void Reader::reportDuplicate(const CityObject& object) {
  if (!ids_.insert(idHash(object.id)).second) reports_.add(Code::DuplicateId, object.id, object.id);
}

}  // namespace lodestone::citygml
