#include "algorithms/switching/switcher.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "algorithms/flights/flight.h"
#include "algorithms/flights/made_paths.h"
#include "algorithms/merging/cutting.h"
#include "algorithms/merging/view.h"
#include "algorithms/switching/switch_count.h"
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
    EXPECT_EQ(frames[i].polygons, cut.faces.polygons);
    EXPECT_EQ(frames[i].polygons, polygons[i]);
    EXPECT_EQ(frames[i].clusters + frames[i].buildings + frames[i].landmarks, cut.drawn.size());
    EXPECT_EQ(frames[i].culled, cut.culled.size());
  }
}

TEST(MadePaths, LeadFromTheRoofsToAllOfTheCity) {
  const FlightPath path = groundToSky(boxes());
  const Camera start = path.at(0, 1280, 800);
  const Camera end = path.at(path.duration(), 1280, 800);
  EXPECT_LT(start.eye.z(), 60);
  EXPECT_TRUE(
      std::none_of(boxes().begin(), boxes().end(), [&](const Box3& box) { return box.contains(start.eye); }));
  const View view(end);
  for (const Box3& box : boxes()) EXPECT_FALSE(view.excludes(box));
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
