// makeCut() and makeUniformCut() against a reference that looks at every node and every building, and their
// rules as properties.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "algorithms/merging/cutting.h"
#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"
#include "tests/support/plain_dendrogram.h"
#include "tests/support/random_polygons.h"

namespace lodestone {
namespace {

using test::Random;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

const ClusterTree& town() {
  static const ClusterTree tree = [] {
    const auto footprints =
        std::make_shared<const FootprintTable>(footprintTable(synthesiseCity({CityPreset::Town, 0, 5})));
    return makeClusterTree(footprints,
                           std::make_shared<const Dendrogram>(test::plainDendrogram(*footprints, 3)));
  }();
  return tree;
}

std::vector<Vec3> cornersOf(const Box3& box) {
  std::vector<Vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) ? box.max.x() : box.min.x(), (i & 2) ? box.max.y() : box.min.y(),
                         (i & 4) ? box.max.z() : box.min.z());
  }
  return corners;
}

/// The rules of methods.md 1.4 from corners and whole silhouettes.
class Reference {
 public:
  Reference(const ClusterTree& tree, const CutOptions& options, const Camera& camera)
      : tree_(tree), options_(options), camera_(camera), frame_(frameOf(camera)) {
    tan_ = std::tan(camera.fov * std::numbers::pi / 360);
  }

  Cut run() {
    visit(static_cast<NodeId>(tree_.nodes.size() - 1));
    return cut_;
  }

 private:
  [[nodiscard]] Vec3 seen(const Vec3& p) const {
    const Vec3 d = p - camera_.eye;
    return {d.dot(frame_.right), d.dot(frame_.up), d.dot(frame_.forward)};
  }
  [[nodiscard]] bool outside(const Box3& box) const {
    const double aspect = static_cast<double>(camera_.width) / camera_.height;
    std::array<int, 5> out{};
    for (const Vec3& corner : cornersOf(box)) {
      const Vec3 s = seen(corner);
      out[0] += s.x() > s.z() * tan_ * aspect ? 1 : 0;
      out[1] += -s.x() > s.z() * tan_ * aspect ? 1 : 0;
      out[2] += s.y() > s.z() * tan_ ? 1 : 0;
      out[3] += -s.y() > s.z() * tan_ ? 1 : 0;
      out[4] += s.z() < 0.1 ? 1 : 0;
    }
    return *std::max_element(out.begin(), out.end()) == 8;
  }
  [[nodiscard]] bool cutByNearPlane(const Box3& box) const {
    const std::vector<Vec3> corners = cornersOf(box);
    return std::any_of(corners.begin(), corners.end(), [&](const Vec3& p) { return seen(p).z() < 0.1; });
  }
  /// Area of the convex hull of the projected corners, which is the silhouette.
  [[nodiscard]] double silhouette(const Box3& box) const {
    Ring points;
    for (const Vec3& corner : cornersOf(box)) {
      const Vec3 s = seen(corner);
      points.push_back(s.head<2>() / s.z() * (camera_.height / (2 * tan_)));
    }
    Vec2 centre = Vec2::Zero();
    for (const Vec2& p : points) centre += p / 8;
    std::sort(points.begin(), points.end(), [&](const Vec2& a, const Vec2& b) {
      return std::atan2(a.y() - centre.y(), a.x() - centre.x()) <
             std::atan2(b.y() - centre.y(), b.x() - centre.x());
    });
    for (bool changed = true; changed;) {
      changed = false;
      for (std::size_t i = 0; i < points.size() && points.size() > 3; ++i) {
        const Vec2 u = points[i] - points[(i + points.size() - 1) % points.size()];
        const Vec2 v = points[(i + 1) % points.size()] - points[i];
        if (u.x() * v.y() - u.y() * v.x() < 0) {
          points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
          changed = true;
        }
      }
    }
    return std::abs(signedArea(points));
  }
  [[nodiscard]] double distance(const Box3& box) const {
    double sum = 0;
    for (int k = 0; k < 3; ++k)
      sum += std::pow(std::max({0.0, box.min[k] - camera_.eye[k], camera_.eye[k] - box.max[k]}), 2);
    return std::sqrt(sum);
  }
  void buildingsBelow(NodeId id, std::vector<NodeId>& leaves) const {
    if (tree_.isLeaf(id)) {
      leaves.push_back(id);
    } else {
      buildingsBelow(tree_.nodes[id].a, leaves);
      buildingsBelow(tree_.nodes[id].b, leaves);
    }
  }
  void visit(NodeId id) {
    const ClusterNode& node = tree_.nodes[id];
    const Box3 box = boxOf(node);
    if (outside(box)) {
      cut_.culled.push_back(id);
      return;
    }
    if (tree_.isLeaf(id)) {
      cut_.drawn.push_back({id, DrawRole::Building});
      return;
    }
    const double pixels =
        cutByNearPlane(box) ? kInfinity : silhouette(negativeSpaceBox(tree_, id, camera_.eye));
    if (pixels > options_.epsilon) {
      visit(node.a);
      visit(node.b);
      return;
    }
    const double alphaHeight = options_.alpha * distance(box) * 2 * tan_ / camera_.height;
    cut_.drawn.push_back({id, DrawRole::Cluster, kNoNode, pixels, alphaHeight});
    std::vector<NodeId> leaves;
    buildingsBelow(id, leaves);
    for (const NodeId leaf : leaves) {
      const bool tall = tree_.nodes[leaf].maxTop > node.base + node.height + alphaHeight;
      if (tall && !outside(boxOf(tree_.nodes[leaf]))) cut_.drawn.push_back({leaf, DrawRole::Landmark, id});
    }
  }

