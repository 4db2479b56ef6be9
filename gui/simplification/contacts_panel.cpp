#include "gui/simplification/contacts_panel.h"

#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/view3d/component_colours.h"
#include "gui/widgets/metres.h"
#include "gui/widgets/row_table.h"

namespace lodestone {
namespace {

constexpr int kContact = Qt::UserRole;

/// Lost first, then the widest gap.
double badness(const SimplifyReport* report, std::size_t contact) {
  if (!report || report->contacts[contact].fate == ContactFate::Kept) return 0;
  const ContactReport& found = report->contacts[contact];
  return found.fate == ContactFate::Lost ? 1e30 : 1 + found.gap;
}

}  // namespace

ContactsPanel::ContactsPanel(Stage& stage, QWidget* parent)
    : QWidget(parent), stage_(stage), table_(new QTableWidget(0, 4, this)), none_(new QLabel(this)) {
  table_->setObjectName(QStringLiteral("contacts"));
  table_->setHorizontalHeaderLabels({tr("Nr."), tr("touches"), tr("Method A"), tr("Method B")});
  table_->horizontalHeaderItem(0)->setToolTip(tr("Component, by its number in Components"));
  table_->horizontalHeaderItem(1)->setToolTip(tr("Component that it touches in the original"));
  makeRowTable(*table_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
  for (const int column : {0, 1})
    table_->horizontalHeader()->setSectionResizeMode(column, QHeaderView::ResizeToContents);
  table_->setToolTip(tr("Contacts of the original that are no more; double-click to fly there"));
  none_->setAlignment(Qt::AlignCenter);
  none_->setWordWrap(true);
  none_->setForegroundRole(QPalette::PlaceholderText);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 4);
  layout->addWidget(table_, 1);
  layout->addWidget(none_, 1);

  for (const auto change : {&Stage::opening, &Stage::opened, &Stage::closed, &Stage::comparingChanged})
    connect(&stage_, change, this, &ContactsPanel::showContacts);
  connect(&stage_, &Stage::levelChanged, this, &ContactsPanel::showContacts);
  connect(&stage_, &Stage::contactChanged, this, &ContactsPanel::showChosen);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto rows = table_->selectionModel()->selectedRows();
    if (rows.isEmpty()) return;
    const auto contact = static_cast<std::size_t>(rows.first().data(kContact).toULongLong());
    stage_.chooseContact(contact);
    const auto& [a, b] = stage_.staged()->classes->contacts[contact];
    stage_.select({a, b});
  });
  connect(table_, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem* item) {
    stage_.flyToContact(static_cast<std::size_t>(table_->item(item->row(), 0)->data(kContact).toULongLong()));
  });
  showContacts();
}

const SimplifyReport* ContactsPanel::reportOf(Stage::Method method) const {
  const auto& level = stage_.level(method);
  const bool shown = method == Stage::A || stage_.comparing();
  return shown && level && level->report ? &*level->report : nullptr;
}

void ContactsPanel::showContacts() {
  const QSignalBlocker quiet(table_);
  table_->setRowCount(0);
  table_->setColumnHidden(3, !stage_.comparing());
  const SimplifyReport* a = reportOf(Stage::A);
  const SimplifyReport* b = reportOf(Stage::B);
  std::vector<std::size_t> bad;
  const std::size_t count = stage_.isOpen() ? stage_.staged()->classes->contacts.size() : 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (badness(a, i) > 0 || badness(b, i) > 0) bad.push_back(i);
  }
  std::stable_sort(bad.begin(), bad.end(), [&](std::size_t i, std::size_t j) {
    return std::max(badness(a, i), badness(b, i)) > std::max(badness(a, j), badness(b, j));
  });
  table_->setRowCount(static_cast<int>(bad.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const std::size_t contact = bad[static_cast<std::size_t>(row)];
    const auto& [first, second] = stage_.staged()->classes->contacts[contact];
    auto* item = new QTableWidgetItem(QString::number(first));
    item->setData(kContact, static_cast<qulonglong>(contact));
    table_->setItem(row, 0, item);
    table_->setItem(row, 1, new QTableWidgetItem(QString::number(second)));
    showFate(row, 2, a, contact);
    showFate(row, 3, b, contact);
  }
  none_->setText(!stage_.isOpen()          ? tr("No building is on the stage.")
                 : !stage_.level(Stage::A) ? tr("Nothing is simplified yet.")
                 : !a                      ? tr("The contacts are being measured.")
                 : count == 0              ? tr("No components touch each other.")
                 : count == 1              ? tr("The only contact is kept.")
                                           : tr("All %L1 contacts are kept.").arg(count));
  table_->setVisible(!bad.empty());
  none_->setVisible(bad.empty());
}

void ContactsPanel::showFate(int row, int column, const SimplifyReport* report, std::size_t contact) {
  if (!report) return;
  const ContactReport& found = report->contacts[contact];
  QString text = tr("kept");
  if (found.fate == ContactFate::Separated) text = tr("%1 apart").arg(metresText(found.gap));
  if (found.fate == ContactFate::Lost) text = tr("lost");
  auto* item = new QTableWidgetItem(text);
  item->setToolTip(text);
  const Rgb colour = fateColour(found.fate);
  item->setData(Qt::DecorationRole, QColor::fromRgbF(colour[0], colour[1], colour[2]));
  table_->setItem(row, column, item);
}

void ContactsPanel::showChosen() {
  const QSignalBlocker quiet(table_);
  table_->clearSelection();
  for (int row = 0; stage_.contact() && row < table_->rowCount(); ++row) {
    if (table_->item(row, 0)->data(kContact).toULongLong() == *stage_.contact()) table_->selectRow(row);
  }
}

}  // namespace lodestone
