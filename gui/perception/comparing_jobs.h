// How levels are compared with the original by pictures, on worker threads.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "algorithms/perception/comparison.h"
#include "gui/perception/perceiving_jobs.h"

namespace lodestone {

/// What a method of the stage made, ready for ray casting as soon as somebody asks. Safe from any thread.
class LevelScene {
 public:
  LevelScene(std::shared_ptr<const Simplified> simplified, std::shared_ptr<const ModelLook> look)
      : simplified_(std::move(simplified)), look_(std::move(look)) {}
  [[nodiscard]] const std::shared_ptr<const Simplified>& simplified() const { return simplified_; }
  [[nodiscard]] const ModelRenderer& renderer() const;

 private:
  std::shared_ptr<const Simplified> simplified_;
  std::shared_ptr<const ModelLook> look_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<const ModelRenderer> renderer_;
};

/// By Stage::Method; null: there is none.
using LevelScenes = std::array<std::shared_ptr<const LevelScene>, Stage::MethodCount>;

/// How different each level looks from the original, from one viewpoint.
using LevelMeasures = std::array<std::optional<PictureMeasures>, Stage::MethodCount>;

/// The original and the levels from one viewpoint.
struct ComparedPictures {
  Camera camera;
  LevelScenes levels;
  double pixelsPerDegree = 0;
  std::shared_ptr<const ZoomPicture> original;
  std::array<std::shared_ptr<const ZoomPicture>, Stage::MethodCount> pictures;
  std::array<std::shared_ptr<const ZoomPicture>, Stage::MethodCount> maps;
  std::array<std::shared_ptr<const FlipMap>, Stage::MethodCount> errors;
  LevelMeasures measures;
};

/// \throw Cancelled
[[nodiscard]] ComparedPictures compareFrom(const ModelRenderer& original, const LevelScenes& levels,
                                           const Camera& camera, double pixelsPerDegree,
                                           const Progress& progress);

/// A view to measure, of the levels that `levels` has.
struct ViewToMeasure {
  std::size_t view = 0;
  Camera camera;
  LevelScenes levels;
};
using MeasureSink = std::function<void(std::size_t view, const LevelMeasures& measures)>;

/// One view after the other; the sink is told of each. \throw Cancelled
void measureViews(const ModelRenderer& original, const std::vector<ViewToMeasure>& views,
                  double pixelsPerDegree, const MeasureSink& sink, const Progress& progress);

}  // namespace lodestone
