#include "algorithms/flights/flight.h"

#include <chrono>
#include <cmath>

#include "algorithms/switching/switch_count.h"

namespace lodestone {
namespace {

void count(const Cut& cut, FlightFrame& frame) {
  frame.faces = cut.faces;
  frame.culled = static_cast<std::uint32_t>(cut.culled.size());
  for (const DrawnNode& item : cut.drawn) {
    frame.clusters += item.role == DrawRole::Cluster ? 1 : 0;
    frame.buildings += item.role == DrawRole::Building ? 1 : 0;
    frame.landmarks += item.role == DrawRole::Landmark ? 1 : 0;
  }
}

}  // namespace

std::vector<FlightFrame> fly(const ClusterTree& tree, Switcher& switcher, const FlightPath& path,
                             const FlightOptions& options, const Progress& progress, const FlightSink& sink) {
  const auto last = static_cast<std::size_t>(std::floor(path.duration() * options.framesPerSecond + 1e-9));
  std::vector<FlightFrame> frames;
  SwitchCounter switches(tree);
  for (std::size_t i = 0; i <= last; ++i) {
    progress.checkpoint();
    FlightFrame frame;
    frame.time = static_cast<double>(i) / options.framesPerSecond;
    frame.camera = path.at(frame.time, options.width, options.height);
    const auto begin = std::chrono::steady_clock::now();
    const Cut& cut = switcher.pick(frame.camera);
    frame.pickTime = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    count(cut, frame);
    frame.switches = switches.next(cut);
    frames.push_back(frame);
    if (sink) sink(frames.back(), cut);
    progress.report(static_cast<double>(i + 1) / static_cast<double>(last + 1));
  }
  return frames;
}

}  // namespace lodestone
