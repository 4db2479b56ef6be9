#include "gui/city/selection_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <map>

#include "gui/widgets/icons.h"
#include "model/exterior.h"

namespace lodestone {
namespace {

QString metres(double value) {
  return QLocale().toString(value, 'f', 2) + QStringLiteral(" m");
}
QString squareMetres(double value) {
  return QLocale().toString(value, 'f', 1) + QStringLiteral(" m²");
}
QString whole(std::uint64_t value) {
  return QLocale().toString(static_cast<qulonglong>(value));
}

QString heightSourceText(HeightSource source) {
  switch (source) {
    case HeightSource::None:
      return {};
    case HeightSource::Geometry:
      return SelectionPanel::tr("from geometry");
    case HeightSource::Attribute:
      return SelectionPanel::tr("from an attribute");
    case HeightSource::Floors:
      return SelectionPanel::tr("from floors");
    case HeightSource::Constant:
      return SelectionPanel::tr("as given at import");
    case HeightSource::Default:
      return SelectionPanel::tr("default");
  }
  return {};
}

}  // namespace

SelectionPanel::SelectionPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      title_(new QLabel(this)),
      parent_(new QToolButton(this)),
      fly_(new QToolButton(this)),
      tree_(new QTreeWidget(this)) {
  title_->setTextFormat(Qt::PlainText);
  title_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  title_->setWordWrap(true);
  parent_->setIcon(icon(QStringLiteral("cluster")));
  parent_->setToolTip(tr("Select the cluster above"));
  parent_->setAutoRaise(true);
  fly_->setIcon(icon(QStringLiteral("fly")));
  fly_->setToolTip(tr("Fly there"));
  fly_->setAutoRaise(true);
  tree_->setColumnCount(2);
  tree_->setHeaderLabels({tr("Property"), tr("Value")});
  tree_->setRootIsDecorated(false);
  tree_->setAlternatingRowColors(true);
  tree_->setIndentation(fontMetrics().averageCharWidth());
  tree_->header()->resizeSection(0, fontMetrics().averageCharWidth() * 20);
  tree_->setUniformRowHeights(true);

  auto* top = new QHBoxLayout;
  top->addWidget(title_, 1);
  top->addWidget(parent_);
  top->addWidget(fly_);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addLayout(top);
  layout->addWidget(tree_, 1);
  layout->addStretch();  // keeps the title at the top while there is no tree

  connect(parent_, &QToolButton::clicked, this, &SelectionPanel::selectParent);
  connect(fly_, &QToolButton::clicked, this, [this] {
    if (!workspace_.selection().empty()) workspace_.flyTo(workspace_.selection().front());
  });
  connect(&workspace_, &Workspace::selectionChanged, this, &SelectionPanel::refresh);
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.city != after.city || before.tree != after.tree) refresh();
          });
  refresh();
}

void SelectionPanel::selectParent() {
  if (workspace_.selection().size() != 1 || !workspace_.state().tree) return;
  const NodeId parent = workspace_.state().tree->nodes[workspace_.selection().front()].parent;
  if (parent != kNoNode) workspace_.select({parent});
}

void SelectionPanel::refresh() {
  tree_->clear();
  const auto& nodes = workspace_.selection();
  const auto& state = workspace_.state();
  const bool one = nodes.size() == 1 && state.city != nullptr;
  fly_->setEnabled(!nodes.empty() && state.city);
  parent_->setEnabled(one && state.tree && state.tree->nodes[nodes.front()].parent != kNoNode);
  tree_->setVisible(one);
  QFont weight = title_->font();
  weight.setBold(!nodes.empty() && state.city);
  title_->setFont(weight);
  if (nodes.empty() || !state.city) {
    title_->setText(tr("Nothing is selected. Click a building in the view, or a row of Objects."));
  } else if (!one) {
    title_->setText(tr("%L1 objects selected").arg(nodes.size()));
  } else {
    title_->setText(workspace_.nameOf(nodes.front()));
    if (nodes.front() < state.city->buildings.size()) {
      showBuilding(nodes.front());
    } else {
      showCluster(nodes.front());
    }
  }
}

