// Two pictures, or two models, compared on the command line.
#include <fmt/format.h>

#include "tests/cli/cli_support.h"

namespace lodestone::test {
namespace {

/// A portable pixmap of a chequered pattern whose dark fields have one grey.
std::string chequered(int width, int height, int dark) {
  std::string text = fmt::format("P3 {} {} 255\n", width, height);
  for (int i = 0; i < width * height; ++i) {
    const int grey = (i % width / 4 + i / width / 4) % 2 == 0 ? 220 : dark;
    text += fmt::format("{0} {0} {0}\n", grey);
  }
  return text;
}

class Compare : public testing::Test {
 protected:
  [[nodiscard]] std::string at(const std::string& name) const { return (folder_ / name).string(); }
  std::string picture(const std::string& name, int width, int height, int dark) {
    writeText(folder_ / name, chequered(width, height, dark));
    return at(name);
  }
  /// Of models, from two places in small pictures.
  Outcome compare(const std::string& a, const std::string& b, const std::vector<std::string>& more = {}) {
    std::vector<std::string> arguments{"compare", a,    b,          "--views",   "2",
                                       "--size",  "64", "--report", at("r.json")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return cli(std::move(arguments));
  }
  /// Two houses, `gap` metres from wall to wall, as the groups "left" and "right" of an OBJ; or one of them.
  std::string row(const std::string& name, double gap, bool second) {
    const auto house = [](const std::string& id, double x) {
      return fmt::format(
          "o {}\nv {} 0 0\nv {} 0 0\nv {} 8 0\nv {} 8 0\nv {} 0 6\nv {} 0 6\nv {} 8 6\nv {} 8 6\n", id, x,
          x + 10, x + 10, x, x, x + 10, x + 10, x);
    };
    const auto faces = [](int first) {
      std::string text;
      for (const auto& [a, b, c, d] : std::vector<std::array<int, 4>>{
               {4, 3, 2, 1}, {5, 6, 7, 8}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 4, 8, 7}, {4, 1, 5, 8}})
        text += fmt::format("f {} {} {} {}\n", first + a, first + b, first + c, first + d);
      return text;
    };
    std::string text = house("left", 0) + faces(0);
    if (second) text += house("right", 10 + gap) + faces(8);
    writeText(folder_ / name, text);
    return at(name);
  }
  Json contacts(const std::string& a, const std::string& b) {
    const Outcome outcome = compare(a, b, {"--up-axis", "z"});
    EXPECT_TRUE(outcome.status == 0 || outcome.status == 3) << outcome.err;
    return figures()["contacts"];
  }
  [[nodiscard]] Json figures() const { return jsonOf(folder_ / "r.json")["figures"]; }

