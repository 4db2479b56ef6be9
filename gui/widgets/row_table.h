// Tables whose rows are things to choose one of, not cells to write into.
#pragma once

#include <QHeaderView>
#include <QTableView>

namespace lodestone {

/// Low rows without a grid, one of which can be chosen; Tab leaves the table.
inline void makeRowTable(QTableView& table) {
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setShowGrid(false);
  table.setAlternatingRowColors(true);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 5);
}

}  // namespace lodestone
