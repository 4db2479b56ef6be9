// What is shown: the city, its lines, and what the method adds, each with an eye.
#pragma once

#include <QWidget>
#include <map>

#include "gui/view3d/city_scene.h"
#include "gui/workspace.h"

class QComboBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace lodestone {

class LayersPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayersPanel(Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] bool isShown(Overlay overlay) const;
  void setShown(Overlay overlay, bool shown);
  /// Lines that are switched on.
  [[nodiscard]] std::vector<LineLayer> shownLines() const;

 Q_SIGNALS:
  void overlayChanged(lodestone::Overlay overlay, bool shown);
  void cityShown(bool shown);
  void linesChanged();
  void coloursChanged(lodestone::SceneColours colours);

 private:
  void rebuildCity();
  void rebuildLines();
  QTreeWidgetItem* addGroup(const QString& title, const QString& iconName);
  void addOverlay(QTreeWidgetItem* group, Overlay overlay, const QString& title, const QString& iconName,
                  bool on, const QString& help);
  QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const QString& title, const QString& iconName, bool on);
  void itemChanged(QTreeWidgetItem* item);

  Workspace& workspace_;
  QTreeWidget* tree_;
  QComboBox* colours_;
  QTreeWidgetItem* city_;
  QTreeWidgetItem* lines_;
  std::map<Overlay, QTreeWidgetItem*> overlays_;
};

}  // namespace lodestone
