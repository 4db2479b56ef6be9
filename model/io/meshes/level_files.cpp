#include "model/io/meshes/level_files.h"

#include <fmt/format.h>

namespace lodestone {

Result<std::vector<LevelFile>> levelFiles(const LodChain& chain, const std::filesystem::path& path,
                                          const WriteOptions& options) {
  std::vector<std::size_t> levels = options.levels;
  for (std::size_t i = 0; levels.size() < chain.levels.size() && options.levels.empty(); ++i)
    levels.push_back(i);
  std::vector<LevelFile> files;
  for (std::size_t level : levels) {
    if (level >= chain.levels.size()) {
      return diagnose(Code::OptionOutOfRange,
                      fmt::format("level {}: the chain has {}", level, chain.levels.size()));
    }
    const std::string name =
        fmt::format("{}_level-{}{}", path.stem().string(), level, path.extension().string());
    files.push_back({level, levels.size() == 1 ? path : path.parent_path() / name});
  }
  return files;
}

}  // namespace lodestone
