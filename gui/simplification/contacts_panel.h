// The contacts that a method separated or lost; a double-click flies there.
#pragma once

#include <QWidget>

#include "gui/simplification/stage.h"

class QLabel;
class QTableWidget;

namespace lodestone {

class ContactsPanel : public QWidget {
  Q_OBJECT

 public:
  explicit ContactsPanel(Stage& stage, QWidget* parent = nullptr);

 private:
  void showContacts();
  void showFate(int row, int column, const SimplifyReport* report, std::size_t contact);
  [[nodiscard]] const SimplifyReport* reportOf(Stage::Method method) const;
  void showChosen();

  Stage& stage_;
  QTableWidget* table_;
  QLabel* none_;
};

}  // namespace lodestone
