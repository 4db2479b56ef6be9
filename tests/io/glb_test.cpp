#include "model/io/meshes/glb.h"

#include <fstream>

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "model/io/atomic_file.h"
#include "model/io/input_file.h"
#include "tests/support/chains.h"
#include "tests/support/glb.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;

class GlbTest : public ::testing::Test {
 protected:
  fs::path folder = fs::path(::testing::TempDir()) /
                    (std::string("glb-") + ::testing::UnitTest::GetInstance()->current_test_info()->name());
  void SetUp() override {
    fs::remove_all(folder);
    fs::create_directories(folder);
  }
  void TearDown() override { fs::remove_all(folder); }

  test::Glb write(const LodChain& chain, std::size_t level = 0) {
    const fs::path path = folder / "out.glb";
    const auto result = glbFormat().write(chain, path, {{level}}, {});
    EXPECT_TRUE(result.ok());
    test::Glb glb(readWholeFile(path));
    glb.expectSound();
    return glb;
  }
  std::vector<std::string> names() const {
    std::vector<std::string> result;
    for (const auto& entry : fs::directory_iterator(folder))
      result.push_back(entry.path().filename().string());
    std::sort(result.begin(), result.end());
    return result;
  }
};

const nlohmann::json& tableOf(const test::Glb& glb) {
  return glb.json["extensions"]["EXT_structural_metadata"]["propertyTables"][0];
}

TEST_F(GlbTest, EveryTriangleIsThereYUpAndFacingOut) {
  const LodChain chain = test::rowOfHouses(1300);  // several blocks of objects
  const test::Glb glb = write(chain);
  EXPECT_GT(glb.json["meshes"].size(), 2U);
  double volume = 0;
  Box3 box;
  for (const auto& node : glb.json["nodes"]) {
    const auto& t = node["translation"];
    for (const auto& p : glb.json["meshes"][node["mesh"].get<std::size_t>()]["primitives"]) {
      const std::size_t position = p["attributes"]["POSITION"];
      const std::size_t normal = p["attributes"]["NORMAL"];
      const std::size_t indices = p["indices"];
      const auto corner = [&](std::size_t i) {
        const auto v = static_cast<std::size_t>(glb.number(indices, i));
        return Vec3(glb.number(position, v, 0) + t[0].get<double>(),
                    glb.number(position, v, 1) + t[1].get<double>(),
                    glb.number(position, v, 2) + t[2].get<double>());
      };
      for (std::size_t i = 0; i < glb.json["accessors"][indices]["count"]; i += 3) {
        const Vec3 a = corner(i), b = corner(i + 1), c = corner(i + 2);
        const auto v = static_cast<std::size_t>(glb.number(indices, i));
        const Vec3 n(glb.number(normal, v, 0), glb.number(normal, v, 1), glb.number(normal, v, 2));
        EXPECT_GT((b - a).cross(c - a).normalized().dot(n), 0.9999);
        volume += a.dot(b.cross(c)) / 6;
        for (const Vec3& corner3 : {a, b, c}) box.add(corner3);
      }
    }
  }
  double expected = 0;
  for (const Building& b : chain.city->buildings) expected += area(b.footprint) * b.height;
  EXPECT_NEAR(volume, expected, 1e-4 * expected);
  EXPECT_NEAR((box.min - Vec3(0, 3, -15)).norm(), 0, 1e-3);
  EXPECT_NEAR((box.max - Vec3(20 * 1299 + 10, 12, -5)).norm(), 0, 1e-3);
}

