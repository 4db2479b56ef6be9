#include "model/io/atomic_file.h"

#include <cstdlib>
#include <system_error>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "model/io/outlines/gdal_writer.h"
#include "tests/support/run_program.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;

TEST(AtomicFile, MakesFoldersAndKeepsThemWithTheFile) {
  const TemporaryFolder folder;
  writeFile(folder / "new/sub/a.txt", "text");
  EXPECT_EQ(test::readText(folder / "new/sub/a.txt"), "text");
}

TEST(AtomicFile, WritesThroughALinkAndReplacesNoPipe) {
  const TemporaryFolder folder;
  { AtomicFile(folder / "target.txt").commit(); }
  fs::create_symlink("target.txt", folder / "link.txt");
  AtomicFile file(folder / "link.txt");
  file.stream() << "whole";
  file.commit();
  EXPECT_TRUE(fs::is_symlink(folder / "link.txt"));
  EXPECT_EQ(fs::file_size(folder / "target.txt"), 5U);
  ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
  EXPECT_THROW(AtomicFile(folder / "pipe"), std::system_error);
  EXPECT_TRUE(fs::is_fifo(folder / "pipe"));
}

TEST(AtomicFile, LeavesNothingWhereTheProcessEndsAtOnce) {
  const TemporaryFolder folder;
  const auto endAtOnce = [&] {
    AtomicFile file(folder / "a.txt");
    AtomicFile whole(folder / "b.txt");
    whole.commit();
    removeAllUnfinished();
    std::_Exit(fs::exists(file.temporaryPath()) ? 1 : 0);
  };
  EXPECT_EXIT(endAtOnce(), testing::ExitedWithCode(0), "");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
  EXPECT_TRUE(fs::exists(folder / "b.txt"));
}

TEST(AtomicFile, LeavesNothingWithoutCommit) {
  const TemporaryFolder folder;
  { AtomicFile(folder / "new/sub/a.txt").stream() << "half"; }
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(AtomicFile, LeavesNoFolderWhenTheFileCannotBeMade) {
  const TemporaryFolder folder;
  const std::string tooLong(250, 'x');
  EXPECT_THROW(AtomicFile(folder / ("new/sub/" + tooLong + ".glb")), std::system_error);
  EXPECT_TRUE(fs::is_empty(folder.path()));
  EXPECT_THROW((void)writeVector(folder / ("new/sub/" + tooLong + ".gpkg"), "GPKG", {}, {}, {}, {}),
               std::system_error);
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

TEST(AtomicFile, LeavesFoldersThatWereThere) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "old");
  EXPECT_THROW(AtomicFile(folder / ("old/sub/" + std::string(250, 'x') + ".glb")), std::system_error);
  EXPECT_TRUE(fs::is_empty(folder / "old"));
  EXPECT_TRUE(fs::exists(folder / "old"));
}

}  // namespace
}  // namespace lodestone
