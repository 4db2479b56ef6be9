#include "gui/simplification/stage_link.h"

#include <QLocale>
#include <QToolButton>

#include "gui/simplification/components_panel.h"
#include "gui/simplification/stage_legend.h"
#include "gui/simplification/stage_view.h"
#include "gui/view3d/component_colours.h"
#include "gui/widgets/parameter_panel.h"
#include "model/detail_colours.h"

namespace lodestone {
namespace {

/// "topology, a = 2", "perception, stage 2"; `found`: the a of a search that has ended.
QString methodText(const SimplifyOptions& options, std::optional<double> found) {
  QString text;
  for (const Field<SimplifyOptions>& field : fields<SimplifyOptions>()) {
    if (field.name == "method") text = QString::fromStdString(toText(field.get(options)));
  }
  if (needsPerception(options.method)) text += StageLink::tr(", stage %1").arg(options.stage);
  if (needsTopology(options.method))
    text += options.aAuto && !found
                ? StageLink::tr(", a is being found")
                : QStringLiteral(", a = ") + QLocale().toString(found.value_or(options.a));
  return text;
}

/// The original is in the first.
std::size_t paneOf(Stage::Method method) {
  return method == Stage::A ? 1 : 2;
}

QString trianglesText(const ComponentMesh& mesh) {
  return StageLink::tr("%L1 triangles").arg(mesh.triangleCount());
}

}  // namespace

StageLink::StageLink(Stage& stage, StageView& view, ComponentsPanel& components, StageLegend& legend,
                     QObject* parent)
    : QObject(parent), stage_(stage), view_(view), components_(components), legend_(legend) {
  connectStage();
  connectView();
  showPanes();
}

void StageLink::connectStage() {
  for (const auto change : {&Stage::opening, &Stage::closed, &Stage::opened})
    connect(&stage_, change, this, &StageLink::showBuilding);
  connect(&stage_, &Stage::levelChanged, this, &StageLink::showLevel);
  connect(&stage_, &Stage::comparingChanged, this, &StageLink::showPanes);
  connect(&stage_, &Stage::selectionChanged, this, &StageLink::showLook);
  connect(&stage_, &Stage::vertexChanged, this, &StageLink::showLook);
  connect(&stage_, &Stage::contactChanged, this, &StageLink::showContacts);
  connect(&stage_, &Stage::perceptionChanged, this, [this] {
    paintOriginal();
    if (legend_.details().isChecked()) showLook();
  });
  connect(&stage_, &Stage::hoverChanged, this, [this] { view_.scene().setHover(stage_.hover()); });
  connect(&stage_, &Stage::flyRequested, this, [this](const Box3& box) { view_.view().fitTo(box); });
  connect(&components_, &ComponentsPanel::isolateToggled, this, &StageLink::showLook);
  connect(&legend_, &StageLegend::changed, this, [this] {
    showLook();
    showContacts();
  });
}

void StageLink::connectView() {
  connect(&view_.view(), &StageScene::hovered, &stage_, &Stage::setHover);
  connect(&view_.view(), &StageScene::picked, this, [this](const std::optional<PickedPart>& part, bool add) {
    std::vector<std::uint32_t> components = add ? stage_.selection() : std::vector<std::uint32_t>();
    if (part && std::erase(components, part->component) == 0) components.push_back(part->component);
    stage_.pickVertex(part ? part->vertex : std::nullopt);
    stage_.select(std::move(components));
  });
}

void StageLink::show(Show show) {
  show_ = show;
  showPanes();
}

void StageLink::setTheme(SceneTheme theme) {
  theme_ = theme;
  showLook();
}

void StageLink::paintOriginal() {
  details_ = {};
  const auto& seen = stage_.perception();
  if (!seen || !stage_.isOpen()) return;
  const auto painted = std::make_shared<PaintedTriangles>();
  painted->mesh = stage_.staged()->mesh;
  for (std::size_t t = 0; t < seen->classes.size(); ++t)
    painted->colours.push_back(seen->isSeen(t) ? detailColour(seen->classes[t]) : unseenColour());
  details_[0] = painted;
  for (const Stage::Method method : {Stage::A, Stage::B}) paintLevel(method);
}

/// What is left has the colours of the triangles that it comes from.
void StageLink::paintLevel(Stage::Method method) {
  auto& paint = details_[paneOf(method)];
  const auto& level = stage_.level(method);
  if (!level || !details_[0]) return paint.reset();
  if (paint && paint->mesh == level->pane->mesh) return;
  const auto painted = std::make_shared<PaintedTriangles>();
  painted->mesh = level->pane->mesh;
  for (const std::uint32_t t : level->simplified->triangle)
    painted->colours.push_back(details_[0]->colours[t]);
  paint = painted;
}

void StageLink::showBuilding() {
  paintOriginal();
  const auto& staged = stage_.staged();
  const bool same = staged && view_.scene().model(0) &&
                    view_.scene().bounds().min == bounds(*staged->mesh).min &&
                    view_.scene().bounds().max == bounds(*staged->mesh).max;
  view_.scene().setModel(0, staged ? staged->pane : nullptr);
  for (const Stage::Method method : {Stage::A, Stage::B}) showLevel(method);
  showLook();
  if (staged && !same) view_.view().fit();
}

void StageLink::showLevel(Stage::Method method) {
  const auto& level = stage_.level(method);
  const std::size_t pane = paneOf(method);
  const auto now = level ? level->pane : nullptr;
  if (view_.scene().model(pane) != now) {
    view_.scene().setModel(pane, now);
    paintLevel(method);
    if (legend_.details().isChecked()) showLook();
  }
  showContacts();
  showTitles();
}

void StageLink::showContacts() {
  std::vector<ContactMark> all;
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    const auto& level = stage_.level(method);
    std::vector<ContactMark> marks;
    for (std::size_t i = 0; level && level->report && i < level->report->contacts.size(); ++i) {
      const ContactReport& contact = level->report->contacts[i];
      const bool chosen = stage_.contact() == i;
      if (contact.fate != ContactFate::Kept && (chosen || legend_.contacts().isChecked()))
        marks.push_back({contact.at, contact.fate, chosen});
    }
    view_.scene().setContacts(paneOf(method), marks);
    if (method == Stage::A || stage_.comparing()) {
      std::erase_if(marks, [](const ContactMark& mark) { return !mark.chosen; });
      all.insert(all.end(), marks.begin(), marks.end());
    }
  }
  view_.scene().setContacts(0, all);  // of the original only where it is asked for
}

