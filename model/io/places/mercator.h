// Mercator projections, which show a metre longer the farther it lies from the equator.
#pragma once

#include <optional>

#include <GeographicLib/Ellipsoid.hpp>

#include "model/geometry.h"

class OGRSpatialReference;

namespace lodestone {

/// The map between a Mercator projection and longitude, latitude on its own ellipsoid: x = k a (λ − λ0) + x0,
/// y = k a ψ(φ) + y0 with the isometric latitude ψ (J. P. Snyder, Map Projections: A Working Manual, 1987,
/// eq. 7-7), on a sphere for Web Mercator. PROJ has the same, but one object of it serves one thread alone.
class Mercator {
 public:
  /// Nothing for systems that are no normal Mercator projection.
  static std::optional<Mercator> from(const OGRSpatialReference& srs);

  /// Metres to degrees; longitude counts from the central meridian, beyond ±180 too.
  [[nodiscard]] Vec2 toDegrees(const Vec2& metres) const;
  [[nodiscard]] Vec2 toMetres(const Vec2& degrees) const;

 private:
  Mercator(const GeographicLib::Ellipsoid& ellipsoid, double metresPerDegree, const Vec2& falseOrigin)
      : ellipsoid_(ellipsoid), metresPerDegree_(metresPerDegree), falseOrigin_(falseOrigin) {}

  GeographicLib::Ellipsoid ellipsoid_;
  double metresPerDegree_;  ///< on the map, along the parallels
  Vec2 falseOrigin_;        ///< metres
};

}  // namespace lodestone
