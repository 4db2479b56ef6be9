// Diagnostics as a tree of two levels: equal codes under one row, filtered here.
#pragma once

#include <QAbstractItemModel>
#include <array>
#include <set>
#include <string>
#include <vector>

#include "model/diagnostics.h"

namespace lodestone {

inline constexpr std::size_t kSeverityCount = 3;

/// What of the messages is shown.
struct MessageFilter {
  QString text;  ///< in the code, its title, the object, the place or the text, in any case
  std::array<bool, kSeverityCount> severities{true, true, true};
};

/// A row for each code, the worst first; below it the messages, unless there is but one: then the row is the
/// message. Cost of a filter or of an addition: linear in the messages.
class MessageTree : public QAbstractItemModel {
  Q_OBJECT

 public:
  enum Column { TextColumn, CountColumn, ObjectColumn, AdviceColumn, ColumnCount };

  using QAbstractItemModel::QAbstractItemModel;
  /// What is for information is told once: clustering again says the same of barriers again.
  void append(const Diagnostics& diagnostics);
  void clear();
  /// Another model: what was told of the one before is told again.
  void startAnew() { told_.clear(); }
  void setFilter(const MessageFilter& filter);
  [[nodiscard]] const Diagnostics& all() const { return diagnostics_; }
  /// How many there are, whatever the filter hides.
  [[nodiscard]] std::size_t count(Severity severity) const {
    return counts_[static_cast<std::size_t>(severity)];
  }
  /// Ids of the objects that a row and those below it are about.
  [[nodiscard]] std::set<std::string> objectsOf(const QModelIndex& index) const;
  [[nodiscard]] QModelIndex groupOf(Code code) const;
  [[nodiscard]] Code codeOf(const QModelIndex& index) const { return groupAt(index).code; }

  [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
  [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
  [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
  [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
  [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 Q_SIGNALS:
  void countsChanged();

 private:
  struct Group {
    Code code;
    Severity severity;
    std::vector<std::size_t> shown;  ///< of diagnostics_
  };
  void regroup();
  [[nodiscard]] bool matches(const Diagnostic& diagnostic) const;
  /// The one message of a row; null for a row that has several below it.
  [[nodiscard]] const Diagnostic* messageAt(const QModelIndex& index) const;
  [[nodiscard]] const Group& groupAt(const QModelIndex& index) const;
  [[nodiscard]] QVariant groupText(const Group& group, int column) const;
  [[nodiscard]] static QVariant messageText(const Diagnostic& message, int column, bool below);

  Diagnostics diagnostics_;
  std::array<std::size_t, kSeverityCount> counts_{};
  std::vector<Group> groups_;  ///< that are shown
  MessageFilter filter_;
  std::set<std::string> told_;
};

}  // namespace lodestone
