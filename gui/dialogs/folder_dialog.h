// Which of the files in a folder are to be opened.
#pragma once

#include <QDialog>
#include <QStringList>
#include <vector>

class QListWidget;

namespace lodestone {

/// Files of one format.
struct FileKind {
  QString format;  ///< its title
  QStringList paths;
};

/// What can be read in a folder and in those in it, the kind with the most files first, paths in the order of
/// their names. Hidden files and links are left out. Cost: the beginning of every file whose ending a format
/// has.
[[nodiscard]] std::vector<FileKind> readableFiles(const QString& folder);

/// Asks where a folder holds several kinds of files.
class FolderDialog : public QDialog {
  Q_OBJECT

 public:
  FolderDialog(const QString& folder, std::vector<FileKind> kinds, QWidget* parent = nullptr);
  [[nodiscard]] QStringList paths() const;

 private:
  std::vector<FileKind> kinds_;
  QListWidget* list_;
};

}  // namespace lodestone
