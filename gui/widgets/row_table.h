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

/// The same for many things with names, of which several can be chosen, in the order of any column: as the
/// model has them until somebody clicks a header. \pre the table has its model.
inline void makeSortedTable(QTableView& table) {
  makeRowTable(table);
  table.setSelectionMode(QAbstractItemView::ExtendedSelection);
  table.setSortingEnabled(true);
  table.sortByColumn(-1, Qt::AscendingOrder);
  table.setWordWrap(false);
  table.setTextElideMode(Qt::ElideMiddle);  // names of things that belong together begin alike
  table.horizontalHeader()->setHighlightSections(false);
}

}  // namespace lodestone
