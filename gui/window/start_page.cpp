#include "gui/window/start_page.h"

#include <QCommandLinkButton>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayoutItem>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <array>
#include <cmath>

#include "gui/widgets/colours.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/mnemonics.h"

namespace lodestone {
namespace {

constexpr int kMostRecent = 6;
constexpr int kFolderCharacters = 26;

QFont scaled(const QFont& font, double factor, QFont::Weight weight) {
  QFont result = font;
  result.setPointSizeF(font.pointSizeF() * factor);
  result.setWeight(weight);
  return result;
}

/// A block in oblique projection, its front lower left corner at `foot`.
struct Block {
  double x, width, depth, height;
};

/// The same street three times, from fine to coarse: what the program does, in one picture.
class Skyline {
 public:
  Skyline(QPainter& painter, const QRectF& area, const QPalette& palette)
      : painter_(painter), area_(area), palette_(palette) {}

  void paint() {
    static const std::array<Block, 14> town{{{0, 20, 9, 34},
                                             {20, 16, 9, 28},
                                             {36, 22, 9, 44},
                                             {66, 24, 9, 72},
                                             {94, 18, 9, 30},
                                             {112, 18, 9, 40},
                                             {130, 14, 9, 26},
                                             {152, 30, 9, 52},
                                             {182, 16, 9, 36},
                                             {206, 14, 9, 104},
                                             {226, 22, 9, 42},
                                             {248, 18, 9, 34},
                                             {274, 28, 9, 60},
                                             {302, 18, 9, 28}}};
    static const std::array<Block, 6> merged{{{0, 58, 9, 36},
                                              {66, 24, 9, 72},
                                              {94, 50, 9, 33},
                                              {152, 46, 9, 46},
                                              {206, 14, 9, 104},
                                              {226, 94, 9, 44}}};
    static const std::array<Block, 2> whole{{{0, 320, 9, 42}, {206, 14, 9, 104}}};
    const double unit = area_.width() / 1090;
    row(town, 0, unit, true);
    row(merged, 385 * unit, unit, false);
    row(whole, 770 * unit, unit, false);
  }

 private:
  template <std::size_t N>
  void row(const std::array<Block, N>& blocks, double offset, double unit, bool windows) {
    painter_.setPen(QPen(faint(0.35), 1.2));
    painter_.drawLine(QPointF(area_.left() + offset - 8 * unit, area_.bottom()),
                      QPointF(area_.left() + offset + 340 * unit, area_.bottom()));
    for (const Block& block : blocks) {
      const double x = area_.left() + offset + block.x * unit;
      const QRectF front(x, area_.bottom() - block.height * unit, block.width * unit, block.height * unit);
      draw(front, block.depth * unit, block.height > 90);
      if (windows) drawWindows(front, unit);
    }
  }

  void draw(const QRectF& front, double depth, bool landmark) {
    const QColor colour = landmark ? selectionColour() : accentColor();
    const QPointF back(depth, -depth * 0.6);
    painter_.setPen(QPen(palette_.color(QPalette::Window), 1));
    painter_.setBrush(shade(colour, 0.62));
    painter_.drawRect(front);
    painter_.setBrush(shade(colour, 0.85));
    painter_.drawPolygon(
        QPolygonF{front.topLeft(), front.topLeft() + back, front.topRight() + back, front.topRight()});
    painter_.setBrush(shade(colour, 0.42));
    painter_.drawPolygon(QPolygonF{front.topRight(), front.topRight() + back, front.bottomRight() + back,
                                   front.bottomRight()});
  }

  void drawWindows(const QRectF& front, double unit) {
    painter_.setPen(Qt::NoPen);
    painter_.setBrush(faint(0.0));
    for (double y = front.top() + 5 * unit; y < front.bottom() - 8 * unit; y += 8 * unit) {
      for (double x = front.left() + 3 * unit; x + 3 * unit <= front.right() - 1.5 * unit; x += 5 * unit) {
        painter_.drawRect(QRectF(x, y, 2.2 * unit, 3.6 * unit));
      }
    }
  }

  [[nodiscard]] QColor shade(const QColor& colour, double share) const {
    const QColor ground = palette_.color(QPalette::Window);
    const auto mix = [share](float a, float b) { return static_cast<float>(a * share + b * (1 - share)); };
    return QColor::fromRgbF(mix(colour.redF(), ground.redF()), mix(colour.greenF(), ground.greenF()),
                            mix(colour.blueF(), ground.blueF()));
  }
  [[nodiscard]] QColor faint(double share) const {
    QColor colour = share == 0.0 ? palette_.color(QPalette::Window) : palette_.color(QPalette::WindowText);
    colour.setAlphaF(share == 0.0 ? 0.55F : static_cast<float>(share));
    return colour;
  }

