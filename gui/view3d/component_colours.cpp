#include "gui/view3d/component_colours.h"

#include <algorithm>
#include <cmath>

namespace lodestone {
namespace {

// Lightness grows evenly along the scale, so that it reads without hue too.
constexpr std::array<Rgb, 5> kAngles{{{0.13F, 0.05F, 0.53F},
                                      {0.46F, 0.03F, 0.64F},
                                      {0.73F, 0.20F, 0.53F},
                                      {0.91F, 0.42F, 0.36F},
                                      {0.99F, 0.70F, 0.20F}}};

/// The hue that fewest components have, of those that no coloured neighbour has.
std::size_t freeHue(const std::array<bool, kHueCount>& taken,
                    const std::array<std::size_t, kHueCount>& uses) {
  std::size_t best = kHueCount;
  for (std::size_t hue = 0; hue < kHueCount; ++hue) {
    if (!taken[hue] && (best == kHueCount || uses[hue] < uses[best])) best = hue;
  }
  if (best < kHueCount) return best;
  return static_cast<std::size_t>(std::min_element(uses.begin(), uses.end()) - uses.begin());
}

}  // namespace

std::vector<Rgb> componentColours(std::size_t count,
                                  std::span<const std::pair<std::uint32_t, std::uint32_t>> contacts) {
  std::vector<std::vector<std::uint32_t>> neighbours(count);
  for (const auto& [a, b] : contacts) {
    neighbours[a].push_back(b);
    neighbours[b].push_back(a);
  }
  std::vector<std::size_t> hues(count, kHueCount);
  std::array<std::size_t, kHueCount> uses{};
  std::vector<Rgb> colours(count);
  for (std::size_t c = 0; c < count; ++c) {
    std::array<bool, kHueCount> taken{};
    for (const std::uint32_t other : neighbours[c]) {
      if (hues[other] < kHueCount) taken[hues[other]] = true;
    }
    hues[c] = freeHue(taken, uses);
    ++uses[hues[c]];
    colours[c] = hueOf(hues[c]);
  }
  return colours;
}

Rgb angleColour(double degrees) {
  const double at = std::clamp(degrees / 90, 0.0, 1.0) * (kAngles.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kAngles.size() - 2);
  const auto share = static_cast<float>(at - static_cast<double>(low));
  Rgb colour{};
  for (std::size_t i = 0; i < 3; ++i) colour[i] = std::lerp(kAngles[low][i], kAngles[low + 1][i], share);
  return colour;
}

Rgb classColour(VertexClass vertexClass) {
  if (vertexClass == VertexClass::Boundary) return {0.84F, 0.37F, 0.0F};
  if (vertexClass == VertexClass::Hole) return {0.0F, 0.35F, 0.70F};
  return {0.36F, 0.40F, 0.44F};
}

Rgb fateColour(ContactFate fate) {
  if (fate == ContactFate::Separated) return {0.90F, 0.62F, 0.0F};
  if (fate == ContactFate::Lost) return {0.80F, 0.10F, 0.35F};
  return {0.0F, 0.62F, 0.45F};
}

}  // namespace lodestone
