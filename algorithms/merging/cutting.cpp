#include "algorithms/merging/cutting.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "algorithms/merging/descent.h"
#include "algorithms/merging/lightest_cut.h"
#include "algorithms/merging/view.h"

namespace lodestone {
namespace {

class Cutter {
 public:
  Cutter(const ClusterTree& tree, Cut& cut) : tree_(tree), cut_(cut), landmarks_(tree) {}

  void drawBuilding(NodeId leaf) { draw({leaf, DrawRole::Building}); }

  /// Draws the cluster, and the buildings in it that stand out by more than `alphaHeight` and are not
  /// hidden(box).
  template <class Hidden>
  void drawCluster(NodeId cluster, double boxPixels, double alphaHeight, const Hidden& hidden) {
    draw({cluster, DrawRole::Cluster, kNoNode, boxPixels, alphaHeight});
    const ClusterNode& node = tree_.nodes[cluster];
    const double limit = node.base + node.height + alphaHeight;
    landmarks_.start(cluster);
    while (!landmarks_.done()) {
      const NodeId id = landmarks_.next();
      if (!(tree_.nodes[id].maxTop > limit) || hidden(boxOf(tree_.nodes[id]))) continue;
      if (tree_.isLeaf(id)) {
        draw({id, DrawRole::Landmark, cluster});
      } else {
        landmarks_.openChildrenOf(id);
      }
    }
  }

 private:
  void draw(const DrawnNode& drawn) { cut_.draw(tree_, drawn); }

  const ClusterTree& tree_;
  Cut& cut_;
  Descent landmarks_;
};

/// Greatest emptiness of each node and those below it. Children come before their parents.
std::vector<double> greatestEmptiness(const ClusterTree& tree) {
  std::vector<double> greatest(tree.nodes.size());
  for (NodeId id = 0; id < tree.nodes.size(); ++id) {
    const ClusterNode& node = tree.nodes[id];
    greatest[id] = tree.isLeaf(id) ? 0 : std::max({emptiness(node), greatest[node.a], greatest[node.b]});
  }
  return greatest;
}

}  // namespace

Cut makeCut(const ClusterTree& tree, const CutOptions& options, const Camera& camera) {
  Cut cut{options, camera};
  const View view(camera);
  const auto hidden = [&](const Box3& box) { return view.excludes(box); };
  Cutter cutter(tree, cut);
  Descent descent(tree);
  for (descent.start(); !descent.done();) {
    const NodeId id = descent.next();
    const Box3 box = boxOf(tree.nodes[id]);
    if (hidden(box)) {
      cut.culled.push_back(id);
    } else if (tree.isLeaf(id)) {
      cutter.drawBuilding(id);
    } else if (view.cuts(box)) {
      descent.openChildrenOf(id);
    } else if (const double pixels = view.pixels(negativeSpaceBox(tree, id, camera.eye));
               pixels <= options.epsilon) {
      cutter.drawCluster(id, pixels, options.alpha * view.metresPerPixel(view.distance(box)), hidden);
    } else {
      descent.openChildrenOf(id);
    }
  }
  return cut;
}

Cut makeUniformCut(const ClusterTree& tree, const CutOptions& options, double tolerance) {
  Cut cut{options, {}};
  const std::vector<double> error = greatestEmptiness(tree);
  const double alphaHeight = options.epsilon > 0 ? tolerance * options.alpha / std::sqrt(options.epsilon)
                                                 : std::numeric_limits<double>::infinity();
  const std::vector<bool> drawn = lightestNodes(
      tree, [&](NodeId id) { return error[id] <= tolerance; }, alphaHeight);
  Cutter cutter(tree, cut);
  Descent descent(tree);
  for (descent.start(); !descent.done();) {
    const NodeId id = descent.next();
    if (tree.isLeaf(id)) {
      cutter.drawBuilding(id);
    } else if (drawn[id]) {
      cutter.drawCluster(id, 0, alphaHeight, [](const Box3&) { return false; });
    } else {
      descent.openChildrenOf(id);
    }
  }
  return cut;
}

double emptiness(const ClusterNode& node) {
  return std::sqrt(std::max(node.negative, node.gap * std::max(node.height, 0.0)));
}

double switchDistance(double tolerance, double epsilon, double fov, int height) {
  const double focal = height / (2 * std::tan(fov * std::numbers::pi / 360));
  return tolerance * focal / std::sqrt(epsilon);
}

Box3 negativeSpaceBox(const ClusterTree& tree, NodeId id, const Vec3& eye) {
  const ClusterNode& node = tree.nodes[id];
  const Vec2 size = node.box.size();
  const double share =
      node.negative > 0 ? std::min(1.0, std::sqrt(node.negative / (size.x() * size.y()))) : 0;
  const Vec2 half = size * (share / 2);
  const Vec2 centre = eye.head<2>().cwiseMax(node.box.min + half).cwiseMin(node.box.max - half);
  Box3 box;
  box.min = Vec3(centre.x() - half.x(), centre.y() - half.y(), node.base);
  box.max = Vec3(centre.x() + half.x(), centre.y() + half.y(), node.base + node.height);
  return box;
}

namespace {

/// The same without a descent, which leaps through memory: where merges rise in weight, those above the cut
/// are the last ones, and their children that are not among them are the cut.
std::vector<NodeId> childrenOfMergesFrom(const Dendrogram& dendrogram, std::size_t first) {
  std::vector<bool> chosen(dendrogram.leafCount + first, false);
  std::size_t count = 0;
  for (std::size_t m = first; m < dendrogram.merges.size(); ++m) {
    for (const NodeId child : {dendrogram.merges[m].a, dendrogram.merges[m].b}) {
      if (child >= chosen.size()) continue;
      chosen[child] = true;
      ++count;
    }
  }
  std::vector<NodeId> nodes;
  nodes.reserve(count);
  for (NodeId node = 0; node < chosen.size(); ++node) {
    if (chosen[node]) nodes.push_back(node);
  }
  return nodes;
}

}  // namespace

std::vector<NodeId> nodesAtWeight(const ClusterTree& tree, double weight) {
  if (tree.dendrogram && !tree.dendrogram->merges.empty()) {
    const auto& merges = tree.dendrogram->merges;
    const auto lighter = [](const Merge& a, const Merge& b) { return a.weight < b.weight; };
    const auto above = std::partition_point(merges.begin(), merges.end(),
                                            [&](const Merge& merge) { return merge.weight <= weight; });
    if (above != merges.end() && std::is_sorted(merges.begin(), merges.end(), lighter))
      return childrenOfMergesFrom(*tree.dendrogram, static_cast<std::size_t>(above - merges.begin()));
  }
  std::vector<NodeId> nodes;
  Descent descent(tree);
  for (descent.start(); !descent.done();) {
    const NodeId id = descent.next();
    if (tree.isLeaf(id) || tree.dendrogram->merge(id).weight <= weight) {
      nodes.push_back(id);
    } else {
      descent.openChildrenOf(id);
    }
  }
  return nodes;
}

}  // namespace lodestone
