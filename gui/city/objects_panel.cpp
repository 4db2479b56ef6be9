#include "gui/city/objects_panel.h"

#include <QHeaderView>
#include <QItemSelection>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QTableView>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/widgets/icons.h"
#include "gui/widgets/row_table.h"

namespace lodestone {
namespace {

constexpr std::size_t kMostSelectedRows = 5000;  // more are counted, not marked one by one
constexpr int kFilterDelayMs = 150;

/// Buildings below a node; the node itself if it is one. Stops at `limit`.
std::vector<NodeId> leavesBelow(const ClusterTree* tree, NodeId node, std::size_t limit) {
  std::vector<NodeId> leaves;
  std::vector<NodeId> stack{node};
  while (!stack.empty() && leaves.size() < limit) {
    const NodeId next = stack.back();
    stack.pop_back();
    if (!tree || tree->isLeaf(next)) {
      leaves.push_back(next);
    } else {
      stack.push_back(tree->nodes[next].b);
      stack.push_back(tree->nodes[next].a);
    }
  }
  return leaves;
}

}  // namespace

ObjectsPanel::ObjectsPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      model_(new BuildingTable(workspace, this)),
      view_(new QTableView(this)),
      filter_(new QLineEdit(this)),
      count_(new QLabel(this)) {
  filter_->setObjectName(QStringLiteral("objectFilter"));
  filter_->setPlaceholderText(tr("Filter by id or attribute"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  view_->setObjectName(QStringLiteral("objectTable"));
  view_->setModel(model_);
  makeSortedTable(*view_);
  const int digit = fontMetrics().averageCharWidth();
  const int widths[] = {16, 9, 8, 13, 12, 11, 11};  // the first four fill the dock as it opens
  for (int column = 0; column < BuildingTable::ColumnCount; ++column)
    view_->setColumnWidth(column, digit * widths[column]);
  count_->setForegroundRole(QPalette::PlaceholderText);

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 4);
  layout->addWidget(filter_);
  layout->addWidget(view_, 1);
  layout->addWidget(count_);

  auto* delay = new QTimer(this);
  delay->setSingleShot(true);
  delay->setInterval(kFilterDelayMs);
  connect(filter_, &QLineEdit::textChanged, delay, qOverload<>(&QTimer::start));
  connect(delay, &QTimer::timeout, this, [this] { model_->setFilter(filter_->text()); });
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    showCount();
    showSelection();
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ObjectsPanel::tellSelection);
  connect(view_, &QAbstractItemView::doubleClicked, this,
          [this](const QModelIndex& index) { workspace_.flyTo(model_->buildingAt(index.row())); });
  connect(&workspace_, &Workspace::selectionChanged, this, &ObjectsPanel::showSelection);
  showCount();
}

void ObjectsPanel::addTableAction(QAction* action) {
  view_->setContextMenuPolicy(Qt::ActionsContextMenu);
  view_->addAction(action);
}

void ObjectsPanel::showCount() {
  const std::size_t all = workspace_.state().city ? workspace_.state().city->buildings.size() : 0;
  const auto shown = static_cast<std::size_t>(model_->rowCount());
  if (shown != all) {
    count_->setText(tr("%L1 of %L2 buildings").arg(shown).arg(all));
  } else {
    count_->setText(all == 1 ? tr("1 building") : tr("%L1 buildings").arg(all));
  }
}

void ObjectsPanel::showSelection() {
  if (syncing_) return;
  syncing_ = true;
  QItemSelection rows;
  QModelIndex first;
  for (const NodeId node : workspace_.selection()) {
    for (const NodeId building : leavesBelow(workspace_.state().tree.get(), node, kMostSelectedRows)) {
      const int row = model_->rowOf(building);
      if (row < 0) continue;
      const QModelIndex at = model_->index(row, 0);
      rows.select(at, model_->index(row, BuildingTable::ColumnCount - 1));
      if (!first.isValid()) first = at;
    }
  }
  view_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (first.isValid()) {
    view_->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    view_->scrollTo(first, QAbstractItemView::PositionAtCenter);
  }
  syncing_ = false;
}

void ObjectsPanel::tellSelection() {
  if (syncing_) return;
  syncing_ = true;
  std::vector<NodeId> nodes;
  for (const QModelIndex& index : view_->selectionModel()->selectedRows())
    nodes.push_back(model_->buildingAt(index.row()));
  std::sort(nodes.begin(), nodes.end());
  workspace_.select(std::move(nodes));
  syncing_ = false;
}

}  // namespace lodestone
