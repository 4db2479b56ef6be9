#include "gui/window/main_window.h"

#include <QAction>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMenu>
#include <QPainter>
#include <QScreen>
#include <QScrollArea>
#include <QSettings>
#include <QStackedWidget>
#include <QStandardPaths>
#include <QStyle>

#include "gui/city/chain_panel.h"
#include "gui/city/dendrogram_view.h"
#include "gui/city/layers_panel.h"
#include "gui/city/messages_panel.h"
#include "gui/city/method_panel.h"
#include "gui/city/objects_panel.h"
#include "gui/city/scene_link.h"
#include "gui/city/selection_panel.h"
#include "gui/city/viewport.h"
#include "gui/window/stage_window.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/mnemonics.h"
#include "gui/window/start_page.h"
#include "gui/window/status_bar.h"
#include "gui/workspace/autosave.h"

/// Resources of a static library stay out unless they are asked for. Qt's macro must stand outside of
/// namespaces.
static void initResources() {
  Q_INIT_RESOURCE(lodestone);
}

namespace lodestone {
namespace {

constexpr int kMostRecent = 10;
constexpr QSize kUsualSize(1440, 900);
constexpr QSize kLeastSize(960, 600);

QString recentKey() {
  return QStringLiteral("recent");
}

}  // namespace

MainWindow::MainWindow(QWidget* parent) : QMainWindow(parent) {
  initResources();
  setObjectName(QStringLiteral("mainWindow"));
  setWindowIcon(QIcon(QStringLiteral(":/icons/lodestone.svg")));
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::RightDockWidgetArea);
  makeCentre();
  status_ = new StatusBar(workspace_, this);
  setStatusBar(status_);
  makeDocks();
  makeActions();
  connectStage();
  connectAll();  // before the link: the view must have its size when a new city is fitted to it
  link_ = new SceneLink(workspace_, *viewport_, *layers_, this);
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  autosave_ = std::make_unique<Autosave>(
      folder, [this] { return workspace_.session().modified() && workspace_.state().city; },
      [this](const QString& path) { return workspace_.saveProject(path, layoutText()); });
  takeRoomOnScreen();
  restoreSettings();
  applyTheme();
  showState();
}

/// The minimum is said here once: with one that follows from what is shown, the window would grow while the
/// docks of the city and those of the stage change places, and stay so.
void MainWindow::takeRoomOnScreen() {
  const QSize frame(0, style()->pixelMetric(QStyle::PM_TitleBarHeight));
  const QSize room = screen()->availableSize() - frame;
  setMinimumSize(kLeastSize.boundedTo(room));
  resize(kUsualSize.boundedTo(room));
}

MainWindow::~MainWindow() {
  workspace_.tasks().cancelAll();
  disconnect(&workspace_, nullptr, this, nullptr);
  // What looks at the workspace goes before it does; Qt alone would let children outlive all members.
  delete link_;
  qDeleteAll(docks_);
  delete takeCentralWidget();
  delete status_;
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, const QString& iconName,
                                 QWidget* panel, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title, this);
  dock->setObjectName(name);
  dock->setWidget(panel);
  dock->toggleViewAction()->setIcon(icon(iconName));
  addDockWidget(area, dock);
  docks_ << dock;
  return dock;
}

void MainWindow::makeDocks() {
  layers_ = new LayersPanel(workspace_, this);
  objects_ = new ObjectsPanel(workspace_, this);
  method_ = new MethodPanel(workspace_, this);
  dendrogram_ = new DendrogramView(workspace_, this);
  chain_ = new ChainPanel(workspace_, this);
  messages_ = new MessagesPanel(workspace_, this);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll->setWidget(method_);
  scroll->setMinimumWidth(method_->minimumSizeHint().width() + fontMetrics().averageCharWidth() * 3);
  addDock(QStringLiteral("layersDock"), tr("Layers"), QStringLiteral("layers"), layers_,
          Qt::LeftDockWidgetArea);
  addDock(QStringLiteral("objectsDock"), tr("Objects"), QStringLiteral("objects"), objects_,
          Qt::LeftDockWidgetArea);
  addDock(QStringLiteral("methodDock"), tr("Method"), QStringLiteral("method"), scroll,
          Qt::RightDockWidgetArea);
  addDock(QStringLiteral("selectionDock"), tr("Selection"), QStringLiteral("selection"),
          new SelectionPanel(workspace_, this), Qt::RightDockWidgetArea);
  addDock(QStringLiteral("dendrogramDock"), tr("Dendrogram"), QStringLiteral("dendrogram"), dendrogram_,
          Qt::BottomDockWidgetArea);
  addDock(QStringLiteral("chainDock"), tr("LOD chain"), QStringLiteral("chain"), chain_,
          Qt::BottomDockWidgetArea);
  addDock(QStringLiteral("messagesDock"), tr("Messages"), QStringLiteral("messages"), messages_,
          Qt::BottomDockWidgetArea);
}