  QPainter& painter_;
  QRectF area_;
  QPalette palette_;
};

QCommandLinkButton* action(const QString& title, const QString& text, const QString& iconName,
                           QWidget* parent) {
  auto* button = new QCommandLinkButton(title, text, parent);
  button->setIcon(icon(iconName));
  button->setIconSize(QSize(32, 32));
  button->setCursor(Qt::PointingHandCursor);
  return button;
}

}  // namespace

StartPage::StartPage(QWidget* parent)
    : QWidget(parent), recent_(new QVBoxLayout), recentTitle_(new QLabel(tr("Recent"), this)) {
  setObjectName(QStringLiteral("startPage"));
  setAutoFillBackground(true);
  auto* title = new QLabel(QStringLiteral("Lodestone"), this);
  title->setFont(scaled(font(), 3.2, QFont::DemiBold));
  auto* line = new QLabel(
      tr("Turn a city into a chain of levels of detail that stays legible from any distance."), this);
  line->setFont(scaled(font(), 1.25, QFont::Normal));
  line->setWordWrap(true);

  auto* open =
      action(tr("Open a city or a building"),
             tr("CityGML, CityJSON, footprints with heights; meshes: OBJ, glTF, COLLADA, PLY, STL, OFF"),
             QStringLiteral("open"), this);
  open->setObjectName(QStringLiteral("openButton"));
  auto* sample =
      action(tr("Try the sample town"), tr("Streets, rows, towers and courtyards, ready to cluster"),
             QStringLiteral("sample"), this);
  sample->setObjectName(QStringLiteral("sampleButton"));
  open->setDefault(true);
  auto* drop = new QLabel(tr("or drop files anywhere in this window; several become one model"), this);
  drop->setForegroundRole(QPalette::PlaceholderText);
  drop->setWordWrap(true);
  recentTitle_->setFont(scaled(font(), 1.1, QFont::DemiBold));
  recent_->setSpacing(2);

  auto* start = new QVBoxLayout;
  start->setSpacing(6);
  start->addWidget(open);
  start->addWidget(sample);
  start->addSpacing(4);
  start->addWidget(drop);
  start->addStretch(1);
  auto* past = new QVBoxLayout;
  past->setSpacing(6);  // or it would take that of the columns
  past->addWidget(recentTitle_);
  past->addLayout(recent_);
  past->addStretch(1);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(48);
  columns->addLayout(start, 5);
  columns->addLayout(past, 4);

  auto* inner = new QVBoxLayout;
  inner->addStretch(5);
  inner->addWidget(title);
  inner->addWidget(line);
  inner->addSpacing(fontMetrics().height());
  inner->addLayout(columns);
  inner->addStretch(3);
  auto* outer = new QHBoxLayout(this);
  const int margin = fontMetrics().averageCharWidth() * 6;
  outer->setContentsMargins(margin, margin / 2, margin, margin / 2);
  outer->addStretch(1);
  outer->addLayout(inner, 10);
  outer->addStretch(1);

  connect(open, &QCommandLinkButton::clicked, this, &StartPage::openRequested);
  connect(sample, &QCommandLinkButton::clicked, this, &StartPage::sampleRequested);
  setRecent({});
}

void StartPage::setRecent(const QStringList& paths) {
  while (QLayoutItem* item = recent_->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  recentTitle_->setVisible(!paths.isEmpty());
  for (const QString& path : paths.mid(0, kMostRecent)) {
    const QFileInfo file(path);
    // One line: a button keeps room for no more where its text breaks late.
    const QString folder = fontMetrics().elidedText(QDir::toNativeSeparators(file.path()), Qt::ElideMiddle,
                                                    fontMetrics().averageCharWidth() * kFolderCharacters);
    auto* button = action(withoutMnemonic(file.fileName()), folder, QStringLiteral("sample"), this);
    button->setIconSize(QSize(20, 20));
    button->setToolTip(QDir::toNativeSeparators(path));
    connect(button, &QCommandLinkButton::clicked, this, [this, path] { Q_EMIT recentChosen(path); });
    recent_->addWidget(button);
  }
}

void StartPage::paintEvent(QPaintEvent* event) {
  QWidget::paintEvent(event);
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double width = std::min(this->width() * 0.84, 1100.0);
  const double height = width * 0.115;
  const QRectF area((this->width() - width) / 2, this->height() * 0.07, width, height);
  if (childrenRect().top() > area.bottom()) Skyline(painter, area, palette()).paint();
}

}  // namespace lodestone
