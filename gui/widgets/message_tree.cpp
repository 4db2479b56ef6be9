#include "gui/widgets/message_tree.h"

#include <algorithm>

#include "gui/widgets/icons.h"

namespace lodestone {
namespace {

constexpr quintptr kTop = 0;  // internal id of a group's row; of a message's: its group's row + 1

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

/// "211  footprint is the projected outline"
QString titleOf(Code code) {
  return QStringLiteral("%1  %2").arg(static_cast<int>(code)).arg(text(info(code).title));
}

/// The particulars alone, where the title stands above them.
QString detailOf(const Diagnostic& message) {
  const std::string prefix = std::string(info(message.code).title) + ": ";
  return text(message.text.starts_with(prefix) ? std::string_view(message.text).substr(prefix.size())
                                               : std::string_view(message.text));
}

}  // namespace

void MessageTree::append(const Diagnostics& diagnostics) {
  const std::size_t before = diagnostics_.size();
  for (const Diagnostic& d : diagnostics) {
    if (d.severity == Severity::Info && !told_.insert(format(d)).second) continue;
    diagnostics_.push_back(d);
    ++counts_[static_cast<std::size_t>(d.severity)];
  }
  if (diagnostics_.size() > before) regroup();
}

void MessageTree::clear() {
  diagnostics_.clear();
  counts_ = {};
  told_.clear();
  regroup();
}

void MessageTree::setFilter(const MessageFilter& filter) {
  filter_ = filter;
  regroup();
}

bool MessageTree::matches(const Diagnostic& d) const {
  if (!filter_.severities[static_cast<std::size_t>(d.severity)]) return false;
  if (filter_.text.isEmpty()) return true;
  const auto has = [this](const QString& in) { return in.contains(filter_.text, Qt::CaseInsensitive); };
  return has(titleOf(d.code)) || has(text(d.object)) || has(text(d.text)) || has(text(d.place));
}

void MessageTree::regroup() {
  beginResetModel();
  groups_.clear();
  for (std::size_t i = 0; i < diagnostics_.size(); ++i) {
    const Diagnostic& d = diagnostics_[i];
    if (!matches(d)) continue;
    auto group = std::find_if(groups_.begin(), groups_.end(),
                              [&](const Group& g) { return g.code == d.code && g.severity == d.severity; });
    if (group == groups_.end()) group = groups_.insert(group, {d.code, d.severity, {}});
    group->shown.push_back(i);
  }
  std::stable_sort(groups_.begin(), groups_.end(),
                   [](const Group& a, const Group& b) { return a.severity > b.severity; });
  endResetModel();
  Q_EMIT countsChanged();
}

const MessageTree::Group& MessageTree::groupAt(const QModelIndex& index) const {
  const bool top = index.internalId() == kTop;
  return groups_[top ? static_cast<std::size_t>(index.row()) : index.internalId() - 1];
}

const Diagnostic* MessageTree::messageAt(const QModelIndex& index) const {
  const Group& group = groupAt(index);
  if (index.internalId() != kTop) return &diagnostics_[group.shown[static_cast<std::size_t>(index.row())]];
  return group.shown.size() == 1 ? &diagnostics_[group.shown.front()] : nullptr;
}

std::set<std::string> MessageTree::objectsOf(const QModelIndex& index) const {
  std::set<std::string> objects;
  const auto add = [&objects](const Diagnostic& d) {
    if (!d.object.empty()) objects.insert(d.object);
  };
  if (const Diagnostic* message = messageAt(index)) {
    add(*message);
  } else {
    for (const std::size_t i : groupAt(index).shown) add(diagnostics_[i]);
  }
  return objects;
}

QModelIndex MessageTree::groupOf(Code code) const {
  const auto found =
      std::find_if(groups_.begin(), groups_.end(), [&](const Group& g) { return g.code == code; });
  return found == groups_.end() ? QModelIndex() : index(static_cast<int>(found - groups_.begin()), 0);
}

QModelIndex MessageTree::index(int row, int column, const QModelIndex& parent) const {
  if (!hasIndex(row, column, parent)) return {};
  return createIndex(row, column, parent.isValid() ? static_cast<quintptr>(parent.row()) + 1 : kTop);
}

QModelIndex MessageTree::parent(const QModelIndex& index) const {
  if (!index.isValid() || index.internalId() == kTop) return {};
  return createIndex(static_cast<int>(index.internalId() - 1), 0, kTop);
}

int MessageTree::rowCount(const QModelIndex& parent) const {
  if (!parent.isValid()) return static_cast<int>(groups_.size());
  if (parent.internalId() != kTop || parent.column() != 0) return 0;
  const std::size_t messages = groupAt(parent).shown.size();
  return messages == 1 ? 0 : static_cast<int>(messages);
}

int MessageTree::columnCount(const QModelIndex&) const {
  return ColumnCount;
}

QVariant MessageTree::groupText(const Group& group, int column) const {
  switch (column) {
    case TextColumn:
      return titleOf(group.code);
    case CountColumn:
      return tr("%L1").arg(group.shown.size());
    case AdviceColumn:
      return text(info(group.code).advice);
    default:
      return {};
  }
}

QVariant MessageTree::messageText(const Diagnostic& message, int column, bool below) {
  if (column == ObjectColumn) return text(message.object);
  if (column == AdviceColumn && !below) return text(info(message.code).advice);
  if (column != TextColumn) return {};
  QString said = below ? detailOf(message)
                       : QStringLiteral("%1  %2").arg(static_cast<int>(message.code)).arg(text(message.text));
  if (!message.place.empty()) said += QStringLiteral("  (%1)").arg(text(message.place));
  return said;
}

QVariant MessageTree::data(const QModelIndex& index, int role) const {
  const Diagnostic* message = messageAt(index);
  const Group& group = groupAt(index);
  const bool below = index.internalId() != kTop;
  if (role == Qt::DecorationRole && index.column() == TextColumn && !below)
    return icon(QString::fromLatin1(toString(group.severity)));
  if (role == Qt::TextAlignmentRole && index.column() == CountColumn)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole) return message ? text(format(*message)) : text(info(group.code).advice);
  if (role != Qt::DisplayRole) return {};
  return message ? messageText(*message, index.column(), below) : groupText(group, index.column());
}

QVariant MessageTree::headerData(int section, Qt::Orientation orientation, int role) const {
  if (role == Qt::TextAlignmentRole && section == CountColumn)
    return QVariant(Qt::AlignRight | Qt::AlignVCenter);
  if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
  static const char* const titles[] = {QT_TR_NOOP("Message"), QT_TR_NOOP("Count"), QT_TR_NOOP("Object"),
                                       QT_TR_NOOP("What to do")};
  return tr(titles[section]);
}

}  // namespace lodestone