void MainWindow::useDefaultLayout() {
  const Qt::DockWidgetArea areas[] = {
      Qt::LeftDockWidgetArea,   Qt::LeftDockWidgetArea,   Qt::RightDockWidgetArea, Qt::RightDockWidgetArea,
      Qt::BottomDockWidgetArea, Qt::BottomDockWidgetArea, Qt::BottomDockWidgetArea};
  stage_->useDefaultLayout();
  if (showsStage_) return cityDocks_.clear();
  for (qsizetype i = 0; i < docks_.size(); ++i) {
    docks_[i]->setFloating(false);
    addDockWidget(areas[i], docks_[i]);
    docks_[i]->show();
  }
  tabifyDockWidget(docks_[4], docks_[5]);
  tabifyDockWidget(docks_[5], docks_[6]);
  docks_[4]->raise();
  restoreState(saveState());  // else tab bars stay that have no dock any more
  const int digit = fontMetrics().averageCharWidth();
  resizeDocks({docks_[0], docks_[2]}, {digit * 47, digit * 42}, Qt::Horizontal);
  resizeDocks({docks_[0], docks_[1]}, {30, 46}, Qt::Vertical);
  resizeDocks({docks_[2], docks_[3]}, {76, 24}, Qt::Vertical);
  resizeDocks({docks_[4]}, {fontMetrics().height() * 16}, Qt::Vertical);
}

void MainWindow::connectAll() {
  connect(&workspace_, &Workspace::stateChanged, this, &MainWindow::showState);
  connect(&workspace_, &Workspace::imported, this, [this] {
    QStringList sources;
    for (const std::string& path : workspace_.state().sources) sources << QString::fromStdString(path);
    addRecent(workspace_.projectPath().isEmpty() ? sources : QStringList{workspace_.projectPath()});
  });
  connect(&workspace_, &Workspace::projectOpened, this, [this](const QString& path, const QString& layout) {
    restoreLayout(layout);
    viewport_->setCamera(workspace_.state().camera);
    workspace_.setCamera(viewport_->camera());
    if (!workspace_.projectPath().isEmpty()) {
      addRecent({path});
      return;
    }
    // Recovered work is kept by this run from here on.
    if (autosave_->saveNow()) Autosave::discard(path);
  });
  connect(&workspace_, &Workspace::exported, this, &MainWindow::showExported);
  connect(messages_, &MessagesPanel::errorAdded, this, [this] {
    QDockWidget* dock = docks_.back();
    dock->show();
    dock->raise();
  });
  connect(messages_, &MessagesPanel::troublesCounted, this, [this](std::size_t count) {
    docks_.back()->setWindowTitle(count == 0 ? tr("Messages") : tr("Messages (%L1)").arg(count));
  });
  connect(start_, &StartPage::openRequested, this, &MainWindow::openDialog);
  connect(start_, &StartPage::sampleRequested, &workspace_, &Workspace::openSample);
  connect(start_, &StartPage::recentChosen, this, [this](const QString& path) { openFiles({path}); });
  connect(chain_, &ChainPanel::exportRequested, this, &MainWindow::exportDialog);
  connect(viewport_, &Viewport::pointedAt, status_, &StatusBar::showPoint);
  connect(viewport_, &Viewport::frameRendered, status_, &StatusBar::showFrame);
  connect(viewport_, &Viewport::planViewChanged, plan_, &QAction::setChecked);
  connect(&workspace_, &Workspace::cutChanged, this,
          [this] { freeze_->setChecked(workspace_.cameraFrozen()); });
}