QTreeWidgetItem* SelectionPanel::group(const QString& title) {
  auto* item = new QTreeWidgetItem(tree_, {title});
  QFont bold = tree_->font();
  bold.setBold(true);
  item->setFont(0, bold);
  item->setFirstColumnSpanned(true);
  item->setExpanded(true);
  return item;
}

void SelectionPanel::add(QTreeWidgetItem* group, const QString& name, const QString& value) {
  auto* item = new QTreeWidgetItem(group, {name, value});
  item->setToolTip(1, value);
}

void SelectionPanel::addFaces(QTreeWidgetItem* group, const FaceCount& faces) {
  add(group, tr("Polygons"), whole(faces.polygons));
  add(group, tr("Triangles"), whole(faces.triangles));
}

void SelectionPanel::showBuilding(NodeId node) {
  const Building& building = workspace_.state().city->buildings[node];
  QTreeWidgetItem* shape = group(tr("Shape"));
  add(shape, tr("Height"),
      QStringLiteral("%1 (%2)").arg(metres(building.height), heightSourceText(building.heightSource)));
  add(shape, tr("Ground"), metres(building.base));
  add(shape, tr("Footprint"), squareMetres(area(building.footprint)));
  addFaces(shape, facesOf(building));
  std::map<std::string, std::size_t> surfaces;
  std::size_t parts = 0;
  forEachObject(building.object, [&](const CityObject& object) {
    ++parts;
    for (const Geometry& geometry : object.geometries) {
      for (const SurfaceInfo& surface : geometry.surfaces)
        ++surfaces["LoD " + geometry.lod + " " + toString(surface.type)];
    }
  });
  if (parts > 1) add(shape, tr("Parts"), whole(parts - 1));
  if (!surfaces.empty()) {
    QTreeWidgetItem* list = group(tr("Surfaces"));
    for (const auto& [name, count] : surfaces) add(list, QString::fromStdString(name), whole(count));
  }
  if (!building.object.attributes.empty()) {
    QTreeWidgetItem* list = group(tr("Attributes"));
    for (const auto& [name, value] : building.object.attributes) {
      add(list, QString::fromStdString(name), QString::fromStdString(toText(value)));
    }
  }
  if (building.source < workspace_.state().city->sources.size()) {
    add(group(tr("Source")), tr("File"),
        QString::fromStdString(workspace_.state().city->sources[building.source].path));
  }
}

void SelectionPanel::showCluster(NodeId node) {
  const ClusterTree& tree = *workspace_.state().tree;
  const ClusterNode& cluster = tree.nodes[node];
  const Merge& merge = tree.dendrogram->merge(node);
  QTreeWidgetItem* shape = group(tr("Merged hull"));
  add(shape, tr("Buildings"), whole(cluster.size));
  add(shape, tr("Edges"), whole(cluster.edges));
  add(shape, tr("Area"), squareMetres(cluster.area));
  add(shape, tr("Negative space"), squareMetres(cluster.negative));
  add(shape, tr("Height"), metres(cluster.height));
  add(shape, tr("Tallest building"), metres(cluster.maxTop - cluster.base));
  addFaces(shape, cluster.faces);
  QTreeWidgetItem* list = group(tr("Merge"));
  add(list, tr("Distance"), metres(merge.distance));
  add(list, tr("Weight"), QLocale().toString(merge.weight, 'g', 5));
  add(list, tr("Cost, Eq. (1)"), QLocale().toString(merge.cost, 'g', 5));
  add(list, tr("Node"), whole(node));
  add(list, tr("Children"),
      QStringLiteral("%1 + %2").arg(whole(tree.nodes[merge.a].size), whole(tree.nodes[merge.b].size)));
}

}  // namespace lodestone
