// Keeps the 3D view, the workspace and the layers saying the same.
#pragma once

#include <QObject>

#include "gui/workspace.h"

namespace lodestone {

class LayersPanel;
class Viewport;

class SceneLink : public QObject {
  Q_OBJECT

 public:
  SceneLink(Workspace& workspace, Viewport& viewport, LayersPanel& layers, QObject* parent = nullptr);

 private:
  void connectWorkspace();
  void connectViewport();
  void connectLayers();
  void showCut();

  Workspace& workspace_;
  Viewport& viewport_;
  LayersPanel& layers_;
};

}  // namespace lodestone
