#include "gui/messages_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <iterator>

#include "gui/icons.h"

namespace lodestone {

void MessageTable::append(const Diagnostics& diagnostics) {
  Diagnostics fresh;
  std::copy_if(diagnostics.begin(), diagnostics.end(), std::back_inserter(fresh), [&](const Diagnostic& d) {
    return d.severity != Severity::Info || told_.insert(format(d)).second;
  });
  if (fresh.empty()) return;
  const int first = rowCount();
  beginInsertRows({}, first, first + static_cast<int>(fresh.size()) - 1);
  diagnostics_.insert(diagnostics_.end(), fresh.begin(), fresh.end());
  endInsertRows();
}

void MessageTable::clear() {
  beginResetModel();
  diagnostics_.clear();
  told_.clear();
  endResetModel();
}

int MessageTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(diagnostics_.size());
}
int MessageTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QVariant MessageTable::data(const QModelIndex& index, int role) const {
  const Diagnostic& d = diagnostics_[static_cast<std::size_t>(index.row())];
  if (role == Qt::DecorationRole && index.column() == SeverityColumn)
    return icon(QString::fromLatin1(toString(d.severity)));
  if (role == Qt::ToolTipRole) return QString::fromStdString(format(d));
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case SeverityColumn:
      return QString::fromLatin1(toString(d.severity));
    case CodeColumn:
      return static_cast<int>(d.code);
    case ObjectColumn:
      return QString::fromStdString(d.object);
    case TextColumn:
      return QString::fromStdString(d.place.empty() ? d.text : d.text + " (" + d.place + ")");
    default:
      return QString::fromUtf8(info(d.code).advice.data(),
                               static_cast<qsizetype>(info(d.code).advice.size()));
  }
}

QVariant MessageTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const char* const titles[] = {QT_TR_NOOP("Severity"), QT_TR_NOOP("Code"), QT_TR_NOOP("Object"),
                                       QT_TR_NOOP("What"), QT_TR_NOOP("What to do")};
  return tr(titles[section]);
}

MessagesPanel::MessagesPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), model_(new MessageTable(this)), view_(new QTableView(this)) {
  view_->setObjectName(QStringLiteral("messageTable"));
  view_->setModel(model_);
  view_->setSelectionBehavior(QAbstractItemView::SelectRows);
  view_->setShowGrid(false);
  view_->setAlternatingRowColors(true);
  view_->setTabKeyNavigation(false);
  view_->verticalHeader()->hide();
  view_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 6);
  view_->horizontalHeader()->setHighlightSections(false);
  view_->horizontalHeader()->setStretchLastSection(true);
  const int digit = fontMetrics().averageCharWidth();
  const int widths[] = {14, 8, 22, 70, 50};
  for (int column = 0; column < MessageTable::ColumnCount; ++column)
    view_->setColumnWidth(column, digit * widths[column]);

  auto* clear = new QToolButton(this);
  clear->setText(tr("Clear"));
  clear->setAutoRaise(true);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(view_, 1);
  layout->addWidget(clear, 0, Qt::AlignTop);

  connect(clear, &QToolButton::clicked, model_, &MessageTable::clear);
  connect(view_, &QAbstractItemView::activated, this, [this](const QModelIndex& index) {
    const NodeId node = workspace_.buildingOf(model_->all()[static_cast<std::size_t>(index.row())].object);
    if (node == kNoNode) return;
    workspace_.select({node});
    workspace_.flyTo(node);
  });
  const auto tell = [this](const Diagnostics& diagnostics) {
    model_->append(diagnostics);
    view_->scrollToBottom();
    if (hasErrors(diagnostics)) Q_EMIT errorAdded();
  };
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.city != after.city) model_->startAnew();
          });
  connect(&workspace_, &Workspace::diagnosed, this, tell);
  connect(&workspace_, &Workspace::importRejected, this, tell);
}

}  // namespace lodestone