void MainWindow::showState() {
  const ProjectState& state = workspace_.state();
  const bool open = state.city != nullptr;
  if (open) viewport_->setGeometry(stack_->contentsRect());
  QWidget* middle = start_;
  if (open) middle = showsStage_ ? static_cast<QWidget*>(stage_) : viewport_;
  stack_->setCurrentWidget(middle);
  for (QAction* action : {save_, saveAs_, close_, export_, picture_, fit_}) action->setEnabled(open);
  for (QAction* action : {plan_, fly_}) action->setEnabled(open && !showsStage_);
  meshSettings_->setEnabled(hasMeshes());
  showSimplifyAction();
  cluster_->setEnabled(workspace_.canCluster());
  freeze_->setEnabled(state.tree != nullptr);
  const Session& session = workspace_.session();
  undo_->setEnabled(session.canUndo());
  redo_->setEnabled(session.canRedo());
  undo_->setText(session.canUndo()
                     ? tr("&Undo %1").arg(withoutMnemonic(QString::fromStdString(session.undoText())))
                     : tr("&Undo"));
  redo_->setText(session.canRedo()
                     ? tr("&Redo %1").arg(withoutMnemonic(QString::fromStdString(session.redoText())))
                     : tr("&Redo"));
  QString title = QStringLiteral("Lodestone");
  if (!workspace_.projectPath().isEmpty()) {
    title = QStringLiteral("%1[*] – Lodestone").arg(QFileInfo(workspace_.projectPath()).completeBaseName());
  } else if (!state.sources.empty()) {
    title = QStringLiteral("%1[*] – Lodestone")
                .arg(QFileInfo(QString::fromStdString(state.sources.front())).fileName());
  }
  setWindowTitle(title);
  setWindowModified(open && session.modified());
}

void MainWindow::applyTheme() {
  const SceneTheme theme = isDark(palette()) ? SceneTheme::Dark : SceneTheme::Light;
  viewport_->scene().setTheme(theme);
  stage_->setTheme(theme);
  viewport_->requestRender();
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange && viewport_) applyTheme();
  QMainWindow::changeEvent(event);
}

void MainWindow::addRecent(const QStringList& paths) {
  QSettings settings;
  QStringList recent = settings.value(recentKey()).toStringList();
  for (const QString& path : paths.mid(0, 3)) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    recent.removeAll(absolute);
    recent.prepend(absolute);
  }
  settings.setValue(recentKey(), QStringList(recent.mid(0, kMostRecent)));
  start_->setRecent(settings.value(recentKey()).toStringList());
}

QString MainWindow::layoutText() const {
  QJsonObject layout;
  layout[QStringLiteral("docks")] =
      QString::fromLatin1((showsStage_ ? cityDocks_ : saveState(kLayoutVersion)).toBase64());
  layout[QStringLiteral("plan")] = viewport_->planView();
  return QString::fromUtf8(QJsonDocument(layout).toJson(QJsonDocument::Compact));
}

void MainWindow::restoreLayout(const QString& text) {
  const QJsonObject layout = QJsonDocument::fromJson(text.toUtf8()).object();
  const QByteArray docks = QByteArray::fromBase64(layout[QStringLiteral("docks")].toString().toLatin1());
  if (!docks.isEmpty() && showsStage_) cityDocks_ = docks;
  if (!docks.isEmpty() && !showsStage_) restoreState(docks, kLayoutVersion);
  viewport_->setPlanView(layout[QStringLiteral("plan")].toBool());
}

void MainWindow::restoreSettings() {
  const QSettings settings;
  useDefaultLayout();
  restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray());
  restoreState(settings.value(QStringLiteral("docks")).toByteArray(), kLayoutVersion);
  stage_->restoreState(settings.value(QStringLiteral("stageDocks")).toByteArray(), kLayoutVersion);
  QStringList recent;
  for (const QString& path : settings.value(recentKey()).toStringList()) {
    if (QFileInfo::exists(path)) recent << path;
  }
  start_->setRecent(recent);
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("docks"), showsStage_ ? cityDocks_ : saveState(kLayoutVersion));
  settings.setValue(QStringLiteral("stageDocks"), stage_->saveState(kLayoutVersion));
  autosave_->forget();
  workspace_.tasks().cancelAll();
  event->accept();
}

QImage MainWindow::picture() {
  QImage image = grab().toImage();
  QWidget* middle = stack_->currentWidget();
  if (middle == start_) return image;
  QPainter painter(&image);  // an OpenGL surface does not always come along
  painter.drawImage(QRect(middle->mapTo(this, QPoint()), middle->size()),
                    middle == stage_ ? stage_->picture() : viewport_->picture());
  return image;
}

}  // namespace lodestone
