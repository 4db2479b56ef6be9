// What is known about the selected building or cluster.
#pragma once

#include <QWidget>

#include "gui/workspace/workspace.h"

class QLabel;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace lodestone {

class SelectionPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SelectionPanel(Workspace& workspace, QWidget* parent = nullptr);

 private:
  void refresh();
  void showBuilding(NodeId node);
  void showCluster(NodeId node);
  QTreeWidgetItem* group(const QString& title);
  static void add(QTreeWidgetItem* group, const QString& name, const QString& value);
  static void addFaces(QTreeWidgetItem* group, const FaceCount& faces);
  void selectParent();

  Workspace& workspace_;
  QLabel* title_;
  QToolButton* parent_;
  QToolButton* fly_;
  QTreeWidget* tree_;
};

}  // namespace lodestone
