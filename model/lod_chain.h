// A chain of levels of detail, as writers and viewers take it.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "model/city_model.h"
#include "model/cluster_tree.h"
#include "model/options.h"

namespace lodestone {

/// One object of a level, made when asked for: a building, or a cluster that stands for several.
struct LevelObject {
  std::string id;  ///< a building's own id, or "cluster-<node>"
  DrawRole role = DrawRole::Building;
  NodeId node = kNoNode;                 ///< in the cluster tree, if there is one
  NodeId of = kNoNode;                   ///< cluster that a landmark stands in
  std::vector<std::uint32_t> buildings;  ///< indices into CityModel::buildings, ascending
  double base = 0;
  double height = 0;
  double negative = 0;     ///< square metres of negative space
  MultiPolygon footprint;  ///< plan outline: hull of a cluster, footprint of a building
  std::vector<Geometry>
      geometries;  ///< polygons; solids where closed. Empty only if the object has nothing to draw
  /// Triangles of geometries[g]: three indices into its vertices, and the surface they came from.
  /// Counter-clockwise from outside.
  struct Triangle {
    std::array<std::uint32_t, 3> vertices;
    std::uint32_t surface;
  };
  std::vector<std::vector<Triangle>> triangles;
};

struct LodLevel {
  std::string name;    ///< "original", "legible-10m"
  std::string method;  ///< "original", "legible"
  OptionValues options;
  double error = 0;           ///< greatest error against the original, metres; never falls along the chain
  double switchDistance = 0;  ///< metres from which this level takes over
  FaceCount faces;
  std::size_t objectCount = 0;
  /// Its objects are the buildings of LodChain::city as they stand there: a format that knows parts,
  /// installations and other objects writes those, and not what is drawn of them.
  bool isCity = false;
  /// Object i of the level, with polygons and triangles. Safe to call from several threads.
  std::function<LevelObject(std::size_t)> object;
};

/// Levels from fine to coarse; level 0 is the original.
struct LodChain {
  std::shared_ptr<const CityModel> city;
  std::shared_ptr<const ClusterTree> tree;  ///< may be null
  std::vector<LodLevel> levels;
  std::string recipe;  ///< JSON text that makes this chain again
};

}  // namespace lodestone
