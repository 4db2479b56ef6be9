// The levels of detail that buildings bring along, and where they change (Polys et al. 2016, section 3;
// resources/docs/methods.md, 4).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/city_model.h"
#include "model/cut_off_options.h"
#include "model/face_count.h"

namespace lodestone {

/// Y(x) = α · β · γ^x. All in metres, as plain numbers. \pre all above 0
[[nodiscard]] double cutOff(double alpha, double beta, double gamma, double x);

/// Levels of each building, the finest first. A building without any of its own has one: its block.
class BuildingLevels {
 public:
  /// Cost: linear. Of n levels the i-th from the finest (from 1) gives way at Y(i / (n − 1)) metres, where α
  /// is the diagonal of the building's box.
  BuildingLevels(std::shared_ptr<const CityModel> city, const CutOffOptions& options);

  [[nodiscard]] const CityModel& city() const { return *city_; }
  /// γ as it was given or found.
  [[nodiscard]] double plotRadius() const { return plotRadius_; }
  [[nodiscard]] std::span<const FaceCount> faces(std::uint32_t building) const {
    return {faces_.data() + first_[building], first_[building + 1] - first_[building]};
  }
  /// Metres at which each level but the coarsest gives way, rising.
  [[nodiscard]] std::span<const double> distances(std::uint32_t building) const {
    return {distances_.data() + (first_[building] - building), first_[building + 1] - first_[building] - 1};
  }
  /// The box around the building as it is drawn; empty where it has neither geometry nor footprint.
  [[nodiscard]] const Box3& box(std::uint32_t building) const { return boxes_[building]; }

 private:
  std::shared_ptr<const CityModel> city_;
  double plotRadius_ = 0;
  std::vector<std::uint32_t> first_{0};  ///< of each building in faces_
  std::vector<FaceCount> faces_;
  std::vector<double> distances_;
  std::vector<Box3> boxes_;
};

}  // namespace lodestone
