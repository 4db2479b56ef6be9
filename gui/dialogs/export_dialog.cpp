#include "gui/dialogs/export_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QRadioButton>
#include <QSettings>
#include <QVBoxLayout>

#include "gui/widgets/icons.h"
#include "gui/widgets/parameter_panel.h"
#include "model/io/format.h"

namespace lodestone {
namespace {

constexpr int kMostNamed = 4;  // of the files that will be replaced

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QString suggestedName(const ProjectState& state) {
  const QString source = state.sources.empty() ? QString() : QString::fromStdString(state.sources.front());
  const QString base = QFileInfo(source).fileName().section(QLatin1Char('.'), 0, 0);
  return base.isEmpty() ? QStringLiteral("city") : base;
}

}  // namespace

ExportDialog::ExportDialog(const Workspace& workspace, QWidget* parent)
    : QDialog(parent), workspace_(workspace), suggested_(suggestedName(workspace.state())) {
  setWindowTitle(tr("Export"));
  fill(makeLevels());
}

ExportDialog::ExportDialog(const Workspace& workspace, const Stage& stage, QWidget* parent)
    : QDialog(parent),
      workspace_(workspace),
      suggested_(workspace.nameOf(stage.building()).section(QLatin1Char('/'), -1) +
                 QStringLiteral("-simplified")) {
  setWindowTitle(tr("Export simplified building"));
  fill(makeMethods(stage));
}

void ExportDialog::fill(QWidget* levels) {
  auto* left = new QVBoxLayout;
  left->addWidget(levels);
  left->addWidget(makePlace());
  left->addStretch(1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(14);
  columns->addLayout(left, 1);
  columns->addWidget(makeFormats(), 1);
  buttons_ = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons_->button(QDialogButtonBox::Ok)->setText(tr("Export"));
  buttons_->button(QDialogButtonBox::Ok)->setIcon(icon(QStringLiteral("export")));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 12);
  layout->setSpacing(12);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons_);
  connect(buttons_, &QDialogButtonBox::accepted, this, [this] {
    QStringList chosen;
    for (const std::string& id : request().formats) chosen << text(id);
    QSettings().setValue(QStringLiteral("exportFormats"), chosen);
    accept();
  });
  connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
  showLosses();
  resize(fontMetrics().averageCharWidth() * 120, fontMetrics().height() * 30);
}

QWidget* ExportDialog::makeLevels() {
  auto* group = new QGroupBox(tr("Levels"), this);
  chain_ = new QRadioButton(tr("The whole chain: original and one level for each tolerance"), group);
  drawn_ = new QRadioButton(tr("Only what is drawn now"), group);
  drawn_->setObjectName(QStringLiteral("drawnCut"));
  chain_->setChecked(true);
  drawn_->setEnabled(workspace_.cut() != nullptr);
  form_ = new ParameterPanel(group);
  form_->addFields<ChainOptions>({"epsilon", "alpha"});
  const ChainOptions& options = workspace_.state().chainOptions;
  form_->show(options);
  const QLocale locale;
  auto* drawnWith =
      new QLabel(tr("ε %1 px and α %2 px are those of the Method dock.")
                     .arg(locale.toString(options.cut.epsilon), locale.toString(options.cut.alpha)),
                 group);
  drawnWith->setForegroundRole(QPalette::PlaceholderText);
  drawnWith->setWordWrap(true);
  auto* layout = new QVBoxLayout(group);
  layout->addWidget(chain_);
  layout->addWidget(drawn_);
  layout->addSpacing(4);
  layout->addWidget(form_);
  layout->addWidget(drawnWith);
  connect(chain_, &QRadioButton::toggled, form_, &QWidget::setEnabled);
  if (!workspace_.state().tree) {
    auto* note = new QLabel(
        tr("Without clusters there is only the original: press Cluster first for more levels."), group);
    note->setWordWrap(true);
    layout->addWidget(note);
  }
  return group;
}

QWidget* ExportDialog::makeMethods(const Stage& stage) {
  auto* group = new QGroupBox(tr("What to write"), this);
  auto* layout = new QVBoxLayout(group);
  for (const Stage::Method method : {Stage::A, Stage::B}) {
    const auto& level = stage.level(method);
    if (method == Stage::B && !stage.comparing()) continue;
    const QString name = method == Stage::A ? tr("Method A") : tr("Method B");
    auto* choice = new QRadioButton(
        level ? tr("%1: %L2 triangles").arg(name).arg(level->simplified->mesh.triangleCount()) : name, group);
    choice->setEnabled(level.has_value());
    choice->setChecked(method == Stage::A);
    layout->addWidget(choice);
    if (method == Stage::B) methodB_ = choice;
  }
  return group;
}

Stage::Method ExportDialog::method() const {
  return methodB_ && methodB_->isChecked() ? Stage::B : Stage::A;
}

