// LOD chains: the original and cuts of the cluster tree (resources/docs/methods.md, 1.5).
#pragma once

#include <optional>

#include "model/artifacts.h"
#include "model/chain_options.h"
#include "model/io/recipe.h"
#include "model/perceive_options.h"
#include "model/progress.h"
#include "model/result.h"
#include "model/simplify_options.h"

namespace lodestone {

/// Why the tolerances cannot be taken (OptionBadValue); nothing where they can. makeChain() asks as well, but
/// then hours may have been spent.
[[nodiscard]] std::optional<Diagnostic> whyNoTolerances(const ChainOptions& options);

/// Level 0 is the city itself (finest exterior LoD of each building, or its footprint as a block); each
/// tolerance adds a level cut from the tree, in which clusters are blocks over their hulls, and single
/// buildings and landmarks look as in level 0. `tree` may be null: then there is level 0 alone. Objects are
/// made when asked for; the chain keeps the city and the tree alive.
///
/// A level's error is the greatest, over its clusters, of emptiness() (algorithms/merging/cutting.h) and the
/// difference in height to any building that it swallows; never less than the level's before it. Fails
/// (OptionBadValue) where the tolerances are not rising numbers above 0. A level is never heavier than the
/// one before it; one that is no lighter is said (LevelNotLighter). With ε = 0 nothing empty may be seen: no
/// level ever takes over, and its switch distance is infinite. \throw Cancelled
[[nodiscard]] Result<LodChain> makeChain(std::shared_ptr<const CityModel> city,
                                         std::shared_ptr<const ClusterTree> tree, const ChainOptions& options,
                                         const Progress& progress = {}, const ArtifactSink& sink = {});

/// The level that one camera's cut draws: what the workbench shows is what it exports. Objects stand in the
/// order of cut.drawn. Cost: linear in the buildings below what is drawn.
[[nodiscard]] LodLevel levelOfCut(std::shared_ptr<const CityModel> city,
                                  std::shared_ptr<const ClusterTree> tree, const Cut& cut);

/// A chain of one level: a city whose buildings were simplified. `error`: the Hausdorff distance to what they
/// were, metres. `perceive`: how it was looked at, where the method asks for that. It has no recipe: a
/// chain is not made this way. \throw Cancelled
[[nodiscard]] LodChain simplifiedChain(std::shared_ptr<const CityModel> city, const SimplifyOptions& options,
                                       double error, const PerceiveOptions& perceive = {});

/// The options that a recipe's levels name: how to make its chain again.
struct ChainPlan {
  ClusterOptions cluster;
  MergeOptions merge;
  ChainOptions chain;
};
/// Methods and options that are not known are said (OptionBadValue, OptionUnknown) and fail the plan.
[[nodiscard]] Result<ChainPlan> planOf(const Recipe& recipe);

}  // namespace lodestone
