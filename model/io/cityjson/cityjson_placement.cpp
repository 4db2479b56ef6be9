#include "model/io/cityjson/cityjson_placement.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <ogr_spatialref.h>

#include "model/io/json_writing.h"

namespace lodestone {
namespace {

std::string urlOf(const Crs& crs) {
  if (crs.epsg > 0) return fmt::format("https://www.opengis.net/def/crs/EPSG/0/{}", crs.epsg);
  const bool isUrl = crs.source.starts_with("http://www.opengis.net/def/crs/") ||
                     crs.source.starts_with("https://www.opengis.net/def/crs/");
  return isUrl ? crs.source : std::string();
}

/// Metres; a power of ten.
double stepOf(const CityModel& model) {
  constexpr double kLargest = 0.001;
  constexpr double kShare = 1e-7;
  const Box3 box = bounds(model);
  const bool onEarth = model.crs.kind == CrsKind::Projected || model.crs.kind == CrsKind::Geographic;
  if (onEarth || box.empty() || !(box.size().norm() > 0)) return kLargest;
  const double exponent = std::floor(std::log10(kShare * box.size().norm()));
  return std::min(kLargest, 1 / std::round(std::pow(10, -exponent)));
}

}  // namespace

CityJsonPlacement::CityJsonPlacement(const CityModel& model)
    : frame_(model), scale_(Vec3::Constant(stepOf(model))), referenceSystem_(urlOf(model.crs)) {
  const Vec3 middle = frame_.toWorld(Vec3(0, 0, 0));
  translate_ = middle.array().round();
  if (model.crs.kind == CrsKind::Geographic) {
    scale_ = Vec3(1e-9, 1e-9, 0.001);  // 0.1 mm on the ground
    translate_ =
        Vec3(std::round(middle.x() * 1000) / 1000, std::round(middle.y() * 1000) / 1000, translate_.z());
    const auto reference = spatialReference(model.crs);
    northFirst_ = model.crs.epsg > 0 && reference && reference->EPSGTreatsAsLatLong() != 0;
  }
  if (northFirst_) std::swap(translate_.x(), translate_.y());
}

std::array<std::int64_t, 3> CityJsonPlacement::quantise(const Vec3& local) const {
  Vec3 world = frame_.toWorld(local);
  if (northFirst_) std::swap(world.x(), world.y());
  std::array<std::int64_t, 3> result{};
  for (int axis = 0; axis < 3; ++axis) {
    const double steps = std::round((world[axis] - translate_[axis]) / scale_[axis]);
    // Integers that doubles hold: what is beyond was never a place.
    constexpr double kGreatest = 9.0e15;
    result[static_cast<std::size_t>(axis)] =
        std::abs(steps) < kGreatest ? static_cast<std::int64_t>(steps) : 0;
  }
  return result;
}

std::string CityJsonPlacement::transform() const {
  return fmt::format(R"("transform":{{"scale":[{},{},{}],"translate":[{},{},{}]}})", jsonNumber(scale_.x()),
                     jsonNumber(scale_.y()), jsonNumber(scale_.z()), jsonNumber(translate_.x()),
                     jsonNumber(translate_.y()), jsonNumber(translate_.z()));
}

}  // namespace lodestone
