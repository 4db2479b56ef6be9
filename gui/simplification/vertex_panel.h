// Why the picked vertex is what it is, and what it costs to move it.
#pragma once

#include <QWidget>

#include "algorithms/simplification/vertex_account.h"
#include "gui/simplification/stage.h"

class QLabel;
class QTreeWidget;
class QTreeWidgetItem;

namespace lodestone {

class VertexPanel : public QWidget {
  Q_OBJECT

 public:
  explicit VertexPanel(Stage& stage, QWidget* parent = nullptr);

 private:
  void refresh();
  void showMeetings(const VertexAccount& account);
  void showPlanes(const VertexAccount& account);
  void showMoves(const VertexAccount& account);
  QTreeWidgetItem* group(const QString& title);
  static void add(QTreeWidgetItem* group, const QStringList& texts, const QString& help = {});
  [[nodiscard]] QString nameOf(std::uint32_t component) const;

  Stage& stage_;
  QLabel* title_;
  QLabel* why_;
  QTreeWidget* tree_;
  SimplifyOptions priced_;  ///< the costs that are shown are by these
};

}  // namespace lodestone
