// A flight through a city that measures itself (Chang et al. 2008, section 9).
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "algorithms/switching/switcher.h"
#include "model/flight_path.h"
#include "model/progress.h"

namespace lodestone {

struct FlightOptions {
  double framesPerSecond = 30;
  int width = 1280;
  int height = 800;
};

struct FlightFrame {
  double time = 0;  ///< seconds from the start
  Camera camera;
  FaceCount faces;              ///< drawn
  std::uint32_t clusters = 0;   ///< drawn
  std::uint32_t buildings = 0;  ///< drawn, landmarks apart
  std::uint32_t landmarks = 0;
  std::uint32_t culled = 0;    ///< nodes left out with all below them
  std::uint64_t switches = 0;  ///< since the frame before (algorithms/switching/switch_count.h)
  double pickTime = 0;         ///< seconds that choosing took, wall time
};

/// Called after each frame with what it draws, from the calling thread.
using FlightSink = std::function<void(const FlightFrame& frame, const Cut& cut)>;

/// Frames at equal times from the first key to the last, both included. \pre the path has a key. \throw
/// Cancelled
[[nodiscard]] std::vector<FlightFrame> fly(const ClusterTree& tree, Switcher& switcher,
                                           const FlightPath& path, const FlightOptions& options,
                                           const Progress& progress = {}, const FlightSink& sink = {});

}  // namespace lodestone
