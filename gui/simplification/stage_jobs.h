// What the stage has worker threads do.
#pragma once

#include "gui/simplification/stage.h"
#include "model/result.h"

namespace lodestone {

/// The triangles of a building (and of those that it touches), their classes, and how they are drawn. \throw
/// Cancelled
[[nodiscard]] Result<StagedBuilding> stageBuilding(std::shared_ptr<const CityModel> city, NodeId building,
                                                   bool withTouching, double gap, const Progress& progress);

/// The same building with its classes by another gap. \throw Cancelled
[[nodiscard]] StagedBuilding classifyStaged(StagedBuilding staged, double gap, const Progress& progress);

/// Without the report, but where the search for a has made it. \pre methods that ask pictures have a
/// `perception` of the building; of others it is null \throw Cancelled
[[nodiscard]] StagedLevel makeStagedLevel(const StagedBuilding& staged,
                                          std::shared_ptr<const Perception> perception,
                                          const SimplifyOptions& options, const Progress& progress);

/// By the contacts of the stage. \throw Cancelled
[[nodiscard]] SimplifyReport measureStagedLevel(const StagedBuilding& staged, const StagedLevel& level,
                                                const Progress& progress);

}  // namespace lodestone
