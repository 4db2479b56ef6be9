// A level's objects as a stream of blocks: made and encoded in parallel, ordered and written one after the
// other, so that memory follows the block and not the city, and the bytes do not depend on the number of
// threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <memory>
#include <vector>

#include <tbb/parallel_pipeline.h>
#include <tbb/task_arena.h>

#include "model/lod_chain.h"
#include "model/progress.h"

namespace lodestone {

/// Consecutive objects of a level and whatever a writer makes of them.
template <class Content>
struct LevelBlock {
  std::size_t first = 0;  ///< index of the first object
  std::vector<LevelObject> objects;
  Content content;
};

/// For each block: `make(block)` and `encode(block)` in parallel, `order(block)` and `write(block)` one at a
/// time in the order of the level; in this sequence. None of them may throw; `write` returns false to stop.
/// \throw Cancelled
template <class Content, class Make, class Order, class Encode, class Write>
void streamLevel(const LodLevel& level, const Progress& progress, Make&& make, Order&& order, Encode&& encode,
                 Write&& write) {
  constexpr std::size_t kObjects = 512;
  using Block = std::shared_ptr<LevelBlock<Content>>;
  std::size_t next = 0;
  std::atomic<bool> stopped = false;  // told by the last filter, asked by the first
  const auto source = [&](tbb::flow_control& flow) -> Block {
    if (next >= level.objectCount || stopped || progress.stopRequested()) {
      flow.stop();
      return nullptr;
    }
    auto block = std::make_shared<LevelBlock<Content>>();
    block->first = next;
    next = std::min(level.objectCount, next + kObjects);
    block->objects.resize(next - block->first);
    return block;
  };
  const auto fill = [&](Block block) {
    for (std::size_t i = 0; i < block->objects.size() && !progress.stopRequested(); ++i) {
      block->objects[i] = level.object(block->first + i);
    }
    make(*block);
    return block;
  };
  const auto place = [&](Block block) {
    order(*block);
    return block;
  };
  const auto turn = [&](Block block) {
    encode(*block);
    return block;
  };
  const auto finish = [&](const Block& block) {
    if (!stopped && !progress.stopRequested()) stopped = !write(*block);
    progress.report(static_cast<double>(block->first + block->objects.size()) /
                    static_cast<double>(level.objectCount));
  };
  const auto inFlight = static_cast<std::size_t>(2 * tbb::this_task_arena::max_concurrency());
  using tbb::filter_mode;
  tbb::parallel_pipeline(inFlight, tbb::make_filter<void, Block>(filter_mode::serial_in_order, source) &
                                       tbb::make_filter<Block, Block>(filter_mode::parallel, fill) &
                                       tbb::make_filter<Block, Block>(filter_mode::serial_in_order, place) &
                                       tbb::make_filter<Block, Block>(filter_mode::parallel, turn) &
                                       tbb::make_filter<Block, void>(filter_mode::serial_in_order, finish));
  progress.checkpoint();
}

}  // namespace lodestone
