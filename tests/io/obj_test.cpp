#include "model/io/meshes/obj.h"

#include <sstream>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "model/io/atomic_file.h"
#include "model/io/input_file.h"
#include "model/io/places/georeference.h"
#include "tests/support/chains.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

/// What an OBJ says, read as plainly as possible.
struct ParsedObj {
  std::vector<Vec3> vertices;
  std::size_t coordinates = 0;
  std::vector<std::string> groups;
  std::set<std::string> materials;
  double volume = 0;
  std::size_t faces = 0;

  explicit ParsedObj(const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
      std::istringstream words(line);
      std::string key;
      words >> key;
      if (key == "v") {
        Vec3 p;
        words >> p.x() >> p.y() >> p.z();
        vertices.push_back(p);
      } else if (key == "vt") {
        ++coordinates;
      } else if (key == "g") {
        words >> groups.emplace_back();
      } else if (key == "usemtl") {
        std::string name;
        words >> name;
        materials.insert(name);
      } else if (key == "f") {
        addFace(words);
      }
    }
  }

  void addFace(std::istringstream& words) {
    std::vector<std::size_t> corners;
    for (std::string word; words >> word;) {
      corners.push_back(std::stoul(word));
      EXPECT_GE(corners.back(), 1U);
      EXPECT_LE(corners.back(), vertices.size());
      const std::size_t slash = word.find('/');
      if (slash != std::string::npos) {
        EXPECT_LE(std::stoul(word.substr(slash + 1)), coordinates);
      }
    }
    ++faces;
    ASSERT_GE(corners.size(), 3U);
    for (std::size_t i = 2; i < corners.size(); ++i) {
      volume +=
          vertices[corners[0] - 1].dot(vertices[corners[i - 1] - 1].cross(vertices[corners[i] - 1])) / 6;
    }
  }
};

class ObjTest : public ::testing::Test {
 protected:
  fs::path folder = fs::path(::testing::TempDir()) /
                    (std::string("obj-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
      if (!entry.is_directory()) result.push_back(fs::relative(entry.path(), folder).generic_string());
    }
    std::sort(result.begin(), result.end());
    return result;
  }
};

TEST_F(ObjTest, HoldsEveryBuildingAsAClosedGroup) {
  const LodChain chain = test::rowOfHouses(1300);
  ASSERT_TRUE(objFormat().write(chain, folder / "row.obj", {{0}}, {}).ok());
  EXPECT_EQ(names(), (std::vector<std::string>{"row.mtl", "row.obj", "row.offset.json"}));
  const std::string text = readWholeFile(folder / "row.obj");
  const ParsedObj obj(text);
  ASSERT_EQ(obj.groups.size(), 1300U);
  EXPECT_EQ(obj.groups[12], "house%2012%25");
  double expected = 0;
  std::size_t faces = 0;
  for (const Building& b : chain.city->buildings) {
    expected += area(b.footprint) * b.height;
    faces += b.footprint[0].holes.empty() ? 6 : 8 + 16;
  }
  EXPECT_NEAR(obj.volume, expected, 1e-6 * expected);
  EXPECT_EQ(obj.faces, faces);
  const std::string mtl = readWholeFile(folder / "row.mtl");
  for (const std::string& name : obj.materials)
    EXPECT_NE(mtl.find("newmtl " + name + "\n"), std::string::npos);
  EXPECT_NE(text.find("z up"), std::string::npos);
  EXPECT_NE(text.find("# offset 389000.5 5820000.25 30\n"), std::string::npos);
  EXPECT_NE(text.find("# CRS ETRS89 / UTM zone 33N (EPSG:25833)\n# world = offset + v\n"), std::string::npos);
  const auto offset = nlohmann::json::parse(readWholeFile(folder / "row.offset.json"));
  EXPECT_EQ(offset["offset"][1], 5820000.25);
  EXPECT_EQ(offset["crs"]["epsg"], 25833);
  EXPECT_EQ(offset["crs"]["frame"], "offset");
}

TEST_F(ObjTest, SaysHowGeographicPlacesComeBack) {
  LodChain chain = test::rowOfHouses(1);
  auto city = std::make_shared<CityModel>(*chain.city);
  city->crs = resolveCrs("EPSG:4326");
  city->origin = Vec3(13.4, 52.5, 0);
  chain.city = city;
  ASSERT_TRUE(objFormat().write(chain, folder / "row.obj", {{0}}, {}).ok());
  const std::string proj = localProjection(city->crs, city->origin);
  ASSERT_NE(proj.find("+lat_0=52.5 +lon_0=13.4 "), std::string::npos);
  EXPECT_NE(readWholeFile(folder / "row.obj").find("# x and y of v are coordinates of " + proj),
            std::string::npos);
  const auto offset = nlohmann::json::parse(readWholeFile(folder / "row.offset.json"));
  EXPECT_EQ(offset["crs"]["proj"], proj);
}

