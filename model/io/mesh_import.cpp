#include "model/io/mesh_import.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "model/io/image_path.h"
#include "model/io/input_file.h"

namespace lodestone {
namespace {

using Transform = aiMatrix4x4t<ai_real>;

/// Turns a cancel into assimp's own way to stop.
class Reporter : public Assimp::ProgressHandler {
 public:
  explicit Reporter(const Progress& progress) : progress_(progress) {}
  bool Update(float done) override {
    if (done >= 0) progress_.report(done);
    return !progress_.stopRequested();
  }

 private:
  Progress progress_;
};

bool endsWith(const std::filesystem::path& path, std::string_view ending) {
  std::string name = path.filename().string();
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.ends_with(ending);
}

/// Which of a file's axes is up, and whether the file said so.
struct UpAxis {
  bool y = false;
  bool assumed = false;
};

UpAxis upAxisOf(const std::filesystem::path& path, const ImportOptions& options) {
  if (options.upAxis != UpAxisOption::Auto) return {options.upAxis == UpAxisOption::Y, false};
  // assimp turns COLLADA's own axis and unit into y up and metres
  if (endsWith(path, ".gltf") || endsWith(path, ".glb") || endsWith(path, ".dae")) return {true, false};
  if (endsWith(path, ".obj")) {
    if (readHead(path, 256).find("Lodestone") != std::string::npos) return {false, false};
    return {true, true};
  }
  return {false, true};
}

class MeshReader {
 public:
  MeshReader(const std::filesystem::path& path, const ImportOptions& options)
      : path_(path),
        images_(path, options.allowOutside),
        up_(upAxisOf(path, options)),
        scale_(options.unit) {}

  Result<CityModel> read(const Progress& progress) {
    Assimp::Importer importer;
    importer.SetProgressHandler(new Reporter(progress));  // the importer owns it
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE, aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    const aiScene* scene = importer.ReadFile(path_.string(), aiProcess_Triangulate | aiProcess_SortByPType);
    progress.checkpoint();
    if (!scene || !scene->mRootNode)
      return diagnose(Code::FileMalformed, importer.GetErrorString(), {}, path_.string());
    readMaterials(*scene);
    Building building;
    building.object.id = path_.stem().string();
    building.object.type = ObjectType::Building;
    readNode(*scene, *scene->mRootNode, Transform(), building.object);
    if (building.object.children.empty())
      return diagnose(Code::FileEmpty, "no triangles", {}, path_.string());
    if (bad_ > 0)
      diagnostics_.push_back(
          diagnose(Code::CoordinateBad, fmt::format("{} triangles", bad_), {}, path_.string()));
    if (up_.assumed)
      diagnostics_.push_back(
          diagnose(Code::UpAxisAssumed, up_.y ? "y is up" : "z is up", {}, path_.string()));
    model_.buildings.push_back(std::move(building));
    model_.crs.source = "#" + path_.filename().string();  // an engineering frame of its own
    return {std::move(model_), std::move(diagnostics_)};
  }

 private:
  void readMaterials(const aiScene& scene) {
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
      const aiMaterial& source = *scene.mMaterials[i];
      Material material;
      material.name = source.GetName().C_Str();
      aiColor3D colour;
      if (source.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS)
        material.diffuse = {colour.r, colour.g, colour.b};
      float opacity = 1;
      if (source.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS)
        material.transparency = 1 - std::clamp(opacity, 0.0F, 1.0F);
      model_.materials.push_back(std::move(material));
      textureOf_.push_back(textureIndex(source));
    }
  }

  std::int32_t textureIndex(const aiMaterial& source) {
    aiString name;
    if (source.GetTexture(aiTextureType_DIFFUSE, 0, &name) != AI_SUCCESS &&
        source.GetTexture(aiTextureType_BASE_COLOR, 0, &name) != AI_SUCCESS)
      return -1;
    if (name.length > 0 && name.C_Str()[0] == '*') {  // inside the file
      diagnostics_.push_back(diagnose(Code::TextureMissing, "embedded in the file", {}, path_.string()));
      return -1;
    }
    Texture texture = images_.find(name.C_Str(), diagnostics_);
    for (std::size_t i = 0; i < model_.textures.size(); ++i) {
      if (model_.textures[i].path == texture.path) return static_cast<std::int32_t>(i);
    }
    model_.textures.push_back(std::move(texture));
    return static_cast<std::int32_t>(model_.textures.size()) - 1;
  }

