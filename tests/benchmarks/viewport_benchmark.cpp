// How long a city takes to its first picture, and a new cut to the next one. Run with
// QT_QPA_PLATFORM=offscreen (no display) or under a window system. Ratios are against one frame of the same
// picture with a moved camera: moving the cut must not cost more.
#include <QApplication>
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>

#include "algorithms/synthesis/synthesis.h"
#include "gui/city/viewport.h"

using namespace lodestone;

namespace {

double msSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

template <class Work>
double medianMs(int runs, const Work& work) {
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    const auto start = std::chrono::steady_clock::now();
    work(i);
    times.push_back(msSince(start));
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[static_cast<std::size_t>(runs / 2)];
}

/// Every building but those of one stripe, which moves: as many new ranges as a cut ever has.
Cut stripes(std::size_t buildings, int step) {
  Cut cut;
  for (std::size_t i = 0; i < buildings; ++i) {
    if ((i + static_cast<std::size_t>(step)) % 10 != 0)
      cut.drawn.push_back({static_cast<NodeId>(i), DrawRole::Building});
  }
  return cut;
}

void measure(int buildings) {
  SynthOptions options;
  options.preset = CityPreset::Charlotte;
  options.buildings = buildings;
  const auto city = std::make_shared<CityModel>(synthesiseCity(options));
  Viewport view;
  view.resize(1280, 800);
  (void)view.grabImage();  // the context and its shaders are not the city's cost
  auto start = std::chrono::steady_clock::now();
  view.scene().setCity(city);
  const double mesh = msSince(start);
  view.fit();
  (void)view.grabImage();
  const double first = msSince(start);
  CityScene& scene = view.scene();
  Camera camera = scene.camera();
  const double frame = medianMs(5, [&](int i) {
    camera.eye.x() += i;
    view.setCamera(camera);
    (void)view.grabImage();
  });
  const double hover = medianMs(5, [&](int i) {
    scene.setHover(static_cast<NodeId>(i));
    (void)view.grabImage();
  });
  std::vector<Cut> cuts;
  for (int i = 0; i < 5; ++i) cuts.push_back(stripes(city->buildings.size(), i));
  const double cut = medianMs(5, [&](int i) {
    scene.showCut(cuts[static_cast<std::size_t>(i)]);
    (void)view.grabImage();
  });
  scene.showAllBuildings();
  const double pick = medianMs(21, [&](int i) { (void)scene.pick(200 + 40 * i, 500); });
  std::printf("%9zu %10.0f %10.0f %10.1f %10.1f %10.1f %8.2f %10.2f\n", city->buildings.size(), mesh, first,
              frame, hover, cut, cut / frame, pick);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  Viewport::setDefaultSurfaceFormat();
  QApplication application(argc, argv);
  std::printf("%9s %10s %10s %10s %10s %10s %8s %10s\n", "buildings", "mesh ms", "first ms", "frame ms",
              "hover ms", "new cut ms", "/ frame", "pick ms");
  for (const int buildings : {2'500, 40'000, 369'929}) measure(buildings);
  return 0;
}
