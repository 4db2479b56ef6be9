// Visibility analysis on the stage: which other buildings of the city are seen past the original, and past
// what methods made of it (Wang et al. 2021, section 4.3).
#pragma once

#include <QObject>
#include <QTimer>
#include <memory>
#include <optional>

#include "gui/simplification/sight_jobs.h"

namespace lodestone {

/// Looks in the background, again with every change of the viewpoint and of what is on the stage; the last
/// good result stays until a new one is there. Lives on the GUI thread.
class Sight : public QObject {
  Q_OBJECT

 public:
  Sight(Stage& stage, Workspace& workspace, QObject* parent = nullptr);

  [[nodiscard]] Stage& stage() const { return stage_; }
  [[nodiscard]] const SightOptions& options() const;
  /// Changes with one `mergeKey` are undone together.
  void setOptions(const SightOptions& options, const QString& what, const QString& mergeKey = {});
  /// Takes the viewpoint away.
  void remove();
  /// The next click in the view is the viewpoint's ground.
  [[nodiscard]] bool isPlacing() const { return placing_; }
  void setPlacing(bool placing);
  /// There are other buildings than those on the stage.
  [[nodiscard]] bool hasTargets() const;

  /// Null while there is nothing to show: no viewpoint and none being placed.
  [[nodiscard]] const std::shared_ptr<const Seen>& seen() const { return seen_; }
  [[nodiscard]] const Sighting* sighting(Past past) const;
  /// What is shown is of another viewpoint or another model than now.
  [[nodiscard]] bool isOutdated() const;
  /// A look is under way; an outdated one that is not was stopped.
  [[nodiscard]] bool isLooking() const;
  [[nodiscard]] QString nameOf(std::size_t target) const;
  [[nodiscard]] static QString task() { return QStringLiteral("sight"); }

  /// A target that is marked, by its place in the surroundings.
  [[nodiscard]] std::optional<std::size_t> target() const { return target_; }
  void choose(std::optional<std::size_t> target);
  void flyTo(std::size_t target);

 Q_SIGNALS:
  void optionsChanged();
  void placingChanged();
  void seenChanged();
  /// A new look is under way, or none any more.
  void looking();
  void targetChanged();

 private:
  void follow();
  void forget();
  void look();
  void take(Seen seen);
  [[nodiscard]] bool isWanted() const;
  [[nodiscard]] PastModels models() const;

  Stage& stage_;
  Workspace& workspace_;
  bool placing_ = false;
  std::shared_ptr<const Seen> seen_;
  std::optional<std::size_t> target_;
  QTimer debounce_;
};

}  // namespace lodestone
