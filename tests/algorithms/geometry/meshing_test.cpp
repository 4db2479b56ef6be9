#include "algorithms/geometry/meshing.h"

#include <map>
#include <numeric>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "tests/support/polygons.h"

namespace lodestone {
namespace {

using IndexTriangle = std::array<std::uint32_t, 3>;

std::vector<Vec2> pointsOf(const Polygon& polygon) {
  std::vector<Vec2> points = polygon.outer;
  for (const Ring& hole : polygon.holes) points.insert(points.end(), hole.begin(), hole.end());
  return points;
}

double areaOf(const std::vector<Vec2>& points, const IndexTriangle& t) {
  return signedArea({points[t[0]], points[t[1]], points[t[2]]});
}

std::vector<IndexTriangle> renamed(std::vector<IndexTriangle> triangles,
                                   const std::vector<std::uint32_t>& name) {
  for (IndexTriangle& t : triangles) t = {name[t[0]], name[t[1]], name[t[2]]};
  return triangles;
}

/// Directed edges that have no opposite, by index.
template <class Triangles>
std::map<std::pair<std::uint32_t, std::uint32_t>, int> openEdges(const Triangles& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const IndexTriangle& t : triangles) {
    for (int i = 0; i < 3; ++i) {
      ++balance[{t[i], t[(i + 1) % 3]}];
      --balance[{t[(i + 1) % 3], t[i]}];
    }
  }
  std::erase_if(balance, [](const auto& entry) { return entry.second <= 0; });
  return balance;
}

/// Number of the first point at each point's place.
template <class Point>
std::vector<std::uint32_t> placesOf(const std::vector<Point>& points) {
  std::vector<std::uint32_t> places;
  for (const Point& p : points) {
    places.push_back(static_cast<std::uint32_t>(std::find(points.begin(), points.end(), p) - points.begin()));
  }
  return places;
}

/// How corners are told apart. A ring that crosses over to another corner at the same place has no triangles
/// whose border it is, index by index.
enum class Corners { ByIndex, ByPlace };

/// The whole contract of triangulate(Polygon) for a polygon whose rings are the right way round.
void expectTriangulated(const Polygon& polygon, std::mt19937& random, Corners corners = Corners::ByIndex) {
  bool broken = true;
  const std::vector<IndexTriangle> triangles = triangulate(polygon, &broken);
  EXPECT_FALSE(broken);
  const std::vector<Vec2> points = pointsOf(polygon);
  double sum = 0;
  for (const IndexTriangle& t : triangles) {
    EXPECT_GT(areaOf(points, t), 0);
    EXPECT_TRUE(test::contains(polygon, (points[t[0]] + points[t[1]] + points[t[2]]) / 3));
    sum += areaOf(points, t);
  }
  EXPECT_NEAR(sum, area(polygon), 1e-9 * area(polygon));

  // Any point is in as many triangles as it is in polygons: none or one.
  const Box2 box = bounds(polygon.outer);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int i = 0; i < 50; ++i) {
    const Vec2 p = box.min + Vec2(unit(random), unit(random)).cwiseProduct(box.size());
    int covered = 0;
    for (const IndexTriangle& t : triangles) {
      covered += test::contains({{points[t[0]], points[t[1]], points[t[2]]}, {}}, p) ? 1 : 0;
    }
    EXPECT_EQ(covered, test::contains(polygon, p) ? 1 : 0);
  }

  // The border of the triangles is the rings, corner by corner.
  std::vector<std::uint32_t> name(points.size());
  std::iota(name.begin(), name.end(), 0U);
  if (corners == Corners::ByPlace) name = placesOf(points);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> ringEdges;
  std::uint32_t begin = 0;
  const auto addRing = [&](const Ring& ring) {
    const auto n = static_cast<std::uint32_t>(ring.size());
    for (std::uint32_t i = 0; i < n; ++i) ringEdges[{name[begin + i], name[begin + (i + 1) % n]}] = 1;
    begin += n;
  };
  addRing(polygon.outer);
  for (const Ring& hole : polygon.holes) addRing(hole);
  EXPECT_EQ(openEdges(renamed(triangles, name)), ringEdges);
}

