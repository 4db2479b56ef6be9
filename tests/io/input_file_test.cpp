#include "model/io/input_file.h"

#include <algorithm>
#include <fstream>
#include <system_error>

#include <cpl_vsi.h>
#include <gtest/gtest.h>

#include "tests/support/shared_data.h"

namespace lodestone {
namespace {

class InputFileTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() /
        ("lodestone_input_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    const auto path = folder_ / name;
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }
  /// Writes through GDAL: "/vsigzip/…" or "/vsizip/…".
  static void writeVirtual(const std::string& path, const std::string& text) {
    VSILFILE* file = VSIFOpenL(path.c_str(), "wb");
    ASSERT_NE(file, nullptr) << path;
    ASSERT_EQ(VSIFWriteL(text.data(), 1, text.size(), file), text.size());
    ASSERT_EQ(VSIFCloseL(file), 0);
  }
  std::filesystem::path folder_;
};

std::string someText() {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += std::to_string(i * 7919 % 10007) + "\n";
  return text;
}

TEST_F(InputFileTest, PlainAndGzippedGiveTheSameBytes) {
  const std::string text = someText();
  const auto plain = write("a.gml", text);
  const auto packed = folder_ / "a.gml.gz";
  writeVirtual("/vsigzip/" + packed.string(), text);
  EXPECT_LT(std::filesystem::file_size(packed), text.size());
  EXPECT_EQ(readWholeFile(plain), text);
  EXPECT_EQ(readWholeFile(packed), text);
  EXPECT_EQ(readHead(packed, 10), text.substr(0, 10));
  EXPECT_FALSE(isArchive(packed));
  InputFile file(virtualPath(packed));
  EXPECT_EQ(file.packedSize(), std::filesystem::file_size(packed));
}

TEST_F(InputFileTest, ReadingLeavesNoSideFiles) {
  const auto packed = folder_ / "a.gml.gz";
  writeVirtual("/vsigzip/" + packed.string(), someText());
  (void)readWholeFile(packed);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_), {}), 1);
}

TEST_F(InputFileTest, TruncatedGzipGivesWhatStandsBeforeItsEnd) {
  const auto packed = folder_ / "a.gml.gz";
  const std::string text = someText();
  writeVirtual("/vsigzip/" + packed.string(), text);
  std::filesystem::resize_file(packed, std::filesystem::file_size(packed) / 2);
  const std::string read = readWholeFile(packed);
  EXPECT_GT(read.size(), text.size() / 4);
  EXPECT_LT(read.size(), text.size());
  EXPECT_EQ(read, text.substr(0, read.size()));
}

TEST_F(InputFileTest, MissingFilesFoldersAndNetworkPathsThrow) {
  EXPECT_THROW(InputFile("/nowhere/at/all.gml"), std::system_error);
  EXPECT_THROW(InputFile(folder_.string()), std::system_error);
  EXPECT_THROW(InputFile("/vsicurl/http://localhost/a.gml"), std::system_error);
  EXPECT_THROW(InputFile("/vsizip//vsicurl/http://localhost/a.zip/a.gml"), std::system_error);
  EXPECT_EQ(readHead("/nowhere/at/all.gml"), "");
  EXPECT_EQ(readHead(write("empty.gml", "")), "");
}

TEST_F(InputFileTest, ArchiveMembersComeInOrderOfLikelihoodThenName) {
  const auto archive = folder_ / "town of many.zip";
  const std::string root = "/vsizip/{" + archive.string() + "}/";
  VSILFILE* holder = VSIFOpenL(root.c_str(), "wb");  // keeps the archive open for more members
  writeVirtual(root + "codelists/class.xml", "<codes/>");
  writeVirtual(root + "readme.txt", "hello");
  writeVirtual(root + "udx/b.gml", "<b/>");
  writeVirtual(root + "udx/a.GML", "<a/>");
  writeVirtual(root + "__MACOSX/udx/._a.gml", "fork");
  if (holder) VSIFCloseL(holder);
  ASSERT_TRUE(isArchive(archive));
  const auto members = archiveMembers(archive);
  ASSERT_TRUE(members);
  ASSERT_EQ(members->size(), 3U);
  EXPECT_TRUE((*members)[0].ends_with("udx/a.GML"));
  EXPECT_TRUE((*members)[1].ends_with("udx/b.gml"));
  EXPECT_TRUE((*members)[2].ends_with("codelists/class.xml"));
  EXPECT_EQ(readHead(archive), "<a/>");
  EXPECT_EQ(readWholeFile((*members)[2]), "<codes/>");
}

