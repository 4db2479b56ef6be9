#include "model/flight_path.h"

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

namespace lodestone {
namespace {

FlightPath randomPath(std::mt19937& random, int keys) {
  std::uniform_real_distribution<double> unit(-1, 1);
  FlightPath path;
  double time = 5 * unit(random);
  for (int i = 0; i < keys; ++i) {
    time += 1.1 + unit(random);
    path.keys.push_back({time, 500 * Vec3(unit(random), unit(random), unit(random)),
                         500 * Vec3(unit(random), unit(random), unit(random)), 60 + 30 * unit(random)});
  }
  return path;
}

TEST(FlightPath, GoesThroughItsKeysAndStaysBetweenThem) {
  std::mt19937 random(1);
  for (int round = 0; round < 50; ++round) {
    const FlightPath path = randomPath(random, 2 + round % 7);
    const double start = path.keys.front().time;
    for (std::size_t i = 0; i + 1 < path.keys.size(); ++i) {
      const KeyCamera& a = path.keys[i];
      const KeyCamera& b = path.keys[i + 1];
      EXPECT_LT((path.at(a.time - start, 8, 6).eye - a.eye).norm(), 1e-9);
      for (double share = 0; share <= 1; share += 0.05) {
        const Camera camera = path.at(a.time - start + share * (b.time - a.time), 8, 6);
        for (int k = 0; k < 3; ++k) {
          EXPECT_GE(camera.eye[k], std::min(a.eye[k], b.eye[k]) - 1e-9);
          EXPECT_LE(camera.eye[k], std::max(a.eye[k], b.eye[k]) + 1e-9);
          EXPECT_GE(camera.target[k], std::min(a.target[k], b.target[k]) - 1e-9);
          EXPECT_LE(camera.target[k], std::max(a.target[k], b.target[k]) + 1e-9);
        }
        EXPECT_GE(camera.fov, std::min(a.fov, b.fov) - 1e-9);
      }
    }
  }
}

TEST(FlightPath, HasNoKinksAtItsKeys) {
  std::mt19937 random(2);
  const FlightPath path = randomPath(random, 8);
  constexpr double kStep = 1e-6;
  for (std::size_t i = 1; i + 1 < path.keys.size(); ++i) {
    const double time = path.keys[i].time - path.keys.front().time;
    const Vec3 at = path.at(time, 8, 6).eye;
    const Vec3 before = (at - path.at(time - kStep, 8, 6).eye) / kStep;
    const Vec3 after = (path.at(time + kStep, 8, 6).eye - at) / kStep;
    EXPECT_LT((after - before).norm(), 0.05);
  }
}

TEST(FlightPath, StandsStillBeforeItBeginsAndAfterItsEnd) {
  std::mt19937 random(3);
  const FlightPath path = randomPath(random, 4);
  EXPECT_EQ(path.at(-1, 8, 6).eye, path.keys.front().eye);
  EXPECT_EQ(path.at(path.duration() + 1, 8, 6).eye, path.keys.back().eye);
  const FlightPath one{{path.keys.front()}};
  EXPECT_EQ(one.duration(), 0);
  EXPECT_EQ(one.at(3, 8, 6).target, path.keys.front().target);
}

}  // namespace
}  // namespace lodestone
