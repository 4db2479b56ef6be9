// Which drawn nodes a selection marks.
#pragma once

#include <span>
#include <vector>

#include "gui/view3d/scene_geometry.h"

namespace lodestone {

/// How much of a drawn node is selected.
enum class Mark : std::uint8_t { None, Part, Whole };

/// Answers for any node how much of it lies below `nodes`. Cost: O(buildings) to make, O(1) to ask.
class Marks {
 public:
  Marks() = default;
  Marks(const LeafOrder& leaves, std::span<const NodeId> nodes);
  [[nodiscard]] Mark of(NodeId node) const;

 private:
  const LeafOrder* leaves_ = nullptr;
  std::vector<std::uint32_t> before_;  ///< marked leaves before each place of the order
};

}  // namespace lodestone