std::vector<IndexTriangle> indicesOf(const std::vector<LevelObject::Triangle>& triangles) {
  std::vector<IndexTriangle> result;
  for (const auto& t : triangles) result.push_back(t.vertices);
  return result;
}

double volumeOf(const Geometry& geometry, const std::vector<LevelObject::Triangle>& triangles) {
  const Vec3 origin = geometry.vertices.front();
  double six = 0;
  for (const auto& t : triangles) {
    six +=
        (geometry.vertices[t.vertices[0]] - origin)
            .dot(
                (geometry.vertices[t.vertices[1]] - origin).cross(geometry.vertices[t.vertices[2]] - origin));
  }
  return six / 6;
}

void expectClosedBlock(const MultiPolygon& footprint, double base, double height,
                       Corners corners = Corners::ByIndex) {
  const Geometry block = makeBlock(footprint, base, height);
  const auto triangles = triangulate(block);
  std::vector<IndexTriangle> indices = indicesOf(triangles);
  if (corners == Corners::ByPlace) indices = renamed(indices, placesOf(block.vertices));
  EXPECT_TRUE(openEdges(indices).empty());
  EXPECT_NEAR(volumeOf(block, triangles), area(footprint) * height, 1e-9 * area(footprint) * height);
  ASSERT_EQ(block.surfaceStart.size(), block.surfaceCount() + 1);
  EXPECT_EQ(block.surfaceStart.back(), block.ringCount());
  EXPECT_EQ(block.ringStart.back(), block.ringVertices.size());
  EXPECT_EQ(block.solidStart.size(), footprint.size() + 1);
  EXPECT_EQ(block.shellStart.back(), block.surfaceCount());
}

Polygon moved(Polygon polygon, const Vec2& by) {
  for (Vec2& p : polygon.outer) p += by;
  for (Ring& hole : polygon.holes) {
    for (Vec2& p : hole) p += by;
  }
  return polygon;
}

TEST(Triangulate, RandomPolygonsWithAndWithoutHoles) {
  std::mt19937 random(1);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    expectTriangulated(test::randomPolygon(random, 3 + i % 60, i % 5), random);
  }
}

TEST(Triangulate, RingsThatTouchThemselvesAndEachOther) {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    SCOPED_TRACE(i);
    const bool close = i % 2 == 0;
    expectTriangulated(test::randomBlob(random, 1 + i, close), random,
                       close ? Corners::ByIndex : Corners::ByPlace);
  }
}

TEST(Triangulate, LargeCoordinates) {
  std::mt19937 random(3);
  const Vec2 far(4470000.25, 5330000.5);
  for (int i = 0; i < 50; ++i) expectTriangulated(moved(test::randomBlob(random, 1 + i, true), far), random);
}

TEST(Triangulate, EitherOrientationGivesCounterClockwiseTriangles) {
  std::mt19937 random(4);
  for (int i = 0; i < 40; ++i) {
    Polygon polygon = test::randomPolygon(random, 3 + i, i % 4);
    const std::size_t expected = triangulate(polygon).size();
    std::reverse(polygon.outer.begin(), polygon.outer.end());
    if (i % 2 == 0) {
      for (Ring& hole : polygon.holes) std::reverse(hole.begin(), hole.end());
    }
    const auto triangles = triangulate(polygon);
    EXPECT_EQ(triangles.size(), expected);
    double sum = 0;
    for (const IndexTriangle& t : triangles) {
      EXPECT_GT(areaOf(pointsOf(polygon), t), 0);
      sum += areaOf(pointsOf(polygon), t);
    }
    EXPECT_NEAR(sum, area(polygon), 1e-9 * sum);
  }
}

