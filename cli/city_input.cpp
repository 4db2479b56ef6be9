#include "cli/city_input.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "algorithms/clustering/clustering.h"
#include "algorithms/footprints/import.h"
#include "algorithms/geometry/components.h"
#include "algorithms/merging/merging.h"
#include "cli/flags.h"
#include "model/io/read_city.h"

namespace lodestone::cli {

void CityInput::addTo(CLI::App& app) {
  app.add_option("INPUT", paths, "Files to read; several make one model")->required();
  addFlags(app, options);
}

namespace {

using Paths = std::vector<std::filesystem::path>;

/// An input that is not there is found out before hours are spent on the others.
void requireAll(const Paths& files) {
  Diagnostics missing;
  for (const auto& file : files) {
    std::error_code error;
    if (!std::filesystem::exists(file, error)) missing.push_back(diagnose(Code::FileNotFound, file.string()));
  }
  if (!missing.empty()) throw Failure(std::move(missing));
}

/// The user named every input: a result without one of them would be taken for the whole. Inputs that were
/// read in part are there, and said.
bool isWhole(const Result<CityModel>& read) {
  return read.ok() && std::none_of(read.diagnostics.begin(), read.diagnostics.end(),
                                   [](const Diagnostic& d) { return d.code == Code::InputLeftOut; });
}

}  // namespace

std::shared_ptr<const CityModel> CityInput::load(Run& run) const {
  const Paths files(paths.begin(), paths.end());
  requireAll(files);
  Result<CityModel> read =
      run.stage("import", [&](const Progress& progress) { return importCity(files, options, progress); });
  if (!isWhole(read)) throw Failure(std::move(read.diagnostics));
  auto city = std::make_shared<const CityModel>(run.take(std::move(read)));
  nlohmann::ordered_json sources = nlohmann::ordered_json::array();
  for (const Source& source : city->sources) {
    sources.push_back({{"path", source.path}, {"format", source.format}, {"version", source.version}});
  }
  run.input = {{"sources", sources}, {"crs", city->crs.source}, {"buildings", city->buildings.size()}};
  return city;
}

Recipe CityInput::recipe(const LodChain& chain, std::vector<std::string> exports) const {
  Recipe recipe = recipeOf(chain, std::move(exports));
  recipe.sources = paths;  // the model names the members of an archive
  recipe.import = values(options);
  return recipe;
}

void TreeInput::addClusterTo(CLI::App& app) {
  addFlags(app, cluster);
  app.add_option("--barriers", barriers, "Layers of lines not to be crossed: streets, rails, rivers");
}

void TreeInput::addMergeTo(CLI::App& app) {
  addClusterTo(app);
  addFlags(app, merge);
}

std::shared_ptr<const Dendrogram> TreeInput::dendrogram(Run& run, const CityModel& city,
                                                        std::shared_ptr<const FootprintTable> table) const {
  std::vector<LineLayer> lines;
  for (const std::string& path : barriers) {
    lines.push_back(run.take(run.stage("barriers", [&](const Progress& progress) {
      return readLines(path, city, cluster.barrierLayer, progress);
    })));
  }
  const ClusterContext context = run.take(clusterContext(city, cluster, lines));
  auto result = std::make_shared<const Dendrogram>(run.stage("cluster", [&](const Progress& progress) {
    return makeDendrogram(*table, cluster, context, progress);
  }));
  run.figures["buildings"] = result->leafCount;
  run.figures["ground_vertices"] = table->vertices.size();
  run.figures["depth"] = result->depth;
  return result;
}

std::shared_ptr<const ClusterTree> TreeInput::build(Run& run, const CityModel& city) const {
  auto table = std::make_shared<const FootprintTable>(footprintTable(city));
  auto hierarchy = dendrogram(run, city, table);
  auto tree = std::make_shared<const ClusterTree>(run.stage(
      "merge", [&](const Progress& progress) { return makeClusterTree(table, hierarchy, merge, progress); }));
  run.figures["polygons"] = tree->buildingFaces.polygons;
  run.figures["triangles"] = tree->buildingFaces.triangles;
  return tree;
}

std::vector<std::string> buildingIds(const CityModel& city) {
  std::vector<std::string> ids;
  ids.reserve(city.buildings.size());
  for (const Building& building : city.buildings) ids.push_back(building.object.id);
  return ids;
}

ComponentMesh meshOf(Run& run, const CityModel& city) {
  std::vector<std::uint32_t> all(city.buildings.size());
  std::iota(all.begin(), all.end(), 0U);
  Diagnostics diagnostics;
  ComponentMesh mesh = makeComponentMesh(city, all, &diagnostics);
  run.add(std::move(diagnostics));
  return mesh;
}

void requireSurfaces(const ComponentMesh& mesh, const std::vector<std::string>& paths) {
  if (mesh.triangles.empty())
    throw Failure(diagnose(Code::ModelEmpty, fmt::format("{}", fmt::join(paths, ", "))));
}

}  // namespace lodestone::cli
