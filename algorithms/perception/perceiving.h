// Pictures of a model, what the eye filters away of them, and the triangles that this concerns (Du, Zhu and
// Zhao, section 3; resources/docs/methods.md, 5).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "algorithms/rendering/model_rendering.h"
#include "model/component_mesh.h"
#include "model/perception.h"
#include "model/progress.h"

namespace lodestone {

/// What the eye filters away of a view. Rows from the top.
struct DifferenceImage {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bins;  ///< of the magnitude of rendered − filtered (differenceBin())
  std::vector<bool> shown;         ///< the pixel shows the model
};

/// All pictures of one view.
struct PerceivedView {
  Camera camera;
  ModelPicture rendered;
  GreyImage filtered;  ///< what the eye lets through
  DifferenceImage difference;
};

/// Cost: one render() and linear in the pixels. \throw Cancelled
[[nodiscard]] PerceivedView perceiveView(const ModelRenderer& renderer, const Camera& camera,
                                         const PerceiveOptions& options, const Progress& progress = {});

/// As pictures: a grey image; the difference, black where there is none and white where it is as great as
/// that of most dramatic changes; the classes in their colours (model/detail_colours.h) on white.
[[nodiscard]] Picture greyPicture(const GreyImage& image);
[[nodiscard]] Picture differencePicture(const DifferenceImage& image, const DifferenceClasses& classes);
[[nodiscard]] Picture classPicture(const DifferenceImage& image, const DifferenceClasses& classes);

/// Called for each view as it is made, in any order, from any thread, several at the same time.
using ViewSink = std::function<void(std::size_t view, PerceivedView&& pictures)>;

/// Looks at a model from `cameras` (viewpointsAround(), or any others). Triangles that no picture shows are
/// looked for once more, by rays alone, from `closer` (closerViewpoints()): what is in sight from there is
/// glimpsed, not unseen. Memory (perceivingMemory()): 20 bytes a pixel of a view for each thread (of one
/// view, where they are large), and 1 KiB a triangle. In parallel, the same for any number of threads. \throw
/// Cancelled
[[nodiscard]] Perception perceive(const ModelRenderer& renderer, const std::vector<Camera>& cameras,
                                  const PerceiveOptions& options, const Progress& progress = {},
                                  const ViewSink& sink = {}, const std::vector<Vec3>& closer = {});

/// How many of these views perceive() has in work, and in memory, at the same time when it is called from
/// here: one of large ones, of others one for each thread.
[[nodiscard]] std::size_t viewsAtOnce(const std::vector<Camera>& cameras);

/// Bytes that perceive() takes when it is called from here, less what its sink keeps, for one model of so
/// many triangles, or for `models` of them side by side, each called from a thread of its own.
[[nodiscard]] double perceivingMemory(const std::vector<Camera>& cameras, std::size_t triangles,
                                      std::size_t models = 1);

/// The same pictures judged by other thresholds; the bins of triangles are shared, not copied. \pre the
/// options differ in thresholds alone. Cost: O(triangles · bins).
[[nodiscard]] Perception judgedAgain(Perception perception, const PerceiveOptions& options);

}  // namespace lodestone
