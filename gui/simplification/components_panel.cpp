#include "gui/simplification/components_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>

#include "gui/widgets/icons.h"

namespace lodestone {

ComponentsPanel::ComponentsPanel(Stage& stage, QWidget* parent)
    : QWidget(parent),
      stage_(stage),
      model_(new ComponentTable(stage, this)),
      filter_(new QLineEdit(this)),
      view_(new QTableView(this)),
      count_(new QLabel(this)),
      isolate_(new QToolButton(this)) {
  filter_->setObjectName(QStringLiteral("componentFilter"));
  filter_->setPlaceholderText(tr("Filter by number or source"));
  filter_->setClearButtonEnabled(true);
  filter_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  isolate_->setObjectName(QStringLiteral("isolate"));
  isolate_->setText(tr("Isolate"));
  isolate_->setIcon(icon(QStringLiteral("isolate")));
  isolate_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  isolate_->setCheckable(true);
  isolate_->setToolTip(tr("Draw the selected components alone; the others stay as lines"));
  view_->setObjectName(QStringLiteral("componentTable"));
  view_->setModel(model_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setSortingEnabled(true);
  view_->sortByColumn(-1, Qt::AscendingOrder);
  view_->setAlternatingRowColors(true);
  view_->setShowGrid(false);
  view_->setWordWrap(false);
  view_->setTabKeyNavigation(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  view_->horizontalHeader()->setHighlightSections(false);
  const int digit = fontMetrics().averageCharWidth();
  const int widths[] = {9, 13, 10, 10, 7, 10};
  for (int column = 0; column < ComponentTable::ColumnCount; ++column)
    view_->setColumnWidth(column, digit * widths[column]);
  count_->setForegroundRole(QPalette::PlaceholderText);

  auto* top = new QHBoxLayout;
  top->addWidget(filter_, 1);
  top->addWidget(isolate_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 4);
  layout->addLayout(top);
  layout->addWidget(view_, 1);
  layout->addWidget(count_);

  connect(filter_, &QLineEdit::textChanged, model_, &ComponentTable::setFilter);
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    showCount();
    showSelection();
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &ComponentsPanel::tellSelection);
  connect(view_, &QAbstractItemView::activated, this,
          [this](const QModelIndex& index) { stage_.flyToComponent(model_->componentAt(index.row())); });
  connect(isolate_, &QToolButton::toggled, this, &ComponentsPanel::isolateToggled);
  connect(&stage_, &Stage::selectionChanged, this, &ComponentsPanel::showSelection);
  connect(&stage_, &Stage::opened, this, [this] { isolate_->setChecked(false); });
  showCount();
}

void ComponentsPanel::showCount() {
  const std::size_t all = stage_.isOpen() ? stage_.staged()->mesh->components.size() : 0;
  const auto shown = static_cast<std::size_t>(model_->rowCount());
  const std::size_t contacts = stage_.isOpen() ? stage_.staged()->classes->contacts.size() : 0;
  count_->setText(shown == all ? tr("%L1 components, %L2 contacts").arg(all).arg(contacts)
                               : tr("%L1 of %L2 components").arg(shown).arg(all));
}

void ComponentsPanel::showSelection() {
  if (syncing_) return;
  syncing_ = true;
  QItemSelection rows;
  QModelIndex first;
  for (const std::uint32_t component : stage_.selection()) {
    const int row = model_->rowOf(component);
    if (row < 0) continue;
    rows.select(model_->index(row, 0), model_->index(row, ComponentTable::ColumnCount - 1));
    if (!first.isValid()) first = model_->index(row, 0);
  }
  view_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (first.isValid()) {
    view_->selectionModel()->setCurrentIndex(first, QItemSelectionModel::NoUpdate);
    view_->scrollTo(first);
  }
  syncing_ = false;
}

void ComponentsPanel::tellSelection() {
  if (syncing_) return;
  syncing_ = true;
  std::vector<std::uint32_t> components;
  for (const QModelIndex& index : view_->selectionModel()->selectedRows())
    components.push_back(model_->componentAt(index.row()));
  stage_.select(std::move(components));
  syncing_ = false;
}

}  // namespace lodestone
