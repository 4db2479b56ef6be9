// The real window with a project in it.
#pragma once

#include <memory>

#include "algorithms/synthesis/synthesis.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {

inline std::shared_ptr<const CityModel> smallCity(int buildings) {
  SynthOptions options;
  options.preset = CityPreset::Charlotte;
  options.buildings = buildings;
  return std::make_shared<const CityModel>(synthesiseCity(options));
}

/// What tests of projects have in common: a fresh window each. Moc wants their slots in the classes
/// themselves.
class ProjectWindow : public QObject {
 protected:
  void open() { window_ = makeWindow(); }
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  void waitForTasks() { QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong); }
  void openSample() {
    workspace().openSample();
    QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
    waitForTasks();
  }
  void cluster(double factor) {
    ClusterOptions options = workspace().state().clusterOptions;
    options.barrierFactor = factor;
    workspace().setClusterOptions(options, QString::number(factor));
    workspace().cluster();
    waitForTasks();
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace lodestone
