#include "model/io/footprints/footprint_repair.h"

#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace lodestone {
namespace {

using ::testing::ElementsAre;

Ring square(double x, double y, double size) {
  return {{x, y}, {x + size, y}, {x + size, y + size}, {x, y + size}};
}

TEST(Repair, LeavesGoodOutlinesAlone) {
  const RepairedFootprint plain = repairFootprint({{square(0, 0, 10), {}}});
  EXPECT_TRUE(plain.codes.empty());
  EXPECT_EQ(plain.polygons.at(0).outer, square(0, 0, 10));
  const RepairedFootprint yard = repairFootprint({{square(0, 0, 10), {square(3, 3, 2)}}});
  EXPECT_TRUE(yard.codes.empty());
  EXPECT_EQ(area(yard.polygons), 96);
  EXPECT_LT(signedArea(yard.polygons.at(0).holes.at(0)), 0);
}

TEST(Repair, TurnsAndTidies) {
  const RepairedFootprint turned = repairFootprint({{{{0, 0}, {0, 5}, {0, 5}, {5, 5}, {5, 0}, {0, 0}}, {}}});
  EXPECT_TRUE(turned.codes.empty());
  EXPECT_EQ(turned.polygons.at(0).outer.size(), 4U);
  EXPECT_EQ(signedArea(turned.polygons.at(0).outer), 25);
}

TEST(Repair, BowTieBecomesTwoTrianglesByTheEvenOddRule) {
  const RepairedFootprint repaired = repairFootprint({{{{0, 0}, {10, 10}, {10, 0}, {0, 10}}, {}}});
  EXPECT_THAT(repaired.codes, ElementsAre(Code::RingSelfIntersecting));
  EXPECT_EQ(repaired.polygons.size(), 2U);
  EXPECT_NEAR(area(repaired.polygons), 50, 1e-9);
}

TEST(Repair, SaysWhatIsNoArea) {
  EXPECT_THAT(repairFootprint({{{{0, 0}, {1, 1}, {0, 0}}, {}}}).codes, ElementsAre(Code::RingTooShort));
  EXPECT_THAT(repairFootprint({{{{0, 0}, {1, 1}, {2, 2}, {5, 5}}, {}}}).codes,
              ElementsAre(Code::RingZeroArea));
  EXPECT_THAT(repairFootprint({{{{0, 0}, {1, std::nan("")}, {2, 2}}, {}}}).codes,
              ElementsAre(Code::CoordinateBad));
  EXPECT_TRUE(repairFootprint({}).polygons.empty());
  const RepairedFootprint hole = repairFootprint({{square(0, 0, 10), {{{1, 1}, {2, 2}}}}});
  EXPECT_THAT(hole.codes, ElementsAre(Code::HoleDropped));
  EXPECT_EQ(area(hole.polygons), 100);
}

TEST(Repair, LeavesOutHolesOutside) {
  const RepairedFootprint repaired =
      repairFootprint({{square(0, 0, 10), {square(20, 20, 3), square(2, 2, 1)}}});
  EXPECT_THAT(repaired.codes, ElementsAre(Code::HoleOutside));
  EXPECT_EQ(area(repaired.polygons), 99);
}

TEST(Repair, UnitesPartsThatOverlap) {
  const RepairedFootprint repaired = repairFootprint({{square(0, 0, 10), {}}, {square(5, 0, 10), {}}});
  EXPECT_THAT(repaired.codes, ElementsAre(Code::FootprintRepaired));
  ASSERT_EQ(repaired.polygons.size(), 1U);
  EXPECT_NEAR(area(repaired.polygons), 150, 1e-9);
}

/// Even-odd rule by counting crossings.
bool insideEvenOdd(const Ring& ring, const Vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
    if ((ring[i].y() > p.y()) != (ring[j].y() > p.y()) &&
        p.x() <
            (ring[j].x() - ring[i].x()) * (p.y() - ring[i].y()) / (ring[j].y() - ring[i].y()) + ring[i].x()) {
      inside = !inside;
    }
  }
  return inside;
}

TEST(Repair, RandomRingsKeepTheirEvenOddInside) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> anywhere(0, 100);
  for (int trial = 0; trial < 300; ++trial) {
    // Far from zero too: real coordinates have seven digits before the point.
    const Vec2 shift = trial % 2 == 0 ? Vec2(0, 0) : Vec2(458880, 5438360);
    Ring ring;
    for (int i = 0; i < 3 + trial % 8; ++i)
      ring.emplace_back(shift + Vec2(anywhere(random), anywhere(random)));
    const RepairedFootprint repaired = repairFootprint({{ring, {}}});
    for (int k = 0; k < 50; ++k) {
      const Vec2 p = shift + Vec2(anywhere(random), anywhere(random));
      bool inside = false;
      for (const Polygon& polygon : repaired.polygons) {
        bool here = insideEvenOdd(polygon.outer, p);
        for (const Ring& hole : polygon.holes) here = here && !insideEvenOdd(hole, p);
        inside = inside || here;
      }
      EXPECT_EQ(inside, insideEvenOdd(ring, p)) << trial;
    }
  }
}

}  // namespace
}  // namespace lodestone
