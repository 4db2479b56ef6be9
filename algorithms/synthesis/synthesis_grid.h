// The city of the study of proxy prisms (Polys et al. 2016): a square grid of plots.
#pragma once

#include "model/city_model.h"

namespace lodestone {

/// So many buildings of four kinds (house, terrace, office, hall), equally many of each, at random on a
/// square grid of plots of kGridPlot metres. Each has four levels: LoD 1.2 a block; 2.2 with its roof and
/// bays; 3.0 with windows and doors; 3.3 with frames, bars and sills. About eight times as many triangles
/// from each to the next.
inline constexpr double kGridPlot = 50;
void addGridCity(CityModel& model, int buildings, int seed);

}  // namespace lodestone
