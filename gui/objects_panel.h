// The dock of all buildings: filter, sort, select.
#pragma once

#include <QWidget>

#include "gui/building_table.h"

class QLabel;
class QLineEdit;
class QTableView;

namespace lodestone {

class ObjectsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ObjectsPanel(Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] QTableView& table() { return *view_; }
  [[nodiscard]] BuildingTable& model() { return *model_; }

 private:
  void showSelection();
  void tellSelection();
  void showCount();

  Workspace& workspace_;
  BuildingTable* model_;
  QTableView* view_;
  QLineEdit* filter_;
  QLabel* count_;
  bool syncing_ = false;
};

}  // namespace lodestone
