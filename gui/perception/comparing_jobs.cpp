#include "gui/perception/comparing_jobs.h"

namespace lodestone {

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
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (!levels[i]) continue;
    const double begin = static_cast<double>(i) / levels.size();
    const ComparedViewSink take = [&](std::size_t, ComparedView&& view) {
      made.original = zoomable(view.first);
      made.pictures[i] = zoomable(view.second);
      made.maps[i] = zoomable(flipPicture(view.difference));
      made.errors[i] = std::make_shared<const FlipMap>(std::move(view.difference));
    };
    made.measures[i] = compareModels(original, levels[i]->renderer(), {camera}, pixelsPerDegree,
                                     progress.part(begin, begin + 1.0 / levels.size(), "compare"), take)
                           .all;
  }
  if (!made.original) made.original = zoomable(original.render(camera, progress).picture);
  return made;
}

void measureViews(const ModelRenderer& original, const std::vector<ViewToMeasure>& views,
                  double pixelsPerDegree, const MeasureSink& sink, const Progress& progress) {
  const auto count = static_cast<double>(views.size());
  for (std::size_t done = 0; done < views.size(); ++done) {
    const Progress own = progress.part(static_cast<double>(done) / count,
                                       static_cast<double>(done + 1) / count, "measured views");
    LevelMeasures measures;
    for (std::size_t i = 0; i < measures.size(); ++i) {
      if (const auto& level = views[done].levels[i])
        measures[i] =
            compareModels(original, level->renderer(), {views[done].camera}, pixelsPerDegree, own.part(0, 1))
                .all;
    }
    progress.checkpoint();
    sink(views[done].view, measures);
  }
}

}  // namespace lodestone
