#include "model/io/meshes/mesh_import.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include <assimp/Importer.hpp>
#include <assimp/ProgressHandler.hpp>
#include <assimp/commonMetaData.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "model/io/input_file.h"
#include "model/io/meshes/mesh_guards.h"
#include "model/io/meshes/mesh_textures.h"
#include "model/io/meshes/obj_names.h"
#include "model/io/meshes/ply.h"
#include "model/level_colours.h"

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

/// An OBJ that we wrote.
bool isOurObj(const std::filesystem::path& path) {
  return endsWith(path, ".obj") && readHead(path, 256).find("Lodestone") != std::string::npos;
}

bool isOurs(const std::filesystem::path& path, const aiScene& scene) {
  aiString generator;
  const bool known = scene.mMetaData && scene.mMetaData->Get(AI_METADATA_SOURCE_GENERATOR, generator);
  return isOurObj(path) || (known && std::string_view(generator.C_Str()) == "Lodestone");
}

/// The kind of surface whose colour we write where a building's surface has no material; none for materials
/// that are somebody's own.
std::optional<SurfaceType> levelColourOf(const Material& material) {
  constexpr std::string_view kBuilding = "building";
  constexpr float kRounding = 1e-3F;
  if (!material.name.starts_with(kBuilding) || material.name.size() <= kBuilding.size()) return std::nullopt;
  const SurfaceType type = surfaceTypeFrom(material.name.substr(kBuilding.size() + 1));
  const std::array<float, 3> colour = surfaceColour(DrawRole::Building, type);
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::abs(colour[i] - material.diffuse[i]) > kRounding) return std::nullopt;
  }
  return type;
}

const Vec2f kNoCoordinate = Vec2f::Constant(std::numeric_limits<float>::quiet_NaN());

class MeshReader {
 public:
  MeshReader(const std::filesystem::path& path, const ImportOptions& options)
      : path_(path),
        up_(options.upAxis == UpAxisOption::Auto ? upAxisOf(path)
                                                 : UpAxis{options.upAxis == UpAxisOption::Y, false}),
        scale_(options.unit),
        textures_(path, options.allowOutside, model_.textures, diagnostics_) {}

  Result<CityModel> read(const Progress& progress) {
    if (const auto refused = whyRefused(path_)) return *refused;
    building_.object.id = path_.stem().string();
    building_.object.type = ObjectType::Building;
    const std::string trouble = endsWith(path_, ".ply") ? readPolygonFile() : readScene(progress);
    progress.checkpoint();
    if (!trouble.empty()) return diagnose(Code::FileMalformed, trouble, {}, path_.string());
    if (building_.object.children.empty()) return diagnose(Code::FileEmpty, "no faces", {}, path_.string());
    if (bad_ > 0)
      diagnostics_.push_back(
          diagnose(Code::CoordinateBad, fmt::format("{} faces", bad_), {}, path_.string()));
    if (up_.assumed)
      diagnostics_.push_back(
          diagnose(Code::UpAxisAssumed, up_.y ? "y is up" : "z is up", {}, path_.string()));
    model_.buildings.push_back(std::move(building_));
    model_.crs.source = "#" + path_.filename().string();  // an engineering frame of its own
    return {std::move(model_), std::move(diagnostics_)};
  }

 private:
  /// Each of the two returns what is wrong with the file; nothing when all is well.
  std::string readScene(const Progress& progress) {
    Assimp::Importer importer;
    importer.SetProgressHandler(new Reporter(progress));  // the importer owns both
    importer.SetIOHandler(new ObjNames);
    // No post-processing: it aborts the program on meshes that its authors thought impossible.
    const aiScene* scene = importer.ReadFile(path_.string(), 0);
    if (!scene || !scene->mRootNode) return std::string("assimp: ") + importer.GetErrorString();
    readMaterials(*scene);
    readNode(*scene, *scene->mRootNode, Transform(), building_.object);
    return {};
  }

  std::string readPolygonFile() {
    PlyMesh ply;
    try {
      ply = parsePly(readWholeFile(path_));
    } catch (const std::exception& error) {
      return error.what();
    }
    const bool textured = !ply.texture.empty();
    const SurfaceInfo surface{SurfaceType::Unknown, -1, textured ? textures_.named(ply.texture) : -1};
    const auto coordinate = [&](std::uint32_t corner) {
      if (!ply.cornerCoordinates.empty()) return ply.cornerCoordinates[corner];
      return ply.vertexCoordinates.empty() ? kNoCoordinate : ply.vertexCoordinates[ply.corners[corner]];
    };
    Geometry geometry;
    geometry.lod = "3";
    for (const Vec3& p : ply.vertices) geometry.vertices.push_back(place(p));
    for (std::size_t f = 0; f + 1 < ply.faceStart.size(); ++f) {
      const std::uint32_t first = ply.faceStart[f];
      addFace(geometry, 0, {ply.corners.data() + first, ply.faceStart[f + 1] - first}, surface,
              [&](std::size_t i) {
                return surface.texture >= 0 ? coordinate(first + static_cast<std::uint32_t>(i))
                                            : kNoCoordinate;
              });
    }
    addObject(building_.object.id + "-0", std::move(geometry), building_.object);
    return {};
  }

