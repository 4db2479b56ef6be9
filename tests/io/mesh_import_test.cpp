#include "model/io/meshes/mesh_import.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "model/io/atomic_file.h"
#include "model/io/meshes/ply.h"
#include "tests/support/run_program.h"

namespace lodestone {
namespace {

using test::TemporaryFolder;

constexpr const char* kTwoGroups =
    "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n"
    "g wall\nf 1 2 3\n"
    "g roof\nf 1 2 4\nf 2 3 4\n";

Result<CityModel> readText(const TemporaryFolder& folder, const std::string& name, const std::string& text,
                           const ImportOptions& options = {}) {
  writeFile(folder / name, text);
  return readMesh(folder / name, options, {});
}

bool says(const Diagnostics& diagnostics, Code code) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [&](const Diagnostic& d) { return d.code == code; });
}

TEST(MeshImport, GroupsStayApartAsParts) {
  const TemporaryFolder folder;
  const Result<CityModel> city = readText(folder, "house.obj", kTwoGroups);
  ASSERT_TRUE(city.ok());
  ASSERT_EQ(city->buildings.size(), 1U);
  const CityObject& house = city->buildings.front().object;
  EXPECT_EQ(house.id, "house");
  ASSERT_EQ(house.children.size(), 2U);
  EXPECT_EQ(house.children[0].id, "wall");
  EXPECT_EQ(house.children[0].geometries.front().surfaceCount(), 1U);
  EXPECT_EQ(house.children[1].geometries.front().surfaceCount(), 2U);
}

TEST(MeshImport, ObjNamesGoOnToTheEndOfTheirLine) {
  const TemporaryFolder folder;
  std::string text;
  std::vector<std::string> names{"Wall Süd", "Wall Nord", "Wall", "Ground slab.001", "groß o g"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string end = i % 2 == 0 ? "\n" : " \r\n";
    text += (i == 3 ? "g  " : "o ") + names[i] + end;
    for (int k = 0; k < 3; ++k)
      text += "v " + std::to_string(i) + " " + std::to_string(k) + " " + std::to_string(k * k) + end;
    text += "usemtl two words" + end + "f -1 -2 -3" + end;
  }
  const Result<CityModel> city = readText(folder, "named.obj", text);
  ASSERT_TRUE(city.ok());
  std::vector<std::string> found;
  for (const CityObject& object : city->buildings.front().object.children) {
    found.push_back(object.id);
    EXPECT_EQ(object.geometries.front().surfaceCount(), 1U) << object.id;
  }
  EXPECT_EQ(found, names);
}

TEST(MeshImport, UpIsWhatIsSaidElseAssumedAndTold) {
  const TemporaryFolder folder;
  const Result<CityModel> assumed = readText(folder, "house.obj", kTwoGroups);
  EXPECT_TRUE(says(assumed.diagnostics, Code::UpAxisAssumed));
  EXPECT_NEAR(bounds(*assumed).size().z(), 2, 1e-6);  // OBJ: y is up
  const Result<CityModel> said =
      readText(folder, "house.obj", kTwoGroups, {.upAxis = UpAxisOption::Z, .unit = 0.5});
  EXPECT_FALSE(says(said.diagnostics, Code::UpAxisAssumed));
  EXPECT_NEAR(bounds(*said).size().z(), 1.5, 1e-6);
}

TEST(MeshImport, PolygonFilesAreTheSameInEveryEncoding) {
  const std::filesystem::path corpus = LODESTONE_SOURCE_DIR "/tests/fuzz/corpus/ply";
  const Result<CityModel> text = readMesh(corpus / "box_ascii.ply", {}, {});
  ASSERT_TRUE(text.ok());
  const Geometry& box = text->buildings.front().object.children.front().geometries.front();
  EXPECT_EQ(box.surfaceCount(), 6U);  // quads stay quads
  EXPECT_EQ(box.vertices.back(), Vec3(1, 1, 1));
  for (const char* name : {"box_little.ply", "box_big.ply"}) {
    const Result<CityModel> binary = readMesh(corpus / name, {}, {});
    ASSERT_TRUE(binary.ok()) << name;
    const Geometry& same = binary->buildings.front().object.children.front().geometries.front();
    EXPECT_EQ(same.vertices, box.vertices) << name;
    EXPECT_EQ(same.ringVertices, box.ringVertices) << name;
  }
}

TEST(MeshImport, PolygonFilesKeepTextureCoordinatesOfCornersAndVertices) {
  const PlyMesh mesh = parsePly(test::readText(LODESTONE_SOURCE_DIR "/tests/fuzz/corpus/ply/textured.ply"));
  EXPECT_EQ(mesh.texture, "wall.png");
  EXPECT_EQ(mesh.vertexCoordinates.at(1), Vec2f(1, 0));
  ASSERT_EQ(mesh.cornerCoordinates.size(), 6U);
  EXPECT_FALSE(mesh.cornerCoordinates[2].allFinite());
  EXPECT_EQ(mesh.cornerCoordinates[4], Vec2f(0.5F, 0));
}

TEST(MeshImport, CornersThatLeadNowhereAreToldAndLeftOut) {
  const TemporaryFolder folder;
  const Result<CityModel> city = readText(
      folder, "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 2\nproperty list uchar int vertex_indices\nend_header\n"
      "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 3\n");
  ASSERT_TRUE(city.ok());
  EXPECT_TRUE(says(city.diagnostics, Code::CoordinateBad));
}

TEST(MeshImport, FilesThatAreCutOffEndWithAnAnswer) {
  const TemporaryFolder folder;
  const std::string off = "OFF\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2\n4 0 1 2 3\n";
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
      "endsolid a\n";
  for (const auto& [name, text] :
       {std::pair("a.off", off), {"a.stl", stl}, {"a.obj", std::string(kTwoGroups)}}) {
    for (std::size_t size = 0; size < text.size(); ++size) {
      const Result<CityModel> city = readText(folder, name, text.substr(0, size));
      EXPECT_TRUE(city.ok() || hasErrors(city.diagnostics));
    }
  }
}

TEST(MeshImport, AFileThatIsNoMeshIsRefused) {
  const TemporaryFolder folder;
  EXPECT_FALSE(readText(folder, "a.ply", "ply\nformat ascii 1.0\nelement vertex 3\n").ok());
  EXPECT_FALSE(readText(folder, "old.gltf", R"({"asset": {"version": "1.0"}})").ok());
  EXPECT_FALSE(
      readText(folder, "index.dae", "<COLLADA><mesh><triangles><p>0 1.5 2</p></triangles></mesh></COLLADA>")
          .ok());
  EXPECT_FALSE(readText(folder, "points.obj", "v 0 0 0\nv 1 1 1\n").ok());
}

}  // namespace
}  // namespace lodestone
