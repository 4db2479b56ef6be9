#include "cli/camera_argument.h"

#include <map>
#include <optional>

#include <fmt/format.h>

#include "cli/run.h"
#include "model/attributes.h"
#include "model/io/places/georeference.h"

namespace lodestone::cli {
namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == separator) {
      parts.emplace_back();
    } else {
      parts.back() += c;
    }
  }
  return parts;
}

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw Failure(diagnose(Code::OptionBadValue, fmt::format("camera \"{}\": {}", text, why)));
}

}  // namespace

void parseSize(const std::string& text, const std::string& part, Camera& camera) {
  const std::vector<std::string> sides = split(part, 'x');
  constexpr double kLargest = 16384;
  const auto side = [&](std::size_t i) {
    const std::optional<double> n = parseNumber(sides[i]);
    if (!n || *n < 1 || *n > kLargest || *n != static_cast<int>(*n))
      refuse(text, "the size is WxH, 1 to 16384 pixels each");
    return static_cast<int>(*n);
  };
  if (sides.size() != 2) refuse(text, "the size is WxH");
  camera.width = side(0);
  camera.height = side(1);
}

namespace {

Camera fitFrom(const std::string& text, const CityModel& city) {
  constexpr double kDown = -0.6;  // looks down at about 31°
  static const std::map<std::string, Vec3> kDirections{
      {"n", {0, 1, kDown}},       {"ne", {0.7, 0.7, kDown}},  {"e", {1, 0, kDown}},
      {"se", {0.7, -0.7, kDown}}, {"s", {0, -1, kDown}},      {"sw", {-0.7, -0.7, kDown}},
      {"w", {-1, 0, kDown}},      {"nw", {-0.7, 0.7, kDown}}, {"top", {0, 0, -1}}};
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() > 2) refuse(text, "wanted fit[:direction][,WxH]");
  const std::string direction = parts[0] == "fit" ? "nw" : parts[0].substr(4);
  const auto found = kDirections.find(direction);
  if (found == kDirections.end()) refuse(text, "the direction is one of n, ne, e, se, s, sw, w, nw, top");
  Camera size;
  if (parts.size() == 2) parseSize(text, parts[1], size);
  std::vector<Box3> boxes;
  for (const Building& building : city.buildings) boxes.push_back(bounds(building));
  boxes = withoutStrays(std::move(boxes));
  if (boxes.empty()) return fitCamera(bounds(city), found->second, size.fov, size.width, size.height);
  FrameFit fit(size, found->second, false);
  for (const Box3& box : boxes) fit.add(box);
  return fit.camera();
}

}  // namespace

Camera parseCamera(const std::string& text, const CityModel& city) {
  if (text == "fit" || text.starts_with("fit:") || text.starts_with("fit,")) return fitFrom(text, city);
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 6 || parts.size() > 8)
    refuse(text, "wanted x,y,z,tx,ty,tz[,fov[,WxH]] or fit[:direction][,WxH]");
  std::vector<double> n;
  for (std::size_t i = 0; i < std::min<std::size_t>(parts.size(), 7); ++i) {
    const std::optional<double> value = parseNumber(parts[i]);
    if (!value) refuse(text, fmt::format("\"{}\" is not a number", parts[i]));
    n.push_back(*value);
  }
  Camera camera;
  const bool metres = city.crs.kind == CrsKind::Geographic;
  const auto place = [&](const Vec3& p) { return metres ? p : toLocal(city, p); };
  camera.eye = place({n[0], n[1], n[2]});
  camera.target = place({n[3], n[4], n[5]});
  if (camera.eye == camera.target) refuse(text, "eye and target are the same point");
  if (n.size() == 7) camera.fov = n[6];
  if (!(camera.fov > 0 && camera.fov < 170)) refuse(text, "the field of view is between 0 and 170 degrees");
  if (parts.size() == 8) parseSize(text, parts[7], camera);
  return camera;
}

Camera asGiven(Camera camera, const CityModel& city) {
  if (city.crs.kind == CrsKind::Geographic) return camera;
  camera.eye = toWorld(city, camera.eye);
  camera.target = toWorld(city, camera.target);
  return camera;
}

}  // namespace lodestone::cli
