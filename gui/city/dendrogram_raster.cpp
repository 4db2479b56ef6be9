#include "gui/city/dendrogram_raster.h"

#include <algorithm>
#include <cmath>

namespace lodestone {

void DendrogramRaster::draw(const DendrogramLayout& layout, const DendrogramWindow& window,
                            const std::vector<std::uint8_t>& drawn) {
  layout_ = &layout;
  drawn_ = &drawn;
  window_ = window;
  reset();
  if (!layout.dendrogram || layout.dendrogram->nodeCount() == 0 || window.width <= 0 || window.height <= 0)
    return;
  stack_.assign(1, {layout.dendrogram->root(), kNoNode});
  while (!stack_.empty()) {
    const Item item = stack_.back();
    stack_.pop_back();
    visit(item, stack_);
  }
  sumUp(above_);
  sumUp(below_);
}

void DendrogramRaster::reset() {
  stride_ = std::max(window_.width, 0) + 1;
  const std::size_t size =
      static_cast<std::size_t>(stride_) * static_cast<std::size_t>(std::max(window_.height, 0) + 1);
  for (Plane* plane : {&above_, &below_}) {
    plane->across.assign(size, 0);
    plane->down.assign(size, 0);
  }
  owner_.assign(static_cast<std::size_t>(stride_), kNoNode);
  visited_ = 0;
}

void DendrogramRaster::visit(const Item& given, std::vector<Item>& stack) {
  Item item = given;
  const LeafOrder& order = layout_->order;
  const double first = order.first[item.node];
  const double last = first + order.count[item.node];
  if (last < window_.left || first > window_.right) return;
  ++visited_;
  const bool startsCluster = item.owner == kNoNode && !drawn_->empty() && (*drawn_)[item.node] != 0;
  if (startsCluster) {
    item.owner = item.node;
    own(first, last, item.node);
  }
  if (layout_->dendrogram->isLeaf(item.node)) return;
  if (window_.column(last) - window_.column(first) <= 1) {
    fillNarrow(item);
    return;
  }
  const Merge& merge = layout_->dendrogram->merge(item.node);
  Plane& plane = item.owner == kNoNode ? above_ : below_;
  const double height = layout_->height[item.node];
  bar(plane, layout_->x[merge.a], layout_->x[merge.b], height);
  stem(plane, layout_->x[merge.a], height, layout_->height[merge.a]);
  stem(plane, layout_->x[merge.b], height, layout_->height[merge.b]);
  stack.push_back({merge.b, item.owner});
  stack.push_back({merge.a, item.owner});
}

void DendrogramRaster::fillNarrow(const Item& item) {
  const bool divided = !drawn_->empty() && item.owner == kNoNode;
  const double x = layout_->x[item.node];
  if (divided) own(x, x, item.node);
  stem(item.owner == kNoNode && !divided ? above_ : below_, x, layout_->height[item.node], kLeafHeight);
}

void DendrogramRaster::bar(Plane& plane, double fromX, double toX, double height) {
  const double row = std::floor(window_.row(height));
  if (row < 0 || row >= window_.height) return;
  const double from = std::max(std::floor(window_.column(fromX)), 0.0);
  const double to = std::min(std::floor(window_.column(toX)), window_.width - 1.0);
  if (from > to) return;
  plane.across[index(static_cast<int>(from), static_cast<int>(row))] += 1;
  plane.across[index(static_cast<int>(to) + 1, static_cast<int>(row))] -= 1;
}

void DendrogramRaster::stem(Plane& plane, double x, double fromHeight, double toHeight) {
  const double column = std::floor(window_.column(x));
  if (column < 0 || column >= window_.width) return;
  const double from = std::max(std::floor(window_.row(std::max(fromHeight, toHeight))), 0.0);
  const double to = std::min(std::floor(window_.row(std::min(fromHeight, toHeight))), window_.height - 1.0);
  if (from > to) return;
  plane.down[index(static_cast<int>(column), static_cast<int>(from))] += 1;
  plane.down[index(static_cast<int>(column), static_cast<int>(to) + 1)] -= 1;
}

void DendrogramRaster::own(double fromX, double toX, NodeId owner) {
  const int from = static_cast<int>(std::clamp(std::floor(window_.column(fromX)), 0.0, window_.width - 1.0));
  const int to =
      static_cast<int>(std::clamp(std::ceil(window_.column(toX)), from + 1.0, window_.width + 0.0));
  std::fill(owner_.begin() + from, owner_.begin() + to, owner);
}

void DendrogramRaster::sumUp(Plane& plane) {
  for (int row = 0; row < window_.height; ++row) {
    std::int32_t* across = plane.across.data() + index(0, row);
    std::int32_t* down = plane.down.data() + index(0, row);
    std::int32_t* below = down + stride_;
    for (int column = 0; column < window_.width; ++column) {
      across[column + 1] += across[column];
      below[column] += down[column];
    }
  }
}

}  // namespace lodestone
