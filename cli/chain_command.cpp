#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "algorithms/chains/chain_building.h"
#include "cli/city_input.h"
#include "cli/commands.h"
#include "cli/flags.h"
#include "cli/written_files.h"
#include "model/io/atomic_file.h"
#include "model/io/recipe.h"

namespace lodestone::cli {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  CityInput city;
  TreeInput tree;
  ChainOptions chain;
  std::string recipe;
  std::vector<std::string> formats;
  std::string output;
};

/// What a recipe says goes before what the flags say: it is the whole story of a chain.
void applyRecipe(Run& run, Arguments& args) {
  const Recipe recipe = run.take(loadRecipe(args.recipe));
  const ChainPlan plan = run.take(planOf(recipe));
  if (args.city.paths.empty()) args.city.paths = recipe.sources;
  run.add(setValues(args.city.options, recipe.import));
  if (args.tree.barriers.empty()) args.tree.barriers = recipe.barriers;
  args.tree.cluster = plan.cluster;
  args.tree.merge = plan.merge;
  args.chain = plan.chain;
  if (args.formats.empty()) args.formats = recipe.exports;
}

/// The name of an input without the endings of any format or archive.
std::string stemOf(const fs::path& path) {
  std::string name = path.filename().string();
  for (bool cut = true; cut;) {
    cut = false;
    const auto drop = [&](std::string_view ending) {
      if (name.size() <= ending.size() || !name.ends_with(ending)) return;
      name.resize(name.size() - ending.size());
      cut = true;
    };
    drop(".zip");
    drop(".gz");
    for (const Format& format : formats()) {
      for (const std::string_view ending : format.extensions) drop(ending);
    }
  }
  return name;
}

/// Writers that make several files, one a level, get a folder of their own.
fs::path placeOf(const Arguments& args, const Format& format) {
  const fs::path name = stemOf(args.city.paths.front()) + std::string(format.extensions.front());
  return format.fileALevel ? fs::path(args.output) / format.id / name : fs::path(args.output) / name;
}

/// A chain goes where there is nothing, or where a chain is: its files would mix with those of others.
void requireOwnFolder(const fs::path& folder) {
  std::error_code notThere;
  if (fs::is_empty(folder, notThere) || notThere || loadRecipe(folder / "recipe.json").ok()) return;
  throw Failure(
      diagnose(Code::OutputExists, folder.string() + " holds something, and no chain's recipe.json"));
}

std::vector<const Format*> chosenFormats(const Arguments& args) {
  std::vector<const Format*> chosen;
  for (const std::string& id : args.formats) {
    const Format* format = formatById(id);
    if (!format || !format->write) throw Failure(diagnose(Code::OutputFormatUnknown, id));
    chosen.push_back(format);
  }
  return chosen;
}

/// Files of an earlier chain that the new one did not write over: they look as if they belonged to it.
void tellLeftOvers(Run& run, const fs::path& folder) {
  std::set<fs::path> written{(folder / "recipe.json").lexically_normal()};
  for (const auto& file : run.output["files"])
    written.insert(fs::path(file.get<std::string>()).lexically_normal());
  std::vector<std::string> names;
  std::error_code unreadable;
  for (const auto& entry : fs::recursive_directory_iterator(folder, unreadable)) {
    if (entry.is_regular_file() && !written.contains(entry.path().lexically_normal()))
      names.push_back(entry.path().lexically_relative(folder).generic_string());
  }
  if (names.empty()) return;
  std::sort(names.begin(), names.end());
  const std::string more = names.size() == 1 ? "" : fmt::format(" and {} more", names.size() - 1);
  run.add({diagnose(Code::OutputLeftOver, fmt::format("{}: {}{}", folder.string(), names.front(), more))});
}

nlohmann::ordered_json levelsJson(const LodChain& chain) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const LodLevel& level : chain.levels) {
    list.push_back({{"name", level.name},
                    {"objects", level.objectCount},
                    {"polygons", level.faces.polygons},
                    {"triangles", level.faces.triangles},
                    {"error", level.error},
                    {"switch_distance", level.switchDistance}});
  }
  return list;
}

void printLevels(const LodChain& chain) {
  fmt::print("{:<16} {:>9} {:>11} {:>7} {:>11} {:>9} {:>12}\n", "level", "objects", "polygons", "share",
             "triangles", "error m", "from metres");
  const FaceCount& all = chain.levels.front().faces;
  for (const LodLevel& level : chain.levels) {
    fmt::print("{:<16} {:>9} {:>11} {:>6.1f}% {:>11} {:>9.2f} {:>12.0f}\n", level.name, level.objectCount,
               level.faces.polygons, 100 * share(level.faces, all), level.faces.triangles, level.error,
               level.switchDistance);
  }
}

/// A recipe is the whole story of a chain but for its inputs and formats: an option beside it would be
/// ignored.
void refuseWhatTheRecipeSays(const CLI::App& command) {
  static const std::set<std::string> beside{"INPUT", "--recipe", "--formats", "--output", "--barriers"};
  for (const CLI::Option* option : command.get_options()) {
    const std::string name = option->get_name();
    if (option->count() > 0 && !beside.contains(name))
      throw CLI::ValidationError(name, "the recipe says it: change it there, or leave --recipe out");
  }
}

void makeAndWrite(Run& run, Arguments args) {
  if (!args.recipe.empty()) applyRecipe(run, args);
  if (args.formats.empty()) args.formats = {"cityjson", "glb", "gpkg"};
  const std::vector<const Format*> formats = chosenFormats(args);
  if (auto why = whyNoTolerances(args.chain)) throw Failure(std::move(*why));
  requireOwnFolder(args.output);
  const auto city = args.city.load(run);
  const auto tree = args.tree.build(run, *city);
  LodChain chain = run.take(run.stage(
      "chain", [&](const Progress& progress) { return makeChain(city, tree, args.chain, progress); }));
  Recipe recipe = args.city.recipe(chain, args.formats);
  recipe.barriers = args.tree.barriers;
  chain.recipe = recipeText(recipe, args.output);
  run.figures["levels"] = levelsJson(chain);
  for (const Format* format : formats) {
    writeChain(run, chain, *format, placeOf(args, *format));
    // As soon as there is anything: an interrupted chain is known for one, and can be made again in its
    // place.
    if (format == formats.front()) writeFile(fs::path(args.output) / "recipe.json", chain.recipe);
  }
  tellLeftOvers(run, args.output);
  if (!run.options().quiet) printLevels(chain);
}

}  // namespace

void addChain(CLI::App& app, Chosen& chosen) {
  auto args = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("chain", "The LOD chain, in every format asked for");
  args->city.addTo(*command);
  args->tree.addMergeTo(*command);
  addFlags(*command, args->chain);
  command->add_option("--recipe", args->recipe, "Make the chain that this recipe describes");
  command
      ->add_option("--formats", args->formats,
                   "Comma list of formats; see info --formats (default cityjson,glb,gpkg)")
      ->delimiter(',');
  command->add_option("-o,--output", args->output, "Folder for the chain and its recipe")->required();
  command->get_option("INPUT")->required(false);
  command->callback([args, command, &chosen] {
    if (args->city.paths.empty() && args->recipe.empty()) throw CLI::RequiredError("INPUT");
    if (!args->recipe.empty()) refuseWhatTheRecipeSays(*command);
    chosen = {"chain", [args](Run& run) { makeAndWrite(run, *args); }};
  });
}

}  // namespace lodestone::cli
