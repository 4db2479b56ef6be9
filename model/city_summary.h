// What a city model holds, in counts: for `info`, the import preview and the layer panel.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "model/city_model.h"

namespace lodestone {

struct CitySummary {
  std::size_t buildings = 0;
  std::size_t parts = 0;  ///< building parts
  std::size_t withFootprint = 0;
  std::map<std::string, std::size_t> objects;  ///< all city objects by type
  std::map<std::string, std::size_t> lods;     ///< geometries by LoD; "" where none is given
  std::map<std::string, std::size_t> heights;  ///< buildings by where their height is from
  std::size_t surfaces = 0;
  std::size_t triangles = 0;   ///< of all surfaces, when triangulated: vertices − 2 + 2 · holes each
  std::size_t components = 0;  ///< connected by shared vertex positions within one geometry
  std::size_t groundVertices = 0;
  std::size_t textures = 0;
  std::size_t texturesMissing = 0;
  std::size_t materials = 0;
  std::size_t texturedSurfaces = 0;
  std::map<std::string, std::size_t> attributes;  ///< by name: buildings that have it
  Box3 extent;                                    ///< local metres
};

/// Cost: one pass over all vertices.
[[nodiscard]] CitySummary summarise(const CityModel& model);

/// Sets of surfaces connected by shared vertex positions.
[[nodiscard]] std::size_t componentCount(const Geometry& geometry);

}  // namespace lodestone
