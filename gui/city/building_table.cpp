#include "gui/city/building_table.h"

#include <QLocale>
#include <QStringList>
#include <algorithm>
#include <cctype>
#include <numeric>

#include "model/exterior.h"

namespace lodestone {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

BuildingTable::BuildingTable(Workspace& workspace, QObject* parent)
    : QAbstractTableModel(parent), workspace_(workspace) {
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.city != after.city) cityChanged();
          });
  connect(&workspace_, &Workspace::cutChanged, this, &BuildingTable::cutChanged);
  connect(&workspace_, &Workspace::diagnosed, this, &BuildingTable::addProblems);
}

int BuildingTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}
int BuildingTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

void BuildingTable::cityChanged() {
  const auto& city = workspace_.state().city;
  areas_.clear();
  polygons_.clear();
  if (city) {
    for (const Building& building : city->buildings) {
      areas_.push_back(area(building.footprint));
      polygons_.push_back(facesOf(building).polygons);
    }
  }
  rebuild();
}

void BuildingTable::cutChanged() {
  const auto& tree = workspace_.state().tree;
  const auto& cut = workspace_.cut();
  drawnCluster_.assign(tree && cut ? tree->nodes.size() : 0, 0);
  if (!drawnCluster_.empty()) {
    for (const DrawnNode& node : cut->drawn)
      drawnCluster_[node.node] = node.role == DrawRole::Cluster ? 1 : 0;
  }
  if (!rows_.empty())
    Q_EMIT dataChanged(index(0, Cluster), index(rowCount() - 1, Cluster), {Qt::DisplayRole});
}

void BuildingTable::addProblems(const Diagnostics& diagnostics) {
  const auto& city = workspace_.state().city;
  if (!city) return;
  std::erase_if(problems_, [](const CityProblems& old) { return old.city.expired(); });
  auto here = std::find_if(problems_.begin(), problems_.end(),
                           [&](const CityProblems& known) { return known.city.lock() == city; });
  if (here == problems_.end()) here = problems_.insert(here, CityProblems{city, {}});
  for (const Diagnostic& d : diagnostics) {
    if (!d.object.empty()) ++here->counts[d.object];
  }
  if (!rows_.empty()) {
    Q_EMIT dataChanged(index(0, Problems), index(rowCount() - 1, Problems), {Qt::DisplayRole});
  }
}

int BuildingTable::problemsOf(NodeId building) const {
  const auto& city = workspace_.state().city;
  const auto here = std::find_if(problems_.begin(), problems_.end(),
                                 [&](const CityProblems& known) { return known.city.lock() == city; });
  if (here == problems_.end()) return 0;
  const auto found = here->counts.find(city->buildings[building].object.id);
  return found == here->counts.end() ? 0 : found->second;
}

NodeId BuildingTable::clusterOf(NodeId building) const {
  const auto& tree = workspace_.state().tree;
  if (!tree || drawnCluster_.size() != tree->nodes.size()) return kNoNode;
  for (NodeId node = building; node != kNoNode; node = tree->nodes[node].parent) {
    if (drawnCluster_[node] != 0) return node;
  }
  return kNoNode;
}

int BuildingTable::rowOf(NodeId building) const {
  return building < rowOf_.size() ? rowOf_[building] : -1;
}

bool BuildingTable::matches(NodeId building) const {
  if (filter_.empty()) return true;
  const CityObject& object = workspace_.state().city->buildings[building].object;
  if (lower(object.id).find(filter_) != std::string::npos) return true;
  return std::any_of(object.attributes.begin(), object.attributes.end(), [&](const auto& entry) {
    return lower(toText(entry.second)).find(filter_) != std::string::npos;
  });
}

void BuildingTable::setFilter(const QString& wanted) {
  filter_ = lower(wanted.trimmed().toStdString());
  rebuild();
}

void BuildingTable::rebuild() {
  beginResetModel();
  rows_.clear();
  for (NodeId i = 0; i < areas_.size(); ++i) {
    if (matches(i)) rows_.push_back(i);
  }
  sortRows();
  endResetModel();
}

double BuildingTable::key(NodeId building) const {
  switch (sortColumn_) {
    case Height:
      return workspace_.state().city->buildings[building].height;
    case Area:
      return areas_[building];
    case Polygons:
      return static_cast<double>(polygons_[building]);
    case Cluster:
      return clusterOf(building);
    case Lods:
      return static_cast<double>(lodsOf(workspace_.state().city->buildings[building].object).size());
    case Problems:
      return problemsOf(building);
    default:
      return building;
  }
}

