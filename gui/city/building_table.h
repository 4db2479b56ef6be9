// The buildings of the city as a table: sorted and filtered here, since a proxy over 370,000 rows is too
// slow.
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <unordered_map>
#include <vector>

#include "gui/workspace/workspace.h"

namespace lodestone {

class BuildingTable : public QAbstractTableModel {
  Q_OBJECT

 public:
  enum Column { Id, Height, Area, Polygons, Lods, Cluster, Problems, ColumnCount };

  explicit BuildingTable(Workspace& workspace, QObject* parent = nullptr);

  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
  void sort(int column, Qt::SortOrder order) override;

  /// Shows the buildings whose id or attributes contain the text, in any case; all when it is empty.
  void setFilter(const QString& text);
  [[nodiscard]] NodeId buildingAt(int row) const { return rows_[static_cast<std::size_t>(row)]; }
  /// Row of a building, or −1 where the filter hides it.
  [[nodiscard]] int rowOf(NodeId building) const;
  /// Drawn cluster that a building is part of at present; kNoNode when it is drawn itself or culled.
  [[nodiscard]] NodeId clusterOf(NodeId building) const;

 private:
  void cityChanged();
  void cutChanged();
  void addProblems(const Diagnostics& diagnostics);
  void rebuild();
  void sortRows();
  [[nodiscard]] int problemsOf(NodeId building) const;
  [[nodiscard]] double key(NodeId building) const;
  [[nodiscard]] bool matches(NodeId building) const;
  [[nodiscard]] QVariant text(NodeId building, int column) const;

  Workspace& workspace_;
  std::vector<double> areas_;
  std::vector<std::uint64_t> polygons_;
  std::vector<NodeId> rows_;
  std::vector<std::int32_t> rowOf_;
  std::vector<std::uint8_t> drawnCluster_;  ///< by node
  /// Messages by object id, of each city that is still held anywhere: undo brings cities back.
  struct CityProblems {
    std::weak_ptr<const CityModel> city;
    std::unordered_map<std::string, int> counts;
  };
  std::vector<CityProblems> problems_;
  std::string filter_;
  int sortColumn_ = -1;
  Qt::SortOrder sortOrder_ = Qt::AscendingOrder;
};

}  // namespace lodestone