void StageLink::showPanes() {
  std::vector<std::size_t> panes{0};
  if (show_ != Show::Original) panes.push_back(1);
  if (show_ != Show::Original && stage_.comparing()) panes.push_back(2);
  if (show_ == Show::Wipe && panes.size() == 3) panes.erase(panes.begin());  // A against B
  view_.setLayout(show_ == Show::Wipe ? PaneLayout::Wipe : PaneLayout::Side, panes);
  showTitles();
  showContacts();
  // Panes of another shape: what was fitted to them is fitted again, a view that somebody chose stays.
  if (stage_.isOpen() && view_.view().isFitted()) view_.view().fit();
}

void StageLink::showLook() {
  BuildingLook look;
  look.dark = theme_ == SceneTheme::Dark;
  look.palette = look.dark ? darkPalette() : lightPalette();
  look.colourComponents = legend_.components().isChecked();
  for (const VertexClass c : {VertexClass::Ordinary, VertexClass::Boundary, VertexClass::Hole})
    look.glyphs[static_cast<std::size_t>(c)] = legend_.glyphs(c).isChecked();
  look.angles = legend_.angles().isChecked();
  look.hover = stage_.hover();
  look.selected = stage_.selection();
  if (const auto& staged = stage_.staged()) {
    if (legend_.textures().isChecked()) look.surfaces = staged->surfaces;
    for (const auto& paint : details_) {
      if (paint && legend_.details().isChecked()) look.painted.push_back(paint);
    }
    const std::size_t count = staged->mesh->components.size();
    look.colours = componentColours(count, staged->classes->contacts);
    if (components_.isolateButton().isChecked() && !look.selected.empty()) {
      look.isolated.assign(count, false);
      for (const std::uint32_t c : look.selected) look.isolated[c] = true;
      look.selected.clear();  // alone they need no mark
    }
    if (stage_.vertex()) {
      const std::uint32_t vertex = *stage_.vertex();
      look.picked = staged->mesh->vertices[vertex];
      for (std::uint32_t i = staged->classes->planeStart[vertex]; i < staged->classes->planeStart[vertex + 1];
           ++i) {
        const auto& [a, b, c] = staged->mesh->triangles[staged->classes->planes[i]];
        look.planes.push_back(
            {staged->mesh->vertices[a], staged->mesh->vertices[b], staged->mesh->vertices[c]});
      }
    }
  }
  view_.scene().setLook(look);
}

void StageLink::showTitles() {
  const auto& staged = stage_.staged();
  view_.setTitle(0, tr("Original"), staged ? trianglesText(*staged->mesh) : tr("classifying…"));
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    const auto& level = stage_.level(method);
    const QString title = method == Stage::A ? tr("A: %1") : tr("B: %1");
    view_.setTitle(paneOf(method),
                   title.arg(level ? methodText(level->options, level->a)
                                   : methodText(stage_.options(method), std::nullopt)),
                   level ? trianglesText(level->simplified->mesh) : tr("not made yet"));
  }
}

}  // namespace lodestone