QWidget* ExportDialog::makeFormats() {
  auto* group = new QGroupBox(tr("Formats"), this);
  formats_ = new QListWidget(group);
  formats_->setObjectName(QStringLiteral("formats"));
  const QStringList usual{QStringLiteral("cityjson"), QStringLiteral("glb"), QStringLiteral("gpkg")};
  const QStringList chosen = QSettings().value(QStringLiteral("exportFormats"), usual).toStringList();
  for (const Format& format : lodestone::formats()) {
    if (!format.write) continue;
    auto* item = new QListWidgetItem(
        QStringLiteral("%1  (%2)").arg(text(format.title), text(format.extensions.front())), formats_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(chosen.contains(text(format.id)) ? Qt::Checked : Qt::Unchecked);
    item->setData(Qt::UserRole, text(format.id));
    if (!format.losses.empty()) item->setToolTip(tr("Cannot hold: %1").arg(text(format.losses)));
  }
  losses_ = new QLabel(group);
  losses_->setObjectName(QStringLiteral("losses"));
  losses_->setWordWrap(true);
  losses_->setTextFormat(Qt::RichText);
  losses_->setAlignment(Qt::AlignTop);
  auto* layout = new QVBoxLayout(group);
  layout->addWidget(formats_, 3);
  layout->addWidget(losses_, 2);
  connect(formats_, &QListWidget::itemChanged, this, &ExportDialog::showLosses);
  return group;
}

QWidget* ExportDialog::makePlace() {
  auto* group = new QGroupBox(tr("Place"), this);
  const QString last = QSettings().value(QStringLiteral("exportFolder"), QDir::homePath()).toString();
  folder_ = new QLineEdit(QDir::toNativeSeparators(last), group);
  folder_->setObjectName(QStringLiteral("folder"));
  name_ = new QLineEdit(suggested_, group);
  name_->setObjectName(QStringLiteral("name"));
  exists_ = new QLabel(group);
  exists_->setWordWrap(true);
  auto* browse = new QPushButton(tr("Choose…"), group);
  auto* row = new QHBoxLayout;
  row->addWidget(folder_, 1);
  row->addWidget(browse);
  auto* form = new QFormLayout(group);
  auto* folderLabel = new QLabel(tr("&Folder"), group);
  folderLabel->setBuddy(folder_);  // a row of several widgets has none by itself, and would show the “&”
  form->addRow(folderLabel, row);
  form->addRow(tr("&Name"), name_);
  form->addRow(exists_);
  connect(browse, &QPushButton::clicked, this, [this] {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Export to"), folder_->text());
    if (!chosen.isEmpty()) folder_->setText(QDir::toNativeSeparators(chosen));
  });
  connect(folder_, &QLineEdit::textChanged, this, &ExportDialog::showReady);
  connect(name_, &QLineEdit::textChanged, this, &ExportDialog::showReady);
  return group;
}

void ExportDialog::showLosses() {
  QString said;
  for (const std::string& id : request().formats) {
    const Format* format = formatById(id);
    const QString loses = format->losses.empty()
                              ? tr("keeps everything of a chain")
                              : tr("cannot hold %1").arg(text(format->losses).toHtmlEscaped());
    said += QStringLiteral("<p style='margin-bottom:4px'><b>%1</b> %2</p>")
                .arg(text(format->title).toHtmlEscaped(), loses);
  }
  losses_->setText(said.isEmpty() ? tr("Tick at least one format.") : said);
  showReady();
}

void ExportDialog::showReady() {
  if (!buttons_) return;
  const ExportRequest wanted = request();
  QStringList replaced;
  const QString name = name_->text().trimmed();
  for (const std::string& id : wanted.formats) {
    const QString ending = text(formatById(id)->extensions.front());
    // some formats make one file a level
    replaced << QDir(folder_->text())
                    .entryList({name + ending, name + QStringLiteral("_level-*") + ending}, QDir::Files);
  }
  if (replaced.size() > kMostNamed)
    replaced = replaced.mid(0, kMostNamed) << tr("and %1 more").arg(replaced.size() - kMostNamed);
  const bool folderThere = QFileInfo(folder_->text()).isDir();
  exists_->setText(!folderThere ? tr("The folder will be made.")
                   : replaced.isEmpty()
                       ? QString()
                       : tr("Will be replaced: %1").arg(replaced.join(QStringLiteral(", "))));
  buttons_->button(QDialogButtonBox::Ok)
      ->setEnabled(!wanted.formats.empty() && !wanted.name.empty() && wanted.folder.is_absolute());
}

ChainOptions ExportDialog::chainOptions() const {
  const ChainOptions& options = workspace_.state().chainOptions;
  return form_ ? form_->read(options) : options;
}

ExportRequest ExportDialog::request() const {
  ExportRequest request;
  request.drawnCut = drawn_ && drawn_->isChecked();
  for (int i = 0; i < formats_->count(); ++i) {
    const QListWidgetItem* item = formats_->item(i);
    if (item->checkState() == Qt::Checked)
      request.formats.push_back(item->data(Qt::UserRole).toString().toStdString());
  }
  request.folder = folder_->text().toStdString();
  request.name = name_->text().trimmed().toStdString();
  return request;
}

}  // namespace lodestone
