// unite() and repaired() against CGAL's boolean operations and against point membership.
#include <CGAL/Boolean_set_operations_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_set_2.h>
#include <gtest/gtest.h>

#include "algorithms/footprints/footprints.h"
#include "algorithms/geometry/predicates.h"
#include "tests/support/random_polygons.h"

namespace lodestone {
namespace {

using test::Random;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;

Ring square(double x, double y, double side) {
  return {Vec2(x, y), Vec2(x + side, y), Vec2(x + side, y + side), Vec2(x, y + side)};
}

Ring reversed(Ring ring) {
  std::reverse(ring.begin(), ring.end());
  return ring;
}

double exactUnionArea(const std::vector<Ring>& rings) {
  CGAL::Polygon_set_2<Kernel> set;
  for (const Ring& ring : rings) {
    CGAL::Polygon_2<Kernel> polygon;
    for (const Vec2& p : ring) polygon.push_back(Kernel::Point_2(p.x(), p.y()));
    set.join(polygon);
  }
  std::vector<CGAL::Polygon_with_holes_2<Kernel>> parts;
  set.polygons_with_holes(std::back_inserter(parts));
  double sum = 0;
  for (const auto& part : parts) {
    sum += CGAL::to_double(part.outer_boundary().area());
    for (const auto& hole : part.holes()) sum += CGAL::to_double(hole.area());
  }
  return sum;
}

bool covers(const MultiPolygon& polygons, const Vec2& p) {
  bool inside = false;
  for (const Polygon& polygon : polygons) {
    bool in = sideOf(polygon.outer, p) == Side::Inside;
    for (const Ring& hole : polygon.holes) in = in && sideOf(hole, p) == Side::Outside;
    inside = inside || in;
  }
  return inside;
}

TEST(Unite, NeighboursWithASharedWallBecomeOnePolygon) {
  const MultiPolygon united = unite({{square(0, 0, 2), {}}, {square(2, 0, 2), {}}});
  ASSERT_EQ(united.size(), 1U);
  EXPECT_EQ(united[0].outer, (Ring{Vec2(0, 0), Vec2(4, 0), Vec2(4, 2), Vec2(0, 2)}));
}

TEST(Unite, ReversedRingsAreTurned) {
  const MultiPolygon united = unite({{reversed(square(0, 0, 2)), {square(0.5, 0.5, 1)}}});
  ASSERT_EQ(united.size(), 1U);
  EXPECT_GT(signedArea(united[0].outer), 0);
  ASSERT_EQ(united[0].holes.size(), 1U);
  EXPECT_LT(signedArea(united[0].holes[0]), 0);
}

TEST(Unite, ARingOfPolygonsLeavesACourtyard) {
  MultiPolygon around;
  for (int x = 0; x < 3; ++x) {
    for (int y = 0; y < 3; ++y) {
      if (x != 1 || y != 1) around.push_back({square(x, y, 1), {}});
    }
  }
  const MultiPolygon united = unite(around);
  ASSERT_EQ(united.size(), 1U);
  ASSERT_EQ(united[0].holes.size(), 1U);
  EXPECT_DOUBLE_EQ(area(united), 8);
}

TEST(Unite, NestedAndEqualPolygonsCountOnce) {
  EXPECT_DOUBLE_EQ(area(unite({{square(0, 0, 4), {}}, {square(1, 1, 1), {}}})), 16);
  EXPECT_DOUBLE_EQ(area(unite({{square(0, 0, 4), {}}, {square(0, 0, 4), {}}})), 16);
}

TEST(Unite, PolygonsThatMeetInACornerStayApart) {
  const MultiPolygon united = unite({{square(0, 0, 1), {}}, {square(1, 1, 1), {}}});
  EXPECT_EQ(united.size(), 2U);
  EXPECT_DOUBLE_EQ(area(united), 2);
}

TEST(Unite, BowTieIsRepairedByTheEvenOddRule) {
  const Polygon bowTie{{Vec2(0, 0), Vec2(2, 2), Vec2(2, 0), Vec2(0, 2)}, {}};
  const MultiPolygon parts = repaired(bowTie);
  EXPECT_EQ(parts.size(), 2U);
  EXPECT_DOUBLE_EQ(area(parts), 2);
}

TEST(Unite, NothingIsLeftOfDegenerateRings) {
  EXPECT_TRUE(unite({}).empty());
  EXPECT_TRUE(unite({{{Vec2(0, 0), Vec2(1, 1)}, {}}}).empty());
  EXPECT_TRUE(unite({{{Vec2(0, 0), Vec2(1, 1), Vec2(2, 2)}, {}}}).empty());
}

TEST(Unite, EqualsTheExactUnionOfRandomHousesOnAGrid) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    Random random(seed);
    std::vector<Ring> rings;
    MultiPolygon polygons;
    for (int i = random.integer(2, 7); i > 0; --i) {
      rings.push_back(test::randomGridHouse(random, 8));
      polygons.push_back({rings.back(), {}});
    }
    const MultiPolygon united = unite(polygons);
    EXPECT_DOUBLE_EQ(area(united), exactUnionArea(rings)) << "seed " << seed;
    for (const Polygon& polygon : united) EXPECT_TRUE(isValid(polygon)) << "seed " << seed;
  }
}

TEST(Unite, EqualsTheExactUnionOfRandomStars) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    std::vector<Ring> rings;
    MultiPolygon polygons;
    for (int i = random.integer(2, 5); i > 0; --i) {
      rings.push_back(
          test::randomStar(random, Vec2(random.real(0, 10), random.real(0, 10)), 6, random.integer(5, 12)));
      polygons.push_back({rings.back(), {}});
    }
    const MultiPolygon united = unite(polygons);
    EXPECT_NEAR(area(united), exactUnionArea(rings), 1e-9) << "seed " << seed;
    for (const Polygon& polygon : united) EXPECT_TRUE(isValid(polygon)) << "seed " << seed;
  }
}

TEST(Unite, SelfCrossingRingsCoverWhatTheEvenOddRuleSays) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    Random random(seed);
    Ring ring;
    for (int i = random.integer(4, 9); i > 0; --i) ring.emplace_back(random.real(0, 10), random.real(0, 10));
    const MultiPolygon parts = repaired({ring, {}});
    for (int probe = 0; probe < 200; ++probe) {
      const Vec2 p(random.real(0, 10), random.real(0, 10));
      EXPECT_EQ(covers(parts, p), sideOf(ring, p) == Side::Inside) << "seed " << seed;
    }
  }
}

}  // namespace
}  // namespace lodestone
