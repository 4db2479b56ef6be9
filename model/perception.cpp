#include "model/perception.h"

#include <algorithm>
#include <cmath>

namespace lodestone {
namespace {

constexpr double kBinsARoot = 16;

}  // namespace

const char* toString(DetailClass detailClass) {
  switch (detailClass) {
    case DetailClass::None:
      return "none";
    case DetailClass::Slight:
      return "slight";
    case DetailClass::Moderate:
      return "moderate";
    case DetailClass::Dramatic:
      return "dramatic";
  }
  return "";
}

int differenceBin(float greyLevels) {
  // In double precision: that of a float, the root of what lies just below a bin can round up into it.
  const double place = kBinsARoot * std::sqrt(static_cast<double>(std::max(0.F, greyLevels)));
  return static_cast<int>(std::min(place, kDifferenceBins - 1.0));
}

double binBegin(int bin) {
  return bin / kBinsARoot * (bin / kBinsARoot);
}

std::vector<bool> admittedTriangles(const Perception& perception, int stage, bool unseen) {
  const auto lowest = static_cast<int>(kDetailClasses) - stage;
  std::vector<bool> admitted(perception.classes.size());
  for (std::size_t t = 0; t < admitted.size(); ++t)
    admitted[t] = perception.isSeen(t) ? static_cast<int>(perception.classes[t]) >= lowest : unseen;
  return admitted;
}

std::vector<DetailClass> classesOfTriangles(const Perception& perception,
                                            const DifferenceClasses& differences) {
  std::vector<DetailClass> classes(perception.pixels.size(), DetailClass::None);
  for (std::size_t t = 0; t < classes.size(); ++t) {
    if (!perception.isSeen(t)) continue;
    std::array<std::uint64_t, kDetailClasses> pixels{};
    for (int bin = 0; bin < kDifferenceBins; ++bin)
      pixels[static_cast<std::size_t>(differences.of(bin))] +=
          perception.triangleBins[t * kDifferenceBins + static_cast<std::size_t>(bin)];
    classes[t] = static_cast<DetailClass>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin());
  }
  return classes;
}

}  // namespace lodestone
