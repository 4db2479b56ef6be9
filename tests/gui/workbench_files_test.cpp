// What the real window reads and writes: bad input, exports, projects.
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <fstream>

#include "gui/city/method_panel.h"
#include "gui/dialogs/export_dialog.h"
#include "gui/widgets/field_slider.h"
#include "model/io/format.h"
#include "tests/gui/sample_support.h"

namespace lodestone {

class WorkbenchFilesTest : public WorkbenchFixture {
  Q_OBJECT

 private Q_SLOTS:
  void init() { window_ = makeWindow(); }
  void cleanup() { window_.reset(); }
  void badFilesAreSaid();
  void exportsEveryFormat();
  void exportDialogSaysWhatIsLost();
  void projectsComeBack();
};

void WorkbenchFilesTest::badFilesAreSaid() {
  openSample();
  const auto city = workspace().state().city;
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("broken.gml"));
  std::ofstream(path.toStdString()) << "<?xml version=\"1.0\"?><core:CityModel "
                                       "xmlns:core=\"http://www.opengis.net/citygml/2.0\"><core:cityObj";
  window_->openFiles({path}, false);
  QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  QVERIFY(!window_->messages().messages().empty());
  QVERIFY(window_->messages().isVisible());
  window_->openFiles({folder.filePath(QStringLiteral("absent.gml"))}, false);
  QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  QVERIFY(said(*window_, Code::FileNotFound) || said(*window_, Code::FormatUnknown));
  QCOMPARE(workspace().state().city, city);
}

void WorkbenchFilesTest::exportsEveryFormat() {
  openSample();
  const QTemporaryDir folder;
  ExportRequest request;
  request.folder = folder.path().toStdString();
  request.name = "town";
  std::size_t wanted = 0;
  for (const Format& format : formats()) {
    if (!format.write) continue;
    request.formats.emplace_back(format.id);
    ++wanted;
  }
  QVERIFY(wanted > 0);
  QSignalSpy exported(&workspace(), &Workspace::exported);
  workspace().exportChain(request);
  QTRY_COMPARE_WITH_TIMEOUT(exported.count(), 1, kLong);
  const QStringList files = exported.front().front().toStringList();
  QVERIFY(files.size() >= static_cast<qsizetype>(wanted));
  for (const QString& file : files) QVERIFY2(QFileInfo(file).size() > 0, qPrintable(file));
  QVERIFY(find<QDialog>("exportReport"));
}

void WorkbenchFilesTest::exportDialogSaysWhatIsLost() {
  openSample();
  ExportDialog dialog(workspace(), {});
  auto* list = dialog.findChild<QListWidget*>(QStringLiteral("formats"));
  QVERIFY(list->count() > 0);
  for (int i = 0; i < list->count(); ++i) list->item(i)->setCheckState(Qt::Checked);
  const QString losses = dialog.findChild<QLabel*>(QStringLiteral("losses"))->text();
  for (const std::string& id : dialog.request().formats) {
    const Format* format = formatById(id);
    QVERIFY(losses.contains(
        QString::fromUtf8(format->losses.data(), static_cast<qsizetype>(format->losses.size()))
            .toHtmlEscaped()));
  }
  const QTemporaryDir home;
  auto* folder = dialog.findChild<QLineEdit*>(QStringLiteral("folder"));
  const QPushButton* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  folder->setText(home.filePath(QStringLiteral("new/deeper")));
  QVERIFY2(ok->isEnabled(), "writers make folders");
  folder->setText(QStringLiteral("somewhere"));
  QVERIFY2(!ok->isEnabled(), "nobody knows from where it counts");

  list->item(0)->setCheckState(Qt::Unchecked);
  const auto chosen = dialog.request().formats;
  folder->setText(home.path());
  dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok)->click();
  QVERIFY2(ExportDialog(workspace(), {}).request().formats == chosen, "as the last time");
}

void WorkbenchFilesTest::projectsComeBack() {
  openSample();
  CutOptions options = workspace().state().chainOptions.cut;
  options.epsilon = 321;
  workspace().setCutOptions(options, QStringLiteral("test"));
  const CutChoice choice{CutMode::Weight, 5000};
  workspace().setCutChoice(choice);
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  workspace().markSaved(path);
  QVERIFY(!workspace().session().modified());
  workspace().close();
  QVERIFY(!workspace().state().city);
  window_->openFiles({path});
  QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
  QCOMPARE(workspace().state().chainOptions.cut.epsilon, 321.0);
  QCOMPARE(workspace().state().cutChoice, choice);
  QCOMPARE(window_->method().epsilon().value(), 321.0);

  // What an autosave kept is not a project: nobody chose its place, and it is not saved yet.
  const QString kept = folder.filePath(QStringLiteral("kept.lodestone"));
  QVERIFY(QFile::copy(path, kept));
  workspace().close();
  workspace().recoverProject(kept);
  QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
  QVERIFY(workspace().projectPath().isEmpty());
  QVERIFY(workspace().hasUnsavedWork());
  QVERIFY2(!QFile::exists(kept), "this run keeps the work from here on");
  workspace().close();
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::WorkbenchFilesTest>(argc, argv);
}
#include "workbench_files_test.moc"
