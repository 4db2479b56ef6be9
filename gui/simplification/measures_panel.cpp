#include "gui/simplification/measures_panel.h"

#include <QHeaderView>
#include <QLocale>
#include <algorithm>

#include "gui/widgets/metres.h"

namespace lodestone {
namespace {

enum Row { Triangles, Vertices, Components, Kept, Separated, Lost, WidestGap, Hausdorff, Time, RowCount };

QString number(std::size_t value) {
  return QLocale().toString(static_cast<qulonglong>(value));
}

QString durationText(double seconds) {
  if (seconds >= 0.1) return QLocale().toString(seconds, 'f', 2) + QStringLiteral(" s");
  return QLocale().toString(seconds * 1000, 'f', seconds < 0.01 ? 1 : 0) + QStringLiteral(" ms");
}

}  // namespace

MeasuresPanel::MeasuresPanel(Stage& stage, QWidget* parent)
    : QTableWidget(RowCount, 3, parent), stage_(stage) {
  setObjectName(QStringLiteral("measures"));
  setHorizontalHeaderLabels({tr("Original"), tr("Method A"), tr("Method B")});
  setVerticalHeaderLabels({tr("Triangles"), tr("Vertices"), tr("Components"), tr("Contacts kept"),
                           tr("Contacts separated"), tr("Contacts lost"), tr("Widest gap"),
                           tr("Hausdorff distance"), tr("Time")});
  setEditTriggers(NoEditTriggers);
  setSelectionMode(ContiguousSelection);
  setShowGrid(false);
  setAlternatingRowColors(true);
  setTabKeyNavigation(false);
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 5);
  verticalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  setWhatsThis(tr(
      "Contacts are pairs of components that touch in the original. Kept: they still do. Separated: both are "
      "there, with a gap between them. Lost: one is gone. The Hausdorff distance is the greatest distance of "
      "any point of one model from the other."));
  for (const auto change : {&Stage::opening, &Stage::opened, &Stage::closed, &Stage::comparingChanged})
    connect(&stage_, change, this, &MeasuresPanel::showFigures);
  connect(&stage_, &Stage::levelChanged, this, &MeasuresPanel::showFigures);
  showFigures();
}

/// With names alone it says nothing.
QSize MeasuresPanel::minimumSizeHint() const {
  int shown = 0;
  int widest = 0;
  for (int column = 0; column < columnCount(); ++column) {
    shown += isColumnHidden(column) ? 0 : 1;
    widest = std::max(widest, horizontalHeader()->sectionSizeHint(column));
  }
  return {verticalHeader()->sizeHint().width() + shown * widest + 2 * frameWidth(),
          QTableWidget::minimumSizeHint().height()};
}

void MeasuresPanel::set(int row, int column, const QString& text) {
  auto* cell = new QTableWidgetItem(text);
  cell->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  setItem(row, column, cell);
}

void MeasuresPanel::showFigures() {
  clearContents();
  setColumnHidden(2, !stage_.comparing());
  updateGeometry();
  if (!stage_.isOpen()) return;
  const StagedBuilding& staged = *stage_.staged();
  set(Triangles, 0, number(staged.mesh->triangleCount()));
  set(Vertices, 0, number(staged.mesh->vertexCount()));
  set(Components, 0, number(staged.mesh->components.size()));
  set(Kept, 0, number(staged.classes->contacts.size()));
  showLevel(1, Stage::A);
  if (stage_.comparing()) showLevel(2, Stage::B);
}

void MeasuresPanel::showLevel(int column, Stage::Method method) {
  const auto& level = stage_.level(method);
  if (!level) return;
  const ComponentMesh& mesh = level->simplified->mesh;
  set(Triangles, column, number(mesh.triangleCount()));
  set(Vertices, column, number(mesh.vertexCount()));
  set(Components, column, number(mesh.components.size()));
  set(Time, column, durationText(level->seconds));
  if (!level->report) {
    for (const int row : {Kept, Separated, Lost, WidestGap, Hausdorff}) set(row, column, QStringLiteral("…"));
    return;
  }
  const SimplifyReport& report = *level->report;
  set(Kept, column, number(report.count(ContactFate::Kept)));
  set(Separated, column, number(report.count(ContactFate::Separated)));
  set(Lost, column, number(report.count(ContactFate::Lost)));
  set(WidestGap, column, metresText(report.widestGap()));
  set(Hausdorff, column, metresText(report.hausdorff));
}

}  // namespace lodestone
