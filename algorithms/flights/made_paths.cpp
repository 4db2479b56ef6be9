#include "algorithms/flights/made_paths.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <utility>

namespace lodestone {
namespace {

constexpr double kBlock = 250;  // metres: how densely a place is built is counted in such squares
constexpr int kKeys = 24;       // of a way that curves

Box3 unionOf(const std::vector<Box3>& boxes) {
  Box3 all;
  for (const Box3& box : boxes) all.add(box);
  return all;
}

/// The middle building of the square with the most; of equal ones that of the first.
Vec3 densestPlace(const std::vector<Box3>& boxes) {
  std::map<std::pair<long, long>, std::vector<const Box3*>> squares;
  for (const Box3& box : boxes) {
    if (box.empty()) continue;
    squares[{std::lround(box.center().x() / kBlock), std::lround(box.center().y() / kBlock)}].push_back(&box);
  }
  const auto densest = std::max_element(squares.begin(), squares.end(), [](const auto& a, const auto& b) {
    return a.second.size() < b.second.size();
  });
  const Box3& middle = *densest->second[densest->second.size() / 2];
  return {middle.center().x(), middle.center().y(), middle.max.z()};
}

}  // namespace

FlightPath groundToSky(const std::vector<Box3>& boxes, double seconds) {
  const Box3 all = unionOf(boxes);
  const Vec3 start = densestPlace(boxes) + Vec3(0, 0, 2);
  std::vector<Box3> worth = withoutStrays(boxes);
  FrameFit fit({}, Vec3(0.35, 0.7, -1), false);
  for (const Box3& box : worth) fit.add(box);
  const Camera whole = fit.camera();
  const Vec3 middle = all.center();
  FlightPath path;
  // From low to high each second adds the same share of the height, as zooming out does.
  const double growth = std::log((whole.eye.z() - start.z() + 1));
  for (int i = 0; i < kKeys; ++i) {
    const double share = i / double{kKeys - 1};
    const double lifted = (std::exp(growth * share) - 1) / (std::exp(growth) - 1);
    const Vec3 eye = start + lifted * (whole.eye - start);
    const Vec3 ahead = start + Vec3((middle - start).x(), (middle - start).y(), 0).normalized() * 300;
    const Vec3 first = (middle - start).head<2>().norm() > 1 ? ahead : Vec3(start + Vec3(0, 300, 0));
    path.keys.push_back({seconds * share, eye, first + share * share * (whole.target - first), whole.fov});
  }
  return path;
}

FlightPath randomPath(const Box3& area, const RandomFlight& flight) {
  std::mt19937 random(flight.seed);
  // The standard's distributions differ from one library to the next.
  const auto share = [&] { return static_cast<double>(random()) / 4294967296.0; };
  const double height = area.min.z() + flight.height;
  const Vec2 size = area.size().head<2>().cwiseMax(flight.height);
  const Vec2 corner = area.center().head<2>() - size / 2;
  const auto place = [&] {
    const double x = corner.x() + share() * size.x();
    const double y = corner.y() + share() * size.y();
    return Vec3(x, y, height);
  };
  std::vector<Vec3> stops{place()};
  double length = 0;
  while (length < flight.speed * flight.seconds) {
    const Vec3 next = place();
    const double leg = (next - stops.back()).norm();
    if (leg < size.norm() / 10) continue;
    length += leg;
    stops.push_back(next);
  }
  FlightPath path;
  for (std::size_t i = 0; i < stops.size(); ++i) {
    const Vec3 along = i + 1 < stops.size() ? stops[i + 1] - stops[i] : stops[i] - stops[i - 1];
    const Vec3 ahead = along.normalized() - Vec3(0, 0, 0.2);  // a little down: at the buildings
    path.keys.push_back({0, stops[i], stops[i] + 100 * ahead, flight.fov});
  }
  timeBySpeed(path, flight.speed);
  return path;
}

}  // namespace lodestone
