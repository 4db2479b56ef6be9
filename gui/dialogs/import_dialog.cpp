#include "gui/dialogs/import_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <cmath>

#include "gui/widgets/icons.h"
#include "gui/widgets/parameter_panel.h"
#include "model/io/footprints/footprints.h"
#include "model/io/places/georeference.h"

namespace lodestone {

/// The sampled footprints in plan.
class OutlinePreview : public QWidget {
 public:
  using QWidget::QWidget;
  void show(const std::vector<Ring>& rings) {
    rings_ = rings;
    update();
  }
  [[nodiscard]] QSize sizeHint() const override {
    return {fontMetrics().height() * 18, fontMetrics().height() * 16};
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(palette().color(QPalette::Base));
    painter.drawRoundedRect(rect(), 6, 6);
    Box2 box;
    for (const Ring& ring : rings_) box.add(lodestone::bounds(ring));
    if (box.empty()) {
      painter.setPen(palette().color(QPalette::PlaceholderText));
      painter.drawText(rect(), Qt::AlignCenter, tr("no polygons"));
      return;
    }
    const double scale = std::min((width() - 16) / std::max(box.size().x(), 1e-9),
                                  (height() - 16) / std::max(box.size().y(), 1e-9));
    QPainterPath path;
    for (const Ring& ring : rings_) {
      QPolygonF polygon;
      for (const Vec2& p : ring) {
        const Vec2 q = (p - box.center()) * scale;
        polygon << QPointF(width() / 2.0 + q.x(), height() / 2.0 - q.y());
      }
      path.addPolygon(polygon);
    }
    painter.setBrush(accentColor());
    painter.drawPath(path);
  }

