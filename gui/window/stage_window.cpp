#include "gui/window/stage_window.h"

#include <QAction>
#include <QActionGroup>
#include <QDockWidget>
#include <QPainter>
#include <QPushButton>
#include <QScrollArea>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "gui/perception/perceiving.h"
#include "gui/perception/perception_panel.h"
#include "gui/simplification/auto_curve.h"
#include "gui/simplification/components_panel.h"
#include "gui/simplification/contacts_panel.h"
#include "gui/simplification/measures_panel.h"
#include "gui/simplification/sight.h"
#include "gui/simplification/sight_link.h"
#include "gui/simplification/sight_panel.h"
#include "gui/simplification/simplify_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/simplification/stage_link.h"
#include "gui/simplification/stage_view.h"
#include "gui/simplification/vertex_panel.h"
#include "gui/widgets/icons.h"

namespace lodestone {
namespace {

constexpr QSize kUsualSize(1440, 780);
constexpr QSize kLeastView(320, 200);

/// Tells that it is about to be shown while nothing has moved for it yet.
class AnnouncedDock : public QDockWidget {
 public:
  AnnouncedDock(const QString& title, QWidget* parent, std::function<void()> beforeShown)
      : QDockWidget(title, parent), beforeShown_(std::move(beforeShown)) {}

  void setVisible(bool visible) override {
    if (visible && isHidden() && beforeShown_) beforeShown_();
    QDockWidget::setVisible(visible);
  }

