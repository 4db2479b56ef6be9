// Made-up cities: blocks, rows, towers, courtyards along streets. The same seed gives the same bytes
// everywhere.
#pragma once

#include "model/city_model.h"
#include "model/options.h"
#include "model/progress.h"

namespace lodestone {

enum class CityPreset { Town, Xinxiang, Charlotte, Grid400 };

struct SynthOptions {
  CityPreset preset = CityPreset::Town;
  int buildings = 0;  ///< 0: the preset's own number
  int seed = 1;
  bool operator==(const SynthOptions&) const = default;
};
template <>
const std::vector<Field<SynthOptions>>& fields<SynthOptions>();

/// Town: about 600 buildings with heights, use and year, streets as a line layer, towers, courtyards with
/// holes, and one LoD2 landmark (a church). Xinxiang and Charlotte: exactly the building and ground-vertex
/// counts of table 1 in Chang et al. 2008 (95,042 with 502,336 and two hole rings; 369,929 with 2,414,056 and
/// none) when `buildings` is 0. Grid400: addGridCity() of 400. \throw Cancelled
[[nodiscard]] CityModel synthesiseCity(const SynthOptions& options, const Progress& progress = {});

}  // namespace lodestone
