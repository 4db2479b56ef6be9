// Parallel loops that can be cancelled.
#pragma once

#include <atomic>
#include <cstddef>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "model/progress.h"

namespace lodestone {

/// Calls `body(first, last)` on pieces of [begin, end) of at most `grain` items, in parallel where there are
/// several. Once a stop is requested no further piece is begun; nothing is thrown: the caller checks
/// afterwards, outside every parallel body. Choose the grain so that a piece takes a few milliseconds at
/// most.
template <class Body>
void forPieces(std::size_t begin, std::size_t end, std::size_t grain, const Progress& progress,
               const Body& body) {
  if (end <= begin || progress.stopRequested()) return;
  if (end - begin <= grain) {  // a round of a few merges is not worth a task
    body(begin, end);
    return;
  }
  // The simple partitioner keeps pieces small, so that a stop is noticed soon.
  tbb::parallel_for(
      tbb::blocked_range<std::size_t>(begin, end, grain),
      [&](const tbb::blocked_range<std::size_t>& piece) {
        if (!progress.stopRequested()) body(piece.begin(), piece.end());
      },
      tbb::simple_partitioner());
}

/// forPieces() that reports the share of items done.
template <class Body>
void forPiecesReported(std::size_t count, std::size_t grain, const Progress& progress, const Body& body) {
  std::atomic<std::size_t> done{0};
  forPieces(0, count, grain, progress, [&](std::size_t first, std::size_t last) {
    body(first, last);
    const std::size_t now = done.fetch_add(last - first, std::memory_order_relaxed) + (last - first);
    progress.report(static_cast<double>(now) / static_cast<double>(count));
  });
}

}  // namespace lodestone
