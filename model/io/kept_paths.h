// Paths inside a file that names other files (projects, recipes): kept from the file's own folder, so that
// they hold from any working directory, and when the folder moves together with what it names.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace lodestone {

/// How the files at `paths` (relative ones: from the working directory) are named in a file of `folder`, with
/// "/" between the parts; absolute where no way leads from the folder to them. Links are followed on the way
/// but a file keeps its own name. The folder need not be there yet.
[[nodiscard]] std::vector<std::string> keptPaths(const std::vector<std::string>& paths,
                                                 const std::filesystem::path& folder);

/// The way back: absolute paths of what a file of `folder` names.
[[nodiscard]] std::vector<std::string> pathsFromKept(const std::vector<std::string>& kept,
                                                     const std::filesystem::path& folder);

}  // namespace lodestone
