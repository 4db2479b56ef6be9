#include "algorithms/switching/switcher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <gtest/gtest.h>

#include "algorithms/flights/flight.h"
#include "algorithms/flights/made_paths.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/merging/view.h"
#include "algorithms/switching/switch_count.h"
#include "model/exterior.h"
#include "tests/support/small_trees.h"

namespace lodestone {
namespace {

const std::shared_ptr<const ClusterTree>& tree() {
  static const auto town = test::townTree();
  return town;
}

std::vector<Box3> boxes() {
  std::vector<Box3> all;
  for (NodeId id = 0; id < tree()->dendrogram->leafCount; ++id) all.push_back(boxOf(tree()->nodes[id]));
  return all;
}

/// A minute from the roofs up, and some random ways with many turns.
std::vector<FlightPath> paths() {
  std::vector<FlightPath> all{groundToSky(boxes(), 10)};
  for (const std::uint32_t seed : {1U, 2U}) {
    Box3 area;
    for (const Box3& box : boxes()) {
      area.add(box.min);
      area.add(box.max);
    }
    all.push_back(randomPath(area, {.height = 40, .speed = 40, .seconds = 20, .seed = seed}));
  }
  return all;
}

std::vector<NodeId> nodesOf(const Cut& cut) {
  std::vector<NodeId> nodes;
  for (const DrawnNode& item : cut.drawn) nodes.push_back(item.node);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

TEST(Switchers, DrawWhatTheirRulesSay) {
  const auto legible = legibleSwitcher(tree(), {50, 2});
  const auto visible = visibleSwitcher(tree());
  const auto everything = everythingSwitcher(tree());
  for (const FlightPath& path : paths()) {
    for (double time = 0; time < path.duration(); time += 1.7) {
      const Camera camera = path.at(time, 640, 400);
      EXPECT_EQ(legible->pick(camera).drawn, makeCut(*tree(), {50, 2}, camera).drawn);
      const View view(camera);
      std::vector<NodeId> seen, all;
      for (NodeId id = 0; id < tree()->dendrogram->leafCount; ++id) {
        all.push_back(id);
        if (!view.excludes(boxOf(tree()->nodes[id]))) seen.push_back(id);
      }
      EXPECT_EQ(nodesOf(visible->pick(camera)), seen);
      EXPECT_EQ(nodesOf(everything->pick(camera)), all);
      EXPECT_EQ(everything->pick(camera).faces, tree()->buildingFaces);
    }
  }
}

struct Grid {
  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;
};

const Grid& grid() {
  static const Grid made = [] {
    auto city = std::make_shared<const CityModel>(synthesiseCity({CityPreset::Grid400, 36, 3}));
    return Grid{city, test::treeOf(*city)};
  }();
  return made;
}

/// Distance of two points by trying very many of the block's.
double distanceToBlock(const Building& building, const Box3& box, const Vec3& eye) {
  double nearest = std::numeric_limits<double>::infinity();
  const Ring& ring = building.footprint.front().outer;
  Box2 plan;
  for (const Vec2& p : ring) plan.add(p);
  for (int i = 0; i <= 60; ++i) {
    for (int j = 0; j <= 60; ++j) {
      const Vec2 at = plan.min + plan.size().cwiseProduct(Vec2(i / 60.0, j / 60.0));
      const double z = std::clamp(eye.z(), box.min.z(), box.max.z());
      nearest = std::min(nearest, (Vec3(at.x(), at.y(), z) - eye).norm());
    }
  }
  return nearest;
}

TEST(BuildingLevels, GiveWayWhereThePaperSays) {
  const BuildingLevels levels(grid().city, {3, 25});
  for (std::uint32_t b = 0; b < 36; ++b) {
    ASSERT_EQ(levels.faces(b).size(), 4U);
    const double alpha = levels.box(b).size().norm();
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(levels.distances(b)[i], alpha * 3 * std::pow(25, (i + 1) / 3.0), 1e-9);
      EXPECT_GT(levels.faces(b)[i].triangles, 2 * levels.faces(b)[i + 1].triangles);
    }
    EXPECT_EQ(levels.faces(b)[0], facesOf(grid().city->buildings[b]));
  }
  EXPECT_NEAR(BuildingLevels(grid().city, {}).plotRadius(), 25, 0.5) << "half of the plots' 50 m";
}

TEST(Switchers, ByRangeAndPrismAreWhatDistancesSay) {
  const auto levels = std::make_shared<const BuildingLevels>(grid().city, CutOffOptions{0.5, 25});
  const auto range = rangeSwitcher(grid().tree, levels);
  const auto prism = prismSwitcher(grid().tree, levels);
  const auto visible = visibleSwitcher(grid().tree);
  const FlightPath path =
      randomPath({{-150, -150, 0}, {150, 150, 30}}, {.height = 20, .seconds = 20, .fov = 75, .seed = 4});
  std::array<int, 4> seen{};
  std::uint64_t finer = 0;
  for (double time = 0; time < path.duration(); time += 0.5) {
    const Camera camera = path.at(time, 640, 400);
    const Cut far = range->pick(camera);
    const Cut& near = prism->pick(camera);
    EXPECT_EQ(nodesOf(far), nodesOf(visible->pick(camera)));
    ASSERT_EQ(far.drawn.size(), near.drawn.size());
    FaceCount faces;
    for (std::size_t i = 0; i < far.drawn.size(); ++i) {
      const NodeId b = far.drawn[i].node;
      const auto levelAt = [&](double away) {
        const auto distances = levels->distances(b);
        return std::count_if(distances.begin(), distances.end(), [&](double d) { return d <= away; });
      };
      EXPECT_EQ(far.drawn[i].level, levelAt((camera.eye - levels->box(b).center()).norm()));
      const double half = levels->box(b).size().norm() / 2;
      const double block = distanceToBlock(grid().city->buildings[b], levels->box(b), camera.eye);
      EXPECT_LE(near.drawn[i].level, levelAt(block + half));
      EXPECT_GE(near.drawn[i].level, levelAt(block + half - 1)) << "samples are less than a metre apart";
      EXPECT_LE(far.drawn[i].level, near.drawn[i].level);
      finer += far.drawn[i].level < near.drawn[i].level ? 1 : 0;
      ++seen[near.drawn[i].level];
      faces += levels->faces(b)[far.drawn[i].level];
    }
    EXPECT_EQ(far.faces, faces);
    EXPECT_LE(near.faces.triangles, far.faces.triangles);
  }
  EXPECT_TRUE(std::all_of(seen.begin(), seen.end(), [](int count) { return count > 0; }));
  EXPECT_GT(finer, 0U);
}

TEST(SwitchCounter, CountsBuildingsThatChangeTheirLevel) {
  const auto levels = std::make_shared<const BuildingLevels>(grid().city, CutOffOptions{0.5, 25});
  const auto range = rangeSwitcher(grid().tree, levels);
  const FlightPath path =
      randomPath({{-150, -150, 0}, {150, 150, 30}}, {.height = 20, .seconds = 20, .seed = 5});
  SwitchCounter counter(*grid().tree);
  std::map<NodeId, int> before;
  std::uint64_t all = 0;
  for (double time = 0; time < path.duration(); time += 0.2) {
    const Cut& cut = range->pick(path.at(time, 640, 400));
    std::map<NodeId, int> now;
    std::uint64_t expected = 0;
    for (const DrawnNode& item : cut.drawn) {
      now[item.node] = item.level;
      expected += before.contains(item.node) && before[item.node] != item.level ? 1 : 0;
    }
    EXPECT_EQ(counter.next(cut), expected);
    all += expected;
    before = std::move(now);
  }
  EXPECT_GT(all, 10U);
}

/// What stands for each building in a cut; kNoNode where nothing does.
std::vector<NodeId> standIns(const Cut& cut) {
  std::vector<NodeId> of(tree()->nodes.size(), kNoNode);
  for (const DrawnNode& item : cut.drawn) {
    if (item.role != DrawRole::Landmark) of[item.node] = item.node;
  }
  for (NodeId id = static_cast<NodeId>(of.size()); id-- > 0;) {
    const NodeId parent = tree()->nodes[id].parent;
    if (parent != kNoNode && of[parent] != kNoNode) of[id] = of[parent];
  }
  of.resize(tree()->dendrogram->leafCount);
  return of;
}

bool isBelow(NodeId node, NodeId above) {
  while (node != kNoNode && node != above) node = tree()->nodes[node].parent;
  return node == above;
}

/// Building by building: who stands for it now and stood for it before.
std::uint64_t switchesByForce(const Cut& before, const Cut& now) {
  const std::vector<NodeId> first = standIns(before);
  const std::vector<NodeId> second = standIns(now);
  std::vector<NodeId> coarse;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == kNoNode || second[i] == kNoNode || first[i] == second[i]) continue;
    coarse.push_back(isBelow(first[i], second[i]) ? second[i] : first[i]);
  }
  std::sort(coarse.begin(), coarse.end());
  std::uint64_t count =
      static_cast<std::uint64_t>(std::unique(coarse.begin(), coarse.end()) - coarse.begin());
  const auto landmarks = [](const Cut& cut, const Cut& other) {
    std::uint64_t alone = 0;
    for (const DrawnNode& item : cut.drawn) {
      if (item.role != DrawRole::Landmark) continue;
      bool cluster = false;
      bool same = false;
      for (const DrawnNode& theirs : other.drawn) {
        cluster = cluster || (theirs.node == item.of && theirs.role == DrawRole::Cluster);
        same = same || (theirs.node == item.node && theirs.role == DrawRole::Landmark);
      }
      alone += cluster && !same ? 1 : 0;
    }
    return alone;
  };
  return count + landmarks(before, now) + landmarks(now, before);
}

