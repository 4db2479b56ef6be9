#include "gui/perception/perceiving_jobs.h"

#include <chrono>

#include "algorithms/perception/viewpoints.h"
#include "gui/perception/viewpoint_strip.h"
#include "gui/widgets/picture_image.h"

namespace lodestone {
namespace {

ViewSink shrinking(const ThumbnailSink& sink) {
  return [&sink](std::size_t view, PerceivedView&& pictures) {
    const int side = ViewpointStrip::kSide;
    sink(
        view,
        toImage(pictures.rendered.picture).scaled(side, side, Qt::KeepAspectRatio, Qt::SmoothTransformation));
  };
}

PerceiveOptions withoutCuts(PerceiveOptions options) {
  options.slight = options.moderate = options.dramatic = 0;
  return options;
}

}  // namespace

bool samePictures(const PerceiveOptions& a, const PerceiveOptions& b) {
  return withoutCuts(a) == withoutCuts(b);
}

Looked lookAt(std::shared_ptr<const StagedBuilding> staged, std::shared_ptr<const Looked> earlier,
              const std::vector<Camera>& cameras, const PerceiveOptions& options, const ThumbnailSink& sink,
              const Progress& progress) {
  Looked looked;
  looked.staged = std::move(staged);
  if (earlier && earlier->staged->mesh == looked.staged->mesh) {
    looked.look = earlier->look;
    looked.renderer = earlier->renderer;
  } else {
    looked.look = readModelLook(*looked.staged->city, *looked.staged->mesh, &looked.diagnostics,
                                progress.part(0, 0.04, "textures"));
    looked.renderer = std::make_shared<const ModelRenderer>(*looked.staged->mesh, looked.look);
  }
  const auto begin = std::chrono::steady_clock::now();
  looked.perception = std::make_shared<const Perception>(
      perceive(*looked.renderer, cameras, options, progress.part(0.05, 1, "viewpoints"), shrinking(sink),
               closerViewpoints(bounds(*looked.staged->mesh), options)));
  looked.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return looked;
}

Looked judgeAgain(Looked looked, const PerceiveOptions& options) {
  looked.perception = std::make_shared<const Perception>(judgedAgain(*looked.perception, options));
  looked.diagnostics.clear();  // they were told
  return looked;
}

ViewPictures makeViewPictures(const Looked& looked, const Camera& camera,
                              std::shared_ptr<const ViewPictures> same, const Progress& progress) {
  ViewPictures made;
  made.renderer = looked.renderer;
  made.options = looked.perception->options;
  made.classes = looked.perception->differences;
  if (same) {
    made.view = same->view;
    made.pictures = same->pictures;
  } else {
    made.view = std::make_shared<const PerceivedView>(
        perceiveView(*looked.renderer, camera, made.options, progress.part(0, 0.8, "view")));
    made.pictures[0] = zoomable(made.view->rendered.picture);
    made.pictures[1] = zoomable(greyPicture(made.view->filtered));
  }
  progress.checkpoint();
  made.pictures[2] = zoomable(differencePicture(made.view->difference, made.classes));
  progress.checkpoint();
  made.pictures[3] = zoomable(classPicture(made.view->difference, made.classes));
  return made;
}

}  // namespace lodestone
