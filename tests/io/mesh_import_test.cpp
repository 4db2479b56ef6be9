#include "model/io/meshes/mesh_import.h"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "model/io/atomic_file.h"
#include "model/io/meshes/glb.h"
#include "model/io/meshes/obj.h"
#include "model/io/meshes/ply.h"
#include "tests/support/chains.h"
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

/// How the textures of a box's walls go on, as a file of one level brings them back: wall `i` has texture i,
/// whose image is that of all the others.
std::vector<std::string> wrapsThatComeBack(const TemporaryFolder& folder, const Format& format,
                                           const std::string& name, const std::vector<std::string>& wraps) {
  writeFile(folder / "wall.png", "\x89PNG\r\n\x1a\n not really a picture");
  LodChain chain = test::rowOfHouses(1);
  auto city = std::make_shared<CityModel>(*chain.city);
  for (const std::string& wrap : wraps)
    city->textures.push_back({(folder / "wall.png").string(), false, wrap, ""});
  chain.city = city;
  chain.levels[0].object = [&](std::size_t) {
    LevelObject object = test::blockObject("a", test::square(0, 0, 10), 0, 5);
    Geometry& g = object.geometries[0];
    g.textureCoordinates.assign(g.ringVertices.size(), Vec2f(0.25F, 2.75F));
    for (std::size_t i = 0; i < wraps.size(); ++i) g.surfaces[i + 1].texture = static_cast<std::int32_t>(i);
    return object;
  };
  EXPECT_TRUE(format.write(chain, folder / name, {{0}}, {}).ok());
  const Result<CityModel> back = readMesh(folder / name, {}, {});
  std::set<std::int32_t> used;
  std::vector<std::string> found;
  for (const CityObject& object : back->buildings.front().object.children) {
    for (const SurfaceInfo& surface : object.geometries.front().surfaces) {
      if (surface.texture >= 0 && used.insert(surface.texture).second)
        found.push_back(back->textures[static_cast<std::size_t>(surface.texture)].wrap);
    }
  }
  return found;
}

TEST(MeshImport, GlbBringsBackHowTexturesGoOn) {
  const TemporaryFolder folder;
  using Words = std::vector<std::string>;
  EXPECT_EQ(wrapsThatComeBack(folder, glbFormat(), "all.glb", {"wrap", "mirror", "clamp"}),
            (Words{"wrap", "mirror", "clamp"}));
  EXPECT_EQ(wrapsThatComeBack(folder, glbFormat(), "less.glb", {"", "border", "none"}),
            (Words{"wrap", "clamp", "clamp"}));
}

TEST(MeshImport, ObjTellsTexturesThatEndFromThoseThatGoOn) {
  const TemporaryFolder folder;
  EXPECT_EQ(wrapsThatComeBack(folder, objFormat(), "all.obj", {"wrap", "clamp"}),
            (std::vector<std::string>{"", "clamp"}));
}

/// As Maya's and Blender's exporters write it.
std::string colladaThatSays(const std::string& wrapping) {
  return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><up_axis>Z_UP</up_axis></asset>
<library_images><image id="i"><init_from>wall.png</init_from></image></library_images>
<library_effects><effect id="e"><profile_COMMON>
<newparam sid="s"><surface type="2D"><init_from>i</init_from></surface></newparam>
<newparam sid="m"><sampler2D><source>s</source></sampler2D></newparam>
<technique sid="t"><lambert><diffuse><texture texture="m" texcoord="UV">)" +
         wrapping + R"(</texture></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="wall" name="wall"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 1 0</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<source id="u"><float_array id="ua" count="6">0 0 2 0 0 2</float_array><technique_common>
<accessor source="#ua" count="3" stride="2"><param name="S" type="float"/><param name="T" type="float"/>
</accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles material="wall" count="1"><input semantic="VERTEX" source="#v" offset="0"/>
<input semantic="TEXCOORD" source="#u" offset="1" set="0"/><p>0 0 1 1 2 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="scene"><node id="n"><instance_geometry url="#g"><bind_material>
<technique_common><instance_material symbol="wall" target="#wall"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#scene"/></scene></COLLADA>)";
}

TEST(MeshImport, ColladaSaysHowTexturesGoOnWhereMayaWroteIt) {
  const TemporaryFolder folder;
  const auto wrapOf = [&](const std::string& u, const std::string& v) {
    const std::string wrapping = R"(<extra><technique profile="MAYA">)" + u + v + "</technique></extra>";
    const Result<CityModel> city = readText(folder, "wall.dae", colladaThatSays(wrapping));
    return city.ok() && city->textures.size() == 1 ? city->textures.front().wrap : "no texture";
  };
  const std::string no = "<wrapU>0</wrapU>";
  EXPECT_EQ(wrapOf("", ""), "wrap");
  EXPECT_EQ(wrapOf(no, "<wrapV>0</wrapV>"), "clamp");
  EXPECT_EQ(wrapOf("<mirrorU>1</mirrorU>", "<mirrorV>1</mirrorV>"), "mirror");
  EXPECT_EQ(wrapOf(no, ""), "wrap") << "along one axis it goes on";
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
