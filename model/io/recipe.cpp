#include "model/io/recipe.h"

#include <system_error>

#include <fmt/format.h>

#include "model/io/input_file.h"
#include "model/io/json_options.h"
#include "model/io/kept_paths.h"

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kVersion = 1;

/// The texts of an array; anything else in it fails.
bool readTexts(const Json& recipe, const char* name, std::vector<std::string>& texts) {
  const auto found = recipe.find(name);
  if (found == recipe.end()) return true;
  if (!found->is_array()) return false;
  for (const Json& item : *found) {
    if (!item.is_string()) return false;
    texts.push_back(item.get<std::string>());
  }
  return true;
}

Diagnostic malformed(const std::string& why) {
  return diagnose(Code::FileMalformed, "recipe: " + why);
}

}  // namespace

Recipe recipeOf(const LodChain& chain, std::vector<std::string> exports) {
  Recipe recipe;
  if (chain.city) {
    for (const Source& source : chain.city->sources) recipe.sources.push_back(source.path);
  }
  for (const LodLevel& level : chain.levels) recipe.levels.push_back({level.method, level.options});
  recipe.exports = std::move(exports);
  return recipe;
}

std::string recipeText(const Recipe& recipe, const std::filesystem::path& folder) {
  const auto kept = [&](const std::vector<std::string>& paths) {
    return folder.empty() ? paths : keptPaths(paths, folder);
  };
  Json levels = Json::array();
  for (const RecipeLevel& level : recipe.levels) {
    levels.push_back({{"method", level.method}, {"options", toJson(level.options)}});
  }
  const Json json{{"type", "recipe"},
                  {"version", kVersion},
                  {"source", kept(recipe.sources)},
                  {"import", toJson(recipe.import)},
                  {"barriers", kept(recipe.barriers)},
                  {"levels", std::move(levels)},
                  {"exports", recipe.exports}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<Recipe> parseRecipe(std::string_view text, const std::filesystem::path& folder) {
  const Json json = Json::parse(text, nullptr, false);
  if (json.is_discarded()) return malformed("not JSON");
  if (!json.is_object() || json.value("type", Json()) != "recipe")
    return malformed("its type is not \"recipe\"");
  Result<Recipe> result{Recipe{}};
  if (json.value("version", Json()) != kVersion) {
    result.diagnostics.push_back(diagnose(Code::VersionUnsupported, "recipe"));
  }
  if (!readTexts(json, "source", result->sources)) return malformed("\"source\" is not a list of paths");
  if (!readTexts(json, "barriers", result->barriers)) return malformed("\"barriers\" is not a list of paths");
  result->import = optionValuesFrom(json.value("import", Json::object()), result.diagnostics);
  if (!readTexts(json, "exports", result->exports)) return malformed("\"exports\" is not a list of formats");
  const auto levels = json.find("levels");
  if (levels == json.end() || !levels->is_array()) return malformed("\"levels\" is not a list");
  for (const Json& level : *levels) {
    if (!level.is_object() || !level.value("method", Json()).is_string())
      return malformed("a level has no method");
    const Json options = level.value("options", Json::object());
    if (!options.is_object()) return malformed("a level's options are not an object");
    result->levels.push_back(
        {level["method"].get<std::string>(), optionValuesFrom(options, result.diagnostics)});
  }
  if (!folder.empty()) {
    result->sources = pathsFromKept(result->sources, folder);
    result->barriers = pathsFromKept(result->barriers, folder);
  }
  return result;
}

Result<Recipe> loadRecipe(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) return diagnose(Code::FileNotFound, path.string());
  try {
    return parseRecipe(readWholeFile(path), std::filesystem::absolute(path).parent_path());
  } catch (const std::system_error& error) {
    return diagnose(Code::FileUnreadable, error.what());
  }
}

}  // namespace lodestone
