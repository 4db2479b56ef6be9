// Where a CityJSON file's integers stand in the world.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "model/city_model.h"
#include "model/io/places/georeference.h"

namespace lodestone {

/// The `transform` and `referenceSystem` of a file to be written, and local metres as its integers:
/// thousandths of the system's unit, or of 10⁻⁶ degrees. A model that stands nowhere on earth may be a
/// made thing of any size: there they are no more than 10⁻⁷ of its diagonal.
class CityJsonPlacement {
 public:
  explicit CityJsonPlacement(const CityModel& model);

  [[nodiscard]] std::array<std::int64_t, 3> quantise(const Vec3& local) const;
  /// The member `"transform":{…}`.
  [[nodiscard]] std::string transform() const;
  /// URL of the coordinate system; empty when it has none.
  [[nodiscard]] const std::string& referenceSystem() const { return referenceSystem_; }

 private:
  Frame frame_;
  Vec3 scale_;
  Vec3 translate_;
  std::string referenceSystem_;
  bool northFirst_ = false;  ///< the authority writes latitude before longitude
};

}  // namespace lodestone
