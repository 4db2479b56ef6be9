// The Perception dock: viewpoints, the pictures of one, how they are judged, and how a level looks beside the
// original.
#pragma once

#include <QWidget>

#include "gui/perception/comparing.h"
#include "gui/perception/shown_pictures.h"

class QLabel;
class QPushButton;
class QSplitter;
class QTabWidget;
class QToolButton;

namespace lodestone {

class ClassesPanel;
class ComparisonPanel;
class ParameterPanel;
class PictureGrid;
class SensitivityPlot;
class ViewpointStrip;

class PerceptionPanel : public QWidget {
  Q_OBJECT

 public:
  PerceptionPanel(Perceiving& perceiving, Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] ViewpointStrip& strip() { return *strip_; }
  [[nodiscard]] PictureGrid& pictures() { return *grid_; }
  [[nodiscard]] Comparing& comparing() { return *comparing_; }
  [[nodiscard]] ComparisonPanel& comparison() { return *comparison_; }
  [[nodiscard]] ClassesPanel& classes() { return *classes_; }
  [[nodiscard]] ParameterPanel& fields() { return *fields_; }
  [[nodiscard]] SensitivityPlot& sensitivity() { return *sensitivity_; }
  [[nodiscard]] QPushButton& lookButton() { return *look_; }
  [[nodiscard]] QToolButton& addButton() { return *add_; }
  [[nodiscard]] QTabWidget& views() { return *views_; }
  [[nodiscard]] QTabWidget& sides() { return *sides_; }
  [[nodiscard]] QString state() const;

 Q_SIGNALS:
  /// What the view's camera sees is to be one more viewpoint.
  void addCameraRequested();
  /// The view's camera is to go to a viewpoint.
  void lookFromRequested(const lodestone::Camera& camera);
  /// The dock came into sight or went out of it.
  void shownChanged();

 protected:
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  QWidget* makeBar();
  QWidget* makeDisplay();
  QToolButton* addTool(const QString& name, const QString& text, const QString& iconName,
                       const QString& help);
  void showViewpoints();
  void showPictures();
  void showOptions();
  void showState();
  [[nodiscard]] QString stateText() const;

  Perceiving& perceiving_;
  ShownPictures* shown_;
  Comparing* comparing_;
  ViewpointStrip* strip_;
  QPushButton* look_;
  QToolButton* add_ = nullptr;
  QToolButton* remove_ = nullptr;
  QLabel* state_;
  PictureGrid* grid_;
  ComparisonPanel* comparison_;
  ClassesPanel* classes_;
  ParameterPanel* fields_;
  SensitivityPlot* sensitivity_;
  QTabWidget* views_;
  QTabWidget* sides_;
};

}  // namespace lodestone
