// The Perception dock in the real window, for tests.
#pragma once

#include <QAction>
#include <QTableWidget>

#include "algorithms/perception/viewpoints.h"
#include "gui/perception/classes_panel.h"
#include "gui/perception/perceiving.h"
#include "gui/perception/perception_panel.h"
#include "gui/widgets/colours.h"
#include "tests/gui/stage_support.h"

namespace lodestone {

/// Looks at the pavilion with pictures that take no time.
class PerceptionFixture : public StageFixture {
 protected:
  [[nodiscard]] Perceiving& perceiving() { return stageWindow().perceiving(); }
  [[nodiscard]] PerceptionPanel& panel() { return stageWindow().perception(); }
  [[nodiscard]] QAction& action() { return *window_->findChild<QAction*>(QStringLiteral("showPerception")); }
  void closeWindow() {
    window_.reset();
    QApplication::setPalette(paletteOf(Appearance::Light));
  }

  void setSmall() {
    PerceiveOptions options;
    options.views = 8;
    options.size = 96;
    perceiving().setOptions(options, QStringLiteral("test"));
  }

  void showDock() {
    openPavilion();
    setSmall();
    action().trigger();
    QVERIFY(panel().isVisible());
    settle();
  }

  void settle() {
    QTRY_VERIFY_WITH_TIMEOUT(!perceiving().isOutdated() && !window_->workspace().tasks().busy(), kLong);
  }

  /// What the algorithms by themselves say.
  [[nodiscard]] Perception reference() {
    const ComponentMesh& mesh = *stage().staged()->mesh;
    const ModelRenderer renderer(mesh, readModelLook(*stage().staged()->city, mesh));
    const PerceiveOptions& options = perceiving().options();
    return perceive(renderer, viewpointsAround(bounds(mesh), options), options, {}, {},
                    closerViewpoints(bounds(mesh), options));
  }

  /// Of the table of stages.
  [[nodiscard]] QString cell(int row, int column) {
    return panel().classes().stages().item(row, column)->text();
  }
};

}  // namespace lodestone