TEST_F(ObjTest, ClustersNameTheirBuildings) {
  const auto result = objFormat().write(test::rowOfHouses(3), folder / "row.obj", {}, {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->files.size(), 6U);
  const std::string text = readWholeFile(folder / "row_level-1.obj");
  EXPECT_NE(text.find("# cluster house%200%25 house%201%25 house%202%25\ng cluster-99\n"), std::string::npos);
  EXPECT_NE(text.find("# landmark of cluster-99 house%200%25\ng house%200%25\n"), std::string::npos);
}

TEST_F(ObjTest, NumbersAreShortMillimetres) {
  LodChain chain = test::rowOfHouses(1);
  chain.levels[0].object = [](std::size_t) {
    return test::blockObject("a", test::square(-1e-9, 0.1234567, 10), 0, 5);
  };
  ASSERT_TRUE(objFormat().write(chain, folder / "a.obj", {{0}}, {}).ok());
  EXPECT_NE(readWholeFile(folder / "a.obj").find("v 0 0.123 0\n"), std::string::npos);
}

TEST_F(ObjTest, TexturesAreCopiedAndNamedByRelativePaths) {
  writeFile(folder / "in" / "fa cade.png", "pixels");
  LodChain chain = test::rowOfHouses(1);
  auto city = std::make_shared<CityModel>(*chain.city);
  city->textures = {{(folder / "in" / "fa cade.png").string(), false, "", ""},
                    {(folder / "in" / "gone.png").string(), true, "", ""}};
  chain.city = city;
  chain.levels[0].object = [](std::size_t) {
    LevelObject object = test::blockObject("a", test::square(0, 0, 10), 0, 5);
    Geometry& g = object.geometries[0];
    g.textureCoordinates.assign(g.ringVertices.size(), Vec2f(0.25F, 0.75F));
    g.surfaces[1].texture = 0;
    g.surfaces[2].texture = 1;
    return object;
  };
  ASSERT_TRUE(objFormat().write(chain, folder / "a.obj", {{0}}, {}).ok());
  EXPECT_EQ(readWholeFile(folder / "a_textures" / "0_fa%20cade.png"), "pixels");
  EXPECT_NE(readWholeFile(folder / "a.mtl").find("map_Kd a_textures/0_fa%20cade.png\n"), std::string::npos);
  const ParsedObj obj(readWholeFile(folder / "a.obj"));
  EXPECT_EQ(obj.coordinates, 24U);
  EXPECT_TRUE(obj.materials.contains("texture-0"));
  EXPECT_FALSE(obj.materials.contains("texture-1"));
}

TEST_F(ObjTest, ATextureThatItCannotMirrorIsTold) {
  writeFile(folder / "wall.png", "pixels");
  LodChain chain = test::rowOfHouses(1);
  auto city = std::make_shared<CityModel>(*chain.city);
  chain.city = city;
  for (const std::string wrap : {"", "wrap", "mirror", "clamp"}) {
    city->textures = {{(folder / "wall.png").string(), false, wrap, ""}};
    const auto report = objFormat().write(chain, folder / "a.obj", {{0}}, {});
    EXPECT_EQ(report.diagnostics.size(), wrap == "mirror" ? 1U : 0U) << wrap;
  }
}

// Few files are open at a time, however many belong together.
TEST_F(ObjTest, ManyTexturesNeedFewDescriptors) {
  constexpr std::size_t kTextures = 100;
  constexpr rlim_t kDescriptors = 40;
  LodChain chain = test::rowOfHouses(1);
  auto city = std::make_shared<CityModel>(*chain.city);
  for (std::size_t i = 0; i < kTextures; ++i) {
    const fs::path image = folder / "in" / (std::to_string(i) + ".png");
    writeFile(image, "pixels");
    city->textures.push_back({image.string(), false, "", ""});
  }
  chain.city = city;
  chain.levels[0].object = [&](std::size_t) {
    LevelObject object = test::blockObject("a", test::square(0, 0, 10), 0, 5);
    const Geometry plain = object.geometries[0];
    object.geometries.assign(kTextures, plain);
    object.triangles.resize(kTextures, object.triangles[0]);
    for (std::size_t i = 0; i < kTextures; ++i) {
      object.geometries[i].textureCoordinates.assign(plain.ringVertices.size(), Vec2f(0, 0));
      object.geometries[i].surfaces[1].texture = static_cast<std::int32_t>(i);
    }
    return object;
  };
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit few{kDescriptors, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &few), 0);
  const Result<WriteReport> report = objFormat().write(chain, folder / "a.obj", {{0}}, {});
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  ASSERT_TRUE(report.ok()) << lodestone::format(report.diagnostics.front());
  EXPECT_EQ(report->files.size(), kTextures + 3);
}

TEST_F(ObjTest, TheSameBytesForAnyNumberOfThreads) {
  const LodChain chain = test::rowOfHouses(3000);
  std::string first;
  for (int threads : {1, 2, 8}) {
    const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] { ASSERT_TRUE(objFormat().write(chain, folder / "t.obj", {{0}}, {}).ok()); });
    const std::string bytes = readWholeFile(folder / "t.obj");
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first);
  }
}

TEST_F(ObjTest, FailsWithoutATrace) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      (void)objFormat().write(test::rowOfHouses(2), folder / "a.obj", {}, Progress({}, stop.get_token())),
      Cancelled);
  EXPECT_FALSE(objFormat().write(test::rowOfHouses(2), folder / "a.obj", {{2}}, {}).ok());
  EXPECT_TRUE(names().empty());
}

}  // namespace
}  // namespace lodestone
