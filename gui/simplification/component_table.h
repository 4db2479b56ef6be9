// The components of the building on the stage as a table.
#pragma once

#include <QAbstractTableModel>
#include <vector>

#include "gui/simplification/stage.h"

namespace lodestone {

class ComponentTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Number, Source, Triangles, Boundary, Hole, Ordinary, ColumnCount };

  explicit ComponentTable(Stage& stage, QObject* parent = nullptr);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  void sort(int column, Qt::SortOrder order) override;

  /// Shows the components whose number or source contains the text, in any case; all when it is empty.
  void setFilter(const QString& text);
  [[nodiscard]] std::uint32_t componentAt(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  /// Row of a component, or −1 where the filter hides it.
  [[nodiscard]] int rowOf(std::uint32_t component) const;

  /// A row with the greatest number in a column of numbers, or −1.
  [[nodiscard]] int widestRow(int column) const;

 private:
  void rebuild();
  void sortRows();
  [[nodiscard]] QString source(std::uint32_t component) const;
  [[nodiscard]] std::uint32_t figure(std::uint32_t component, int column) const;

  Stage& stage_;
  std::vector<Rgb> colours_;
  std::vector<std::uint32_t> rows_;
  QString filter_;
  int sortColumn_ = -1;
  Qt::SortOrder sortOrder_ = Qt::AscendingOrder;
};

}  // namespace lodestone
