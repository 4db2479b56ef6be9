// The levels of the LOD chain: what each looks like and costs, and where it takes over; click one to see it.
#pragma once

#include <QWidget>

#include "gui/workspace/workspace.h"

class QLabel;
class QPushButton;
class QStackedWidget;

namespace lodestone {

class LevelStrip;
class ParameterPanel;

class ChainPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ChainPanel(Workspace& workspace, QWidget* parent = nullptr);
  [[nodiscard]] LevelStrip& strip() { return *strip_; }

 Q_SIGNALS:
  void exportRequested();

 private:
  /// One more level, twice as coarse as the last.
  void addLevel();
  /// What has to be done before levels can be measured; empty: nothing.
  [[nodiscard]] QString missing() const;
  void showReady();
  void refresh();
  void drawPictures();
  void showLevel(int level);
  /// What the cut has to be for a level to be drawn.
  [[nodiscard]] CutChoice choiceOf(int level) const;
  void markShown();

  Workspace& workspace_;
  ParameterPanel* form_;
  LevelStrip* strip_;
  QLabel* empty_;
  QStackedWidget* stack_;
  QPushButton* measure_;
  QPushButton* add_;
};

}  // namespace lodestone
