// What the Perception dock has worker threads do.
#pragma once

#include <QImage>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

#include "algorithms/perception/perceiving.h"
#include "gui/perception/zoom_picture.h"
#include "gui/simplification/stage.h"

namespace lodestone {

/// Pictures by one are pictures by the other: they differ in thresholds alone.
[[nodiscard]] bool samePictures(const PerceiveOptions& a, const PerceiveOptions& b);

/// What pictures say of the building on the stage. Never changed once made.
struct Looked {
  std::shared_ptr<const StagedBuilding> staged;
  std::shared_ptr<const ModelLook> look;
  std::shared_ptr<const ModelRenderer> renderer;
  std::shared_ptr<const Perception> perception;
  Diagnostics diagnostics;  ///< of textures that are missing
  double seconds = 0;       ///< that the pictures took
};

/// Called with a small picture of each view as it is made, from any thread, one call at a time.
using ThumbnailSink = std::function<void(std::size_t view, const QImage& picture)>;

/// Looks from all cameras; textures and scene are those of `earlier` (may be null) where it is of the same
/// building. \throw Cancelled
[[nodiscard]] Looked lookAt(std::shared_ptr<const StagedBuilding> staged,
                            std::shared_ptr<const Looked> earlier, const std::vector<Camera>& cameras,
                            const PerceiveOptions& options, const ThumbnailSink& sink,
                            const Progress& progress);
/// The same pictures by other thresholds. Cost: O(triangles · bins).
[[nodiscard]] Looked judgeAgain(Looked looked, const PerceiveOptions& options);

/// The pictures of one view: rendered, filtered, difference, classes.
struct ViewPictures {
  std::shared_ptr<const ModelRenderer> renderer;
  std::shared_ptr<const PerceivedView> view;
  PerceiveOptions options;
  DifferenceClasses classes;
  std::array<std::shared_ptr<const ZoomPicture>, 4> pictures;
};

/// `same` (may be null) is the view where it is known already. \throw Cancelled
[[nodiscard]] ViewPictures makeViewPictures(const Looked& looked, const Camera& camera,
                                            std::shared_ptr<const ViewPictures> same,
                                            const Progress& progress);

}  // namespace lodestone
