// Diagnostics as a table; a double-click flies to the object.
#pragma once

#include <QAbstractTableModel>
#include <QWidget>
#include <set>
#include <string>

#include "gui/workspace.h"

class QTableView;

namespace lodestone {

class MessageTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { SeverityColumn, CodeColumn, ObjectColumn, TextColumn, AdviceColumn, ColumnCount };

  using QAbstractTableModel::QAbstractTableModel;
  /// What is for information is told once: clustering again says the same of barriers again.
  void append(const Diagnostics& diagnostics);
  void clear();
  /// Another model: what was told of the one before is told again.
  void startAnew() { told_.clear(); }
  [[nodiscard]] const Diagnostics& all() const { return diagnostics_; }

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  Diagnostics diagnostics_;
  std::set<std::string> told_;
};

class MessagesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MessagesPanel(Workspace& workspace, QWidget* parent = nullptr);
  [[nodiscard]] const Diagnostics& messages() const { return model_->all(); }

 Q_SIGNALS:
  /// Something that a person should not miss was added.
  void errorAdded();

 private:
  Workspace& workspace_;
  MessageTable* model_;
  QTableView* view_;
};

}  // namespace lodestone
