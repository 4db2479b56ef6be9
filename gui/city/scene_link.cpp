#include "gui/city/scene_link.h"

#include <utility>

#include "gui/city/layers_panel.h"
#include "gui/city/viewport.h"
#include "gui/view3d/scene_geometry.h"

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
            if (before.city != after.city) fits_ = true;
            prepare();
          });
  connect(&workspace_, &Workspace::projectOpened, this, [this] { fits_ = false; });  // it has a camera
  connect(&workspace_, &Workspace::cutChanged, this, &SceneLink::showCut);
  connect(&workspace_, &Workspace::selectionChanged, this, [this] {
    if (upToDate()) viewport_.scene().setSelection(workspace_.selection());
  });
  connect(&workspace_, &Workspace::hoverChanged, this, [this] {
    if (upToDate()) viewport_.scene().setHover(workspace_.hover());
  });
  connect(&workspace_, &Workspace::flyRequested, this, [this](NodeId node) {
    const Box3 box = upToDate() ? viewport_.scene().boundsOf(node) : Box3{};
    if (!box.empty()) viewport_.fitTo(box);
  });
}

void SceneLink::connectViewport() {
  connect(&viewport_, &Viewport::cameraChanged, &workspace_, &Workspace::setCamera);
  connect(&viewport_, &Viewport::hovered, this, [this](NodeId node) {
    if (upToDate()) workspace_.setHover(node);
  });
  connect(&viewport_, &Viewport::picked, this, [this](NodeId node, bool add) {
    if (!upToDate()) return;
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

bool SceneLink::upToDate() const {
  const CityScene& scene = viewport_.scene();
  return scene.city() == workspace_.state().city && scene.tree() == workspace_.state().tree;
}

void SceneLink::prepare() {
  const ProjectState& state = workspace_.state();
  if (!state.city) return viewport_.scene().setCity(nullptr);
  workspace_.tasks().complete(
      QStringLiteral("scene"), tr("Preparing the 3D view"),
      [city = state.city, tree = state.tree, earlier = viewport_.scene().geometry()](const Progress&) {
        return makeSceneGeometry(city, tree, earlier.get());
      },
      [this](std::shared_ptr<const SceneGeometry> geometry) { show(std::move(geometry)); });
}

void SceneLink::show(std::shared_ptr<const SceneGeometry> geometry) {
  const ProjectState& state = workspace_.state();
  if (geometry->city != state.city || geometry->tree != state.tree) return;  // another is on its way
  viewport_.scene().setCity(state.city, state.tree, std::move(geometry));
  viewport_.scene().setLines(layers_.shownLines());
  viewport_.scene().setSelection(workspace_.selection());
  if (std::exchange(fits_, false)) viewport_.fit();
  workspace_.setCamera(viewport_.camera());
  showCut();
}

void SceneLink::showCut() {
  if (!workspace_.state().city || !upToDate()) return;
  if (workspace_.cut()) {
    viewport_.scene().showCut(*workspace_.cut());
  } else {
    viewport_.scene().showAllBuildings();
  }
}

}  // namespace lodestone
