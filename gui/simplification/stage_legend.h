// What the signs on the stage mean; each is a switch.
#pragma once

#include <QWidget>
#include <array>

#include "gui/simplification/stage.h"

class QToolButton;

namespace lodestone {

class StageLegend : public QWidget {
  Q_OBJECT

 public:
  explicit StageLegend(Stage& stage, QWidget* parent = nullptr);

  [[nodiscard]] QToolButton& components() { return *components_; }
  [[nodiscard]] QToolButton& textures() { return *textures_; }
  /// Triangles of the original in the colours of their classes of detail.
  [[nodiscard]] QToolButton& details() { return *details_; }
  [[nodiscard]] QToolButton& glyphs(VertexClass vertexClass) {
    return *glyphs_[static_cast<std::size_t>(vertexClass)];
  }
  [[nodiscard]] QToolButton& angles() { return *angles_; }
  [[nodiscard]] QToolButton& contacts() { return *contacts_; }

 Q_SIGNALS:
  void changed();

 private:
  QToolButton* addSwitch(const QString& name, const QString& text, const QIcon& icon, bool on,
                         const QString& help);
  void showCounts();
  void showDetails(bool on);
  void showTextures();

  Stage& stage_;
  QToolButton* components_;
  QToolButton* textures_;
  QToolButton* details_;
  std::array<QToolButton*, 3> glyphs_{};
  QToolButton* angles_;
  QToolButton* contacts_;
  std::vector<QToolButton*> putAside_;  ///< signs that were on before classes of detail
};

}  // namespace lodestone
