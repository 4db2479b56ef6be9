#include "gui/perception/shown_pictures.h"

#include <QLocale>
#include <algorithm>
#include <cmath>

#include "gui/widgets/detail_looks.h"

namespace lodestone {
namespace {

constexpr std::size_t kMostPixels = 24'000'000;  // that are kept: some 30 bytes each
const QString kTask = QStringLiteral("perceive-view");

std::size_t pixelsOf(const ViewPictures& pictures) {
  return pictures.view->difference.bins.size();
}

}  // namespace

ShownPictures::ShownPictures(Perceiving& perceiving, Workspace& workspace, QObject* parent)
    : QObject(parent), perceiving_(perceiving), workspace_(workspace) {
  for (const auto change : {&Perceiving::lookedChanged, &Perceiving::viewChanged})
    connect(&perceiving_, change, this, &ShownPictures::follow);
  connect(&workspace_.tasks(), &TaskRunner::finished, this, [this](const QString& key, bool committed) {
    if (key != kTask) return;
    making_.reset();
    if (committed) follow();  // to cuts that have moved on
  });
}

/// What is asked for: nothing while the chosen view is not among those that were looked from.
std::optional<Camera> ShownPictures::wanted() const {
  const auto& looked = perceiving_.looked();
  if (!looked || perceiving_.view() >= looked->perception->cameras.size()) return {};
  return looked->perception->cameras[perceiving_.view()];
}

std::shared_ptr<const ViewPictures> ShownPictures::known(const Camera& camera) const {
  const auto& looked = *perceiving_.looked();
  const auto found = std::find_if(kept_.begin(), kept_.end(), [&](const auto& pictures) {
    return pictures->renderer == looked.renderer && pictures->view->camera == camera &&
           samePictures(pictures->options, looked.perception->options);
  });
  return found == kept_.end() ? nullptr : *found;
}

void ShownPictures::follow() {
  if (!perceiving_.looked()) {
    if (workspace_.tasks().busy(kTask)) workspace_.tasks().cancel(kTask);
    kept_.clear();
    return show(nullptr);
  }
  const auto camera = wanted();
  if (!camera) return;
  const auto same = known(*camera);
  if (same) show(same);
  if (same && same->classes.cuts == perceiving_.looked()->perception->differences.cuts) return;
  if (making_ == camera && workspace_.tasks().busy(kTask)) return;  // follows when it is there
  start(same);
}

void ShownPictures::start(std::shared_ptr<const ViewPictures> same) {
  making_ = wanted();
  workspace_.tasks().start(
      kTask, tr("Pictures of the view"),
      [looked = perceiving_.looked(), camera = *making_, same = std::move(same)](const Progress& progress) {
        return makeViewPictures(*looked, camera, same, progress);
      },
      [this, renderer = perceiving_.looked()->renderer](ViewPictures made) {
        if (!perceiving_.looked() || perceiving_.looked()->renderer != renderer) return;
        keep(std::make_shared<const ViewPictures>(std::move(made)));
      });
}

void ShownPictures::keep(std::shared_ptr<const ViewPictures> made) {
  std::erase_if(kept_, [&](const auto& old) { return old->view->camera == made->view->camera; });
  std::size_t pixels = pixelsOf(*made);
  kept_.push_front(made);
  for (std::size_t i = 1; i < kept_.size(); ++i) {
    pixels += pixelsOf(*kept_[i]);
    if (pixels > kMostPixels) kept_.resize(i);
  }
  if (wanted() == made->view->camera) show(std::move(made));
}

void ShownPictures::show(std::shared_ptr<const ViewPictures> pictures) {
  if (pictures == shown_) return;
  shown_ = std::move(pictures);
  Q_EMIT changed();
}

std::optional<std::uint32_t> ShownPictures::triangleAt(const QPoint& pixel) const {
  if (!shown_) return {};
  const DifferenceImage& image = shown_->view->difference;
  if (!QRect(0, 0, image.width, image.height).contains(pixel)) return {};
  const auto place = static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(pixel.x());
  const std::uint32_t triangle = shown_->view->rendered.triangle[place];
  return triangle == kNoTriangle ? std::nullopt : std::optional(triangle);
}

QString ShownPictures::textOf(const QPoint& pixel) const {
  if (!shown_) return {};
  const PerceivedView& view = *shown_->view;
  if (!QRect(0, 0, view.difference.width, view.difference.height).contains(pixel)) return {};
  const auto place = static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(view.difference.width) +
                     static_cast<std::size_t>(pixel.x());
  const float rendered = view.rendered.grey.pixels[place];
  const float filtered = view.filtered.pixels[place];
  const auto grey = [](float value) { return QLocale().toString(value, 'f', 1); };
  QString text = tr("Pixel %1, %2: rendered %3, filtered %4, difference %5")
                     .arg(pixel.x())
                     .arg(pixel.y())
                     .arg(grey(rendered), grey(filtered), grey(std::abs(rendered - filtered)));
  const auto triangle = triangleAt(pixel);
  if (!triangle) return text + tr("; background");
  text += tr("; %1, triangle %L2")
              .arg(nameOf(shown_->classes.of(view.difference.bins[place])).toLower())
              .arg(*triangle);
  const auto& looked = perceiving_.looked();
  if (looked && *triangle < looked->perception->classes.size())
    text += tr(" (%1)").arg(nameOf(looked->perception->classes[*triangle]).toLower());
  return text;
}

}  // namespace lodestone
