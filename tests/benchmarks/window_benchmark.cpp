// From the start of the process to a window that is drawn, and from a file of footprints to its picture in
// it. Run with QT_QPA_PLATFORM=offscreen (no display) or under a window system.
//
// usage: window_benchmark [FOOTPRINTS]   (default: 40,000 made-up buildings as GeoJSON)
//
// Each measurement is a process of its own, as a user would start it. The floor of the first is a bare Qt
// window of the same size; that of the second, reading the same file on the command line's way, without a
// window.
#include <QApplication>
#include <QMainWindow>
#include <QProcess>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTimer>
#include <algorithm>
#include <chrono>
#include <cstdio>

#include "algorithms/chains/chain_building.h"
#include "algorithms/footprints/import.h"
#include "algorithms/synthesis/synthesis.h"
#include "gui/city/viewport.h"
#include "gui/widgets/workbench_style.h"
#include "gui/window/main_window.h"
#include "gui/workspace/task_runner.h"
#include "model/io/format.h"

#include "measuring.h"

using namespace lodestone;

namespace {

constexpr int kRuns = 5;
constexpr QSize kSize(1440, 900);

int showBareWindow(int argc, char** argv) {
  const QApplication app(argc, argv);
  QMainWindow window;
  window.resize(kSize);
  window.show();
  QApplication::processEvents();
  return window.grab().isNull() ? 1 : 0;
}

/// Shows the workbench, with a file when there is one, and ends as soon as what it shows is drawn.
int showWorkbench(int argc, char** argv, const QString& file) {
  QStandardPaths::setTestModeEnabled(true);
  Viewport::setDefaultSurfaceFormat();
  const QApplication app(argc, argv);
  QApplication::setStyle(new WorkbenchStyle);
  MainWindow window;
  window.useDefaultLayout();
  window.resize(kSize);
  window.show();
  QApplication::processEvents();
  if (file.isEmpty()) return window.picture().isNull() ? 1 : 0;
  const auto drawn = [&window] { QApplication::exit(window.picture().isNull() ? 1 : 0); };
  // The last task makes what is drawn.
  QObject::connect(&window.workspace().tasks(), &TaskRunner::idle, &window, drawn, Qt::QueuedConnection);
  window.openFiles({file}, false);
  return QApplication::exec();
}

int readOnly(const QString& file) {
  return importCity({file.toStdString()}, {}).value ? 0 : 1;
}

/// Median wall time of this program run with `arguments`, s; below 0 when it failed.
double timeOf(const QStringList& arguments) {
  std::vector<double> times;
  int status = 0;
  for (int run = 0; run < kRuns; ++run)
    times.push_back(
        seconds([&] { status |= QProcess::execute(QCoreApplication::applicationFilePath(), arguments); }));
  if (status != 0) return -1;
  std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
  return times[kRuns / 2];
}

bool writeCity(const QString& path) {
  const auto city = std::make_shared<const CityModel>(
      synthesiseCity({.preset = CityPreset::Charlotte, .buildings = 40'000}));
  const Format* format = formatForWriting(path.toStdString());
  const Result<LodChain> chain = makeChain(city, nullptr, {});
  return format && chain && format->write(*chain, path.toStdString(), {}, {});
}

int compare(int argc, char** argv) {
  const QCoreApplication app(argc, argv);
  const QTemporaryDir folder;
  QString file = QCoreApplication::arguments().value(1);
  if (file.isEmpty()) {
    file = folder.filePath(QStringLiteral("city.geojson"));
    if (!writeCity(file)) return 1;
  }
  const double bare = timeOf({QStringLiteral("--bare")});
  const double window = timeOf({QStringLiteral("--workbench")});
  const double reading = timeOf({QStringLiteral("--read"), file});
  const double picture = timeOf({QStringLiteral("--workbench"), file});
  const bool kept = std::min({bare, window, reading, picture}) > 0 && window <= 1 && picture - window <= 3;
  std::printf("window up           %6.2f s (asked: 1 s); a bare Qt window %.2f s, ratio %.1f\n", window, bare,
              window / bare);
  std::printf(
      "file to picture     %6.2f s (asked: 3 s), start of the program not counted; reading alone %.2f s, "
      "ratio %.2f\n",
      picture - window, reading, (picture - window) / reading);
  return kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string mode = argc > 1 ? argv[1] : "";
  const QString file = QString::fromLocal8Bit(argc > 2 ? argv[2] : "");
  if (mode == "--bare") return showBareWindow(argc, argv);
  if (mode == "--workbench") return showWorkbench(argc, argv, file);
  if (mode == "--read") return readOnly(file);
  return compare(argc, argv);
}
