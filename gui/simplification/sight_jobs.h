// What a visibility analysis has worker threads do.
#pragma once

#include <array>
#include <memory>
#include <optional>

#include "algorithms/rendering/visibility.h"
#include "gui/simplification/stage.h"
#include "gui/view3d/surroundings.h"
#include "model/sight_options.h"

namespace lodestone {

/// The models that are looked past: the original, and what each method of the stage made of it.
enum class Past : std::uint8_t { Original, A, B };
inline constexpr std::array<Past, 3> kPasts{Past::Original, Past::A, Past::B};

/// Models by Past; null: there is none yet.
using PastModels = std::array<std::shared_ptr<const ComponentMesh>, kPasts.size()>;

/// What is seen from a viewpoint. Never changed once made.
struct Seen {
  SightOptions options;
  PastModels models;
  std::shared_ptr<const Surroundings> around;       ///< whose buildings are the targets
  std::shared_ptr<const OwnedTriangles> triangles;  ///< of the targets
  std::size_t within = 0;                           ///< targets that distance reaches
  std::optional<std::uint32_t> enclosing;           ///< a target that the eye is inside
  /// Past each model; null where there is none, and everywhere while no viewpoint is placed.
  std::array<std::shared_ptr<const Sighting>, kPasts.size()> sightings;
};

[[nodiscard]] Viewpoint viewpointOf(const SightOptions& options);
/// The targets are the buildings around the viewpoint and the stage as far as sight goes. What `earlier` (may
/// be null) has of the same targets and models is taken over. Cost: one lookFrom() a model. \throw Cancelled
[[nodiscard]] Seen lookPast(const StagedBuilding& staged, const SightOptions& options,
                            const PastModels& models, const Seen* earlier, const Progress& progress);
/// Past a model, of a target by its place in the surroundings.
[[nodiscard]] TargetFate fateOf(const Seen& seen, Past past, std::uint32_t target);

}  // namespace lodestone
