#include "model/io/footprints/footprint_repair.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include <ogr_geometry.h>

#include "model/io/gdal_support.h"

namespace lodestone {
namespace {

// A ring narrower than this share of its length has no area: a needle of 10 m is then thinner than 1e-8 m.
constexpr double kNarrow = 1e-9;
constexpr std::size_t kQuadraticUpTo = 64;

void note(std::vector<Code>& codes, Code code) {
  if (std::find(codes.begin(), codes.end(), code) == codes.end()) codes.push_back(code);
}

bool finite(const Ring& ring) {
  return std::all_of(ring.begin(), ring.end(), [](const Vec2& p) { return p.allFinite(); });
}

double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

// All points on one line. The area alone does not tell: the halves of a bow-tie cancel.
bool flat(const Ring& ring) {
  const Vec2& first = ring.front();
  const Vec2& far = *std::max_element(ring.begin(), ring.end(), [&](const Vec2& a, const Vec2& b) {
    return (a - first).squaredNorm() < (b - first).squaredNorm();
  });
  const double limit = kNarrow * (far - first).squaredNorm();
  return std::all_of(ring.begin(), ring.end(),
                     [&](const Vec2& p) { return std::abs(turn(first, far, p)) <= limit; });
}

// True only when the two edges are clearly apart; rounding and touching count as not clear.
bool clearlyApart(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  if (std::max(a.x(), b.x()) < std::min(c.x(), d.x()) || std::max(c.x(), d.x()) < std::min(a.x(), b.x()))
    return true;
  if (std::max(a.y(), b.y()) < std::min(c.y(), d.y()) || std::max(c.y(), d.y()) < std::min(a.y(), b.y()))
    return true;
  const double doubt = 1e-12 * ((b - a).squaredNorm() + (d - c).squaredNorm() + (c - a).squaredNorm());
  const double abc = turn(a, b, c);
  const double abd = turn(a, b, d);
  if ((abc > doubt && abd > doubt) || (abc < -doubt && abd < -doubt)) return true;
  const double cda = turn(c, d, a);
  const double cdb = turn(c, d, b);
  return (cda > doubt && cdb > doubt) || (cda < -doubt && cdb < -doubt);
}

bool plainlySimple(const Ring& ring) {
  const std::size_t n = ring.size();
  if (n > kQuadraticUpTo) return false;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2& a = ring[i];
    const Vec2& b = ring[(i + 1) % n];
    const Vec2& c = ring[(i + 2) % n];
    // A spike runs back on itself.
    if (std::abs(turn(a, b, c)) <= 1e-12 * (b - a).squaredNorm() && (b - a).dot(c - b) < 0) return false;
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      if (!clearlyApart(a, b, ring[j], ring[(j + 1) % n])) return false;
    }
  }
  return true;
}

std::unique_ptr<OGRLinearRing> toOgr(const Ring& ring, const Vec2& shift) {
  auto result = std::make_unique<OGRLinearRing>();
  result->setNumPoints(static_cast<int>(ring.size()) + 1, FALSE);
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Vec2 p = ring[i % ring.size()] - shift;
    result->setPoint(static_cast<int>(i), p.x(), p.y());
  }
  return result;
}

std::unique_ptr<OGRPolygon> toOgr(const Polygon& polygon, const Vec2& shift) {
  auto result = std::make_unique<OGRPolygon>();
  result->addRingDirectly(toOgr(polygon.outer, shift).release());
  for (const Ring& hole : polygon.holes) result->addRingDirectly(toOgr(hole, shift).release());
  return result;
}

Ring fromOgr(const OGRLinearRing& ring, const Vec2& shift) {
  Ring result;
  result.reserve(static_cast<std::size_t>(ring.getNumPoints()));
  for (int i = 0; i < ring.getNumPoints(); ++i)
    result.emplace_back(ring.getX(i) + shift.x(), ring.getY(i) + shift.y());
  return result;
}

void collect(const OGRGeometry& geometry, const Vec2& shift, MultiPolygon& polygons) {
  const OGRwkbGeometryType type = wkbFlatten(geometry.getGeometryType());
  if (type == wkbPolygon) {
    const OGRPolygon& source = *geometry.toPolygon();
    if (source.IsEmpty()) return;
    Polygon polygon;
    polygon.outer = fromOgr(*source.getExteriorRing(), shift);
    for (int i = 0; i < source.getNumInteriorRings(); ++i) {
      polygon.holes.push_back(fromOgr(*source.getInteriorRing(i), shift));
    }
    polygons.push_back(std::move(polygon));
  } else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection)) {
    for (const OGRGeometry* part : *geometry.toGeometryCollection()) collect(*part, shift, polygons);
  }
}