void BuildingTable::sortRows() {
  if (!workspace_.state().city) return;
  if (sortColumn_ == Id) {
    const auto& buildings = workspace_.state().city->buildings;
    std::stable_sort(rows_.begin(), rows_.end(),
                     [&](NodeId a, NodeId b) { return buildings[a].object.id < buildings[b].object.id; });
  } else if (sortColumn_ >= 0) {
    std::vector<double> keys(areas_.size());
    for (const NodeId building : rows_) keys[building] = key(building);
    std::stable_sort(rows_.begin(), rows_.end(), [&](NodeId a, NodeId b) { return keys[a] < keys[b]; });
  }
  if (sortColumn_ >= 0 && sortOrder_ == Qt::DescendingOrder) std::reverse(rows_.begin(), rows_.end());
  rowOf_.assign(areas_.size(), -1);
  for (std::size_t row = 0; row < rows_.size(); ++row) rowOf_[rows_[row]] = static_cast<std::int32_t>(row);
}

void BuildingTable::sort(int column, Qt::SortOrder order) {
  if (!workspace_.state().city) return;
  Q_EMIT layoutAboutToBeChanged();
  const QModelIndexList before = persistentIndexList();
  std::vector<NodeId> buildings;
  for (const QModelIndex& old : before) buildings.push_back(buildingAt(old.row()));
  sortColumn_ = column;
  sortOrder_ = order;
  sortRows();
  QModelIndexList after;
  for (qsizetype i = 0; i < before.size(); ++i)
    after << index(rowOf(buildings[static_cast<std::size_t>(i)]), before[i].column());
  changePersistentIndexList(before, after);
  Q_EMIT layoutChanged();
}

QVariant BuildingTable::text(NodeId node, int column) const {
  const Building& building = workspace_.state().city->buildings[node];
  const QLocale locale;
  switch (column) {
    case Id:
      return QString::fromStdString(building.object.id);
    case Height:
      return locale.toString(building.height, 'f', 1);
    case Area:
      return locale.toString(areas_[node], 'f', 0);
    case Polygons:
      return locale.toString(static_cast<qulonglong>(polygons_[node]));
    case Lods: {
      QStringList lods;
      for (const std::string& lod : lodsOf(building.object)) lods << QString::fromStdString(lod);
      return lods.isEmpty() ? tr("footprint") : lods.join(QStringLiteral(", "));
    }
    case Cluster: {
      const NodeId cluster = clusterOf(node);
      return cluster == kNoNode ? QString() : locale.toString(cluster);
    }
    default: {
      const int problems = problemsOf(node);
      return problems == 0 ? QString() : locale.toString(problems);
    }
  }
}

QVariant BuildingTable::data(const QModelIndex& index, int role) const {
  if (!index.isValid()) return {};
  if (role == Qt::DisplayRole || (role == Qt::ToolTipRole && index.column() == Id))
    return text(buildingAt(index.row()), index.column());
  if (role == Qt::TextAlignmentRole && index.column() != Id && index.column() != Lods) {
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  }
  return {};
}

QVariant BuildingTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  static const char* const titles[] = {QT_TR_NOOP("Id"),       QT_TR_NOOP("Height"), QT_TR_NOOP("Area"),
                                       QT_TR_NOOP("Polygons"), QT_TR_NOOP("LoDs"),   QT_TR_NOOP("Cluster"),
                                       QT_TR_NOOP("Problems")};
  static const char* const helps[] = {
      QT_TR_NOOP("Id of the building in its file"),
      QT_TR_NOOP("Height above the ground, metres"),
      QT_TR_NOOP("Area of the footprint, square metres"),
      QT_TR_NOOP("Polygons that it is drawn with: wall quads, and triangles of other faces but the ground"),
      QT_TR_NOOP("Levels of detail that the file holds of it"),
      QT_TR_NOOP("Drawn cluster that stands for it at present"),
      QT_TR_NOOP("Messages about it")};
  if (role == Qt::DisplayRole) return tr(titles[section]);
  if (role == Qt::ToolTipRole) return tr(helps[section]);
  return {};
}

}  // namespace lodestone
