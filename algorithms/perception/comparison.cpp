#include "algorithms/perception/comparison.h"

namespace lodestone {
namespace {

/// Sums over pixels, which views add to.
struct Sums {
  double pixels = 0;
  double shown = 0;
  double different = 0;
  double errors = 0;
  double errorsShown = 0;

  void operator+=(const Sums& other) {
    pixels += other.pixels;
    shown += other.shown;
    different += other.different;
    errors += other.errors;
    errorsShown += other.errorsShown;
  }

  [[nodiscard]] PictureMeasures measures() const {
    if (pixels == 0) return {};
    return {errors / pixels, shown > 0 ? errorsShown / shown : 0, different / pixels, shown / pixels};
  }
};

Sums sumsOf(const ModelPicture& first, const ModelPicture& second, const FlipMap& difference) {
  Sums sums;
  sums.pixels = static_cast<double>(difference.errors.size());
  sums.errors = difference.mean * sums.pixels;
  sums.different = pixelError(first.picture, second.picture) * sums.pixels;
  for (std::size_t i = 0; i < difference.errors.size(); ++i) {
    if (first.triangle[i] == kNoTriangle && second.triangle[i] == kNoTriangle) continue;
    ++sums.shown;
    sums.errorsShown += static_cast<double>(difference.errors[i]);
  }
  return sums;
}

}  // namespace

ModelComparison compareModels(const ModelRenderer& first, const ModelRenderer& second,
                              const std::vector<Camera>& cameras, double pixelsPerDegree,
                              const Progress& progress, const ComparedViewSink& sink) {
  ModelComparison comparison;
  Sums all;
  for (std::size_t view = 0; view < cameras.size(); ++view) {
    const auto step = [&](int third) {
      return (static_cast<double>(view) + third / 3.0) / static_cast<double>(cameras.size());
    };
    ModelPicture a = first.render(cameras[view], progress.part(step(0), step(1)));
    ModelPicture b = second.render(cameras[view], progress.part(step(1), step(2)));
    FlipMap difference = flip(a.picture, b.picture, pixelsPerDegree, progress.part(step(2), step(3)));
    const Sums sums = sumsOf(a, b, difference);
    all += sums;
    comparison.views.push_back(sums.measures());
    if (sink) sink(view, {std::move(a.picture), std::move(b.picture), std::move(difference)});
  }
  comparison.all = all.measures();
  return comparison;
}

}  // namespace lodestone
