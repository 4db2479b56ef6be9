#include "gui/perception/comparing_jobs.h"

#include "gui/widgets/picture_image.h"

namespace lodestone {
namespace {

std::shared_ptr<const ZoomPicture> zoomable(const Picture& picture) {
  return std::make_shared<const ZoomPicture>(toImage(picture));
}

}  // namespace

const ModelRenderer& LevelScene::renderer() const {
  std::call_once(once_,
                 [this] { renderer_ = std::make_unique<const ModelRenderer>(simplified_->mesh, look_); });
  return *renderer_;
}

ComparedPictures compareFrom(const ModelRenderer& original, const LevelScenes& levels, const Camera& camera,
                             double pixelsPerDegree, const Progress& progress) {
  ComparedPictures made;
  made.camera = camera;
  made.levels = levels;
  made.pixelsPerDegree = pixelsPerDegree;
  const Picture reference = original.render(camera, progress.part(0, 0.2, "original")).picture;
  made.original = zoomable(reference);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!levels[i]) continue;
    const double begin = 0.2 + 0.4 * static_cast<double>(i);
    const Picture test =
        levels[i]->renderer().render(camera, progress.part(begin, begin + 0.1, "level")).picture;
    made.errors[i] = std::make_shared<const FlipMap>(
        flip(reference, test, pixelsPerDegree, progress.part(begin + 0.1, begin + 0.4, "ꟻLIP")));
    made.pictures[i] = zoomable(test);
    made.maps[i] = zoomable(flipPicture(*made.errors[i]));
    made.differences[i] = LookDifference{made.errors[i]->mean, pixelError(reference, test)};
  }
  return made;
}

void measureViews(const ModelRenderer& original, const std::vector<ViewToMeasure>& views,
                  double pixelsPerDegree, const MeasureSink& sink, const Progress& progress) {
  for (std::size_t done = 0; done < views.size(); ++done) {
    const auto count = static_cast<double>(views.size());
    const Progress own = progress.part(static_cast<double>(done) / count,
                                       static_cast<double>(done + 1) / count, "measured views");
    const ViewToMeasure& wanted = views[done];
    const Picture reference = original.render(wanted.camera, own.part(0, 0.2)).picture;
    LookDifferences differences;
    for (std::size_t i = 0; i < wanted.levels.size(); ++i) {
      if (!wanted.levels[i]) continue;
      const double begin = 0.2 + 0.4 * static_cast<double>(i);
      const Picture test =
          wanted.levels[i]->renderer().render(wanted.camera, own.part(begin, begin + 0.1)).picture;
      const FlipMap map = flip(reference, test, pixelsPerDegree, own.part(begin + 0.1, begin + 0.4));
      differences[i] = LookDifference{map.mean, pixelError(reference, test)};
    }
    progress.checkpoint();
    sink(wanted.view, differences);
  }
}

}  // namespace lodestone
