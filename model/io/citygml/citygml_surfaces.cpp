// The part of the Assembler that copies surfaces into a Geometry, every vector made in its final size.
#include <limits>

#include "model/io/citygml/citygml_assembly.h"

namespace lodestone::citygml {
namespace {

const Vec2f kNoCoordinate(std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::quiet_NaN());

/// Appends one vertex for each of [begin, end), turned round if asked, through `at(index)`.
template <class At>
void appendRing(Geometry& geometry, std::uint32_t begin, std::uint32_t end, bool flip, At&& at) {
  for (std::uint32_t i = 0; i < end - begin; ++i) {
    geometry.ringVertices.push_back(static_cast<std::uint32_t>(geometry.vertices.size()));
    at(flip ? end - 1 - i : begin + i);
  }
  geometry.ringStart.push_back(static_cast<std::uint32_t>(geometry.ringVertices.size()));
}

void place(std::vector<Vec3>& vertices, const Placement& placement) {
  const auto& m = placement.matrix;
  for (Vec3& p : vertices) {
    const auto row = [&](std::size_t k) {
      return m[k] * p.x() + m[k + 1] * p.y() + m[k + 2] * p.z() + m[k + 3];
    };
    const double w = row(12);
    p = Vec3(row(0), row(4), row(8)) / (w == 0 ? 1 : w) + placement.reference;
  }
}

}  // namespace

void Assembler::copyPoolSurface(Geometry& geometry, const Shown& shown, bool withCoordinates) const {
  const PoolSurface& surface = pool_.surfaces[shown.surface];
  for (std::uint32_t r = surface.ringBegin; r < surface.ringEnd; ++r) {
    const PoolRing& ring = pool_.rings[r];
    appendRing(geometry, ring.begin, ring.end, shown.flip, [&](std::uint32_t i) {
      geometry.vertices.push_back(pool_.points[i]);
      if (!withCoordinates) return;
      geometry.textureCoordinates.push_back(
          ring.coordinates == kNothing ? kNoCoordinate
                                       : pool_.textureCoordinates[ring.coordinates + (i - ring.begin)]);
    });
  }
  geometry.finishSurface({surface.type, surface.material, surface.texture});
}

void Assembler::copySharedSurface(Geometry& geometry, const Shown& shown, bool withCoordinates) {
  const Geometry& from = *shown.shared;
  for (std::uint32_t r = from.surfaceStart[shown.surface]; r < from.surfaceStart[shown.surface + 1]; ++r) {
    appendRing(geometry, from.ringStart[r], from.ringStart[r + 1], shown.flip, [&](std::uint32_t i) {
      geometry.vertices.push_back(from.vertices[from.ringVertices[i]]);
      if (!withCoordinates) return;
      geometry.textureCoordinates.push_back(from.textureCoordinates.empty() ? kNoCoordinate
                                                                            : from.textureCoordinates[i]);
    });
  }
  geometry.finishSurface(from.surfaces[shown.surface]);
}

Geometry Assembler::make(const std::vector<Shown>& surfaces, const Placement* placement) {
  std::size_t rings = 0;
  std::size_t points = 0;
  bool withCoordinates = false;
  for (const Shown& shown : surfaces) {
    if (shown.shared) {
      const Geometry& from = *shown.shared;
      const std::uint32_t begin = from.surfaceStart[shown.surface];
      const std::uint32_t end = from.surfaceStart[shown.surface + 1];
      rings += end - begin;
      points += from.ringStart[end] - from.ringStart[begin];
      withCoordinates = withCoordinates || !from.textureCoordinates.empty();
      continue;
    }
    const PoolSurface& surface = pool_.surfaces[shown.surface];
    rings += surface.ringEnd - surface.ringBegin;
    for (std::uint32_t r = surface.ringBegin; r < surface.ringEnd; ++r) {
      points += pool_.rings[r].end - pool_.rings[r].begin;
      withCoordinates = withCoordinates || pool_.rings[r].coordinates != kNothing;
    }
  }
  Geometry geometry;
  geometry.vertices.reserve(points);
  geometry.ringVertices.reserve(points);
  geometry.ringStart.reserve(rings + 1);
  geometry.surfaceStart.reserve(surfaces.size() + 1);
  geometry.surfaces.reserve(surfaces.size());
  if (withCoordinates) geometry.textureCoordinates.reserve(points);
  for (const Shown& shown : surfaces) {
    if (shown.shared) {
      copySharedSurface(geometry, shown, withCoordinates);
    } else {
      copyPoolSurface(geometry, shown, withCoordinates);
    }
  }
  if (placement) place(geometry.vertices, *placement);
  return geometry;
}

}  // namespace lodestone::citygml
