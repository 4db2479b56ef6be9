#include "gui/simplification/vertex_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "gui/widgets/counted.h"
#include "gui/widgets/metres.h"

namespace lodestone {
namespace {

QString degrees(double angle) {
  return QLocale().toString(angle, 'f', 1) + QStringLiteral("°");
}

QString className(VertexClass vertexClass) {
  switch (vertexClass) {
    case VertexClass::Boundary:
      return VertexPanel::tr("Boundary vertex");
    case VertexClass::Hole:
      return VertexPanel::tr("Hole vertex");
    case VertexClass::Ordinary:
      break;
  }
  return VertexPanel::tr("Ordinary vertex");
}

QString ruleText(InsideRule rule) {
  switch (rule) {
    case InsideRule::Solid:
      return VertexPanel::tr("a ray from it crosses the closed component an odd number of times");
    case InsideRule::Normal:
      return VertexPanel::tr("the angle of the edge with the normal of the triangle that it meets is acute");
    case InsideRule::Touch:
      return VertexPanel::tr("it lies on the other component");
    case InsideRule::Lengthened:
      return VertexPanel::tr("the edge meets the component where it was lengthened at this end");
  }
  return {};
}

QString whyBoundary(const VertexAccount& account, const Classification& classes) {
  const auto makesBoundary = [&](bool passesThrough) {
    return std::any_of(account.meetings.begin(), account.meetings.end(), [&](const Meeting& meeting) {
      return meeting.inside && classes.edges[meeting.edge].passesThrough == passesThrough;
    });
  };
  if (makesBoundary(false))
    return VertexPanel::tr("Its edges meet other components, and this end lies inside them or on them.");
  if (makesBoundary(true))
    return VertexPanel::tr(
        "An edge of it passes through another component. Both its ends are held, wherever they "
        "lie: without them that edge would leave the component.");
  return VertexPanel::tr(
      "It is a corner of a flat face that another component stands in or on: the edge across from "
      "it passes through that component. Without it the face would leave the component.");
}

QString whyText(const VertexAccount& account, const Classification& classes) {
  if (account.vertexClass == VertexClass::Boundary) return whyBoundary(account, classes);
  if (account.vertexClass == VertexClass::Hole)
    return VertexPanel::tr("It ends an edge that has one triangle alone, and it touches no other component.");
  if (!account.meetings.empty())
    return VertexPanel::tr("Its edges meet other components, but it is their other end that lies inside.");
  return VertexPanel::tr("None of its edges meets another component or ends a sheet.");
}

}  // namespace

VertexPanel::VertexPanel(Stage& stage, QWidget* parent)
    : QWidget(parent),
      stage_(stage),
      title_(new QLabel(this)),
      why_(new QLabel(this)),
      tree_(new QTreeWidget(this)) {
  for (QLabel* label : {title_, why_}) {
    label->setWordWrap(true);
    label->setMinimumWidth(1);  // a long name must not widen the dock
    label->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  }
  tree_->setObjectName(QStringLiteral("vertexTree"));
  tree_->setColumnCount(3);
  tree_->setHeaderLabels({tr("What"), tr("E–C"), tr("Value")});
  tree_->headerItem()->setToolTip(
      1, tr("E–C angle: between the edge and the plane of the component that it meets"));
  tree_->setAlternatingRowColors(true);
  tree_->setIndentation(fontMetrics().averageCharWidth());
  tree_->setUniformRowHeights(true);
  tree_->setRootIsDecorated(false);
  tree_->setTextElideMode(Qt::ElideMiddle);
  tree_->header()->setStretchLastSection(false);  // values are whole, what they are of has the rest
  tree_->header()->setSectionResizeMode(QHeaderView::ResizeToContents);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(title_);
  layout->addWidget(why_);
  layout->addWidget(tree_, 1);
  layout->addStretch();
  for (const auto change : {&Stage::opened, &Stage::closed, &Stage::vertexChanged})
    connect(&stage_, change, this, &VertexPanel::refresh);
  connect(&stage_, &Stage::optionsChanged, this, [this] {
    SimplifyOptions now = stage_.options(Stage::A);
    now.rate = priced_.rate;  // costs do not depend on it, and its slider moves fast
    if (now != priced_) refresh();
  });
  connect(&stage_, &Stage::perceptionChanged, this, &VertexPanel::refresh);
  refresh();
}

QString VertexPanel::nameOf(std::uint32_t component) const {
  const ComponentMesh& mesh = *stage_.staged()->mesh;
  return tr("component %1 (%2)")
      .arg(component)
      .arg(QString::fromStdString(mesh.objects[mesh.components[component].object].id));
}

QTreeWidgetItem* VertexPanel::group(const QString& title) {
  auto* item = new QTreeWidgetItem(tree_, {title});
  QFont bold = tree_->font();
  bold.setBold(true);
  item->setFont(0, bold);
  item->setFirstColumnSpanned(true);
  item->setExpanded(true);
  return item;
}

void VertexPanel::add(QTreeWidgetItem* group, const QStringList& texts, const QString& help) {
  auto* item = new QTreeWidgetItem(group, texts);
  for (int column = 0; column < texts.size(); ++column)
    item->setToolTip(column, help.isEmpty() ? texts[column] : help);
}

void VertexPanel::refresh() {
  tree_->clear();
  const bool any = stage_.isOpen() && stage_.vertex();
  tree_->setVisible(any);
  why_->setVisible(any);
  QFont weight = title_->font();
  weight.setBold(any);
  title_->setFont(weight);
  if (!any) {
    title_->setText(tr("Click a vertex in the view to see what it is and why."));
    return;
  }
  const StagedBuilding& staged = *stage_.staged();
  const std::uint32_t vertex = *stage_.vertex();
  priced_ = stage_.options(Stage::A);
  const auto& perception = stage_.perception();
  const auto& level = stage_.level(Stage::A);
  const bool isMade =
      level && level->perception && level->perception == perception && level->options == priced_;
  Admission admission;
  if (isMade)
    admission = level->admission;  // what settling took back stays as well
  else if (perception && needsPerception(priced_.method))
    admission = admissionOf(*staged.mesh, *perception, priced_);
  const VertexAccount account = accountOf(*staged.mesh, *staged.classes, priced_, vertex, admission);
  title_->setText(tr("%1 %2 of %3")
                      .arg(className(account.vertexClass))
                      .arg(vertex)
                      .arg(nameOf(componentOfVertex(*staged.mesh, vertex))));
  why_->setText(whyText(account, *staged.classes) +
                (account.held ? QLatin1Char(' ') + tr("It stays where it is: a triangle around it is not "
                                                      "admitted at this stage.")
                              : QString()));
  showMeetings(account);
  showPlanes(account);
  showMoves(account);
  QTreeWidgetItem* about = group(tr("Around it"));
  const Vec3& at = staged.mesh->vertices[vertex];
  const QString axes[] = {tr("Position x"), tr("Position y"), tr("Position z")};
  for (int axis = 0; axis < 3; ++axis)
    add(about, {axes[axis], {}, QLocale().toString(at[axis], 'f', 3) + QStringLiteral(" m")});
  add(about, {tr("Area"), {}, QLocale().toString(account.area, 'g', 4) + QStringLiteral(" m²")});
  add(about, {tr("At an open rim"), {}, account.onHoleEdge ? tr("yes") : tr("no")});
}

void VertexPanel::showMeetings(const VertexAccount& account) {
  if (account.meetings.empty()) return;
  QTreeWidgetItem* list = group(tr("Edges that meet other components"));
  const auto& edges = stage_.staged()->classes->edges;
  for (const Meeting& meeting : account.meetings) {
    const BoundaryEdge& edge = edges[meeting.edge];
    QStringList triangles;
    for (const std::uint32_t t : edge.triangles) triangles << QString::number(t);
    const QString inside =
        meeting.inside ? (edge.passesThrough ? tr("passes through") : tr("inside")) : tr("outside");
    const QString said = meeting.inside && edge.passesThrough ? tr("through") : inside;
    const QString help =
        tr("Edge %1–%2 meets %3 of %4: %5. This end is %6%7.")
            .arg(edge.from)
            .arg(edge.to)
            .arg(counted(edge.triangles.size(), tr("triangle"), tr("triangles")))
            .arg(nameOf(edge.other), triangles.join(QStringLiteral(", ")), inside,
                 meeting.inside && !edge.passesThrough ? QStringLiteral(": ") + ruleText(edge.rule)
                                                       : QString());
    add(list,
        {tr("%1–%2, comp. %3").arg(edge.from).arg(edge.to).arg(edge.other), degrees(meeting.angle),
         tr("%1 tri., %2").arg(edge.triangles.size()).arg(said)},
        help);
  }
}

void VertexPanel::showPlanes(const VertexAccount& account) {
  if (account.planes.empty()) return;
  QTreeWidgetItem* list = group(tr("Reference planes (%1)").arg(account.planes.size()));
  const ComponentMesh& mesh = *stage_.staged()->mesh;
  for (const std::uint32_t t : account.planes) {
    const Vec3 normal = areaNormal(mesh, t).normalized();
    const auto part = [&](int axis) { return QString::number(normal[axis], 'f', 2); };
    add(list, {tr("triangle %1").arg(t), {}, QStringLiteral("(%1, %2, %3)").arg(part(0), part(1), part(2))},
        tr("Triangle %1 of %2, and its normal").arg(t).arg(nameOf(componentOfTriangle(mesh, t))));
  }
}

void VertexPanel::showMoves(const VertexAccount& account) {
  QTreeWidgetItem* list = group(tr("Cost of moving it, the cheapest first"));
  for (const MoveCost& move : account.moves) {
    const bool boundary = account.vertexClass == VertexClass::Boundary;
    add(list,
        {tr("to %1, %2").arg(move.to).arg(metresText(move.length)),
         boundary ? degrees(move.angle) : QString(),
         std::isinf(move.cost) ? tr("never") : QLocale().toString(move.cost, 'g', 4)},
        move.perceived
            ? tr("Cost of contracting it with vertex %1 before any other, in m³: φ = %2, at least %3, times "
                 "Cost_G = %4 (Du, Zhu and Zhao, Eq. (3) to (6))")
                  .arg(move.to)
                  .arg(move.perceived->phi, 0, 'g', 3)
                  .arg(kLeastPhi)
                  .arg(move.perceived->geometry, 0, 'g', 3)
            : tr("Cost of the collapse onto vertex %1 before any other, in m⁴: with the options of method A")
                  .arg(move.to));
  }
}

}  // namespace lodestone