 private:
  std::vector<Ring> rings_;
};

namespace {

enum HeightKind { Usual, HeightField, FloorField, Constant };
constexpr int kKindRole = Qt::UserRole;
constexpr int kFieldRole = Qt::UserRole + 1;

QString rangeOf(const FieldPreview& field) {
  const QLocale locale;
  return QStringLiteral("%1 – %2").arg(locale.toString(field.min, 'g', 4),
                                       locale.toString(field.max, 'g', 4));
}

/// Nothing is left to ask: one layer of polygons, with a coordinate system and heights in a field that is
/// known.
bool saysItAll(const VectorPreview& preview) {
  const LayerPreview& layer = preview.layers.front();
  return preview.layers.size() == 1 && layer.hasPolygons && layer.saysHeights && !layer.crs.empty();
}

}  // namespace

std::optional<VectorPreview> ImportDialog::questionsFor(const QStringList& paths) {
  for (const QString& path : paths) {
    const Format* format = formatForReading(path.toStdString());
    if (!format || format->id != footprintFormat().id) continue;
    Result<VectorPreview> preview = previewVector(path.toStdString());
    if (preview && !preview->layers.empty() && !saysItAll(*preview)) return std::move(preview.value);
  }
  return std::nullopt;
}

ImportDialog::ImportDialog(const QStringList& paths, VectorPreview preview, const ImportOptions& options,
                           QWidget* parent)
    : QDialog(parent),
      preview_(std::move(preview)),
      given_(options),
      layers_(new QComboBox(this)),
      heights_(new QComboBox(this)),
      floorHeight_(new QDoubleSpinBox(this)),
      constant_(new QDoubleSpinBox(this)),
      crs_(new QLineEdit(this)),
      crsFound_(new QLabel(this)),
      crsNote_(new QLabel(this)),
      heightNote_(new QLabel(this)),
      picture_(new OutlinePreview(this)) {
  const QString file = QFileInfo(paths.value(0)).fileName();
  setWindowTitle(paths.size() > 1 ? tr("Import %1 files").arg(paths.size()) : tr("Import %1").arg(file));
  auto* title = new QLabel(tr("%1 does not say everything. What it says is filled in.").arg(file), this);
  title->setWordWrap(true);
  layers_->setObjectName(QStringLiteral("layer"));
  heights_->setObjectName(QStringLiteral("height"));
  crs_->setObjectName(QStringLiteral("crs"));
  crs_->setPlaceholderText(QStringLiteral("EPSG:25833"));
  for (QDoubleSpinBox* box : {floorHeight_, constant_}) {
    box->setRange(0.1, 1000);
    box->setDecimals(1);
    box->setSuffix(QStringLiteral(" m"));
  }
  floorHeight_->setValue(given_.floorHeight);
  const double constant = QString::fromStdString(given_.height).toDouble();
  if (constant > 0) given_.defaultHeight = constant;
  constant_->setValue(given_.defaultHeight);
  crs_->setText(QString::fromStdString(given_.crs));
  for (const LayerPreview& one : preview_.layers) {
    const QString count =
        one.features < 0 ? tr("not counted")
                         : (one.features == 1 ? tr("%L1 feature") : tr("%L1 features")).arg(one.features);
    if (one.hasPolygons || preview_.layers.size() == 1) {
      layers_->addItem(QStringLiteral("%1 (%2)").arg(QString::fromStdString(one.name), count),
                       QString::fromStdString(one.name));
      if (one.read) layers_->setCurrentIndex(layers_->count() - 1);
    }
  }
  heightNote_->setForegroundRole(QPalette::PlaceholderText);
  heightNote_->setWordWrap(true);
  crsFound_->setWordWrap(true);
  crsNote_->setForegroundRole(QPalette::PlaceholderText);
  crsNote_->setWordWrap(true);

  auto* form = new QFormLayout;
  form->addRow(tr("&Layer"), layers_);
  form->addRow(tr("&Heights from"), heights_);
  form->addRow(tr("Height of a &floor"), floorHeight_);
  form->addRow(tr("Height where there is &none"), constant_);
  form->addRow(QString(), heightNote_);
  form->addRow(tr("In the file"), crsFound_);
  form->addRow(tr("Take &instead"), crs_);
  form->addRow(QString(), crsNote_);
  for (const Field<ImportOptions>& row : fields<ImportOptions>()) {
    const QString help = helpText(row);
    if (row.name == "layer") layers_->setToolTip(help);
    if (row.name == "height") heights_->setToolTip(help);
    if (row.name == "floor-height") floorHeight_->setToolTip(help);
    if (row.name == "default-height") constant_->setToolTip(help);
    if (row.name == "crs") crs_->setToolTip(help);
  }
  form->labelForField(layers_)->setVisible(layers_->count() > 1);
  layers_->setVisible(layers_->count() > 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  import_ = buttons->button(QDialogButtonBox::Ok);
  import_->setText(tr("Import"));
  auto* columns = new QHBoxLayout;
  columns->setSpacing(18);
  columns->addLayout(form, 3);
  columns->addWidget(picture_, 2);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(16, 16, 16, 12);
  layout->setSpacing(14);
  layout->addWidget(title);
  layout->addLayout(columns, 1);
  layout->addWidget(buttons);

  connect(layers_, &QComboBox::currentIndexChanged, this, &ImportDialog::showLayer);
  connect(heights_, &QComboBox::currentIndexChanged, this, &ImportDialog::showField);
  connect(crs_, &QLineEdit::textChanged, this, &ImportDialog::showSystem);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  showLayer();
  showSystem();
  resize(fontMetrics().averageCharWidth() * 110, sizeHint().height());
}

void ImportDialog::paintEvent(QPaintEvent* event) {
  QDialog::paintEvent(event);
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

const LayerPreview* ImportDialog::layer() const {
  for (const LayerPreview& one : preview_.layers) {
    if (QString::fromStdString(one.name) == layers_->currentData().toString()) return &one;
  }
  return preview_.layers.empty() ? nullptr : &preview_.layers.front();
}

const FieldPreview* ImportDialog::field() const {
  if (!layer()) return nullptr;
  for (const FieldPreview& one : layer()->fields) {
    if (QString::fromStdString(one.name) == heights_->currentData(kFieldRole).toString()) return &one;
  }
  return nullptr;
}

void ImportDialog::showLayer() {
  const LayerPreview* shown = layer();
  heights_->clear();
  const auto add = [this](const QString& title, HeightKind kind, const QString& name) {
    heights_->addItem(title, kind);
    heights_->setItemData(heights_->count() - 1, name, kFieldRole);
  };
  add(tr("Usual fields (height, building:levels, …)"), Usual, {});
  if (shown) {
    for (const FieldPreview& one : shown->fields) {
      if (one.numeric)
        add(tr("%1: metres").arg(QString::fromStdString(one.name)), HeightField,
            QString::fromStdString(one.name));
    }
    for (const FieldPreview& one : shown->fields) {
      if (one.numeric)
        add(tr("%1: number of floors").arg(QString::fromStdString(one.name)), FloorField,
            QString::fromStdString(one.name));
    }
  }
  add(tr("One height for all"), Constant, {});
  chooseGivenHeights();
  picture_->show(shown ? shown->outlines : std::vector<Ring>());
  const bool known = shown && !shown->crs.empty();
  crsFound_->setText(known ? QString::fromStdString(shown->crs)
                           : tr("No coordinate system: taken as metres"));
  showField();
}

void ImportDialog::chooseGivenHeights() {
  const bool constant = !given_.height.empty() && QString::fromStdString(given_.height).toDouble() > 0;
  const HeightKind kind = constant                 ? Constant
                          : !given_.height.empty() ? HeightField
                          : !given_.floors.empty() ? FloorField
                                                   : Usual;
  const QString name = kind == HeightField  ? QString::fromStdString(given_.height)
                       : kind == FloorField ? QString::fromStdString(given_.floors)
                                            : QString();
  for (int i = 0; i < heights_->count(); ++i) {
    const bool same = heights_->itemData(i, kKindRole).toInt() == kind &&
                      heights_->itemData(i, kFieldRole).toString() == name;
    if (same) heights_->setCurrentIndex(i);
  }
}

void ImportDialog::showField() {
  const int kind = heights_->currentData(kKindRole).toInt();
  floorHeight_->setEnabled(kind == FloorField || kind == Usual);
  if (const FieldPreview* shown = field()) {
    QStringList samples;
    for (const std::string& sample : shown->samples) samples << QString::fromStdString(sample);
    heightNote_->setText(tr("%1; such as %2").arg(rangeOf(*shown), samples.join(QStringLiteral(", "))));
  } else {
    heightNote_->setText(kind == Constant ? tr("Every building gets the height above.")
                                          : tr("Where no field holds a height, the height above is taken."));
  }
}

/// What stands in the field is a system, or there is nothing to import by.
void ImportDialog::showSystem() {
  const std::string given = crs_->text().trimmed().toStdString();
  const bool known = !whyNoSystem(given);
  crsNote_->setText(known ? QString::fromStdString(resolveCrs(given).name)
                          : tr("No such coordinate system: a code such as EPSG:25833 is wanted."));
  import_->setEnabled(known);
}

ImportOptions ImportDialog::options() const {
  ImportOptions options = given_;
  const int kind = heights_->currentData(kKindRole).toInt();
  const std::string name = heights_->currentData(kFieldRole).toString().toStdString();
  // What nobody changed stays what it was, whatever digits the boxes have for it.
  const auto valueOf = [](const QDoubleSpinBox& box, double given) {
    return std::abs(box.value() - given) <= 0.5001 * std::pow(10, -box.decimals()) ? given : box.value();
  };
  options.height = kind == HeightField ? name
                   : kind == Constant
                       ? QString::number(valueOf(*constant_, given_.defaultHeight), 'g', 17).toStdString()
                       : "";
  options.floors = kind == FloorField ? name : "";
  options.floorHeight = valueOf(*floorHeight_, given_.floorHeight);
  options.defaultHeight = valueOf(*constant_, given_.defaultHeight);
  options.layer = layers_->count() > 1 ? layers_->currentData().toString().toStdString() : "";
  options.crs = crs_->text().trimmed().toStdString();
  return options;
}

}  // namespace lodestone
