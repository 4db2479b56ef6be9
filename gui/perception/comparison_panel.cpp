#include "gui/perception/comparison_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QSignalBlocker>
#include <QTableWidget>
#include <QVBoxLayout>

#include "gui/perception/picture_grid.h"
#include "gui/perception/viewpoint_strip.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/row_table.h"

namespace lodestone {
namespace {

constexpr int kChosenRow = 0;  // the chosen viewpoint; measured ones follow

QString flipText(double flip) {
  return QLocale().toString(flip, 'f', 4);
}

QString percent(double share) {
  return QLocale().toString(share * 100, 'f', share < 0.0995 ? 2 : 1) + QStringLiteral(" %");
}

QString nameOf(Stage::Method method) {
  return method == Stage::A ? ComparisonPanel::tr("A") : ComparisonPanel::tr("B");
}

}  // namespace

ComparisonPanel::ComparisonPanel(Comparing& comparing, QWidget* parent)
    : QWidget(parent),
      comparing_(comparing),
      grid_(new PictureGrid(this)),
      table_(new QTableWidget(0, 5, this)),
      pooled_(new QLabel(this)),
      stop_(new QPushButton(this)) {
  grid_->setObjectName(QStringLiteral("comparedPictures"));
  grid_->setAccessibleName(tr("Original, levels and ꟻLIP maps"));
  grid_->setReadout([this](const QPoint& pixel) { return readout(pixel); });
  pooled_->setObjectName(QStringLiteral("pooledFlip"));
  pooled_->setWordWrap(true);
  makeTable();
  auto* side = new QVBoxLayout;
  side->setSpacing(4);
  auto* head = new QHBoxLayout;
  head->addWidget(pooled_, 1);
  head->addWidget(stop_, 0, Qt::AlignTop);
  side->addLayout(head);
  side->addWidget(table_, 1);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 4, 0, 0);
  row->addWidget(grid_, 3);
  row->addLayout(side, 1);
  connect(table_, &QTableWidget::currentCellChanged, this, [this](int chosen) {
    if (chosen >= 0)
      comparing_.choose(chosen == kChosenRow ? std::nullopt
                                             : std::optional(static_cast<std::size_t>(chosen - 1)));
  });
  connect(stop_, &QPushButton::clicked, this,
          [this] { comparing_.isBusy() ? comparing_.cancel() : comparing_.resume(); });
  connect(&comparing_, &Comparing::picturesChanged, this, &ComparisonPanel::showPictures);
  for (const auto change :
       {&Comparing::measuredChanged, &Comparing::viewChanged, &Comparing::picturesChanged})
    connect(&comparing_, change, this, &ComparisonPanel::showMeasures);
  showPictures();
  showMeasures();
}

void ComparisonPanel::makeTable() {
  table_->setObjectName(QStringLiteral("measuredViews"));
  table_->setAccessibleName(tr("Measured viewpoints"));
  table_->setHorizontalHeaderLabels({tr("View"), tr("ꟻLIP A"), tr("Pixels A"), tr("ꟻLIP B"), tr("Pixels B")});
  for (const int column : {1, 3})
    table_->horizontalHeaderItem(column)->setToolTip(
        tr("Mean ꟻLIP of all pixels: 0 where nobody sees a difference when flipping between the pictures, to "
           "1"));
  for (const int column : {2, 4})
    table_->horizontalHeaderItem(column)->setToolTip(tr("Share of the pixels that differ at all"));
  table_->setWhatsThis(tr(
      "How different each level looks from the original: ꟻLIP (Andersson et al. 2020) and the share of "
      "pixels "
      "that differ (Chang et al. 2008). The viewpoints are others than those that triangles were classified "
      "by: half way between them. Choose a row to see its pictures."));
  makeRowTable(*table_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
}

void ComparisonPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  comparing_.setWatched(true);
}

void ComparisonPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  comparing_.setWatched(false);
}

void ComparisonPanel::showPictures() {
  const auto& shown = comparing_.pictures();
  if (!shown) return grid_->setPictures({});
  std::vector<PictureGrid::Entry> entries{
      {tr("Original"), tr("The model as it is lit for judging"), shown->original}};
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    if (!shown->pictures[method]) continue;
    const PictureMeasures& measured = *shown->measures[method];
    entries.push_back(
        {nameOf(method), tr("What method %1 made of it").arg(nameOf(method)), shown->pictures[method]});
    entries.push_back(
        {tr("ꟻLIP %1: %2").arg(nameOf(method), flipText(measured.flip)),
         tr("Where somebody who flips between the two pictures sees a difference: black nowhere, "
            "by violet and orange to white"),
         shown->maps[method]});
  }
  grid_->setPictures(std::move(entries));
}