TEST(SwitchCounter, EqualsTheCountBuildingByBuilding) {
  std::uint64_t all = 0;
  for (const FlightPath& path : paths()) {
    const auto switcher = legibleSwitcher(tree(), {80, 2});
    SwitchCounter counter(*tree());
    Cut before;
    for (double time = 0; time < path.duration(); time += 0.25) {
      const Cut& now = switcher->pick(path.at(time, 640, 400));
      const std::uint64_t count = counter.next(now);
      EXPECT_EQ(count, time == 0 ? 0 : switchesByForce(before, now)) << time;
      all += count;
      before = now;
    }
  }
  EXPECT_GT(all, 200U);
}

TEST(Flight, RecordsEveryFrameOfThePath) {
  const FlightPath path = paths().front();
  const auto switcher = legibleSwitcher(tree(), {});
  std::vector<std::uint64_t> polygons;
  const auto frames =
      fly(*tree(), *switcher, path, {10, 640, 400}, {},
          [&](const FlightFrame&, const Cut& cut) { polygons.push_back(cut.faces.polygons); });
  ASSERT_EQ(frames.size(), 101U);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    EXPECT_EQ(frames[i].camera, path.at(static_cast<double>(i) / 10, 640, 400));
    const Cut cut = makeCut(*tree(), {}, frames[i].camera);
    EXPECT_EQ(frames[i].faces, cut.faces);
    EXPECT_EQ(frames[i].faces.polygons, polygons[i]);
    EXPECT_EQ(frames[i].clusters + frames[i].buildings + frames[i].landmarks, cut.drawn.size());
    EXPECT_EQ(frames[i].culled, cut.culled.size());
  }
}

