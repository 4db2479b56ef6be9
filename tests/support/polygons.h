// Random polygons for property tests: the same seed gives the same ones.
#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <random>
#include <set>
#include <utility>
#include <vector>

#include "model/geometry.h"

namespace lodestone::test {

/// A star-shaped ring about `center` with corners at sorted random angles; counter-clockwise.
inline Ring randomStar(std::mt19937& random, const Vec2& center, double radius, int corners) {
  std::uniform_real_distribution<double> unit(0, 1);
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = (i + 0.8 * unit(random)) * 2 * std::numbers::pi / corners;
    const double r = radius * (0.35 + 0.65 * unit(random));
    ring.emplace_back(center.x() + r * std::cos(angle), center.y() + r * std::sin(angle));
  }
  return ring;
}

/// A star of radius 100 with small stars cut out near its middle, clockwise; none where a star of so few
/// corners might not hold them.
inline Polygon randomPolygon(std::mt19937& random, int corners, int holes) {
  Polygon polygon{randomStar(random, Vec2(0, 0), 100, corners), {}};
  for (int h = 0; h < holes && corners >= 6; ++h) {
    const double angle = 2 * std::numbers::pi * h / holes;
    Ring hole = randomStar(random, Vec2(8 * std::cos(angle), 8 * std::sin(angle)), 2.2, 3 + h % 4);
    polygon.holes.emplace_back(hole.rbegin(), hole.rend());
  }
  return polygon;
}

/// A blob of unit cells grown at random, as polygon: rings touch themselves and each other at corners, and
/// sides have collinear points. `closeAtPinch`: rings stay with their cell where two corners
/// meet, instead of crossing over to the other.
inline Polygon randomBlob(std::mt19937& random, int cells, bool closeAtPinch) {
  using Cell = std::pair<int, int>;
  std::set<Cell> blob{{0, 0}};
  const Cell steps[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  while (static_cast<int>(blob.size()) < cells) {
    auto it = blob.begin();
    std::advance(it, static_cast<std::ptrdiff_t>(random() % blob.size()));
    const Cell step = steps[random() % 4];
    blob.insert({it->first + step.first, it->second + step.second});
  }
  std::map<Cell, std::set<Cell>> next;  // directed boundary edges, inside on the left
  for (const auto& [x, y] : blob) {
    if (!blob.contains({x, y - 1})) next[{x, y}].insert({x + 1, y});
    if (!blob.contains({x + 1, y})) next[{x + 1, y}].insert({x + 1, y + 1});
    if (!blob.contains({x, y + 1})) next[{x + 1, y + 1}].insert({x, y + 1});
    if (!blob.contains({x - 1, y})) next[{x, y + 1}].insert({x, y});
  }
  Polygon polygon;
  while (!next.empty()) {
    const Cell start = next.begin()->first;
    Cell from{start.first, start.second};
    Cell at = start;
    Ring ring;
    do {
      auto& ways = next[at];
      auto way = ways.begin();
      for (auto it = ways.begin(); it != ways.end() && ways.size() > 1; ++it) {
        const int turn = (at.first - from.first) * (it->second - at.second) -
                         (at.second - from.second) * (it->first - at.first);
        if ((turn > 0) == closeAtPinch) way = it;
      }
      ring.emplace_back(at.first, at.second);
      from = at;
      at = *way;
      ways.erase(way);
      if (ways.empty()) next.erase(from);
    } while (at != start);
    if (signedArea(ring) > 0)
      polygon.outer = ring;
    else
      polygon.holes.push_back(ring);
  }
  return polygon;
}

/// Even-odd, by crossing numbers; points on the outline may go either way.
inline bool contains(const Polygon& polygon, const Vec2& p) {
  bool inside = false;
  const auto cross = [&](const Ring& ring) {
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[j];
      if ((a.y() > p.y()) != (b.y() > p.y()) &&
          p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
        inside = !inside;
      }
    }
  };
  cross(polygon.outer);
  for (const Ring& hole : polygon.holes) cross(hole);
  return inside;
}

}  // namespace lodestone::test
