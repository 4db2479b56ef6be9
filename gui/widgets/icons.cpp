#include "gui/widgets/icons.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

namespace lodestone {
namespace {

/// Draws from the SVG each time, so that a change of palette or of pixel ratio needs no new icon.
class LineIconEngine : public QIconEngine {
 public:
  explicit LineIconEngine(QByteArray svg) : svg_(std::move(svg)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const QPalette palette = QApplication::palette();
    const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
    const QColor line =
        palette.color(group, mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::WindowText);
    const bool plain = mode == QIcon::Disabled || mode == QIcon::Selected;
    QByteArray coloured = svg_;
    coloured.replace("currentColor", line.name().toUtf8());
    coloured.replace("\"accent\"", "\"" + (plain ? line : accentColor()).name().toUtf8() + "\"");
    QSvgRenderer(coloured).render(painter, rect);
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    QPixmap result(size);
    result.fill(Qt::transparent);
    QPainter painter(&result);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return result;
  }

  [[nodiscard]] QIconEngine* clone() const override { return new LineIconEngine(svg_); }

 private:
  QByteArray svg_;
};

}  // namespace

QColor accentColor() {
  const bool dark = QApplication::palette().color(QPalette::Window).lightness() < 128;
  return dark ? QColor(0x4f, 0xb3, 0xbf) : QColor(0x1b, 0x7f, 0x8c);
}

QIcon icon(const QString& name) {
  QFile file(QStringLiteral(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) return {};
  return QIcon(new LineIconEngine(file.readAll()));
}

}  // namespace lodestone
