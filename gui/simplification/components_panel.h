// The components of the building on the stage: a table with a filter, and isolation of what is selected.
#pragma once

#include <QWidget>

#include "gui/simplification/component_table.h"

class QLabel;
class QLineEdit;
class QTableView;
class QToolButton;

namespace lodestone {

class ComponentsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ComponentsPanel(Stage& stage, QWidget* parent = nullptr);

  [[nodiscard]] ComponentTable& model() { return *model_; }
  [[nodiscard]] QToolButton& isolateButton() { return *isolate_; }

 Q_SIGNALS:
  /// What is selected is drawn alone, or again with everything else.
  void isolateToggled(bool isolate);

 private:
  void showSelection();
  void tellSelection();
  void showCount();
  void fitColumns();

  Stage& stage_;
  ComponentTable* model_;
  QLineEdit* filter_;
  QTableView* view_;
  QLabel* count_;
  QToolButton* isolate_;
  bool syncing_ = false;
};

}  // namespace lodestone
