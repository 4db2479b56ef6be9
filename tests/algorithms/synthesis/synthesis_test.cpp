#include "algorithms/synthesis/synthesis.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "algorithms/synthesis/synthesis_landmark.h"
#include "model/face_count.h"

namespace lodestone {
namespace {

// Plans stand on eighths of a metre: every predicate below is exact in 64-bit integers.
struct Point {
  std::int64_t x, y;
  bool operator==(const Point&) const = default;
};
using IntRing = std::vector<Point>;

Point pointOf(const Vec2& p) {
  return {static_cast<std::int64_t>(std::llround(p.x() * 8)),
          static_cast<std::int64_t>(std::llround(p.y() * 8))};
}
IntRing ringOf(const Ring& ring) {
  IntRing result;
  for (const Vec2& p : ring) result.push_back(pointOf(p));
  return result;
}
int side(const Point& a, const Point& b, const Point& c) {
  const std::int64_t cross = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return cross > 0 ? 1 : cross < 0 ? -1 : 0;
}
bool onSegment(const Point& a, const Point& b, const Point& p) {
  return side(a, b, p) == 0 && std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
         std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}
bool cross(const Point& a, const Point& b, const Point& c, const Point& d) {
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
  return cross(a, b, c, d) || onSegment(a, b, c) || onSegment(a, b, d) || onSegment(c, d, a) ||
         onSegment(c, d, b);
}
bool strictlyInside(const IntRing& ring, const Point& p) {
  bool in = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if (onSegment(ring[j], ring[i], p)) return false;
    if ((ring[i].y > p.y) != (ring[j].y > p.y)) {
      const int s = side(ring[j], ring[i], p);
      if ((ring[i].y > ring[j].y) == (s > 0)) in = !in;
    }
  }
  return in;
}
bool overlap(const IntRing& a, const IntRing& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      if (cross(a[i], a[(i + 1) % a.size()], b[j], b[(j + 1) % b.size()])) return true;
    }
  }
  const auto anyInside = [](const IntRing& ring, const IntRing& other) {
    return std::any_of(ring.begin(), ring.end(), [&](const Point& p) { return strictlyInside(other, p); });
  };
  return a == b || anyInside(a, b) || anyInside(b, a);
}
void expectValid(const IntRing& ring, bool counterClockwise, const std::string& id) {
  std::int64_t twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point& a = ring[i];
    const Point& b = ring[(i + 1) % ring.size()];
    const Point& c = ring[(i + 2) % ring.size()];
    twice += a.x * b.y - a.y * b.x;
    EXPECT_NE(side(a, b, c), 0) << id << ": repeated or collinear vertex";
    for (std::size_t j = i + 2; j < ring.size(); ++j) {
      if (i == 0 && j + 1 == ring.size()) continue;
      EXPECT_FALSE(meet(a, b, ring[j], ring[(j + 1) % ring.size()])) << id << ": crosses itself";
    }
  }
  EXPECT_EQ(twice > 0, counterClockwise) << id;
}

struct Counts {
  std::size_t vertices = 0, holes = 0, polygons = 0;
};
Counts countsOf(const CityModel& city) {
  Counts counts;
  for (const Building& building : city.buildings) {
    counts.polygons += facesOfBlock(building.footprint).polygons;
    for (const Polygon& polygon : building.footprint) {
      counts.vertices += polygon.outer.size();
      counts.holes += polygon.holes.size();
      for (const Ring& hole : polygon.holes) counts.vertices += hole.size();
    }
  }
  return counts;
}
std::uint64_t fingerprint(const CityModel& city) {
  std::uint64_t hash = 14695981039346656037U;
  const auto add = [&](const void* data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      hash = (hash ^ static_cast<const unsigned char*>(data)[i]) * 1099511628211U;
  };
  for (const Building& building : city.buildings) {
    add(building.object.id.data(), building.object.id.size());
    for (const auto& [name, value] : building.object.attributes) {
      const std::string text = name + "=" + toText(value);
      add(text.data(), text.size());
    }
    add(&building.height, sizeof building.height);
    for (const Polygon& polygon : building.footprint) {
      for (const Vec2& p : polygon.outer) add(p.data(), 2 * sizeof(double));
    }
  }
  for (const auto& line : city.lines.at(0).lines) {
    for (const Vec2& p : line) add(p.data(), 2 * sizeof(double));
  }
  return hash;
}

