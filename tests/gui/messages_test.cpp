// Messages: grouped, filtered, and leading to their buildings.
#include <QLineEdit>
#include <QToolButton>
#include <QTreeView>

#include "gui/widgets/message_tree.h"
#include "tests/gui/project_support.h"

namespace lodestone {
namespace {

Diagnostics sameOfMany(Code code, int count) {
  Diagnostics many;
  for (int i = 0; i < count; ++i) many.push_back(diagnose(code, {}, "b" + std::to_string(i)));
  return many;
}

QString textAt(const MessageTree& tree, const QModelIndex& row, MessageTree::Column column) {
  return tree.data(row.siblingAtColumn(column), Qt::DisplayRole).toString();
}

}  // namespace

class MessagesTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void informationIsToldOnce();
  void equalCodesAreOneRow();
  void theFilterFindsCodesObjectsAndTexts();
  void everyRowKnowsItsParent();
  void selectingAMessageSelectsItsBuilding();
  void whatIsHiddenComesBackAsItWas();
  void messagesGoWithTheirProject();
  void manyMessagesStayQuick();
};

void MessagesTest::informationIsToldOnce() {
  MessageTree tree;
  const Diagnostic roads = diagnose(Code::BarriersTaken, "873 roads");
  const Diagnostic error = diagnose(Code::ProjectBad, "town.lodestone");
  tree.append({roads, error});
  tree.append({roads, error, diagnose(Code::BarriersTaken, "12 roads")});
  QCOMPARE(tree.all().size(), std::size_t{4});
  QCOMPARE(tree.all()[2].code, Code::ProjectBad);
  tree.clear();
  tree.append({roads});
  QCOMPARE(tree.all().size(), std::size_t{1});
}

void MessagesTest::equalCodesAreOneRow() {
  MessageTree tree;
  tree.append(sameOfMany(Code::FootprintFromOutline, 373));
  tree.append({diagnose(Code::ProjectBad, "town.lodestone"), diagnose(Code::RingTooShort, "2 points", "b7")});
  QCOMPARE(tree.rowCount(), 3);
  // The worst first; one message is its own row.
  QCOMPARE(tree.codeOf(tree.index(0, 0)), Code::ProjectBad);
  QCOMPARE(tree.rowCount(tree.index(0, 0)), 0);
  QCOMPARE(textAt(tree, tree.index(1, 0), MessageTree::ObjectColumn), QStringLiteral("b7"));
  const QModelIndex outlines = tree.groupOf(Code::FootprintFromOutline);
  QCOMPARE(outlines.row(), 2);
  QCOMPARE(tree.rowCount(outlines), 373);
  QCOMPARE(textAt(tree, outlines, MessageTree::CountColumn), QStringLiteral("373"));
  QVERIFY(textAt(tree, outlines, MessageTree::TextColumn).startsWith(QStringLiteral("211  footprint")));
  QCOMPARE(textAt(tree, tree.index(41, 0, outlines), MessageTree::ObjectColumn), QStringLiteral("b41"));
  QCOMPARE(tree.objectsOf(outlines).size(), std::size_t{373});
  QCOMPARE(tree.objectsOf(tree.index(41, 0, outlines)), std::set<std::string>{"b41"});
}

void MessagesTest::theFilterFindsCodesObjectsAndTexts() {
  MessageTree tree;
  tree.append(sameOfMany(Code::FootprintFromOutline, 20));
  tree.append(
      {diagnose(Code::RingTooShort, "two Points", "b7"), diagnose(Code::ProjectBad, "town.lodestone")});
  const auto shown = [&tree](const QString& text,
                             std::array<bool, kSeverityCount> severities = {true, true, true}) {
    tree.setFilter({text, severities});
    int messages = 0;
    for (int row = 0; row < tree.rowCount(); ++row)
      messages += std::max(1, tree.rowCount(tree.index(row, 0)));
    return messages;
  };
  QCOMPARE(shown({}), 22);
  QCOMPARE(shown(QStringLiteral("211")), 20);
  QCOMPARE(shown(QStringLiteral("b7")), 2);
  QCOMPARE(shown(QStringLiteral("TWO POINTS")), 1);
  QCOMPARE(shown(QStringLiteral("nowhere")), 0);
  QCOMPARE(shown({}, {false, true, true}), 2);
  QCOMPARE(shown({}, {false, false, true}), 1);
  QCOMPARE(tree.count(Severity::Info), std::size_t{20});  // whatever is shown
}

