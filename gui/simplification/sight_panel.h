// From where visibility is analysed, and what is seen past each model.
#pragma once

#include <QWidget>
#include <array>

#include "gui/simplification/sight.h"
#include "gui/view3d/palette.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;
class QToolButton;
class QVBoxLayout;

namespace lodestone {

class ParameterPanel;
class SightPicture;

class SightPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SightPanel(Sight& sight, QWidget* parent = nullptr);

  [[nodiscard]] QPushButton& placeButton() { return *place_; }
  [[nodiscard]] ParameterPanel& fields() { return *fields_; }
  [[nodiscard]] SightPicture& picture(Past past) { return *pictures_[static_cast<std::size_t>(past)]; }
  /// "9 seen" and the like, as shown for a model.
  [[nodiscard]] QLabel& count(TargetFate fate, Past past) {
    return *counts_[static_cast<std::size_t>(fate)][static_cast<std::size_t>(past)];
  }
  /// The scene's colours.
  void setTheme(SceneTheme theme);

 Q_SIGNALS:
  void fromCameraRequested();
  void lookRequested();

 private:
  void addButtons(QVBoxLayout& layout);
  void addResults(QVBoxLayout& layout);
  QToolButton* addTool(QLayout& layout, const QString& name, const QString& text, const QString& iconName,
                       const QString& help);
  void addPosition(QVBoxLayout& layout);
  void showOptions();
  void showPosition();
  void readPosition();
  void showSeen();
  void showState();
  void showRows();
  void showFate(int row, Past past, std::uint32_t target);
  void showChosen();
  [[nodiscard]] bool isListed(std::uint32_t target) const;

  static constexpr std::size_t kFates = 4;

  Sight& sight_;
  Palette palette_ = lightPalette();
  QPushButton* place_;
  QToolButton* camera_ = nullptr;
  QToolButton* look_ = nullptr;
  QToolButton* remove_ = nullptr;
  ParameterPanel* fields_;
  QLineEdit* position_;
  QLabel* state_;
  QWidget* results_;
  std::array<QLabel*, kPasts.size()> titles_{};
  std::array<SightPicture*, kPasts.size()> pictures_{};
  std::array<QLabel*, kFates> swatches_{};
  std::array<std::array<QLabel*, kPasts.size()>, kFates> counts_{};
  QCheckBox* differing_;
  QTableWidget* table_;
};

}  // namespace lodestone
