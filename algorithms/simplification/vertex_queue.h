// A priority queue of vertices whose costs change.
#pragma once

#include <cstdint>
#include <vector>

namespace lodestone {

/// A binary heap that knows where each vertex stands. Equal costs come in the order of the vertices, so that
/// the result does not depend on how the heap was built. Cost: O(log n) an operation.
class VertexQueue {
 public:
  explicit VertexQueue(std::size_t vertices) : place_(vertices, kNowhere) {}

  [[nodiscard]] bool empty() const { return heap_.empty(); }
  [[nodiscard]] std::uint32_t top() const { return heap_.front().vertex; }
  /// \pre the vertex is in the queue.
  [[nodiscard]] double cost(std::uint32_t vertex) const { return heap_[place_[vertex]].cost; }
  [[nodiscard]] bool contains(std::uint32_t vertex) const { return place_[vertex] != kNowhere; }

  void addCosts(std::vector<double>& costs) const {
    for (const Entry& entry : heap_) costs.push_back(entry.cost);
  }

  /// Adds the vertex, or changes its cost.
  void set(std::uint32_t vertex, double cost) {
    if (place_[vertex] == kNowhere) {
      place_[vertex] = static_cast<std::uint32_t>(heap_.size());
      heap_.push_back({cost, vertex});
    }
    heap_[place_[vertex]].cost = cost;
    rise(place_[vertex]);
    sink(place_[vertex]);
  }

  void clear() {
    for (const Entry& entry : heap_) place_[entry.vertex] = kNowhere;
    heap_.clear();
  }

  void remove(std::uint32_t vertex) {
    const std::uint32_t hole = place_[vertex];
    if (hole == kNowhere) return;
    place_[vertex] = kNowhere;
    const Entry last = heap_.back();
    heap_.pop_back();
    if (last.vertex == vertex) return;
    put(last, hole);
    rise(hole);
    sink(place_[last.vertex]);
  }

 private:
  static constexpr std::uint32_t kNowhere = 0xFFFFFFFFU;

  /// The cost stands in the heap itself: comparisons look nowhere else.
  struct Entry {
    double cost = 0;
    std::uint32_t vertex = 0;
    [[nodiscard]] bool before(const Entry& other) const {
      return cost != other.cost ? cost < other.cost : vertex < other.vertex;
    }
  };

  void put(const Entry& entry, std::uint32_t place) {
    heap_[place] = entry;
    place_[entry.vertex] = place;
  }
  void rise(std::uint32_t place) {
    const Entry entry = heap_[place];
    while (place > 0 && entry.before(heap_[(place - 1) / 2])) {
      put(heap_[(place - 1) / 2], place);
      place = (place - 1) / 2;
    }
    put(entry, place);
  }
  void sink(std::uint32_t place) {
    const Entry entry = heap_[place];
    for (std::uint32_t child = 2 * place + 1; child < heap_.size(); child = 2 * place + 1) {
      if (child + 1 < heap_.size() && heap_[child + 1].before(heap_[child])) ++child;
      if (!heap_[child].before(entry)) break;
      put(heap_[child], place);
      place = child;
    }
    put(entry, place);
  }

  std::vector<Entry> heap_;
  std::vector<std::uint32_t> place_;
};

}  // namespace lodestone
