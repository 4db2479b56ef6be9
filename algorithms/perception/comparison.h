// How different two models look from the same places (resources/docs/methods.md, 5.5).
#pragma once

#include <functional>
#include <vector>

#include "algorithms/perception/flip.h"
#include "algorithms/rendering/model_rendering.h"
#include "model/camera.h"
#include "model/progress.h"

namespace lodestone {

/// What pictures of two models differ in.
struct PictureMeasures {
  double flip = 0;        ///< mean ꟻLIP of all pixels
  double flipShown = 0;   ///< mean ꟻLIP of the pixels that show either model: the background does not count
  double pixelError = 0;  ///< share of all pixels that differ at all
  double shown = 0;       ///< share of all pixels that show either model
};

struct ModelComparison {
  std::vector<PictureMeasures> views;  ///< by camera
  PictureMeasures all;                 ///< over the pixels of all views together
};

/// Both models as one view shows them.
struct ComparedView {
  Picture first;
  Picture second;
  FlipMap difference;
};

/// Called for each view in turn, from the calling thread.
using ComparedViewSink = std::function<void(std::size_t view, ComparedView&& pictures)>;

/// Looks at both models with every camera; the first is the reference. \pre both stand in one frame. Cost: of
/// each view, two render() and one flip(). Memory: of one view. The same for any number of threads. \throw
/// Cancelled
[[nodiscard]] ModelComparison compareModels(const ModelRenderer& first, const ModelRenderer& second,
                                            const std::vector<Camera>& cameras, double pixelsPerDegree,
                                            const Progress& progress = {}, const ComparedViewSink& sink = {});

}  // namespace lodestone