  TemporaryFolder folder_;
};

TEST_F(Compare, EqualPicturesDoNotDiffer) {
  const Outcome outcome =
      cli({"compare", picture("a.ppm", 20, 16, 40), picture("b.ppm", 20, 16, 40), "--report", at("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(figures()["flip"], 0);
  EXPECT_EQ(figures()["pixel_error"], 0);
}

TEST_F(Compare, PicturesThatDifferAreMeasuredAndTheirDifferenceIsDrawn) {
  const std::string a = picture("a.ppm", 20, 16, 40);
  const std::string b = picture("b.ppm", 20, 16, 90);
  const Outcome outcome = cli({"compare", a, b, "--ppd", "67", "-o", at("out"), "--report", at("r.json")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(filesIn(at("out")), (std::set<std::string>{"comparison.json", "flip.png"}));
  const Json answer = jsonOf(folder_ / "out/comparison.json");
  EXPECT_EQ(answer["kind"], "pictures");
  EXPECT_EQ(answer["size"], Json({20, 16}));
  EXPECT_EQ(answer["pixels_per_degree"], 67);
  EXPECT_EQ(answer["pixel_error"], 0.5);
  EXPECT_GT(answer["flip"], 0.05);
  EXPECT_EQ(answer["flip"], figures()["flip"]);
}

/// 0.7 m from a screen of 0.7 m and 3840 pixels: the 67 pixels per degree of the paper.
TEST_F(Compare, TheDisplayGivesThePixelsPerDegree) {
  const std::string a = picture("a.ppm", 20, 16, 40);
  const std::string b = picture("b.ppm", 20, 16, 90);
  ASSERT_EQ(cli({"compare", a, b, "--distance", "0.7", "--screen-width", "0.7", "--screen-resolution", "3840",
                 "--report", at("r.json")})
                .status,
            0);
  EXPECT_NEAR(figures()["pixels_per_degree"].get<double>(), 67.02, 0.01);
}

TEST_F(Compare, PicturesOfOtherSizesAreRefused) {
  const Outcome outcome = cli({"compare", picture("a.ppm", 20, 16, 40), picture("b.ppm", 16, 20, 40)});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("617"), std::string::npos) << outcome.err;
}

TEST_F(Compare, WhatIsNoPictureIsRefused) {
  writeText(folder_ / "b.png", "no picture");
  const Outcome outcome = cli({"compare", picture("a.ppm", 20, 16, 40), at("b.png"), "-o", at("out")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("616"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(at("out")));
  EXPECT_EQ(cli({"compare", at("a.ppm"), at("none.png")}).status, 1);
}

/// What libraries print by themselves names neither file nor remedy.
TEST_F(Compare, BrokenPicturesAreSaidInOneLine) {
  ASSERT_EQ(
      cli({"compare", picture("a.ppm", 20, 16, 40), picture("b.ppm", 20, 16, 90), "-o", at("out")}).status,
      0);
  const std::string whole = at("out/flip.png");
  const std::string bytes = readText(whole);
  std::string damaged = bytes;
  damaged[20] = static_cast<char>(damaged[20] ^ 1);
  for (const std::string& broken : {bytes.substr(0, 20), bytes.substr(0, bytes.size() / 2), damaged}) {
    writeText(folder_ / "b.png", broken);
    const Outcome outcome = cli({"compare", whole, at("b.png")});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.err.starts_with("error 616")) << outcome.err;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  }
}

TEST_F(Compare, APictureAndAModelAreRefusedByName) {
  const std::string a = picture("a.ppm", 20, 16, 40);
  const Outcome outcome = cli({"compare", town(folder_, 3), a});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_NE(outcome.err.find("506"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(a + " is a picture"), std::string::npos) << outcome.err;
}

TEST_F(Compare, OptionsThatPicturesIgnoreAreRefused) {
  const std::string a = picture("a.ppm", 20, 16, 40);
  for (const std::vector<std::string>& given : {std::vector<std::string>{"--views", "3"},
                                                {"--turn", "0.2"},
                                                {"--size", "64"},
                                                {"--plain"},
                                                {"--viewpoints", "upper"},
                                                {"--up-axis", "z"},
                                                {"--ppd", "30", "--distance", "1"}}) {
    std::vector<std::string> arguments{"compare", a, a};
    arguments.insert(arguments.end(), given.begin(), given.end());
    const Outcome outcome = cli(arguments);
    EXPECT_EQ(outcome.status, 2) << given[0];
    EXPECT_NE(outcome.err.find("505"), std::string::npos) << outcome.err;
  }
}

TEST_F(Compare, AFileInThePlaceOfTheFolderIsSaidAtOnce) {
  const std::string a = picture("a.ppm", 20, 16, 40);
  const Outcome outcome = cli({"compare", a, a, "-o", a});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("701"), std::string::npos) << outcome.err;
}

TEST_F(Compare, NothingCannotBeCompared) {
  writeText(folder_ / "empty.city.json",
            R"({"type":"CityJSON","version":"2.0","CityObjects":{},"vertices":[],)"
            R"("transform":{"scale":[1,1,1],"translate":[0,0,0]}})");
  const Outcome outcome = compare(town(folder_, 3), at("empty.city.json"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("618"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find(at("empty.city.json")), std::string::npos) << outcome.err;
}

TEST_F(Compare, NotesNameTheInputThatTheyAreAbout) {
  const Outcome outcome = compare(row("a.obj", 0, true), row("b.obj", 0, false));
  EXPECT_NE(outcome.err.find("outline (" + at("a.obj") + ")"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("outline (" + at("b.obj") + ")"), std::string::npos) << outcome.err;
}

TEST_F(Compare, AMissingInputIsFoundOutBeforeTheOtherIsRead) {
  const Outcome outcome = compare(town(folder_, 3), at("none.gml"));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("101"), std::string::npos) << outcome.err;
  EXPECT_TRUE(jsonOf(folder_ / "r.json")["stages"].empty());
}

TEST_F(Compare, AnInputIsNotReplaced) {
  const std::string a = picture("flip.png", 20, 16, 40);
  const std::string before = readText(a);
  const Outcome outcome = cli({"compare", a, picture("b.ppm", 20, 16, 90), "-o", folder_.path().string()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_NE(outcome.err.find("701"), std::string::npos) << outcome.err;
  EXPECT_EQ(readText(a), before);
}

TEST_F(Compare, AModelIsEqualToItself) {
  const std::string model = town(folder_, 6);
  const Outcome outcome = compare(model, model);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json f = figures();
  EXPECT_EQ(f["flip"], 0);
  EXPECT_EQ(f["pixel_error"], 0);
  EXPECT_EQ(f["hausdorff_m"], 0);
  EXPECT_GT(f["shown"], 0.01);
  EXPECT_EQ(f["views"].size(), 2U);
  EXPECT_EQ(f["contacts"]["kept"], f["contacts"]["contacts"]);
  EXPECT_EQ(f["contacts"]["objects_in_both"], f["a"]["buildings"]);
  EXPECT_EQ(f["a"]["triangles"], f["b"]["triangles"]);
}

TEST_F(Compare, ASimplifiedModelIsMeasuredAndDrawnFromAllViews) {
  const std::string model = town(folder_, 40);
  ASSERT_EQ(cli({"simplify", model, "--rate", "0.5", "-o", at("less.city.json")}).status, 0);
  const Outcome outcome = compare(model, at("less.city.json"), {"-o", at("out")});
  ASSERT_TRUE(outcome.status == 0 || outcome.status == 3) << outcome.err;  // a floor may be gone
  std::set<std::string> expected{"comparison.json"};
  for (const char* view : {"00", "01"}) {
    for (const char* what : {"a", "b", "flip"}) expected.insert(fmt::format("view_{}_{}.png", view, what));
  }
  EXPECT_EQ(filesIn(at("out")), expected);
  const Json answer = jsonOf(folder_ / "out/comparison.json");
  EXPECT_GT(answer["flip"], 0);
  EXPECT_GT(answer["flip_shown"], answer["flip"]);
  EXPECT_GT(answer["hausdorff_m"], 0);
  EXPECT_LT(answer["b"]["triangles"], answer["a"]["triangles"]);
  double sum = 0;
  for (const Json& view : answer["views"]) sum += view["flip"].get<double>();
  EXPECT_NEAR(answer["flip"].get<double>(), sum / 2, 1e-12);
  // A picture of the answer compared by itself gives the view's figures.
  ASSERT_EQ(
      cli({"compare", at("out/view_01_a.png"), at("out/view_01_b.png"), "--report", at("r.json")}).status, 0);
  EXPECT_NEAR(figures()["flip"].get<double>(), answer["views"][1]["flip"].get<double>(), 1e-12);
  EXPECT_EQ(figures()["pixel_error"], answer["views"][1]["pixel_error"]);
}

/// A GLB holds local metres and does not say from where.
TEST_F(Compare, AModelInTheMetresOfTheFirstStandsWhereItStands) {
  const std::string model = town(folder_, 6);
  ASSERT_EQ(cli({"simplify", model, "--rate", "0", "-o", at("same.glb")}).status, 0);
  for (const auto& [a, b] : {std::pair(model, at("same.glb")), std::pair(at("same.glb"), model)}) {
    const Outcome outcome = compare(a, b);
    EXPECT_EQ(outcome.err.find("412"), std::string::npos) << outcome.err;
    EXPECT_LT(figures()["hausdorff_m"], 0.01);
  }
}

/// Colours alone are a difference, unless nobody asks for them.
TEST_F(Compare, PlainModelsDifferByTheirShapeAlone) {
  const auto wall = [&](const std::string& name, const std::string& colour) {
    writeText(folder_ / (name + ".mtl"), "newmtl paint\nKd " + colour + "\n");
    writeText(folder_ / (name + ".obj"),
              "mtllib " + name +
                  ".mtl\nv 0 0 0\nv 9 0 0\nv 9 0 6\nv 0 0 6\nv 5 7 0\nusemtl paint\nf 1 2 3 4\nf 1 2 5\n");
    return at(name + ".obj");
  };
  const std::string red = wall("red", "0.8 0.1 0.1");
  const std::string blue = wall("blue", "0.1 0.1 0.8");
  (void)compare(red, blue, {"--up-axis", "z"});
  EXPECT_GT(figures()["flip_shown"], 0.1);
  (void)compare(red, blue, {"--up-axis", "z", "--plain"});
  EXPECT_EQ(figures()["flip_shown"], 0);
}

TEST_F(Compare, ModelsThatStandApartAreSaid) {
  const std::string model = town(folder_, 4);
  Json moved = jsonOf(model);
  moved["transform"]["translate"][0] = moved["transform"]["translate"][0].get<double>() + 5000;
  writeText(folder_ / "moved.city.json", moved.dump());
  const Outcome outcome = compare(model, at("moved.city.json"));
  EXPECT_EQ(outcome.status, 3) << outcome.err;
  EXPECT_NE(outcome.err.find("412"), std::string::npos) << outcome.err;
  EXPECT_NEAR(figures()["hausdorff_m"].get<double>(), 5000, 500);
}

/// Two houses wall to wall; in the other model one stands a metre away, or is not there.
TEST_F(Compare, ContactsBetweenBuildingsAreFollowedByTheirNames) {
  const std::string touching = row("a.obj", 0, true);
  const Json same = contacts(touching, touching);
  EXPECT_EQ(same["contacts"], 1) << same;
  EXPECT_EQ(same["kept"], 1) << same;
  const Json gaping = contacts(touching, row("gap.obj", 1, true));
  EXPECT_EQ(gaping["separated"], 1) << gaping;
  EXPECT_NEAR(gaping["widest_gap_m"].get<double>(), 1, 1e-6) << gaping;
  EXPECT_EQ(contacts(touching, row("one.obj", 0, false))["lost"], 1);
}

/// OBJ has buildings as groups, and no parts of theirs: they are not lost.
TEST_F(Compare, PartsThatTheOtherFormatHasNotAreNotLost) {
  const std::string touching = row("a.obj", 0, true);
  ASSERT_EQ(cli({"convert", touching, "--up-axis", "z", "-o", at("a.city.json")}).status, 0);
  Json model = jsonOf(at("a.city.json"));
  model["CityObjects"]["left"]["type"] = "Building";
  model["CityObjects"]["left"].erase("parents");
  model["CityObjects"]["left"]["children"] = {"right"};
  model["CityObjects"]["right"]["parents"] = {"left"};
  model["CityObjects"].erase("a");
  writeText(folder_ / "parts.city.json", model.dump());
  ASSERT_EQ(cli({"simplify", at("parts.city.json"), "--rate", "0", "-o", at("whole.obj")}).status, 0);
  const Json followed = contacts(at("parts.city.json"), at("whole.obj"));
  EXPECT_EQ(followed["of"], "buildings") << followed;
  EXPECT_EQ(followed["lost"], 0) << followed;
}

TEST_F(Compare, AGlbIsSaidToNameNoBuildings) {
  const std::string touching = row("a.obj", 0, true);
  for (const char* name : {"a.city.json", "b.glb"})
    ASSERT_EQ(cli({"simplify", touching, "--up-axis", "z", "--rate", "0", "-o", at(name)}).status, 0);
  const Outcome outcome = compare(at("a.city.json"), at("b.glb"));
  EXPECT_TRUE(figures()["contacts"].is_null());
  EXPECT_NE(outcome.out.find("names none of the objects"), std::string::npos) << outcome.out;
}

/// Millimetres are coarse for a model of centimetres.
TEST_F(Compare, SmallModelsAreWrittenInSmallSteps) {
  const std::string small = row("a.obj", 0.37, true);
  const std::vector<std::string> read{"--up-axis", "z", "--unit", "0.0017"};
  std::vector<std::string> arguments{"simplify", small, "--rate", "0", "-o", at("a.city.json")};
  arguments.insert(arguments.end(), read.begin(), read.end());
  ASSERT_EQ(cli(arguments).status, 0);
  (void)compare(small, at("a.city.json"), read);
  EXPECT_LT(figures()["hausdorff_m"].get<double>(), 1e-8);
}

TEST_F(Compare, InterruptedLeavesNothing) {
  const std::string model = town(folder_);
  const Outcome outcome =
      cli({"compare", model, model, "--views", "1000", "--size", "256", "-o", at("cut")}, 900);
  EXPECT_EQ(outcome.status, 130) << outcome.err;
  for (const std::string& name : filesIn(folder_ / ""))
    EXPECT_EQ(name.find(".png"), std::string::npos) << name;
}

/// Surfaces without a material get a colour in a GLB, which is none of theirs.
TEST_F(Compare, AModelWithoutMaterialsLooksTheSameAsGlbAndObj) {
  const std::string model = town(folder_, 6);
  for (const char* name : {"same.glb", "same.obj"}) {
    ASSERT_EQ(cli({"simplify", model, "--rate", "0", "-o", at(name)}).status, 0);
    (void)compare(model, at(name));
    EXPECT_LT(figures()["flip_shown"].get<double>(), 1e-3) << name;
  }
}

/// What simplify writes has the parts that it read, with their names.
TEST_F(Compare, PartsOfASimplifiedModelAreFollowed) {
  const std::string touching = row("a.obj", 0, true);
  ASSERT_EQ(cli({"simplify", touching, "--up-axis", "z", "--rate", "0", "-o", at("a.city.json")}).status, 0);
  const Json same = contacts(touching, at("a.city.json"));
  EXPECT_EQ(same["objects_in_both"], 2) << same;
  EXPECT_EQ(same["kept"], 1) << same;
}

}  // namespace
}  // namespace lodestone::test
