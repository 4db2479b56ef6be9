#include <QTest>

#include "gui/messages_panel.h"

namespace lodestone {

class MessagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void informationIsToldOnce();
};

void MessagesTest::informationIsToldOnce() {
  MessageTable table;
  const Diagnostic roads = diagnose(Code::BarriersTaken, "873 roads");
  const Diagnostic error = diagnose(Code::ProjectBad, "town.lodestone");
  table.append({roads, error});
  table.append({roads, error, diagnose(Code::BarriersTaken, "12 roads")});
  QCOMPARE(table.rowCount(), 4);
  QCOMPARE(table.all()[2].code, Code::ProjectBad);
  table.clear();
  table.append({roads});
  QCOMPARE(table.rowCount(), 1);
}

}  // namespace lodestone

QTEST_MAIN(lodestone::MessagesTest)
#include "messages_test.moc"
