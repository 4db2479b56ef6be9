#include "algorithms/chains/chain_building.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "algorithms/geometry/meshing.h"
#include "algorithms/merging/cutting.h"
#include "model/exterior.h"

namespace lodestone {

namespace {

/// What the objects of a level are made from; shared by all its levels.
struct ChainSource {
  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;
};

void triangulateAll(LevelObject& object) {
  object.triangles.reserve(object.geometries.size());
  for (const Geometry& geometry : object.geometries) object.triangles.push_back(triangulate(geometry));
}

LevelObject buildingObject(const CityModel& city, std::uint32_t index) {
  const Building& building = city.buildings[index];
  LevelObject object;
  object.id = building.object.id;
  object.buildings = {index};
  object.base = building.base;
  object.height = building.height;
  object.footprint = building.footprint;
  object.geometries = exteriorGeometry(building.object);
  if (object.geometries.empty() && !building.footprint.empty() && building.height > 0) {
    object.geometries.push_back(makeBlock(building.footprint, building.base, building.height));
  }
  triangulateAll(object);
  return object;
}

/// Calls `visit(leaf)` for every building below a node.
template <class Visit>
void forEachLeaf(const ClusterTree& tree, NodeId node, Visit&& visit) {
  std::vector<NodeId> open{node};
  while (!open.empty()) {
    const NodeId at = open.back();
    open.pop_back();
    if (tree.isLeaf(at)) {
      visit(at);
      continue;
    }
    open.push_back(tree.nodes[at].b);
    open.push_back(tree.nodes[at].a);
  }
}

LevelObject clusterObject(const ClusterTree& tree, NodeId id) {
  const ClusterNode& node = tree.nodes[id];
  LevelObject object;
  object.id = fmt::format("cluster-{}", id);
  object.buildings.reserve(node.size);
  forEachLeaf(tree, id, [&](NodeId leaf) { object.buildings.push_back(leaf); });
  std::sort(object.buildings.begin(), object.buildings.end());
  object.base = node.base;
  object.height = node.height;
  object.negative = node.negative;
  const auto hull = tree.hull(id);
  if (hull.size() >= 3) {
    object.footprint.push_back({Ring(hull.begin(), hull.end()), {}});
    if (node.height > 0) object.geometries.push_back(makeBlock(object.footprint, node.base, node.height));
  }
  triangulateAll(object);
  return object;
}

LevelObject drawnObject(const ChainSource& source, const DrawnNode& drawn) {
  LevelObject object = drawn.role == DrawRole::Cluster ? clusterObject(*source.tree, drawn.node)
                                                       : buildingObject(*source.city, drawn.node);
  object.role = drawn.role;
  object.node = drawn.node;
  object.of = drawn.of;
  return object;
}

LodLevel originalLevel(std::shared_ptr<const ChainSource> source) {
  LodLevel level;
  level.name = "original";
  level.method = "original";
  level.isCity = true;
  level.objectCount = source->city->buildings.size();
  for (const Building& building : source->city->buildings) level.faces += facesOf(building);
  level.object = [source = std::move(source)](std::size_t i) {
    LevelObject object = buildingObject(*source->city, static_cast<std::uint32_t>(i));
    if (source->tree) object.node = static_cast<NodeId>(i);
    return object;
  };
  return level;
}

/// Greatest error of what is drawn against the buildings that it stands for, metres; see makeChain().
double errorOf(const ClusterTree& tree, const Cut& cut) {
  std::vector<bool> shown(tree.footprints->buildingCount(), false);
  for (const DrawnNode& drawn : cut.drawn) {
    if (drawn.role == DrawRole::Landmark) shown[drawn.node] = true;
  }
  double error = 0;
  for (const DrawnNode& drawn : cut.drawn) {
    if (drawn.role != DrawRole::Cluster) continue;
    const ClusterNode& node = tree.nodes[drawn.node];
    error = std::max(error, emptiness(node));
    forEachLeaf(tree, drawn.node, [&](NodeId leaf) {
      if (shown[leaf]) return;
      const ClusterNode& building = tree.nodes[leaf];
      error = std::max(error, std::abs(building.base + building.height - node.base - node.height));
    });
  }
  return error;
}

LodLevel cutLevel(std::shared_ptr<const ChainSource> source, Cut cut) {
  LodLevel level;
  level.method = "legible";
  level.objectCount = cut.drawn.size();
  level.faces = cut.faces;
  level.error = errorOf(*source->tree, cut);
  auto shared = std::make_shared<const std::vector<DrawnNode>>(std::move(cut.drawn));
  level.object = [source = std::move(source), drawn = std::move(shared)](std::size_t i) {
    return drawnObject(*source, (*drawn)[i]);
  };
  return level;
}

OptionValues legibleOptions(const ClusterTree& tree, const ChainOptions& options, double tolerance) {
  OptionValues result{{"tolerance", tolerance}};
  const auto add = [&result](OptionValues more) { result.insert(result.end(), more.begin(), more.end()); };
  for (auto& value : values(options)) {
    if (value.first != "tolerances") result.push_back(std::move(value));
  }
  add(values(tree.dendrogram->options));
  add(values(tree.options));
  return result;
}

/// The rising numbers of "5,10,20"; nothing, and a diagnostic, where they are not.
std::vector<double> parseTolerances(const std::string& text, Diagnostics& diagnostics) {
  std::vector<double> result;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(',', begin), text.size());
    const std::optional<double> value = parseNumber(text.substr(begin, end - begin));
    if (!value || *value <= (result.empty() ? 0 : result.back())) {
      diagnostics.push_back(diagnose(
          Code::OptionBadValue,
          fmt::format("tolerances: \"{}\", wanted rising numbers above 0 with commas between", text)));
      return {};
    }
    result.push_back(*value);
    begin = end + 1;
  }
  return result;
}