TEST(Triangulate, NumberOfTrianglesIsEulers) {
  std::mt19937 random(5);
  for (int i = 0; i < 60; ++i) {
    const Polygon polygon = test::randomPolygon(random, 3 + i, i % 5);
    EXPECT_EQ(triangulate(polygon).size(), pointsOf(polygon).size() - 2 + 2 * polygon.holes.size());
  }
}

TEST(Triangulate, HoleThatSharesAnEdgeWithItsOuterRing) {
  const Polygon polygon{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 0}, {1, 2}, {3, 2}, {3, 0}}}};
  bool broken = true;
  const auto triangles = triangulate(polygon, &broken);
  EXPECT_FALSE(broken);
  double sum = 0;
  for (const IndexTriangle& t : triangles) sum += areaOf(pointsOf(polygon), t);
  EXPECT_DOUBLE_EQ(sum, 12);
}

TEST(Triangulate, NearlyCollinearPointsKeepTheirOrientation) {
  Ring ring{{0, 0}};
  for (int i = 1; i <= 40; ++i) ring.emplace_back(i * 0.1, i * 0.1 * (1 + (i % 2 == 0 ? 1e-16 : -1e-16)));
  ring.emplace_back(0, 4);
  const auto triangles = triangulate(Polygon{ring, {}});
  double sum = 0;
  for (const IndexTriangle& t : triangles) sum += areaOf(ring, t);
  EXPECT_NEAR(sum, 8, 1e-12);
}

TEST(Triangulate, CrossingRingIsSaidAndStillDrawn) {
  const Polygon bowTie{{{0, 0}, {4, 4}, {4, 0}, {0, 3}}, {}};
  bool broken = false;
  EXPECT_FALSE(triangulate(bowTie, &broken).empty());
  EXPECT_TRUE(broken);
}

TEST(Triangulate, RingsWithoutAreaHaveNoTriangles) {
  EXPECT_TRUE(triangulate(Polygon{}).empty());
  EXPECT_TRUE(triangulate(Polygon{{{0, 0}, {1, 1}}, {}}).empty());
  EXPECT_TRUE(triangulate(Polygon{{{0, 0}, {1, 1}, {2, 2}}, {}}).empty());
  EXPECT_TRUE(triangulate(Polygon{{{3, 3}, {3, 3}, {3, 3}}, {}}).empty());
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(triangulate(Polygon{{{0, 0}, {1, nan}, {2, 2}}, {}}).empty());
}

TEST(Triangulate, RepeatedPointsAndSpikesDoNoHarm) {
  const Polygon polygon{{{0, 0}, {0, 0}, {4, 0}, {4, 0}, {4, 4}, {6, 6}, {4, 4}, {0, 4}, {0, 0}},
                        {{{1, 1}, {1, 1}}}};
  double sum = 0;
  for (const IndexTriangle& t : triangulate(polygon)) sum += areaOf(pointsOf(polygon), t);
  EXPECT_DOUBLE_EQ(sum, 16);
}

TEST(TriangulateGeometry, SurfacesFaceTheWayTheirRingDoes) {
  std::mt19937 random(6);
  std::normal_distribution<double> normal(0, 1);
  for (int i = 0; i < 100; ++i) {
    const Polygon polygon = test::randomPolygon(random, 3 + i % 20, i % 3);
    const Vec3 u = Vec3(normal(random), normal(random), normal(random)).normalized();
    const Vec3 v = u.cross(Vec3(normal(random), normal(random), normal(random))).normalized();
    const Vec3 facing = u.cross(v);
    Geometry geometry;
    const auto place = [&](const Ring& ring) {
      std::vector<Vec3> placed;
      for (const Vec2& p : ring) placed.emplace_back(u * p.x() + v * p.y());
      geometry.addRing(placed);
    };
    place(polygon.outer);
    for (const Ring& hole : polygon.holes) place(hole);
    geometry.finishSurface();
    double sum = 0;
    for (const auto& t : triangulate(geometry)) {
      const auto& p = geometry.vertices;
      const Vec3 twice = (p[t.vertices[1]] - p[t.vertices[0]]).cross(p[t.vertices[2]] - p[t.vertices[0]]);
      EXPECT_GT(twice.dot(facing), 0);
      sum += twice.dot(facing) / 2;
    }
    EXPECT_NEAR(sum, area(polygon), 1e-6);
  }
}

