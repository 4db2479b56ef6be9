// Images on their way through the program.
#include <array>
#include <cstring>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace lodestone::test {
namespace {

namespace fs = std::filesystem;

std::string base64(const std::string& bytes) {
  constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      text += i + k > bytes.size() ? '=' : kDigits[three >> (18 - 6 * k) & 63U];
  }
  return text;
}

/// A wall of two triangles that leans with the image inside the file.
std::string texturedWall(const std::string& image) {
  const std::array<float, 20> numbers{0, 0, 0, 4, 0, 0, 4, 3, 1, 0, 3, 1, 0, 1, 1, 1, 1, 0, 0, 0};
  const std::array<std::uint16_t, 6> corners{0, 1, 2, 0, 2, 3};
  std::string bytes(sizeof(numbers) + sizeof(corners), '\0');
  std::memcpy(bytes.data(), numbers.data(), sizeof(numbers));
  std::memcpy(bytes.data() + sizeof(numbers), corners.data(), sizeof(corners));
  nlohmann::json json = nlohmann::json::parse(R"({
    "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "name": "wall"}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "indices": 2, "material": 0}]}],
    "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}}}],
    "textures": [{"source": 0}],
    "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 48},
                    {"buffer": 0, "byteOffset": 48, "byteLength": 32},
                    {"buffer": 0, "byteOffset": 80, "byteLength": 12}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [4, 3, 1]},
                  {"bufferView": 1, "componentType": 5126, "count": 4, "type": "VEC2"},
                  {"bufferView": 2, "componentType": 5123, "count": 6, "type": "SCALAR"}]})");
  json["buffers"] = {
      {{"byteLength", bytes.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes)}}};
  json["images"] = {{{"uri", "data:image/png;base64," + base64(image)}}};
  return json.dump();
}

bool holds(const fs::path& file, const std::string& bytes) {
  return readText(file).find(bytes) != std::string::npos;
}

TEST(CliTextures, ImagesInsideAFileGoOnToEveryFormat) {
  const std::string image = std::string("\x89PNG\r\n\x1a\n", 8) + "the image itself";
  const TemporaryFolder folder;
  writeText(folder / "wall.gltf", texturedWall(image));
  std::string input = (folder / "wall.gltf").string();
  for (const std::string name : {"a.glb", "b.glb", "c.obj", "d.city.json"}) {  // b.glb is of what a.glb holds
    const std::string output = (folder / name).string();
    const Outcome outcome =
        runProgram({LODESTONE_CLI, "simplify", input, "--rate", "0", "-o", output, "--up-axis", "auto"});
    ASSERT_EQ(outcome.status, 0) << name << outcome.err;
    if (name == "a.glb") input = output;
    if (name.ends_with(".glb")) {
      EXPECT_TRUE(holds(output, image)) << name;
    }
  }
  for (const std::string images : {"c_textures", "d.textures"}) {
    ASSERT_TRUE(fs::is_directory(folder / images)) << images;
    const fs::path copy = fs::directory_iterator(folder / images)->path();
    EXPECT_EQ(readText(copy), image) << copy;
    EXPECT_EQ(copy.extension(), ".png");
    const std::string namedIn = images == "c_textures" ? "c.mtl" : "d.city.json";
    EXPECT_TRUE(holds(folder / namedIn, fs::relative(copy, folder.path()).generic_string())) << namedIn;
  }
}

TEST(CliTextures, AnImageThatGltfCannotHoldIsTold) {
  const TemporaryFolder folder;
  writeText(folder / "wall.obj",
            "mtllib wall.mtl\nv 0 0 0\nv 4 0 0\nv 4 3 1\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl m\nf 1/1 2/2 3/3\n");
  writeText(folder / "wall.mtl", "newmtl m\nmap_Kd brick.tga\n");
  writeText(folder / "brick.tga", "no PNG");
  const auto convert = [&](const std::string& output) {
    return runProgram(
        {LODESTONE_CLI, "convert", (folder / "wall.obj").string(), "-o", (folder / output).string()});
  };
  EXPECT_THAT(convert("wall.glb").err, testing::HasSubstr("neither PNG nor JPEG"));
  EXPECT_THAT(convert("wall2.obj").err, testing::Not(testing::HasSubstr("neither PNG nor JPEG")));
  EXPECT_EQ(readText(folder / "wall2_textures/0_brick.tga"), "no PNG");
}

}  // namespace
}  // namespace lodestone::test
