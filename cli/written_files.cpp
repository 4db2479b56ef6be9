#include "cli/written_files.h"

#include <algorithm>

#include <fmt/format.h>

#include "model/io/meshes/mesh_import.h"

namespace lodestone::cli {

void noteFiles(Run& run, const WriteReport& report) {
  auto& files = run.output["files"];
  if (files.is_null()) files = nlohmann::ordered_json::array();
  for (const auto& file : report.files) files.push_back(file.generic_string());
}

const Format& outputFormat(const std::filesystem::path& path) {
  const Format* format = formatForWriting(path);
  if (!format) throw Failure(diagnose(Code::OutputFormatUnknown, path.string()));
  return *format;
}

std::filesystem::path folderOf(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

namespace {

/// A mesh has surfaces, materials and textures: what holds those loses nothing.
bool keepsAll(const Format& format, const LodChain& chain) {
  const bool holdsSurfaces = isMeshFormat(&format) || format.id.starts_with("cityjson");
  return holdsSurfaces && chain.city && !chain.city->sources.empty() &&
         std::all_of(chain.city->sources.begin(), chain.city->sources.end(),
                     [](const Source& source) { return isMeshFormat(formatById(source.format)); });
}

}  // namespace

void requireFolder(const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  if (fs::is_directory(folder)) return;
  const auto refuse = [&](const char* why) {
    throw Failure(diagnose(Code::OutputExists, why, {}, folder.string()));
  };
  if (fs::exists(folder)) refuse("a folder is wanted, and there is a file");
  if (fs::is_symlink(folder)) refuse("a folder is wanted, and there is a link that leads nowhere");
}

void writeChain(Run& run, const LodChain& chain, const Format& format, const std::filesystem::path& path,
                const WriteOptions& options) {
  if (!format.losses.empty() && !keepsAll(format, chain)) {
    run.add({diagnose(Code::OutputLossy, fmt::format("{}: {}", format.title, format.losses))});
  }
  noteFiles(run, run.take(run.stage(fmt::format("write {}", format.id), [&](const Progress& progress) {
    return format.write(chain, path, options, progress);
  })));
}

}  // namespace lodestone::cli
