// The strip of levels: measured, drawn, chosen by mouse and keys, and grown by a level.
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <set>

#include "gui/city/level_strip.h"
#include "gui/dialogs/export_dialog.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {

class ChainTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    window_ = makeWindow();
    workspace().openSample();
    QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
    waitForTasks();
    window_->findChild<QWidget*>(QStringLiteral("chainDock"))->raise();
    click("measureLevels");
  }
  void cleanup() { window_.reset(); }

  void everyLevelHasItsCard();
  void choosingALevelShowsIt();
  void focusChoosesNoLevel();
  void aLevelIsAdded();
  void levelsBelongToTheProject();

 private:
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  [[nodiscard]] LevelStrip& strip() { return *window_->findChild<LevelStrip*>(); }
  void waitForTasks() { QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong); }
  void click(const char* button) {
    QTest::mouseClick(window_->findChild<QPushButton*>(QString::fromLatin1(button)), Qt::LeftButton);
    waitForTasks();
  }

  std::unique_ptr<MainWindow> window_;
};

void ChainTest::everyLevelHasItsCard() {
  QVERIFY(workspace().chain());
  QCOMPARE(strip().model()->rowCount(), static_cast<int>(workspace().chain()->levels.size()));
  std::set<QByteArray> pictures;
  for (int row = 0; row < strip().model()->rowCount(); ++row) {
    const auto picture = strip().model()->index(row, 0).data(Qt::UserRole).value<QImage>();
    QCOMPARE(picture.size(), strip().pictureSize() * strip().devicePixelRatioF());
    pictures.insert(QByteArray(reinterpret_cast<const char*>(picture.constBits()), picture.sizeInBytes()));
  }
  QVERIFY2(pictures.size() > 2, "levels look different");
  QCOMPARE(strip().currentIndex().row(), -1);  // the cut follows the camera: none of the levels is drawn
}

void ChainTest::choosingALevelShowsIt() {
  strip().setFocus();
  const QModelIndex second = strip().model()->index(1, 0);
  QTest::mouseClick(strip().viewport(), Qt::LeftButton, {}, strip().visualRect(second).center());
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Tolerance);
  const std::size_t fine = workspace().cut()->drawn.size();
  QTest::keyClick(&strip(), Qt::Key_Right);
  QCOMPARE(strip().currentIndex().row(), 2);
  QVERIFY(workspace().cut()->drawn.size() < fine);
  keepPicture(*window_, QStringLiteral("chain"));
  QTest::keyClick(&strip(), Qt::Key_Home);
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Original);
  // What is drawn is marked, whoever chose it.
  workspace().session().undo();
  QCOMPARE(strip().currentIndex().row(), 2);
  workspace().setCutChoice({});
  QCOMPARE(strip().currentIndex().row(), -1);
}

void ChainTest::focusChoosesNoLevel() {
  const CutChoice choice = workspace().state().cutChoice;
  const std::string undo = workspace().session().undoText();
  window_->activateWindow();
  window_->findChild<QPushButton*>(QStringLiteral("measureLevels"))->setFocus();
  strip().setFocus(Qt::TabFocusReason);
  QTRY_VERIFY(strip().hasFocus());
  QVERIFY(workspace().state().cutChoice == choice);
  QCOMPARE(workspace().session().undoText(), undo);
  QCOMPARE(strip().currentIndex().row(), -1);
  QTest::keyClick(&strip(), Qt::Key_Right);
  QCOMPARE(strip().currentIndex().row(), 0);
  QCOMPARE(workspace().state().cutChoice.mode, CutMode::Original);
}

void ChainTest::aLevelIsAdded() {
  const std::size_t before = workspace().chain()->levels.size();
  const double last = workspace().chain()->levels.back().error;
  click("addLevel");
  QCOMPARE(workspace().chain()->levels.size(), before + 1);
  QVERIFY(workspace().chain()->levels.back().error >= last);
  QCOMPARE(strip().model()->rowCount(), static_cast<int>(before) + 1);
}

void ChainTest::levelsBelongToTheProject() {
  const std::string first = workspace().state().chainOptions.tolerances;
  click("addLevel");
  const std::string more = workspace().state().chainOptions.tolerances;
  QVERIFY(more != first);
  const auto shown = [this] { return window_->findChild<QLineEdit*>(QStringLiteral("tolerances"))->text(); };
  QCOMPARE(shown().toStdString(), more);
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  workspace().session().undo();
  QCOMPARE(workspace().state().chainOptions.tolerances, first);
  QCOMPARE(shown().toStdString(), first);
  QVERIFY2(workspace().chainOutdated(), "it was measured with a level more");
  // What is exported is what the project says.
  workspace().openProject(path);
  QTRY_VERIFY_WITH_TIMEOUT(workspace().projectPath() == path, kLong);
  waitForTasks();
  QCOMPARE(workspace().state().chainOptions.tolerances, more);
  QCOMPARE(ExportDialog(workspace()).chainOptions().tolerances, more);
  // A slider of the method is one of the chain.
  click("measureLevels");
  QVERIFY(!workspace().chainOutdated());
  CutOptions options = workspace().state().chainOptions.cut;
  options.epsilon = 0;
  workspace().setCutOptions(options, QStringLiteral("ε"));
  QVERIFY(workspace().chainOutdated());
  click("measureLevels");
  QVERIFY2(workspace().chain() && !workspace().chainOutdated(), "what the cut takes the chain takes");
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::ChainTest>(argc, argv);
}
#include "chain_test.moc"
