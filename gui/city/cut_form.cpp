#include "gui/city/cut_form.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/city/dendrogram_view.h"
#include "gui/widgets/field_slider.h"
#include "gui/widgets/icons.h"

namespace lodestone {
namespace {

constexpr int kSourceLines = 3;  // of the longest text in a narrow dock

}  // namespace

CutForm::CutForm(Workspace& workspace, QWidget* parent)
    : QGroupBox(tr("What is drawn"), parent),
      workspace_(workspace),
      epsilon_(makeSlider("epsilon", &CutOptions::epsilon, 1, 20000)),
      alpha_(makeSlider("alpha", &CutOptions::alpha, 0.1, 200)),
      sign_(new QLabel(this)),
      source_(new QLabel(this)),
      follow_(makeButton(QStringLiteral("followCamera"), tr("Follow camera"), QStringLiteral("eye"))),
      freeze_(makeButton(QStringLiteral("freezeCamera"), tr("Freeze"), QStringLiteral("freeze"))) {
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(follow_);
  buttons->addWidget(freeze_);
  auto* layout = new QVBoxLayout(this);
  layout->setSpacing(8);
  layout->addWidget(epsilon_);
  layout->addWidget(alpha_);
  layout->addWidget(makeSource());
  layout->addLayout(buttons);
  connect(follow_, &QToolButton::clicked, this, [this] {
    workspace_.chooseByCamera(false);
    showState();  // where nothing changed too: a click lets the button up
  });
  connect(freeze_, &QToolButton::clicked, this,
          [this] { workspace_.chooseByCamera(!workspace_.cameraFrozen()); });
  connect(&workspace_, &Workspace::stateChanged, this, &CutForm::showState);
  connect(&workspace_, &Workspace::cutChanged, this, &CutForm::showState);
  showState();
}

FieldSlider* CutForm::makeSlider(const char* name, double CutOptions::*option, double low, double high) {
  const auto& table = fields<CutOptions>();
  const auto field = std::find_if(table.begin(), table.end(), [&](const auto& f) { return f.name == name; });
  auto* slider = new FieldSlider(*field, {low, high, true, 1}, this);
  const QString what = tr("Change %1").arg(QString::fromStdString(field->label));
  connect(slider, &FieldSlider::edited, this, [this, option, what](double value) {
    CutOptions options = workspace_.state().chainOptions.cut;
    options.*option = value;
    workspace_.setCutOptions(options, what);
  });
  return slider;
}

QToolButton* CutForm::makeButton(const QString& name, const QString& text, const QString& iconName) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(text);
  button->setIcon(icon(iconName));
  button->setCheckable(true);
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  return button;
}

QWidget* CutForm::makeSource() {
  auto* box = new QWidget(this);
  source_->setObjectName(QStringLiteral("cutSource"));
  source_->setWordWrap(true);
  source_->setAlignment(Qt::AlignTop);
  source_->setMinimumHeight(kSourceLines * fontMetrics().lineSpacing());  // nothing below it jumps
  sign_->setAlignment(Qt::AlignTop);
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(sign_);
  layout->addWidget(source_, 1);
  return box;
}

void CutForm::showState() {
  const ProjectState& state = workspace_.state();
  epsilon_->setValue(state.chainOptions.cut.epsilon);
  alpha_->setValue(state.chainOptions.cut.alpha);
  const bool tree = state.tree != nullptr;
  for (QWidget* widget : {static_cast<QWidget*>(epsilon_), static_cast<QWidget*>(alpha_),
                          static_cast<QWidget*>(follow_), static_cast<QWidget*>(freeze_)}) {
    widget->setEnabled(tree);
  }
  const bool byCamera = tree && state.cutChoice.mode == CutMode::Camera;
  follow_->setChecked(byCamera && !workspace_.cameraFrozen());
  freeze_->setChecked(byCamera && workspace_.cameraFrozen());
  const QString first = tr("There are no clusters to choose from: press “Cluster” first");
  follow_->setToolTip(tree ? tr("Choose clusters by ε and α from the camera, anew as it moves") : first);
  freeze_->setToolTip(
      tree ? tr("Choose by ε and α what this camera sees now, keep it, and look at it from elsewhere")
           : first);
  showSource();
}

void CutForm::showSource() {
  const ProjectState& state = workspace_.state();
  const double value = state.cutChoice.value;
  const QString back = tr("“Follow camera” lets ε and α choose again.");
  QString sign = QStringLiteral("sample");
  QString said;
  if (!state.tree) {
    if (state.city) said = tr("Every building itself: there are no clusters yet.");
  } else if (state.cutChoice.mode == CutMode::Weight) {
    sign = QStringLiteral("dendrogram");
    said = tr("Cut at weight %1 of the dendrogram. %2").arg(shortNumber(value), back);
  } else if (state.cutChoice.mode == CutMode::Tolerance) {
    sign = QStringLiteral("chain");
    said = tr("Level of %1 m of the chain. %2").arg(QLocale().toString(value), back);
  } else if (state.cutChoice.mode == CutMode::Original) {
    said = tr("The original: every building itself. %1").arg(back);
  } else if (workspace_.cameraFrozen()) {
    sign = QStringLiteral("freeze");
    said = tr("Frozen: what the camera saw then stays drawn. “Follow camera” lets it go.");
  } else {
    sign = QStringLiteral("eye");
    said = tr("Chosen by ε and α from this camera, anew as it moves.");
  }
  source_->setText(said);
  source_->parentWidget()->setVisible(!said.isEmpty());
  const int side = fontMetrics().height();
  sign_->setPixmap(icon(sign).pixmap(QSize(side, side), devicePixelRatioF()));
}

}  // namespace lodestone
