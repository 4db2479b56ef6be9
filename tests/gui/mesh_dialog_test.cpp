// Meshes that say neither which axis is up nor their unit: asked at the door, and changed later.
#include "gui/dialogs/mesh_dialog.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QToolButton>

#include "gui/window/stage_window.h"
#include "model/io/atomic_file.h"
#include "tests/gui/workbench_support.h"

namespace lodestone {
namespace {

/// A tower of 400 × 400 × 1000 centimetres that stands on its z axis, though nobody says so.
constexpr const char* kTower =
    "v 0 0 0\nv 400 0 0\nv 400 400 0\nv 0 400 0\nv 0 0 1000\nv 400 0 1000\nv 400 400 1000\nv 0 400 1000\n"
    "g tower\nf 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n";

/// Answers the dialog that opens next, once its pictures are there.
void answerNext(const std::function<void(MeshDialog&)>& answer) {
  QTimer::singleShot(100, [answer] {
    auto* dialog = qobject_cast<MeshDialog*>(QApplication::activeModalWidget());
    if (!dialog || dialog->findChild<QToolButton*>(QStringLiteral("zUp"))->icon().isNull())
      return answerNext(answer);
    answer(*dialog);
  });
}

class MeshDialogTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() {
    QVERIFY(folder_.isValid());
    tower_ = folder_.filePath(QStringLiteral("tower.obj"));
    writeFile(tower_.toStdString(), kTower);
    window_ = makeWindow();
  }
  void cleanup() { window_.reset(); }

  void asksAndTakesTheAnswer();
  void changesWhatIsOpen();
  void asksNothingWhereTheFileSaysIt();

 private:
  [[nodiscard]] Vec3 size() {
    const auto& city = window_->workspace().state().city;
    return city ? bounds(*city).size() : Vec3::Zero().eval();
  }

  QTemporaryDir folder_;
  QString tower_;
  std::unique_ptr<MainWindow> window_;
};

void MeshDialogTest::asksAndTakesTheAnswer() {
  bool asked = false;
  answerNext([&](MeshDialog& dialog) {
    asked = true;
    auto* y = dialog.findChild<QToolButton*>(QStringLiteral("yUp"));
    auto* z = dialog.findChild<QToolButton*>(QStringLiteral("zUp"));
    QVERIFY(y->isChecked());
    const QSize shown = y->iconSize();
    QVERIFY(y->icon().pixmap(shown).toImage() != z->icon().pixmap(shown).toImage());
    z->click();
    dialog.findChild<QComboBox*>(QStringLiteral("unit"))->setCurrentIndex(1);
    QVERIFY(!dialog.findChild<QDoubleSpinBox*>(QStringLiteral("otherUnit"))->isVisible());
    if (const QString pictures = qEnvironmentVariable("LODESTONE_SCREENSHOTS"); !pictures.isEmpty())
      dialog.grab().save(QDir(pictures).filePath(QStringLiteral("mesh-dialog.png")));
    dialog.accept();
  });
  window_->openFiles({tower_});
  QVERIFY(asked);
  QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().state().city, kLong);
  QVERIFY((size() - Vec3(4, 4, 10)).norm() < 1e-9);
  QVERIFY(!said(*window_, Code::UpAxisAssumed));
}

void MeshDialogTest::changesWhatIsOpen() {
  window_->openFiles({tower_}, false);
  QTRY_VERIFY_WITH_TIMEOUT(window_->workspace().state().city, kLong);
  QVERIFY(said(*window_, Code::UpAxisAssumed));
  QVERIFY((size() - Vec3(400, 1000, 400)).norm() < 1e-6);
  auto* action = window_->findChild<QAction*>(QStringLiteral("meshSettings"));
  QVERIFY(action->isEnabled());
  answerNext([](MeshDialog& dialog) {
    dialog.findChild<QToolButton*>(QStringLiteral("zUp"))->click();
    auto* unit = dialog.findChild<QComboBox*>(QStringLiteral("unit"));
    unit->setCurrentIndex(unit->count() - 1);
    auto* other = dialog.findChild<QDoubleSpinBox*>(QStringLiteral("otherUnit"));
    QVERIFY(other->isVisible());
    other->setValue(0.05);
    dialog.accept();
  });
  action->trigger();
  QTRY_VERIFY_WITH_TIMEOUT((size() - Vec3(20, 20, 50)).norm() < 1e-6, kLong);
  window_->workspace().session().undo();
  QVERIFY((size() - Vec3(400, 1000, 400)).norm() < 1e-6);
}

void MeshDialogTest::asksNothingWhereTheFileSaysIt() {
  QCOMPARE(MeshDialog::askedFor({tower_}), QStringList{tower_});
  const QString ours = folder_.filePath(QStringLiteral("ours.obj"));
  writeFile(ours.toStdString(), std::string("# Lodestone: original\n") + kTower);
  const QString town = QStringLiteral(LODESTONE_SOURCE_DIR "/resources/sample/town.city.json");
  QCOMPARE(MeshDialog::askedFor({ours, town}), QStringList());
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::MeshDialogTest>(argc, argv);
}

#include "mesh_dialog_test.moc"