QString ComparisonPanel::readout(const QPoint& pixel) const {
  const auto& shown = comparing_.pictures();
  if (!shown) return {};
  QString text = tr("Pixel %1, %2").arg(pixel.x()).arg(pixel.y());
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    const auto& map = shown->errors[method];
    if (!map) continue;
    const auto place = static_cast<std::size_t>(pixel.y()) * static_cast<std::size_t>(map->width) +
                       static_cast<std::size_t>(pixel.x());
    if (place < map->errors.size())
      text += tr("; ꟻLIP %1 %2").arg(nameOf(method), QLocale().toString(map->errors[place], 'f', 3));
  }
  return text;
}

void ComparisonPanel::showRow(int row, const QString& name, const QString& help,
                              const LevelMeasures& measures) {
  QStringList texts{name};
  for (const auto& measure : measures)
    texts << (measure ? flipText(measure->flip) : QStringLiteral("–"))
          << (measure ? percent(measure->pixelError) : QStringLiteral("–"));
  for (int column = 0; column < texts.size(); ++column) {
    QTableWidgetItem* item = table_->item(row, column);
    if (!item) {
      item = new QTableWidgetItem;
      if (column > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      table_->setItem(row, column, item);
    }
    item->setText(texts[column]);
    item->setToolTip(help);
  }
}

void ComparisonPanel::showMeasures() {
  const QSignalBlocker quiet(table_);
  const auto views = comparing_.cameras().size();
  table_->setRowCount(views == 0 ? 0 : static_cast<int>(views) + 1);
  for (const int column : {3, 4}) table_->setColumnHidden(column, !comparing_.hasLevel(Stage::B));
  table_->setMinimumWidth(fontMetrics().averageCharWidth() * (comparing_.hasLevel(Stage::B) ? 52 : 34));
  if (views > 0) {
    const auto& shown = comparing_.pictures();
    const bool own = shown && !comparing_.view();
    showRow(kChosenRow, tr("Chosen"), tr("The viewpoint that is chosen above"),
            own ? shown->measures : LevelMeasures{});
  }
  for (std::size_t view = 0; view < views; ++view)
    showRow(static_cast<int>(view) + 1, QString::number(view + 1), directionText(comparing_.cameras()[view]),
            comparing_.measures(view));
  const auto chosen = comparing_.view();
  if (table_->rowCount() > 0) table_->setCurrentCell(chosen ? static_cast<int>(*chosen) + 1 : kChosenRow, 0);
  showState();
}

void ComparisonPanel::showState() {
  QStringList lines;
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    const Comparing::Pooled pooled = comparing_.pooled(method);
    if (!comparing_.hasLevel(method) || pooled.views == 0) continue;
    lines << tr("<b>%1</b>: ꟻLIP <b>%2</b> (model %3), %4 of pixels")
                 .arg(nameOf(method), flipText(pooled.mean.flip), flipText(pooled.mean.flipShown),
                      percent(pooled.mean.pixelError));
    if (pooled.views < comparing_.cameras().size())
      lines.back() += tr(", %1 of %2 views").arg(pooled.views).arg(comparing_.cameras().size());
  }
  if (lines.isEmpty()) {
    const bool looked = comparing_.perceiving().looked() != nullptr;
    const bool level = comparing_.hasLevel(Stage::A) || comparing_.perceiving().stage().level(Stage::A);
    lines << (!looked               ? tr("Nothing was looked at yet: press Look.")
              : !level              ? tr("There is no level yet to compare with the original.")
              : comparing_.isBusy() ? tr("Comparing…")
                                    : tr("Stopped."));
  }
  pooled_->setToolTip(
      tr("Means over the measured views: ꟻLIP of all pixels, ꟻLIP of the pixels that show the model, and the "
         "share "
         "of pixels that differ at all"));
  pooled_->setText(lines.join(QStringLiteral("<br>")));
  grid_->setMessage(QString(lines.first()).remove(QRegularExpression(QStringLiteral("<[^>]*>"))));
  const bool busy = comparing_.isBusy();
  stop_->setVisible(busy || (!comparing_.isDone() && comparing_.hasLevel(Stage::A)));
  stop_->setText(busy ? tr("Cancel") : tr("Compare"));
  stop_->setIcon(icon(busy ? QStringLiteral("cancel") : QStringLiteral("eye")));
}

}  // namespace lodestone
