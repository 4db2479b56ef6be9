// Recipes: how a chain was made, as JSON text that makes it again (resources/schemas/recipe.json).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/lod_chain.h"
#include "model/result.h"

namespace lodestone {

struct RecipeLevel {
  std::string method;  ///< "original", "legible"
  OptionValues options;
  bool operator==(const RecipeLevel&) const = default;
};

struct Recipe {
  std::vector<std::string> sources;   ///< paths of the inputs
  OptionValues import;                ///< how the sources were read
  std::vector<std::string> barriers;  ///< layers of lines that clusters do not cross
  std::vector<RecipeLevel> levels;    ///< from fine to coarse
  std::vector<std::string> exports;   ///< ids of formats
  bool operator==(const Recipe&) const = default;
};

[[nodiscard]] Recipe recipeOf(const LodChain& chain, std::vector<std::string> exports = {});
/// For a file of `folder`: paths are named from there (kept_paths.h); without a folder as they stand. The
/// same recipe gives the same bytes.
[[nodiscard]] std::string recipeText(const Recipe& recipe, const std::filesystem::path& folder = {});
/// Of a file in `folder`: its paths come back absolute; without a folder as they stand. Fails on text that is
/// not a recipe; options of kinds that no option has are left out and said.
[[nodiscard]] Result<Recipe> parseRecipe(std::string_view text, const std::filesystem::path& folder = {});
[[nodiscard]] Result<Recipe> loadRecipe(const std::filesystem::path& path);

}  // namespace lodestone
