// A form gives back what it was given, bit for bit, until a person changes it.
#include "gui/widgets/parameter_panel.h"

#include <QApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QTest>
#include <cmath>

#include "gui/dialogs/import_dialog.h"
#include "model/cluster_options.h"

namespace lodestone {

class ParameterPanelTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void untouchedFieldsComeBackAsTheyWere();
  void whatIsTypedCounts();
  void theImportFormStartsFromWhatIsGiven();
  void importWantsASystemThatIsOne();
};

void ParameterPanelTest::untouchedFieldsComeBackAsTheyWere() {
  ParameterPanel panel;
  panel.addFields<CutOptions>();
  panel.addFields<MergeOptions>();
  CutOptions cut;
  cut.epsilon = std::sqrt(12345.678);
  cut.alpha = 1.0 / 3;
  panel.show(cut);
  QCOMPARE(panel.read(CutOptions{}), cut);
  // One field is changed by a person: the others still are what they were.
  auto* alpha = qobject_cast<QDoubleSpinBox*>(panel.editor("alpha"));
  QVERIFY(alpha);
  alpha->setValue(2.5);
  cut.alpha = 2.5;
  QCOMPARE(panel.read(CutOptions{}), cut);
}

void ParameterPanelTest::whatIsTypedCounts() {
  ParameterPanel panel;
  panel.addFields<CutOptions>();
  CutOptions cut;
  cut.alpha = 1.0 / 3;
  panel.show(cut);
  auto* alpha = qobject_cast<QDoubleSpinBox*>(panel.editor("alpha"));
  QSignalSpy edited(&panel, &ParameterPanel::edited);
  const double shown = alpha->value();
  alpha->setValue(7);
  alpha->setValue(shown);  // typed by a person now: no longer the hidden digits of before
  QCOMPARE(edited.count(), 2);
  QCOMPARE(panel.read(cut).alpha, shown);
}

void ParameterPanelTest::theImportFormStartsFromWhatIsGiven() {
  FieldPreview roof;
  roof.name = "ROOF";
  roof.numeric = true;
  LayerPreview layer;
  layer.name = "blocks";
  layer.hasPolygons = true;
  layer.fields = {roof};
  const VectorPreview preview{{layer}};
  ImportOptions given;
  given.height = "ROOF";
  given.floorHeight = 2.83333;
  given.defaultHeight = 7.77;
  given.crs = "EPSG:25832";
  const ImportOptions back = ImportDialog({}, preview, given).options();
  QCOMPARE(back.height, given.height);
  QCOMPARE(back.floorHeight, given.floorHeight);
  QCOMPARE(back.defaultHeight, given.defaultHeight);
  QCOMPARE(back.crs, given.crs);
  given.height.clear();
  given.floors = "ROOF";
  QCOMPARE(ImportDialog({}, preview, given).options().floors, given.floors);
  QVERIFY(ImportDialog({}, preview, given).options().height.empty());
}

void ParameterPanelTest::importWantsASystemThatIsOne() {
  LayerPreview layer;
  layer.name = "blocks";
  layer.hasPolygons = true;
  ImportDialog dialog({}, VectorPreview{{layer}}, {});
  auto* crs = dialog.findChild<QLineEdit*>(QStringLiteral("crs"));
  auto* import = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  QVERIFY(import->isEnabled());
  crs->setText(QStringLiteral("EPSG:99999999"));
  QVERIFY(!import->isEnabled());
  crs->setText(QStringLiteral("EPSG:25833"));
  QVERIFY(import->isEnabled());
}

}  // namespace lodestone

QTEST_MAIN(lodestone::ParameterPanelTest)
#include "parameter_panel_test.moc"
