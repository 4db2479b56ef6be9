#include "gui/city/chain_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QImage>
#include <QLabel>
#include <QPushButton>
#include <QStackedWidget>
#include <QVBoxLayout>
#include <cmath>
#include <numbers>

#include "algorithms/rendering/rendering.h"
#include "gui/city/level_strip.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/parameter_panel.h"
#include "gui/widgets/picture_image.h"

namespace lodestone {
namespace {

/// The same view in another size, as wide as before.
Camera pictureCamera(Camera camera, const QSize& size) {
  const double wider = camera.height * size.width() / (static_cast<double>(camera.width) * size.height());
  const double half = std::tan(camera.fov * std::numbers::pi / 360);
  if (wider > 1) camera.fov = std::atan(half / wider) * 360 / std::numbers::pi;
  camera.width = size.width();
  camera.height = size.height();
  return camera;
}

}  // namespace

ChainPanel::ChainPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      form_(new ParameterPanel(this)),
      strip_(new LevelStrip(this)),
      empty_(new QLabel(this)),
      stack_(new QStackedWidget(this)),
      measure_(new QPushButton(icon(QStringLiteral("chain")), tr("Measure levels"), this)),
      add_(new QPushButton(tr("+ Level"), this)) {
  form_->addFields<ChainOptions>({"epsilon", "alpha"});
  empty_->setObjectName(QStringLiteral("noLevels"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  empty_->setEnabled(false);
  stack_->addWidget(empty_);
  stack_->addWidget(strip_);
  add_->setObjectName(QStringLiteral("addLevel"));
  measure_->setObjectName(QStringLiteral("measureLevels"));
  auto* write = new QPushButton(icon(QStringLiteral("export")), tr("Export…"), this);

  form_->setMaximumWidth(fontMetrics().averageCharWidth() * 34);

  auto* side = new QVBoxLayout;
  side->addWidget(form_);
  side->addStretch(1);
  auto* buttons = new QGridLayout;
  buttons->addWidget(measure_, 0, 0, 1, 2);
  buttons->addWidget(add_, 1, 0);
  buttons->addWidget(write, 1, 1);
  side->addLayout(buttons);
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 6, 6, 6);
  layout->setSpacing(12);
  layout->addLayout(side);
  layout->addWidget(stack_, 1);

  connect(form_, &ParameterPanel::edited, this, [this] {
    workspace_.setChainOptions(form_->read(workspace_.state().chainOptions), tr("Change levels"));
  });
  connect(measure_, &QPushButton::clicked, &workspace_, &Workspace::makeChainPreview);
  connect(add_, &QPushButton::clicked, this, &ChainPanel::addLevel);
  connect(write, &QPushButton::clicked, this, &ChainPanel::exportRequested);
  connect(strip_, &LevelStrip::chosen, this, &ChainPanel::showLevel);
  connect(&workspace_, &Workspace::chainChanged, this, &ChainPanel::refresh);
  connect(&workspace_, &Workspace::stateChanged, this, [this] {
    showReady();
    markShown();
  });
  connect(&workspace_.tasks(), &TaskRunner::started, this, &ChainPanel::showReady);
  connect(&workspace_.tasks(), &TaskRunner::finished, this, &ChainPanel::showReady);
  showReady();
}

QString ChainPanel::missing() const {
  if (workspace_.state().tree) return {};
  if (workspace_.tasks().busy(Workspace::clusterTask()))
    return tr("Clustering: levels can be measured when it is done.");
  if (workspace_.canCluster())
    return tr("Press “Cluster” first: the levels of a chain are made from clusters of buildings.");
  return tr("Open a city model and cluster it: the levels of a chain are made from clusters of buildings.");
}

void ChainPanel::showReady() {
  form_->show(workspace_.state().chainOptions);
  const QString first = missing();
  empty_->setText(first.isEmpty()
                      ? tr("Press “Measure levels” to see what each level of the chain looks like and costs.")
                      : first);
  for (QPushButton* button : {measure_, add_}) button->setEnabled(first.isEmpty());
  measure_->setText(workspace_.chainOutdated() ? tr("Measure again") : tr("Measure levels"));
  measure_->setToolTip(first.isEmpty() ? tr("What each level looks like and costs, and where it takes over")
                                       : first);
  add_->setToolTip(first.isEmpty() ? tr("One more level, twice as coarse as the last") : first);
}

void ChainPanel::addLevel() {
  ChainOptions options = workspace_.state().chainOptions;
  const QString all = QString::fromStdString(options.tolerances);
  const double last = all.section(QLatin1Char(','), -1).toDouble();
  if (last > 0) options.tolerances = QStringLiteral("%1,%2").arg(all).arg(2 * last).toStdString();
  workspace_.setChainOptions(options, tr("Add a level"));
  workspace_.makeChainPreview();
}

void ChainPanel::refresh() {
  const auto& chain = workspace_.chain();
  showReady();
  strip_->setLevels(chain ? chain->levels : std::vector<LodLevel>());
  stack_->setCurrentWidget(chain ? static_cast<QWidget*>(strip_) : empty_);
  markShown();
  if (chain) drawPictures();
}

void ChainPanel::drawPictures() {
  const LodChain chain = *workspace_.chain();
  const Camera camera = pictureCamera(workspace_.camera(), strip_->pictureSize() * devicePixelRatioF());
  workspace_.tasks().start(
      QStringLiteral("pictures"), tr("Drawing levels"),
      [chain, camera](const Progress& progress) {
        std::vector<QImage> pictures;
        const double share = 1.0 / static_cast<double>(chain.levels.size());
        for (const LodLevel& level : chain.levels) {
          const double begin = static_cast<double>(pictures.size()) * share;
          pictures.push_back(
              toImage(renderLevel(level, camera, progress.part(begin, begin + share, level.name))));
        }
        return pictures;
      },
      [this, chain](const std::vector<QImage>& pictures) {
        const auto& now = workspace_.chain();
        if (now && now->tree == chain.tree && now->recipe == chain.recipe) strip_->setPictures(pictures);
      });
}

CutChoice ChainPanel::choiceOf(int level) const {
  double tolerance = 0;
  for (const auto& [name, value] : workspace_.chain()->levels[static_cast<std::size_t>(level)].options) {
    if (name == "tolerance" && std::holds_alternative<double>(value)) tolerance = std::get<double>(value);
  }
  return level == 0 ? CutChoice{CutMode::Original, 0} : CutChoice{CutMode::Tolerance, tolerance};
}

void ChainPanel::showLevel(int level) {
  workspace_.setCutChoice(choiceOf(level));
}

void ChainPanel::markShown() {
  int shown = -1;
  const int levels = workspace_.chain() ? static_cast<int>(workspace_.chain()->levels.size()) : 0;
  for (int level = 0; level < levels; ++level) {
    if (choiceOf(level) == workspace_.state().cutChoice) shown = level;
  }
  strip_->setShown(shown);
}

}  // namespace lodestone
