// Union-find.
#pragma once

#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace lodestone {

/// Sets of the numbers 0 … n−1, joined by size with path halving: nearly constant time an operation.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count), size_(count, 1) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  [[nodiscard]] std::uint32_t find(std::uint32_t item) {
    while (parent_[item] != item) {
      parent_[item] = parent_[parent_[item]];
      item = parent_[item];
    }
    return item;
  }

  /// As find(), for several threads at once.
  [[nodiscard]] std::uint32_t root(std::uint32_t item) const {
    while (parent_[item] != item) item = parent_[item];
    return item;
  }

  /// Joins the sets of a and b; false when they are one already.
  bool join(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (size_[a] < size_[b]) std::swap(a, b);
    parent_[b] = a;
    size_[a] += size_[b];
    return true;
  }

 private:
  std::vector<std::uint32_t> parent_;
  std::vector<std::uint32_t> size_;
};

}  // namespace lodestone
