#include "model/flight_path.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace lodestone {
namespace {

constexpr std::size_t kNumbers = 7;
using Numbers = std::array<double, kNumbers>;

Numbers numbersOf(const KeyCamera& key) {
  return {key.eye.x(), key.eye.y(), key.eye.z(), key.target.x(), key.target.y(), key.target.z(), key.fov};
}

/// Of the straight line from a key to the next one.
double slope(const std::vector<KeyCamera>& keys, std::size_t i, std::size_t number) {
  return (numbersOf(keys[i + 1])[number] - numbersOf(keys[i])[number]) / (keys[i + 1].time - keys[i].time);
}

/// At a key: 0 where the numbers turn, else the harmonic mean of both sides weighted by their lengths, which
/// keeps the cubic monotone (Fritsch and Butland 1984).
double tangent(const std::vector<KeyCamera>& keys, std::size_t i, std::size_t number) {
  if (i == 0) return slope(keys, 0, number);
  if (i + 1 == keys.size()) return slope(keys, i - 1, number);
  const double before = slope(keys, i - 1, number);
  const double after = slope(keys, i, number);
  if (before * after <= 0) return 0;
  const double shorter = keys[i].time - keys[i - 1].time;
  const double longer = keys[i + 1].time - keys[i].time;
  const double weightBefore = 2 * longer + shorter;
  const double weightAfter = longer + 2 * shorter;
  return (weightBefore + weightAfter) / (weightBefore / before + weightAfter / after);
}

double between(const std::vector<KeyCamera>& keys, std::size_t i, std::size_t number, double share) {
  const double length = keys[i + 1].time - keys[i].time;
  const double from = numbersOf(keys[i])[number];
  const double to = numbersOf(keys[i + 1])[number];
  const double s = share;
  const double rest = 1 - s;
  return from * (1 + 2 * s) * rest * rest + to * s * s * (3 - 2 * s) +
         length * (tangent(keys, i, number) * s * rest * rest - tangent(keys, i + 1, number) * s * s * rest);
}

Camera cameraOf(const Numbers& n, int width, int height) {
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}, n[6], width, height};
}

}  // namespace

double FlightPath::duration() const {
  return keys.empty() ? 0 : keys.back().time - keys.front().time;
}

Camera FlightPath::at(double seconds, int width, int height) const {
  const double time = keys.front().time + seconds;
  const auto next = std::upper_bound(keys.begin(), keys.end(), time,
                                     [](double t, const KeyCamera& key) { return t < key.time; });
  if (next == keys.begin()) return cameraOf(numbersOf(keys.front()), width, height);
  const auto i = static_cast<std::size_t>(next - keys.begin()) - 1;
  if (next == keys.end()) return cameraOf(numbersOf(keys.back()), width, height);
  const double share = (time - keys[i].time) / (next->time - keys[i].time);
  Numbers numbers{};
  for (std::size_t n = 0; n < kNumbers; ++n) numbers[n] = between(keys, i, n, share);
  return cameraOf(numbers, width, height);
}

void timeBySpeed(FlightPath& path, double speed) {
  for (std::size_t i = 0; i < path.keys.size(); ++i)
    path.keys[i].time =
        i == 0 ? 0 : path.keys[i - 1].time + (path.keys[i].eye - path.keys[i - 1].eye).norm() / speed;
}

}  // namespace lodestone
