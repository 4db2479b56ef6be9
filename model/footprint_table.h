// The footprints of all buildings, stored flat: the input of clustering and merging.
#pragma once

#include <cstdint>
#include <vector>

#include "model/city_model.h"
#include "model/face_count.h"

namespace lodestone {

/// Building i has the rings [buildingRing[i], buildingRing[i+1]); ring r has the vertices
/// vertices[ringStart[r] … ringStart[r+1]). Outer rings are counter-clockwise, holes clockwise and after
/// their outer ring. A building without a footprint has no rings.
struct FootprintTable {
  std::vector<Vec2> vertices;
  std::vector<std::uint32_t> ringStart{0};
  std::vector<std::uint8_t> ringIsHole;
  std::vector<std::uint32_t> buildingRing{0};
  std::vector<double> base;      ///< z of the ground, metres
  std::vector<double> height;    ///< metres above base
  std::vector<FaceCount> faces;  ///< of each building when it is drawn itself

  [[nodiscard]] std::size_t buildingCount() const { return buildingRing.size() - 1; }
  [[nodiscard]] std::size_t ringCount() const { return ringIsHole.size(); }
  /// A building that is drawn as the block over its footprint, if it has a height.
  void add(const MultiPolygon& footprint, double base, double height);
  /// A building that is drawn by what it has.
  void add(const Building& building);
  [[nodiscard]] MultiPolygon footprint(std::size_t building) const;
};

[[nodiscard]] FootprintTable footprintTable(const CityModel& model);

}  // namespace lodestone
