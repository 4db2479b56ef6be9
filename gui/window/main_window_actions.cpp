// Menus, tool bar, and what their actions do.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QSettings>
#include <QToolBar>
#include <QWhatsThis>

#include "gui/city/method_panel.h"
#include "gui/city/viewport.h"
#include "gui/simplification/stage_view.h"
#include "gui/window/stage_window.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/mnemonics.h"
#include "gui/window/main_window.h"

#include "version.h"

namespace lodestone {
QAction* MainWindow::add(QMenu* menu, const QString& text, const QString& iconName, const QKeySequence& keys,
                         std::function<void()> run) {
  QAction* action = menu->addAction(text);
  if (!iconName.isEmpty()) action->setIcon(icon(iconName));
  if (!keys.isEmpty()) action->setShortcut(keys);
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  return action;
}

void MainWindow::makeActions() {
  makeFileMenu();
  makeEditMenu();
  makeViewMenu();
  makeMethodMenu();
  makeHelpMenu();
  makeToolBar();
}

void MainWindow::makeFileMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&File"));
  open_ = add(menu, tr("&Open…"), QStringLiteral("open"), QKeySequence::Open, [this] { openDialog(); });
  recentMenu_ = menu->addMenu(tr("Open &recent"));
  connect(recentMenu_, &QMenu::aboutToShow, this, [this] {
    recentMenu_->clear();
    for (const QString& path : QSettings().value(QStringLiteral("recent")).toStringList()) {
      add(recentMenu_, withoutMnemonic(QDir::toNativeSeparators(path)), {}, {},
          [this, path] { openFiles({path}); });
    }
    if (recentMenu_->isEmpty()) recentMenu_->addAction(tr("Nothing yet"))->setEnabled(false);
  });
  add(menu, tr("Open sample &town"), QStringLiteral("sample"), {}, [this] { workspace_.openSample(); });
  meshSettings_ = add(menu, tr("&Unit and up axis…"), {}, {}, [this] { askForMeshSettings(); });
  meshSettings_->setObjectName(QStringLiteral("meshSettings"));
  menu->addSeparator();
  save_ = add(menu, tr("&Save project"), QStringLiteral("save"), QKeySequence::Save, [this] { save(); });
  saveAs_ = add(menu, tr("Save project &as…"), {}, QKeySequence::SaveAs, [this] { saveAs(); });
  close_ = add(menu, tr("&Close"), {}, QKeySequence::Close, [this] { closeModel(); });
  menu->addSeparator();
  export_ = add(menu, tr("&Export…"), QStringLiteral("export"), QKeySequence(tr("Ctrl+E")),
                [this] { showsStage_ ? exportSimplified() : exportDialog(); });
  picture_ = add(menu, tr("Save &picture…"), QStringLiteral("picture"), QKeySequence(tr("Ctrl+Shift+P")),
                 [this] { savePicture(); });
  menu->addSeparator();
  add(menu, tr("&Quit"), {}, QKeySequence::Quit, [this] { close(); })->setMenuRole(QAction::QuitRole);
}

void MainWindow::makeEditMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Edit"));
  undo_ = add(menu, tr("&Undo"), QStringLiteral("undo"), QKeySequence::Undo,
              [this] { workspace_.session().undo(); });
  redo_ = add(menu, tr("&Redo"), QStringLiteral("redo"), QKeySequence::Redo,
              [this] { workspace_.session().redo(); });
  menu->addSeparator();
  add(menu, tr("&Deselect"), {}, QKeySequence::Deselect, [this] { workspace_.select({}); });
}

