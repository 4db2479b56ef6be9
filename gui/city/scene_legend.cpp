#include "gui/city/scene_legend.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <array>

#include "gui/view3d/city_scene.h"
#include "gui/widgets/colours.h"

namespace lodestone {
namespace {

constexpr int kPadding = 8;
constexpr double kPanelOpacity = 0.86;  // the view stays felt behind it

QColor toColour(const Rgb& rgb) {
  return QColor::fromRgbF(rgb[0], rgb[1], rgb[2]);
}

/// A block in the view's own slant, as its corners on paper: floor and roof, from the left around the front.
struct Block {
  std::array<QPointF, 4> floor, roof;

  explicit Block(const QRectF& area) {
    const std::array<QPointF, 4> plan{{{0, 0.72}, {0.56, 1}, {1, 0.80}, {0.44, 0.54}}};
    for (std::size_t i = 0; i < plan.size(); ++i) {
      floor[i] = area.topLeft() + QPointF(plan[i].x() * area.width(), plan[i].y() * area.height());
      roof[i] = floor[i] - QPointF(0, 0.54 * area.height());
    }
  }
};

void drawLines(QPainter& painter, const QRectF& area, const QColor& colour) {
  const Block block(area);
  painter.setPen(QPen(colour, 1.4, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
  painter.setBrush(Qt::NoBrush);
  painter.drawPolygon(block.floor.data(), 4);
  painter.drawPolygon(block.roof.data(), 4);
  for (std::size_t i = 0; i < 4; ++i) painter.drawLine(block.floor[i], block.roof[i]);
}

void drawBlock(QPainter& painter, const QRectF& area, const QColor& colour) {
  const Block block(area);
  const auto face = [&painter](std::initializer_list<QPointF> corners, const QColor& fill) {
    painter.setBrush(fill);
    painter.drawPolygon(QPolygonF(QList<QPointF>(corners)));
  };
  painter.setPen(QPen(mixed(colour, Qt::black, 0.45), 0.8));
  face({block.roof[0], block.roof[1], block.roof[2], block.roof[3]}, colour);
  face({block.floor[0], block.floor[1], block.roof[1], block.roof[0]}, mixed(colour, Qt::black, 0.12));
  face({block.floor[1], block.floor[2], block.roof[2], block.roof[1]}, mixed(colour, Qt::black, 0.28));
}

/// Three hues side by side: what stands for “each its own”.
void drawHues(QPainter& painter, const QRectF& area) {
  const double width = area.width() / 3;
  painter.setPen(Qt::NoPen);
  for (int i = 0; i < 3; ++i) {
    painter.setBrush(toColour(hueOf(static_cast<std::size_t>(i))));
    painter.drawRect(QRectF(area.left() + i * width, area.top() + 3, width, area.height() - 6));
  }
}

void drawSign(QPainter& painter, const QRectF& area, const LegendEntry& entry) {
  switch (entry.sign) {
    case LegendEntry::Sign::Block:
      return drawBlock(painter, area, entry.colour);
    case LegendEntry::Sign::Hues:
      return drawHues(painter, area);
    case LegendEntry::Sign::Hull:
    case LegendEntry::Sign::Box:
      return drawLines(painter, area, entry.colour);
  }
}

/// Buildings, clusters and landmarks, as far as they are drawn.
void addRoles(const CityScene& scene, const Palette& palette, std::vector<LegendEntry>& entries) {
  std::array<bool, 3> drawn{};
  for (const DrawnNode& node : scene.drawn()) drawn[static_cast<std::size_t>(node.role)] = true;
  const auto has = [&](DrawRole role) { return drawn[static_cast<std::size_t>(role)]; };
  const auto add = [&](const Rgb& colour, const QString& text) {
    entries.push_back({LegendEntry::Sign::Block, toColour(colour), text});
  };
  if (scene.colours() == SceneColours::ByCluster) {
    entries.push_back({LegendEntry::Sign::Hues, {}, SceneLegend::tr("Clusters, each in a hue of its own")});
    return;
  }
  const Rgb building = scene.layerStyle(SceneLayer::Buildings).colour.value_or(palette.building);
  if (has(DrawRole::Building)) add(building, SceneLegend::tr("Building"));
  if (has(DrawRole::Cluster)) add(palette.cluster, SceneLegend::tr("Cluster of buildings"));
  if (has(DrawRole::Landmark) && scene.overlay(Overlay::Landmarks))
    add(palette.landmark, SceneLegend::tr("Landmark: stands out by more than α"));
}

}  // namespace

std::vector<LegendEntry> legendOf(const CityScene& scene) {
  std::vector<LegendEntry> entries;
  const bool hulls = scene.overlay(Overlay::Hulls);
  const bool boxes = scene.overlay(Overlay::NegativeSpace);
  if (!scene.tree() || (!hulls && !boxes)) return entries;
  const Palette& palette = scene.theme() == SceneTheme::Dark ? darkPalette() : lightPalette();
  addRoles(scene, palette, entries);
  if (hulls) {
    entries.push_back({LegendEntry::Sign::Hull, toColour(palette.hullLine),
                       SceneLegend::tr("Merged hull: outline of a cluster")});
  }
  if (boxes) {
    entries.push_back({LegendEntry::Sign::Box, toColour(palette.boxLine),
                       SceneLegend::tr("Negative space: what ε measures, as a box")});
  }
  return entries;
}

SceneLegend::SceneLegend(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("sceneLegend"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
  hide();
}

void SceneLegend::setEntries(std::vector<LegendEntry> entries) {
  if (entries == entries_) return;
  entries_ = std::move(entries);
  QStringList said;
  for (const LegendEntry& entry : entries_) said << entry.text;
  setAccessibleName(said.join(QStringLiteral("; ")));
  updateGeometry();
  resize(sizeHint());
  setVisible(!entries_.empty());
  update();
}

QSize SceneLegend::sizeHint() const {
  int widest = 0;
  for (const LegendEntry& entry : entries_)
    widest = std::max(widest, fontMetrics().horizontalAdvance(entry.text));
  return {3 * kPadding + signWidth() + widest,
          2 * kPadding + static_cast<int>(entries_.size()) * rowHeight()};
}

void SceneLegend::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  QColor panel = palette().color(QPalette::Base);
  panel.setAlphaF(kPanelOpacity);
  painter.setBrush(panel);
  painter.setPen(mixed(palette().color(QPalette::Text), palette().color(QPalette::Base), 0.75));
  painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
  double top = kPadding;
  for (const LegendEntry& entry : entries_) {
    const QRectF sign(kPadding, top + 2, signWidth(), rowHeight() - 4);
    drawSign(painter, sign, entry);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(sign.right() + kPadding, top, width(), rowHeight()), Qt::AlignVCenter,
                     entry.text);
    top += rowHeight();
  }
}

}  // namespace lodestone
