#include "gui/simplification/stage_legend.h"

#include <QLabel>
#include <QLinearGradient>
#include <QLocale>
#include <QPainter>
#include <QToolButton>

#include "gui/simplification/class_icon.h"
#include "gui/simplification/surface_images.h"
#include "gui/view3d/component_colours.h"
#include "gui/widgets/detail_looks.h"
#include "gui/widgets/flow_layout.h"
#include "gui/widgets/icons.h"

namespace lodestone {
namespace {

QColor colourOf(const Rgb& colour) {
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

QIcon brokenIcon() {
  QPixmap picture(32, 32);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colourOf(fateColour(ContactFate::Separated)), 4));
  painter.drawEllipse(QPointF(9, 16), 6, 6);
  painter.setPen(QPen(colourOf(fateColour(ContactFate::Lost)), 4));
  painter.drawLine(20, 11, 30, 21);
  painter.drawLine(30, 11, 20, 21);
  return picture;
}

/// The scale of E–C angles, 0 to 90°.
class AngleScale : public QWidget {
 public:
  explicit AngleScale(QWidget* parent) : QWidget(parent) {
    setFixedSize(fontMetrics().averageCharWidth() * 18, fontMetrics().height());
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const QString low = QStringLiteral("0° ");
    const QString high = QStringLiteral(" 90°");
    const int left = fontMetrics().horizontalAdvance(low);
    const int right = width() - fontMetrics().horizontalAdvance(high);
    QLinearGradient gradient(left, 0, right, 0);
    for (int i = 0; i <= 8; ++i) gradient.setColorAt(i / 8.0, colourOf(angleColour(i * 90 / 8.0)));
    painter.fillRect(QRect(left, height() / 2 - 4, right - left, 8), gradient);
    painter.drawText(rect(), Qt::AlignLeft | Qt::AlignVCenter, low);
    painter.drawText(rect(), Qt::AlignRight | Qt::AlignVCenter, high);
  }
};

/// The classes of detail by name, beside their colours.
class DetailScale : public QWidget {
 public:
  explicit DetailScale(QWidget* parent) : QWidget(parent) {
    for (const DetailClass detail : kAllDetail)
      entries_.emplace_back(lodestone::colourOf(detail), nameOf(detail));
    entries_.emplace_back(colourOfUnseen(), StageLegend::tr("Unseen"));
    int wide = 0;
    for (const auto& [colour, name] : entries_) wide += stepOf(name);
    setFixedSize(wide, fontMetrics().height());
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const int side = height() * 2 / 3;
    int x = 0;
    for (const auto& [colour, name] : entries_) {
      painter.fillRect(QRect(x, (height() - side) / 2, side, side), colour);
      painter.drawText(QRect(x + side + 4, 0, width(), height()), Qt::AlignLeft | Qt::AlignVCenter, name);
      x += stepOf(name);
    }
  }

 private:
  [[nodiscard]] int stepOf(const QString& name) const {
    return fontMetrics().horizontalAdvance(name) + fontMetrics().height() * 2 / 3 + 14;
  }

  std::vector<std::pair<QColor, QString>> entries_;
};

}  // namespace

