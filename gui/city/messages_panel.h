// What the program has to say, one row a code; selecting a message selects its building.
#pragma once

#include <QWidget>

#include "gui/widgets/message_tree.h"
#include "gui/workspace/workspace.h"

class QLineEdit;
class QToolButton;
class QTreeView;

namespace lodestone {

class MessagesPanel : public QWidget {
  Q_OBJECT

 public:
  explicit MessagesPanel(Workspace& workspace, QWidget* parent = nullptr);
  [[nodiscard]] const Diagnostics& messages() const { return model_->all(); }

 Q_SIGNALS:
  /// Something that a person should not miss was added.
  void errorAdded();
  /// Of errors and warnings.
  void troublesCounted(std::size_t count);

 private:
  QWidget* makeBar();
  void makeView();
  void tell(const Diagnostics& diagnostics);
  void filter();
  void showCounts();
  /// Buildings of what is selected; none, where that is too many to look at.
  [[nodiscard]] std::vector<NodeId> selectedBuildings() const;

  Workspace& workspace_;
  MessageTree* model_;
  QTreeView* view_;
  QLineEdit* text_;
  std::array<QToolButton*, kSeverityCount> severities_{};
  std::set<Code> expanded_;  ///< the model forgets its rows when it is filtered
};

}  // namespace lodestone
