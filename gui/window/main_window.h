// The window: start page, 3D view or the stage of one building in the middle, docks around it.
#pragma once

#include <QMainWindow>
#include <memory>

#include "gui/workspace/workspace.h"

class QAction;
class QDockWidget;
class QMenu;
class QStackedWidget;
class QTabBar;

namespace lodestone {

class Autosave;
class ChainPanel;
class DendrogramView;
class LayersPanel;
class MessagesPanel;
class MethodPanel;
class ObjectsPanel;
class SceneLink;
class StageWindow;
class StartPage;
class StatusBar;
class Viewport;

class MainWindow : public QMainWindow {
  Q_OBJECT

 public:
  explicit MainWindow(QWidget* parent = nullptr);
  ~MainWindow() override;

  [[nodiscard]] Workspace& workspace() { return workspace_; }
  [[nodiscard]] Viewport& viewport() { return *viewport_; }
  [[nodiscard]] DendrogramView& dendrogram() { return *dendrogram_; }
  [[nodiscard]] ObjectsPanel& objects() { return *objects_; }
  [[nodiscard]] MethodPanel& method() { return *method_; }
  [[nodiscard]] MessagesPanel& messages() { return *messages_; }
  [[nodiscard]] LayersPanel& layers() { return *layers_; }
  [[nodiscard]] StageWindow& stage() { return *stage_; }
  /// Whether the Simplification view is in the middle.
  [[nodiscard]] bool showsStage() const { return showsStage_; }

  /// Opens the Simplification view for a building and those that touch it; says what to do where there is
  /// none.
  void simplifyBuilding(NodeId building);

  /// Opens projects and city models; asks what the files do not say, and whether they join a model that is
  /// open: they do, in its project, or a new one takes its place when nothing is lost. Lines on top of an
  /// open model become barriers. Where it may not ask, the files are opened instead, with default options. A
  /// folder stands for the files in it that can be read.
  void openFiles(const QStringList& paths, bool mayAsk = true);
  /// The whole window as it looks, the 3D view included.
  [[nodiscard]] QImage picture();
  /// Offers back the work of a program that crashed.
  void offerLeftWork();
  void useDefaultLayout();

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void takeRoomOnScreen();
  void makeCentre();
  void makeDocks();
  QDockWidget* addDock(const QString& name, const QString& title, const QString& iconName, QWidget* panel,
                       Qt::DockWidgetArea area);
  void makeActions();
  void makeFileMenu();
  void makeEditMenu();
  void makeViewMenu();
  void makeMethodMenu();
  void makeHelpMenu();
  void makeToolBar();
  void makeAppearanceMenu(QMenu& menu);
  void connectAll();
  void connectStage();
  QAction* add(QMenu* menu, const QString& text, const QString& iconName, const QKeySequence& keys,
               std::function<void()> run);

  /// The paths with the files of folders in their place; nothing where a person gives up, or where there is
  /// nothing to read, which is said.
  [[nodiscard]] QStringList withoutFolders(const QStringList& paths, bool mayAsk);
  enum class Opening { Added, Instead, NotAtAll };
  /// What files opened over a model are to be to it.
  [[nodiscard]] Opening askHowToOpen(const QStringList& paths);
  void refuseToAdd(const QStringList& paths, const QStringList& changed);
  /// Which axis of the open meshes is up, and their unit.
  void askForMeshSettings();
  [[nodiscard]] bool hasMeshes() const;
  void openDialog();
  bool save();
  bool saveAs();
  bool saveTo(const QString& path);
  [[nodiscard]] bool mayDiscard();
  void exportDialog();
  void exportSimplified();
  void showExported(const QStringList& files);
  void savePicture();
  void closeModel();
  void showAbout();

  void showStage(bool show);
  void changeToStage();
  void changeToCity();
  /// The building that "Simplify building" means, or kNoNode.
  [[nodiscard]] NodeId buildingToSimplify() const;
  void showSimplifyAction();
  void showViewMenu(const QPoint& at);
  void showState();
  void applyTheme();
  void addRecent(const QStringList& paths);
  [[nodiscard]] QString layoutText() const;
  void restoreLayout(const QString& text);
  void restoreSettings();

  static constexpr int kLayoutVersion = 1;
  Workspace workspace_;
  QTabBar* tabs_ = nullptr;
  QStackedWidget* stack_ = nullptr;
  StartPage* start_ = nullptr;
  Viewport* viewport_ = nullptr;
  StageWindow* stage_ = nullptr;
  bool showsStage_ = false;
  QByteArray cityDocks_;  ///< while the stage is shown, which has docks of its own
  LayersPanel* layers_ = nullptr;
  ObjectsPanel* objects_ = nullptr;
  MethodPanel* method_ = nullptr;
  DendrogramView* dendrogram_ = nullptr;
  ChainPanel* chain_ = nullptr;
  MessagesPanel* messages_ = nullptr;
  StatusBar* status_ = nullptr;
  SceneLink* link_ = nullptr;
  std::unique_ptr<Autosave> autosave_;
  QList<QDockWidget*> docks_;
  QMenu* recentMenu_ = nullptr;
  QAction* open_ = nullptr;
  QAction* meshSettings_ = nullptr;
  QAction* save_ = nullptr;
  QAction* saveAs_ = nullptr;
  QAction* close_ = nullptr;
  QAction* export_ = nullptr;
  QAction* picture_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* cluster_ = nullptr;
  QAction* simplify_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* plan_ = nullptr;
  QAction* freeze_ = nullptr;
  QAction* fly_ = nullptr;
};

}  // namespace lodestone
