// What people perceive of the building on the stage: pictures from many viewpoints, and the classes of detail
// that they give its triangles (Du, Zhu and Zhao).
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

#include "gui/perception/perceiving_jobs.h"

namespace lodestone {

/// Looks in the background, again when what is looked with changes; what was seen last stays until then, and
/// is judged again as soon as thresholds change. Tells the stage. Lives on the GUI thread.
class Perceiving : public QObject {
  Q_OBJECT

 public:
  Perceiving(Stage& stage, Workspace& workspace, QObject* parent = nullptr);

  [[nodiscard]] Stage& stage() const { return stage_; }
  [[nodiscard]] const PerceiveOptions& options() const;
  void setOptions(const PerceiveOptions& options, const QString& what);
  /// The dock, or the classes on the model, are there to be seen: without, nobody looks unless a method asks.
  void setWatched(bool watched);

  /// Viewpoints by the options, and then those that were added.
  [[nodiscard]] std::vector<Camera> cameras() const;
  /// A square picture of what the camera sees is one more viewpoint.
  void addCamera(const Camera& camera);
  [[nodiscard]] bool isAdded(std::size_t view) const;
  void removeCamera(std::size_t view);

  /// Null: nothing was looked at yet.
  [[nodiscard]] const std::shared_ptr<const Looked>& looked() const { return looked_; }
  [[nodiscard]] const QImage& thumbnail(std::size_t view) const;
  /// There are surfaces to look at.
  [[nodiscard]] bool canLook() const;
  /// What is known is of other options or viewpoints than those set now, or there is nothing.
  [[nodiscard]] bool isOutdated() const;
  /// The pictures are those of the options, but judging them by these cuts was stopped or failed.
  [[nodiscard]] bool isLeftUnjudged() const;
  [[nodiscard]] bool isLooking() const;
  /// Pictures that the look under way has made so far.
  [[nodiscard]] std::size_t made() const { return made_; }
  /// So much to do that a person says when.
  [[nodiscard]] bool isLarge() const;
  /// An estimate of looking once.
  [[nodiscard]] double seconds() const;
  [[nodiscard]] double gibibytes() const;
  /// Or judges again what was left unjudged.
  void look();
  void cancel();

  /// The view whose pictures are shown.
  [[nodiscard]] std::size_t view() const { return view_; }
  void choose(std::size_t view);

 Q_SIGNALS:
  void optionsChanged();
  void camerasChanged();
  void thumbnailMade(std::size_t view);
  void lookedChanged();
  /// A look began, ended, or waits for somebody to start it.
  void looking();
  void viewChanged();
  /// A method waits for pictures that take so much that a person has to say when.
  void consentWanted();

 private:
  void onOptions(const PerceiveOptions& before);
  void forget();
  void follow();
  void judge();
  void take(Looked looked);
  void takeThumbnail(unsigned run, std::size_t view, const QImage& picture);
  [[nodiscard]] bool isWanted() const;

  Stage& stage_;
  Workspace& workspace_;
  bool watched_ = false;
  bool stopped_ = false;     ///< by a person: waits for another change
  bool forgetting_ = false;  ///< a look that was cancelled with its building has not ended yet
  std::vector<Camera> added_;
  std::shared_ptr<const Looked> looked_;
  std::vector<QImage> thumbnails_;
  unsigned run_ = 0;  ///< pictures of earlier ones are dropped
  std::size_t made_ = 0;
  std::size_t view_ = 0;
  double secondsAPixel_;
  QTimer debounce_;
};

}  // namespace lodestone