  const ClusterTree& tree_;
  CutOptions options_;
  Camera camera_;
  CameraFrame frame_;
  double tan_ = 0;
  Cut cut_;
};

Camera randomCamera(Random& random, const ClusterTree& tree) {
  const ClusterNode& root = tree.nodes.back();
  const Vec2 size = root.box.size();
  Camera camera;
  camera.eye =
      Vec3(random.real(root.box.min.x() - size.x(), root.box.max.x() + size.x()),
           random.real(root.box.min.y() - size.y(), root.box.max.y() + size.y()), random.real(1, 600));
  camera.target = Vec3(random.real(root.box.min.x(), root.box.max.x()),
                       random.real(root.box.min.y(), root.box.max.y()), 0);
  camera.fov = random.real(20, 80);
  camera.width = random.integer(300, 2000);
  camera.height = random.integer(300, 1200);
  return camera;
}

/// Number of drawn (landmarks aside) or culled nodes at or above each building.
std::vector<int> coverCounts(const ClusterTree& tree, const Cut& cut) {
  std::vector<int> count(tree.nodes.size(), 0);
  for (const DrawnNode& d : cut.drawn) count[d.node] += d.role == DrawRole::Landmark ? 0 : 1;
  for (const NodeId id : cut.culled) ++count[id];
  for (NodeId id = static_cast<NodeId>(tree.nodes.size()); id-- > 0;) {
    if (tree.nodes[id].parent != kNoNode) count[id] += count[tree.nodes[id].parent];
  }
  count.resize(tree.dendrogram->leafCount);
  return count;
}

TEST(Cut, EqualsTheReferenceFromRandomCameras) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Camera camera = randomCamera(random, town());
    const CutOptions options{std::pow(10, random.real(-1, 5)), random.real(0, 30)};
    const Cut cut = makeCut(town(), options, camera);
    const Cut expected = Reference(town(), options, camera).run();
    ASSERT_EQ(cut.culled, expected.culled) << i;
    ASSERT_EQ(cut.drawn.size(), expected.drawn.size()) << i;
    FaceCount faces;
    for (std::size_t k = 0; k < cut.drawn.size(); ++k) {
      ASSERT_EQ(cut.drawn[k].node, expected.drawn[k].node) << i;
      ASSERT_EQ(cut.drawn[k].role, expected.drawn[k].role) << i;
      ASSERT_EQ(cut.drawn[k].of, expected.drawn[k].of) << i;
      ASSERT_NEAR(cut.drawn[k].boxPixels, expected.drawn[k].boxPixels,
                  1e-6 * (1 + expected.drawn[k].boxPixels))
          << i;
      ASSERT_NEAR(cut.drawn[k].alphaHeight, expected.drawn[k].alphaHeight, 1e-9) << i;
      faces += town().nodes[cut.drawn[k].node].faces;
    }
    ASSERT_EQ(cut.faces, faces);
  }
}

TEST(Cut, EveryBuildingHasOneDrawnOrCulledNodeAtOrAboveIt) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Cut cut = makeCut(town(), {std::pow(10, random.real(-1, 5)), 2}, randomCamera(random, town()));
    for (const int count : coverCounts(town(), cut)) ASSERT_EQ(count, 1);
  }
}

TEST(Cut, LargerEpsilonDrawsSameNodesOrOnesAboveThem) {
  Random random(3);
  for (int i = 0; i < 60; ++i) {
    const Camera camera = randomCamera(random, town());
    Cut finer = makeCut(town(), {0.1, kInfinity}, camera);
    for (const double epsilon : {1.0, 10.0, 100.0, 1000.0, 1e5}) {
      Cut coarser = makeCut(town(), {epsilon, kInfinity}, camera);
      std::vector<bool> above(town().nodes.size(), false);
      for (const DrawnNode& d : coarser.drawn) above[d.node] = true;
      for (NodeId id : coarser.culled) above[id] = true;
      for (NodeId id = static_cast<NodeId>(above.size()); id-- > 0;) {
        if (town().nodes[id].parent != kNoNode && above[town().nodes[id].parent]) above[id] = true;
      }
      for (const DrawnNode& d : finer.drawn) ASSERT_TRUE(above[d.node]);
      ASSERT_LE(coarser.faces.polygons, finer.faces.polygons) << "epsilon " << epsilon;
      finer = std::move(coarser);
    }
  }
}