// All pairs of buildings that a coarse grid cannot tell apart.
template <class Visit>
void forEachClosePair(const std::vector<IntRing>& rings, Visit&& visit) {
  constexpr std::int64_t kCell = 80 * 8;
  std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::size_t>> grid;
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::set<std::pair<std::int64_t, std::int64_t>> cells;
    for (const Point& p : rings[i]) {
      for (const int dx : {-1, 0, 1}) {
        for (const int dy : {-1, 0, 1}) {
          cells.insert({static_cast<std::int64_t>(std::floor(static_cast<double>(p.x) / kCell)) + dx,
                        static_cast<std::int64_t>(std::floor(static_cast<double>(p.y) / kCell)) + dy});
        }
      }
    }
    for (const auto& cell : cells) {
      for (const std::size_t other : grid[cell]) {
        if (seen.insert({other, i}).second) visit(other, i);
      }
      grid[cell].push_back(i);
    }
  }
}

class Presets : public testing::TestWithParam<SynthOptions> {};

TEST_P(Presets, FootprintsAreValidAndDoNotOverlap) {
  const CityModel city = synthesiseCity(GetParam());
  std::vector<IntRing> outers;
  for (const Building& building : city.buildings) {
    ASSERT_EQ(building.footprint.size(), 1U);
    EXPECT_GT(building.height, 0);
    const Polygon& polygon = building.footprint[0];
    for (const Vec2& p : polygon.outer) ASSERT_EQ(p * 8, Vec2(std::round(p.x() * 8), std::round(p.y() * 8)));
    outers.push_back(ringOf(polygon.outer));
    expectValid(outers.back(), true, building.object.id);
    for (const Ring& hole : polygon.holes) {
      expectValid(ringOf(hole), false, building.object.id);
      for (const Vec2& p : hole) EXPECT_TRUE(strictlyInside(outers.back(), pointOf(p)));
    }
  }
  std::size_t pairs = 0;
  forEachClosePair(outers, [&](std::size_t a, std::size_t b) {
    ++pairs;
    EXPECT_FALSE(overlap(outers[a], outers[b]))
        << city.buildings[a].object.id << " and " << city.buildings[b].object.id;
  });
  EXPECT_GT(pairs, city.buildings.size());
}

TEST_P(Presets, StreetsRunBetweenTheBuildings) {
  const CityModel city = synthesiseCity(GetParam());
  ASSERT_EQ(city.lines.size(), 1U);
  ASSERT_EQ(city.lines[0].lines.size(), city.lines[0].kinds.size());
  EXPECT_GT(city.lines[0].lines.size(), 10U);
  for (const auto& line : city.lines[0].lines) {
    const Point a = pointOf(line.front());
    const Point b = pointOf(line.back());
    for (const Building& building : city.buildings) {
      const IntRing ring = ringOf(building.footprint[0].outer);
      for (std::size_t i = 0; i < ring.size(); ++i) {
        EXPECT_FALSE(cross(a, b, ring[i], ring[(i + 1) % ring.size()])) << building.object.id;
      }
    }
  }
}

TEST_P(Presets, IdsAreUnique) {
  const CityModel city = synthesiseCity(GetParam());
  std::set<std::string> ids;
  for (const Building& building : city.buildings) ids.insert(building.object.id);
  EXPECT_EQ(ids.size(), city.buildings.size());
}

INSTANTIATE_TEST_SUITE_P(All, Presets,
                         testing::Values(SynthOptions{CityPreset::Town, 0, 1},
                                         SynthOptions{CityPreset::Town, 900, 77},
                                         SynthOptions{CityPreset::Xinxiang, 3000, 5},
                                         SynthOptions{CityPreset::Charlotte, 3000, 6}));

