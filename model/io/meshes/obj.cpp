#include "model/io/meshes/obj.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "model/io/atomic_file.h"
#include "model/io/input_file.h"
#include "model/io/meshes/level_files.h"
#include "model/io/meshes/level_stream.h"
#include "model/io/meshes/mesh_import.h"
#include "model/io/meshes/obj_text.h"
#include "model/io/output_failure.h"
#include "model/io/places/crs_json.h"
#include "model/io/places/georeference.h"
#include "model/io/texture_image.h"
#include "model/level_colours.h"

namespace lodestone {
namespace {

namespace fs = std::filesystem;
using Materials = std::map<std::string, ObjText::Use>;

struct BlockText {
  ObjOffsets before;
  ObjText made;
};

/// One level's files, complete but not yet in their places.
class ObjFiles {
 public:
  ObjFiles(const LodChain& chain, const LevelFile& file, AtomicFiles& files)
      : chain_(chain), level_(file.level), path_(file.path), files_(files), obj_(files.add(path_)) {
    if (!chain.city) return;
    for (const Texture& texture : chain.city->textures) usable_.push_back(hasImage(texture));
  }

  void write(const Progress& progress) {
    writeHead();
    writeObjects(progress);
    obj_.close();
    writeMaterials();
    writeOffset();
  }

 private:
  [[nodiscard]] fs::path beside(const std::string& ending) const {
    return path_.parent_path() / (path_.stem().string() + ending);
  }

  void writeHead() {
    std::ostream& obj = obj_.stream();
    obj << fmt::format("# Lodestone: {}, level {}\n# metres, z up\n", chain_.levels[level_].name, level_);
    if (chain_.city) writePlace(*chain_.city, obj);
    obj << fmt::format("mtllib {}\n", objName(beside(".mtl").filename().string()));
  }

  /// How to put v back into the world.
  static void writePlace(const CityModel& city, std::ostream& obj) {
    const Crs& crs = city.crs;
    const std::string epsg = crs.epsg > 0 ? fmt::format(" (EPSG:{})", crs.epsg) : "";
    obj << fmt::format("# offset {} {} {}\n# CRS {}{}\n", city.origin.x(), city.origin.y(), city.origin.z(),
                       crs.name.empty() ? "none given" : crs.name, epsg);
    if (const std::string proj = localProjection(crs, city.origin); !proj.empty()) {
      obj << fmt::format("# x and y of v are coordinates of {}; height = (offset z + v z) / {}\n", proj,
                         crs.verticalUnit);
    } else if (crs.unit == 1 && crs.verticalUnit == 1) {
      obj << "# world = offset + v\n";
    } else {
      obj << fmt::format("# world = (offset + v) / {}, heights / {}\n", crs.unit, crs.verticalUnit);
    }
  }

  void writeObjects(const Progress& progress) {
    using Block = LevelBlock<BlockText>;
    ObjOffsets before;
    streamLevel<BlockText>(
        chain_.levels[level_], progress, [](Block&) {},
        [&](Block& block) {
          block.content.before = before;
          const ObjOffsets sizes = objSizes(block.objects);
          before.vertices += sizes.vertices;
          before.coordinates += sizes.coordinates;
        },
        [&](Block& block) {
          block.content.made = makeObjText(block.objects, chain_.city.get(), block.content.before, usable_);
        },
        [&](const Block& block) {
          const ObjText& made = block.content.made;
          obj_.stream().write(made.text.data(), static_cast<std::streamsize>(made.text.size()));
          materials_.insert(made.materials.begin(), made.materials.end());
          return obj_.stream().good();
        });
  }

