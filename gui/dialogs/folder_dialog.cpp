#include "gui/dialogs/folder_dialog.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QDirIterator>
#include <QFileInfo>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>
#include <map>

#include "model/io/format.h"

namespace lodestone {
namespace {

constexpr int kMostNamed = 3;  // files of a kind

QString text(std::string_view utf8) {
  return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

/// Endings of all that can be read, as a folder is searched for them.
QStringList patterns() {
  QStringList all;
  for (const Format& format : formats()) {
    if (!format.read) continue;
    for (const std::string_view ending : format.extensions) all << QStringLiteral("*") + text(ending);
  }
  all.removeDuplicates();
  return all;
}

/// "12 files: a.gml, b.gml, c.gml and 9 more"
QString summary(const QStringList& paths) {
  QStringList names;
  for (const QString& path : paths.mid(0, kMostNamed)) names << QFileInfo(path).fileName();
  if (paths.size() > kMostNamed)
    names.back() += FolderDialog::tr(" and %L1 more").arg(paths.size() - kMostNamed);
  return (paths.size() == 1 ? FolderDialog::tr("%L1 file: %2") : FolderDialog::tr("%L1 files: %2"))
      .arg(paths.size())
      .arg(names.join(QStringLiteral(", ")));
}

}  // namespace

std::vector<FileKind> readableFiles(const QString& folder) {
  QStringList found;
  QDirIterator files(folder, patterns(), QDir::Files | QDir::NoSymLinks, QDirIterator::Subdirectories);
  while (files.hasNext()) found << files.next();
  found.sort();
  std::map<QString, QStringList> byFormat;
  for (const QString& path : found) {
    if (const Format* format = formatForReading(path.toStdString())) byFormat[text(format->title)] << path;
  }
  std::vector<FileKind> kinds;
  for (const auto& [format, paths] : byFormat) kinds.push_back({format, paths});
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const FileKind& a, const FileKind& b) { return a.paths.size() > b.paths.size(); });
  return kinds;
}

FolderDialog::FolderDialog(const QString& folder, std::vector<FileKind> kinds, QWidget* parent)
    : QDialog(parent), kinds_(std::move(kinds)), list_(new QListWidget(this)) {
  setObjectName(QStringLiteral("folderDialog"));
  setWindowTitle(tr("Open a folder"));
  auto* title = new QLabel(tr("%1 holds files of several kinds. Those that are ticked become one model.")
                               .arg(QDir(folder).dirName()),
                           this);
  title->setTextFormat(Qt::PlainText);
  title->setWordWrap(true);
  list_->setObjectName(QStringLiteral("fileKinds"));
  for (const FileKind& kind : kinds_) {
    auto* item = new QListWidgetItem(QStringLiteral("%1\n%2").arg(kind.format, summary(kind.paths)), list_);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
    item->setCheckState(list_->count() == 1 ? Qt::Checked : Qt::Unchecked);
    item->setToolTip(kind.paths.mid(0, 20).join(QLatin1Char('\n')));
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Open | QDialogButtonBox::Cancel, this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 12);
  layout->setSpacing(12);
  layout->addWidget(title);
  layout->addWidget(list_, 1);
  layout->addWidget(buttons);
  connect(list_, &QListWidget::itemChanged, this,
          [this, buttons] { buttons->button(QDialogButtonBox::Open)->setEnabled(!paths().isEmpty()); });
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(fontMetrics().averageCharWidth() * 84, fontMetrics().height() * 16);
}

QStringList FolderDialog::paths() const {
  QStringList chosen;
  for (int i = 0; i < list_->count(); ++i) {
    if (list_->item(i)->checkState() == Qt::Checked) chosen << kinds_[static_cast<std::size_t>(i)].paths;
  }
  return chosen;
}

}  // namespace lodestone
