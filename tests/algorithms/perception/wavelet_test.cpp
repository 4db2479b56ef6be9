#include "algorithms/perception/wavelet.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/plain_wavelet.h"

namespace lodestone {
namespace {

using Kind = WaveletBand::Kind;

constexpr int kLevels = 5;
constexpr double kRange = 255;

const std::pair<int, int> kSizes[] = {{1, 1},   {1, 2},   {2, 1},   {2, 2},   {1, 97},  {101, 1}, {3, 3},
                                      {2, 63},  {5, 4},   {7, 31},  {13, 17}, {32, 32}, {33, 65}, {64, 48},
                                      {31, 97}, {66, 33}, {127, 3}, {4, 130}, {96, 29}, {100, 75}};

std::vector<float> randomPixels(int width, int height, std::mt19937& random) {
  std::uniform_real_distribution<float> grey(0, static_cast<float>(kRange));
  std::vector<float> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (float& pixel : pixels) pixel = grey(random);
  return pixels;
}

double largestDifference(const std::vector<float>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

TEST(Wavelet, EqualsItsFilters) {
  std::mt19937 random(1);
  for (const auto& [width, height] : kSizes) {
    for (const int levels : {1, 2, kLevels}) {
      std::vector<float> pixels = randomPixels(width, height, random);
      PlainPicture plain{
          static_cast<std::size_t>(width), static_cast<std::size_t>(height), {pixels.begin(), pixels.end()}};
      forwardWavelet(pixels, width, height, levels);
      plainTransform(plain, levels, false);
      EXPECT_LT(largestDifference(pixels, plain.pixels), 3e-6 * kRange) << width << " x " << height;
      inverseWavelet(pixels, width, height, levels);
      plainTransform(plain, levels, true);
      EXPECT_LT(largestDifference(pixels, plain.pixels), 3e-6 * kRange) << width << " x " << height;
    }
  }
}

TEST(Wavelet, GivesThePictureBack) {
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    const int width = std::uniform_int_distribution(1, 150)(random);
    const int height = std::uniform_int_distribution(1, 150)(random);
    const int levels = std::uniform_int_distribution(0, 9)(random);
    const std::vector<float> pixels = randomPixels(width, height, random);
    std::vector<float> back = pixels;
    forwardWavelet(back, width, height, levels);
    inverseWavelet(back, width, height, levels);
    EXPECT_LT(largestDifference(back, {pixels.begin(), pixels.end()}), 3e-6 * kRange)
        << width << " x " << height << ", " << levels << " levels";
  }
}

TEST(Wavelet, BandsCoverThePicture) {
  for (const auto& [width, height] : kSizes) {
    std::vector<int> covered(static_cast<std::size_t>(width * height), 0);
    for (const WaveletBand& band : waveletBands(width, height, kLevels))
      for (int y = band.y; y < band.y + band.height; ++y)
        for (int x = band.x; x < band.x + band.width; ++x) ++covered[static_cast<std::size_t>(y * width + x)];
    EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), width * height) << width << " x " << height;
  }
  EXPECT_TRUE(waveletBands(0, 5, kLevels).empty());
  EXPECT_TRUE(waveletBands(5, 0, kLevels).empty());
}

TEST(Wavelet, AShortSideLetsTheOtherGoOn) {
  std::vector<std::pair<int, Kind>> found;
  for (const WaveletBand& band : waveletBands(40, 2, kLevels)) found.emplace_back(band.level, band.kind);
  const std::vector<std::pair<int, Kind>> expected{{1, Kind::HL}, {1, Kind::LH}, {1, Kind::HH},
                                                   {2, Kind::HL}, {3, Kind::HL}, {4, Kind::HL},
                                                   {5, Kind::HL}, {5, Kind::LL}};
  EXPECT_EQ(found, expected);
  const std::vector<WaveletBand> single = waveletBands(1, 1, kLevels);
  ASSERT_EQ(single.size(), 1U);
  EXPECT_EQ(single[0].level, 0);
  EXPECT_EQ(single[0].kind, Kind::LL);
}

/// The bands in which anything is.
std::vector<std::pair<int, Kind>> bandsOf(std::vector<float> pixels, int width, int height) {
  forwardWavelet(pixels, width, height, kLevels);
  std::vector<std::pair<int, Kind>> filled;
  for (const WaveletBand& band : waveletBands(width, height, kLevels)) {
    float largest = 0;
    for (int y = band.y; y < band.y + band.height; ++y)
      for (int x = band.x; x < band.x + band.width; ++x)
        largest = std::max(largest, std::abs(pixels[static_cast<std::size_t>(y * width + x)]));
    if (largest > 1e-3F) filled.emplace_back(band.level, band.kind);
  }
  return filled;
}

TEST(Wavelet, BandsHoldWhatTheirNamesSay) {
  constexpr int kWidth = 45;
  constexpr int kHeight = 38;
  std::vector<float> upright;
  std::vector<float> level;
  std::vector<float> board;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      upright.push_back(x % 2 == 0 ? 1.F : -1.F);
      level.push_back(y % 2 == 0 ? 1.F : -1.F);
      board.push_back((x + y) % 2 == 0 ? 1.F : -1.F);
    }
  }
  using Bands = std::vector<std::pair<int, Kind>>;
  EXPECT_EQ(bandsOf(upright, kWidth, kHeight), (Bands{{1, Kind::HL}}));
  EXPECT_EQ(bandsOf(level, kWidth, kHeight), (Bands{{1, Kind::LH}}));
  EXPECT_EQ(bandsOf(board, kWidth, kHeight), (Bands{{1, Kind::HH}}));
  EXPECT_EQ(bandsOf(std::vector<float>(kWidth * kHeight, 7.F), kWidth, kHeight), (Bands{{5, Kind::LL}}));
}

TEST(Wavelet, ApproximationKeepsWhatIsEven) {
  std::vector<float> pixels(50 * 30, 200.F);
  forwardWavelet(pixels, 50, 30, kLevels);
  EXPECT_NEAR(pixels[0], 200, 1e-3);
  EXPECT_NEAR(pixels[1], 200, 1e-3);
}

}  // namespace
}  // namespace lodestone
