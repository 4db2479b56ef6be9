// Asks what a file does not say: which field holds heights, which layer, which coordinate system.
#pragma once

#include <QDialog>
#include <QStringList>

#include "model/import_options.h"
#include "model/io/footprints/vector_preview.h"

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace lodestone {

class OutlinePreview;

class ImportDialog : public QDialog {
  Q_OBJECT

 public:
  ImportDialog(const QStringList& paths, VectorPreview preview, const ImportOptions& options,
               QWidget* parent = nullptr);

  [[nodiscard]] ImportOptions options() const;

  /// What there is to ask about these files; nothing where they say it all (CityGML, CityJSON).
  static std::optional<VectorPreview> questionsFor(const QStringList& paths);

 protected:
  /// An outline: over the start page, and without a window manager's frame, nothing else would set it off.
  void paintEvent(QPaintEvent* event) override;

 private:
  void showLayer();
  void chooseGivenHeights();
  void showField();
  void showSystem();
  [[nodiscard]] const LayerPreview* layer() const;
  [[nodiscard]] const FieldPreview* field() const;

  VectorPreview preview_;
  ImportOptions given_;
  QComboBox* layers_;
  QComboBox* heights_;
  QDoubleSpinBox* floorHeight_;
  QDoubleSpinBox* constant_;
  QLineEdit* crs_;
  QLabel* crsFound_;
  QLabel* crsNote_;
  QPushButton* import_ = nullptr;
  QLabel* heightNote_;
  OutlinePreview* picture_;
};

}  // namespace lodestone
