#include "algorithms/switching/switcher.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/merging/cutting.h"
#include "algorithms/merging/descent.h"
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

/// Draws buildings alone, at the levels that a rule says.
class Buildings : public Switcher {
 public:
  Buildings(std::shared_ptr<const ClusterTree> tree, bool culls)
      : tree_(std::move(tree)), descent_(*tree_), culls_(culls) {}

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

 protected:
  virtual void draw(NodeId building, Cut& cut) const { cut.draw(*tree_, {building, DrawRole::Building}); }

 private:
  void drawAll() {
    for (NodeId id = 0; id < tree_->nodes.size(); ++id) {
      if (isBuilding(id)) draw(id, cut_);
    }
  }

  void drawVisible(const View& view) {
    for (descent_.start(); !descent_.done();) {
      const NodeId id = descent_.next();
      if (view.excludes(boxOf(tree_->nodes[id]))) {
        cut_.culled.push_back(id);
      } else if (tree_->isLeaf(id)) {
        draw(id, cut_);
      } else {
        descent_.openChildrenOf(id);
      }
    }
  }

  [[nodiscard]] bool isBuilding(NodeId id) const { return tree_->isLeaf(id) && tree_->nodes[id].edges > 0; }

  std::shared_ptr<const ClusterTree> tree_;
  Descent descent_;
  bool culls_;
  Cut cut_;
};

/// Metres in plan from a point to a footprint; 0 inside, yards included.
double distanceInPlan(const MultiPolygon& footprint, const Vec2& point) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Polygon& polygon : footprint) {
    const Ring& ring = polygon.outer;
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2& a = ring[i];
      const Vec2& b = ring[(i + 1) % ring.size()];
      const Vec2 along = b - a;
      const double length = along.squaredNorm();
      const double share = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0;
      nearest = std::min(nearest, (point - a - share * along).norm());
      if ((a.y() > point.y()) != (b.y() > point.y()) &&
          point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * along.x())
        inside = !inside;
    }
    if (inside) return 0;
  }
  return nearest;
}

/// By distance, each its own.
class ByDistance : public Buildings {
 public:
  ByDistance(std::shared_ptr<const ClusterTree> tree, std::shared_ptr<const BuildingLevels> levels)
      : Buildings(std::move(tree), true), levels_(std::move(levels)) {}

 protected:
  [[nodiscard]] const BuildingLevels& levels() const { return *levels_; }
  /// To be held against the level's distances.
  [[nodiscard]] virtual double distance(NodeId building, const Vec3& eye) const = 0;

  void draw(NodeId building, Cut& cut) const override {
    const std::span<const double> distances = levels_->distances(building);
    const double away = distances.empty() ? 0 : distance(building, cut.camera.eye);
    const auto level = std::upper_bound(distances.begin(), distances.end(), away) - distances.begin();
    DrawnNode drawn{building, DrawRole::Building};
    drawn.level = static_cast<std::uint8_t>(level);
    cut.drawn.push_back(drawn);
    cut.faces += levels_->faces(building)[static_cast<std::size_t>(level)];
  }

 private:
  std::shared_ptr<const BuildingLevels> levels_;
};

class ByRange final : public ByDistance {
 public:
  using ByDistance::ByDistance;

 private:
  [[nodiscard]] double distance(NodeId building, const Vec3& eye) const override {
    return (eye - levels().box(building).center()).norm();
  }
};

class ByPrism final : public ByDistance {
 public:
  using ByDistance::ByDistance;

 private:
  [[nodiscard]] double distance(NodeId building, const Vec3& eye) const override {
    const Box3& box = levels().box(building);
    const double plan = distanceInPlan(levels().city().buildings[building].footprint, eye.head<2>());
    const double height = std::max({0.0, eye.z() - box.max.z(), box.min.z() - eye.z()});
    return std::hypot(plan, height) + box.size().norm() / 2;
  }
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

std::unique_ptr<Switcher> rangeSwitcher(std::shared_ptr<const ClusterTree> tree,
                                        std::shared_ptr<const BuildingLevels> levels) {
  return std::make_unique<ByRange>(std::move(tree), std::move(levels));
}

std::unique_ptr<Switcher> prismSwitcher(std::shared_ptr<const ClusterTree> tree,
                                        std::shared_ptr<const BuildingLevels> levels) {
  return std::make_unique<ByPrism>(std::move(tree), std::move(levels));
}

}  // namespace lodestone
