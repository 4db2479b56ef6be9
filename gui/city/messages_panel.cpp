#include "gui/city/messages_panel.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/widgets/icons.h"

namespace lodestone {
namespace {

constexpr std::size_t kMostSelected = 1000;  // buildings: more light up the whole city and say nothing

}  // namespace

MessagesPanel::MessagesPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      model_(new MessageTree(this)),
      view_(new QTreeView(this)),
      text_(new QLineEdit(this)) {
  makeView();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(makeBar());
  layout->addWidget(view_, 1);
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.project != after.project) {
              model_->clear();  // what is said is of another
            } else if (before.city != after.city) {
              model_->startAnew();
            }
          });
  connect(&workspace_, &Workspace::diagnosed, this, &MessagesPanel::tell);
  connect(&workspace_, &Workspace::importRejected, this, &MessagesPanel::tell);
  showCounts();
}

QWidget* MessagesPanel::makeBar() {
  auto* bar = new QWidget(this);
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(0, 0, 0, 0);
  text_->setObjectName(QStringLiteral("messageFilter"));
  text_->setPlaceholderText(tr("Filter by code, object or text"));
  text_->setClearButtonEnabled(true);
  text_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  row->addWidget(text_, 1);
  for (const Severity severity : {Severity::Error, Severity::Warning, Severity::Info}) {
    auto* button = new QToolButton(bar);
    button->setObjectName(QStringLiteral("show-") + QString::fromLatin1(toString(severity)));
    button->setIcon(icon(QString::fromLatin1(toString(severity))));
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setCheckable(true);
    button->setChecked(true);
    row->addWidget(button);
    severities_[static_cast<std::size_t>(severity)] = button;
    connect(button, &QToolButton::toggled, this, &MessagesPanel::filter);
  }
  auto* clear = new QToolButton(bar);
  clear->setText(tr("Clear"));
  clear->setToolTip(tr("Forget all messages"));
  clear->setAutoRaise(true);
  row->addWidget(clear);
  connect(clear, &QToolButton::clicked, model_, &MessageTree::clear);
  connect(text_, &QLineEdit::textChanged, this, &MessagesPanel::filter);
  connect(model_, &MessageTree::countsChanged, this, &MessagesPanel::showCounts);
  return bar;
}

void MessagesPanel::makeView() {
  view_->setObjectName(QStringLiteral("messageTree"));
  view_->setModel(model_);
  view_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  view_->setAlternatingRowColors(true);
  view_->setUniformRowHeights(true);
  view_->setExpandsOnDoubleClick(false);  // it flies
  view_->header()->setStretchLastSection(true);
  const int digit = fontMetrics().averageCharWidth();
  const int widths[] = {52, 8, 18, 50};
  for (int column = 0; column < MessageTree::ColumnCount; ++column)
    view_->setColumnWidth(column, digit * widths[column]);
  connect(view_, &QTreeView::expanded, this,
          [this](const QModelIndex& at) { expanded_.insert(model_->codeOf(at)); });
  connect(view_, &QTreeView::collapsed, this,
          [this](const QModelIndex& at) { expanded_.erase(model_->codeOf(at)); });
  connect(model_, &QAbstractItemModel::modelReset, this, [this] {
    for (const Code code : std::set<Code>(expanded_)) view_->setExpanded(model_->groupOf(code), true);
  });
  connect(view_->selectionModel(), &QItemSelectionModel::selectionChanged, this, [this] {
    const std::vector<NodeId> buildings = selectedBuildings();
    if (!buildings.empty()) workspace_.select(buildings);
  });
  connect(view_, &QAbstractItemView::activated, this, [this] {
    const std::vector<NodeId> buildings = selectedBuildings();
    if (!buildings.empty()) workspace_.flyTo(buildings.front());
  });
}

void MessagesPanel::tell(const Diagnostics& diagnostics) {
  model_->append(diagnostics);
  const auto error = std::find_if(diagnostics.begin(), diagnostics.end(),
                                  [](const Diagnostic& d) { return d.severity == Severity::Error; });
  if (error == diagnostics.end()) return;
  view_->scrollTo(model_->groupOf(error->code));
  Q_EMIT errorAdded();
}

void MessagesPanel::filter() {
  MessageFilter wanted{text_->text().trimmed(), {}};
  for (std::size_t i = 0; i < kSeverityCount; ++i) wanted.severities[i] = severities_[i]->isChecked();
  model_->setFilter(wanted);
}

void MessagesPanel::showCounts() {
  const QString help[kSeverityCount] = {tr("Show what is for information"), tr("Show warnings"),
                                        tr("Show errors")};
  for (std::size_t i = 0; i < kSeverityCount; ++i) {
    severities_[i]->setText(
        QLocale().toString(static_cast<qulonglong>(model_->count(static_cast<Severity>(i)))));
    severities_[i]->setToolTip(help[i]);
  }
  Q_EMIT troublesCounted(model_->count(Severity::Error) + model_->count(Severity::Warning));
}

std::vector<NodeId> MessagesPanel::selectedBuildings() const {
  std::set<std::string> objects;
  for (const QModelIndex& row : view_->selectionModel()->selectedRows())
    objects.merge(model_->objectsOf(row));
  return objects.size() > kMostSelected ? std::vector<NodeId>() : workspace_.buildingsOf(objects);
}

}  // namespace lodestone