  void writeMaterials() {
    AtomicFile& file = files_.add(beside(".mtl"));
    std::ostream& mtl = file.stream();
    for (const auto& [name, use] : materials_) {
      std::array<float, 3> colour = surfaceColour(use.role, use.surface.type);
      float opacity = 1;
      const auto index = static_cast<std::size_t>(use.surface.material);
      if (!use.textured && use.surface.material >= 0 && chain_.city &&
          index < chain_.city->materials.size()) {
        colour = chain_.city->materials[index].diffuse;
        opacity = 1 - chain_.city->materials[index].transparency;
        mtl << fmt::format("# {}\n", objName(chain_.city->materials[index].name));
      }
      if (use.textured) colour = {1, 1, 1};
      mtl << fmt::format("newmtl {}\nKd {} {} {}\nd {}\nillum 1\n", name, colour[0], colour[1], colour[2],
                         opacity);
      if (use.textured)
        mtl << fmt::format("map_Kd {}{}\n", clampOption(use.surface.texture),
                           copyTexture(use.surface.texture));
    }
    file.close();
  }

  /// MTL tells what ends at its edges from what goes on; how it goes on (mirrored) it cannot say.
  [[nodiscard]] const char* clampOption(std::int32_t index) const {
    const std::string& wrap = chain_.city->textures[static_cast<std::size_t>(index)].wrap;
    return wrap == "clamp" || wrap == "border" || wrap == "none" ? "-clamp on " : "";
  }

  /// Copies the image beside the OBJ and returns its relative path. The number keeps images of one name
  /// apart.
  std::string copyTexture(std::int32_t index) {
    const Texture& texture = chain_.city->textures[static_cast<std::size_t>(index)];
    const fs::path folder = objName(path_.stem().string() + "_textures");
    const fs::path relative =
        folder / fmt::format("{}_{}", index, objName(fs::path(texture.path).filename().string()));
    files_.add(path_.parent_path() / relative, readImage(texture));
    return relative.generic_string();
  }

  void writeOffset() {
    nlohmann::ordered_json json{{"type", "offset"}, {"version", 1}, {"up", "z"}, {"unit", "metre"}};
    if (chain_.city) {
      const Crs& crs = chain_.city->crs;
      const Vec3& origin = chain_.city->origin;
      json["crs"] = crsJson(crs, origin);
      json["crs"]["geographic"] = crs.kind == CrsKind::Geographic;
      json["offset"] = {origin.x(), origin.y(), origin.z()};
    }
    files_.add(beside(".offset.json"),
               json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
  }

  const LodChain& chain_;
  std::size_t level_;
  fs::path path_;
  AtomicFiles& files_;
  AtomicFile& obj_;
  std::vector<bool> usable_;
  Materials materials_;
};

Diagnostics mirrorsLost(const LodChain& chain) {
  Diagnostics diagnostics;
  if (!chain.city) return diagnostics;
  for (const Texture& texture : chain.city->textures) {
    if (texture.wrap == "mirror" && hasImage(texture))
      diagnostics.push_back(
          diagnose(Code::OutputLossy, "Wavefront OBJ: a texture goes on unmirrored, " + texture.path));
  }
  return diagnostics;
}

Result<WriteReport> writeObj(const LodChain& chain, const fs::path& path, const WriteOptions& options,
                             const Progress& progress) {
  const Result<std::vector<LevelFile>> files = levelFiles(chain, path, options);
  if (!files) return Result<WriteReport>::failure(files.diagnostics);
  Result<WriteReport> result{WriteReport{}, mirrorsLost(chain)};
  try {
    AtomicFiles together;
    for (std::size_t i = 0; i < files->size(); ++i) {
      const auto share = [&](std::size_t n) {
        return static_cast<double>(n) / static_cast<double>(files->size());
      };
      ObjFiles(chain, (*files)[i], together).write(progress.part(share(i), share(i + 1), "obj"));
    }
    result->files = together.commit();
  } catch (const std::system_error& error) {
    return outputFailure(error, path);
  }
  return result;
}

}  // namespace

Format objFormat() {
  Format format{"obj", "Wavefront OBJ", {".obj"}};
  format.probe = probeObj;
  readsMeshes(format);
  format.write = writeObj;
  format.fileALevel = true;
  format.losses =
      "attributes, line layers, objects that are not buildings, kinds of surface except as material names";
  return format;
}

}  // namespace lodestone
