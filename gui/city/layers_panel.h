// What is shown: the city, what surrounds it, its lines, and what the method adds, each with an eye; the
// layers of them with colour and opacity.
#pragma once

#include <QJsonObject>
#include <QWidget>
#include <array>
#include <map>
#include <optional>

#include "gui/view3d/city_scene.h"
#include "gui/workspace/workspace.h"

class QComboBox;
class QTreeWidget;
class QTreeWidgetItem;

namespace lodestone {

class LayerStyleRow;

class LayersPanel : public QWidget {
  Q_OBJECT

 public:
  explicit LayersPanel(Workspace& workspace, QWidget* parent = nullptr);

  [[nodiscard]] const LayerStyle& style(SceneLayer layer) const {
    return styles_[static_cast<std::size_t>(layer)];
  }
  [[nodiscard]] bool isShown(Overlay overlay) const;
  void setShown(Overlay overlay, bool shown);
  /// Styles, eyes and colours, as a project keeps them (ProjectState::looks).
  [[nodiscard]] QJsonObject view() const;
  /// Shows them, without a step for undo; what `view` does not say is as at first.
  void setView(const QJsonObject& view);
  /// Lines that are switched on.
  [[nodiscard]] std::vector<LineLayer> shownLines() const;

 Q_SIGNALS:
  void overlayChanged(lodestone::Overlay overlay, bool shown);
  void layerStyled(lodestone::SceneLayer layer, const lodestone::LayerStyle& style);
  void linesChanged();
  void coloursChanged(lodestone::SceneColours colours);

 private:
  void rebuildCity();
  void rebuildSurroundings();
  /// The layer of a row or of the row it stands under; nothing for what is no layer.
  [[nodiscard]] std::optional<SceneLayer> layerOf(const QTreeWidgetItem* item) const;
  void currentChanged();
  void layerEdited(SceneLayer layer);
  void rebuildLines();
  [[nodiscard]] QTreeWidgetItem* rowOf(SceneLayer layer) const;
  void setStyle(SceneLayer layer, const LayerStyle& style);
  QTreeWidgetItem* addGroup(const QString& title, const QString& iconName);
  void addOverlay(QTreeWidgetItem* group, Overlay overlay, const QString& title, const QString& iconName,
                  bool on, const QString& help);
  QTreeWidgetItem* addRow(QTreeWidgetItem* parent, const QString& title, const QString& iconName, bool on);
  void itemChanged(QTreeWidgetItem* item);
  void styleEdited(const LayerStyle& style);
  /// A person changed how something looks.
  void keep(const QString& what, const QString& mergeKey = {});
  void showLooks();

  Workspace& workspace_;
  QTreeWidget* tree_;
  QComboBox* colours_;
  QTreeWidgetItem* city_;
  QTreeWidgetItem* surroundings_;
  QTreeWidgetItem* lines_;
  std::array<LayerStyle, kSceneLayerCount> styles_;
  LayerStyleRow* styleRow_;
  std::map<Overlay, QTreeWidgetItem*> overlays_;
  bool keeping_ = true;  // false while what is kept is shown
};

}  // namespace lodestone
