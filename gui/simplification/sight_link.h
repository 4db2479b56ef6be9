// Draws the visibility analysis on the stage, and lets its viewpoint be placed and dragged there.
#pragma once

#include <QObject>
#include <optional>

#include "gui/simplification/sight.h"
#include "gui/simplification/stage_view.h"
#include "gui/view3d/sight_fan.h"

namespace lodestone {

class SightLink : public QObject, public StageTool {
  Q_OBJECT

 public:
  SightLink(Sight& sight, StageView& view, QObject* parent = nullptr);
  ~SightLink() override;

  /// The viewpoint becomes what the view's camera sees.
  void standAtCamera();
  /// The view's camera goes to the viewpoint.
  void lookFromViewpoint();

  bool click(const QPointF& at) override;
  bool grab(const QPointF& at) override;
  void pull(const QPointF& at) override;
  void release() override;
  bool cancel() override;

 private:
  /// A viewpoint on what stands or lies under the pixel, looking to the stage.
  bool place(const QPointF& at);
  [[nodiscard]] std::optional<SightHandle> handleAt(const QPointF& at) const;
  void showSight();
  void showTargets();
  void set(const SightOptions& options, const QString& what);

  Sight& sight_;
  StageView& view_;
  std::optional<SightHandle> grabbed_;
  std::size_t pane_ = 0;  ///< in which it was grabbed
  int gesture_ = 0;       ///< counts clicks and drags: each is one step of undo
};

}  // namespace lodestone
