#include "gui/view3d/palette.h"

namespace lodestone {
namespace {

// Hues chosen so that any two differ in lightness or along the blue–yellow axis, which all common kinds of
// colour blindness leave intact.
constexpr std::array<Rgb, kHueCount> kClusterColours{{{0.38F, 0.58F, 0.80F},
                                                      {0.93F, 0.73F, 0.38F},
                                                      {0.40F, 0.70F, 0.64F},
                                                      {0.86F, 0.53F, 0.45F},
                                                      {0.66F, 0.64F, 0.86F},
                                                      {0.84F, 0.83F, 0.50F},
                                                      {0.30F, 0.47F, 0.60F},
                                                      {0.90F, 0.66F, 0.72F},
                                                      {0.55F, 0.80F, 0.88F},
                                                      {0.70F, 0.55F, 0.36F},
                                                      {0.62F, 0.78F, 0.52F},
                                                      {0.60F, 0.44F, 0.58F}}};

}  // namespace

const Palette& lightPalette() {
  static const Palette palette{
      .skyTop = {0.60F, 0.74F, 0.88F},
      .skyHorizon = {0.93F, 0.95F, 0.965F},
      .ground = {0.835F, 0.85F, 0.83F},
      .grid = {0.725F, 0.75F, 0.74F},
      .ink = {0.16F, 0.18F, 0.23F},
      .building = {0.96F, 0.92F, 0.85F},
      .cluster = {0.62F, 0.74F, 0.86F},
      .landmark = {0.95F, 0.66F, 0.28F},
      .context = {0.72F, 0.79F, 0.70F},
      .selection = {0.84F, 0.22F, 0.48F},
      .hover = {0.99F, 0.82F, 0.24F},
      .selectionLine = {0.52F, 0.05F, 0.27F},
      .hoverLine = {0.48F, 0.33F, 0.02F},
      .hullLine = {0.05F, 0.33F, 0.55F},
      .boxLine = {0.72F, 0.20F, 0.10F},
      .street = {0.52F, 0.54F, 0.58F},
      .rail = {0.34F, 0.30F, 0.30F},
      .water = {0.30F, 0.55F, 0.78F},
      .unseen = {0.80F, 0.80F, 0.79F},
      .seen = {0.13F, 0.47F, 0.78F},
      .appeared = {0.95F, 0.56F, 0.02F},
      .vanished = {0.55F, 0.16F, 0.50F},
      .sight = {0.05F, 0.42F, 0.62F},
  };
  return palette;
}

const Palette& darkPalette() {
  static const Palette palette{
      .skyTop = {0.055F, 0.070F, 0.095F},
      .skyHorizon = {0.165F, 0.190F, 0.225F},
      .ground = {0.125F, 0.138F, 0.155F},
      .grid = {0.225F, 0.245F, 0.270F},
      .ink = {0.02F, 0.025F, 0.035F},
      .building = {0.74F, 0.72F, 0.68F},
      .cluster = {0.40F, 0.53F, 0.66F},
      .landmark = {0.90F, 0.60F, 0.22F},
      .context = {0.38F, 0.46F, 0.38F},
      .selection = {0.92F, 0.32F, 0.58F},
      .hover = {0.99F, 0.82F, 0.30F},
      .selectionLine = {1.0F, 0.78F, 0.88F},
      .hoverLine = {1.0F, 0.95F, 0.70F},
      .hullLine = {0.45F, 0.75F, 0.95F},
      .boxLine = {0.98F, 0.50F, 0.36F},
      .street = {0.44F, 0.47F, 0.52F},
      .rail = {0.62F, 0.56F, 0.54F},
      .water = {0.26F, 0.48F, 0.72F},
      .unseen = {0.40F, 0.41F, 0.43F},
      .seen = {0.25F, 0.60F, 0.92F},
      .appeared = {0.98F, 0.66F, 0.16F},
      .vanished = {0.80F, 0.42F, 0.76F},
      .sight = {0.40F, 0.78F, 0.95F},
  };
  return palette;
}

Rgb hueOf(std::size_t i) {
  return kClusterColours[i];
}

Rgb clusterColour(NodeId node) {
  // Fibonacci hashing spreads numbers that follow each other over the table and over the shades.
  const std::uint32_t hash = node * 2654435769U;
  Rgb colour = kClusterColours[(hash >> 16U) % kClusterColours.size()];
  const float shade = 0.92F + 0.16F * static_cast<float>((hash >> 8U) & 255U) / 255.0F;
  for (float& channel : colour) channel = channel * shade < 1 ? channel * shade : 1;
  return colour;
}

}  // namespace lodestone