void MainWindow::makeViewMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&View"));
  fit_ = add(menu, tr("&Fit"), QStringLiteral("fit"), QKeySequence(tr("Ctrl+0")),
             [this] { showsStage_ ? stage_->view().view().fit() : viewport_->fit(); });
  fly_ = add(menu, tr("Fly to &selection"), QStringLiteral("fly"), QKeySequence(tr("Ctrl+J")), [this] {
    if (!workspace_.selection().empty()) workspace_.flyTo(workspace_.selection().front());
  });
  plan_ = add(menu, tr("&Plan view"), QStringLiteral("plan"), QKeySequence(tr("Ctrl+P")),
              [this] { viewport_->setPlanView(plan_->isChecked()); });
  plan_->setCheckable(true);
  menu->addSeparator();
  makeAppearanceMenu(*menu->addMenu(tr("&Appearance")));
  QMenu* docks = menu->addMenu(tr("&Docks"));
  int number = 1;
  for (QDockWidget* dock : docks_) {
    dock->toggleViewAction()->setShortcut(QKeySequence(QStringLiteral("Alt+%1").arg(number++)));
    docks->addAction(dock->toggleViewAction());
  }
  docks->addSection(tr("Simplification"));
  for (QDockWidget* dock : stage_->docks()) docks->addAction(dock->toggleViewAction());
  add(menu, tr("&Reset layout"), {}, {}, [this] { useDefaultLayout(); });
  menu->addSeparator();
  QAction* full = add(menu, tr("F&ull screen"), {}, QKeySequence::FullScreen,
                      [this] { setWindowState(windowState() ^ Qt::WindowFullScreen); });
  full->setCheckable(true);
}

void MainWindow::makeAppearanceMenu(QMenu& menu) {
  auto* group = new QActionGroup(&menu);
  const int chosen = QSettings().value(QStringLiteral("appearance"), 0).toInt();
  const QString titles[] = {tr("As the &desktop"), tr("&Light"), tr("&Dark")};
  for (int i = 0; i < 3; ++i) {
    QAction* action = menu.addAction(titles[i]);
    action->setCheckable(true);
    action->setChecked(i == chosen);
    group->addAction(action);
    connect(action, &QAction::triggered, this, [i] {
      QSettings().setValue(QStringLiteral("appearance"), i);
      QApplication::setPalette(paletteOf(static_cast<Appearance>(i)));
    });
  }
}

void MainWindow::makeMethodMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Method"));
  cluster_ = add(menu, tr("&Cluster"), QStringLiteral("cluster"), QKeySequence(tr("Ctrl+R")),
                 [this] { workspace_.cluster(); });
  simplify_ = add(menu, tr("&Simplify building"), QStringLiteral("simplify"), QKeySequence(tr("Ctrl+B")),
                  [this] { simplifyBuilding(buildingToSimplify()); });
  simplify_->setObjectName(QStringLiteral("simplifyBuilding"));
  simplify_->setToolTip(
      tr("Look at the parts of the selected building, and remove triangles such that they still touch"));
  freeze_ = add(menu, tr("&Freeze LOD camera"), QStringLiteral("freeze"), QKeySequence(tr("Ctrl+L")),
                [this] { workspace_.chooseByCamera(freeze_->isChecked()); });
  freeze_->setCheckable(true);
  freeze_->setToolTip(
      tr("Choose by ε and α what this camera sees now, keep it, and look at it from elsewhere"));
}

void MainWindow::makeHelpMenu() {
  QMenu* menu = menuBar()->addMenu(tr("&Help"));
  QAction* whatsThis = QWhatsThis::createAction(this);
  whatsThis->setIcon(icon(QStringLiteral("help")));
  menu->addAction(whatsThis);
  add(menu, tr("&About Lodestone"), QStringLiteral("info"), {}, [this] {
    showAbout();
  })->setMenuRole(QAction::AboutRole);
}

void MainWindow::makeToolBar() {
  QToolBar* bar = addToolBar(tr("Main"));
  bar->setObjectName(QStringLiteral("mainToolBar"));
  bar->setIconSize(QSize(22, 22));
  bar->setMovable(false);
  bar->addActions({open_, save_, export_});
  bar->addSeparator();
  bar->addActions({undo_, redo_});
  bar->addSeparator();
  bar->addActions({cluster_, freeze_, simplify_});
  bar->addSeparator();
  bar->addActions({fit_, plan_, fly_});
  bar->setToolButtonStyle(Qt::ToolButtonIconOnly);
}

void MainWindow::showAbout() {
  QMessageBox::about(this, tr("About Lodestone"),
                     tr("<h3>Lodestone %1</h3><p>Chains of levels of detail for 3D city "
                        "models.</p><p>Legible simplification after "
                        "Chang et al. 2008.</p><p>%2</p><p>GPL-3.0-or-later</p>")
                         .arg(QStringLiteral(LODESTONE_VERSION), viewport_->graphicsInfo().toHtmlEscaped()));
}

}  // namespace lodestone
