#include "algorithms/perception/wavelet.h"

#include <algorithm>

#include "algorithms/geometry/vector_clones.h"

namespace lodestone {
namespace {

// The lifting steps and the scale (ITU-T T.800, table F.4).
constexpr float kAlpha = -1.586134342059924F;
constexpr float kBeta = -0.052980118572961F;
constexpr float kGamma = 0.882911075530934F;
constexpr float kDelta = 0.443506852043971F;
constexpr float kScale = 1.230174104914001F;

// Columns that are lifted together: whole cache lines, and a strip of 2048 rows fits the second cache.
constexpr std::size_t kStrip = 64;

struct Size {
  std::size_t width = 0;
  std::size_t height = 0;
};

std::size_t lowHalf(std::size_t length) {
  return (length + 1) / 2;
}

/// What each level divides, the whole picture first.
std::vector<Size> dividedSizes(int width, int height, int levels) {
  std::vector<Size> sizes;
  Size size{static_cast<std::size_t>(width), static_cast<std::size_t>(height)};
  if (width < 1 || height < 1) return sizes;
  for (int level = 0; level < levels && (size.width > 1 || size.height > 1); ++level) {
    sizes.push_back(size);
    size = {lowHalf(size.width), lowHalf(size.height)};
  }
  return sizes;
}

// The sums do not depend on how many are made at once.
LODESTONE_VECTOR_CLONES
void addSums(float* to, const float* a, const float* b, std::size_t count, float factor) {
  for (std::size_t i = 0; i < count; ++i) to[i] += factor * (a[i] + b[i]);
}

LODESTONE_VECTOR_CLONES
void copyScaled(float* to, const float* from, std::size_t count, float factor) {
  for (std::size_t i = 0; i < count; ++i) to[i] = factor * from[i];
}

LODESTONE_VECTOR_CLONES
void splitPairs(float* evens, float* odds, const float* from, std::size_t pairs) {
  for (std::size_t i = 0; i < pairs; ++i) {
    evens[i] = from[2 * i];
    odds[i] = from[2 * i + 1];
  }
}

LODESTONE_VECTOR_CLONES
void joinPairs(float* to, const float* evens, const float* odds, std::size_t pairs) {
  for (std::size_t i = 0; i < pairs; ++i) {
    to[2 * i] = evens[i];
    to[2 * i + 1] = odds[i];
  }
}

/// Some lines that are lifted together. Their first samples lie side by side, then their third ones and so
/// on; behind all of these the second ones, the fourth ones … So each step of the lifting is one loop over
/// neighbours in memory, be it over one row or over many columns. \pre length > 1
class Lines {
 public:
  Lines(std::vector<float>& samples, std::size_t length, std::size_t lines)
      : lines_(lines),
        evens_(lowHalf(length)),
        odds_(length / 2),
        even_(samples.data()),
        odd_(even_ + evens_ * lines) {}

  float* evens() { return even_; }
  float* odds() { return odd_; }
  [[nodiscard]] float* sample(std::size_t i) { return (i % 2 == 0 ? even_ : odd_) + i / 2 * lines_; }

  void lift() {
    addToOdds(kAlpha);
    addToEvens(kBeta);
    addToOdds(kGamma);
    addToEvens(kDelta);
  }

  void unlift() {
    addToEvens(-kDelta);
    addToOdds(-kGamma);
    addToEvens(-kBeta);
    addToOdds(-kAlpha);
  }

 private:
  /// The sample behind the last odd one mirrors the one before it.
  void addToOdds(float factor) {
    const std::size_t inner = (evens_ - 1) * lines_;
    addSums(odd_, even_, even_ + lines_, inner, factor);
    if (odds_ == evens_) addSums(odd_ + inner, even_ + inner, even_ + inner, lines_, factor);
  }

  void addToEvens(float factor) {
    const std::size_t inner = (odds_ - 1) * lines_;
    addSums(even_, odd_, odd_, lines_, factor);
    addSums(even_ + lines_, odd_, odd_ + lines_, inner, factor);
    if (evens_ > odds_) addSums(even_ + inner + lines_, odd_ + inner, odd_ + inner, lines_, factor);
  }

  std::size_t lines_, evens_, odds_;
  float* even_;
  float* odd_;
};

/// One picture and the memory that its rows and columns are lifted in.
class Lifting {
 public:
  Lifting(std::span<float> pixels, int width, int height)
      : pixels_(pixels.data()),
        stride_(static_cast<std::size_t>(width)),
        samples_(std::max(stride_, static_cast<std::size_t>(height) * std::min(kStrip, stride_))) {}

