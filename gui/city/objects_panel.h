// The dock of all buildings: filter, sort, select.
#pragma once

#include <QWidget>

#include "gui/city/building_table.h"

class QAction;
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
  /// Offered by a right click on a row, which is selected then.
  void addTableAction(QAction* action);

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
