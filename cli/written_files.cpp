#include "cli/written_files.h"

#include <fmt/format.h>

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

void writeChain(Run& run, const LodChain& chain, const Format& format, const std::filesystem::path& path,
                const WriteOptions& options) {
  if (!format.losses.empty()) {
    run.add({diagnose(Code::OutputLossy, fmt::format("{}: {}", format.title, format.losses))});
  }
  noteFiles(run, run.take(run.stage(fmt::format("write {}", format.id), [&](const Progress& progress) {
    return format.write(chain, path, options, progress);
  })));
}

}  // namespace lodestone::cli
