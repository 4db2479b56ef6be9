#include "gui/scene_link.h"

#include "gui/layers_panel.h"
#include "gui/viewport.h"

namespace lodestone {

SceneLink::SceneLink(Workspace& workspace, Viewport& viewport, LayersPanel& layers, QObject* parent)
    : QObject(parent), workspace_(workspace), viewport_(viewport), layers_(layers) {
  for (std::size_t i = 0; i < kOverlayCount; ++i) {
    const auto overlay = static_cast<Overlay>(i);
    viewport_.scene().setOverlay(overlay, layers_.isShown(overlay));
  }
  connectWorkspace();
  connectViewport();
  connectLayers();
}

void SceneLink::connectWorkspace() {
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.city == after.city && before.tree == after.tree) return;
            viewport_.scene().setCity(after.city, after.tree);
            if (before.city != after.city) {
              viewport_.fit();
              workspace_.setCamera(viewport_.camera());
            }
          });
  connect(&workspace_, &Workspace::cutChanged, this, &SceneLink::showCut);
  connect(&workspace_, &Workspace::selectionChanged, this,
          [this] { viewport_.scene().setSelection(workspace_.selection()); });
  connect(&workspace_, &Workspace::hoverChanged, this,
          [this] { viewport_.scene().setHover(workspace_.hover()); });
  connect(&workspace_, &Workspace::flyRequested, this, [this](NodeId node) {
    const Box3 box = viewport_.scene().boundsOf(node);
    if (!box.empty()) viewport_.fitTo(box);
  });
}

void SceneLink::connectViewport() {
  connect(&viewport_, &Viewport::cameraChanged, &workspace_, &Workspace::setCamera);
  connect(&viewport_, &Viewport::hovered, &workspace_, &Workspace::setHover);
  connect(&viewport_, &Viewport::picked, this, [this](NodeId node, bool add) {
    std::vector<NodeId> nodes = add ? workspace_.selection() : std::vector<NodeId>();
    if (node != kNoNode && std::erase(nodes, node) == 0) nodes.push_back(node);
    workspace_.select(std::move(nodes));
  });
}

void SceneLink::connectLayers() {
  connect(&layers_, &LayersPanel::overlayChanged, this,
          [this](Overlay overlay, bool on) { viewport_.scene().setOverlay(overlay, on); });
  connect(&layers_, &LayersPanel::layerStyled, this, [this](SceneLayer layer, const LayerStyle& style) {
    viewport_.scene().setLayerStyle(layer, style);
  });
  connect(&layers_, &LayersPanel::linesChanged, this,
          [this] { viewport_.scene().setLines(layers_.shownLines()); });
  connect(&layers_, &LayersPanel::coloursChanged, this,
          [this](SceneColours colours) { viewport_.scene().setColours(colours); });
}

void SceneLink::showCut() {
  if (!workspace_.state().city) return;
  if (workspace_.cut()) {
    viewport_.scene().showCut(*workspace_.cut());
  } else {
    viewport_.scene().showAllBuildings();
  }
}

}  // namespace lodestone
