#include "model/io/image_path.h"

#include <filesystem>

#include <gtest/gtest.h>
#include <unistd.h>

#include "model/io/atomic_file.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

class ImagePathsTest : public testing::Test {
 protected:
  void SetUp() override {
    root_ = fs::path(testing::TempDir()) / ("images-" + std::to_string(::getpid()));
    fs::create_directories(root_ / "in" / "textures");
    writeFile(root_ / "in" / "textures" / "wall.png", "x");
    writeFile(root_ / "secret.png", "x");
    fs::create_symlink(root_ / "secret.png", root_ / "in" / "link.png");
  }
  void TearDown() override { fs::remove_all(root_); }

  /// The code that is said about a name; 0: none.
  int said(const std::string& name, bool allowOutside = false) {
    Diagnostics diagnostics;
    texture_ = ImagePaths(root_ / "in" / "city.json", allowOutside).find(name, diagnostics);
    EXPECT_EQ(texture_.missing, !diagnostics.empty());
    return diagnostics.empty() ? 0 : static_cast<int>(diagnostics[0].code);
  }

  fs::path root_;
  Texture texture_;
};

TEST_F(ImagePathsTest, FindsImagesBesideTheFile) {
  EXPECT_EQ(said("textures/wall.png"), 0);
  EXPECT_TRUE(fs::exists(texture_.path));
  EXPECT_EQ(said("textures\\wall.png"), 0);
  EXPECT_EQ(said("textures/../textures/wall.png"), 0);
}

TEST_F(ImagePathsTest, RefusesWhatLeavesTheFolder) {
  const int outside = static_cast<int>(Code::TextureOutside);
  EXPECT_EQ(said("../secret.png"), outside);
  EXPECT_EQ(said((root_ / "secret.png").string()), outside);
  EXPECT_EQ(said("link.png"), outside);
  EXPECT_EQ(said("../secret.png", true), 0);
}

TEST_F(ImagePathsTest, LooksBesideACompressedFile) {
  Diagnostics diagnostics;
  const std::string packed = "/vsigzip/" + (root_ / "in" / "city.gml.gz").string();
  EXPECT_FALSE(ImagePaths(packed, false).find("textures/wall.png", diagnostics).missing);
  EXPECT_TRUE(ImagePaths(packed, false).find("../secret.png", diagnostics).missing);
}

TEST_F(ImagePathsTest, SaysWhatIsMissing) {
  const int missing = static_cast<int>(Code::TextureMissing);
  EXPECT_EQ(said("gone.png"), missing);
  EXPECT_EQ(texture_.path, "gone.png");
  EXPECT_EQ(said("textures"), missing);
  EXPECT_EQ(said(""), missing);
  EXPECT_EQ(said("https://example.org/wall.png"), missing);
  EXPECT_EQ(said("/vsicurl/https", true), missing);
}

}  // namespace
}  // namespace lodestone
