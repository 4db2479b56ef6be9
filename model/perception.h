// What of a model people perceive (Du, Zhu and Zhao; resources/docs/methods.md, section 5).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "model/camera.h"
#include "model/perceive_options.h"

namespace lodestone {

/// How much of a place the eye filters away (table 1): the more, the less is perceived there.
enum class DetailClass : std::uint8_t { None, Slight, Moderate, Dramatic };
inline constexpr std::size_t kDetailClasses = 4;
[[nodiscard]] const char* toString(DetailClass detailClass);  ///< "none", "slight", …

/// Magnitudes of differences are counted in bins that are finer where they are small: bin b begins at
/// (b / 16)² grey levels.
inline constexpr int kDifferenceBins = 256;
[[nodiscard]] int differenceBin(float greyLevels);
[[nodiscard]] double binBegin(int bin);  ///< grey levels; of kDifferenceBins: 256

/// Numbers of pixels by bin of their difference.
using DifferenceHistogram = std::array<std::uint64_t, kDifferenceBins>;

struct Gaussian {
  double prior = 0;  ///< share of the pixels; 0: the class is empty
  double mean = 0;   ///< grey levels
  double sigma = 0;  ///< grey levels
};

/// The classes of differences, and where they are cut.
struct DifferenceClasses {
  std::array<Gaussian, kDetailClasses> gaussians;
  /// The first bins of Slight, Moderate and Dramatic; never falling, kDifferenceBins where there is none.
  std::array<int, kDetailClasses - 1> cuts{kDifferenceBins, kDifferenceBins, kDifferenceBins};

  [[nodiscard]] DetailClass of(int bin) const {
    return static_cast<DetailClass>((bin >= cuts[0]) + (bin >= cuts[1]) + (bin >= cuts[2]));
  }
};

/// Of the triangles of a ComponentMesh, over all pictures.
struct Perception {
  PerceiveOptions options;
  std::vector<Camera> cameras;
  DifferenceHistogram histogram{};  ///< of the pixels that show the model
  DifferenceClasses differences;
  /// Pixels of triangle t by bin: [t · kDifferenceBins, (t + 1) · kDifferenceBins); null where nobody looked.
  /// They are most of the memory: whoever judges them by other cuts shares them.
  std::shared_ptr<const std::vector<std::uint32_t>> triangleBins;
  std::vector<std::uint32_t> pixels;  ///< that show triangle t
  /// Triangle t can be seen, but no picture shows it: it is smaller than a pixel, or in sight only from
  /// elsewhere. Empty where nobody looked for such.
  std::vector<bool> glimpsed;
  std::vector<DetailClass> classes;  ///< of triangle t; None where no picture shows it

  [[nodiscard]] bool isSeen(std::size_t triangle) const {
    return pixels[triangle] > 0 || (!glimpsed.empty() && glimpsed[triangle]);
  }
};

/// Whether triangles may be simplified: those of the classes of stage 1 (dramatic), 2 (and moderate) or 3
/// (and slight), those that were never seen where `unseen` says so.
[[nodiscard]] std::vector<bool> admittedTriangles(const Perception& perception, int stage, bool unseen);

/// Numbers of triangles by what is perceived of them.
struct DetailCounts {
  std::array<std::uint32_t, kDetailClasses> seen{};  ///< by class
  std::uint32_t unseen = 0;

  /// As many as admittedTriangles() names.
  [[nodiscard]] std::uint32_t admitted(int stage, bool withUnseen) const;
};
[[nodiscard]] DetailCounts countDetail(const Perception& perception);

/// The class that most pixels of each triangle have, of equally many the lower one; by other cuts than those
/// it holds. Cost: O(triangles · bins).
[[nodiscard]] std::vector<DetailClass> classesOfTriangles(const Perception& perception,
                                                          const DifferenceClasses& differences);

}  // namespace lodestone