TEST(Cut, EpsilonZeroDrawsBuildingsAndClustersWithoutNegativeSpaceOnly) {
  const Cut cut = makeCut(town(), {0, 2}, fitCamera(Box3{{-500, -500, 0}, {1500, 1500, 50}}, Vec3(1, 2, -1)));
  for (const DrawnNode& d : cut.drawn) {
    if (d.role == DrawRole::Cluster) {
      EXPECT_EQ(town().nodes[d.node].negative, 0);
    }
  }
}

TEST(Cut, InfiniteAlphaLeavesNoLandmarksAndAlphaZeroAllThatStandOut) {
  Random random(4);
  bool some = false;
  for (int i = 0; i < 20; ++i) {
    const Camera camera = randomCamera(random, town());
    for (const DrawnNode& d : makeCut(town(), {1000, kInfinity}, camera).drawn)
      EXPECT_NE(d.role, DrawRole::Landmark);
    for (const DrawnNode& d : makeCut(town(), {1000, 0}, camera).drawn)
      some = some || d.role == DrawRole::Landmark;
  }
  EXPECT_TRUE(some);
}

TEST(Cut, SwitchDistanceMakesToleranceCoverEpsilonPixels) {
  const double distance = switchDistance(10, 100, 45, 800);
  const double pixelsAMetre = 800 / (2 * std::tan(22.5 * std::numbers::pi / 180) * distance);
  EXPECT_NEAR(std::pow(10 * pixelsAMetre, 2), 100, 1e-9);
}

TEST(Cut, NegativeSpaceBoxHasItsAreaAndStaysInTheNode) {
  Random random(6);
  for (NodeId id = 0; id < town().nodes.size(); ++id) {
    const ClusterNode& node = town().nodes[id];
    const Vec3 eye(random.real(-500, 1500), random.real(-500, 1500), 50);
    const Box3 box = negativeSpaceBox(town(), id, eye);
    const Vec3 size = box.size();
    EXPECT_NEAR(size.x() * size.y(), node.negative, 1e-6);
    EXPECT_NEAR(size.x() * node.box.size().y(), size.y() * node.box.size().x(), 1e-6);
    EXPECT_NEAR(size.z(), node.height, 1e-9);
    EXPECT_TRUE((box.min.head<2>().array() >= node.box.min.array() - 1e-9).all());
    EXPECT_TRUE((box.max.head<2>().array() <= node.box.max.array() + 1e-9).all());
  }
}

TEST(Cut, NodesAtWeightCutTheDendrogram) {
  const auto& merges = town().dendrogram->merges;
  for (const double weight : {-1.0, merges[5].weight, merges[merges.size() / 2].weight, 1e9}) {
    std::vector<int> count(town().nodes.size(), 0);
    for (const NodeId id : nodesAtWeight(town(), weight)) {
      count[id] = 1;
      if (!town().isLeaf(id)) {
        EXPECT_LE(town().dendrogram->merge(id).weight, weight);
      }
      const NodeId parent = town().nodes[id].parent;
      if (parent != kNoNode) {
        EXPECT_GT(town().dendrogram->merge(parent).weight, weight);
      }
    }
    for (NodeId id = static_cast<NodeId>(count.size()); id-- > 0;) {
      if (town().nodes[id].parent != kNoNode) count[id] += count[town().nodes[id].parent];
    }
    for (NodeId leaf = 0; leaf < town().dendrogram->leafCount; ++leaf) ASSERT_EQ(count[leaf], 1);
  }
}

TEST(Cut, OneBuildingAmongOthersWithoutFootprintIsDrawn) {
  auto footprints = std::make_shared<FootprintTable>();
  footprints->add({}, 0, 5);
  footprints->add({{{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1)}, {}}}, 0, 5);
  footprints->add({}, 0, 5);
  auto dendrogram = std::make_shared<Dendrogram>();  // as clustering leaves it: nothing to merge
  dendrogram->leafCount = 3;
  const ClusterTree tree = makeClusterTree(footprints, dendrogram);
  const Cut cut = makeUniformCut(tree, {}, 5);
  ASSERT_EQ(cut.drawn.size(), 1U);
  EXPECT_EQ(cut.drawn[0].node, 1U);
  EXPECT_EQ(makeCut(tree, {}, fitCamera(Box3{{0, 0, 0}, {1, 1, 5}}, Vec3(1, 1, -1))).drawn.size(), 1U);
  EXPECT_EQ(nodesAtWeight(tree, 0), std::vector<NodeId>{1});
}

TEST(Cut, AnEmptyTreeDrawsNothing) {
  EXPECT_TRUE(makeCut({}, {}, {}).drawn.empty());
  EXPECT_TRUE(makeUniformCut({}, {}, 5).drawn.empty());
  EXPECT_TRUE(nodesAtWeight({}, 1).empty());
}

}  // namespace
}  // namespace lodestone