  void readMaterials(const aiScene& scene) {
    const bool ours = isOurs(path_, scene);
    for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
      const aiMaterial& source = *scene.mMaterials[i];
      Material material;
      material.name = source.GetName().C_Str();
      aiColor3D colour;
      if (source.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS)
        material.diffuse = {colour.r, colour.g, colour.b};
      // glTF's colours are linear (2.0, 3.9.2), those of other formats and ours are for the display.
      aiColor4D base;
      if (source.Get(AI_MATKEY_BASE_COLOR, base) == AI_SUCCESS)
        material.diffuse = {toSrgb(base.r), toSrgb(base.g), toSrgb(base.b)};
      float opacity = 1;
      if (source.Get(AI_MATKEY_OPACITY, opacity) == AI_SUCCESS)
        material.transparency = 1 - std::clamp(opacity, 0.0F, 1.0F);
      levelColourOf_.push_back(ours ? levelColourOf(material) : std::nullopt);
      model_.materials.push_back(std::move(material));
      textureOf_.push_back(textures_.of(scene, source));
    }
  }

  void readNode(const aiScene& scene, const aiNode& node, const Transform& above, CityObject& building) {
    const Transform here = above * node.mTransformation;
    Geometry geometry;
    geometry.lod = "3";
    for (unsigned i = 0; i < node.mNumMeshes; ++i) addMesh(*scene.mMeshes[node.mMeshes[i]], here, geometry);
    addObject(idOf(node, building), std::move(geometry), building);
    for (unsigned i = 0; i < node.mNumChildren; ++i) readNode(scene, *node.mChildren[i], here, building);
  }

  static void addObject(std::string id, Geometry geometry, CityObject& building) {
    if (geometry.surfaceCount() == 0) return;
    const auto untextured = [](const Vec2f& st) { return !st.allFinite(); };
    if (std::all_of(geometry.textureCoordinates.begin(), geometry.textureCoordinates.end(), untextured))
      geometry.textureCoordinates.clear();
    CityObject object;
    object.id = std::move(id);
    object.type = ObjectType::BuildingInstallation;
    object.geometries.push_back(std::move(geometry));
    building.children.push_back(std::move(object));
  }

  std::string idOf(const aiNode& node, const CityObject& building) {
    std::string name = takeNameBack(node.mName.C_Str());
    if (name.empty() || name == building.id)
      name = fmt::format("{}-{}", building.id, building.children.size());
    return name;
  }

  /// A colour of ours is no material: what had none looks the same when it comes back.
  [[nodiscard]] SurfaceInfo surfaceOf(std::size_t material) const {
    if (material >= textureOf_.size()) return {};
    if (const auto type = levelColourOf_[material])
      return {*type == SurfaceType::Wall ? SurfaceType::Unknown : *type, -1, textureOf_[material]};
    return {SurfaceType::Unknown, static_cast<std::int32_t>(material), textureOf_[material]};
  }

  void addMesh(const aiMesh& mesh, const Transform& transform, Geometry& geometry) {
    const auto first = static_cast<std::uint32_t>(geometry.vertices.size());
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
      const aiVector3D p = transform * mesh.mVertices[v];
      geometry.vertices.push_back(place({p.x, p.y, p.z}));
    }
    const SurfaceInfo surface = surfaceOf(mesh.mMaterialIndex);
    const bool textured = mesh.HasTextureCoords(0) && surface.texture >= 0;
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
      const aiFace& face = mesh.mFaces[f];
      addFace(geometry, first, {face.mIndices, face.mNumIndices}, surface, [&](std::size_t i) {
        const aiVector3D* st = mesh.mTextureCoords[0] + face.mIndices[i];
        return textured ? Vec2f(st->x, st->y) : kNoCoordinate;
      });
    }
  }

  /// `corners` count from vertex `first` of the geometry; `coordinate(i)` is that of corner i.
  template <class Coordinate>
  void addFace(Geometry& geometry, std::uint32_t first, std::span<const std::uint32_t> corners,
               const SurfaceInfo& surface, const Coordinate& coordinate) {
    if (corners.size() < 3) return;  // points and lines
    const std::size_t count = geometry.vertices.size() - first;
    if (!std::all_of(corners.begin(), corners.end(), [&](std::uint32_t v) {
          return v < count && geometry.vertices[first + v].allFinite();
        })) {
      ++bad_;
      return;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      geometry.ringVertices.push_back(first + corners[i]);
      geometry.textureCoordinates.push_back(coordinate(i));
    }
    geometry.ringStart.push_back(static_cast<std::uint32_t>(geometry.ringVertices.size()));
    geometry.finishSurface(surface);
  }

  [[nodiscard]] Vec3 place(const Vec3& p) const { return scale_ * (up_.y ? Vec3(p.x(), -p.z(), p.y()) : p); }

  std::filesystem::path path_;
  UpAxis up_;
  double scale_;
  CityModel model_;
  Building building_;
  Diagnostics diagnostics_;
  MeshTextures textures_;                                  ///< adds to the model's and to the diagnostics
  std::vector<std::int32_t> textureOf_;                    ///< by material
  std::vector<std::optional<SurfaceType>> levelColourOf_;  ///< by material
  std::size_t bad_ = 0;
};

Format meshFormat(std::string_view id, std::string_view title, std::vector<std::string_view> extensions,
                  int (*probe)(const std::filesystem::path&, std::string_view)) {
  Format format{id, title, std::move(extensions)};
  format.probe = probe;
  readsMeshes(format);
  return format;
}

int sure(bool yes) {
  return yes ? 90 : 0;
}

}  // namespace

UpAxis upAxisOf(const std::filesystem::path& path) {
  // assimp turns COLLADA's own axis and unit into y up and metres
  if (endsWith(path, ".gltf") || endsWith(path, ".glb") || endsWith(path, ".dae")) return {true, false};
  if (endsWith(path, ".obj")) {
    const bool ours = isOurObj(path);
    return {!ours, !ours};
  }
  return {false, true};
}

bool isMeshFormat(const Format* format) {
  return format && format->read == readMesh;
}

void readsMeshes(Format& format) {
  format.read = readMesh;
  format.listensTo = {"up-axis", "unit"};
}

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
