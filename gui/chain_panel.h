// The levels of the LOD chain: what each costs and where it takes over; click one to see it.
#pragma once

#include <QWidget>

#include "gui/workspace.h"

class QPushButton;
class QTableWidget;

namespace lodestone {

class ParameterPanel;

class ChainPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ChainPanel(Workspace& workspace, QWidget* parent = nullptr);
  [[nodiscard]] const ChainOptions& options() const { return options_; }

 Q_SIGNALS:
  void exportRequested();

 private:
  void refresh();
  void showLevel(int row);

  Workspace& workspace_;
  ChainOptions options_;
  ParameterPanel* form_;
  QTableWidget* table_;
  QPushButton* measure_;
};

}  // namespace lodestone
