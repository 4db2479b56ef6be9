// The wavelet transform CDF 9/7 as its filters define it, in double precision: every coefficient is the sum
// of nine or seven samples.
#pragma once

#include <cstddef>
#include <vector>

namespace lodestone {

struct PlainPicture {
  std::size_t width = 0;
  std::size_t height = 0;
  std::vector<double> pixels;
};

/// The filters on either side of their middle (ITU-T T.800, table F.2 and its like).
inline constexpr double kPlainLow[] = {0.6029490182363579, 0.2668641184428723, -0.07822326652898785,
                                       -0.01686411844287495, 0.02674875741080976};
inline constexpr double kPlainHigh[] = {1.115087052456994, -0.5912717631142470, -0.05754352622849957,
                                        0.09127176311424948, 0};

inline std::size_t mirrored(std::ptrdiff_t i, std::size_t length) {
  const auto last = static_cast<std::ptrdiff_t>(length) - 1;
  while (i < 0 || i > last) i = i < 0 ? -i : 2 * last - i;
  return static_cast<std::size_t>(i);
}

/// Where sample i of a line stands once low frequencies come first.
inline std::size_t mallatPlace(std::size_t i, std::size_t length) {
  return i % 2 == 0 ? i / 2 : (length + 1) / 2 + i / 2;
}

inline std::vector<double> plainForward(const std::vector<double>& line) {
  if (line.size() < 2) return line;
  std::vector<double> coefficients(line.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    double sum = 0;
    for (std::ptrdiff_t k = -4; k <= 4; ++k)
      sum += (i % 2 == 0 ? kPlainLow : kPlainHigh)[k < 0 ? -k : k] *
             line[mirrored(static_cast<std::ptrdiff_t>(i) + k, line.size())];
    coefficients[mallatPlace(i, line.size())] = sum;
  }
  return coefficients;
}

/// The filters of the synthesis are those of the analysis, low and high exchanged, every other sign turned.
inline std::vector<double> plainInverse(const std::vector<double>& coefficients) {
  if (coefficients.size() < 2) return coefficients;
  std::vector<double> line(coefficients.size());
  for (std::size_t i = 0; i < line.size(); ++i) {
    for (std::ptrdiff_t k = -4; k <= 4; ++k) {
      const std::size_t from = mirrored(static_cast<std::ptrdiff_t>(i) + k, line.size());
      line[i] += (from % 2 == 0 ? kPlainHigh : kPlainLow)[k < 0 ? -k : k] * (k % 2 == 0 ? 1 : -1) *
                 coefficients[mallatPlace(from, line.size())];
    }
  }
  return line;
}

/// Replaces the line of `length` pixels from `first` on, `step` apart.
template <class Filter>
void filterLine(PlainPicture& picture, std::size_t first, std::size_t step, std::size_t length,
                const Filter& filter) {
  std::vector<double> line(length);
  for (std::size_t i = 0; i < length; ++i) line[i] = picture.pixels[first + i * step];
  line = filter(line);
  for (std::size_t i = 0; i < length; ++i) picture.pixels[first + i * step] = line[i];
}

/// A side of one pixel stays, a picture of one pixel does.
inline void plainTransform(PlainPicture& picture, int levels, bool inverse) {
  const auto filter = inverse ? plainInverse : plainForward;
  for (int i = 0; i < levels; ++i) {
    std::size_t width = picture.width;
    std::size_t height = picture.height;
    for (int level = inverse ? levels - 1 - i : i; level > 0; --level) {
      width = (width + 1) / 2;
      height = (height + 1) / 2;
    }
    for (std::size_t y = 0; y < height; ++y) filterLine(picture, y * picture.width, 1, width, filter);
    for (std::size_t x = 0; x < width; ++x) filterLine(picture, x, picture.width, height, filter);
  }
}

}  // namespace lodestone
