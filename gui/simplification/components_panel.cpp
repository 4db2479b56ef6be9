#include "gui/simplification/components_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QToolButton>
#include <algorithm>

#include "gui/widgets/counted.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/row_table.h"

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
  makeSortedTable(*view_);
  view_->horizontalHeader()->setMinimumSectionSize(fontMetrics().averageCharWidth() * 4);
  view_->horizontalHeader()->setSectionResizeMode(ComponentTable::Source, QHeaderView::Stretch);
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
    fitColumns();
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
  fitColumns();
  showCount();
}

/// Numbers have the room that they need, what a component comes from has the rest: all is seen without
/// scrolling.
void ComponentsPanel::fitColumns() {
  const QHeaderView& header = *view_->horizontalHeader();
  const int sign = style()->pixelMetric(QStyle::PM_SmallIconSize, nullptr, view_);
  const int margin = style()->pixelMetric(QStyle::PM_HeaderMargin, nullptr, &header);
  const int arrow = style()->pixelMetric(QStyle::PM_HeaderMarkSize, nullptr, &header) + margin;
  for (int column = 0; column < ComponentTable::ColumnCount; ++column) {
    if (column == ComponentTable::Source) continue;
    const QString title = model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    int width = (title.isEmpty() ? sign : fontMetrics().horizontalAdvance(title)) + 2 * margin;
    if (header.sortIndicatorSection() == column) width += arrow;
    if (const int row = model_->widestRow(column); row >= 0)
      width = std::max(width, view_->sizeHintForIndex(model_->index(row, column)).width());
    view_->setColumnWidth(column, width);
  }
}

void ComponentsPanel::showCount() {
  const std::size_t all = stage_.isOpen() ? stage_.staged()->mesh->components.size() : 0;
  const auto shown = static_cast<std::size_t>(model_->rowCount());
  const std::size_t contacts = stage_.isOpen() ? stage_.staged()->classes->contacts.size() : 0;
  count_->setText(shown == all
                      ? tr("%1, %2").arg(counted(all, tr("component"), tr("components")),
                                         counted(contacts, tr("contact"), tr("contacts")))
                      : tr("%L1 of %2").arg(shown).arg(counted(all, tr("component"), tr("components"))));
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
