#include "gui/perception/perception_panel.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QTabBar>
#include <QTabWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/perception/classes_panel.h"
#include "gui/perception/comparison_panel.h"
#include "gui/perception/picture_grid.h"
#include "gui/perception/sensitivity_plot.h"
#include "gui/perception/viewpoint_strip.h"
#include "gui/widgets/counted.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/parameter_panel.h"

namespace lodestone {
namespace {

QString number(std::size_t value) {
  return QLocale().toString(static_cast<qulonglong>(value));
}

/// "40 s", "13 min".
QString durationText(double seconds) {
  if (seconds < 90) return PerceptionPanel::tr("%1 s").arg(QLocale().toString(std::ceil(seconds)));
  return PerceptionPanel::tr("%1 min").arg(QLocale().toString(std::ceil(seconds / 60)));
}

QScrollArea* scrolled(QWidget* widget, QWidget* parent) {
  auto* area = new QScrollArea(parent);
  area->setWidgetResizable(true);
  area->setFrameShape(QFrame::NoFrame);
  area->setWidget(widget);
  return area;
}

}  // namespace

PerceptionPanel::PerceptionPanel(Perceiving& perceiving, Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      perceiving_(perceiving),
      shown_(new ShownPictures(perceiving, workspace, this)),
      comparing_(new Comparing(perceiving, workspace, this)),
      strip_(new ViewpointStrip(this)),
      look_(new QPushButton(this)),
      state_(new QLabel(this)),
      grid_(new PictureGrid(this)),
      comparison_(new ComparisonPanel(*comparing_, this)),
      classes_(new ClassesPanel(perceiving, this)),
      fields_(new ParameterPanel(this)),
      sensitivity_(new SensitivityPlot(this)),
      views_(new QTabWidget(this)),
      sides_(new QTabWidget(this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->setSpacing(4);
  grid_->setObjectName(QStringLiteral("viewPictures"));
  grid_->setAccessibleName(tr("Pictures of the chosen viewpoint"));
  grid_->setHint(tr("Wheel: zoom. Drag: move. Double-click: whole picture. Click: select its component."));
  grid_->setReadout([this](const QPoint& pixel) { return shown_->textOf(pixel); });
  views_->setObjectName(QStringLiteral("perceptionViews"));
  views_->setDocumentMode(true);
  views_->addTab(grid_, tr("Viewpoint"));
  views_->addTab(comparison_, tr("Comparison"));
  sides_->setObjectName(QStringLiteral("perceptionSides"));
  sides_->setDocumentMode(true);
  sides_->setMinimumWidth(fontMetrics().averageCharWidth() * 54);
  sides_->addTab(classes_, tr("Classes"));
  sides_->addTab(makeDisplay(), tr("Display and eye"));
  auto* splitter = new QSplitter(Qt::Horizontal, this);
  auto* left = new QWidget(splitter);
  auto* column = new QVBoxLayout(left);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(2);
  column->addWidget(strip_);
  column->addWidget(makeBar());
  column->addWidget(views_, 1);
  splitter->addWidget(left);
  splitter->addWidget(sides_);
  splitter->setStretchFactor(0, 2);
  splitter->setStretchFactor(1, 1);
  splitter->setChildrenCollapsible(false);
  // A form and a plot beside each other want more of the width than plot and table below each other.
  connect(sides_, &QTabWidget::currentChanged, this, [this, splitter](int) {
    const int wide = splitter->width();
    const int side = sides_->currentWidget() == classes_ ? wide * 3 / 10 : wide * 9 / 20;
    splitter->setSizes({wide - side, side});
  });
  layout->addWidget(splitter, 1);

  for (const auto change : {&Perceiving::camerasChanged, &Perceiving::viewChanged})
    connect(&perceiving_, change, this, &PerceptionPanel::showViewpoints);
  for (const auto change : {&Perceiving::lookedChanged, &Perceiving::looking})
    connect(&perceiving_, change, this, &PerceptionPanel::showState);
  connect(&perceiving_, &Perceiving::optionsChanged, this, &PerceptionPanel::showOptions);
  connect(&perceiving_, &Perceiving::thumbnailMade, this, [this](std::size_t view) {
    strip_->setPicture(view, perceiving_.thumbnail(view));
    showState();
  });
  connect(shown_, &ShownPictures::changed, this, &PerceptionPanel::showPictures);
  connect(grid_, &PictureGrid::picked, this, [this](const QPoint& pixel) {
    const auto triangle = shown_->triangleAt(pixel);
    if (triangle && perceiving_.stage().isOpen())
      perceiving_.stage().select({componentOfTriangle(*perceiving_.stage().staged()->mesh, *triangle)});
  });
  showViewpoints();
  showOptions();
  showPictures();
}

QToolButton* PerceptionPanel::addTool(const QString& name, const QString& text, const QString& iconName,
                                      const QString& help) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(text);
  button->setIcon(icon(iconName));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setAutoRaise(true);
  button->setToolTip(help);
  return button;
}

/// Tabs, and beside them what is said and done. In the corner of a tab widget it would push its tabs away.
QWidget* PerceptionPanel::makeBar() {
  add_ = addTool(QStringLiteral("addViewpoint"), tr("From camera"), QStringLiteral("perspective"),
                 tr("What the view's camera sees is one more viewpoint"));
  remove_ = addTool(QStringLiteral("removeViewpoint"), tr("Remove"), QStringLiteral("cancel"),
                    tr("Take the chosen viewpoint away, where it was added"));
  look_->setObjectName(QStringLiteral("lookNow"));
  state_->setObjectName(QStringLiteral("perceptionState"));
  state_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  state_->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  state_->setWordWrap(true);  // in a row that is as high with one line, so that nothing moves
  state_->setMinimumHeight(2 * state_->fontMetrics().lineSpacing());
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  auto* tabs = new QTabBar(bar);
  tabs->setDocumentMode(true);
  tabs->setDrawBase(false);
  tabs->setUsesScrollButtons(false);
  for (int i = 0; i < views_->count(); ++i) tabs->addTab(views_->tabText(i));
  views_->tabBar()->hide();
  connect(tabs, &QTabBar::currentChanged, views_, &QTabWidget::setCurrentIndex);
  connect(views_, &QTabWidget::currentChanged, tabs, &QTabBar::setCurrentIndex);
  row->addWidget(tabs);
  row->addWidget(state_, 1);
  row->addWidget(look_);
  row->addWidget(add_);
  row->addWidget(remove_);

  connect(strip_, &ViewpointStrip::chosen, &perceiving_, &Perceiving::choose);
  connect(strip_, &QListWidget::itemActivated, this, [this] {
    const std::vector<Camera> cameras = perceiving_.cameras();
    if (perceiving_.view() < cameras.size()) Q_EMIT lookFromRequested(cameras[perceiving_.view()]);
  });
  connect(add_, &QToolButton::clicked, this, &PerceptionPanel::addCameraRequested);
  connect(remove_, &QToolButton::clicked, this, [this] { perceiving_.removeCamera(perceiving_.view()); });
  connect(look_, &QPushButton::clicked, this,
          [this] { perceiving_.isLooking() ? perceiving_.cancel() : perceiving_.look(); });
  return bar;
}

QWidget* PerceptionPanel::makeDisplay() {
  fields_->addFields<PerceiveOptions>({"slight", "moderate", "dramatic"});
  connect(fields_, &ParameterPanel::edited, this, [this](const QString& name) {
    const auto& table = lodestone::fields<PerceiveOptions>();
    const auto field = std::find_if(table.begin(), table.end(),
                                    [&](const FieldInfo& info) { return info.name == name.toStdString(); });
    perceiving_.setOptions(fields_->read(perceiving_.options()),
                           tr("Change %1").arg(QString::fromStdString(field->label).toLower()));
  });
  auto* page = new QWidget(this);
  auto* row = new QHBoxLayout(page);
  row->setContentsMargins(4, 4, 4, 4);
  auto* form = new QWidget(page);
  auto* column = new QVBoxLayout(form);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(fields_);
  column->addStretch();
  row->addWidget(scrolled(form, page), 5);
  row->addWidget(sensitivity_, 6);
  return page;
}

void PerceptionPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  Q_EMIT shownChanged();
}

void PerceptionPanel::hideEvent(QHideEvent* event) {
  QWidget::hideEvent(event);
  Q_EMIT shownChanged();
}

void PerceptionPanel::showViewpoints() {
  const std::vector<Camera> cameras = perceiving_.cameras();
  if (cameras.size() != strip_->viewCount() || sender() != &perceiving_ ||
      strip_->currentRow() != static_cast<int>(perceiving_.view())) {
    strip_->setViewpoints(cameras);
    for (std::size_t view = 0; view < cameras.size(); ++view) {
      if (!perceiving_.thumbnail(view).isNull()) strip_->setPicture(view, perceiving_.thumbnail(view));
    }
    strip_->choose(perceiving_.view());
  }
  remove_->setEnabled(perceiving_.isAdded(perceiving_.view()));
  showState();
}

void PerceptionPanel::showPictures() {
  const auto& shown = shown_->pictures();
  if (!shown) return grid_->setPictures({});
  const QString titles[] = {tr("Rendered"), tr("Filtered"), tr("Difference"), tr("Classes")};
  const QString helps[] = {
      tr("The model as it is lit for judging, in display-encoded grey and colour"),
      tr("What the eye lets through: every band of the wavelet transform weighted by the contrast "
         "sensitivity"),
      tr("The magnitude of rendered − filtered: black where nothing is filtered away"),
      tr("The class of each pixel: blue none, light blue slight, orange moderate, red dramatic")};
  std::vector<PictureGrid::Entry> entries;
  for (std::size_t i = 0; i < shown->pictures.size(); ++i)
    entries.push_back({titles[i], helps[i], shown->pictures[i]});
  grid_->setPictures(std::move(entries));
}

void PerceptionPanel::showOptions() {
  fields_->show(perceiving_.options());
  sensitivity_->show(perceiving_.options());
  showState();
}

QString PerceptionPanel::state() const {
  return state_->text();
}

QString PerceptionPanel::stateText() const {
  if (!perceiving_.stage().isOpen())
    return perceiving_.stage().isOpening() ? tr("Classifying…") : tr("No building is on the stage.");
  if (!perceiving_.canLook()) return tr("It has no surfaces to look at.");
  const std::size_t views = perceiving_.cameras().size();
  if (perceiving_.isLooking()) {
    return perceiving_.made() == 0 ? tr("Looking…")
                                   : tr("Looking: %1 of %2 viewpoints").arg(perceiving_.made()).arg(views);
  }
  const auto& looked = perceiving_.looked();
  if (perceiving_.isOutdated()) {
    const QString cost = tr("%1 of %L2 × %L2 pixels take about %3 and %4 GiB.")
                             .arg(counted(views, tr("picture"), tr("pictures")))
                             .arg(perceiving_.options().size)
                             .arg(durationText(perceiving_.seconds()),
                                  QLocale().toString(std::max(0.1, perceiving_.gibibytes()), 'f', 1));
    return cost + QStringLiteral(" ") +
           (looked ? tr("What is shown is of before: press Look.") : tr("Press Look."));
  }
  if (perceiving_.isLeftUnjudged()) return tr("Classes are by the cuts of before: press Look.");
  const Perception& seen = *looked->perception;
  const std::size_t visible = seen.pixels.size() - countDetail(seen).unseen;
  if (visible == 0) return tr("Nothing of the model is seen from these viewpoints.");
  return tr("%1 of %2 triangles in sight of %3 or from between them, in %4.")
      .arg(number(visible), number(seen.pixels.size()), counted(views, tr("viewpoint"), tr("viewpoints")),
           durationText(looked->seconds));
}

void PerceptionPanel::showState() {
  const bool looking = perceiving_.isLooking();
  const QString text = stateText();
  state_->setText(text);
  state_->setToolTip(text);
  grid_->setMessage(text);
  look_->setText(looking ? tr("Cancel") : tr("Look"));
  look_->setIcon(icon(looking ? QStringLiteral("cancel") : QStringLiteral("eye")));
  look_->setEnabled(looking || perceiving_.isOutdated() || perceiving_.isLeftUnjudged());
  look_->setToolTip(looking ? tr("Stop looking; what was seen before stays")
                            : tr("Look from all viewpoints again"));
  add_->setEnabled(perceiving_.canLook());
  remove_->setEnabled(perceiving_.isAdded(perceiving_.view()));
}

}  // namespace lodestone
