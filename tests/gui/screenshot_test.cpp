// The workbench started for a picture alone: what a script sees of it.
#include <QDir>
#include <QFile>
#include <QImage>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

namespace lodestone {

struct Ran {
  int status = -1;
  QString err;
};

class ScreenshotTest : public QObject {
  Q_OBJECT

 private:
  static Ran run(const QStringList& arguments) {
    QProcess program;
    program.start(QStringLiteral(LODESTONE_PROGRAM), arguments);
    constexpr int kPatience = 120000;
    if (!program.waitForFinished(kPatience) || program.exitStatus() != QProcess::NormalExit) return {};
    return {program.exitCode(), QString::fromUtf8(program.readAllStandardError())};
  }

 private Q_SLOTS:
  void takesThePicture() {
    const QTemporaryDir folder;
    const QString picture = folder.filePath(QStringLiteral("p.png"));
    const Ran ran =
        run({QStringLiteral("--screenshot"), picture, QStringLiteral("--size"), QStringLiteral("1000x700"),
             QStringLiteral(LODESTONE_SOURCE_DIR "/resources/sample/town.city.json")});
    QCOMPARE(ran.status, 0);
    QVERIFY(!QImage(picture).isNull());
  }

  void failsForWhatCannotBeOpened_data() {
    QTest::addColumn<QStringList>("files");
    QTest::addColumn<QString>("said");
    const QString town = QStringLiteral(LODESTONE_SOURCE_DIR "/resources/sample/town.city.json");
    const QString readme = QStringLiteral(LODESTONE_SOURCE_DIR "/README.md");
    QTest::newRow("missing") << QStringList{QStringLiteral("no-such.gml")} << QStringLiteral("error 101");
    QTest::newRow("no model") << QStringList{readme} << QStringLiteral("error 103");
    QTest::newRow("beside a good one") << QStringList{town, readme} << QStringLiteral("error 103");
    QTest::newRow("project") << QStringList{QStringLiteral("no-such.lodestone")}
                             << QStringLiteral("error 101");
  }
  void failsForWhatCannotBeOpened() {
    QFETCH(QStringList, files);
    QFETCH(QString, said);
    const QTemporaryDir folder;
    const QString picture = folder.filePath(QStringLiteral("p.png"));
    const Ran ran = run(QStringList{QStringLiteral("--screenshot"), picture} + files);
    QCOMPARE(ran.status, 1);
    QVERIFY2(ran.err.contains(said), qPrintable(ran.err));
    QVERIFY(!QFile::exists(picture));
  }

  void refusesSizesThatAreNone() {
    const Ran ran = run({QStringLiteral("--size"), QStringLiteral("huge")});
    QCOMPARE(ran.status, 2);
    QVERIFY2(ran.err.contains(QStringLiteral("1440x900")), qPrintable(ran.err));
  }
};

}  // namespace lodestone

QTEST_GUILESS_MAIN(lodestone::ScreenshotTest)
#include "screenshot_test.moc"
