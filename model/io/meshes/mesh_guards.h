// Files that assimp would not survive, told before it sees them.
#pragma once

#include <filesystem>
#include <optional>

#include "model/diagnostics.h"

namespace lodestone {

/// What is wrong with a COLLADA or glTF file, if it is of a kind on which assimp 5.2 crashes or never ends:
/// COLLADA whose indices are no whole numbers (it reads them for ever) or whose accessors reach beyond their
/// arrays, and glTF 1 (a missing property crashes its reader; superseded in 2017). Cost: one pass over the
/// file.
[[nodiscard]] std::optional<Diagnostic> whyRefused(const std::filesystem::path& path);

}  // namespace lodestone
