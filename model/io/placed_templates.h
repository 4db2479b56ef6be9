// How often templates may be placed.
#pragma once

#include <cstdint>

namespace lodestone {

/// Counts the vertices that placed templates have made. Templates may be placed often, but not so often that
/// a small file fills the memory: readers leave out the placements that come once it is full, and say so
/// (CountImplausible).
class PlacedTemplates {
 public:
  static constexpr std::uint64_t kMostVertices = 50'000'000;

  explicit PlacedTemplates(std::uint64_t mostVertices = kMostVertices) : most_(mostVertices) {}
  void add(std::uint64_t vertices) { placed_ += vertices; }
  [[nodiscard]] bool full() const { return placed_ > most_; }
  static constexpr const char* kTooOften = "templates are placed too often";

 private:
  std::uint64_t most_;
  std::uint64_t placed_ = 0;
};

}  // namespace lodestone
