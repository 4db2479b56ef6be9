#include "model/camera.h"

#include <gmock/gmock.h>

namespace lodestone {
namespace {

Box3 boxAt(double x, double y) {
  return {Vec3(x - 1, y - 1, 0), Vec3(x + 1, y + 1, 3)};
}

TEST(WithoutStrays, KeepsEvenlySpreadBoxes) {
  std::vector<Box3> grid;
  std::vector<Box3> line;
  for (int i = 0; i < 900; ++i) grid.push_back(boxAt(10.0 * (i % 30), 10.0 * (i / 30)));
  for (int i = 0; i < 100; ++i) line.push_back(boxAt(50.0 * i, 0));
  EXPECT_EQ(withoutStrays(grid).size(), grid.size());
  EXPECT_EQ(withoutStrays(line).size(), line.size());
}

TEST(WithoutStrays, LeavesOutTheFewThatStandFarAway) {
  std::vector<Box3> boxes;
  for (int i = 0; i < 100; ++i) boxes.push_back(boxAt(10.0 * (i % 10), 10.0 * (i / 10)));
  boxes.push_back(boxAt(5000, 0));
  boxes.push_back(boxAt(0, -3000));
  boxes.push_back({});
  EXPECT_EQ(withoutStrays(boxes).size(), 100U);
}

TEST(WithoutStrays, SmallSetsAreLeftAlone) {
  EXPECT_TRUE(withoutStrays({}).empty());
  EXPECT_EQ(withoutStrays({boxAt(0, 0)}).size(), 1U);
  EXPECT_EQ(withoutStrays({boxAt(0, 0), boxAt(1, 0), boxAt(9000, 0)}).size(), 3U);
}

}  // namespace
}  // namespace lodestone
