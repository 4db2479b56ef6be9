// Made-up towns for tests: random, gridded, touching, overlapping, broken.
#pragma once

#include <algorithm>
#include <cmath>
#include <random>

#include "model/footprint_table.h"

namespace lodestone::test {

inline Ring rectangle(double x, double y, double w, double h) {
  return {Vec2(x, y), Vec2(x + w, y), Vec2(x + w, y + h), Vec2(x, y + h)};
}

inline void addRing(FootprintTable& table, Ring ring) {
  table.add({{std::move(ring), {}}}, 0, 10);
}

inline Ring randomBuilding(std::mt19937& random, const Vec2& centre, double radius) {
  std::uniform_real_distribution<double> share(0.4, 1);
  const int corners = std::uniform_int_distribution<int>(3, 9)(random);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * 3.14159265358979 * i / corners;
    ring.push_back(centre + radius * share(random) * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

/// Buildings anywhere: some overlap, some stand in each other, sizes differ widely.
inline FootprintTable randomTown(std::uint32_t seed, int buildings) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> place(0, 30 * std::sqrt(buildings));
  std::lognormal_distribution<double> radius(1.8, 0.7);
  FootprintTable table;
  for (int i = 0; i < buildings; ++i) {
    const double x = place(random);
    const double y = place(random);
    addRing(table, randomBuilding(random, Vec2(x, y), radius(random)));
  }
  return table;
}

/// Streets of houses on whole metres: rows whose houses share walls, equal gaps everywhere, in shuffled
/// order.
inline FootprintTable griddedTown(std::uint32_t seed, int buildings) {
  std::mt19937 random(seed);
  const int side = static_cast<int>(std::ceil(std::sqrt(buildings)));
  std::vector<Ring> houses;
  for (int i = 0; i < buildings; ++i) {
    const int column = i % side;
    const int row = i / side;
    houses.push_back(rectangle(10 * column + 12 * (column / 5), 10 * row + 15 * (row / 2), 10, 10));
  }
  std::shuffle(houses.begin(), houses.end(), random);
  FootprintTable table;
  for (Ring& house : houses) addRing(table, std::move(house));
  return table;
}

/// Every kind of trouble: equal footprints, overlaps, courtyards with a house in them, parts, buildings
/// without a footprint.
inline FootprintTable oddTown(std::uint32_t seed, int buildings) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> place(0, 12);
  std::uniform_int_distribution<int> kind(0, 9);
  FootprintTable table;
  while (static_cast<int>(table.buildingCount()) < buildings) {
    const double x = 10 * place(random);
    const double y = 10 * place(random);
    switch (kind(random)) {
      case 0:
        table.add({}, 0, 0);
        break;
      case 1:
        table.add({{rectangle(x, y, 30, 30),
                    {{Vec2(x + 8, y + 8), Vec2(x + 8, y + 22), Vec2(x + 22, y + 22), Vec2(x + 22, y + 8)}}}},
                  0, 9);
        break;
      case 2:
        table.add({{rectangle(x, y, 4, 4), {}}, {rectangle(x + 20, y, 4, 4), {}}}, 0, 9);
        break;
      case 3:
        addRing(table, rectangle(x + 13, y + 13, 4, 4));
        break;
      case 4:
        addRing(table, rectangle(x, y, 100, 2));
        break;
      default:
        addRing(table, rectangle(x, y, 10, 10));
        break;
    }
  }
  return table;
}

/// A row of houses whose gaps grow or are all the same.
inline FootprintTable rowOfHouses(int buildings, double gap, double growth) {
  FootprintTable table;
  double x = 0;
  for (int i = 0; i < buildings; ++i) {
    addRing(table, rectangle(x, 0, 8, 10));
    x += 8 + gap;
    gap *= growth;
  }
  return table;
}

}  // namespace lodestone::test
