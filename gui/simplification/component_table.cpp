#include "gui/simplification/component_table.h"

#include <QColor>
#include <QLocale>
#include <algorithm>
#include <optional>

#include "gui/simplification/class_icon.h"
#include "gui/view3d/component_colours.h"

namespace lodestone {
namespace {

/// Of the columns that count vertices.
std::optional<VertexClass> classOf(int column) {
  switch (column) {
    case ComponentTable::Boundary:
      return VertexClass::Boundary;
    case ComponentTable::Hole:
      return VertexClass::Hole;
    case ComponentTable::Ordinary:
      return VertexClass::Ordinary;
    default:
      return std::nullopt;
  }
}

}  // namespace

ComponentTable::ComponentTable(Stage& stage, QObject* parent) : QAbstractTableModel(parent), stage_(stage) {
  for (const auto change : {&Stage::opening, &Stage::opened, &Stage::closed})
    connect(&stage_, change, this, &ComponentTable::rebuild);
}

int ComponentTable::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}
int ComponentTable::columnCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : ColumnCount;
}

QString ComponentTable::source(std::uint32_t component) const {
  const ComponentMesh& mesh = *stage_.staged()->mesh;
  return QString::fromStdString(mesh.objects[mesh.components[component].object].id);
}

std::uint32_t ComponentTable::figure(std::uint32_t component, int column) const {
  const StagedBuilding& staged = *stage_.staged();
  if (const std::optional<VertexClass> counted = classOf(column))
    return staged.counts[component].vertices[static_cast<std::size_t>(*counted)];
  return column == Triangles ? staged.mesh->components[component].triangleCount : component;
}

QVariant ComponentTable::data(const QModelIndex& index, int role) const {
  const std::uint32_t component = componentAt(index.row());
  if (role == Qt::TextAlignmentRole && index.column() > Source)
    return static_cast<int>(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::DecorationRole && index.column() == Number) {
    const Rgb& colour = colours_[component];
    return QColor::fromRgbF(colour[0], colour[1], colour[2]);
  }
  if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
  if (index.column() == Source) return source(component);
  return QLocale().toString(figure(component, index.column()));
}

int ComponentTable::widestRow(int column) const {
  const auto widest = std::max_element(rows_.begin(), rows_.end(), [&](std::uint32_t a, std::uint32_t b) {
    return figure(a, column) < figure(b, column);
  });
  return widest == rows_.end() ? -1 : static_cast<int>(widest - rows_.begin());
}

QVariant ComponentTable::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  static const char* const titles[] = {QT_TR_NOOP("Nr."),      QT_TR_NOOP("Source"), QT_TR_NOOP("Tri."),
                                       QT_TR_NOOP("Boundary"), QT_TR_NOOP("Hole"),   QT_TR_NOOP("Ordinary")};
  static const char* const helps[] = {
      QT_TR_NOOP("Component, in its colour of the view: triangles that vertices connect"),
      QT_TR_NOOP("Group, node or part that it comes from"),
      QT_TR_NOOP("Triangles of the original"),
      QT_TR_NOOP(
          "Boundary vertices: they lie inside another component or on it, and hold the building together"),
      QT_TR_NOOP("Hole vertices: at the end of an edge with one triangle, touching nothing"),
      QT_TR_NOOP("Ordinary vertices: all others")};
  const std::optional<VertexClass> counted = classOf(section);
  if (role == Qt::DecorationRole && counted) return classIcon(*counted);
  if (role == Qt::AccessibleTextRole || (role == Qt::DisplayRole && !counted)) return tr(titles[section]);
  if (role == Qt::ToolTipRole) return tr(helps[section]);
  return {};
}

void ComponentTable::rebuild() {
  beginResetModel();
  rows_.clear();
  colours_.clear();
  if (stage_.isOpen()) {
    const auto count = static_cast<std::uint32_t>(stage_.staged()->mesh->components.size());
    colours_ = componentColours(count, stage_.staged()->classes->contacts);
    for (std::uint32_t c = 0; c < count; ++c) {
      if (filter_.isEmpty() || source(c).contains(filter_, Qt::CaseInsensitive) ||
          QString::number(c).contains(filter_))
        rows_.push_back(c);
    }
    sortRows();
  }
  endResetModel();
}

void ComponentTable::sort(int column, Qt::SortOrder order) {
  sortColumn_ = column;
  sortOrder_ = order;
  rebuild();
}

void ComponentTable::sortRows() {
  if (sortColumn_ < 0) return;
  std::stable_sort(rows_.begin(), rows_.end(), [this](std::uint32_t a, std::uint32_t b) {
    if (sortOrder_ == Qt::DescendingOrder) std::swap(a, b);
    if (sortColumn_ == Source) return source(a).localeAwareCompare(source(b)) < 0;
    return figure(a, sortColumn_) < figure(b, sortColumn_);
  });
}

void ComponentTable::setFilter(const QString& text) {
  filter_ = text.trimmed();
  rebuild();
}

int ComponentTable::rowOf(std::uint32_t component) const {
  const auto found = std::find(rows_.begin(), rows_.end(), component);
  return found == rows_.end() ? -1 : static_cast<int>(found - rows_.begin());
}

}  // namespace lodestone