TEST(Synthesis, PresetsHaveTheCountsOfThePaper) {
  const CityModel xinxiang = synthesiseCity({CityPreset::Xinxiang, 0, 3});
  const Counts x = countsOf(xinxiang);
  EXPECT_EQ(xinxiang.buildings.size(), 95'042U);
  EXPECT_EQ(x.vertices, 502'336U);
  EXPECT_EQ(x.holes, 2U);
  EXPECT_EQ(x.polygons, 814'592U);
  const CityModel charlotte = synthesiseCity({CityPreset::Charlotte, 0, 3});
  const Counts c = countsOf(charlotte);
  EXPECT_EQ(charlotte.buildings.size(), 369'929U);
  EXPECT_EQ(c.vertices, 2'414'056U);
  EXPECT_EQ(c.holes, 0U);
  EXPECT_EQ(c.polygons, 4'088'254U);
}

TEST(Synthesis, VertexBudgetIsSpentExactlyForAnyNumber) {
  for (int n = 1; n < 400; n += 7) {
    for (const int seed : {1, 2, 3}) {
      const CityModel city = synthesiseCity({CityPreset::Charlotte, n, seed});
      ASSERT_EQ(city.buildings.size(), static_cast<std::size_t>(n));
      const std::int64_t steps = std::int64_t{467'170} * n / 369'929;
      EXPECT_EQ(countsOf(city).vertices, static_cast<std::size_t>(4 * n + 2 * steps))
          << n << " seed " << seed;
    }
  }
}

TEST(Synthesis, SameSeedSameBytes) {
  const std::uint64_t town = fingerprint(synthesiseCity({CityPreset::Town, 0, 1}));
  EXPECT_EQ(town, fingerprint(synthesiseCity({CityPreset::Town, 0, 1})));
  EXPECT_NE(town, fingerprint(synthesiseCity({CityPreset::Town, 0, 2})));
}

TEST(Synthesis, TownHasAttributesYardsAndOneLandmark) {
  const CityModel town = synthesiseCity({});
  std::size_t landmarks = 0;
  for (const Building& building : town.buildings) {
    EXPECT_EQ(building.object.attributes.number("height"), building.height);
    EXPECT_TRUE(building.object.attributes.text("use"));
    EXPECT_TRUE(building.object.attributes.number("year"));
    const bool landmark = !building.object.geometries.empty();
    landmarks += landmark ? 1 : 0;
    EXPECT_EQ(building.object.attributes.text("name").has_value(), landmark);
  }
  EXPECT_EQ(landmarks, 1U);
  EXPECT_GE(countsOf(town).holes, 3U);
  EXPECT_EQ(town.crs.epsg, 25832);
}

TEST(Synthesis, StopsWhenAsked) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)synthesiseCity({CityPreset::Charlotte, 0, 1}, Progress({}, stop.get_token())),
               Cancelled);
}

// Every edge of a closed, oriented surface is walked once in each direction.
TEST(SynthesisLandmark, ChurchIsAClosedSolid) {
  const Geometry church = makeChurch({}, Vec3(5, 6, 7));
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  double volume = 0;
  std::set<SurfaceType> types;
  for (std::size_t s = 0; s < church.surfaceCount(); ++s) {
    types.insert(church.surfaces[s].type);
    ASSERT_EQ(church.surfaceStart[s + 1] - church.surfaceStart[s], 1U);
    const std::uint32_t begin = church.ringStart[church.surfaceStart[s]];
    const std::uint32_t end = church.ringStart[church.surfaceStart[s] + 1];
    const auto at = [&](std::uint32_t i) { return church.ringVertices[begin + (i - begin) % (end - begin)]; };
    Vec3 normal = Vec3::Zero();
    const Vec3 first = church.vertices[at(begin)];
    for (std::uint32_t i = begin; i < end; ++i) {
      ++edges[{at(i), at(i + 1)}];
      normal += (church.vertices[at(i)] - first).cross(church.vertices[at(i + 1)] - first);
    }
    volume += first.dot(normal) / 6;
    for (std::uint32_t i = begin; i < end; ++i) {
      EXPECT_NEAR((church.vertices[at(i)] - first).dot(normal.normalized()), 0, 1e-12);
    }
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ(edges.count({edge.second, edge.first}), 1U);
  }
  // Nave with its gable roof, tower, spire.
  EXPECT_NEAR(volume, 32 * 16 * (10 + 8 / 2.0) + 8 * 8 * 30 + 8 * 8 * 18 / 3.0, 1e-6);
  EXPECT_EQ(types, (std::set<SurfaceType>{SurfaceType::Ground, SurfaceType::Wall, SurfaceType::Roof}));
  EXPECT_EQ(church.lod, "2.2");
}

}  // namespace
}  // namespace lodestone
