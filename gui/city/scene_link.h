// Keeps the 3D view, the workspace and the layers saying the same.
#pragma once

#include <QObject>
#include <memory>

#include "gui/workspace/workspace.h"

namespace lodestone {

class LayersPanel;
class Viewport;
struct SceneGeometry;

class SceneLink : public QObject {
  Q_OBJECT

 public:
  SceneLink(Workspace& workspace, Viewport& viewport, LayersPanel& layers, QObject* parent = nullptr);

 private:
  void connectWorkspace();
  void connectViewport();
  void connectLayers();
  /// Has the city of the state meshed on another thread; show() follows.
  void prepare();
  void show(std::shared_ptr<const SceneGeometry> geometry);
  /// The scene shows the city and the tree of the state, and not those before, whose numbers mean others.
  [[nodiscard]] bool upToDate() const;
  void showCut();

  Workspace& workspace_;
  Viewport& viewport_;
  LayersPanel& layers_;
  bool fits_ = false;  ///< the city that is being meshed is to be looked at as a whole
};

}  // namespace lodestone
