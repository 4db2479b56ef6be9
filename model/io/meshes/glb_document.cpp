#include "model/io/meshes/glb_document.h"

#include <algorithm>
#include <limits>
#include <system_error>

#include "model/io/json_writing.h"
#include "model/io/texture_image.h"
#include "model/level_colours.h"

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;

// Numbers of the glTF 2.0 specification.
constexpr int kFloat = 5126;
constexpr int kUnsignedShort = 5123;
constexpr int kUnsignedInt = 5125;
constexpr int kVertexBuffer = 34962;
constexpr int kIndexBuffer = 34963;
constexpr std::uint32_t kMagic = 0x46546C67;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
/// The largest index is reserved for restarting primitives.
constexpr std::size_t kShortIndices = 65535;

std::string_view imageType(const std::string& head) {
  if (head.starts_with("\x89PNG\r\n\x1a\n")) return "image/png";
  if (head.starts_with("\xFF\xD8\xFF")) return "image/jpeg";
  return {};
}

int wrapMode(const std::string& wrap) {
  if (wrap == "mirror") return 33648;
  if (wrap == "clamp" || wrap == "border" || wrap == "none") return 33071;
  return 10497;
}

template <class Value>
std::string_view bytesOf(const std::vector<Value>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(Value)};
}

void write32(std::ostream& out, std::uint64_t value) {
  for (int i = 0; i < 4; ++i) out.put(static_cast<char>((value >> (8 * i)) & 0xFFU));
}

template <class Vector>
std::string join(const Vector& vector) {
  std::string text;
  for (const float x : vector) text += fmt::format("{}{}", text.empty() ? "" : ",", static_cast<double>(x));
  return text;
}

}  // namespace

std::size_t GlbDocument::Items::add(std::string_view item) {
  if (count > 0) text.push_back(',');
  text.append(item.data(), item.data() + item.size());
  return count++;
}

bool glbHoldsImage(const Texture& texture) {
  return !imageType(readImageHead(texture, 16)).empty();
}

GlbDocument::GlbDocument(std::shared_ptr<const CityModel> city, const std::filesystem::path& path)
    : city_(std::move(city)), spool_(path.string() + ".bin") {
  if (!city_) return;
  for (const Texture& texture : city_->textures) {
    usableTextures_.push_back(glbHoldsImage(texture));
  }
}

void GlbDocument::pad(std::size_t alignment) {
  while (size_ % alignment != 0) {
    spool_.stream().put('\0');
    ++size_;
  }
}

// Views start at multiples of 8, as property tables need it.
std::size_t GlbDocument::addView(std::string_view bytes, const std::string& more) {
  pad(8);
  const std::uint64_t offset = size_;
  if (bytes.empty()) bytes = std::string_view("\0", 1);  // a view cannot be empty
  spool_.stream().write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  size_ += bytes.size();
  return views_.add(
      fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}{}}})", offset, size_ - offset, more));
}

bool GlbDocument::addMesh(const GlbMesh& mesh) {
  if (!mesh.primitives.empty()) {
    addPrimitives(mesh);
    nodes_.add(fmt::format(R"({{"mesh":{},"translation":[{},{},{}]}})", meshes_.count - 1, mesh.origin.x(),
                           mesh.origin.z(), 0 - mesh.origin.y()));
  }
  return spool_.stream().good();
}

template <class Vector>
std::size_t GlbDocument::addVectors(std::size_t view, std::size_t offset, const std::vector<Vector>& values,
                                    bool withBounds) {
  std::string range;
  if (withBounds) {
    Vector low = values.front();
    Vector high = low;
    for (const Vector& v : values) {
      low = low.cwiseMin(v);
      high = high.cwiseMax(v);
    }
    range = fmt::format(R"(,"min":[{}],"max":[{}])", join(low), join(high));
  }
  return accessors_.add(
      fmt::format(R"({{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"VEC{}"{}}})",
                  view, offset, kFloat, values.size(), Vector::SizeAtCompileTime, range));
}