TEST_F(GlbTest, PropertyTableNamesBuildingsAndTheirAttributes) {
  const LodChain chain = test::rowOfHouses(7);
  const test::Glb glb = write(chain);
  const auto& table = tableOf(glb);
  ASSERT_EQ(table["count"], 7U);
  const auto& columns = table["properties"];
  const auto& schema =
      glb.json["extensions"]["EXT_structural_metadata"]["schema"]["classes"]["object"]["properties"];
  for (const auto& [name, column] : columns.items()) EXPECT_TRUE(schema.contains(name)) << name;
  EXPECT_EQ(columns.size(), schema.size());
  EXPECT_EQ(glb.texts(columns["id"])[3], "house 3%");
  EXPECT_EQ(glb.texts(columns["buildings"])[3], "house 3%");
  EXPECT_EQ(glb.values<double>(columns["height"]["values"])[2], 8);
  EXPECT_EQ(glb.values<std::uint32_t>(columns["node"]["values"])[6], 6U);
  EXPECT_EQ(glb.values<double>(columns["storeys"]["values"])[4], 4);
  EXPECT_EQ(schema["first_name"]["name"], "first name");
  EXPECT_EQ(glb.texts(columns["first_name"])[2], "Jürgen");
  EXPECT_EQ(glb.texts(columns["first_name"])[1], "An\xEF\xBF\xBD");
  EXPECT_EQ(glb.values<double>(columns["roof_height"]["values"])[3], 4.5);
  EXPECT_EQ(glb.values<double>(columns["roof_height"]["values"])[1],
            schema["roof_height"]["noData"].get<double>());
}

TEST_F(GlbTest, ClustersLeadBackToTheirBuildings) {
  const LodChain chain = test::rowOfHouses(7);
  const test::Glb glb = write(chain, 1);
  const auto& columns = tableOf(glb)["properties"];
  EXPECT_EQ(glb.values<std::uint8_t>(columns["role"]["values"]),
            (std::vector<std::uint8_t>{static_cast<std::uint8_t>(DrawRole::Cluster),
                                       static_cast<std::uint8_t>(DrawRole::Landmark)}));
  EXPECT_EQ(glb.values<std::uint32_t>(columns["buildings"]["arrayOffsets"]),
            (std::vector<std::uint32_t>{0, 7, 8}));
  const auto ids = glb.texts(columns["buildings"]);
  ASSERT_EQ(ids.size(), 8U);
  EXPECT_EQ(ids[6], "house 6%");
  EXPECT_EQ(ids[7], "house 0%");
  EXPECT_EQ(glb.values<std::uint32_t>(columns["of"]["values"]), (std::vector<std::uint32_t>{kNoNode, 99}));
  EXPECT_EQ(glb.values<double>(columns["negative"]["values"])[0], 42);
  const auto& extras = glb.json["asset"]["extras"]["lodestone"];
  EXPECT_EQ(extras["origin"][0], 389000.5);
  EXPECT_EQ(extras["crs"]["epsg"], 25833);
  EXPECT_EQ(extras["crs"]["frame"], "offset");
  EXPECT_EQ(extras["crs"]["unit"], 1);
  EXPECT_EQ(extras["recipe"]["type"], "recipe");
}

TEST_F(GlbTest, SeveralLevelsAreSeveralFiles) {
  const auto result = glbFormat().write(test::rowOfHouses(3), folder / "row.glb", {}, {});
  ASSERT_TRUE(result.ok());
  EXPECT_EQ(result->files, (std::vector<fs::path>{folder / "row_level-0.glb", folder / "row_level-1.glb"}));
  EXPECT_EQ(names(), (std::vector<std::string>{"row_level-0.glb", "row_level-1.glb"}));
}

TEST_F(GlbTest, TheSameBytesForAnyNumberOfThreads) {
  const LodChain chain = test::rowOfHouses(3000);
  std::string first;
  for (int threads : {1, 2, 8}) {
    const tbb::global_control workers(tbb::global_control::max_allowed_parallelism,
                                      static_cast<std::size_t>(threads));
    tbb::task_arena arena(threads);
    arena.execute([&] { ASSERT_TRUE(glbFormat().write(chain, folder / "t.glb", {{0}}, {}).ok()); });
    const std::string bytes = readWholeFile(folder / "t.glb");
    if (first.empty()) first = bytes;
    EXPECT_TRUE(bytes == first);
  }
}

TEST_F(GlbTest, NothingToDrawIsStillAFile) {
  LodChain chain = test::rowOfHouses(2);
  chain.levels[0].object = [](std::size_t i) {
    LevelObject object;
    object.id = std::to_string(i);
    return object;
  };
  EXPECT_FALSE(write(chain).json.contains("meshes"));
  chain.levels[0].objectCount = 0;
  EXPECT_FALSE(write(chain).json.contains("buffers"));
}