  void forwardRows(const Size& size) {
    if (size.width < 2) return;
    const std::size_t low = lowHalf(size.width);
    Lines line(samples_, size.width, 1);
    for (std::size_t y = 0; y < size.height; ++y) {
      float* row = pixels_ + y * stride_;
      splitPairs(line.evens(), line.odds(), row, size.width / 2);
      if (size.width % 2 == 1) line.evens()[low - 1] = row[size.width - 1];
      line.lift();
      copyScaled(row, line.evens(), low, 1 / kScale);
      copyScaled(row + low, line.odds(), size.width - low, kScale);
    }
  }

  void inverseRows(const Size& size) {
    if (size.width < 2) return;
    const std::size_t low = lowHalf(size.width);
    Lines line(samples_, size.width, 1);
    for (std::size_t y = 0; y < size.height; ++y) {
      float* row = pixels_ + y * stride_;
      copyScaled(line.evens(), row, low, kScale);
      copyScaled(line.odds(), row + low, size.width - low, 1 / kScale);
      line.unlift();
      joinPairs(row, line.evens(), line.odds(), size.width / 2);
      if (size.width % 2 == 1) row[size.width - 1] = line.evens()[low - 1];
    }
  }

  void forwardColumns(const Size& size) {
    if (size.height < 2) return;
    const std::size_t low = lowHalf(size.height);
    for (std::size_t x = 0; x < size.width; x += kStrip) {
      const std::size_t columns = std::min(kStrip, size.width - x);
      Lines lines(samples_, size.height, columns);
      for (std::size_t y = 0; y < size.height; ++y)
        std::copy_n(pixels_ + y * stride_ + x, columns, lines.sample(y));
      lines.lift();
      for (std::size_t y = 0; y < size.height; ++y)
        copyScaled(pixels_ + y * stride_ + x, lines.evens() + y * columns, columns,
                   y < low ? 1 / kScale : kScale);
    }
  }

  void inverseColumns(const Size& size) {
    if (size.height < 2) return;
    const std::size_t low = lowHalf(size.height);
    for (std::size_t x = 0; x < size.width; x += kStrip) {
      const std::size_t columns = std::min(kStrip, size.width - x);
      Lines lines(samples_, size.height, columns);
      for (std::size_t y = 0; y < size.height; ++y)
        copyScaled(lines.evens() + y * columns, pixels_ + y * stride_ + x, columns,
                   y < low ? kScale : 1 / kScale);
      lines.unlift();
      for (std::size_t y = 0; y < size.height; ++y)
        std::copy_n(lines.sample(y), columns, pixels_ + y * stride_ + x);
    }
  }

 private:
  float* pixels_;
  std::size_t stride_;
  std::vector<float> samples_;
};

}  // namespace

std::vector<WaveletBand> waveletBands(int width, int height, int levels) {
  using Kind = WaveletBand::Kind;
  std::vector<WaveletBand> bands;
  if (width < 1 || height < 1) return bands;
  const auto add = [&](const WaveletBand& band) {
    if (band.width > 0 && band.height > 0) bands.push_back(band);
  };
  WaveletBand rest{0, Kind::LL, 0, 0, width, height};
  for (const Size& size : dividedSizes(width, height, levels)) {
    const int level = rest.level + 1;
    const int lowWidth = static_cast<int>(lowHalf(size.width));
    const int lowHeight = static_cast<int>(lowHalf(size.height));
    add({level, Kind::HL, lowWidth, 0, rest.width - lowWidth, lowHeight});
    add({level, Kind::LH, 0, lowHeight, lowWidth, rest.height - lowHeight});
    add({level, Kind::HH, lowWidth, lowHeight, rest.width - lowWidth, rest.height - lowHeight});
    rest = {level, Kind::LL, 0, 0, lowWidth, lowHeight};
  }
  add(rest);
  return bands;
}

void forwardWavelet(std::span<float> pixels, int width, int height, int levels) {
  Lifting lifting(pixels, width, height);
  for (const Size& size : dividedSizes(width, height, levels)) {
    lifting.forwardRows(size);
    lifting.forwardColumns(size);
  }
}

void inverseWavelet(std::span<float> pixels, int width, int height, int levels) {
  Lifting lifting(pixels, width, height);
  std::vector<Size> sizes = dividedSizes(width, height, levels);
  std::reverse(sizes.begin(), sizes.end());
  for (const Size& size : sizes) {
    lifting.inverseColumns(size);
    lifting.inverseRows(size);
  }
}

}  // namespace lodestone
