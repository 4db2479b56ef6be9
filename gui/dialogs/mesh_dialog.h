// Asks what a mesh file does not say: which axis is up, and its unit.
#pragma once

#include <QDialog>
#include <QStringList>

#include "gui/dialogs/mesh_pictures.h"
#include "gui/workspace/task_runner.h"
#include "model/import_options.h"
#include "model/io/meshes/mesh_import.h"

class QButtonGroup;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QToolButton;

namespace lodestone {

class MeshDialog : public QDialog {
  Q_OBJECT

 public:
  /// The first file is drawn; what is said holds for all. \pre paths of meshes
  MeshDialog(const QStringList& paths, const ImportOptions& options, TaskRunner& tasks,
             QWidget* parent = nullptr);
  ~MeshDialog() override;

  [[nodiscard]] ImportOptions options() const;

  /// Of some files those that say neither.
  [[nodiscard]] static QStringList askedFor(const QStringList& paths);

 protected:
  /// An outline: over the start page, and without a window manager's frame, nothing else would set it off.
  void paintEvent(QPaintEvent* event) override;

 private:
  QToolButton* addCard(const QString& name, const QString& text);
  void addUnits(double unit);
  void show(const MeshPictures& pictures);
  void showSize();
  [[nodiscard]] double unit() const;

  ImportOptions given_;
  UpAxis assumed_;
  TaskRunner& tasks_;
  MeshPictures pictures_;
  QButtonGroup* axes_;
  QToolButton* zUp_;
  QToolButton* yUp_;
  QComboBox* units_;
  QDoubleSpinBox* other_;
  QLabel* size_;
};

}  // namespace lodestone
