#include "gui/chain_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QStyledItemDelegate>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/icons.h"
#include "gui/parameter_panel.h"

namespace lodestone {
namespace {

enum Column { Name, Polygons, Share, Objects, Error, From, ColumnCount };

/// Draws the share of polygons as a bar behind its figure.
class ShareDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const double share = index.data(Qt::UserRole).toDouble();
    QRectF bar = QRectF(option.rect).adjusted(2, 3, -2, -3);
    bar.setWidth(bar.width() * share);
    QColor colour = accentColor();
    colour.setAlphaF(0.35F);
    painter->fillRect(bar, colour);
    QStyledItemDelegate::paint(painter, option, index);
  }
};

}  // namespace

ChainPanel::ChainPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      form_(new ParameterPanel(this)),
      table_(new QTableWidget(0, ColumnCount, this)),
      measure_(new QPushButton(icon(QStringLiteral("chain")), tr("Measure levels"), this)) {
  form_->addFields<ChainOptions>({"epsilon", "alpha"});
  form_->show(options_);
  table_->setObjectName(QStringLiteral("levelTable"));
  table_->setHorizontalHeaderLabels(
      {tr("Level"), tr("Polygons"), tr("Share"), tr("Objects"), tr("Error"), tr("From distance")});
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setShowGrid(false);
  table_->setTabKeyNavigation(false);
  table_->setItemDelegateForColumn(Share, new ShareDelegate(table_));
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 8);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->horizontalHeader()->setHighlightSections(false);
  for (int column = 0; column < ColumnCount; ++column)
    table_->setColumnWidth(column, fontMetrics().averageCharWidth() * (column == Name ? 24 : 17));
  auto* write = new QPushButton(icon(QStringLiteral("export")), tr("Export…"), this);

  auto* side = new QVBoxLayout;
  side->addWidget(form_);
  side->addStretch(1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(measure_);
  buttons->addWidget(write);
  side->addLayout(buttons);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 6, 6, 6);
  layout->setSpacing(12);
  layout->addLayout(side);
  layout->addWidget(table_, 1);

  connect(form_, &ParameterPanel::edited, this, [this] { options_ = form_->read(options_); });
  connect(measure_, &QPushButton::clicked, this, [this] {
    options_.epsilon = workspace_.state().cutOptions.epsilon;
    options_.alpha = workspace_.state().cutOptions.alpha;
    workspace_.makeChainPreview(options_);
  });
  connect(write, &QPushButton::clicked, this, &ChainPanel::exportRequested);
  connect(table_, &QTableWidget::cellClicked, this, &ChainPanel::showLevel);
  connect(table_, &QTableWidget::cellActivated, this, &ChainPanel::showLevel);
  connect(&workspace_, &Workspace::chainChanged, this, &ChainPanel::refresh);
  connect(&workspace_, &Workspace::stateChanged, this,
          [this] { measure_->setEnabled(workspace_.state().tree != nullptr); });
  measure_->setEnabled(false);
}

void ChainPanel::refresh() {
  table_->setRowCount(0);
  if (!workspace_.chain()) return;
  const QLocale locale;
  const auto& levels = workspace_.chain()->levels;
  table_->setRowCount(static_cast<int>(levels.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const LodLevel& level = levels[static_cast<std::size_t>(row)];
    const double share = levels.front().polygons == 0 ? 1
                                                      : static_cast<double>(level.polygons) /
                                                            static_cast<double>(levels.front().polygons);
    const QString texts[] = {QString::fromStdString(level.name),
                             locale.toString(static_cast<qulonglong>(level.polygons)),
                             locale.toString(100 * share, 'f', 1) + QStringLiteral(" %"),
                             locale.toString(static_cast<qulonglong>(level.objectCount)),
                             locale.toString(level.error, 'f', 2) + QStringLiteral(" m"),
                             locale.toString(level.switchDistance, 'f', 0) + QStringLiteral(" m")};
    for (int column = 0; column < ColumnCount; ++column) {
      auto* item = new QTableWidgetItem(texts[column]);
      if (column != Name) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      if (column == Share) item->setData(Qt::UserRole, std::min(share, 1.0));
      table_->setItem(row, column, item);
    }
  }
}

void ChainPanel::showLevel(int row) {
  const auto& levels = workspace_.chain()->levels;
  const LodLevel& level = levels[static_cast<std::size_t>(row)];
  double tolerance = 0;
  for (const auto& [name, value] : level.options) {
    if (name == "tolerance" && std::holds_alternative<double>(value)) tolerance = std::get<double>(value);
  }
  workspace_.setCutChoice(row == 0 ? CutChoice{CutMode::Original, 0}
                                   : CutChoice{CutMode::Tolerance, tolerance});
}

}  // namespace lodestone
