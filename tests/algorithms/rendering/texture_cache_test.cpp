#include "algorithms/rendering/texture_cache.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include "algorithms/rendering/rendering.h"
#include "tests/support/run_program.h"

namespace lodestone {
namespace {

constexpr int kSide = 64;
constexpr std::size_t kBytes = 4 * kSide * kSide * 4 / 3;  // of a pyramid, about

/// A city of so many images, each in a grey of its own.
CityModel cityOfImages(const test::TemporaryFolder& folder, int count) {
  CityModel city;
  for (int i = 0; i < count; ++i) {
    Picture picture{kSide, kSide, std::vector<std::uint8_t>(std::size_t{4} * kSide * kSide, 255)};
    for (std::size_t k = 0; k < picture.rgba.size(); k += 4) picture.rgba[k] = static_cast<std::uint8_t>(i);
    const std::string path = (folder / (std::to_string(i) + ".png")).string();
    EXPECT_TRUE(writePicture(picture, path));
    city.textures.push_back({path, false, "", ""});
  }
  return city;
}

TEST(TextureCache, DecodesAnImageOnceForAll) {
  const test::TemporaryFolder folder;
  const CityModel city = cityOfImages(folder, 3);
  TextureCache cache(city);
  std::vector<std::shared_ptr<const TexturePyramid>> got(300);
  tbb::parallel_for(std::size_t{0}, got.size(), [&](std::size_t i) { got[i] = cache.get(i % 3, nullptr); });
  for (std::size_t i = 0; i < got.size(); ++i) {
    ASSERT_TRUE(got[i]);
    EXPECT_EQ(got[i], got[i % 3]);
    EXPECT_EQ(got[i]->levels.front().rgba[0], i % 3);
  }
}

TEST(TextureCache, LetsGoOfWhatWasUsedLongestAgo) {
  const test::TemporaryFolder folder;
  const CityModel city = cityOfImages(folder, 3);
  TextureCache cache(city, 5 * kBytes / 2);  // room for two
  const std::weak_ptr<const TexturePyramid> first = cache.get(0, nullptr);
  const std::weak_ptr<const TexturePyramid> second = cache.get(1, nullptr);
  (void)cache.get(0, nullptr);
  EXPECT_FALSE(first.expired());
  EXPECT_FALSE(second.expired());
  const std::weak_ptr<const TexturePyramid> third = cache.get(2, nullptr);
  EXPECT_FALSE(first.expired());
  EXPECT_TRUE(second.expired());
  EXPECT_FALSE(third.expired());
  EXPECT_EQ(cache.get(1, nullptr)->levels.front().rgba[0], 1) << "and decodes it again";
  TextureCache small(city, 1);
  EXPECT_TRUE(small.get(0, nullptr)) << "whoever asked has what is too large to keep";
}

TEST(TextureCache, TellsOnceOfAnImageThatCannotBeHad) {
  const test::TemporaryFolder folder;
  CityModel city = cityOfImages(folder, 1);
  test::writeText(folder / "bad.png", "no picture");
  city.textures.push_back({(folder / "bad.png").string(), false, "", ""});
  city.textures.push_back({(folder / "none.png").string(), true, "", ""});
  TextureCache cache(city);
  Diagnostics diagnostics;
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(cache.get(1, &diagnostics));
    EXPECT_FALSE(cache.get(2, &diagnostics));
  }
  ASSERT_EQ(diagnostics.size(), 1U);
  EXPECT_EQ(diagnostics.front().code, Code::TextureBad);
}

}  // namespace
}  // namespace lodestone
