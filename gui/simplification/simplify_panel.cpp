#include "gui/simplification/simplify_panel.h"

#include <QCheckBox>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/simplification/simplify_form.h"
#include "gui/widgets/icons.h"

namespace lodestone {

SimplifyPanel::SimplifyPanel(Stage& stage, QWidget* parent) : QWidget(parent), stage_(stage) {
  auto* first = new QGroupBox(tr("Method A"), this);
  first->setWhatsThis(
      tr("Half-edge collapses that keep the parts of a building together: Wang, Zhang, Chen, Yang, Zhang: "
         "topology-preserving simplification of building models of many components, 2021."));
  compare_ = new QGroupBox(tr("Compare with method B"), this);
  compare_->setObjectName(QStringLiteral("compare"));
  compare_->setCheckable(true);
  compare_->setChecked(false);
  compare_->setToolTip(tr("Make a second model with other options and show it beside the first"));
  for (const auto& [group, method] :
       {std::pair(first, Stage::A), std::pair(static_cast<QGroupBox*>(compare_), Stage::B)}) {
    forms_[method] = new SimplifyForm(stage_, method, group);
    auto* inner = new QVBoxLayout(group);
    inner->addWidget(forms_[method]);
  }
  touching_ = new QCheckBox(tr("With touching buildings"), this);
  touching_->setObjectName(QStringLiteral("withTouching"));
  touching_->setToolTip(
      tr("Buildings that touch are simplified as one model, so that no gap opens between them"));
  run_ = new QPushButton(this);
  run_->setObjectName(QStringLiteral("simplifyNow"));
  export_ = new QPushButton(icon(QStringLiteral("export")), tr("Export simplified building…"), this);
  export_->setObjectName(QStringLiteral("exportSimplified"));

  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(10);
  layout->addWidget(makeFigures());
  layout->addWidget(first);
  layout->addWidget(compare_);
  layout->addWidget(touching_);
  layout->addWidget(export_);
  layout->addStretch(1);

  connect(compare_, &QGroupBox::toggled, &stage_, &Stage::setComparing);
  connect(touching_, &QCheckBox::clicked, this, [this](bool on) { stage_.open(stage_.building(), on); });
  connect(run_, &QPushButton::clicked, this, [this] {
    stage_.isComputing(Stage::A) || stage_.isComputing(Stage::B) ? stage_.cancel() : stage_.compute();
  });
  for (const auto change :
       {&Stage::opening, &Stage::opened, &Stage::closed, &Stage::optionsChanged, &Stage::comparingChanged})
    connect(&stage_, change, this, &SimplifyPanel::showState);
  connect(&stage_, &Stage::computingChanged, this, &SimplifyPanel::showState);
  connect(&stage_, &Stage::perceptionChanged, this, &SimplifyPanel::showState);
  connect(&stage_, &Stage::levelChanged, this, &SimplifyPanel::showState);
  showState();
}

QWidget* SimplifyPanel::makeFigures() {
  auto* box = new QWidget(this);
  triangles_ = new QLabel(box);
  triangles_->setObjectName(QStringLiteral("stageTriangles"));
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.9);
  large.setWeight(QFont::DemiBold);
  triangles_->setFont(large);
  state_ = new QLabel(box);
  state_->setObjectName(QStringLiteral("stageState"));
  state_->setWordWrap(true);
  auto* row = new QHBoxLayout;  // whether the button is there or not, nothing else moves
  row->addWidget(triangles_, 1);
  row->addWidget(run_);
  row->addStrut(std::max(triangles_->sizeHint().height(), run_->sizeHint().height()));
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(2, 0, 2, 0);
  layout->setSpacing(0);
  layout->addLayout(row);
  layout->addWidget(state_);
  return box;
}

void SimplifyPanel::showState() {
  const QLocale locale;
  const auto& level = stage_.level(Stage::A);
  const bool open = stage_.isOpen();
  const std::uint32_t all = open ? stage_.staged()->mesh->triangleCount() : 0;
  triangles_->setText(level ? locale.toString(level->simplified->mesh.triangleCount()) : QStringLiteral("–"));
  const bool computing = stage_.isComputing(Stage::A) || stage_.isComputing(Stage::B);
  const bool unfinished =
      stage_.isUnfinished(Stage::A) || (stage_.comparing() && stage_.isUnfinished(Stage::B));
  QString said = open ? tr("of %1 triangles").arg(locale.toString(all)) : tr("Classifying…");
  if (open && all == 0) said = tr("It has a footprint alone: there are no surfaces to simplify.");
  if (open && all > Stage::kMostLiveTriangles)
    said += tr("; more than %1, so press Simplify").arg(locale.toString(Stage::kMostLiveTriangles));
  if (open && all > 0 && stage_.needsPictures() && !stage_.perception())
    said += tr("; pictures say first where it may be touched");
  state_->setText(said);
  run_->setVisible(open && (!stage_.isLive() || stage_.isStopped()));
  run_->setText(computing ? tr("Cancel") : tr("Simplify"));
  run_->setIcon(icon(computing ? QStringLiteral("cancel") : QStringLiteral("simplify")));
  run_->setEnabled(computing || unfinished);
  touching_->setEnabled(open);
  touching_->setChecked(stage_.withTouching());
  compare_->setChecked(stage_.comparing());
  export_->setEnabled(level.has_value());
}

}  // namespace lodestone