/// The struct among `targets` that has an option of this name takes it.
template <class... Options>
bool applyTo(const std::pair<std::string, FieldValue>& value, Diagnostics& diagnostics, Options&... targets) {
  const auto tryOne = [&](auto& target) {
    using O = std::remove_reference_t<decltype(target)>;
    const auto& table = fields<O>();
    if (std::none_of(table.begin(), table.end(), [&](const auto& f) { return f.name == value.first; }))
      return false;
    Diagnostics said = setValues(target, {value});
    diagnostics.insert(diagnostics.end(), said.begin(), said.end());
    return true;
  };
  return (tryOne(targets) || ...);
}

}  // namespace

std::optional<Diagnostic> whyNoTolerances(const ChainOptions& options) {
  Diagnostics diagnostics;
  (void)parseTolerances(options.tolerances, diagnostics);
  return diagnostics.empty() ? std::nullopt : std::optional(diagnostics.front());
}

Result<LodChain> makeChain(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree,
                           const ChainOptions& options, const Progress& progress, const ArtifactSink& sink) {
  Diagnostics diagnostics = check(options);
  const std::vector<double> tolerances = parseTolerances(options.tolerances, diagnostics);
  if (hasErrors(diagnostics)) return Result<LodChain>::failure(std::move(diagnostics));

  const auto source = std::make_shared<const ChainSource>(ChainSource{city, tree});
  LodChain chain{city, tree, {}, {}};
  chain.levels.push_back(originalLevel(source));

  if (tree && !tree->nodes.empty()) {
    for (std::size_t i = 0; i < tolerances.size(); ++i) {
      const double tolerance = tolerances[i];
      LodLevel level = cutLevel(source, makeUniformCut(*tree, options.cut, tolerance));
      level.name = fmt::format("legible-{}m", tolerance);
      level.options = legibleOptions(*tree, options, tolerance);
      level.error = std::max(level.error, chain.levels.back().error);
      level.switchDistance =
          switchDistance(tolerance, options.cut.epsilon, options.fov, options.pictureHeight);
      if (const LodLevel& finer = chain.levels.back(); level.faces.polygons >= finer.faces.polygons) {
        diagnostics.push_back(diagnose(
            Code::LevelNotLighter,
            fmt::format("{}: {:.1f}% of {}", level.name, 100 * share(level.faces, finer.faces), finer.name)));
      }
      chain.levels.push_back(std::move(level));
      progress.checkpoint();
      progress.report(static_cast<double>(i + 1) / static_cast<double>(tolerances.size()));
    }
  }
  chain.recipe = recipeText(recipeOf(chain));
  tell(sink, "chain", &chain);
  return {std::move(chain), std::move(diagnostics)};
}

LodChain simplifiedChain(std::shared_ptr<const CityModel> city, const SimplifyOptions& options, double error,
                         const PerceiveOptions& perceive) {
  LodChain chain;
  chain.city = city;
  LodLevel level = originalLevel(std::make_shared<const ChainSource>(ChainSource{std::move(city), nullptr}));
  level.options = values(options);
  if (needsPerception(options.method)) {
    for (auto& [name, value] : values(perceive)) level.options.emplace_back(name, value);
  }
  level.method = toText(fields<SimplifyOptions>().front().get(options));
  level.name = fmt::format("{}-{:.3g}", level.method, 100 * options.rate);
  level.error = error;
  chain.levels.push_back(std::move(level));
  return chain;
}

LodLevel levelOfCut(std::shared_ptr<const CityModel> city, std::shared_ptr<const ClusterTree> tree,
                    const Cut& cut) {
  const auto source = std::make_shared<const ChainSource>(ChainSource{std::move(city), std::move(tree)});
  LodLevel level = cutLevel(source, cut);
  level.name = "cut";
  level.options = values(cut.options);
  return level;
}

Result<ChainPlan> planOf(const Recipe& recipe) {
  Result<ChainPlan> result{ChainPlan{}};
  std::string tolerances;
  for (const RecipeLevel& level : recipe.levels) {
    if (level.method == "original") continue;
    if (level.method != "legible") {
      result.diagnostics.push_back(
          diagnose(Code::OptionBadValue, fmt::format("method \"{}\"", level.method)));
      continue;
    }
    for (const auto& option : level.options) {
      if (option.first == "tolerance") {
        tolerances += (tolerances.empty() ? "" : ",") + toText(option.second);
      } else if (!applyTo(option, result.diagnostics, result->chain, result->cluster, result->merge)) {
        result.diagnostics.push_back(diagnose(Code::OptionUnknown, option.first));
      }
    }
  }
  result->chain.tolerances = tolerances;
  if (auto why = whyNoTolerances(result->chain)) result.diagnostics.push_back(std::move(*why));
  if (hasErrors(result.diagnostics)) result.value.reset();
  return result;
}

}  // namespace lodestone
