// Which levels, in which formats, to where; what each format loses is said before.
#pragma once

#include <QDialog>

#include "gui/workspace.h"

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
  ExportDialog(const Workspace& workspace, const ChainOptions& options, QWidget* parent = nullptr);
  [[nodiscard]] ExportRequest request() const;

 private:
  QWidget* makeLevels();
  QWidget* makeFormats();
  QWidget* makePlace();
  void showLosses();
  void showReady();

  const Workspace& workspace_;
  ChainOptions options_;
  QRadioButton* chain_;
  QRadioButton* drawn_;
  ParameterPanel* form_;
  QListWidget* formats_;
  QLabel* losses_;
  QLineEdit* folder_;
  QLineEdit* name_;
  QLabel* exists_;
  QDialogButtonBox* buttons_ = nullptr;
};

}  // namespace lodestone