/// Bytes of a zip archive with one stored member whose header may lie about its size.
std::string storedZip(const std::string& name, const std::string& text, std::uint32_t crc,
                      std::uint32_t claimed) {
  const auto le = [](std::uint32_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>(value >> (8 * i));
    return out;
  };
  const auto size = static_cast<std::uint32_t>(text.size());
  const std::string common = le(20, 2) + le(0, 2) + le(0, 2) + le(0, 4) + le(crc, 4) + le(size, 4) +
                             le(claimed, 4) + le(static_cast<std::uint32_t>(name.size()), 2) + le(0, 2);
  const std::string local = "PK\x03\x04" + common + name + text;
  const std::string central =
      "PK\x01\x02" + le(20, 2) + common + le(0, 2) + le(0, 2) + le(0, 2) + le(0, 4) + le(0, 4) + name;
  return local + central + "PK\x05\x06" + le(0, 4) + le(1, 2) + le(1, 2) +
         le(static_cast<std::uint32_t>(central.size()), 4) + le(static_cast<std::uint32_t>(local.size()), 4) +
         le(0, 2);
}

TEST_F(InputFileTest, MembersThatClimbOutAreRefused) {
  for (const std::string name :
       {"../evil.gml", "a/../../evil.gml", "/etc/evil.gml", "..\\evil.gml", "C:/evil.gml"}) {
    const auto members = archiveMembers(write("evil.zip", storedZip(name, "<a/>", 0, 4)));
    EXPECT_FALSE(members) << name;
    const auto isUnsafe = [](const Diagnostic& d) { return d.code == Code::ArchiveUnsafe; };
    EXPECT_TRUE(std::any_of(members.diagnostics.begin(), members.diagnostics.end(), isUnsafe)) << name;
  }
}

TEST_F(InputFileTest, ArchiveThatClaimsTooMuchIsRefused) {
  const auto members = archiveMembers(write("bomb.zip", storedZip("a.gml", "<a/>", 0, 0xF0000000U)));
  EXPECT_FALSE(members);
  ASSERT_FALSE(members.diagnostics.empty());
  EXPECT_EQ(members.diagnostics.front().code, Code::ArchiveUnsafe);
}

TEST_F(InputFileTest, BrokenAndEmptyArchivesAreSaid) {
  const auto broken = archiveMembers(write("broken.zip", "PK\x03\x04 and nothing more"));
  ASSERT_FALSE(broken);
  EXPECT_EQ(broken.diagnostics.front().code, Code::FileMalformed);
  const auto empty = archiveMembers(write("empty.zip", storedZip("readme.txt", "hi", 0, 2)));
  ASSERT_FALSE(empty);
  EXPECT_EQ(empty.diagnostics.front().code, Code::ArchiveEmpty);
}

TEST_F(InputFileTest, GzipBombIsStopped) {
  const auto packed = folder_ / "bomb.gml.gz";
  VSILFILE* file = VSIFOpenL(("/vsigzip/" + packed.string()).c_str(), "wb");
  ASSERT_NE(file, nullptr);
  const std::string block(1 << 20, ' ');
  for (int i = 0; i < 1100; ++i) VSIFWriteL(block.data(), 1, block.size(), file);
  VSIFCloseL(file);
  InputFile input(virtualPath(packed));
  std::string buffer(1 << 20, '\0');
  const auto drain = [&] {
    while (input.read(buffer.data(), buffer.size()) > 0) {
    }
  };
  try {
    drain();
    FAIL() << "the whole bomb was unpacked";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::file_too_large);
  }
}

TEST_F(InputFileTest, RealArchive) {
  const auto path = test::sharedData("A_citygml/fzkhaus_all_lods/FZK-Haus-LoD-all-KIT-IAI-KHH-B36-V1.zip");
  if (path.empty()) GTEST_SKIP() << "shared data not present";
  const auto members = archiveMembers(path);
  ASSERT_TRUE(members);
  ASSERT_EQ(members->size(), 1U);
  EXPECT_NE(readHead(path).find("CityModel"), std::string::npos);
}

}  // namespace
}  // namespace lodestone
