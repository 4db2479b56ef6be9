// Recipes: how a chain was made, as JSON text that makes it again (resources/schemas/recipe.json).
#pragma once

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
  std::vector<std::string> sources;   ///< paths, as the model names them
  OptionValues import;                ///< how the sources were read
  std::vector<std::string> barriers;  ///< layers of lines that clusters do not cross
  std::vector<RecipeLevel> levels;    ///< from fine to coarse
  std::vector<std::string> exports;   ///< ids of formats
  bool operator==(const Recipe&) const = default;
};

[[nodiscard]] Recipe recipeOf(const LodChain& chain, std::vector<std::string> exports = {});
/// The same recipe gives the same bytes.
[[nodiscard]] std::string recipeText(const Recipe& recipe);
/// Fails on text that is not a recipe; options of kinds that no option has are left out and said.
[[nodiscard]] Result<Recipe> parseRecipe(std::string_view text);

}  // namespace lodestone
