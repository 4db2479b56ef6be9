// The real window for tests, with settings of its own.
#pragma once

#include <QApplication>
#include <QDir>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <memory>

#include "gui/city/messages_panel.h"
#include "gui/city/viewport.h"
#include "gui/widgets/workbench_style.h"
#include "gui/window/main_window.h"

namespace lodestone {

inline constexpr int kLong = 120'000;  // milliseconds

inline std::unique_ptr<MainWindow> makeWindow() {
  auto window = std::make_unique<MainWindow>();
  window->resize(1280, 800);
  window->show();
  [[maybe_unused]] const bool shown = QTest::qWaitForWindowExposed(window.get());
  return window;
}

inline bool said(MainWindow& window, Code code) {
  const Diagnostics& all = window.messages().messages();
  return std::any_of(all.begin(), all.end(), [&](const Diagnostic& d) { return d.code == code; });
}

/// LODESTONE_SCREENSHOTS names a folder in which people find what the tests saw.
inline void keepPicture(MainWindow& window, const QString& name) {
  const QString folder = qEnvironmentVariable("LODESTONE_SCREENSHOTS");
  if (folder.isEmpty() || !QDir().mkpath(folder)) return;
  window.picture().save(QDir(folder).filePath(name + QStringLiteral(".png")));
}

/// Runs one test class in an application as the program sets it up. Settings and autosaves lie in a folder of
/// this process: tests run side by side, and windows that share a layout would close each other's docks.
template <class Test>
int runWorkbenchTest(int argc, char** argv) {
  const QTemporaryDir home;
  if (!home.isValid()) return 1;
  for (const char* place : {"XDG_CONFIG_HOME", "XDG_DATA_HOME"}) qputenv(place, home.path().toUtf8());
  Viewport::setDefaultSurfaceFormat();
  QApplication app(argc, argv);
  QApplication::setApplicationName(QStringLiteral("lodestone-test"));
  QApplication::setOrganizationName(QStringLiteral("lodestone-test"));
  QApplication::setStyle(new WorkbenchStyle);
  Test test;
  return QTest::qExec(&test, argc, argv);
}

}  // namespace lodestone
