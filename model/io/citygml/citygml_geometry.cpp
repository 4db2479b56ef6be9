#include "model/io/citygml/citygml_geometry.h"

#include <fmt/format.h>

#include "model/io/citygml/citygml_numbers.h"

namespace lodestone::citygml {

bool GeometryReader::startElement(const Tag& tag, const XmlAttributes& attributes) {
  Step step;
  step.kind = tag.kind;
  step.dimension = static_cast<std::int8_t>(dimension_);
  const Place parent = steps_.empty() ? Place::Member : steps_.back().place;
  switch (parent) {
    case Place::Aggregate:
    case Place::Member:
    case Place::Boundary:
      if (tag.kind == Kind::Ring && parent == Place::Boundary) {
        step.place = Place::Ring;
        readDimension(attributes);
        startRing(attributes);
      } else if (isGeometry(tag.kind)) {
        startGeometry(step, tag, attributes);
      } else if (tag.kind == Kind::Curve) {
        noteUnsupported(tag);
      } else if (parent == Place::Aggregate) {
        step.place = Place::Member;
        if (const auto href = attributes.href(); !href.empty()) addLink(href);
      } else if (tag.space == Space::CityGml) {
        reports_.once(Code::AppearanceBad, std::string(tag.local) + " of a TexturedSurface", object_());
      }
      break;
    case Place::Solid:
      if (tag.kind != Kind::Boundary) break;
      step.place = Place::Member;
      pool_.addItem(ItemKind::Shell);
      if (const auto href = attributes.href(); !href.empty()) addLink(href);
      break;
    case Place::Polygon:
      if (tag.kind != Kind::Boundary) break;
      step.place = Place::Boundary;
      step.interior = tag.local.starts_with("in");
      break;
    case Place::Ring:
    case Place::InRing:
      if (tag.kind == Kind::PosList || tag.kind == Kind::Pos || tag.kind == Kind::Coordinates) {
        step.place = Place::Numbers;
        readDimension(attributes);
      } else {
        step.place = Place::InRing;
      }
      break;
    case Place::Numbers:
    case Place::Skipped:
      break;
  }
  steps_.push_back(step);
  return step.place == Place::Numbers;
}

void GeometryReader::startGeometry(Step& step, const Tag& tag, const XmlAttributes& attributes) {
  readDimension(attributes);
  if (srsName_.empty()) srsName_ = attributes.find("srsName");
  step.id = idHash(attributes.gmlId());
  step.item = static_cast<std::uint32_t>(pool_.items.size());
  step.target = static_cast<std::uint32_t>(pool_.targets.size());
  if (tag.kind == Kind::Aggregate) {
    step.place = Place::Aggregate;
    step.flip = attributes.find("orientation") == "-";
  } else if (tag.kind == Kind::Solid) {
    step.place = Place::Solid;
    pool_.addItem(ItemKind::Solid);
  } else {
    step.place = Place::Polygon;
    spoiled_ = false;
    PoolSurface surface;
    surface.ringBegin = static_cast<std::uint32_t>(pool_.rings.size());
    surface.type = type_;
    pool_.surfaces.push_back(surface);
  }
}

void GeometryReader::readDimension(const XmlAttributes& attributes) {
  const std::string_view text = attributes.find("srsDimension");
  if (text == "2") dimension_ = 2;
  if (text == "3") dimension_ = 3;
}

void GeometryReader::startRing(const XmlAttributes& attributes) {
  PoolRing ring;
  ring.begin = static_cast<std::uint32_t>(pool_.points.size());
  ring.id = idHash(attributes.gmlId());
  pool_.rings.push_back(ring);
}

void GeometryReader::endElement(std::string_view text) {
  const Step step = steps_.back();
  steps_.pop_back();
  switch (step.place) {
    case Place::Aggregate:
      if (step.flip) pool_.flip(step.item, step.target);
      pool_.name(step.id, step.item);
      break;
    case Place::Solid:
      pool_.addItem(ItemKind::SolidEnd);
      pool_.name(step.id, step.item);
      break;
    case Place::Polygon:
      endPolygon(step);
      break;
    case Place::Ring:
      endRing(steps_.back());
      break;
    case Place::Numbers:
      endNumbers(step.kind, text);
      break;
    case Place::Member:
    case Place::Boundary:
    case Place::InRing:
    case Place::Skipped:
      break;
  }
  dimension_ = step.dimension;
}

void GeometryReader::endPolygon(const Step& step) {
  PoolSurface& surface = pool_.surfaces.back();
  surface.ringEnd = static_cast<std::uint32_t>(pool_.rings.size());
  if (surface.ringBegin == surface.ringEnd) spoil(Code::RingTooShort, "a polygon without rings");
  surface.valid = !spoiled_;
  pool_.addItem(ItemKind::Surface, static_cast<std::uint32_t>(pool_.surfaces.size() - 1));
  pool_.name(step.id, step.item);
}

bool GeometryReader::hasThreePoints(const PoolRing& ring) const {
  std::uint32_t different = 0;
  for (std::uint32_t i = ring.begin; i < ring.end && different < 3; ++i) {
    if (i == ring.begin || pool_.points[i] != pool_.points[i - 1]) ++different;
  }
  return different >= 3;
}

void GeometryReader::endRing(const Step& boundary) {
  PoolRing& ring = pool_.rings.back();
  ring.end = static_cast<std::uint32_t>(pool_.points.size());
  if (ring.end - ring.begin > 1 && pool_.points[ring.begin] == pool_.points[ring.end - 1]) {
    pool_.points.pop_back();
    --ring.end;
  }
  if (hasThreePoints(ring)) return;
  const bool outerMissing = pool_.rings.size() - 1 == pool_.surfaces.back().ringBegin;
  if (boundary.interior && !outerMissing) {
    reports_.add(Code::HoleDropped, {}, object_());
    pool_.points.resize(ring.begin);
    pool_.rings.pop_back();
  } else {
    spoil(Code::RingTooShort, {});
  }
}

void GeometryReader::endNumbers(Kind kind, std::string_view text) {
  numbers_.clear();
  int dimension = dimension_;
  bool good = true;
  if (kind == Kind::Coordinates) {
    dimension = parseCoordinates(text, numbers_);
    good = dimension == 2 || dimension == 3;
  } else {
    good = parseNumbers(text, numbers_);
    // Nothing tells the dimension: three, unless the count allows two alone.
    if (dimension == 0) dimension = numbers_.size() % 3 == 0 || numbers_.size() % 2 != 0 ? 3 : 2;
  }
  if (!good) return spoil(Code::CoordinateBad, {});
  if (numbers_.size() % static_cast<std::size_t>(dimension) != 0) {
    return spoil(Code::CoordinateBad,
                 fmt::format("{} numbers make no points of {}", numbers_.size(), dimension));
  }
  addPoints(dimension);
}

void GeometryReader::addPoints(int dimension) {
  const auto step = static_cast<std::size_t>(dimension);
  for (std::size_t i = 0; i + step <= numbers_.size(); i += step) {
    pool_.points.emplace_back(numbers_[i], numbers_[i + 1], dimension == 3 ? numbers_[i + 2] : 0);
  }
}

void GeometryReader::addLink(std::string_view reference) {
  if (!isLocalLink(reference)) {
    reports_.add(Code::XlinkOutside, std::string(reference), object_());
    return;
  }
  pool_.addItem(ItemKind::Link, 0, linkHash(reference));
}

void GeometryReader::spoil(Code code, const std::string& text) {
  if (!spoiled_) reports_.add(code, text, object_());
  spoiled_ = true;
}

void GeometryReader::noteUnsupported(const Tag& tag) {
  reports_.once(Code::GeometryUnsupported, std::string(tag.local), object_());
}

}  // namespace lodestone::citygml
