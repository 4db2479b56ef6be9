#include "gui/perception/classes_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <numeric>

#include "gui/perception/difference_plot.h"
#include "gui/widgets/detail_looks.h"
#include "gui/widgets/row_table.h"

namespace lodestone {
namespace {

constexpr int kStages = 3;
constexpr int kLinesALevel = 2;
constexpr double PerceiveOptions::*kCutOptions[] = {&PerceiveOptions::slight, &PerceiveOptions::moderate,
                                                    &PerceiveOptions::dramatic};

QString number(std::size_t value) {
  return QLocale().toString(static_cast<qulonglong>(value));
}

/// The classes of a stage, as colours.
QPixmap swatches(int stage, int size, double ratio) {
  QPixmap picture(QSize(size * kStages, size) * ratio);
  picture.setDevicePixelRatio(ratio);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  for (int i = 0; i < stage; ++i)
    painter.fillRect(QRect(i * size, 0, size - 2, size),
                     colourOf(static_cast<DetailClass>(static_cast<int>(kDetailClasses) - 1 - i)));
  return picture;
}

}  // namespace

ClassesPanel::ClassesPanel(Perceiving& perceiving, QWidget* parent)
    : QWidget(parent),
      perceiving_(perceiving),
      plot_(new DifferencePlot(this)),
      stages_(new QTableWidget(kStages, 3, this)),
      removed_(new QLabel(this)),
      find_(new QPushButton(tr("Find cuts"), this)),
      use_(new QPushButton(tr("Simplify at this stage"), this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(4, 4, 4, 4);
  layout->setSpacing(4);
  layout->addWidget(plot_, 1);
  makeTable();
  layout->addWidget(stages_);
  removed_->setObjectName(QStringLiteral("removedTriangles"));
  removed_->setAlignment(Qt::AlignLeft | Qt::AlignTop);
  removed_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // what it says moves nothing
  layout->addWidget(removed_);
  find_->setObjectName(QStringLiteral("findCuts"));
  find_->setToolTip(tr("Have all three cuts found by maximum likelihood again"));
  use_->setObjectName(QStringLiteral("useStage"));
  use_->setToolTip(
      tr("Method A touches the triangles of the chosen row alone: perception, or combined where that is "
         "chosen"));
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(find_);
  buttons->addStretch();
  buttons->addWidget(use_);
  layout->addLayout(buttons);
  connect(plot_, &DifferencePlot::cutMoved, this, [this](std::size_t cut, int bin) {
    setCut(cut, binBegin(bin),
           tr("Move the cut of %1").arg(nameOf(static_cast<DetailClass>(cut + 1)).toLower()));
  });
  connect(plot_, &DifferencePlot::cutReset, this, [this](std::size_t cut) {
    setCut(cut, 0, tr("Find the cut of %1").arg(nameOf(static_cast<DetailClass>(cut + 1)).toLower()));
  });
  connect(find_, &QPushButton::clicked, this, &ClassesPanel::findAgain);
  connect(use_, &QPushButton::clicked, this, &ClassesPanel::useStage);
  connect(stages_, &QTableWidget::itemActivated, this, &ClassesPanel::useStage);
  connect(stages_, &QTableWidget::itemSelectionChanged, this, &ClassesPanel::showUse);
  for (const auto change : {&Perceiving::lookedChanged, &Perceiving::optionsChanged})
    connect(&perceiving_, change, this, [this] {
      showPlot();
      showStages();
    });
  for (const auto change : {&Stage::comparingChanged, &Stage::optionsChanged})
    connect(&perceiving_.stage(), change, this, &ClassesPanel::showStages);
  connect(&perceiving_.stage(), &Stage::levelChanged, this, &ClassesPanel::showStages);
  stages_->selectRow(perceiving_.stage().options(Stage::A).stage - 1);
  showPlot();
  showStages();
}

void ClassesPanel::makeTable() {
  stages_->setObjectName(QStringLiteral("stages"));
  stages_->setAccessibleName(tr("Triangles of each stage"));
  stages_->setHorizontalHeaderLabels({tr("Stage"), tr("Triangles"), tr("With unseen")});
  stages_->horizontalHeaderItem(1)->setToolTip(tr("That are seen, and of a class that the stage touches"));
  stages_->horizontalHeaderItem(2)->setToolTip(tr("And those that no picture shows (“Unseen too”)"));
  stages_->setWhatsThis(tr(
      "Which triangles may be simplified: at stage 1 those whose detail the eye filters away dramatically, "
      "at stage 2 moderately too, at stage 3 slightly too (Du, Zhu and Zhao, section 5.2). A double click "
      "simplifies at a stage."));
  makeRowTable(*stages_);
  const int line = stages_->verticalHeader()->defaultSectionSize();
  stages_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  stages_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  stages_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  stages_->setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  stages_->setFixedHeight(line * kStages + stages_->horizontalHeader()->sizeHint().height() + 3);
  stages_->setIconSize(QSize(kStages * line / 2, line / 2));
  const QString names[] = {tr("1: dramatic"), tr("2: and moderate"), tr("3: and slight")};
  for (int row = 0; row < kStages; ++row) {
    auto* name = new QTableWidgetItem(names[row]);
    name->setIcon(swatches(row + 1, line / 2, devicePixelRatioF()));
    stages_->setItem(row, 0, name);
    for (const int column : {1, 2}) {
      auto* item = new QTableWidgetItem;
      item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      stages_->setItem(row, column, item);
    }
  }
}

void ClassesPanel::setCut(std::size_t cut, double greyLevels, const QString& what) {
  PerceiveOptions options = perceiving_.options();
  options.*kCutOptions[cut] = greyLevels;
  perceiving_.setOptions(options, what);
}

void ClassesPanel::findAgain() {
  PerceiveOptions options = perceiving_.options();
  for (const auto cut : kCutOptions) options.*cut = 0;
  perceiving_.setOptions(options, tr("Find the cuts"));
}

void ClassesPanel::useStage() {
  Stage& stage = perceiving_.stage();
  if (!perceiving_.looked() || stages_->currentRow() < 0) return;
  SimplifyOptions options = stage.options(Stage::A);
  if (!needsPerception(options.method)) options.method = SimplifyMethod::Perception;
  options.stage = stages_->currentRow() + 1;
  stage.setOptions(Stage::A, options, tr("Simplify at stage %1").arg(options.stage));
  if (!stage.isLive()) stage.compute();
}

void ClassesPanel::showPlot() {
  const auto& looked = perceiving_.looked();
  const PerceiveOptions& options = perceiving_.options();
  find_->setEnabled(options.slight > 0 || options.moderate > 0 || options.dramatic > 0);
  if (!looked)
    return plot_->clear(
        tr("How much the pictures differ from what the eye lets through of them is shown here."));
  const Perception& seen = *looked->perception;
  if (std::accumulate(seen.histogram.begin(), seen.histogram.end(), std::uint64_t{0}) == 0)
    return plot_->clear(tr("Nothing of the model is seen from these viewpoints."));
  plot_->show(seen.histogram, seen.differences,
              {options.slight > 0, options.moderate > 0, options.dramatic > 0});
}

void ClassesPanel::showStages() {
  const auto& looked = perceiving_.looked();
  const DetailCounts counts = looked ? countDetail(*looked->perception) : DetailCounts{};
  for (int row = 0; row < kStages; ++row) {
    for (const bool unseen : {false, true})
      stages_->item(row, unseen ? 2 : 1)
          ->setText(looked ? number(counts.admitted(row + 1, unseen)) : QStringLiteral("–"));
  }
  const bool comparing = perceiving_.stage().comparing();
  QStringList lines = removedLines(Stage::A);
  if (comparing) lines += removedLines(Stage::B);
  removed_->setFixedHeight(fontMetrics().lineSpacing() * kLinesALevel * (comparing ? 2 : 1));
  removed_->setText(lines.join(QLatin1Char('\n')));
  removed_->setToolTip(removed_->text());
  showUse();
}

void ClassesPanel::showUse() {
  const int row = stages_->currentRow();
  use_->setEnabled(perceiving_.looked() && row >= 0);
  use_->setText(row < 0 ? tr("Simplify at a stage") : tr("Simplify at stage %1").arg(row + 1));
}

/// Of a level that follows a stage: how many triangles are gone, the paper's rate, and whether the stage held
/// up the rate that was asked for.
QStringList ClassesPanel::removedLines(Stage::Method method) const {
  const auto& level = perceiving_.stage().level(method);
  if (!level || !perceiving_.stage().isOpen() || !needsPerception(level->options.method)) return {};
  const std::uint32_t before = perceiving_.stage().staged()->mesh->triangleCount();
  const std::uint32_t after = level->simplified->mesh.triangleCount();
  QStringList shares;
  const auto& stage = level->report ? level->report->stage : std::nullopt;
  const bool unseen = level->options.unseen;  // they are of no class
  const std::uint32_t whole = !stage ? 0 : unseen ? stage->admitted : stage->latent();
  if (whole > 0) {
    const QString percent = QLocale().toString(100.0 * stage->removed / whole, 'f', 1);
    shares << (unseen ? tr("%1 % of those admitted") : tr("%1 % of slight and above")).arg(percent);
  }
  if (fallsShort(level->options, before, after))
    shares << tr("stopped before rate %1").arg(QLocale().toString(level->options.rate));
  return {tr("%1, stage %2: %3 of %4 triangles removed")
              .arg(method == Stage::A ? tr("A") : tr("B"))
              .arg(level->options.stage)
              .arg(number(before - std::min(before, after)), number(before)),
          shares.join(QStringLiteral("; "))};
}

}  // namespace lodestone
