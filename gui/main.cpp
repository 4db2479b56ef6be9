// lodestone: the workbench.
#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QStandardPaths>
#include <QTimer>
#include <cstdio>
#include <cstdlib>
#include <optional>

#include "gui/city/viewport.h"
#include "gui/widgets/colours.h"
#include "gui/widgets/workbench_style.h"
#include "gui/window/main_window.h"

#include "version.h"

namespace lodestone {
namespace {

/// Qt ends the program without a word of ours when there is no display: say it before.
bool hasDisplay() {
  const auto set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

/// "1440x900"
std::optional<QSize> parseSize(const QString& text) {
  const QStringList parts = text.split(QLatin1Char('x'));
  const QSize size(parts.value(0).toInt(), parts.value(1).toInt());
  return parts.size() != 2 || size.isEmpty() ? std::nullopt : std::optional(size);
}

constexpr const char* kFailed = "failed";

/// A picture's run has nobody who reads the Messages dock. What a person named and cannot be had fails it.
void tellTerminal(MainWindow& window) {
  const auto print = [](const Diagnostics& diagnostics) {
    for (const Diagnostic& d : diagnostics) {
      if (d.severity != Severity::Info) std::fprintf(stderr, "lodestone: %s\n", format(d).c_str());
    }
  };
  QObject::connect(&window.workspace(), &Workspace::importRejected, &window,
                   [&window, print](const Diagnostics& diagnostics) {
                     print(diagnostics);
                     window.setProperty(kFailed, true);
                   });
  QObject::connect(&window.workspace(), &Workspace::diagnosed, &window,
                   [&window, print](const Diagnostics& diagnostics) {
                     print(diagnostics);
                     if (leavesAnyOut(diagnostics)) window.setProperty(kFailed, true);
                   });
}

/// Takes a picture of the whole window when all work is done, and quits; none where an input could not be
/// opened.
void pictureWhenIdle(MainWindow& window, const QString& path) {
  auto* timer = new QTimer(&window);
  timer->setInterval(200);
  QObject::connect(timer, &QTimer::timeout, &window, [&window, path, timer] {
    if (window.workspace().tasks().busy()) return;
    if (window.property(kFailed).toBool()) return QApplication::exit(1);
    if (window.workspace().canCluster() && !window.workspace().state().tree &&
        !window.property("clustered").toBool()) {
      window.setProperty("clustered", true);
      window.workspace().cluster();
      return;
    }
    timer->stop();
    const bool saved = window.picture().save(path);
    if (!saved) std::fprintf(stderr, "lodestone: cannot write %s\n", qPrintable(path));
    QApplication::exit(saved ? 0 : 1);
  });
  timer->start();
}

int run(int argc, char** argv) {
  if (!hasDisplay()) {
    std::fprintf(stderr,
                 "lodestone: there is no display. Set DISPLAY, or use lodestone-cli, which needs none.\n");
    return 1;
  }
  Viewport::setDefaultSurfaceFormat();
  QApplication app(argc, argv);
  QApplication::setApplicationName(QStringLiteral("lodestone"));
  QApplication::setOrganizationName(QStringLiteral("lodestone"));
  QApplication::setApplicationDisplayName(QStringLiteral("Lodestone"));
  QApplication::setApplicationVersion(QStringLiteral(LODESTONE_VERSION));
  QApplication::setStyle(new WorkbenchStyle);

  QCommandLineParser parser;
  parser.setApplicationDescription(QApplication::tr("Turns city models into chains of levels of detail."));
  parser.addHelpOption();
  parser.addVersionOption();
  parser.addPositionalArgument(QStringLiteral("files"), QApplication::tr("City models or a project to open."),
                               QStringLiteral("[FILE…]"));
  const QCommandLineOption sample(QStringLiteral("sample"), QApplication::tr("Open the sample town."));
  const QCommandLineOption screenshot(QStringLiteral("screenshot"),
                                      QApplication::tr("Open, cluster, save a picture of the window, quit."),
                                      QStringLiteral("OUT.png"));
  const QCommandLineOption size(QStringLiteral("size"), QApplication::tr("Size of the window."),
                                QStringLiteral("WxH"), QStringLiteral("1440x900"));
  const QCommandLineOption dark(QStringLiteral("dark"), QApplication::tr("Dark appearance."));
  const QCommandLineOption light(QStringLiteral("light"), QApplication::tr("Light appearance."));
  parser.addOptions({sample, screenshot, size, dark, light});
  parser.process(app);
  const std::optional<QSize> windowSize = parseSize(parser.value(size));
  if (!windowSize) {
    std::fprintf(stderr, "lodestone: --size is %s, wanted WxH such as 1440x900\n",
                 qPrintable(parser.value(size)));
    return 2;
  }
  const bool picture = parser.isSet(screenshot);
  if (picture) QStandardPaths::setTestModeEnabled(true);

  const int wanted = parser.isSet(dark) ? 2
                     : parser.isSet(light) || picture
                         ? 1
                         : QSettings().value(QStringLiteral("appearance"), 0).toInt();
  (void)paletteOf(Appearance::System);  // remembers the desktop's palette before it is replaced
  QApplication::setPalette(paletteOf(static_cast<Appearance>(wanted)));

  MainWindow window;
  if (picture) tellTerminal(window);
  if (picture) window.useDefaultLayout();
  if (picture || parser.isSet(size)) window.resize(*windowSize);
  window.show();
  if (!parser.positionalArguments().isEmpty()) {
    window.openFiles(parser.positionalArguments(),
                     !picture);  // nobody is there to answer a picture's questions
  } else if (parser.isSet(sample)) {
    window.workspace().openSample();
  } else if (!picture) {
    QTimer::singleShot(0, &window, &MainWindow::offerLeftWork);
  }
  if (picture) pictureWhenIdle(window, parser.value(screenshot));
  return QApplication::exec();
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::run(argc, argv);
}
