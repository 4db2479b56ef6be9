// A dendrogram as pixels, at a cost that follows the picture and not the tree. No Qt.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "gui/city/dendrogram_layout.h"

namespace lodestone {

/// The part of a layout that a picture shows: leaves [left, right], heights [bottom, top], in `width` ×
/// `height` pixels.
struct DendrogramWindow {
  double left = 0;
  double right = 1;
  double bottom = kLeafHeight;
  double top = 1;
  int width = 0;
  int height = 0;

  [[nodiscard]] double column(double x) const { return (x - left) / (right - left) * width; }
  [[nodiscard]] double row(double h) const { return (top - h) / (top - bottom) * height; }
  [[nodiscard]] double xAt(double column) const { return left + column / width * (right - left); }
  [[nodiscard]] double heightAt(double row) const { return top - row / height * (top - bottom); }
};

/// How many lines go through each pixel. Bars and stems are noted at their two ends and summed up at the end,
/// so that a line costs the same whatever its length; subtrees narrower than a pixel become one span and are
/// not entered.
class DendrogramRaster {
 public:
  /// `drawn[node]` is not 0 for nodes of the cut (empty: no cut): what is below them is counted apart from
  /// what is above. Cost: the nodes wider than a pixel, and the pixels.
  void draw(const DendrogramLayout& layout, const DendrogramWindow& window,
            const std::vector<std::uint8_t>& drawn);

  [[nodiscard]] std::uint32_t above(int column, int row) const { return above_.count(index(column, row)); }
  [[nodiscard]] std::uint32_t below(int column, int row) const { return below_.count(index(column, row)); }
  /// Node of the cut that the lines below it belong to, in this column; kNoNode where there are none.
  [[nodiscard]] NodeId owner(int column) const { return owner_[static_cast<std::size_t>(column)]; }
  /// Nodes looked at by the last draw().
  [[nodiscard]] std::size_t visited() const { return visited_; }

 private:
  struct Plane {
    std::vector<std::int32_t> across;  ///< changes along a row
    std::vector<std::int32_t> down;    ///< changes along a column
    [[nodiscard]] std::uint32_t count(std::size_t i) const {
      return static_cast<std::uint32_t>(across[i] + down[i]);
    }
  };
  struct Item {
    NodeId node;
    NodeId owner;  ///< node of the cut at or above it
  };

  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(stride_) +
           static_cast<std::size_t>(column);
  }
  void reset();
  void visit(const Item& item, std::vector<Item>& stack);
  void fillNarrow(const Item& item);
  void bar(Plane& plane, double fromX, double toX, double height);
  void stem(Plane& plane, double x, double fromHeight, double toHeight);
  void own(double fromX, double toX, NodeId owner);
  void sumUp(Plane& plane);

  const DendrogramLayout* layout_ = nullptr;
  const std::vector<std::uint8_t>* drawn_ = nullptr;
  DendrogramWindow window_;
  int stride_ = 0;  ///< width + 1: room for the change after the last pixel
  Plane above_;
  Plane below_;
  std::vector<NodeId> owner_;
  std::vector<Item> stack_;
  std::size_t visited_ = 0;
};

}  // namespace lodestone