 private:
  std::function<void()> beforeShown_;
};

}  // namespace

StageWindow::StageWindow(Workspace& workspace, QWidget* parent)
    : QMainWindow(parent),
      workspace_(workspace),
      stage_(new Stage(workspace, this)),
      sight_(new Sight(*stage_, workspace, this)),
      perceiving_(new Perceiving(*stage_, workspace, this)) {
  setWindowFlags(Qt::Widget);  // a window inside a window: docks of its own
  setObjectName(QStringLiteral("stageWindow"));
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  auto* middle = new QWidget(this);
  view_ = new StageView(middle);
  legend_ = new StageLegend(*stage_, middle);
  auto* layout = new QVBoxLayout(middle);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(view_, 1);
  layout->addWidget(legend_);
  middle->setSizePolicy(QSizePolicy::Ignored,
                        QSizePolicy::Ignored);  // docks keep their widths, it has the rest
  middle->setMinimumSize(kLeastView);
  setCentralWidget(middle);
  makeDocks();
  link_ = new StageLink(*stage_, *view_, *components_, *legend_, this);
  makeToolBar();
  resize(kUsualSize);  // what docks are given is a share of it
  useDefaultLayout();
}

StageWindow::~StageWindow() {
  // What looks at the stage goes before it does.
  delete link_;
  delete sightLink_;
  qDeleteAll(docks_);
  delete takeCentralWidget();
  delete sight_;
  delete perceiving_;
}

QDockWidget* StageWindow::addDock(const QString& name, const QString& title, QWidget* panel,
                                  Qt::DockWidgetArea area, std::function<void()> beforeShown) {
  auto* dock = new AnnouncedDock(title, this, std::move(beforeShown));
  dock->setObjectName(name);
  dock->setWidget(panel);
  addDockWidget(area, dock);
  docks_ << dock;
  return dock;
}

void StageWindow::makeDocks() {
  components_ = new ComponentsPanel(*stage_, this);
  method_ = new SimplifyPanel(*stage_, this);
  connect(&method_->exportButton(), &QPushButton::clicked, this, &StageWindow::exportRequested);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(method_);
  scroll->setMinimumWidth(method_->minimumSizeHint().width() + fontMetrics().averageCharWidth() * 3);
  componentsDock_ =
      addDock(QStringLiteral("componentsDock"), tr("Components"), components_, Qt::LeftDockWidgetArea);
  vertexDock_ = addDock(QStringLiteral("vertexDock"), tr("Vertex"), new VertexPanel(*stage_, this),
                        Qt::LeftDockWidgetArea);
  methodDock_ =
      addDock(QStringLiteral("simplifyDock"), tr("Simplification"), scroll, Qt::RightDockWidgetArea);
  measuresDock_ = addDock(QStringLiteral("measuresDock"), tr("Measurements"),
                          new MeasuresPanel(*stage_, this), Qt::BottomDockWidgetArea);
  contactsDock_ = addDock(QStringLiteral("contactsDock"), tr("Contacts"), new ContactsPanel(*stage_, this),
                          Qt::BottomDockWidgetArea);
  curveDock_ = addDock(QStringLiteral("curveDock"), tr("Choice of a"), new AutoCurve(*stage_, this),
                       Qt::BottomDockWidgetArea);
  connect(stage_, &Stage::levelChanged, curveDock_, [this, searched = false](Stage::Method method) mutable {
    if (method != Stage::A) return;
    const bool found = !stage_->level(Stage::A)->trials.empty();
    if (found && !searched) curveDock_->raise();  // who asks for a wants to see why
    searched = found;
  });
  makeVisibilityDock();
  makePerceptionDock();
}

void StageWindow::makeVisibilityDock() {
  visibility_ = new SightPanel(*sight_, this);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(visibility_);
  scroll->setMinimumWidth(fontMetrics().averageCharWidth() * 36);
  visibilityDock_ =
      addDock(QStringLiteral("visibilityDock"), tr("Visibility"), scroll, Qt::LeftDockWidgetArea);
  sightLink_ = new SightLink(*sight_, *view_, this);
  connect(visibility_, &SightPanel::fromCameraRequested, sightLink_, &SightLink::standAtCamera);
  connect(visibility_, &SightPanel::lookRequested, sightLink_, &SightLink::lookFromViewpoint);
}

void StageWindow::makePerceptionDock() {
  perception_ = new PerceptionPanel(*perceiving_, workspace_, this);
  perceptionDock_ = addDock(QStringLiteral("perceptionDock"), tr("Perception"), perception_,
                            Qt::BottomDockWidgetArea, [this] { makeRoomForPerception(); });
  perceptionDock_->hide();
  connect(perceptionDock_->toggleViewAction(), &QAction::toggled, this, &StageWindow::showPerception);
  connect(perception_, &PerceptionPanel::shownChanged, this, &StageWindow::watchPerception);
  connect(&legend_->details(), &QToolButton::toggled, this, &StageWindow::watchPerception);
  connect(perceiving_, &Perceiving::consentWanted, perceptionDock_, &QWidget::show);
  connect(perception_, &PerceptionPanel::addCameraRequested, this,
          [this] { perceiving_->addCamera(view_->view().camera()); });
  connect(perception_, &PerceptionPanel::lookFromRequested, this, [this](const Camera& from) {
    Camera camera = view_->view().camera();
    camera.eye = from.eye;
    camera.target = from.target;
    view_->view().setPlanView(false);
    view_->view().setCamera(camera);
  });
}

void StageWindow::watchPerception() {
  perceiving_->setWatched(perception_->isVisible() || legend_->details().isChecked());
}

QList<QDockWidget*> StageWindow::docksBelow() const {
  QList<QDockWidget*> below;
  for (QDockWidget* dock : docks_) {
    if (dock != perceptionDock_ && !dock->isFloating() && dockWidgetArea(dock) == Qt::BottomDockWidgetArea)
      below << dock;
  }
  return below;
}

/// Pictures want room: while they are there they have the whole width of the bottom to themselves. It is made
/// before they come: pressed in between the others they would squeeze the docks at the sides.
void StageWindow::makeRoomForPerception() {
  if (!perceptionDock_ || perceptionDock_->isFloating()) return;  // it is being made, or takes no room
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  for (QDockWidget* dock : docksBelow()) dock->hide();
}

void StageWindow::showPerception(bool shown) {
  if (shown) {
    if (perceptionDock_->isFloating()) return;
    perceptionDock_->raise();
    resizeDocks({perceptionDock_}, {height() / 2}, Qt::Vertical);
    return;
  }
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  const QList<QDockWidget*> below = docksBelow();
  if (std::any_of(below.begin(), below.end(), [](QDockWidget* dock) { return !dock->isHidden(); })) return;
  for (QDockWidget* dock : below) dock->show();
}

/// It is long: it gets the room of the vertex dock, which nobody needs meanwhile.
void StageWindow::showVisibility() {
  visibilityDock_->show();
  visibilityDock_->raise();
  if (!visibilityDock_->isFloating() && vertexDock_->isVisible())
    resizeDocks({visibilityDock_, vertexDock_}, {80, 20}, Qt::Vertical);
}

void StageWindow::useDefaultLayout() {
  perceptionDock_->setFloating(false);
  perceptionDock_->hide();
  const struct {
    QDockWidget* dock;
    Qt::DockWidgetArea area;
  } places[] = {{componentsDock_, Qt::LeftDockWidgetArea}, {vertexDock_, Qt::LeftDockWidgetArea},
                {methodDock_, Qt::RightDockWidgetArea},    {measuresDock_, Qt::BottomDockWidgetArea},
                {contactsDock_, Qt::BottomDockWidgetArea}, {curveDock_, Qt::BottomDockWidgetArea},
                {visibilityDock_, Qt::LeftDockWidgetArea}};
  for (const auto& [dock, area] : places) {
    dock->setFloating(false);
    addDockWidget(area, dock);
    dock->show();
  }
  tabifyDockWidget(contactsDock_, curveDock_);
  contactsDock_->raise();
  tabifyDockWidget(componentsDock_, visibilityDock_);
  componentsDock_->raise();
  restoreState(saveState());  // else tab bars stay that have no dock any more
  const int digit = fontMetrics().averageCharWidth();
  resizeDocks({componentsDock_, methodDock_}, {digit * 50, digit * 40}, Qt::Horizontal);
  resizeDocks({componentsDock_, vertexDock_}, {55, 45}, Qt::Vertical);
  resizeDocks({measuresDock_, contactsDock_}, {46, 54}, Qt::Horizontal);
  resizeDocks({measuresDock_}, {fontMetrics().height() * 15}, Qt::Vertical);
}

void StageWindow::makeToolBar() {
  QToolBar* bar = addToolBar(tr("Simplification"));
  bar->setObjectName(QStringLiteral("stageToolBar"));
  bar->setMovable(false);
  bar->setIconSize(QSize(20, 20));
  bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  auto* group = new QActionGroup(this);
  const struct {
    StageLink::Show show;
    QString text, icon, help;
  } layouts[] = {
      {StageLink::Show::Original, tr("Original"), QStringLiteral("single"), tr("The original alone")},
      {StageLink::Show::Side, tr("Side by side"), QStringLiteral("side"),
       tr("Original and simplified beside each other, with one camera")},
      {StageLink::Show::Wipe, tr("Wipe"), QStringLiteral("wipe"),
       tr("Both over each other, with a line to drag between them; of two methods one against the other")}};
  std::size_t next = 0;
  for (const auto& [show, text, iconName, help] : layouts) {
    QAction* action = bar->addAction(icon(iconName), text);
    action->setCheckable(true);
    action->setChecked(show == link_->shown());
    action->setToolTip(help);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, show = show] { link_->show(show); });
    layouts_[next++] = action;
  }
  bar->addSeparator();
  connect(bar->addAction(icon(QStringLiteral("fit")), tr("Fit")), &QAction::triggered, this,
          [this] { view_->view().fit(); });
  QAction* plan = bar->addAction(icon(QStringLiteral("plan")), tr("Plan"));
  plan->setCheckable(true);
  connect(plan, &QAction::triggered, this, [this](bool on) { view_->view().setPlanView(on); });
  connect(&view_->view(), &SceneWidget::planViewChanged, plan, &QAction::setChecked);
  bar->addSeparator();
  QAction* visibility = bar->addAction(icon(QStringLiteral("eye")), tr("Visibility"));
  visibility->setObjectName(QStringLiteral("showVisibility"));
  visibility->setToolTip(tr("Which other buildings are seen past the original, and past what is made of it"));
  connect(visibility, &QAction::triggered, this, &StageWindow::showVisibility);
  QAction* perception = bar->addAction(icon(QStringLiteral("picture")), tr("Perception"));
  perception->setObjectName(QStringLiteral("showPerception"));
  perception->setCheckable(true);
  perception->setToolTip(tr("Which details would nobody miss: pictures as the eye sees them"));
  connect(perception, &QAction::triggered, perceptionDock_, &QWidget::setVisible);
  connect(perceptionDock_->toggleViewAction(), &QAction::toggled, perception, &QAction::setChecked);
}

void StageWindow::setTheme(SceneTheme theme) {
  link_->setTheme(theme);
  visibility_->setTheme(theme);
}

QImage StageWindow::picture() {
  QImage image = grab().toImage();
  QPainter painter(&image);
  painter.drawImage(QRect(view_->mapTo(this, QPoint()), view_->size()), view_->picture());
  return image;
}

}  // namespace lodestone
