// What the window opens, saves and exports, and what it asks before.
#include <QDesktopServices>
#include <QDialogButtonBox>
#include <QDir>
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QMessageBox>
#include <QMimeData>
#include <QPushButton>
#include <QSettings>
#include <QTimer>
#include <QUrl>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/city/chain_panel.h"
#include "gui/city/viewport.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/dialogs/folder_dialog.h"
#include "gui/dialogs/import_dialog.h"
#include "gui/dialogs/mesh_dialog.h"
#include "gui/simplification/stage_view.h"
#include "gui/window/stage_window.h"
#include "gui/window/main_window.h"
#include "gui/workspace/autosave.h"
#include "model/io/footprints/footprints.h"
#include "model/io/format.h"

namespace lodestone {
namespace {

/// File dialog filter of all that can be read.
QString readFilter() {
  QStringList all{QStringLiteral("*.lodestone")};
  QStringList each;
  for (const Format& format : formats()) {
    if (!format.read) continue;
    QStringList endings;
    for (const std::string_view ending : format.extensions) {
      endings << QStringLiteral("*") +
                     QString::fromUtf8(ending.data(), static_cast<qsizetype>(ending.size()));
    }
    all << endings;
    each << QStringLiteral("%1 (%2)").arg(
        QString::fromUtf8(format.title.data(), static_cast<qsizetype>(format.title.size()))
            .replace(QLatin1Char('('), QLatin1Char('['))
            .replace(QLatin1Char(')'), QLatin1Char(']')),
        endings.join(QLatin1Char(' ')));
  }
  all.removeDuplicates();
  const QString everything = MainWindow::tr("City models and projects (%1)").arg(all.join(QLatin1Char(' ')));
  return (QStringList{everything} + each + QStringList{MainWindow::tr("All files (*)")})
      .join(QStringLiteral(";;"));
}

/// ".gml, .city.json, …": the usual ending of each format.
QString usualEndings() {
  QStringList endings;
  for (const Format& format : formats()) {
    const std::string_view usual = format.extensions.front();
    if (format.read) endings << QString::fromUtf8(usual.data(), static_cast<qsizetype>(usual.size()));
  }
  return endings.join(QStringLiteral(", "));
}

bool isProject(const QString& path) {
  return path.endsWith(QStringLiteral(".lodestone"), Qt::CaseInsensitive);
}

/// A file of lines alone, such as streets.
bool holdsOnlyLines(const VectorPreview& preview) {
  bool lines = false;
  for (const LayerPreview& layer : preview.layers) {
    if (layer.hasPolygons) return false;
    lines = lines || layer.hasLines;
  }
  return lines;
}

/// Where heights come from: "H_MAX", "9 m", "floors × 3 m".
QString heightsOf(const ImportOptions& options) {
  const QString field = QString::fromStdString(options.height);
  bool isNumber = false;
  field.toDouble(&isNumber);
  if (!field.isEmpty()) return isNumber ? MainWindow::tr("%1 m").arg(field) : field;
  if (!options.floors.empty())
    return MainWindow::tr("%1 × %2 m").arg(QString::fromStdString(options.floors)).arg(options.floorHeight);
  return MainWindow::tr("the usual fields, else %1 m").arg(options.defaultHeight);
}

QString orSaid(const std::string& text) {
  return text.empty() ? MainWindow::tr("what the files say") : QString::fromStdString(text);
}

QString meshSettingsOf(const ImportOptions& options) {
  const QString axis = options.upAxis == UpAxisOption::Y   ? MainWindow::tr("y is up")
                       : options.upAxis == UpAxisOption::Z ? MainWindow::tr("z is up")
                                                           : MainWindow::tr("the usual axis is up");
  return MainWindow::tr("%1 m, %2").arg(QLocale().toString(options.unit), axis);
}

QStringList meshesOf(const ProjectState& state) {
  QStringList paths;
  if (!state.city) return paths;
  for (const Source& source : state.city->sources) {
    if (isMeshFormat(formatById(source.format))) paths << QString::fromStdString(source.path);
  }
  return paths;
}

/// What the open files would be read with otherwise than before, were others added with these options: the
/// files of a model share them. One line each: what, as the model has it, as it was chosen.
QStringList changedFor(const ProjectState& state, const ImportOptions& options) {
  const ImportOptions& before = state.importOptions;
  const bool footprints =
      std::any_of(state.city->sources.begin(), state.city->sources.end(),
                  [](const Source& source) { return source.format == footprintFormat().id; });
  const bool sameCrs =
      options.crs == before.crs || options.crs == "EPSG:" + std::to_string(state.city->crs.epsg);
  QStringList changed;
  const auto add = [&changed](const QString& what, const QString& model, const QString& chosen) {
    changed << MainWindow::tr("%1: %2 in the model, %3 chosen").arg(what, model, chosen);
  };
  if (!sameCrs) add(MainWindow::tr("coordinate system"), orSaid(before.crs), orSaid(options.crs));
  if (!meshesOf(state).isEmpty() && (options.unit != before.unit || options.upAxis != before.upAxis))
    add(MainWindow::tr("unit and up axis of meshes"), meshSettingsOf(before), meshSettingsOf(options));
  if (!footprints) return changed;  // the others say themselves how high they are
  if (options.layer != before.layer)
    add(MainWindow::tr("layer"), orSaid(before.layer), orSaid(options.layer));
  if (options.height != before.height || options.floors != before.floors ||
      options.floorHeight != before.floorHeight || options.defaultHeight != before.defaultHeight)
    add(MainWindow::tr("heights"), heightsOf(before), heightsOf(options));
  return changed;
}

}  // namespace

QStringList MainWindow::withoutFolders(const QStringList& paths, bool mayAsk) {
  QStringList files;
  for (const QString& path : paths) {
    if (!QFileInfo(path).isDir()) {
      files << path;
      continue;
    }
    std::vector<FileKind> kinds = readableFiles(path);
    if (kinds.empty()) {
      const QString why =
          tr("nothing in the folder %1 can be read: open a city model (%2), or the folder that "
             "holds one")
              .arg(QDir::toNativeSeparators(path), usualEndings());
      Q_EMIT workspace_.importRejected({diagnose(Code::FileUnreadable, why.toStdString())});
      return {};
    }
    if (kinds.size() > 1 && mayAsk) {
      FolderDialog dialog(path, std::move(kinds), this);
      if (dialog.exec() != QDialog::Accepted) return {};
      files << dialog.paths();
    } else {
      for (const FileKind& kind : kinds) files << kind.paths;
    }
  }
  return files;
}

void MainWindow::openFiles(const QStringList& given, bool mayAsk) {
  const QStringList paths = withoutFolders(given, mayAsk);
  if (paths.isEmpty()) return;
  if (isProject(paths.first())) {
    if (mayDiscard()) workspace_.openProject(paths.first());
    return;
  }
  if (!mayAsk) return workspace_.import(paths, {});
  std::optional<VectorPreview> questions = ImportDialog::questionsFor(paths);
  const bool open = workspace_.state().city != nullptr;
  if (open && questions && holdsOnlyLines(*questions)) {
    QStringList all;
    for (const std::string& path : workspace_.state().barriers) all << QString::fromStdString(path);
    workspace_.setBarriers(all + paths);
    return;
  }
  const Opening opening = open ? askHowToOpen(paths) : Opening::Instead;
  if (opening == Opening::NotAtAll || (opening == Opening::Instead && !mayDiscard())) return;
  // A city of its own starts afresh: CRS and fields of the one before are not this one's.
  ImportOptions options = opening == Opening::Added ? workspace_.state().importOptions : ImportOptions{};
  if (questions) {
    ImportDialog dialog(paths, std::move(*questions), options, this);
    if (dialog.exec() != QDialog::Accepted) return;
    options = dialog.options();
  }
  if (const QStringList meshes = MeshDialog::askedFor(paths); !meshes.isEmpty()) {
    MeshDialog dialog(meshes, options, workspace_.tasks(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    options = dialog.options();
  }
  if (opening == Opening::Instead) return workspace_.import(paths, options);
  const QStringList changed = changedFor(workspace_.state(), options);
  changed.isEmpty() ? workspace_.addToModel(paths, options) : refuseToAdd(paths, changed);
}

void MainWindow::askForMeshSettings() {
  const ProjectState& state = workspace_.state();
  MeshDialog dialog(meshesOf(state), state.importOptions, workspace_.tasks(), this);
  if (dialog.exec() == QDialog::Accepted && dialog.options() != state.importOptions)
    workspace_.readAgain(dialog.options());
}

bool MainWindow::hasMeshes() const {
  return !meshesOf(workspace_.state()).isEmpty();
}

void MainWindow::refuseToAdd(const QStringList& paths, const QStringList& changed) {
  QMessageBox box(QMessageBox::Warning, tr("Open"),
                  tr("%1 cannot be added with these settings.").arg(QFileInfo(paths.first()).fileName()),
                  QMessageBox::Ok, this);
  box.setObjectName(QStringLiteral("cannotAdd"));
  box.setInformativeText(
      tr("All files of a model are read with the same settings, and these are not those of the open model:"
         "\n%1\n\nThe model stays as it is. To have the file in it, do one of these:\n"
         "• Add it again, and leave the settings as the dialog first shows them.\n"
         "• Open all files together, with settings that suit them all.\n"
         "• If it needs settings of its own, turn it into a file that needs none, and add that: "
         "lodestone-cli convert %2 -o %3.city.json, with its settings as options.")
          .arg(changed.join(QStringLiteral("\n")), QFileInfo(paths.first()).fileName(),
               QFileInfo(paths.first()).completeBaseName()));
  box.exec();
}

MainWindow::Opening MainWindow::askHowToOpen(const QStringList& paths) {
  const QString name = QFileInfo(paths.first()).fileName();
  QMessageBox box(QMessageBox::Question, tr("Open"),
                  paths.size() == 1 ? tr("Add %1 to the open model?").arg(name)
                                    : tr("Add these %1 files to the open model?").arg(paths.size()),
                  QMessageBox::Cancel, this);
  box.setObjectName(QStringLiteral("howToOpen"));
  box.setInformativeText(tr("Added, it becomes part of this project. Opened instead, it starts a new one."));
  QPushButton* add = box.addButton(tr("&Add"), QMessageBox::AcceptRole);
  QPushButton* instead = box.addButton(tr("&Open instead"), QMessageBox::ActionRole);
  box.setDefaultButton(add);
  box.exec();
  if (box.clickedButton() == add) return Opening::Added;
  return box.clickedButton() == instead ? Opening::Instead : Opening::NotAtAll;
}

void MainWindow::openDialog() {
  const QString folder = QSettings().value(QStringLiteral("openFolder"), QDir::homePath()).toString();
  const QStringList files = QFileDialog::getOpenFileNames(this, tr("Open"), folder, readFilter());
  if (files.isEmpty()) return;
  QSettings().setValue(QStringLiteral("openFolder"), QFileInfo(files.first()).absolutePath());
  openFiles(files);
}

bool MainWindow::saveTo(const QString& path) {
  if (!workspace_.saveProject(path, layoutText())) return false;
  workspace_.markSaved(path);
  autosave_->forget();
  addRecent({path});
  showState();
  return true;
}

bool MainWindow::save() {
  return workspace_.projectPath().isEmpty() ? saveAs() : saveTo(workspace_.projectPath());
}

bool MainWindow::saveAs() {
  QString path = QFileDialog::getSaveFileName(this, tr("Save project"), workspace_.projectPath(),
                                              tr("Lodestone projects (*.lodestone)"));
  if (path.isEmpty()) return false;
  if (!path.endsWith(QStringLiteral(".lodestone"))) path += QStringLiteral(".lodestone");
  return saveTo(path);
}

bool MainWindow::mayDiscard() {
  if (workspace_.tasks().busy(Workspace::exportTask())) {
    const auto stop = QMessageBox::warning(this, tr("Export under way"),
                                           tr("Stop the export? What it has not written yet is left out."),
                                           QMessageBox::Yes | QMessageBox::No, QMessageBox::No);
    if (stop != QMessageBox::Yes) return false;
    workspace_.tasks().cancel(Workspace::exportTask());
  }
  if (!workspace_.hasUnsavedWork()) return true;
  const auto answer =
      QMessageBox::warning(this, tr("Unsaved changes"), tr("Save the changes to this project?"),
                           QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
  return answer == QMessageBox::Discard || (answer == QMessageBox::Save && save());
}

void MainWindow::closeModel() {
  if (!mayDiscard()) return;
  workspace_.tasks().cancelAll();
  workspace_.close();
}

void MainWindow::exportDialog() {
  ExportDialog dialog(workspace_, this);
  if (dialog.exec() != QDialog::Accepted) return;
  workspace_.setChainOptions(dialog.chainOptions(), tr("Change levels"));
  const ExportRequest request = dialog.request();
  QSettings().setValue(QStringLiteral("exportFolder"), QString::fromStdString(request.folder.string()));
  workspace_.exportChain(request);
}

void MainWindow::showExported(const QStringList& files) {
  if (files.isEmpty()) return;
  auto* dialog = new QDialog(this);
  dialog->setObjectName(QStringLiteral("exportReport"));
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Export"));
  auto* list = new QListWidget(dialog);
  qint64 bytes = 0;
  for (const QString& file : files) {
    const qint64 size = QFileInfo(file).size();
    bytes += size;
    list->addItem(tr("%1  (%2)").arg(QDir::toNativeSeparators(file), QLocale().formattedDataSize(size)));
  }
  auto* title = new QLabel(
      (files.size() == 1 ? tr("1 file written, %1.") : tr("%1 files written, %2 together.").arg(files.size()))
          .arg(QLocale().formattedDataSize(bytes)),
      dialog);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, dialog);
  QPushButton* show = buttons->addButton(tr("Open folder"), QDialogButtonBox::ActionRole);
  connect(show, &QPushButton::clicked, dialog, [files] {
    QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(files.first()).absolutePath()));
  });
  connect(buttons, &QDialogButtonBox::rejected, dialog, &QDialog::close);
  auto* layout = new QVBoxLayout(dialog);
  layout->addWidget(title);
  layout->addWidget(list);
  layout->addWidget(buttons);
  dialog->resize(fontMetrics().averageCharWidth() * 90, fontMetrics().height() * 16);
  dialog->show();
}

void MainWindow::savePicture() {
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Save picture"), {}, tr("Pictures (*.png *.jpg)"));
  if (path.isEmpty()) return;
  if (!(showsStage_ ? stage_->view().picture() : viewport_->picture()).save(path)) {
    Q_EMIT workspace_.diagnosed({diagnose(Code::OutputUnwritable, path.toStdString())});
  }
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  QStringList paths;
  for (const QUrl& url : event->mimeData()->urls()) {
    if (url.isLocalFile()) paths << url.toLocalFile();
  }
  event->acceptProposedAction();
  QTimer::singleShot(0, this,
                     [this, paths] { openFiles(paths); });  // the drag must end before a dialog opens
}

void MainWindow::offerLeftWork() {
  const std::optional<QString> left = autosave_->leftBehind();
  if (!left) return;
  const QString when = QLocale().toString(QFileInfo(*left).lastModified(), QLocale::ShortFormat);
  const auto answer = QMessageBox::question(
      this, tr("Unsaved work"),
      tr("Lodestone did not end well last time. Open the work that was kept at %1?").arg(when));
  if (answer == QMessageBox::Yes) {
    workspace_.recoverProject(*left);
  } else {
    Autosave::discard(*left);
  }
}

}  // namespace lodestone
