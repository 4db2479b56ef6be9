// What several commands share: inputs to a model, and a model to a tree.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/run.h"
#include "model/cluster_tree.h"
#include "model/component_mesh.h"
#include "model/import_options.h"
#include "model/io/recipe.h"

namespace lodestone::cli {

/// INPUT… and the import options.
struct CityInput {
  std::vector<std::string> paths;
  ImportOptions options;

  void addTo(CLI::App& app);
  /// Imports, and writes the input and its counts into the report. \throw Failure also when one of several
  /// inputs cannot be read at all
  [[nodiscard]] std::shared_ptr<const CityModel> load(Run& run) const;
  /// What makes the chain again: these inputs, read with these options.
  [[nodiscard]] Recipe recipe(const LodChain& chain, std::vector<std::string> exports = {}) const;
};

/// The options of clustering and merging.
struct TreeInput {
  ClusterOptions cluster;
  MergeOptions merge;
  std::vector<std::string> barriers;

  void addClusterTo(CLI::App& app);
  void addMergeTo(CLI::App& app);
  [[nodiscard]] std::shared_ptr<const Dendrogram> dendrogram(
      Run& run, const CityModel& city, std::shared_ptr<const FootprintTable> table) const;
  /// Clusters and merges; figures go into the report. \throw Failure
  [[nodiscard]] std::shared_ptr<const ClusterTree> build(Run& run, const CityModel& city) const;
};

[[nodiscard]] std::vector<std::string> buildingIds(const CityModel& city);

/// All buildings as one model of components; what had to be left out is said.
[[nodiscard]] ComponentMesh meshOf(Run& run, const CityModel& city);

/// \throw Failure (618) where there is nothing to look at
void requireSurfaces(const ComponentMesh& mesh, const std::vector<std::string>& paths);

}  // namespace lodestone::cli
