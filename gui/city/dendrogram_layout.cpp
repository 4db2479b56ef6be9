#include "gui/city/dendrogram_layout.h"

#include <algorithm>
#include <cmath>

namespace lodestone {

double heightOfWeight(double weight) {
  return std::log10(1 + std::max(weight, 0.0));
}
double weightOfHeight(double height) {
  return std::max(std::pow(10, height) - 1, 0.0);
}

DendrogramLayout makeLayout(std::shared_ptr<const Dendrogram> dendrogram) {
  DendrogramLayout layout;
  layout.order = leafOrder(*dendrogram);
  const NodeId nodes = dendrogram->nodeCount();
  layout.x.resize(nodes);
  layout.height.resize(nodes);
  for (NodeId node = 0; node < nodes; ++node) {
    if (dendrogram->isLeaf(node)) {
      layout.x[node] = layout.order.first[node] + 0.5;
      layout.height[node] = static_cast<float>(kLeafHeight);
      continue;
    }
    const Merge& merge = dendrogram->merge(node);
    layout.x[node] = (layout.x[merge.a] + layout.x[merge.b]) / 2;
    layout.height[node] = static_cast<float>(heightOfWeight(merge.weight));
    layout.top = std::max<double>(layout.top, layout.height[node]);
  }
  layout.dendrogram = std::move(dendrogram);
  return layout;
}

NodeId DendrogramLayout::nodeAt(double wantedX, double wantedHeight) const {
  if (!dendrogram || dendrogram->nodeCount() == 0 || wantedX < 0 || wantedX >= dendrogram->leafCount)
    return kNoNode;
  const auto contains = [&](NodeId node) {
    const double first = order.first[node];
    return wantedX >= first && wantedX < first + order.count[node];
  };
  NodeId node = dendrogram->root();
  if (!contains(node) || height[node] < wantedHeight) return kNoNode;
  while (!dendrogram->isLeaf(node)) {
    const Merge& merge = dendrogram->merge(node);
    const NodeId child = contains(merge.a) ? merge.a : merge.b;
    if (height[child] < wantedHeight) break;
    node = child;
  }
  return node;
}

}  // namespace lodestone