StageLegend::StageLegend(Stage& stage, QWidget* parent) : QWidget(parent), stage_(stage) {
  auto* row = new FlowLayout(this);  // beside wide docks there is no room for all of them in a line
  row->setContentsMargins(6, 3, 6, 3);
  row->setSpacing(4);
  components_ =
      addSwitch(QStringLiteral("showComponents"), tr("Components"), icon(QStringLiteral("components")), true,
                tr("Give each component a colour of its own"));
  textures_ = addSwitch(QStringLiteral("showTextures"), tr("Textures"), {}, false,
                        tr("The model's own textures and materials"));
  details_ =
      addSwitch(QStringLiteral("showDetails"), tr("Classes of detail"), icon(QStringLiteral("eye")), false,
                tr("How much of its detail the eye filters away: each triangle of the original, and what is "
                   "left of it, in the colour of its class; those that no picture shows in grey (Du, "
                   "Zhu and Zhao)"));
  auto* scale = new DetailScale(this);
  row->addWidget(scale);
  scale->hide();
  connect(details_, &QToolButton::toggled, scale, &QWidget::setVisible);
  const auto excludes = [](QToolButton* one, QToolButton* other) {  // a face has one look
    connect(one, &QToolButton::toggled, other, [other](bool on) {
      if (on) other->setChecked(false);
    });
  };
  for (QToolButton* one : {components_, textures_, details_}) {
    for (QToolButton* other : {components_, textures_, details_}) {
      if (one != other) excludes(one, other);
    }
  }
  const struct {
    VertexClass vertexClass;
    const char* name;
    QString help;
    bool on;
  } classes[] = {
      {VertexClass::Boundary, "showBoundary",
       tr("Boundary vertices: they lie inside another component or on it. Moving them is expensive"), true},
      {VertexClass::Hole, "showHole",
       tr("Hole vertices: they end an edge with one triangle and touch nothing"), true},
      {VertexClass::Ordinary, "showOrdinary", tr("All other vertices: they go first"), false}};
  for (const auto& [vertexClass, name, help, on] : classes) {
    glyphs_[static_cast<std::size_t>(vertexClass)] =
        addSwitch(QString::fromLatin1(name), QString(), classIcon(vertexClass), on, help);
  }
  angles_ = addSwitch(
      QStringLiteral("showAngles"), tr("E–C angle"), {}, false,
      tr("Boundary edges, coloured by the angle between the edge and the plane of the component that "
         "it meets: 0° in the plane, 90° across it. A steep edge is expensive to shorten"));
  row->addWidget(new AngleScale(this));
  contacts_ =
      addSwitch(QStringLiteral("showContacts"), tr("Broken contacts"), brokenIcon(), true,
                tr("Where components touched in the original: a ring where a gap opened between them, a "
                   "cross where one of them is gone"));
  connect(details_, &QToolButton::toggled, this, &StageLegend::showDetails);
  for (const auto change : {&Stage::opening, &Stage::opened, &Stage::closed})
    connect(&stage_, change, this, [this] {
      showCounts();
      showTextures();
    });
  showCounts();
  showTextures();
}

QToolButton* StageLegend::addSwitch(const QString& name, const QString& text, const QIcon& icon, bool on,
                                    const QString& help) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(text);
  button->setIcon(icon);
  button->setToolButtonStyle(icon.isNull() ? Qt::ToolButtonTextOnly : Qt::ToolButtonTextBesideIcon);
  button->setCheckable(true);
  button->setChecked(on);
  button->setToolTip(help);
  button->setWhatsThis(help);
  layout()->addWidget(button);
  connect(button, &QToolButton::toggled, this, &StageLegend::changed);
  return button;
}

/// Signs on every vertex would hide the colours of small triangles: they are put aside until then, and can be
/// put on again.
void StageLegend::showDetails(bool on) {
  if (on) {
    putAside_.clear();
    for (QToolButton* sign : {glyphs_[0], glyphs_[1], glyphs_[2], angles_}) {
      if (sign->isChecked()) putAside_.push_back(sign);
    }
  }
  for (QToolButton* sign : putAside_) sign->setChecked(!on);
}

void StageLegend::showTextures() {
  const bool any = stage_.isOpen() && hasOwnLook(*stage_.staged()->surfaces);
  if (textures_->isChecked() && stage_.isOpen() && !any) components_->setChecked(true);
  textures_->setEnabled(any);
  textures_->setToolTip(any || !stage_.isOpen() ? textures_->whatsThis()
                                                : tr("This model has neither textures nor materials"));
}

void StageLegend::showCounts() {
  std::array<std::size_t, 3> counts{};
  if (stage_.isOpen()) {
    for (const ComponentCounts& component : stage_.staged()->counts) {
      for (std::size_t i = 0; i < counts.size(); ++i) counts[i] += component.vertices[i];
    }
  }
  const QString names[] = {tr("Ordinary"), tr("Boundary"), tr("Hole")};
  for (std::size_t i = 0; i < counts.size(); ++i) {
    glyphs_[i]->setText(QStringLiteral("%1 %2").arg(
        names[i], stage_.isOpen() ? QLocale().toString(static_cast<qulonglong>(counts[i])) : QString()));
  }
}

}  // namespace lodestone
