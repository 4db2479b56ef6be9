// What writers of one file a level share.
#pragma once

#include <filesystem>
#include <vector>

#include "model/io/format.h"

namespace lodestone {

struct LevelFile {
  std::size_t level = 0;
  std::filesystem::path path;
};

/// The files that hold the wanted levels: `path` itself for one level, "name_level-K.ext" beside it for
/// several. Fails (OptionOutOfRange) on a level that the chain has not got.
[[nodiscard]] Result<std::vector<LevelFile>> levelFiles(const LodChain& chain,
                                                        const std::filesystem::path& path,
                                                        const WriteOptions& options);

}  // namespace lodestone