std::size_t GlbDocument::addIndices(const GlbPrimitive& primitive) {
  const bool isShort = primitive.positions.size() <= kShortIndices;
  const std::vector<std::uint16_t> narrow(isShort ? primitive.indices.begin() : primitive.indices.end(),
                                          primitive.indices.end());
  const std::size_t view = addView(isShort ? bytesOf(narrow) : bytesOf(primitive.indices),
                                   fmt::format(R"(,"target":{})", kIndexBuffer));
  return accessors_.add(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                                    view, isShort ? kUnsignedShort : kUnsignedInt, primitive.indices.size()));
}

// One view holds the positions and normals of all primitives of a mesh, one their features, one their texture
// coordinates.
void GlbDocument::addPrimitives(const GlbMesh& mesh) {
  std::string vectors;
  std::string features;
  std::string coordinates;
  for (const GlbPrimitive& p : mesh.primitives) {
    vectors.append(bytesOf(p.positions)).append(bytesOf(p.normals));
    features.append(bytesOf(p.features));
    coordinates.append(bytesOf(p.textureCoordinates));
  }
  const auto vertexView = [&](const std::string& bytes, int stride) {
    return addView(bytes, fmt::format(R"(,"byteStride":{},"target":{})", stride, kVertexBuffer));
  };
  const std::size_t vectorView = vertexView(vectors, 12);
  const std::size_t featureView = vertexView(features, 4);
  const std::size_t coordinateView = coordinates.empty() ? 0 : vertexView(coordinates, 8);

  std::string primitives;
  std::size_t done = 0;      // vertices
  std::size_t textured = 0;  // vertices with texture coordinates
  for (const GlbPrimitive& p : mesh.primitives) {
    const std::size_t n = p.positions.size();
    const std::size_t position = addVectors(vectorView, done * 24, p.positions, true);
    const std::size_t normal = addVectors(vectorView, done * 24 + n * 12, p.normals, false);
    const std::size_t feature = accessors_.add(
        fmt::format(R"({{"bufferView":{},"byteOffset":{},"componentType":{},"count":{},"type":"SCALAR"}})",
                    featureView, done * 4, kFloat, n));
    std::string coordinate;
    if (!p.textureCoordinates.empty()) {
      coordinate = fmt::format(R"(,"TEXCOORD_0":{})",
                               addVectors(coordinateView, textured * 8, p.textureCoordinates, false));
      textured += n;
    }
    done += n;
    const std::size_t indices = addIndices(p);
    primitives += fmt::format(
        R"({}{{"attributes":{{"POSITION":{},"NORMAL":{},"_FEATURE_ID_0":{}{}}},"indices":{},"material":{},"extensions":{{"EXT_mesh_features":{{"featureIds":[{{"featureCount":{},"attribute":0,"propertyTable":0}}]}}}}}})",
        primitives.empty() ? "" : ",", position, normal, feature, coordinate, indices, materialOf(p.material),
        p.featureCount);
  }
  meshes_.add(fmt::format(R"({{"primitives":[{}]}})", primitives));
}

std::size_t GlbDocument::materialOf(const GlbMaterialKey& key) {
  const auto found = materialIndex_.find(key);
  if (found != materialIndex_.end()) return found->second;
  const std::size_t index =
      materials_.add(key.texture >= 0 ? texturedMaterial(key.texture) : plainMaterial(key));
  return materialIndex_[key] = index;
}

std::string GlbDocument::plainMaterial(const GlbMaterialKey& key) const {
  std::array<float, 3> colour = surfaceColour(key.role, key.type);
  std::string name = fmt::format("{} {}", toString(key.role), toString(key.type));
  float alpha = 1;
  if (key.material >= 0 && city_ && static_cast<std::size_t>(key.material) < city_->materials.size()) {
    const Material& material = city_->materials[static_cast<std::size_t>(key.material)];
    name = material.name;
    colour = material.diffuse;
    alpha = 1 - std::clamp(material.transparency, 0.F, 1.F);
  }
  return fmt::format(
      R"({{"name":{},"pbrMetallicRoughness":{{"baseColorFactor":[{},{},{},{}],"metallicFactor":0,"roughnessFactor":0.9}}{},"doubleSided":{}}})",
      jsonQuoted(name), toLinear(std::clamp(colour[0], 0.F, 1.F)), toLinear(std::clamp(colour[1], 0.F, 1.F)),
      toLinear(std::clamp(colour[2], 0.F, 1.F)), alpha, alpha < 1 ? R"(,"alphaMode":"BLEND")" : "",
      key.role != DrawRole::Cluster);
}

