// Which levels, in which formats, to where; what each format loses is said before.
#pragma once

#include <QDialog>

#include "gui/simplification/stage.h"
#include "gui/workspace/workspace.h"

class QCheckBox;
class QDialogButtonBox;
class QLabel;
class QLineEdit;
class QListWidget;
class QRadioButton;

namespace lodestone {

class ParameterPanel;

class ExportDialog : public QDialog {
  Q_OBJECT

 public:
  /// The levels of the chain, or what is drawn.
  explicit ExportDialog(const Workspace& workspace, QWidget* parent = nullptr);
  /// What the methods on the stage have made.
  ExportDialog(const Workspace& workspace, const Stage& stage, QWidget* parent = nullptr);
  [[nodiscard]] ExportRequest request() const;
  /// What was made of the workspace's: to be set there before the export.
  [[nodiscard]] ChainOptions chainOptions() const;
  /// Which of them is to be written.
  [[nodiscard]] Stage::Method method() const;

 private:
  void fill(QWidget* levels);
  QWidget* makeLevels();
  QWidget* makeMethods(const Stage& stage);
  QWidget* makeFormats();
  QWidget* makePlace();
  void showLosses();
  void showReady();

  const Workspace& workspace_;
  QRadioButton* chain_ = nullptr;
  QRadioButton* drawn_ = nullptr;
  ParameterPanel* form_ = nullptr;
  QRadioButton* methodB_ = nullptr;
  QString suggested_;
  QListWidget* formats_ = nullptr;
  QLabel* losses_ = nullptr;
  QLineEdit* folder_ = nullptr;
  QLineEdit* name_ = nullptr;
  QLabel* exists_ = nullptr;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace lodestone
