#include "algorithms/switching/switcher.h"

#include <utility>
#include <vector>

#include "algorithms/merging/cutting.h"
#include "algorithms/merging/view.h"

namespace lodestone {
namespace {

class Legible final : public Switcher {
 public:
  Legible(std::shared_ptr<const ClusterTree> tree, const CutOptions& options)
      : tree_(std::move(tree)), options_(options) {}

  const Cut& pick(const Camera& camera) override {
    cut_ = makeCut(*tree_, options_, camera);
    return cut_;
  }

 private:
  std::shared_ptr<const ClusterTree> tree_;
  CutOptions options_;
  Cut cut_;
};

/// Draws buildings alone, however far away they are.
class Buildings final : public Switcher {
 public:
  Buildings(std::shared_ptr<const ClusterTree> tree, bool culls) : tree_(std::move(tree)), culls_(culls) {}

  const Cut& pick(const Camera& camera) override {
    cut_.camera = camera;
    cut_.drawn.clear();
    cut_.culled.clear();
    cut_.faces = {};
    if (culls_)
      drawVisible(View(camera));
    else
      drawAll();
    return cut_;
  }

 private:
  void drawAll() {
    for (NodeId id = 0; id < tree_->nodes.size(); ++id) {
      if (isBuilding(id)) cut_.draw(*tree_, {id, DrawRole::Building});
    }
  }

  void drawVisible(const View& view) {
    open_.clear();
    for (NodeId id = 0; id < tree_->nodes.size(); ++id) {
      const bool isRoot = tree_->nodes[id].parent == kNoNode;
      if (isRoot && (isBuilding(id) || !tree_->isLeaf(id))) open_.push_back(id);
    }
    while (!open_.empty()) {
      const NodeId id = open_.back();
      open_.pop_back();
      const ClusterNode& node = tree_->nodes[id];
      if (view.excludes(boxOf(node))) {
        cut_.culled.push_back(id);
      } else if (tree_->isLeaf(id)) {
        cut_.draw(*tree_, {id, DrawRole::Building});
      } else {
        open_.push_back(node.b);
        open_.push_back(node.a);
      }
    }
  }

  [[nodiscard]] bool isBuilding(NodeId id) const { return tree_->isLeaf(id) && tree_->nodes[id].edges > 0; }

  std::shared_ptr<const ClusterTree> tree_;
  bool culls_;
  Cut cut_;
  std::vector<NodeId> open_;
};

}  // namespace

std::unique_ptr<Switcher> legibleSwitcher(std::shared_ptr<const ClusterTree> tree,
                                          const CutOptions& options) {
  return std::make_unique<Legible>(std::move(tree), options);
}

std::unique_ptr<Switcher> visibleSwitcher(std::shared_ptr<const ClusterTree> tree) {
  return std::make_unique<Buildings>(std::move(tree), true);
}

std::unique_ptr<Switcher> everythingSwitcher(std::shared_ptr<const ClusterTree> tree) {
  return std::make_unique<Buildings>(std::move(tree), false);
}

}  // namespace lodestone