TEST(MadePaths, LeadFromTheRoofsToAllOfTheCity) {
  const std::vector<Box3> all = boxes();
  const FlightPath path = groundToSky(all);
  const Camera start = path.at(0, 1280, 800);
  const Camera end = path.at(path.duration(), 1280, 800);
  EXPECT_LT(start.eye.z(), 60);
  EXPECT_TRUE(std::none_of(all.begin(), all.end(), [&](const Box3& box) { return box.contains(start.eye); }));
  const View view(end);
  for (const Box3& box : all) EXPECT_FALSE(view.excludes(box));
  double height = 0;
  for (double time = 0; time <= path.duration(); time += 0.5) {
    const double now = path.at(time, 1280, 800).eye.z();
    EXPECT_GE(now, height);
    height = now;
  }
}

TEST(MadePaths, AtRandomKeepTheirHeightAndSpeed) {
  const Box3 area{{-300, 200, 3}, {900, 700, 80}};
  for (const std::uint32_t seed : {1U, 2U, 3U}) {
    const FlightPath path = randomPath(area, {.seed = seed});
    EXPECT_GE(path.duration(), 70);
    for (std::size_t i = 0; i < path.keys.size(); ++i) {
      EXPECT_DOUBLE_EQ(path.keys[i].eye.z(), 53);
      if (i == 0) continue;
      const double length = (path.keys[i].eye - path.keys[i - 1].eye).norm();
      EXPECT_NEAR(length / (path.keys[i].time - path.keys[i - 1].time), 20, 1e-9);
    }
    EXPECT_EQ(path, randomPath(area, {.seed = seed}));
  }
  EXPECT_NE(randomPath(area, {.seed = 1}), randomPath(area, {.seed = 2}));
  EXPECT_GT(randomPath(Box3{{0, 0, 0}, {0, 0, 0}}, {}).keys.size(), 2U) << "of a city of one point as well";
}

}  // namespace
}  // namespace lodestone