// Repeated points and rings without area go; the orientation is made ours.
bool tidy(Ring& ring, bool outer, std::vector<Code>& codes) {
  if (!finite(ring)) {
    note(codes, Code::CoordinateBad);
    return false;
  }
  tidyRing(ring, outer);
  if (ring.size() < 3) {
    note(codes, outer ? Code::RingTooShort : Code::HoleDropped);
    return false;
  }
  if (flat(ring)) {
    note(codes, outer ? Code::RingZeroArea : Code::HoleDropped);
    return false;
  }
  return true;
}

bool tidy(Polygon& polygon, std::vector<Code>& codes) {
  if (!tidy(polygon.outer, true, codes)) return false;
  std::erase_if(polygon.holes, [&](Ring& hole) { return !tidy(hole, false, codes); });
  return true;
}

// Which shift keeps the digits that matter: GEOS computes in plain doubles.
Vec2 shiftOf(const Polygon& polygon) {
  return polygon.outer.front();
}

void dropHolesOutside(Polygon& polygon, const Vec2& shift, std::vector<Code>& codes) {
  const auto outer = toOgr(Polygon{polygon.outer, {}}, shift);
  const std::unique_ptr<OGRGeometry> valid(outer->MakeValid());
  if (!valid) return;
  std::erase_if(polygon.holes, [&](const Ring& hole) {
    const std::unique_ptr<OGRGeometry> area(toOgr(Polygon{hole, {}}, shift)->MakeValid());
    const bool outside = area && (!valid->Intersects(area.get()) || valid->Touches(area.get()));
    if (outside) note(codes, Code::HoleOutside);
    return outside;
  });
}

void appendTidied(MultiPolygon& to, MultiPolygon from) {
  std::vector<Code> slivers;  // of the repair itself: nobody's concern
  for (Polygon& polygon : from) {
    if (tidy(polygon, slivers)) to.push_back(std::move(polygon));
  }
}

void repairPolygon(Polygon polygon, RepairedFootprint& result) {
  if (polygon.holes.empty() && plainlySimple(polygon.outer)) {
    result.polygons.push_back(std::move(polygon));
    return;
  }
  const Vec2 shift = shiftOf(polygon);
  if (toOgr(polygon, shift)->IsValid()) {
    result.polygons.push_back(std::move(polygon));
    return;
  }
  dropHolesOutside(polygon, shift, result.codes);
  const auto source = toOgr(polygon, shift);
  if (source->IsValid()) {
    result.polygons.push_back(std::move(polygon));
    return;
  }
  const bool crossing = !toOgr(Polygon{polygon.outer, {}}, shift)->IsValid();
  note(result.codes, crossing ? Code::RingSelfIntersecting : Code::FootprintRepaired);
  const std::unique_ptr<OGRGeometry> valid(source->MakeValid());
  if (!valid) return;
  MultiPolygon pieces;
  collect(*valid, shift, pieces);
  appendTidied(result.polygons, std::move(pieces));
}

// Parts of one building that overlap or share a side make one outline.
void uniteParts(RepairedFootprint& result) {
  const Vec2 shift = shiftOf(result.polygons.front());
  OGRMultiPolygon parts;
  for (const Polygon& polygon : result.polygons) parts.addGeometryDirectly(toOgr(polygon, shift).release());
  if (parts.IsValid()) return;
  const std::unique_ptr<OGRGeometry> whole(parts.UnionCascaded());
  if (!whole) return;
  note(result.codes, Code::FootprintRepaired);
  MultiPolygon pieces;
  collect(*whole, shift, pieces);
  result.polygons.clear();
  appendTidied(result.polygons, std::move(pieces));
}

}  // namespace

RepairedFootprint repairFootprint(MultiPolygon raw) {
  RepairedFootprint result;
  std::erase_if(raw, [&](Polygon& polygon) { return !tidy(polygon, result.codes); });
  const bool simple = raw.size() == 1 && raw.front().holes.empty() && plainlySimple(raw.front().outer);
  if (raw.empty() || simple) {
    result.polygons = std::move(raw);
    return result;
  }
  const GdalErrors quiet;
  for (Polygon& polygon : raw) repairPolygon(std::move(polygon), result);
  if (result.polygons.size() > 1) uniteParts(result);
  return result;
}

}  // namespace lodestone
