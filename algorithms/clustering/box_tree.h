// A packed tree of boxes.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry.h"

namespace lodestone {

/// A tree over boxes that already stand in a spatial order (a packed R-tree): kFan consecutive boxes make a
/// block, kFan blocks a node, and so on. Cost: linear to build; a query visits the nodes that meet it.
class BoxTree {
 public:
  static constexpr std::uint32_t kFan = 8;
  /// A block within reach.
  struct Hit {
    double squared = 0;
    std::uint32_t block = 0;
    bool operator<(const Hit& other) const {
      return squared != other.squared ? squared < other.squared : block < other.block;
    }
  };

  explicit BoxTree(std::span<const Box2> boxes);

  [[nodiscard]] std::uint32_t blockCount() const {
    return static_cast<std::uint32_t>(levels_.front().size());
  }
  [[nodiscard]] const Box2& blockBox(std::uint32_t block) const { return levels_.front()[block]; }
  /// All blocks whose squared distance from `box` is at most `bound`, in the order of the tree.
  void within(const Box2& box, double bound, std::vector<Hit>& hits) const;

 private:
  void visit(std::size_t level, std::uint32_t node, const Box2& box, double bound,
             std::vector<Hit>& hits) const;

  std::vector<std::vector<Box2>> levels_;  ///< blocks first, the root last
};

}  // namespace lodestone
