// A priority queue of vertices whose costs change.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

namespace lodestone {

/// A binary heap that knows where each vertex stands. Equal costs come in the order of the vertices, so that
/// the result does not depend on how the heap was built. Cost: O(log n) an operation.
class VertexQueue {
 public:
  explicit VertexQueue(std::size_t vertices) : place_(vertices, kNowhere), cost_(vertices, 0) {}

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::uint32_t top() const { return heap_.front(); }
  [[nodiscard]] double cost(std::uint32_t vertex) const { return cost_[vertex]; }
  [[nodiscard]] bool contains(std::uint32_t vertex) const { return place_[vertex] != kNowhere; }

  /// Adds the vertex, or changes its cost.
  void set(std::uint32_t vertex, double cost) {
    cost_[vertex] = cost;
    if (place_[vertex] == kNowhere) {
      place_[vertex] = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back(vertex);
    }
    rise(place_[vertex]);
    sink(place_[vertex]);
  }

  void remove(std::uint32_t vertex) {
    const std::uint32_t hole = place_[vertex];
    if (hole == kNowhere) return;
    place_[vertex] = kNowhere;
    const std::uint32_t last = heap_.back();
    heap_.pop_back();
    if (last == vertex) return;
    heap_[hole] = last;
    place_[last] = hole;
    rise(hole);
    sink(place_[last]);
  }

 private:
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;

  [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const {
    return cost_[a] != cost_[b] ? cost_[a] < cost_[b] : a < b;
  }
  void put(std::uint32_t vertex, std::uint32_t place) {
    heap_[place] = vertex;
    place_[vertex] = place;
  }
  void rise(std::uint32_t place) {
    const std::uint32_t vertex = heap_[place];
    while (place > 0 && before(vertex, heap_[(place - 1) / 2])) {
      put(heap_[(place - 1) / 2], place);
      place = (place - 1) / 2;
    }
    put(vertex, place);
  }
  void sink(std::uint32_t place) {
    const std::uint32_t vertex = heap_[place];
    for (std::uint32_t child = 2 * place + 1; child < heap_.size(); child = 2 * place + 1) {
      if (child + 1 < heap_.size() && before(heap_[child + 1], heap_[child])) ++child;
      if (!before(heap_[child], vertex)) break;
      put(heap_[child], place);
      place = child;
    }
    put(vertex, place);
  }

  std::vector<std::uint32_t> heap_;
  std::vector<std::uint32_t> place_;
  std::vector<double> cost_;
};

}  // namespace lodestone
