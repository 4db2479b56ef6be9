// Perception analysis as people ask for it on the command line.
#include <cstdlib>

#include "tests/cli/cli_support.h"

namespace lodestone::test {
namespace {

class Perceive : public testing::Test {
 protected:
  /// Of a few buildings, in small pictures.
  Outcome perceive(std::vector<std::string> more) {
    std::vector<std::string> arguments{"perceive", town_, "--views", "2",        "--size",
                                       "48x48",    "-o",  out(),     "--report", report()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli(std::move(arguments));
  }
  [[nodiscard]] std::string out() const { return (folder_ / "out").string(); }
  [[nodiscard]] std::string report() const { return (folder_ / "report.json").string(); }

  TemporaryFolder folder_;
  std::string town_ = town(folder_, 6);
};

TEST_F(Perceive, WritesFourPicturesAViewAndWhatItFound) {
  const Outcome outcome = perceive({});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  std::set<std::string> expected{"triangles.json", "views.json"};
  for (const char* view : {"00", "01"}) {
    for (const char* what : {"render", "filtered", "difference", "classes"})
      expected.insert(std::string("view_") + view + "_" + what + ".png");
  }
  EXPECT_EQ(filesIn(out()), expected);
  const Json figures = jsonOf(report())["figures"];
  const Json triangles = jsonOf(folder_ / "out/triangles.json");
  EXPECT_EQ(triangles["triangles"].size() + triangles["unseen"].size(), figures["triangles"]);
  EXPECT_EQ(triangles["unseen"].size(), figures["triangles_unseen"]);
  EXPECT_EQ(jsonOf(folder_ / "out/views.json")["views"].size(), 2U);
}

TEST_F(Perceive, WritesTheSameAgain) {
  ASSERT_EQ(perceive({"--threads", "1"}).status, 0);
  const std::string once = readText(folder_ / "out/triangles.json");
  const std::string picture = readText(folder_ / "out/view_01_classes.png");
  ASSERT_EQ(perceive({"--threads", "3"}).status, 0);
  EXPECT_EQ(readText(folder_ / "out/triangles.json"), once);
  EXPECT_EQ(readText(folder_ / "out/view_01_classes.png"), picture);
}

TEST_F(Perceive, LooksFromCamerasThatAreGiven) {
  const Outcome outcome = cli({"perceive", town_, "--camera", "fit", "--camera", "fit:top", "--camera",
                               "fit:n", "-o", out(), "--no-pictures"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(jsonOf(folder_ / "out/views.json")["views"].size(), 3U);
  EXPECT_EQ(filesIn(out()), (std::set<std::string>{"triangles.json", "views.json"}));
  EXPECT_EQ(perceive({"--camera", "fit"}).status, 2) << "views of one's own have their own number and size";
}

TEST_F(Perceive, SaysWhenNoPictureShowsTheModel) {
  const Outcome outcome =
      cli({"perceive", town_, "--camera=0,0,-9000,0,0,-9999,45,40x40", "--no-pictures", "-o", out() + "/"});
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("613"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.out.find("none of 1 views"), std::string::npos) << outcome.out;
  EXPECT_TRUE(jsonOf(folder_ / "out/triangles.json")["triangles"].empty());
}

TEST_F(Perceive, OfNothingThereIsNothingToSay) {
  const std::string empty = (folder_ / "empty.city.json").string();
  writeText(empty, R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[],)"
                   R"("transform":{"scale":[1,1,1],"translate":[0,0,0]}})");
  const Outcome outcome = cli({"perceive", empty, "-o", out()});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("618"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(empty), std::string::npos) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  EXPECT_FALSE(std::filesystem::exists(out()));
}

TEST_F(Perceive, ThresholdsThatDoNotRiseAreRefused) {
  const Outcome outcome = perceive({"--slight", "9", "--dramatic", "3"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("503"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("--dramatic 3 is below --slight 9"), std::string::npos) << outcome.err;
  EXPECT_EQ(perceive({"--slight", "3", "--moderate", "3", "--no-pictures"}).status, 0);
}

TEST_F(Perceive, CamerasThatFitHaveTheSizeThatIsGiven) {
  ASSERT_EQ(cli({"perceive", town_, "--camera", "fit:top,64x48", "--camera", "fit,32x16", "-o", out(),
                 "--no-pictures"})
                .status,
            0);
  const Json views = jsonOf(folder_ / "out/views.json")["views"];
  EXPECT_EQ(views[0]["size"], Json({64, 48}));
  EXPECT_EQ(views[1]["size"], Json({32, 16}));
  for (const char* wrong : {"fit:top,0x48", "fit,64", "fit,64x48,9", "fit:up,64x48"})
    EXPECT_EQ(cli({"perceive", town_, "--camera", wrong, "-o", out()}).status, 2) << wrong;
}

/// Said before the place of the output is looked at: that there is none ends the command at once.
TEST_F(Perceive, SaysBeforehandWhatMuchLookingTakes) {
  writeText(out(), "a file");
  const Outcome outcome =
      cli({"perceive", town_, "--views", "1000", "--size", "400", "--no-pictures", "-o", out()});
  EXPECT_EQ(outcome.status, 1) << outcome.err;
  EXPECT_NE(outcome.err.find("619"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("160 million"), std::string::npos) << outcome.err;
  std::filesystem::remove(out());
  EXPECT_EQ(perceive({"--no-pictures"}).err.find("619"), std::string::npos);
}

TEST_F(Perceive, SaysThatACityIsLookedAtAsAWhole) {
  EXPECT_NE(perceive({"--no-pictures"}).err.find("620"), std::string::npos);
}

TEST_F(Perceive, SaysWhichPicturesAreOfAnEarlierRun) {
  ASSERT_EQ(perceive({}).status, 0);
  const Outcome outcome = cli({"perceive", town_, "--views", "1", "--size", "48", "-o", out()});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("708"), std::string::npos) << outcome.err;
  EXPECT_EQ(jsonOf(folder_ / "out/views.json")["views"].size(), 1U);
}

TEST_F(Perceive, InterruptedLeavesNothing) {
  const Outcome outcome = cli({"perceive", town_, "--views", "1000", "--size", "256", "-o", out()}, 600);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  for (const std::string& name : filesIn(std::filesystem::path(out()).parent_path()))
    EXPECT_EQ(name.find(".png"), std::string::npos) << name;
}

TEST_F(Perceive, FromFartherAwayMoreMayGo) {
  const auto dramatic = [&](const std::string& distance) {
    EXPECT_EQ(perceive({"--no-pictures", "--distance", distance, "--dramatic", "3"}).status, 0);
    return jsonOf(report())["figures"]["triangles_dramatic"].get<int>();
  };
  EXPECT_GT(dramatic("20"), dramatic("0.3"));
}

/// A folder on another file system than the temporary one, where there is one.
class ElsewhereFolder {
 public:
  ElsewhereFolder() {
    std::string name = "/dev/shm/lodestone-XXXXXX";
    if (mkdtemp(name.data())) path_ = name;
  }
  ~ElsewhereFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  ElsewhereFolder(const ElsewhereFolder&) = delete;
  ElsewhereFolder& operator=(const ElsewhereFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

TEST_F(Perceive, WritesIntoAFolderOfAnotherFileSystem) {
  const ElsewhereFolder elsewhere;
  if (elsewhere.path().empty()) GTEST_SKIP() << "no other file system";
  std::filesystem::create_directory_symlink(elsewhere.path(), out());
  const Outcome outcome = perceive({"--no-pictures"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  const std::set<std::string> expected{"triangles.json", "views.json"};
  EXPECT_EQ(filesIn(elsewhere.path()), expected);
  EXPECT_TRUE(std::filesystem::is_symlink(out()));
  const Outcome stopped = cli({"perceive", town_, "--views", "1000", "--size", "256", "-o", out()}, 600);
  EXPECT_EQ(stopped.status, 130) << stopped.err;
  for (const auto& entry : std::filesystem::directory_iterator(elsewhere.path()))
    EXPECT_TRUE(expected.contains(entry.path().filename().string())) << entry.path();
}

TEST_F(Perceive, RefusesALinkThatLeadsNowhereBeforeItBegins) {
  std::filesystem::create_directory_symlink(folder_ / "gone", out());
  const Outcome outcome = perceive({"--no-pictures"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("leads nowhere"), std::string::npos) << outcome.err;
}

TEST_F(Perceive, CamerasHaveTheLargestSizeThatViewsHave) {
  for (const char* camera : {"fit,8193x16", "0,0,9,0,0,0,45,16x8193"}) {
    const Outcome outcome =
        cli({"perceive", town_, std::string("--camera=") + camera, "--no-pictures", "-o", out()});
    EXPECT_EQ(outcome.status, 2) << camera;
    EXPECT_NE(outcome.err.find("503"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("at most 8192"), std::string::npos) << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
  EXPECT_EQ(cli({"perceive", town_, "--camera=fit,8192x16", "--no-pictures", "-o", out()}).status, 0);
}

TEST_F(Perceive, RefusesWhatIsNoSize) {
  for (const std::string size : {"48x64", "8193", "x", "0"}) {
    const Outcome outcome = cli({"perceive", town_, "--size", size, "-o", out()});
    EXPECT_EQ(outcome.status, 2) << size;
    EXPECT_FALSE(std::filesystem::exists(out()));
  }
}

TEST_F(Perceive, LeavesNothingBehindWhereItCannotWrite) {
  writeText(folder_ / "out", "a file");
  const Outcome outcome = perceive({});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("701"), std::string::npos) << outcome.err;
  EXPECT_EQ(readText(folder_ / "out"), "a file");
}

}  // namespace
}  // namespace lodestone::test
