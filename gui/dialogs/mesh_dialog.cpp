#include "gui/dialogs/mesh_dialog.h"

#include <QButtonGroup>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPainter>
#include <QPointer>
#include <QPushButton>
#include <QToolButton>
#include <QVBoxLayout>

#include "model/io/format.h"

namespace lodestone {
namespace {

const QString kTask = QStringLiteral("meshPictures");
constexpr int kOther = -1;  ///< the unit that is typed
/// Extents that hardly any building has, metres.
constexpr double kSmallest = 1;
constexpr double kLargest = 1000;

QString lengthText(double metres) {
  return QLocale().toString(metres, 'f', metres < 1 ? 3 : metres < 100 ? 1 : 0);
}

}  // namespace

QStringList MeshDialog::askedFor(const QStringList& paths) {
  QStringList asked;
  for (const QString& path : paths) {
    const std::string file = path.toStdString();
    if (isMeshFormat(formatForReading(file)) && upAxisOf(file).assumed) asked << path;
  }
  return asked;
}

MeshDialog::MeshDialog(const QStringList& paths, const ImportOptions& options, TaskRunner& tasks,
                       QWidget* parent)
    : QDialog(parent),
      given_(options),
      assumed_(upAxisOf(paths.value(0).toStdString())),
      tasks_(tasks),
      axes_(new QButtonGroup(this)),
      units_(new QComboBox(this)),
      other_(new QDoubleSpinBox(this)),
      size_(new QLabel(this)) {
  const QString file = QFileInfo(paths.value(0)).fileName();
  setWindowTitle(paths.size() > 1 ? tr("%1 meshes").arg(paths.size()) : file);
  auto* question = new QLabel(
      assumed_.assumed
          ? tr("%1 says neither which axis points up nor what its unit is. Which is right?").arg(file)
          : tr("Which way does %1 stand, and what is its unit?").arg(file),
      this);
  question->setWordWrap(true);
  auto* cards = new QHBoxLayout;
  zUp_ = addCard(QStringLiteral("zUp"), tr("z is up"));
  yUp_ = addCard(QStringLiteral("yUp"), tr("y is up"));
  for (QToolButton* card : {zUp_, yUp_}) cards->addWidget(card);
  const bool y = options.upAxis == UpAxisOption::Auto ? assumed_.y : options.upAxis == UpAxisOption::Y;
  (y ? yUp_ : zUp_)->setChecked(true);
  addUnits(options.unit);
  auto* form = new QFormLayout;
  auto* unitRow = new QHBoxLayout;
  unitRow->addWidget(units_);
  unitRow->addWidget(other_);
  unitRow->addStretch(1);
  form->addRow(tr("One unit is"), unitRow);
  form->addRow(tr("Size"), size_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Import"));
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(16, 14, 16, 14);
  column->setSpacing(10);
  column->addWidget(question);
  column->addLayout(cards);
  column->addLayout(form);
  column->addWidget(buttons);
  connect(axes_, &QButtonGroup::buttonClicked, this, &MeshDialog::showSize);
  showSize();
  tasks_.start(
      kTask, tr("Drawing %1").arg(file),
      [path = paths.value(0), size = zUp_->iconSize() * devicePixelRatioF()](const Progress& progress) {
        return drawMesh(path, size, progress);
      },
      [dialog = QPointer(this)](const MeshPictures& pictures) {
        if (dialog) dialog->show(pictures);
      });
}

MeshDialog::~MeshDialog() {
  tasks_.cancel(kTask);
}

QToolButton* MeshDialog::addCard(const QString& name, const QString& text) {
  auto* card = new QToolButton(this);
  card->setObjectName(name);
  card->setText(text);
  card->setCheckable(true);
  card->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  card->setIconSize(QSize(16, 12) * fontMetrics().height());
  axes_->addButton(card);
  return card;
}

void MeshDialog::addUnits(double unit) {
  units_->setObjectName(QStringLiteral("unit"));
  other_->setObjectName(QStringLiteral("otherUnit"));
  const std::pair<QString, double> known[] = {{tr("1 metre"), 1},
                                              {tr("1 centimetre"), 0.01},
                                              {tr("1 millimetre"), 0.001},
                                              {tr("1 foot"), 0.3048},
                                              {tr("1 inch"), 0.0254}};
  for (const auto& [name, metres] : known) units_->addItem(name, metres);
  units_->addItem(tr("another length"), kOther);
  other_->setDecimals(6);
  other_->setRange(1e-6, 1e6);
  other_->setSuffix(tr(" m"));
  other_->setValue(unit);
  const int place = units_->findData(unit);
  units_->setCurrentIndex(place >= 0 ? place : units_->count() - 1);
  connect(units_, &QComboBox::currentIndexChanged, this, &MeshDialog::showSize);
  connect(other_, &QDoubleSpinBox::valueChanged, this, &MeshDialog::showSize);
}

void MeshDialog::show(const MeshPictures& pictures) {
  pictures_ = pictures;
  const auto iconOf = [this](QImage image) {
    image.setDevicePixelRatio(devicePixelRatioF());
    return QIcon(QPixmap::fromImage(image));
  };
  if (!pictures.zUp.isNull()) zUp_->setIcon(iconOf(pictures.zUp));
  if (!pictures.yUp.isNull()) yUp_->setIcon(iconOf(pictures.yUp));
  showSize();
}

double MeshDialog::unit() const {
  const double metres = units_->currentData().toDouble();
  return metres == kOther ? other_->value() : metres;
}

void MeshDialog::showSize() {
  other_->setVisible(units_->currentData().toDouble() == kOther);
  if (!pictures_.trouble.isEmpty()) return size_->setText(pictures_.trouble);
  const Vec3 size = unit() * pictures_.size;
  if (size.norm() == 0) return size_->setText(tr("being read…"));
  const bool y = yUp_->isChecked();
  QString text = tr("%1 × %2 m, %3 m high")
                     .arg(lengthText(size.x()), lengthText(y ? size.z() : size.y()),
                          lengthText(y ? size.y() : size.z()));
  if (size.maxCoeff() < kSmallest) text += tr(": small for a building");
  if (size.maxCoeff() > kLargest) text += tr(": large for a building");
  size_->setText(text);
}

ImportOptions MeshDialog::options() const {
  ImportOptions options = given_;
  options.unit = unit();
  // What is assumed anyway stays open, for files that are added later and say themselves what is up.
  options.upAxis = yUp_->isChecked() == assumed_.y ? UpAxisOption::Auto
                   : yUp_->isChecked()             ? UpAxisOption::Y
                                                   : UpAxisOption::Z;
  return options;
}

void MeshDialog::paintEvent(QPaintEvent* event) {
  QDialog::paintEvent(event);
  QPainter painter(this);
  painter.setPen(palette().color(QPalette::Mid));
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace lodestone
