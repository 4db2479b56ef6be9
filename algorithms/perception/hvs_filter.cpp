#include "algorithms/perception/hvs_filter.h"

#include "algorithms/perception/contrast_sensitivity.h"
#include "algorithms/perception/wavelet.h"

namespace lodestone {
namespace {

double weightOf(int level, bool diagonal, const PerceiveOptions& options) {
  return bandWeight(level, diagonal, options.pixelsPerDegree(), options.csf);
}

/// The coarsest level of which anything is filtered: its diagonal band is the finest.
int filteredLevels(const PerceiveOptions& options) {
  int levels = kWaveletLevels;
  while (levels > 0 && weightOf(levels, true, options) == 1) --levels;
  return levels;
}

void weigh(GreyImage& coefficients, const WaveletBand& band, float weight) {
  for (int y = band.y; y < band.y + band.height; ++y) {
    float* row = coefficients.pixels.data() +
                 static_cast<std::size_t>(y) * static_cast<std::size_t>(coefficients.width);
    for (int x = band.x; x < band.x + band.width; ++x) row[x] *= weight;
  }
}

}  // namespace

GreyImage filterAsSeen(const GreyImage& image, const PerceiveOptions& options) {
  GreyImage seen = image;
  // Dividing bands that stay as they are would add rounding alone.
  const int levels = filteredLevels(options);
  forwardWavelet(seen.pixels, seen.width, seen.height, levels);
  for (const WaveletBand& band : waveletBands(seen.width, seen.height, levels)) {
    if (band.kind == WaveletBand::Kind::LL) continue;
    const double weight = weightOf(band.level, band.kind == WaveletBand::Kind::HH, options);
    weigh(seen, band, static_cast<float>(weight));
  }
  inverseWavelet(seen.pixels, seen.width, seen.height, levels);
  return seen;
}

}  // namespace lodestone
