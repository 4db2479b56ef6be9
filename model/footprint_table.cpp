#include "model/footprint_table.h"

#include "model/exterior.h"

namespace lodestone {

void FootprintTable::add(const MultiPolygon& footprint, double groundLevel, double buildingHeight) {
  const auto addRing = [this](const Ring& ring, bool hole) {
    vertices.insert(vertices.end(), ring.begin(), ring.end());
    ringStart.push_back(static_cast<std::uint32_t>(vertices.size()));
    ringIsHole.push_back(hole ? 1 : 0);
  };
  for (const Polygon& polygon : footprint) {
    addRing(polygon.outer, false);
    for (const Ring& hole : polygon.holes) addRing(hole, true);
  }
  buildingRing.push_back(static_cast<std::uint32_t>(ringIsHole.size()));
  base.push_back(groundLevel);
  height.push_back(buildingHeight);
  faces.push_back(buildingHeight > 0 ? facesOfBlock(footprint) : FaceCount{});
}

void FootprintTable::add(const Building& building) {
  add(building.footprint, building.base, building.height);
  faces.back() = facesOf(building);
}

MultiPolygon FootprintTable::footprint(std::size_t building) const {
  MultiPolygon result;
  for (std::uint32_t r = buildingRing[building]; r < buildingRing[building + 1]; ++r) {
    Ring ring(vertices.begin() + ringStart[r], vertices.begin() + ringStart[r + 1]);
    if (ringIsHole[r] == 0) {
      result.push_back({std::move(ring), {}});
    } else if (!result.empty()) {
      result.back().holes.push_back(std::move(ring));
    }
  }
  return result;
}

FootprintTable footprintTable(const CityModel& model) {
  FootprintTable table;
  for (const Building& building : model.buildings) table.add(building);
  return table;
}

}  // namespace lodestone
