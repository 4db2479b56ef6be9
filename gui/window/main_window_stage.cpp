// The stage of one building within the window: its tab, and the ways there.
#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QSettings>
#include <QStackedWidget>
#include <QTabBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "gui/city/objects_panel.h"
#include "gui/city/viewport.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/window/stage_window.h"
#include "gui/widgets/icons.h"
#include "gui/window/main_window.h"
#include "gui/window/start_page.h"
#include "gui/window/status_bar.h"

namespace lodestone {
namespace {

constexpr int kCityTab = 0;
constexpr int kStageTab = 1;
constexpr int kMessageMs = 8000;

}  // namespace

void MainWindow::makeCentre() {
  auto* centre = new QWidget(this);
  tabs_ = new QTabBar(centre);
  tabs_->setObjectName(QStringLiteral("centreTabs"));
  tabs_->setDocumentMode(true);
  tabs_->setDrawBase(false);
  tabs_->setExpanding(false);
  tabs_->hide();
  stack_ = new QStackedWidget(centre);
  start_ = new StartPage(stack_);
  viewport_ = new Viewport(stack_);
  stage_ = new StageWindow(workspace_, stack_);
  // It takes what room there is: hidden, it must not press upon the city's docks.
  stage_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
  for (QWidget* page :
       {static_cast<QWidget*>(start_), static_cast<QWidget*>(viewport_), static_cast<QWidget*>(stage_)})
    stack_->addWidget(page);
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(tabs_);
  layout->addWidget(stack_, 1);
  setCentralWidget(centre);
}

void MainWindow::connectStage() {
  objects_->addTableAction(simplify_);
  connect(viewport_, &SceneWidget::menuRequested, this, &MainWindow::showViewMenu);
  connect(&workspace_, &Workspace::selectionChanged, this, &MainWindow::showSimplifyAction);
  connect(&workspace_, &Workspace::imported, this, [this] {
    // There is nothing to group: what can be done is to look at its parts.
    if (workspace_.state().city->buildings.size() == 1) simplifyBuilding(0);
  });
  connect(tabs_, &QTabBar::currentChanged, this, [this](int tab) { showStage(tab == kStageTab); });
  Stage& stage = stage_->stage();
  connect(&stage, &Stage::closed, this, [this] { showStage(false); });
  connect(&stage, &Stage::opened, this,
          [this, &stage] { tabs_->setTabText(kStageTab, tr("Simplification: %1").arg(stage.title())); });
  connect(stage_, &StageWindow::exportRequested, this, &MainWindow::exportSimplified);
}

NodeId MainWindow::buildingToSimplify() const {
  const auto& city = workspace_.state().city;
  if (!city) return kNoNode;
  if (city->buildings.size() == 1) return 0;
  const auto& selected = workspace_.selection();
  return !selected.empty() && selected.front() < city->buildings.size() ? selected.front() : kNoNode;
}

void MainWindow::showSimplifyAction() {
  simplify_->setEnabled(workspace_.state().city != nullptr);
}

void MainWindow::showViewMenu(const QPoint& at) {
  QMenu menu(this);
  menu.addActions({simplify_, fly_, fit_});
  menu.exec(at);
}

void MainWindow::simplifyBuilding(NodeId building) {
  if (building == kNoNode)
    return status_->showMessage(tr("Select a building first: click it in the view, or its row in Objects."),
                                kMessageMs);
  status_->clearMessage();
  Stage& stage = stage_->stage();
  if (stage.building() != building) stage.open(building);
  const QSignalBlocker quiet(tabs_);
  if (tabs_->count() == 0) {
    tabs_->addTab(icon(QStringLiteral("perspective")), tr("City"));
    tabs_->addTab(icon(QStringLiteral("simplify")), {});
    auto* close = new QToolButton(tabs_);
    close->setIcon(icon(QStringLiteral("cancel")));
    close->setAutoRaise(true);
    close->setToolTip(tr("Close"));
    tabs_->setTabButton(kStageTab, QTabBar::RightSide, close);
    connect(close, &QToolButton::clicked, &stage, &Stage::close);
  }
  tabs_->setTabText(kStageTab, tr("Simplification: %1").arg(stage.title()));
  showStage(true);
}

void MainWindow::showStage(bool show) {
  const QSignalBlocker quiet(tabs_);
  const bool staged = stage_->stage().building() != kNoNode;
  while (!staged && tabs_->count() > 0) tabs_->removeTab(tabs_->count() - 1);
  tabs_->setVisible(staged);
  tabs_->setCurrentIndex(show ? kStageTab : kCityTab);
  if (show != showsStage_) show ? changeToStage() : changeToCity();
  showState();
}

/// The docks of the city go before the stage comes, and come after it has gone: squeezed in between, what is
/// around the stage would stay narrow.
void MainWindow::changeToStage() {
  cityDocks_ = saveState(kLayoutVersion);
  showsStage_ = true;
  status_->setCityShown(false);
  for (QDockWidget* dock : docks_) dock->hide();
  layout()->activate();
}

void MainWindow::changeToCity() {
  showsStage_ = false;
  status_->setCityShown(true);
  showState();
  for (QDockWidget* dock : docks_) dock->show();
  cityDocks_.isEmpty() ? useDefaultLayout() : static_cast<void>(restoreState(cityDocks_, kLayoutVersion));
}

void MainWindow::exportSimplified() {
  const Stage& stage = stage_->stage();
  const std::function<LodChain()> a = stage.simplified(Stage::A);
  const std::function<LodChain()> b = stage.simplified(Stage::B);
  if (!a) return;
  ExportDialog dialog(workspace_, stage, this);
  if (dialog.exec() != QDialog::Accepted) return;
  const ExportRequest request = dialog.request();
  QSettings().setValue(QStringLiteral("exportFolder"), QString::fromStdString(request.folder.string()));
  workspace_.exportBuildings(request, dialog.method() == Stage::B ? b : a);
}

}  // namespace lodestone
