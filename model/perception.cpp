#include "model/perception.h"

#include <algorithm>
#include <cmath>
#include <numeric>

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

std::uint32_t DetailCounts::admitted(int stage, bool withUnseen) const {
  return std::accumulate(seen.end() - stage, seen.end(), withUnseen ? unseen : 0U);
}

DetailCounts countDetail(const Perception& perception) {
  DetailCounts counts;
  for (std::size_t t = 0; t < perception.classes.size(); ++t)
    ++(perception.isSeen(t) ? counts.seen[static_cast<std::size_t>(perception.classes[t])] : counts.unseen);
  return counts;
}

std::vector<DetailClass> classesOfTriangles(const Perception& perception,
                                            const DifferenceClasses& differences) {
  std::vector<DetailClass> classes(perception.pixels.size(), DetailClass::None);
  const auto& cuts = differences.cuts;
  const std::array<int, kDetailClasses + 1> begins{0, cuts[0], cuts[1], cuts[2], kDifferenceBins};
  for (std::size_t t = 0; t < classes.size(); ++t) {
    if (!perception.isSeen(t)) continue;
    const std::uint32_t* bins = perception.triangleBins->data() + t * kDifferenceBins;
    std::array<std::uint64_t, kDetailClasses> pixels{};
    for (std::size_t k = 0; k < kDetailClasses; ++k)
      pixels[k] = std::accumulate(bins + begins[k], bins + begins[k + 1], std::uint64_t{0});
    classes[t] = static_cast<DetailClass>(std::max_element(pixels.begin(), pixels.end()) - pixels.begin());
  }
  return classes;
}

}  // namespace lodestone
