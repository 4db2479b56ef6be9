// lodestone: the workbench.
#include <QApplication>

#include "gui/viewport.h"

int main(int argc, char** argv) {
  lodestone::Viewport::setDefaultSurfaceFormat();
  QApplication app(argc, argv);
  lodestone::Viewport viewport;
  viewport.show();
  return QApplication::exec();
}
