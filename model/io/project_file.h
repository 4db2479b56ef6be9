// Project files (.lodestone): what was opened, all options and the view. Results are computed again.
#pragma once

#include <filesystem>

#include "model/result.h"
#include "model/session.h"

namespace lodestone {

/// Everything of the state that is not computed, sources by path relative to the project file, and `layout`,
/// an opaque text of the window.
[[nodiscard]] Result<bool> saveProject(const ProjectState& state, const std::filesystem::path& path,
                                       const std::string& layout = {});

struct LoadedProject {
  ProjectState state;
  std::string layout;
};
[[nodiscard]] Result<LoadedProject> loadProject(const std::filesystem::path& path);

}  // namespace lodestone
