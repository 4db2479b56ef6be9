// For hash tables over vertices, triangles and places.
#pragma once

#include <cstddef>
#include <functional>
#include <type_traits>

namespace lodestone {

/// Of a few numbers in a range: an array of indices, a Vec3. Equal numbers hash alike, 0 and -0 among them.
struct TupleHash {
  template <class Numbers>
  std::size_t operator()(const Numbers& numbers) const {
    constexpr std::size_t kOdd = 0x9E3779B97F4A7C15U;  // 2^64 / golden ratio: spreads neighbours
    std::size_t hash = 0;
    for (const auto x : numbers)
      hash = (hash ^ std::hash<std::decay_t<decltype(x)>>{}(x)) * kOdd + (hash >> 29U);
    return hash;
  }
};

}  // namespace lodestone
