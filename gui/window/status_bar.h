// Where the cursor is, what is drawn and how fast, and what is being computed.
#pragma once

#include <QStatusBar>

#include "gui/workspace/workspace.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace lodestone {

class StatusBar : public QStatusBar {
  Q_OBJECT

 public:
  explicit StatusBar(Workspace& workspace, QWidget* parent = nullptr);

  void showPoint(double x, double y, double z);
  void showFrame(double ms);
  /// Whether the city is what is looked at: where the cursor is and what is drawn is told of it alone.
  void setCityShown(bool shown);
  [[nodiscard]] QToolButton& cancelButton() { return *cancel_; }

 private:
  void showPolygons();
  void setBusy(bool busy);

  Workspace& workspace_;
  QLabel* point_;
  QLabel* polygons_;
  QLabel* frame_;
  QLabel* task_;
  QProgressBar* progress_;
  QToolButton* cancel_;
};

}  // namespace lodestone
