#include "algorithms/perception/perceiving.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <mutex>

#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "algorithms/geometry/parallel.h"
#include "algorithms/perception/difference_classes.h"
#include "algorithms/perception/hvs_filter.h"
#include "model/detail_colours.h"

namespace lodestone {
namespace {

/// Share of the time that pictures take; the second look at what none shows takes the rest, or less.
constexpr double kLooking = 0.75;

/// Held at the greatest number: a wall that fills all of very many very large pictures was seen all the same.
void increase(std::uint32_t& count) {
  if (count < std::numeric_limits<std::uint32_t>::max()) ++count;
}

/// Adds what a view shows of the model to the counts; adding is all, so the order of views does not matter.
void count(const PerceivedView& view, Perception& perception, std::vector<std::uint32_t>& triangleBins) {
  for (std::size_t place = 0; place < view.difference.bins.size(); ++place) {
    const std::uint32_t triangle = view.rendered.triangle[place];
    if (triangle == kNoTriangle) continue;
    const std::size_t bin = view.difference.bins[place];
    ++perception.histogram[bin];
    increase(perception.pixels[triangle]);
    increase(triangleBins[static_cast<std::size_t>(triangle) * kDifferenceBins + bin]);
  }
}

Perception nothingYet(std::size_t triangles, const std::vector<Camera>& cameras,
                      const PerceiveOptions& options) {
  Perception perception;
  perception.options = options;
  perception.cameras = cameras;
  perception.pixels.resize(triangles);
  return perception;
}

void glimpse(const ModelRenderer& renderer, const std::vector<Vec3>& closer, Perception& perception,
             const Progress& progress) {
  if (closer.empty()) return;
  std::vector<bool> unseen(perception.pixels.size());
  for (std::size_t t = 0; t < unseen.size(); ++t) unseen[t] = perception.pixels[t] == 0;
  perception.glimpsed = renderer.visibleFrom(closer, unseen, progress);
}

/// `colourOf(place)` gives the colour of a pixel: three bytes.
template <class ColourOf>
Picture pictureOf(int width, int height, const ColourOf& colourOf) {
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Picture picture{width, height, std::vector<std::uint8_t>(4 * pixels, 255)};
  for (std::size_t place = 0; place < pixels; ++place) {
    const std::array<std::uint8_t, 3> colour = colourOf(place);
    std::copy(colour.begin(), colour.end(), picture.rgba.begin() + static_cast<std::ptrdiff_t>(4 * place));
  }
  return picture;
}

std::array<std::uint8_t, 3> greyOf(float value) {
  const auto grey = static_cast<std::uint8_t>(std::clamp(value, 0.F, 255.F) + 0.5F);
  return {grey, grey, grey};
}

/// Too large to have one in work for each thread: such views come one after the other, and share out their
/// rows alone. Others come side by side, since the filter of a view is work for one thread.
bool isLarge(const Camera& camera) {
  constexpr double kMostPixels = 2048.0 * 2048.0;
  return static_cast<double>(camera.width) * camera.height > kMostPixels;
}

std::size_t threadsHere() {
  const std::size_t allowed = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  return std::min(static_cast<std::size_t>(tbb::this_task_arena::max_concurrency()), allowed);
}

/// Grey levels that the difference picture shows as white: where the dramatic ones are in the mean.
double whiteAt(const DifferenceClasses& classes) {
  constexpr double kLeast = 4;
  double white = kLeast;
  for (const Gaussian& gaussian : classes.gaussians) {
    if (gaussian.prior > 0) white = std::max(white, gaussian.mean + gaussian.sigma);
  }
  return white;
}

}  // namespace

PerceivedView perceiveView(const ModelRenderer& renderer, const Camera& camera,
                           const PerceiveOptions& options, const Progress& progress) {
  PerceivedView view;
  view.camera = camera;
  view.rendered = renderer.render(camera, progress);
  view.filtered = filterAsSeen(view.rendered.grey, options);
  const std::vector<float>& seen = view.rendered.grey.pixels;
  view.difference = {camera.width, camera.height, std::vector<std::uint8_t>(seen.size()),
                     std::vector<bool>(seen.size())};
  for (std::size_t place = 0; place < seen.size(); ++place) {
    view.difference.bins[place] =
        static_cast<std::uint8_t>(differenceBin(std::abs(seen[place] - view.filtered.pixels[place])));
    view.difference.shown[place] = view.rendered.triangle[place] != kNoTriangle;
  }
  return view;
}

Picture greyPicture(const GreyImage& image) {
  return pictureOf(image.width, image.height, [&](std::size_t place) { return greyOf(image.pixels[place]); });
}

Picture differencePicture(const DifferenceImage& image, const DifferenceClasses& classes) {
  const double white = whiteAt(classes);
  return pictureOf(image.width, image.height, [&](std::size_t place) {
    return greyOf(static_cast<float>(255 * binBegin(image.bins[place]) / white));
  });
}

Picture classPicture(const DifferenceImage& image, const DifferenceClasses& classes) {
  return pictureOf(image.width, image.height, [&](std::size_t place) -> std::array<std::uint8_t, 3> {
    if (!image.shown[place]) return {255, 255, 255};
    const auto colour = detailColour(classes.of(image.bins[place]));
    std::array<std::uint8_t, 3> bytes{};
    for (std::size_t c = 0; c < 3; ++c) bytes[c] = static_cast<std::uint8_t>(255 * colour[c] + 0.5F);
    return bytes;
  });
}

Perception perceive(const ModelRenderer& renderer, const std::vector<Camera>& cameras,
                    const PerceiveOptions& options, const Progress& whole, const ViewSink& sink,
                    const std::vector<Vec3>& closer) {
  const Progress progress = whole.part(0, kLooking);
  Perception perception = nothingYet(renderer.triangleCount(), cameras, options);
  const auto triangleBins =
      std::make_shared<std::vector<std::uint32_t>>(perception.pixels.size() * kDifferenceBins);
  std::mutex mutex;
  const auto look = [&](std::size_t i, const Progress& own) {
    PerceivedView view = perceiveView(renderer, cameras[i], options, own);
    {
      const std::lock_guard lock(mutex);
      count(view, perception, *triangleBins);
    }
    if (sink) sink(i, std::move(view));
  };
  if (std::any_of(cameras.begin(), cameras.end(), isLarge)) {
    const auto views = static_cast<double>(cameras.size());
    for (std::size_t i = 0; i < cameras.size(); ++i)
      look(i, progress.part(static_cast<double>(i) / views, static_cast<double>(i + 1) / views));
  } else {
    const Progress silent({}, progress.stopToken());
    forPiecesReported(cameras.size(), 1, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        try {
          // A thread that waits for the rows of its view begins no other one: views in work would pile up.
          tbb::this_task_arena::isolate([&] { look(i, silent); });
        } catch (const Cancelled&) {  // stays in this thread: said at the checkpoint below
        }
      }
    });
  }
  progress.checkpoint();
  perception.triangleBins = triangleBins;
  glimpse(renderer, closer, perception, whole.part(kLooking, 1));
  return judgedAgain(std::move(perception), options);
}

std::size_t viewsAtOnce(const std::vector<Camera>& cameras) {
  if (std::any_of(cameras.begin(), cameras.end(), isLarge)) return 1;
  return std::min(cameras.size(), threadsHere());
}

double perceivingMemory(const std::vector<Camera>& cameras, std::size_t triangles, std::size_t models) {
  constexpr double kBytesOfPixel = 20;  // colour, grey, filtered, identity, bin, and what the filter works on
  double largest = 0;
  for (const Camera& camera : cameras)
    largest = std::max(largest, static_cast<double>(camera.width) * camera.height);
  // A thread has one view in work, whichever model it is of.
  const std::size_t views = std::min(viewsAtOnce(cameras) * models, threadsHere());
  const double bytesOfTriangles = static_cast<double>(triangles) * kDifferenceBins * sizeof(std::uint32_t);
  return kBytesOfPixel * largest * static_cast<double>(views) +
         bytesOfTriangles * static_cast<double>(models);
}

Perception judgedAgain(Perception perception, const PerceiveOptions& options) {
  perception.options = options;
  perception.differences = classifyDifferences(perception.histogram, options);
  perception.classes = classesOfTriangles(perception, perception.differences);
  return perception;
}

}  // namespace lodestone