TEST(TriangulateGeometry, SkipsWhatHasNoAreaAndNamesWhatCrosses) {
  Geometry geometry;
  geometry.addRing({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
  geometry.finishSurface();
  geometry.addRing({{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 3, 0}});
  geometry.finishSurface();
  geometry.addRing({{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}});  // a saddle
  geometry.finishSurface();
  geometry.finishSurface();  // no rings at all
  std::vector<std::uint32_t> broken;
  const auto triangles = triangulate(geometry, &broken);
  EXPECT_EQ(broken, std::vector<std::uint32_t>{1});
  EXPECT_EQ(std::count_if(triangles.begin(), triangles.end(), [](const auto& t) { return t.surface == 2; }),
            2);
  EXPECT_EQ(std::count_if(triangles.begin(), triangles.end(), [](const auto& t) { return t.surface == 0; }),
            0);
}

TEST(MakeBlock, IsClosedAndHasItsVolume) {
  std::mt19937 random(7);
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    expectClosedBlock({test::randomPolygon(random, 3 + i, i % 5)}, -3, 12.5);
    expectClosedBlock({test::randomBlob(random, 1 + i, true)}, 100, 4);
    expectClosedBlock({test::randomBlob(random, 1 + i, false)}, 100, 4, Corners::ByPlace);
    expectClosedBlock(
        {test::randomBlob(random, 1 + i, true), moved(test::randomPolygon(random, 5, 1), {500, 0})}, 0, 1);
  }
}

TEST(MakeBlock, NamesItsSurfacesAndCountsAsThePaperDoes) {
  const MultiPolygon footprint{{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}};
  const Geometry block = makeBlock(footprint, 10, 5);
  ASSERT_EQ(block.surfaceCount(), 10U);
  EXPECT_EQ(block.surfaces.front().type, SurfaceType::Ground);
  EXPECT_EQ(block.surfaces.back().type, SurfaceType::Roof);
  std::size_t walls = 0;
  std::size_t roof = 0;
  for (const SurfaceInfo& surface : block.surfaces) walls += surface.type == SurfaceType::Wall ? 1 : 0;
  for (const auto& t : triangulate(block))
    roof += block.surfaces[t.surface].type == SurfaceType::Roof ? 1 : 0;
  EXPECT_EQ(walls + roof, facesOfBlock(footprint).polygons);
  for (const Vec3& p : block.vertices) EXPECT_TRUE(p.z() == 10 || p.z() == 15);
}

TEST(MakeBlock, CountsTheSameWithLabelsAndWithout) {
  const MultiPolygon footprint{
      {{{0, 0}, {4, 0}, {4, 4}, {2, 5}, {0, 4}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}};
  Geometry block = makeBlock(footprint, 0, 3);
  EXPECT_EQ(facesOf(block), facesOfBlock(footprint));
  EXPECT_EQ(facesOf(block).triangles, triangulate(block).size());
  for (SurfaceInfo& surface : block.surfaces) surface.type = SurfaceType::Unknown;
  EXPECT_EQ(facesOf(block), facesOfBlock(footprint));
}

TEST(MakeBlock, OfNothingIsEmpty) {
  EXPECT_EQ(makeBlock({}, 0, 1).surfaceCount(), 0U);
  EXPECT_TRUE(triangulate(makeBlock({}, 0, 1)).empty());
}

}  // namespace
}  // namespace lodestone