  void readNode(const aiScene& scene, const aiNode& node, const Transform& above, CityObject& building) {
    const Transform here = above * node.mTransformation;
    CityObject object;
    object.id = idOf(node, building);
    object.type = ObjectType::BuildingInstallation;
    Geometry geometry;
    geometry.lod = "3";
    for (unsigned i = 0; i < node.mNumMeshes; ++i) addMesh(*scene.mMeshes[node.mMeshes[i]], here, geometry);
    if (geometry.surfaceCount() > 0) {
      const auto untextured = [](const Vec2f& st) { return !st.allFinite(); };
      if (std::all_of(geometry.textureCoordinates.begin(), geometry.textureCoordinates.end(), untextured))
        geometry.textureCoordinates.clear();
      object.geometries.push_back(std::move(geometry));
      building.children.push_back(std::move(object));
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) readNode(scene, *node.mChildren[i], here, building);
  }

  std::string idOf(const aiNode& node, const CityObject& building) {
    std::string name = node.mName.C_Str();
    if (name.empty() || name == building.id) name = fmt::format("{}-{}", building.id, building.children.size());
    return name;
  }

  void addMesh(const aiMesh& mesh, const Transform& transform, Geometry& geometry) {
    const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v)
      geometry.vertices.push_back(place(transform * mesh.mVertices[v]));
    const SurfaceInfo surface{SurfaceType::Unknown, static_cast<std::int32_t>(mesh.mMaterialIndex),
                              textureOf_.at(mesh.mMaterialIndex)};
    const bool textured = mesh.HasTextureCoords(0) && surface.texture >= 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      if (face.mNumIndices != 3) continue;
      if (!std::all_of(face.mIndices, face.mIndices + 3,
                       [&](unsigned v) { return geometry.vertices[first + v].allFinite(); })) {
        ++bad_;
        continue;
      }
      for (unsigned corner = 0; corner < 3; ++corner) {
        const unsigned v = face.mIndices[corner];
        geometry.ringVertices.push_back(first + v);
        geometry.textureCoordinates.push_back(
            textured ? Vec2f(mesh.mTextureCoords[0][v].x, mesh.mTextureCoords[0][v].y)
                     : Vec2f::Constant(std::numeric_limits<float>::quiet_NaN()));
      }
      geometry.ringStart.push_back(static_cast<std::uint32_t>(geometry.ringVertices.size()));
      geometry.finishSurface(surface);
    }
  }

  [[nodiscard]] Vec3 place(const aiVector3D& p) const {
    return scale_ * (up_.y ? Vec3(p.x, -p.z, p.y) : Vec3(p.x, p.y, p.z));
  }

  std::filesystem::path path_;
  ImagePaths images_;
  UpAxis up_;
  double scale_;
  CityModel model_;
  Diagnostics diagnostics_;
  std::vector<std::int32_t> textureOf_;  ///< by material
  std::size_t bad_ = 0;
};

Format meshFormat(std::string_view id, std::string_view title, std::vector<std::string_view> extensions,
                  int (*probe)(const std::filesystem::path&, std::string_view)) {
  Format format{id, title, std::move(extensions)};
  format.probe = probe;
  format.read = readMesh;
  return format;
}

int sure(bool yes) {
  return yes ? 90 : 0;
}

}  // namespace

Result<CityModel> readMesh(const std::filesystem::path& path, const ImportOptions& options,
                           const Progress& progress) {
  return MeshReader(path, options).read(progress);
}

int probeObj(const std::filesystem::path& path, std::string_view head) {
  return sure(endsWith(path, ".obj") && head.find('\0') == std::string_view::npos);
}

int probeGltf(const std::filesystem::path& path, std::string_view head) {
  return sure(head.starts_with("glTF") ||
              (endsWith(path, ".gltf") && head.find("\"asset\"") != std::string_view::npos) ||
              endsWith(path, ".gltf"));
}

Format plyFormat() {
  return meshFormat(
      "ply", "Polygon file (PLY)", {".ply"},
      [](const std::filesystem::path&, std::string_view head) { return sure(head.starts_with("ply")); });
}

Format stlFormat() {
  return meshFormat(
      "stl", "Stereolithography (STL)", {".stl"},
      [](const std::filesystem::path& path, std::string_view) { return sure(endsWith(path, ".stl")); });
}

Format colladaFormat() {
  return meshFormat("collada", "COLLADA", {".dae"}, [](const std::filesystem::path&, std::string_view head) {
    return sure(head.find("<COLLADA") != std::string_view::npos);
  });
}

Format offFormat() {
  return meshFormat("off", "Object file format (OFF)", {".off"},
                    [](const std::filesystem::path& path, std::string_view head) {
                      return sure(endsWith(path, ".off") && head.find("OFF") != std::string_view::npos);
                    });
}

}  // namespace lodestone
