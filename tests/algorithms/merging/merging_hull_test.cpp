// mergedHull() against the reference that follows the text, and its rules as properties.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "algorithms/geometry/predicates.h"
#include "algorithms/merging/merging.h"
#include "tests/support/random_polygons.h"
#include "tests/support/reference_hull.h"

namespace lodestone {
namespace {

using test::brokenRule;
using test::Random;
using test::referenceHull;

constexpr double kRatios[] = {0.4, 0.75, 0.9, 1.0};

std::size_t targetOf(const std::vector<Ring>& children, double ratio) {
  std::size_t edges = 0;
  for (const Ring& child : children) edges += child.size();
  return static_cast<std::size_t>(std::floor(ratio * static_cast<double>(edges)));
}

void expectSameAsReference(const std::vector<Ring>& children, const std::string& what) {
  for (const double ratio : kRatios) {
    const std::size_t target = targetOf(children, ratio);
    const Ring hull = mergedHull(children, target);
    ASSERT_EQ(hull, referenceHull(children, target)) << what << ", ratio " << ratio;
    ASSERT_EQ(brokenRule(hull, children, target), "") << what << ", ratio " << ratio;
  }
}

Ring rectangle(double x0, double y0, double x1, double y1) {
  return {Vec2(x0, y0), Vec2(x1, y0), Vec2(x1, y1), Vec2(x0, y1)};
}

TEST(MergedHull, TwoHousesInARowBecomeOneBlock) {
  EXPECT_EQ(mergedHull({rectangle(0, 0, 2, 3), rectangle(4, 0, 6, 3)}, 6), rectangle(0, 0, 6, 3));
}

TEST(MergedHull, ARectangleInLineWithAnLIsFollowed) {
  const Ring ell{Vec2(0, 0), Vec2(4, 0), Vec2(4, 1), Vec2(1, 1), Vec2(1, 4), Vec2(0, 4)};
  const Ring hull = mergedHull({ell, rectangle(6, 0, 8, 1)}, 7);
  EXPECT_EQ(hull, (Ring{Vec2(0, 0), Vec2(8, 0), Vec2(8, 1), Vec2(1, 1), Vec2(1, 4), Vec2(0, 4)}));
}

TEST(MergedHull, EqualAndNestedChildren) {
  EXPECT_EQ(mergedHull({rectangle(0, 0, 2, 2), rectangle(0, 0, 2, 2)}, 6), rectangle(0, 0, 2, 2));
  EXPECT_EQ(mergedHull({rectangle(0, 0, 9, 9), rectangle(2, 2, 3, 3)}, 6), rectangle(0, 0, 9, 9));
}

TEST(MergedHull, OneChildGivesItsOwnOutlineWhenItMay) {
  const Ring ell{Vec2(0, 0), Vec2(4, 0), Vec2(4, 1), Vec2(1, 1), Vec2(1, 4), Vec2(0, 4)};
  EXPECT_EQ(mergedHull({ell}, 6), ell);
  EXPECT_EQ(mergedHull({ell}, 5).size(), 5U);
}

TEST(MergedHull, AConvexHullAboveTheTargetIsKept) {
  EXPECT_EQ(mergedHull({rectangle(0, 0, 2, 2), rectangle(5, 5, 7, 7)}, 3).size(), 6U);
}

TEST(MergedHull, NothingComesOfRingsWithoutArea) {
  EXPECT_TRUE(mergedHull({}, 4).empty());
  EXPECT_TRUE(mergedHull({{}}, 4).empty());
  EXPECT_TRUE(mergedHull({{Vec2(0, 0), Vec2(1, 1), Vec2(3, 3)}}, 4).empty());
}

TEST(MergedHull, EqualsTheReferenceOnHousesOnAGrid) {  // touching, equal, nested, overlapping, in line
  for (unsigned seed = 1; seed <= 120; ++seed) {
    Random random(seed);
    std::vector<Ring> children;
    for (int i = random.integer(1, 4); i > 0; --i) children.push_back(test::randomGridHouse(random, 9));
    expectSameAsReference(children, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(MergedHull, EqualsTheReferenceOnStarsApart) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    const std::vector<Ring> children{
        test::randomStar(random, Vec2(0, 0), 5, random.integer(4, 11)),
        test::randomStar(random, Vec2(random.real(10, 14), random.real(-4, 4)), 5, random.integer(4, 11))};
    expectSameAsReference(children, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

TEST(MergedHull, EqualsTheReferenceOnOverlappingStars) {
  for (unsigned seed = 1; seed <= 30; ++seed) {
    Random random(seed);
    std::vector<Ring> children;
    for (int i = random.integer(2, 3); i > 0; --i) {
      const Ring star =
          test::randomStar(random, Vec2(random.real(0, 8), random.real(0, 8)), 6, random.integer(4, 10), 0.5);
      if (isSimple(star) && signedArea(star) > 0) children.push_back(star);
    }
    if (children.empty()) continue;
    expectSameAsReference(children, "seed " + std::to_string(seed));
    if (HasFatalFailure()) return;
  }
}

/// The children of a real tree are themselves hulls, so that two of them interlock.
TEST(MergedHull, EqualsTheReferenceUpATreeOfHouses) {
  for (unsigned seed = 1; seed <= 12; ++seed) {
    Random random(seed);
    std::vector<Ring> row;
    for (int i = 0; i < 8; ++i) {
      row.push_back(seed % 2 == 0 ? test::randomGridHouse(random, 14)
                                  : test::randomStar(random, Vec2(random.real(0, 25), random.real(0, 12)), 3,
                                                     random.integer(4, 7)));
    }
    while (row.size() > 1) {
      std::vector<Ring> parents;
      for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
        const std::vector<Ring> children{row[i], row[i + 1]};
        const std::size_t target = targetOf(children, 0.75);
        parents.push_back(mergedHull(children, target));
        ASSERT_EQ(parents.back(), referenceHull(children, target)) << "seed " << seed;
        ASSERT_EQ(brokenRule(parents.back(), children, target), "") << "seed " << seed;
      }
      row = parents;
    }
  }
}

TEST(MergedHull, RulesHoldOnLargeInterlockingRings) {
  for (unsigned seed = 1; seed <= 4; ++seed) {
    Random random(seed);
    const std::vector<Ring> children{test::randomStar(random, Vec2(0, 0), 50, 200),
                                     test::randomStar(random, Vec2(random.real(30, 120), 10), 50, 200)};
    for (const double ratio : kRatios) {
      const std::size_t target = targetOf(children, ratio);
      ASSERT_EQ(brokenRule(mergedHull(children, target), children, target), "")
          << "seed " << seed << ", ratio " << ratio;
    }
  }
}

TEST(MergedHull, DoesNotDependOnTheOrderOfTheChildrenOrTheirVertices) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    Random random(seed);
    std::vector<Ring> children;
    for (int i = 0; i < 3; ++i) children.push_back(test::randomGridHouse(random, 9));
    const Ring hull = mergedHull(children, 9);
    std::reverse(children.begin(), children.end());
    for (Ring& child : children) std::rotate(child.begin(), child.begin() + 2, child.end());
    EXPECT_EQ(mergedHull(children, 9), hull) << "seed " << seed;
  }
}

}  // namespace
}  // namespace lodestone