void MessagesTest::everyRowKnowsItsParent() {
  MessageTree tree;
  tree.append(sameOfMany(Code::FootprintFromOutline, 3));
  tree.append(sameOfMany(Code::RingTooShort, 2));
  for (int row = 0; row < tree.rowCount(); ++row) {
    const QModelIndex group = tree.index(row, 0);
    QVERIFY(!group.parent().isValid());
    for (int i = 0; i < tree.rowCount(group); ++i) {
      for (int column = 0; column < MessageTree::ColumnCount; ++column) {
        const QModelIndex message = tree.index(i, column, group);
        QCOMPARE(message.parent(), group);
        QCOMPARE(tree.rowCount(message), 0);
      }
    }
  }
  QVERIFY(!tree.index(0, 0, tree.index(0, 0, tree.index(0, 0))).isValid());
}

void MessagesTest::selectingAMessageSelectsItsBuilding() {
  open();
  openSample();
  window_->findChild<QWidget*>(QStringLiteral("messagesDock"))->raise();
  const auto& buildings = workspace().state().city->buildings;
  Diagnostics said = sameOfMany(Code::RingTooShort, 2);
  said[0].object = buildings[5].object.id;
  said[1].object = buildings[9].object.id;
  Q_EMIT workspace().diagnosed(said);
  Q_EMIT workspace().diagnosed({diagnose(Code::ProjectBad, "about no object")});
  auto* view = window_->findChild<QTreeView*>(QStringLiteral("messageTree"));
  const auto* tree = qobject_cast<const MessageTree*>(view->model());
  const QModelIndex group = tree->groupOf(Code::RingTooShort);
  view->setCurrentIndex(group);
  QCOMPARE(workspace().selection(), (std::vector<NodeId>{5, 9}));
  view->setExpanded(group, true);
  view->setCurrentIndex(tree->index(1, 0, group));
  QCOMPARE(workspace().selection(), std::vector<NodeId>{9});
  view->setCurrentIndex(tree->groupOf(Code::ProjectBad));
  QCOMPARE(workspace().selection(), std::vector<NodeId>{9});  // it is about no building
  keepPicture(*window_, QStringLiteral("messages"));
  window_.reset();
}

void MessagesTest::whatIsHiddenComesBackAsItWas() {
  open();
  Q_EMIT workspace().diagnosed(sameOfMany(Code::FootprintFromOutline, 5));
  auto* view = window_->findChild<QTreeView*>(QStringLiteral("messageTree"));
  const auto* tree = qobject_cast<const MessageTree*>(view->model());
  view->setExpanded(tree->groupOf(Code::FootprintFromOutline), true);
  auto* notes = window_->findChild<QToolButton*>(QStringLiteral("show-info"));
  QCOMPARE(notes->text(), QStringLiteral("5"));
  notes->click();
  QCOMPARE(tree->rowCount(), 0);
  QCOMPARE(notes->text(), QStringLiteral("5"));
  notes->click();
  QVERIFY(view->isExpanded(tree->groupOf(Code::FootprintFromOutline)));
  Q_EMIT workspace().diagnosed(sameOfMany(Code::RingTooShort, 5));
  QVERIFY(view->isExpanded(tree->groupOf(Code::FootprintFromOutline)));
  QVERIFY(!view->isExpanded(tree->groupOf(Code::RingTooShort)));
  window_->findChild<QLineEdit*>(QStringLiteral("messageFilter"))->setText(QStringLiteral("b3"));
  QCOMPARE(tree->rowCount(), 2);
  window_.reset();
}

void MessagesTest::messagesGoWithTheirProject() {
  open();
  openSample();
  Q_EMIT workspace().diagnosed(sameOfMany(Code::RingTooShort, 3));
  QVERIFY(said(*window_, Code::RingTooShort));
  const QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("town.lodestone"));
  QVERIFY(workspace().saveProject(path, QStringLiteral("{}")));
  openSample();  // instead
  QVERIFY(!said(*window_, Code::RingTooShort));
  for (int i = 0; i < 2; ++i) {
    Q_EMIT workspace().diagnosed(sameOfMany(Code::RingTooShort, 3));
    workspace().openProject(path);
    waitForTasks();
    QVERIFY(!said(*window_, Code::RingTooShort));
  }
  window_.reset();
}

void MessagesTest::manyMessagesStayQuick() {
  MessageTree tree;
  tree.append(sameOfMany(Code::RingTooShort, 200'000));
  QCOMPARE(tree.rowCount(tree.index(0, 0)), 200'000);
  QCOMPARE(textAt(tree, tree.index(199'999, 0, tree.index(0, 0)), MessageTree::ObjectColumn),
           QStringLiteral("b199999"));
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::MessagesTest>(argc, argv);
}
#include "messages_test.moc"
