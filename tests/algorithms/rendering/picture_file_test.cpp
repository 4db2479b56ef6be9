// Pictures that are read: what was written comes back, whatever stands in a file.
#include <cmath>
#include <filesystem>
#include <random>

#include <gmock/gmock.h>
#include <png.h>

#include "algorithms/rendering/rendering.h"
#include "tests/support/run_program.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

/// Smooth enough for lossy formats, opaque.
Picture waves(int width, int height) {
  Picture picture{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto wave = [&](double a, double b) {
        return static_cast<std::uint8_t>(std::lround(127.5 + 120 * std::sin(a * x + b * y)));
      };
      picture.rgba.insert(picture.rgba.end(), {wave(0.05, 0.02), wave(0.01, 0.06), wave(0.03, 0.03), 255});
    }
  }
  return picture;
}

int largestDifference(const Picture& a, const Picture& b) {
  int largest = 0;
  for (std::size_t i = 0; i < a.rgba.size(); ++i)
    largest = std::max(largest, std::abs(a.rgba[i] - b.rgba[i]));
  return largest;
}

std::string bytesOf(const Picture& picture, const std::string& ending) {
  const fs::path path = fs::path(testing::TempDir()) / ("picture" + ending);
  EXPECT_TRUE(writePicture(picture, path).ok()) << ending;
  return test::readText(path);
}

/// A PNG as libpng writes it from rows of samples.
struct PngKind {
  int depth = 8;
  int type = PNG_COLOR_TYPE_GRAY;
  std::vector<png_color> palette;
  std::vector<png_byte> paletteAlpha;
};

