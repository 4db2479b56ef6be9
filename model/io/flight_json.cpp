#include "model/io/flight_json.h"

#include <cmath>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/input_file.h"

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;
constexpr double kSpeed = 20;  // m/s: what the study of proxy prisms flew at

Diagnostic malformed(const std::string& why) {
  return diagnose(Code::FileMalformed, "path: " + why);
}

std::optional<double> numberAt(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_number()) return std::nullopt;
  return found->get<double>();
}

std::optional<Vec3> pointAt(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_array() || found->size() != 3) return std::nullopt;
  Vec3 point;
  for (int i = 0; i < 3; ++i) {
    const Json& part = (*found)[static_cast<std::size_t>(i)];
    if (!part.is_number()) return std::nullopt;
    point[i] = part.get<double>();
  }
  return point;
}

/// What is wrong with a key; nothing where it was read.
std::optional<std::string> readKey(const Json& json, KeyCamera& key) {
  if (!json.is_object()) return "is not an object";
  const auto eye = pointAt(json, "eye");
  const auto target = pointAt(json, "target");
  if (!eye || !target) return "wants \"eye\" and \"target\", three numbers each";
  if (*eye == *target) return "has its target where its eye is";
  key.eye = *eye;
  key.target = *target;
  if (json.contains("fov")) {
    const auto fov = numberAt(json, "fov");
    if (!fov || !(*fov > 0 && *fov < 170)) return "has a field of view that is not between 0 and 170 degrees";
    key.fov = *fov;
  }
  return std::nullopt;
}

}  // namespace

Result<FlightPath> parseFlightPath(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return malformed("not JSON");
  if (!json.is_object() || json.value("type", Json()) != "path") return malformed("its type is not \"path\"");
  Result<FlightPath> result{FlightPath{}};
  if (json.value("version", Json()) != kVersion)
    result.diagnostics.push_back(diagnose(Code::VersionUnsupported, "path"));
  const auto keys = json.find("keys");
  if (keys == json.end() || !keys->is_array() || keys->empty()) return malformed("it has no \"keys\"");
  std::size_t timed = 0;
  for (const Json& item : *keys) {
    KeyCamera key;
    const std::string name = fmt::format("key {}", result->keys.size() + 1);
    if (const auto why = readKey(item, key)) return malformed(name + " " + *why);
    if (const auto time = numberAt(item, "t")) {
      key.time = *time;
      if (timed++ > 0 && !(key.time > result->keys.back().time))
        return malformed(name + " is not later than the one before it");
    }
    result->keys.push_back(key);
  }
  if (timed > 0 && timed < result->keys.size())
    return malformed("some keys have a time \"t\" and others have none");
  if (timed > 0) return result;
  const double speed = json.contains("speed") ? numberAt(json, "speed").value_or(0) : kSpeed;
  if (!(speed > 0)) return malformed("\"speed\" is not a number above 0");
  for (std::size_t i = 1; i < result->keys.size(); ++i) {
    if (result->keys[i].eye == result->keys[i - 1].eye)
      return malformed(fmt::format("keys {} and {} stand in one place: give them times \"t\"", i, i + 1));
  }
  timeBySpeed(*result, speed);
  return result;
}

Result<FlightPath> loadFlightPath(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return diagnose(Code::FileNotFound, path.string());
  try {
    return parseFlightPath(readWholeFile(path));
  } catch (const std::system_error& error) {
    return diagnose(Code::FileUnreadable, error.what());
  }
}

std::string flightPathText(const FlightPath& path) {
  Json keys = Json::array();
  const auto point = [](const Vec3& p) { return Json{p.x(), p.y(), p.z()}; };
  for (const KeyCamera& key : path.keys)
    keys.push_back(
        {{"t", key.time}, {"eye", point(key.eye)}, {"target", point(key.target)}, {"fov", key.fov}});
  return Json{{"type", "path"}, {"version", kVersion}, {"keys", std::move(keys)}}.dump(1) + "\n";
}

}  // namespace lodestone
