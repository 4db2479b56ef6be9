#include "model/io/project_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string_view>
#include <system_error>

#include <nlohmann/json.hpp>

#include "model/io/atomic_file.h"
#include "model/io/json_options.h"
#include "model/io/kept_paths.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::array<std::pair<CutMode, std::string_view>, 4> kCutModes{{{CutMode::Camera, "camera"},
                                                                         {CutMode::Weight, "weight"},
                                                                         {CutMode::Tolerance, "tolerance"},
                                                                         {CutMode::Original, "original"}}};

Json vectorJson(const Vec3& v) {
  return Json::array({v.x(), v.y(), v.z()});
}
Vec3 vectorFrom(const Json& json) {
  return {json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>()};
}

Json cameraJson(const Camera& camera) {
  return {{"eye", vectorJson(camera.eye)},
          {"target", vectorJson(camera.target)},
          {"fov", camera.fov},
          {"size", {camera.width, camera.height}}};
}

Camera cameraFrom(const Json& json) {
  Camera camera;
  camera.eye = vectorFrom(json.at("eye"));
  camera.target = vectorFrom(json.at("target"));
  camera.fov = json.at("fov").get<double>();
  camera.width = json.at("size").at(0).get<int>();
  camera.height = json.at("size").at(1).get<int>();
  return camera;
}

Json cutChoiceJson(const CutChoice& choice) {
  const auto named = std::ranges::find(kCutModes, choice.mode, &std::pair<CutMode, std::string_view>::first);
  return {{"from", named->second}, {"value", choice.value}};
}

/// One that is not understood is said, and the camera chooses.
CutChoice cutChoiceFrom(const Json& json, Diagnostics& diagnostics) {
  const auto name = json.at("from").get<std::string>();
  const auto named = std::ranges::find(kCutModes, name, &std::pair<CutMode, std::string_view>::second);
  const auto value = json.value("value", 0.0);
  if (named != kCutModes.end() && std::isfinite(value) && value >= 0) return {named->first, value};
  diagnostics.push_back(diagnose(Code::OptionBadValue, "drawn: " + json.dump()));
  return {};
}

template <class Options>
void applyFrom(const Json& options, const char* name, Options& target, Diagnostics& diagnostics) {
  if (!options.contains(name)) return;
  Diagnostics more = setValues(target, optionValuesFrom(options.at(name), diagnostics));
  diagnostics.insert(diagnostics.end(), more.begin(), more.end());
}

/// \throw nlohmann::json::exception when a part is missing or of another type.
LoadedProject projectFrom(const Json& json, const fs::path& folder, Diagnostics& diagnostics) {
  LoadedProject project;
  ProjectState& state = project.state;
  state.sources = pathsFromKept(json.at("sources").get<std::vector<std::string>>(), folder);
  state.barriers =
      pathsFromKept(json.value("barriers", Json::array()).get<std::vector<std::string>>(), folder);
  const Json options = json.value("options", Json::object());
  applyFrom(options, "import", state.importOptions, diagnostics);
  applyFrom(options, "cluster", state.clusterOptions, diagnostics);
  applyFrom(options, "merge", state.mergeOptions, diagnostics);
  applyFrom(options, "cut", state.chainOptions.cut, diagnostics);  // of files from before chains were kept
  applyFrom(options, "chain", state.chainOptions, diagnostics);
  applyFrom(options, "simplify", state.simplifyOptions, diagnostics);
  applyFrom(options, "compare", state.comparedOptions, diagnostics);
  applyFrom(options, "perceive", state.perceiveOptions, diagnostics);
  applyFrom(options, "sight", state.sight, diagnostics);
  if (json.contains("drawn")) state.cutChoice = cutChoiceFrom(json.at("drawn"), diagnostics);
  if (json.contains("camera")) state.camera = cameraFrom(json.at("camera"));
  state.looks = json.value("looks", std::string());
  project.layout = json.value("layout", std::string());
  return project;
}

}  // namespace

Result<bool> saveProject(const ProjectState& state, const fs::path& path, const std::string& layout) {
  const fs::path folder = fs::absolute(path).parent_path();
  const Json json = {{"type", "lodestone-project"},
                     {"version", kVersion},
                     {"sources", keptPaths(state.sources, folder)},
                     {"barriers", keptPaths(state.barriers, folder)},
                     {"options",
                      {{"import", toJson(values(state.importOptions))},
                       {"cluster", toJson(values(state.clusterOptions))},
                       {"merge", toJson(values(state.mergeOptions))},
                       {"chain", toJson(values(state.chainOptions))},
                       {"simplify", toJson(values(state.simplifyOptions))},
                       {"compare", toJson(values(state.comparedOptions))},
                       {"perceive", toJson(values(state.perceiveOptions))},
                       {"sight", toJson(values(state.sight))}}},
                     {"drawn", cutChoiceJson(state.cutChoice)},
                     {"camera", cameraJson(state.camera)},
                     {"looks", state.looks},
                     {"layout", layout}};
  try {
    writeFile(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
  } catch (const std::system_error& error) {
    return diagnose(Code::OutputUnwritable, error.what());
  }
  return true;
}

Result<LoadedProject> loadProject(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return diagnose(Code::FileNotFound, path.string());
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || json.value("type", Json()) != "lodestone-project") {
    return diagnose(Code::ProjectBad, path.string());
  }
  try {
    if (json.at("version").get<int>() > kVersion) {
      return diagnose(Code::ProjectBad, path.string() + " has version " + json.at("version").dump());
    }
    Diagnostics diagnostics;
    LoadedProject project = projectFrom(json, fs::absolute(path).parent_path(), diagnostics);
    return {std::move(project), std::move(diagnostics)};
  } catch (const nlohmann::json::exception& error) {
    return diagnose(Code::ProjectBad, path.string() + ": " + error.what());
  }
}

}  // namespace lodestone
