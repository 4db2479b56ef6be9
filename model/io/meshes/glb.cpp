#include "model/io/meshes/glb.h"

#include "model/io/meshes/glb_document.h"
#include "model/io/meshes/level_files.h"
#include "model/io/meshes/level_stream.h"
#include "model/io/meshes/mesh_import.h"
#include "model/io/output_failure.h"
#include "model/io/places/crs_json.h"

namespace lodestone {
namespace {

using Json = nlohmann::ordered_json;

/// Feature ids are floats: those that are exact.
constexpr std::size_t kMostFeatures = std::size_t{1} << 24U;

Json extrasOf(const LodChain& chain, std::size_t index) {
  const LodLevel& level = chain.levels[index];
  Json ours{{"level", index},
            {"name", level.name},
            {"method", level.method},
            {"error", level.error},
            {"switchDistance", level.switchDistance},
            {"polygons", level.faces.polygons},
            {"triangles", level.faces.triangles}};
  if (chain.city) {
    const Crs& crs = chain.city->crs;
    const Vec3& origin = chain.city->origin;
    static constexpr const char* kKinds[] = {"unknown", "projected", "geographic", "local"};
    ours["crs"] = crsJson(crs, origin);
    ours["crs"]["kind"] = kKinds[static_cast<int>(crs.kind)];
    ours["origin"] = {origin.x(), origin.y(), origin.z()};
  }
  Json recipe = Json::parse(chain.recipe, nullptr, false);
  if (!recipe.is_discarded()) ours["recipe"] = std::move(recipe);
  return {{"lodestone", std::move(ours)}};
}

void writeLevel(const LodChain& chain, std::size_t index, const std::filesystem::path& path,
                std::ostream& out, const Progress& progress) {
  GlbDocument document(chain.city, path);
  GlbTable table(chain.city, index);
  bool failed = false;
  using Block = LevelBlock<GlbMesh>;
  streamLevel<GlbMesh>(
      chain.levels[index], progress,
      [&](Block& block) {
        block.content = makeGlbMesh(block.objects, block.first, document.usableTextures());
      },
      [](Block&) {}, [](Block&) {},
      [&](const Block& block) {
        for (const LevelObject& object : block.objects) table.add(object);
        failed = !document.addMesh(block.content);
        return !failed;
      });
  if (failed) throw std::system_error(std::make_error_code(std::errc::no_space_on_device), path.string());
  document.finish(table, extrasOf(chain, index), out);
}

Diagnostics texturesLeftOut(const LodChain& chain) {
  Diagnostics diagnostics;
  if (!chain.city) return diagnostics;
  for (const Texture& texture : chain.city->textures) {
    if (texture.missing) {
      diagnostics.push_back(diagnose(Code::TextureMissing, texture.path));
    } else if (!glbHoldsImage(texture)) {
      diagnostics.push_back(
          diagnose(Code::OutputLossy, "glTF 2.0: an image that is neither PNG nor JPEG, " + texture.path));
    }
  }
  return diagnostics;
}

Result<WriteReport> writeGlb(const LodChain& chain, const std::filesystem::path& path,
                             const WriteOptions& options, const Progress& progress) {
  if (path.extension() == ".gltf")  // others take it for the text form
    return diagnose(Code::OutputFormatUnknown, "glTF is written in its binary form: .glb", {}, path.string());
  const Result<std::vector<LevelFile>> files = levelFiles(chain, path, options);
  if (!files) return Result<WriteReport>::failure(files.diagnostics);
  Result<WriteReport> result{WriteReport{}, texturesLeftOut(chain)};
  try {
    AtomicFiles together;
    for (std::size_t i = 0; i < files->size(); ++i) {
      const LevelFile& file = (*files)[i];
      if (chain.levels[file.level].objectCount > kMostFeatures) {
        return diagnose(Code::OutputUnwritable, "more objects than a GLB can name", {}, file.path.string());
      }
      const auto share = [&](std::size_t n) {
        return static_cast<double>(n) / static_cast<double>(files->size());
      };
      AtomicFile& output = together.add(file.path);
      writeLevel(chain, file.level, file.path, output.stream(), progress.part(share(i), share(i + 1), "glb"));
      output.close();
    }
    result->files = together.commit();
  } catch (const std::system_error& error) {
    return outputFailure(error, path);
  }
  return result;
}

}  // namespace

Format glbFormat() {
  Format format{"glb", "glTF 2.0", {".glb", ".gltf"}};
  format.probe = probeGltf;
  readsMeshes(format);
  format.write = writeGlb;
  format.fileALevel = true;
  format.losses =
      "line layers, objects that are not buildings, structured attributes, all but the 64 commonest "
      "attributes";
  return format;
}

}  // namespace lodestone