TEST_F(GlbTest, TexturesAreEmbeddedOnceAndOnlyWhereTheyCanBe) {
  const std::string png = "\x89PNG\r\n\x1a\n not really a picture";
  writeFile(folder / "facade.png", png);
  writeFile(folder / "facade.bmp", "BM");
  LodChain chain = test::rowOfHouses(2);
  auto city = std::make_shared<CityModel>(*chain.city);
  city->textures = {{(folder / "facade.png").string(), false, "mirror", ""},
                    {(folder / "facade.bmp").string(), false, "", ""},
                    {(folder / "gone.png").string(), true, "", ""}};
  city->materials.push_back({"brick", {0.6F, 0.3F, 0.2F}, 0.25F, ""});
  chain.city = city;
  chain.levels[0].object = [](std::size_t i) {
    LevelObject object = test::blockObject(std::to_string(i), test::square(0, 0, 10), 0, 5);
    Geometry& g = object.geometries[0];
    g.textureCoordinates.assign(g.ringVertices.size(), Vec2f(0.25F, 0.75F));
    for (std::size_t s = 1; s < 4; ++s) g.surfaces[s].texture = static_cast<std::int32_t>(s - 1);
    g.surfaces[4].texture = 0;
    g.textureCoordinates[g.ringStart[g.surfaceStart[4]]] =
        Vec2f::Constant(std::numeric_limits<float>::quiet_NaN());
    g.surfaces[5].material = 0;
    return object;
  };
  const test::Glb glb = write(chain);
  ASSERT_EQ(glb.json["images"].size(), 1U);
  EXPECT_EQ(glb.json["images"][0]["mimeType"], "image/png");
  EXPECT_EQ(glb.view(glb.json["images"][0]["bufferView"]), png);
  EXPECT_EQ(glb.json["samplers"][0]["wrapS"], 33648);
  std::size_t textured = 0;
  bool brick = false;
  for (const auto& p : glb.json["meshes"][0]["primitives"]) {
    brick =
        brick || glb.json["materials"][p["material"].get<std::size_t>()].value("alphaMode", "") == "BLEND";
    if (!p["attributes"].contains("TEXCOORD_0")) continue;
    const std::size_t accessor = p["attributes"]["TEXCOORD_0"];
    textured += glb.json["accessors"][accessor]["count"].get<std::size_t>();
    EXPECT_EQ(glb.number(accessor, 0, 0), 0.25);
    EXPECT_EQ(glb.number(accessor, 0, 1), 0.25);
  }
  EXPECT_EQ(textured, 8U);  // one wall of each building
  EXPECT_TRUE(brick);
}

TEST_F(GlbTest, IsNotNamedAsTheTextForm) {
  const auto result = glbFormat().write(test::rowOfHouses(2), folder / "a.gltf", {}, {});
  ASSERT_FALSE(result.ok());
  EXPECT_EQ(result.diagnostics[0].code, Code::OutputFormatUnknown);
  EXPECT_TRUE(names().empty());
}

TEST_F(GlbTest, FailsWithoutATrace) {
  writeFile(folder / "file", "x");
  const auto below = glbFormat().write(test::rowOfHouses(2), folder / "file" / "a.glb", {{0}}, {});
  ASSERT_FALSE(below.ok());
  EXPECT_EQ(below.diagnostics[0].code, Code::OutputUnwritable);
  const auto level = glbFormat().write(test::rowOfHouses(2), folder / "a.glb", {{7}}, {});
  ASSERT_FALSE(level.ok());
  EXPECT_EQ(level.diagnostics[0].code, Code::OptionOutOfRange);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW(
      (void)glbFormat().write(test::rowOfHouses(2), folder / "a.glb", {}, Progress({}, stop.get_token())),
      Cancelled);
  EXPECT_EQ(names(), std::vector<std::string>{"file"});
}

}  // namespace
}  // namespace lodestone
