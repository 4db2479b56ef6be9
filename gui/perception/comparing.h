// How the levels on the stage look beside the original: by ꟻLIP and by pixels that differ, from the chosen
// viewpoint and from viewpoints that nothing was classified by.
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "gui/perception/comparing_jobs.h"
#include "gui/perception/perceiving.h"

namespace lodestone {

/// Compares in the background while somebody watches, again when a level or the pictures change; what was
/// measured of a level that stays is kept. Lives on the GUI thread.
class Comparing : public QObject {
  Q_OBJECT

 public:
  Comparing(Perceiving& perceiving, Workspace& workspace, QObject* parent = nullptr);

  [[nodiscard]] Perceiving& perceiving() const { return perceiving_; }
  void setWatched(bool watched);

  /// A measured view whose pictures are shown; none: the chosen viewpoint's are.
  [[nodiscard]] std::optional<std::size_t> view() const { return view_; }
  void choose(std::optional<std::size_t> view);
  /// Of the view that is shown, or of the one before while they are made; null: nothing yet.
  [[nodiscard]] const std::shared_ptr<const ComparedPictures>& pictures() const { return pictures_; }
  /// Viewpoints that are measured from.
  [[nodiscard]] const std::vector<Camera>& cameras() const { return cameras_; }
  [[nodiscard]] const LevelMeasures& measures(std::size_t view) const { return measured_[view]; }
  /// Means over the views that are measured so far, and how many these are.
  struct Pooled {
    PictureMeasures mean;
    std::size_t views = 0;
  };
  [[nodiscard]] Pooled pooled(Stage::Method method) const;
  [[nodiscard]] bool hasLevel(Stage::Method method) const { return levels_[method] != nullptr; }
  [[nodiscard]] bool isBusy() const;
  /// Everything is there that there can be.
  [[nodiscard]] bool isDone() const;
  void cancel();
  /// Goes on after cancel().
  void resume();

 Q_SIGNALS:
  void picturesChanged();
  void measuredChanged();
  void viewChanged();

 private:
  void follow();
  void update();
  void takeLevels();
  void showView();
  void measure();
  void takeMeasures(unsigned run, std::size_t view, const LevelMeasures& measures);
  [[nodiscard]] std::optional<Camera> camera() const;
  [[nodiscard]] bool isShown() const;

  Perceiving& perceiving_;
  Workspace& workspace_;
  bool watched_ = false;
  bool stopped_ = false;
  std::shared_ptr<const ModelRenderer> original_;
  double pixelsPerDegree_ = 0;
  LevelScenes levels_;
  std::vector<Camera> cameras_;
  std::vector<LevelMeasures> measured_;  ///< by view
  std::shared_ptr<const ComparedPictures> pictures_;
  std::optional<std::size_t> view_;
  bool measuring_ = false;  ///< else pictures are made, where anything is
  unsigned run_ = 0;
  QTimer debounce_;
};

}  // namespace lodestone
