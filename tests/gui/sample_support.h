// A window with the sample town, for tests of the main job.
#pragma once

#include "tests/gui/workbench_support.h"

namespace lodestone {

/// A window to open the sample in.
class WorkbenchFixture : public QObject {
 protected:
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  void openSample() {
    workspace().openSample();
    QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  }
  template <class Widget>
  Widget* find(const char* name) {
    return window_->findChild<Widget*>(QString::fromLatin1(name));
  }

  std::unique_ptr<MainWindow> window_;
};

}  // namespace lodestone
