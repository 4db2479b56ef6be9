#include "gui/view3d/building_pane.h"

#include <algorithm>

#include <vtkRenderer.h>

#include "gui/view3d/component_colours.h"

namespace lodestone {
namespace {

/// A building is seen from so near that nothing fades.
constexpr double kNoHaze = 1e9;

std::array<std::uint8_t, 4> bytes(const Rgb& colour, std::uint8_t outline) {
  std::array<std::uint8_t, 4> result{0, 0, 0, outline};
  for (std::size_t i = 0; i < 3; ++i)
    result[i] = static_cast<std::uint8_t>(std::clamp(colour[i], 0.0F, 1.0F) * 255 + 0.5F);
  return result;
}

Rgb mix(const Rgb& a, const Rgb& b, float share) {
  return {a[0] + (b[0] - a[0]) * share, a[1] + (b[1] - a[1]) * share, a[2] + (b[2] - a[2]) * share};
}

/// First in its renderer: it paints every pixel, and what comes after lies over it.
vtkSmartPointer<CityProp> propIn(vtkRenderer* renderer) {
  auto prop = vtkSmartPointer<CityProp>::New();
  renderer->AddViewProp(prop);
  return prop;
}

bool isSolid(const BuildingLook& look, std::uint32_t component) {
  return look.isolated.empty() || look.isolated[component];
}

}  // namespace

BuildingPane::BuildingPane(vtkRenderer* renderer)
    : renderer_(renderer),
      prop_(propIn(renderer)),
      ghosts_(renderer, 1, 0.35),
      angles_(renderer, 3, 1),
      planes_(renderer, 3, 1),
      glyphs_{PointOverlay(renderer, PointShape::Disc, 5), PointOverlay(renderer, PointShape::Disc, 9),
              PointOverlay(renderer, PointShape::Square, 9)},
      picked_(renderer, PointShape::Circle, 20, true),
      separated_(renderer, PointShape::Circle, 17, true),
      lost_(renderer, PointShape::Cross, 15, true),
      chosen_(renderer, PointShape::Circle, 30, true),
      sight_(renderer),
      surfaces_(renderer) {
  for (const VertexClass c : {VertexClass::Ordinary, VertexClass::Boundary, VertexClass::Hole})
    glyphs_[static_cast<std::size_t>(c)].setColour(classColour(c));
  separated_.setColour(fateColour(ContactFate::Separated));
  lost_.setColour(fateColour(ContactFate::Lost));
}

BuildingPane::~BuildingPane() {
  renderer_->RemoveViewProp(prop_);
}

void BuildingPane::setModel(std::shared_ptr<const PaneModel> model, const BuildingLook& look) {
  model_ = std::move(model);
  prop_->setMesh(CityProp::Buildings, model_ ? model_->nodes : nullptr);
  show(look);
}

void BuildingPane::show(const BuildingLook& look) {
  solid_.clear();
  for (std::uint32_t c = 0; model_ && c < model_->nodes->ranges.size(); ++c) {
    if (model_->nodes->ranges[c].count > 0 && isSolid(look, c)) solid_.push_back(c);
  }
  prop_->setPalette(look.palette);
  showSurfaces(look);
  setRanges(look);
  showGlyphs(look);
  showLines(look);
  recolour(look);
}

void BuildingPane::showSurfaces(const BuildingLook& look) {
  std::vector<bool> drawn;
  for (std::size_t c = 0; model_ && c < model_->component.size(); ++c)
    drawn.push_back(isSolid(look, model_->component[c]));
  surfaces_.show(model_ ? model_->mesh : nullptr, drawn, look.surfaces, paintOf(look));
}

/// Null: none of the paint is for what the pane shows.
std::shared_ptr<const PaintedTriangles> BuildingPane::paintOf(const BuildingLook& look) const {
  const auto found = std::find_if(look.painted.begin(), look.painted.end(), [this](const auto& paint) {
    return model_ && paint->mesh == model_->mesh;
  });
  return found == look.painted.end() ? nullptr : *found;
}

/// Where surfaces have a look of their own, components are drawn over them that are marked.
void BuildingPane::setRanges(const BuildingLook& look) {
  const auto isMarked = [&](std::uint32_t c) {
    return c == look.hover || std::find(look.selected.begin(), look.selected.end(), c) != look.selected.end();
  };
  const bool plain = !look.surfaces && !paintOf(look);
  std::vector<MeshRange> ranges;
  for (const NodeId c : solid_) {
    if (plain || isMarked(c)) ranges.push_back(model_->nodes->ranges[c]);
  }
  prop_->setRanges(CityProp::Buildings, std::move(ranges));
}

void BuildingPane::recolour(const BuildingLook& look) {
  if (look.surfaces || paintOf(look)) setRanges(look);
  std::vector<std::array<std::uint8_t, 4>> colours;
  for (std::size_t c = 0; c < look.colours.size(); ++c) {
    Rgb colour = look.colourComponents ? look.colours[c] : look.palette.building;
    if (look.dark && look.colourComponents) colour = mix(colour, Rgb{0, 0, 0}, 0.2F);
    colours.push_back(bytes(colour, CityProp::kPlain));
  }
  if (look.hover < colours.size())
    colours[look.hover] = bytes(mix(look.colours[look.hover], look.palette.hover, 0.6F), CityProp::kHovered);
  for (const std::uint32_t c : look.selected) {
    if (c < colours.size())
      colours[c] = bytes(mix(look.colours[c], look.palette.selection, 0.55F), CityProp::kSelected);
  }
  for (std::size_t i = 0; around_ && i < around_->buildings.size(); ++i) {
    colours.resize(std::max<std::size_t>(colours.size(), around_->mesh.firstNode + i));
    const TargetFate fate = i < targets_.size() ? targets_[i] : TargetFate::Unseen;
    colours.push_back(
        bytes(targetColour(fate, look.palette), look.target == i ? CityProp::kSelected : CityProp::kPlain));
  }
  // The last entry is that of the context, which is not drawn here.
  colours.push_back(bytes(look.palette.context, CityProp::kPlain));
  prop_->setColours(std::move(colours));
}

void BuildingPane::showGlyphs(const BuildingLook& look) {
  std::array<std::vector<Vec3>, 3> points;
  for (std::size_t c = 0; model_ && !model_->classes.empty() && c < model_->component.size(); ++c) {
    if (!isSolid(look, model_->component[c])) continue;
    const Component& component = model_->mesh->components[c];
    for (std::uint32_t v = component.firstVertex; v < component.endVertex(); ++v) {
      const auto kind = static_cast<std::size_t>(model_->classes[v]);
      if (look.glyphs[kind]) points[kind].push_back(model_->mesh->vertices[v]);
    }
  }
  for (std::size_t kind = 0; kind < points.size(); ++kind) {
    glyphs_[kind].setPoints(points[kind]);
    glyphs_[kind].setVisible(true);
  }
  const std::vector<Vec3> picked = look.picked ? std::vector<Vec3>{*look.picked} : std::vector<Vec3>();
  picked_.setColour(look.palette.selection);
  picked_.setPoints(picked);
  picked_.setVisible(true);
}

/// What is painted has no edges of its own, and one class can be all over it.
void BuildingPane::addCreases(const BuildingLook& look, LineSegments& lines) const {
  for (const NodeId c : solid_) {
    for (std::uint32_t e = model_->creaseStart[c]; e < model_->creaseStart[c + 1]; ++e)
      lines.add(model_->creases[e][0], model_->creases[e][1], look.palette.ink);
  }
}

void BuildingPane::showLines(const BuildingLook& look) {
  LineSegments ghosts;
  LineSegments angles;
  LineSegments planes;
  if (model_ && look.ghosts && !look.isolated.empty()) {
    for (std::uint32_t c = 0; c + 1 < model_->creaseStart.size(); ++c) {
      if (isSolid(look, c)) continue;
      for (std::uint32_t e = model_->creaseStart[c]; e < model_->creaseStart[c + 1]; ++e)
        ghosts.add(model_->creases[e][0], model_->creases[e][1],
                   look.dark ? Rgb{0.7F, 0.75F, 0.8F} : look.palette.ink);
    }
  }
  if (paintOf(look)) addCreases(look, ghosts);
  for (std::size_t i = 0; model_ && look.angles && i < model_->angles.segments.size(); ++i) {
    if (isSolid(look, model_->angleComponent[i]))
      angles.add(model_->angles.segments[i][0], model_->angles.segments[i][1], model_->angles.colours[i]);
  }
  for (const std::array<Vec3, 3>& plane : look.planes) {
    for (std::size_t i = 0; i < 3; ++i) planes.add(plane[i], plane[(i + 1) % 3], look.palette.selection);
  }
  ghosts_.setLines(ghosts);
  ghosts_.setVisible(!ghosts.segments.empty());
  angles_.setLines(angles);
  angles_.setVisible(!angles.segments.empty());
  planes_.setLines(planes);
  planes_.setVisible(!planes.segments.empty());
}

void BuildingPane::setContacts(const std::vector<ContactMark>& marks) {
  std::vector<Vec3> separated;
  std::vector<Vec3> lost;
  std::vector<Vec3> chosen;
  for (const ContactMark& mark : marks) {
    if (mark.fate == ContactFate::Separated) separated.push_back(mark.at);
    if (mark.fate == ContactFate::Lost) lost.push_back(mark.at);
    if (!mark.chosen) continue;
    chosen.push_back(mark.at);
    chosen_.setColour(fateColour(mark.fate));
  }
  separated_.setPoints(separated);
  lost_.setPoints(lost);
  chosen_.setPoints(chosen);
  for (PointOverlay* overlay : {&separated_, &lost_, &chosen_}) overlay->setVisible(true);
}

void BuildingPane::setSurroundings(std::shared_ptr<const Surroundings> around, const BuildingLook& look) {
  around_ = std::move(around);
  targets_.clear();
  std::vector<MeshRange> ranges;
  for (std::size_t i = 0; around_ && i < around_->nodes.size(); ++i)
    ranges.push_back(around_->mesh.ranges[around_->nodes[i] - around_->mesh.firstNode]);
  // Drawn as clusters are: what lies in a wall of the building stands back by a hair.
  prop_->setMesh(CityProp::Clusters,
                 around_ ? std::shared_ptr<const NodeMesh>(around_, &around_->mesh) : nullptr);
  prop_->setRanges(CityProp::Clusters, std::move(ranges));
  recolour(look);
}

void BuildingPane::setTargets(std::vector<TargetFate> fates, const BuildingLook& look) {
  targets_ = std::move(fates);
  recolour(look);
}

void BuildingPane::setSight(const std::optional<SightOptions>& sight, const Palette& palette) {
  sight_.show(sight, palette);
}

void BuildingPane::setGround(double height) {
  prop_->setGround(height, true, true);
  prop_->setHazeDistance(kNoHaze);
}

void BuildingPane::setPixelRatio(double ratio) {
  prop_->setPixelRatio(ratio);
  for (LineOverlay* lines : {&ghosts_, &angles_, &planes_}) lines->setPixelRatio(ratio);
  for (PointOverlay& glyphs : glyphs_) glyphs.setPixelRatio(ratio);
  for (PointOverlay* points : {&picked_, &separated_, &lost_, &chosen_}) points->setPixelRatio(ratio);
  sight_.setPixelRatio(ratio);
}

}  // namespace lodestone