std::string GlbDocument::texturedMaterial(std::int32_t index) {
  const Texture& texture = city_->textures[static_cast<std::size_t>(index)];
  const std::string bytes = readImage(texture);
  const std::size_t view = addView(bytes);
  const std::string name = jsonQuoted(std::filesystem::path(texture.path).filename().string());
  const std::size_t image = images_.add(
      fmt::format(R"({{"name":{},"bufferView":{},"mimeType":"{}"}})", name, view, imageType(bytes)));
  const int wrap = wrapMode(texture.wrap);
  const std::size_t sampler = samplers_.add(
      fmt::format(R"({{"magFilter":9729,"minFilter":9987,"wrapS":{},"wrapT":{}}})", wrap, wrap));
  const std::size_t map = textures_.add(fmt::format(R"({{"sampler":{},"source":{}}})", sampler, image));
  return fmt::format(
      R"({{"name":{},"pbrMetallicRoughness":{{"baseColorTexture":{{"index":{}}},"metallicFactor":0,"roughnessFactor":0.9}},"doubleSided":true}})",
      name, map);
}

std::string GlbDocument::json(const std::string& extensions, const Json& extras) const {
  std::string nodes;
  for (std::size_t i = 0; i < nodes_.count; ++i) nodes += fmt::format("{}{}", i == 0 ? "" : ",", i);
  std::string text = fmt::format(R"({{"asset":{{"version":"2.0","generator":"Lodestone","extras":{}}})",
                                 extras.dump(-1, ' ', false, Json::error_handler_t::replace));
  if (!extensions.empty())
    text += R"(,"extensionsUsed":["EXT_mesh_features","EXT_structural_metadata"])" + extensions;
  text += R"(,"scene":0,"scenes":[{)" + (nodes.empty() ? std::string() : R"("nodes":[)" + nodes + "]") + "}]";
  const std::pair<const char*, const Items*> arrays[] = {
      {"nodes", &nodes_},   {"meshes", &meshes_},     {"materials", &materials_}, {"textures", &textures_},
      {"images", &images_}, {"samplers", &samplers_}, {"accessors", &accessors_}, {"bufferViews", &views_}};
  for (const auto& [name, items] : arrays) {
    if (items->count > 0)
      text += fmt::format(R"(,"{}":[{}])", name, std::string_view(items->text.data(), items->text.size()));
  }
  if (size_ > 0) text += fmt::format(R"(,"buffers":[{{"byteLength":{}}}])", size_);
  text += "}";
  while (text.size() % 4 != 0) text += ' ';
  return text;
}

void GlbDocument::finish(const GlbTable& table, const Json& extras, std::ostream& out) {
  std::string extensions;
  if (table.rows() > 0) {
    const Json metadata = table.write([this](std::string_view bytes) { return addView(bytes); });
    extensions = R"(,"extensions":{"EXT_structural_metadata":)" +
                 metadata.dump(-1, ' ', false, Json::error_handler_t::replace) + "}";
  }
  pad(4);
  const std::string text = json(extensions, extras);
  const std::uint64_t total = 12 + 8 + text.size() + (size_ > 0 ? 8 + size_ : 0);
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    throw std::system_error(std::make_error_code(std::errc::file_too_large), "GLB holds 4 GiB at most");
  }
  write32(out, kMagic);
  write32(out, 2);
  write32(out, total);
  write32(out, text.size());
  write32(out, kJsonChunk);
  out << text;
  if (size_ == 0) return;
  write32(out, size_);
  write32(out, kBinaryChunk);
  spool_.stream().flush();
  std::ifstream spooled(spool_.temporaryPath(), std::ios::binary);
  if (!spool_.stream() || !(out << spooled.rdbuf())) {
    throw std::system_error(std::make_error_code(std::errc::io_error), "GLB");
  }
}

}  // namespace lodestone