std::string pngOf(int width, const PngKind& kind, const std::vector<std::vector<png_byte>>& rows) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp to, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(data), size);
      },
      nullptr);
  png_set_IHDR(png, info, static_cast<png_uint_32>(width), static_cast<png_uint_32>(rows.size()), kind.depth,
               kind.type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  if (!kind.palette.empty())
    png_set_PLTE(png, info, kind.palette.data(), static_cast<int>(kind.palette.size()));
  if (!kind.paletteAlpha.empty())
    png_set_tRNS(png, info, kind.paletteAlpha.data(), static_cast<int>(kind.paletteAlpha.size()), nullptr);
  png_write_info(png, info);
  for (const auto& row : rows) png_write_row(png, row.data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

using Pixels = std::vector<std::uint8_t>;

Pixels decoded(const std::string& bytes, const std::string& name = "picture") {
  const Result<Picture> picture = decodePicture(bytes, name);
  EXPECT_TRUE(picture.ok() && picture.diagnostics.empty()) << name;
  return picture ? picture->rgba : Pixels();
}

TEST(PictureFile, WhatIsWrittenIsRead) {
  const Picture picture = waves(97, 61);
  for (const auto& [ending, tolerance] : std::vector<std::pair<std::string, int>>{
           {".png", 0}, {".tif", 0}, {".tiff", 0}, {".bmp", 0}, {".jpg", 12}, {".jpeg", 12}, {".webp", 16}}) {
    const fs::path path = fs::path(testing::TempDir()) / ("waves" + ending);
    ASSERT_TRUE(writePicture(picture, path).ok());
    const Result<Picture> back = readPicture(path);
    ASSERT_TRUE(back.ok()) << ending << " " << back.diagnostics.front().text;
    EXPECT_TRUE(back.diagnostics.empty()) << ending;
    ASSERT_EQ(back->width, 97) << ending;
    ASSERT_EQ(back->height, 61) << ending;
    EXPECT_LE(largestDifference(picture, *back), tolerance) << ending;
  }
}

TEST(PictureFile, ColoursAreNotMultipliedByAlpha) {
  Picture picture{3, 1, {200, 100, 50, 128, 10, 250, 90, 255, 255, 128, 0, 64}};
  for (const char* ending : {".png", ".tif", ".bmp"})
    EXPECT_EQ(decoded(bytesOf(picture, ending)), picture.rgba) << ending;
}

/// OpenImageIO multiplies WebP's: white glass would come back grey.
TEST(PictureFile, WhiteGlassStaysWhite) {
  Picture picture{16, 16, {}};
  for (int i = 0; i < 256; ++i) picture.rgba.insert(picture.rgba.end(), {255, 255, 255, 128});
  const Pixels back = decoded(bytesOf(picture, ".webp"));
  ASSERT_EQ(back.size(), 1024U);
  EXPECT_GE(back[0], 250);
  EXPECT_NEAR(back[3], 128, 2);
}

TEST(PictureFile, PortablePixmapsAreRead) {
  EXPECT_EQ(decoded(std::string("P6\n# two pixels\n2 1\n255\n\x01\x02\x03\xff\x80\x40", 33)),
            (Pixels{1, 2, 3, 255, 255, 128, 64, 255}));
  EXPECT_EQ(decoded("P3 1 1 255 7 8 9\n"), (Pixels{7, 8, 9, 255}));
  EXPECT_EQ(decoded("P2\n1 2\n255\n30\n40\n"), (Pixels{30, 30, 30, 255, 40, 40, 40, 255}));
}

TEST(PictureFile, GreySixteenBitsAndPalettesBecomeRgba) {
  EXPECT_EQ(decoded(pngOf(2, {}, {{0, 200}})), (Pixels{0, 0, 0, 255, 200, 200, 200, 255}));
  EXPECT_EQ(decoded(pngOf(1, {8, PNG_COLOR_TYPE_GRAY_ALPHA, {}, {}}, {{80, 40}})), (Pixels{80, 80, 80, 40}));
  EXPECT_EQ(decoded(pngOf(1, {16, PNG_COLOR_TYPE_RGB, {}, {}}, {{0x80, 0x80, 0xff, 0xff, 0, 0}})),
            (Pixels{128, 255, 0, 255}));
  EXPECT_EQ(decoded(pngOf(8, {1, PNG_COLOR_TYPE_GRAY, {}, {}}, {{0x80}})).at(4), 0);
  const PngKind palette{8, PNG_COLOR_TYPE_PALETTE, {{1, 2, 3}, {40, 50, 60}}, {}};
  EXPECT_EQ(decoded(pngOf(2, palette, {{1, 0}})), (Pixels{40, 50, 60, 255, 1, 2, 3, 255}));
  const PngKind glass{8, PNG_COLOR_TYPE_PALETTE, {{1, 2, 3}, {40, 50, 60}}, {128}};
  EXPECT_EQ(decoded(pngOf(2, glass, {{1, 0}})), (Pixels{40, 50, 60, 255, 1, 2, 3, 128}));
}

TEST(PictureFile, TgaIsKnownByItsEnding) {
  std::string tga(18, '\0');
  tga[2] = 2;      // colours, not packed
  tga[12] = 1;     // width
  tga[14] = 2;     // height
  tga[16] = 24;    // bits a pixel
  tga[17] = 0x20;  // rows from the top
  tga += std::string("\x03\x02\x01\x06\x05\x04", 6);
  EXPECT_EQ(decoded(tga, "Roof.TGA"), (Pixels{1, 2, 3, 255, 4, 5, 6, 255}));
  EXPECT_EQ(decodePicture(tga, "roof").diagnostics.at(0).code, Code::PictureUnreadable);
}

/// Textures are often named after another format than theirs.
TEST(PictureFile, TheBytesSayTheFormatAndNotTheName) {
  const Picture picture = waves(20, 10);
  EXPECT_EQ(decoded(bytesOf(picture, ".png"), "facade.jpg"), picture.rgba);
}

TEST(PictureFile, GarbageIsRefused) {
  std::mt19937 random(5);
  for (const std::string begin :
       {"", "\x89PNG\r\n\x1a\n", "\xff\xd8\xff", "II*", "RIFF1234WEBP", "BM", "P6 "}) {
    for (const std::size_t size : {0, 1, 3, 17, 200, 5000}) {
      std::string bytes = begin;
      if (begin == "II*") bytes.push_back('\0');
      for (std::size_t i = 0; i < size; ++i) bytes.push_back(static_cast<char>(random()));
      const Result<Picture> picture = decodePicture(bytes, "garbage.tga");
      ASSERT_FALSE(picture.diagnostics.empty()) << begin << size;
      EXPECT_FALSE(picture.ok()) << begin << size;
      EXPECT_EQ(picture.diagnostics[0].code, Code::PictureUnreadable);
      EXPECT_EQ(picture.diagnostics[0].place, "garbage.tga");
    }
  }
}

/// Of a JPEG the rows that are there come back, with a warning.
TEST(PictureFile, TruncatedFilesAreSaid) {
  for (const char* ending : {".png", ".tif", ".webp", ".bmp", ".jpg"}) {
    const std::string bytes = bytesOf(waves(200, 160), ending);
    for (const double share : {0.02, 0.3, 0.7, 0.95}) {
      const auto size = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
      const Result<Picture> picture = decodePicture(std::string_view(bytes).substr(0, size), "cut");
      ASSERT_FALSE(picture.diagnostics.empty()) << ending << share;
      EXPECT_EQ(picture.diagnostics[0].code, picture.ok() ? Code::InputReadInPart : Code::PictureUnreadable);
      EXPECT_TRUE(!picture.ok() || std::string(ending) == ".jpg");
    }
  }
}

TEST(PictureFile, TooLargeOnesAreRefusedBeforeAPixelIsRead) {
  for (const char* size : {"32769 1", "1 32769", "32768 32768", "2000000000 2000000000"}) {
    const Result<Picture> picture = decodePicture("P6\n" + std::string(size) + "\n255\n123", "large");
    ASSERT_FALSE(picture.ok());
    EXPECT_EQ(picture.diagnostics[0].code, Code::PictureUnreadable) << size;
  }
}

TEST(PictureFile, WhatIsNotThereIsSaid) {
  EXPECT_EQ(readPicture("/nowhere/a.png").diagnostics.at(0).code, Code::FileNotFound);
  EXPECT_EQ(readPicture(testing::TempDir()).diagnostics.at(0).code, Code::FileUnreadable);
}

}  // namespace
}  // namespace lodestone
