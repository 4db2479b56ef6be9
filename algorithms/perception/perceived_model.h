// A model of a city's buildings as people perceive it (Du, Zhu and Zhao; resources/docs/methods.md, 5).
#pragma once

#include "algorithms/rendering/texture_cache.h"
#include "model/component_mesh.h"
#include "model/diagnostics.h"
#include "model/perception.h"
#include "model/progress.h"

namespace lodestone {

/// Looks at `mesh`, made of buildings of the city of `textures`, from viewpointsAround() it. Images that
/// cannot be had are told of, and a model that no picture shows (Code::ModelNotSeen). In parallel, the same
/// for any number of threads. \throw Cancelled; std::runtime_error when Embree cannot build the scene
[[nodiscard]] Perception perceiveModel(TextureCache& textures, const ComponentMesh& mesh,
                                       const PerceiveOptions& options, Diagnostics* diagnostics = nullptr,
                                       const Progress& progress = {});

}  // namespace lodestone
