// Plan outlines with attributes, row by row: what the vector writers take.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <variant>
#include <vector>

#include <tbb/parallel_for.h>

#include "model/cluster_tree.h"
#include "model/lod_chain.h"
#include "model/progress.h"

namespace lodestone {

/// monostate: no value.
using OutlineValue =
    std::variant<std::monostate, std::int64_t, double, std::string, std::vector<std::string>>;

struct OutlineColumn {
  enum class Type { Integer, Real, Text, TextList };
  std::string name;
  Type type = Type::Text;
  bool sparse = false;  ///< many rows have no value: formats that name each value leave it out there
};

struct OutlineRow {
  std::vector<OutlineValue> values;  ///< as many as columns
  MultiPolygon outline;              ///< world coordinates, x east, y north
};

struct OutlineTable {
  std::string name;
  std::vector<OutlineColumn> columns;
  std::size_t rows = 0;
  bool multi = true;  ///< some outlines have several polygons
  /// Row i. Safe to call from several threads.
  std::function<OutlineRow(std::size_t)> row;
  /// Called with each row as it is written, in order, from one thread; may be empty.
  std::function<void(const OutlineRow&)> seen;
};

/// Objects of each wanted level: id, level, role, node, of, buildings (count), base, height, negative, then
/// the attributes of the building where it is a single one (model/io/outlines/attribute_columns.h),
/// building_ids last. The chain must outlive the tables. \pre chain.city
[[nodiscard]] std::vector<OutlineTable> levelTables(const LodChain& chain,
                                                    const std::vector<std::size_t>& asked);
/// Hulls of all nodes: node, parent (−1 for the root), size, edges, area, negative, height, base, max_top,
/// building.
[[nodiscard]] OutlineTable hullTable(const CityModel& city, const ClusterTree& tree);
/// The levels that the options ask for and the chain has, ascending.
[[nodiscard]] std::vector<std::size_t> wantedLevels(const LodChain& chain,
                                                    const std::vector<std::size_t>& asked);

/// Makes `make(i)` for all i in parallel and hands the results to `take`, in order, one at a time. Memory
/// follows the chunk. \throw Cancelled
template <class Make, class Take>
void inOrder(std::size_t count, const Progress& progress, const Make& make, const Take& take) {
  constexpr std::size_t kChunk = 4096;
  std::vector<decltype(make(std::size_t{0}))> made;
  for (std::size_t begin = 0; begin < count; begin += kChunk) {
    const std::size_t size = std::min(kChunk, count - begin);
    made.clear();
    made.resize(size);
    tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
      if (!progress.stopRequested()) made[i] = make(begin + i);
    });
    progress.checkpoint();
    for (auto& one : made) take(one);
    progress.report(static_cast<double>(begin + size) / static_cast<double>(count));
  }
}

}  // namespace lodestone
