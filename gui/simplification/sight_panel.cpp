#include "gui/simplification/sight_panel.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/simplification/sight_picture.h"
#include "gui/widgets/counted.h"
#include "gui/widgets/flow_layout.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/parameter_panel.h"
#include "gui/widgets/row_table.h"
#include "model/io/places/georeference.h"

namespace lodestone {
namespace {

constexpr int kTarget = Qt::UserRole;
/// Those that have a row of counts; what is never seen is not counted.
constexpr std::array kCounted{TargetFate::Seen, TargetFate::Appeared, TargetFate::Vanished};

QColor colourOf(const Rgb& colour) {
  return QColor::fromRgbF(colour[0], colour[1], colour[2]);
}

QString nameOf(Past past) {
  switch (past) {
    case Past::A:
      return SightPanel::tr("A");
    case Past::B:
      return SightPanel::tr("B");
    case Past::Original:
      break;
  }
  return SightPanel::tr("Original");
}

QString nameOf(TargetFate fate) {
  switch (fate) {
    case TargetFate::Appeared:
      return SightPanel::tr("Newly seen");
    case TargetFate::Vanished:
      return SightPanel::tr("Now hidden");
    default:
      return SightPanel::tr("Seen");
  }
}

QString number(std::size_t value) {
  return QLocale().toString(static_cast<qulonglong>(value));
}

}  // namespace

SightPanel::SightPanel(Sight& sight, QWidget* parent)
    : QWidget(parent),
      sight_(sight),
      place_(new QPushButton(icon(QStringLiteral("fly")), tr("Place viewpoint"), this)),
      fields_(new ParameterPanel(this)),
      position_(new QLineEdit(this)),
      state_(new QLabel(this)),
      results_(new QWidget(this)),
      differing_(new QCheckBox(tr("Only those that differ"), this)),
      table_(new QTableWidget(0, 4, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 4);
  addButtons(*layout);
  fields_->addFields<SightOptions>({"placed", "x", "y", "z"});
  layout->addWidget(fields_);
  addPosition(*layout);
  state_->setObjectName(QStringLiteral("sightState"));
  state_->setWordWrap(true);
  layout->addWidget(state_);
  layout->addWidget(results_);
  addResults(*layout);
  layout->addStretch(0);

  connect(fields_, &ParameterPanel::edited, this, [this](const QString& name) {
    sight_.setOptions(fields_->read(sight_.options()), tr("Change viewpoint"),
                      QStringLiteral("sight-") + name);
  });
  for (const auto change : {&Sight::optionsChanged, &Sight::placingChanged})
    connect(&sight_, change, this, &SightPanel::showOptions);
  for (const auto change : {&Sight::seenChanged, &Sight::looking})
    connect(&sight_, change, this, &SightPanel::showSeen);
  connect(&sight_, &Sight::targetChanged, this, &SightPanel::showChosen);
  for (const auto change : {&Stage::opening, &Stage::opened, &Stage::closed, &Stage::comparingChanged})
    connect(&sight_.stage(), change, this, &SightPanel::showOptions);
  setTheme(SceneTheme::Light);
  showOptions();
}

void SightPanel::addPosition(QVBoxLayout& layout) {
  auto* row = new QHBoxLayout;
  auto* label = new QLabel(tr("Eye at"), this);
  label->setBuddy(position_);
  position_->setObjectName(QStringLiteral("sightPosition"));
  position_->setPlaceholderText(tr("x; y; height"));
  position_->setToolTip(
      tr("Where the eye is, in the coordinates of the model: x; y; height. Type or paste "
         "a place to look from there."));
  row->addWidget(label);
  row->addWidget(position_, 1);
  layout.addLayout(row);
  connect(position_, &QLineEdit::editingFinished, this, &SightPanel::readPosition);
}

QToolButton* SightPanel::addTool(QLayout& layout, const QString& name, const QString& text,
                                 const QString& iconName, const QString& help) {
  auto* button = new QToolButton(this);
  button->setObjectName(name);
  button->setText(text);
  button->setIcon(icon(iconName));
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setAutoRaise(true);
  button->setToolTip(help);
  layout.addWidget(button);
  return button;
}

void SightPanel::addButtons(QVBoxLayout& layout) {
  place_->setObjectName(QStringLiteral("placeViewpoint"));
  place_->setCheckable(true);
  place_->setToolTip(tr(
      "Click the ground in the view; drag to say in which direction and how far sight goes. Later drag the "
      "ring to move the viewpoint, the squares to turn and open it."));
  layout.addWidget(place_);
  auto* row = new FlowLayout;  // the dock may be narrow
  row->setSpacing(2);
  camera_ = addTool(*row, QStringLiteral("sightFromCamera"), tr("From camera"), QStringLiteral("perspective"),
                    tr("Put the viewpoint where the camera is: it sees what this view sees"));
  look_ = addTool(*row, QStringLiteral("sightLook"), tr("Look from it"), QStringLiteral("eye"),
                  tr("Take the camera to the viewpoint"));
  remove_ = addTool(*row, QStringLiteral("sightRemove"), tr("Remove"), QStringLiteral("cancel"),
                    tr("Remove the viewpoint"));
  layout.addLayout(row);
  connect(place_, &QPushButton::toggled, &sight_, &Sight::setPlacing);
  connect(camera_, &QToolButton::clicked, this, &SightPanel::fromCameraRequested);
  connect(look_, &QToolButton::clicked, this, &SightPanel::lookRequested);
  connect(remove_, &QToolButton::clicked, &sight_, &Sight::remove);
}

void SightPanel::addResults(QVBoxLayout& layout) {
  auto* column = new QVBoxLayout(results_);
  column->setContentsMargins(0, 0, 0, 0);
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  column->addLayout(row);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(4);
  grid->setVerticalSpacing(2);
  grid->setColumnStretch(1, 1);
  for (const int level : {2, 3, 4}) grid->setColumnMinimumWidth(level, fontMetrics().averageCharWidth() * 3);
  column->addLayout(grid);
  for (const Past past : kPasts) {
    const auto i = static_cast<std::size_t>(past);
    titles_[i] = new QLabel(nameOf(past), results_);
    titles_[i]->setAlignment(Qt::AlignCenter);
    grid->addWidget(titles_[i], 0, static_cast<int>(i) + 2);
    pictures_[i] = new SightPicture([this](std::uint32_t target) { return sight_.nameOf(target); }, results_);
    pictures_[i]->setAccessibleName(tr("Seen past %1").arg(nameOf(past)));
    row->addWidget(pictures_[i], 1);
    connect(pictures_[i], &SightPicture::picked, &sight_,
            [this](std::uint32_t target) { sight_.choose(target); });
  }
  for (const TargetFate fate : kCounted) {
    const auto f = static_cast<std::size_t>(fate);
    const int line = static_cast<int>(f);
    swatches_[f] = new QLabel(results_);
    grid->addWidget(swatches_[f], line, 0);
    grid->addWidget(new QLabel(nameOf(fate), results_), line, 1);
    for (const Past past : kPasts) {
      const auto i = static_cast<std::size_t>(past);
      counts_[f][i] = new QLabel(results_);
      counts_[f][i]->setAlignment(Qt::AlignCenter);
      grid->addWidget(counts_[f][i], line, static_cast<int>(i) + 2);
    }
  }
  differing_->setObjectName(QStringLiteral("sightDiffering"));
  differing_->setChecked(true);
  layout.addWidget(differing_);
  table_->setObjectName(QStringLiteral("sightTargets"));
  table_->setHorizontalHeaderLabels(
      {tr("Building"), nameOf(Past::Original), nameOf(Past::A), nameOf(Past::B)});
  makeRowTable(*table_);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setStretchLastSection(true);
  table_->setToolTip(tr("Pixels of each building in the pictures; double-click to fly there"));
  table_->setMinimumHeight(fontMetrics().height() * 5);
  layout.addWidget(table_);
  connect(differing_, &QCheckBox::toggled, this, &SightPanel::showRows);
  connect(table_, &QTableWidget::itemSelectionChanged, this, [this] {
    const auto rows = table_->selectionModel()->selectedRows();
    if (!rows.isEmpty()) sight_.choose(rows.first().data(kTarget).toULongLong());
  });
  connect(table_, &QTableWidget::itemActivated, this, [this](const QTableWidgetItem* item) {
    sight_.flyTo(table_->item(item->row(), 0)->data(kTarget).toULongLong());
  });
}

void SightPanel::setTheme(SceneTheme theme) {
  palette_ = theme == SceneTheme::Dark ? darkPalette() : lightPalette();
  const int size = fontMetrics().height() * 2 / 3;
  for (const TargetFate fate : kCounted) {
    QPixmap swatch(QSize(size, size) * devicePixelRatioF());
    swatch.setDevicePixelRatio(devicePixelRatioF());
    swatch.fill(colourOf(targetColour(fate, palette_)));
    swatches_[static_cast<std::size_t>(fate)]->setPixmap(swatch);
  }
  showRows();
}

void SightPanel::showOptions() {
  const SightOptions& options = sight_.options();
  const QSignalBlocker quiet(place_);
  place_->setChecked(sight_.isPlacing());
  place_->setEnabled(sight_.hasTargets());
  camera_->setEnabled(sight_.hasTargets());
  fields_->setEnabled(sight_.hasTargets());
  fields_->show(options);
  const bool placed = sight_.hasTargets() && options.placed;
  look_->setEnabled(placed);
  remove_->setEnabled(placed);
  position_->setEnabled(sight_.hasTargets());
  showPosition();
  showSeen();
}

void SightPanel::showPosition() {
  const SightOptions& options = sight_.options();
  QStringList parts;
  if (sight_.hasTargets() && options.placed) {
    const CityModel& city = *sight_.stage().staged()->city;
    const Vec3 eye = toWorld(city, options.eye());
    const int digits = city.crs.kind == CrsKind::Geographic ? 7 : 2;
    parts << QLocale().toString(eye.x(), 'f', digits) << QLocale().toString(eye.y(), 'f', digits)
          << QLocale().toString(eye.z(), 'f', 2);
  }
  position_->setText(parts.join(QStringLiteral("; ")));
  position_->setCursorPosition(0);
}

/// What is no place is put back as it was.
void SightPanel::readPosition() {
  if (!position_->isModified()) return;
  static const QRegularExpression between(QStringLiteral("\\s*;\\s*|\\s+"));
  Vec3 eye;
  const QStringList parts = position_->text().trimmed().split(between);
  bool understood = parts.size() == 3;
  for (Eigen::Index i = 0; understood && i < 3; ++i) eye[i] = QLocale().toDouble(parts[i], &understood);
  if (understood) eye = toLocal(*sight_.stage().staged()->city, eye);
  if (!understood || !eye.allFinite()) return showPosition();
  SightOptions options = sight_.options();
  options.standAt(eye - Vec3(0, 0, options.height));
  sight_.setOptions(options, tr("Change viewpoint"), QStringLiteral("sight-position"));
}

void SightPanel::showSeen() {
  const Sighting* original = sight_.sighting(Past::Original);
  for (const Past past : kPasts) {
    const auto i = static_cast<std::size_t>(past);
    const bool shown = past != Past::B || sight_.stage().comparing();
    const auto sighting = sight_.seen() ? sight_.seen()->sightings[i] : nullptr;
    pictures_[i]->show(sighting, original);
    for (QWidget* widget : {static_cast<QWidget*>(pictures_[i]), static_cast<QWidget*>(titles_[i])})
      widget->setVisible(shown);
    std::array<std::size_t, kFates> counts{};
    for (std::uint32_t t = 0; sighting && t < sighting->pixels.size(); ++t)
      ++counts[static_cast<std::size_t>(fateOf(*sight_.seen(), past, t))];
    // Whatever is seen, newly or not.
    counts[static_cast<std::size_t>(TargetFate::Seen)] +=
        counts[static_cast<std::size_t>(TargetFate::Appeared)];
    for (const TargetFate fate : kCounted) {
      QLabel& label = count(fate, past);
      label.setVisible(shown && (past != Past::Original || fate == TargetFate::Seen));
      label.setText(sighting ? number(counts[static_cast<std::size_t>(fate)]) : QStringLiteral("–"));
    }
  }
  results_->setVisible(original != nullptr);
  differing_->setVisible(original != nullptr);
  showState();
  showRows();
}

void SightPanel::showState() {
  const auto& seen = sight_.seen();
  QString text;
  if (!sight_.stage().isOpen()) {
    text = tr("No building is on the stage.");
  } else if (!sight_.hasTargets()) {
    text = tr(
        "There is nothing else to see. Add a city (drop its file on the window): the targets are its other "
        "buildings.");
  } else if (sight_.isPlacing()) {
    text = tr("Click the ground in the view, or drag from there to where sight goes.");
  } else if (!sight_.options().placed) {
    text = tr(
        "Which other buildings are seen past the original, and past what is made of it? Place a viewpoint.");
  } else if (sight_.isOutdated()) {
    text = sight_.isLooking() ? tr("Looking…") : tr("Stopped. Move the viewpoint to look again.");
  } else if (seen->enclosing) {
    text = tr("The eye is inside %1, and sees its walls alone: move it, or raise it.")
               .arg(sight_.nameOf(*seen->enclosing));
  } else {
    const auto* distance = qobject_cast<const QDoubleSpinBox*>(fields_->editor("distance"));
    text = tr("%1 within %2.")  // as the box says it
               .arg(counted(seen->within, tr("building"), tr("buildings")), distance->text());
  }
  state_->setText(text);
}

bool SightPanel::isListed(std::uint32_t target) const {
  return std::any_of(kPasts.begin(), kPasts.end(), [&](Past past) {
    const TargetFate fate = fateOf(*sight_.seen(), past, target);
    return fate == TargetFate::Appeared || fate == TargetFate::Vanished ||
           (fate == TargetFate::Seen && !differing_->isChecked());
  });
}

void SightPanel::showRows() {
  const QSignalBlocker quiet(table_);
  table_->setRowCount(0);
  table_->setColumnHidden(3, !sight_.stage().comparing());
  const Sighting* original = sight_.sighting(Past::Original);
  std::vector<std::uint32_t> rows;
  for (std::uint32_t t = 0; original && t < original->pixels.size(); ++t) {
    if (isListed(t)) rows.push_back(t);
  }
  table_->setRowCount(static_cast<int>(rows.size()));
  for (int row = 0; row < table_->rowCount(); ++row) {
    const std::uint32_t target = rows[static_cast<std::size_t>(row)];
    auto* item = new QTableWidgetItem(sight_.nameOf(target));
    item->setData(kTarget, static_cast<qulonglong>(target));
    table_->setItem(row, 0, item);
    for (const Past past : kPasts) showFate(row, past, target);
  }
  table_->setVisible(!rows.empty());
  const bool level = sight_.sighting(Past::A) != nullptr;
  if (original && level && rows.empty() && !sight_.isOutdated() && !sight_.seen()->enclosing)
    state_->setText(state_->text() + QStringLiteral(" ") + tr("Past every model the same are seen."));
  showChosen();
}

void SightPanel::showFate(int row, Past past, std::uint32_t target) {
  const Sighting* sighting = sight_.sighting(past);
  if (!sighting) return;
  auto* item =
      new QTableWidgetItem(sighting->sees(target) ? number(sighting->pixels[target]) : QStringLiteral("–"));
  const TargetFate fate = fateOf(*sight_.seen(), past, target);
  item->setData(Qt::DecorationRole, colourOf(targetColour(fate, palette_)));
  item->setToolTip(fate == TargetFate::Unseen ? tr("Not seen") : nameOf(fate));
  table_->setItem(row, 1 + static_cast<int>(past), item);
}

void SightPanel::showChosen() {
  const QSignalBlocker quiet(table_);
  table_->clearSelection();
  for (int row = 0; sight_.target() && row < table_->rowCount(); ++row) {
    if (table_->item(row, 0)->data(kTarget).toULongLong() == *sight_.target()) table_->selectRow(row);
  }
}

}  // namespace lodestone
