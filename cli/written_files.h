// Names written files in the report and refuses endings that nothing writes.
#pragma once

#include "cli/run.h"
#include "model/io/format.h"

namespace lodestone::cli {

/// Lists the files in the report's output.
void noteFiles(Run& run, const WriteReport& report);

/// The format for an output path. \throw Failure (704)
[[nodiscard]] const Format& outputFormat(const std::filesystem::path& path);

/// The folder that a file is written into.
[[nodiscard]] std::filesystem::path folderOf(const std::filesystem::path& file);

/// That files can be written into this folder, or that it can be made. \throw Failure (701) where something
/// else stands in its place
void requireFolder(const std::filesystem::path& folder);

/// Writes a chain in a format as a stage of the run, and says what the format loses. \throw Failure
void writeChain(Run& run, const LodChain& chain, const Format& format, const std::filesystem::path& path,
                const WriteOptions& options = {});

}  // namespace lodestone::cli
