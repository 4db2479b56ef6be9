#include "gui/city/layers_panel.h"

#include <QComboBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QJsonDocument>
#include <QLabel>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/city/layer_style_row.h"
#include "gui/widgets/icons.h"

namespace lodestone {
namespace {

constexpr int kShownAtFirst = Qt::UserRole;

QString keyOf(SceneLayer layer) {
  static constexpr const char* keys[kSceneLayerCount] = {"buildings", "surroundings", "lines"};
  return QString::fromLatin1(keys[static_cast<std::size_t>(layer)]);
}

QString keyOf(Overlay overlay) {
  static constexpr const char* keys[kOverlayCount] = {"hulls",   "negativeSpace", "landmarks",
                                                      "streets", "ground",        "edges"};
  return QString::fromLatin1(keys[static_cast<std::size_t>(overlay)]);
}

QJsonObject toJson(const LayerStyle& style) {
  QJsonObject json{{QStringLiteral("visible"), style.visible},
                   {QStringLiteral("opacity"), static_cast<double>(style.opacity)}};
  if (style.colour) {
    const Rgb& c = *style.colour;
    json[QStringLiteral("colour")] = QColor::fromRgbF(c[0], c[1], c[2]).name();
  }
  return json;
}

/// A project file may say anything: what is no style is the first one.
LayerStyle toStyle(const QJsonObject& json) {
  LayerStyle style;
  style.visible = json[QStringLiteral("visible")].toBool(style.visible);
  style.opacity = std::clamp(static_cast<float>(json[QStringLiteral("opacity")].toDouble(1)), 0.0F, 1.0F);
  const QColor colour(json[QStringLiteral("colour")].toString());
  if (colour.isValid()) style.colour = Rgb{colour.redF(), colour.greenF(), colour.blueF()};
  return style;
}

}  // namespace

LayersPanel::LayersPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent),
      workspace_(workspace),
      tree_(new QTreeWidget(this)),
      colours_(new QComboBox(this)),
      styleRow_(new LayerStyleRow(this)) {
  tree_->setObjectName(QStringLiteral("layerTree"));
  tree_->setHeaderHidden(true);
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(fontMetrics().averageCharWidth() * 2);
  city_ = addRow(nullptr, tr("City model"), QStringLiteral("sample"), true);
  surroundings_ = addRow(nullptr, tr("Surroundings"), QStringLiteral("plan"), true);
  surroundings_->setToolTip(0, tr("Terrain, water, vegetation, bridges and whatever else is no building"));
  lines_ = addRow(nullptr, tr("Lines"), QStringLiteral("streets"), true);
  QTreeWidgetItem* method = addGroup(tr("Legible simplification"), QStringLiteral("cluster"));
  addOverlay(method, Overlay::Landmarks, tr("Landmarks"), QStringLiteral("landmark"), true,
             tr("Buildings that stand out of their cluster by more than α, drawn beside it"));
  addOverlay(method, Overlay::Hulls, tr("Merged hulls"), QStringLiteral("hulls"), false,
             tr("Outlines of the drawn clusters on the ground"));
  addOverlay(method, Overlay::NegativeSpace, tr("Negative space"), QStringLiteral("negative"), false,
             tr("Boxes of the area that clusters add to their buildings: what ε measures"));
  QTreeWidgetItem* picture = addGroup(tr("Picture"), QStringLiteral("picture"));
  addOverlay(picture, Overlay::Ground, tr("Ground"), QStringLiteral("plan"), true,
             tr("The plane that the city stands on"));
  addOverlay(picture, Overlay::Edges, tr("Edges"), QStringLiteral("perspective"), true,
             tr("Lines along the edges of blocks"));
  tree_->expandAll();

  colours_->setObjectName(QStringLiteral("sceneColours"));
  colours_->addItem(tr("By role: building, cluster, landmark"), static_cast<int>(SceneColours::ByRole));
  colours_->addItem(tr("By cluster"), static_cast<int>(SceneColours::ByCluster));
  auto* label = new QLabel(tr("Colours"), this);
  label->setBuddy(colours_);
  auto* row = new QHBoxLayout;
  row->addWidget(label);
  row->addWidget(colours_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->addWidget(tree_, 1);
  layout->addWidget(styleRow_);
  layout->addLayout(row);

  connect(tree_, &QTreeWidget::itemChanged, this, [this](QTreeWidgetItem* item, int) { itemChanged(item); });
  connect(tree_, &QTreeWidget::currentItemChanged, this, &LayersPanel::currentChanged);
  connect(styleRow_, &LayerStyleRow::edited, this, &LayersPanel::styleEdited);
  connect(colours_, &QComboBox::currentIndexChanged, this, [this] {
    Q_EMIT coloursChanged(static_cast<SceneColours>(colours_->currentData().toInt()));
    keep(tr("Change colours"));
  });
  connect(&workspace_, &Workspace::stateChanged, this,
          [this](const ProjectState& before, const ProjectState& after) {
            if (before.city != after.city || before.looks != after.looks) showLooks();
            if (before.city == after.city) return;
            rebuildCity();
            rebuildSurroundings();
            rebuildLines();
          });
  connect(&workspace_, &Workspace::barrierLinesChanged, this, &LayersPanel::rebuildLines);
  rebuildCity();
  rebuildSurroundings();
  rebuildLines();
  tree_->setCurrentItem(city_);
}

std::optional<SceneLayer> LayersPanel::layerOf(const QTreeWidgetItem* item) const {
  const QTreeWidgetItem* top = item && item->parent() ? item->parent() : item;
  if (!top) return {};
  if (top == city_) return SceneLayer::Buildings;
  if (top == surroundings_) return SceneLayer::Surroundings;
  if (top == lines_) return SceneLayer::Lines;
  return {};
}

QTreeWidgetItem* LayersPanel::rowOf(SceneLayer layer) const {
  return layer == SceneLayer::Buildings ? city_ : layer == SceneLayer::Surroundings ? surroundings_ : lines_;
}

QJsonObject LayersPanel::view() const {
  QJsonObject view;
  for (std::size_t i = 0; i < kSceneLayerCount; ++i)
    view[keyOf(static_cast<SceneLayer>(i))] = toJson(styles_[i]);
  for (const auto& [overlay, row] : overlays_) view[keyOf(overlay)] = isShown(overlay);
  view[QStringLiteral("byCluster")] =
      colours_->currentData().toInt() == static_cast<int>(SceneColours::ByCluster);
  return view;
}

void LayersPanel::keep(const QString& what, const QString& mergeKey) {
  if (keeping_) workspace_.setLooks(QJsonDocument(view()).toJson(QJsonDocument::Compact), what, mergeKey);
}

void LayersPanel::showLooks() {
  const QJsonObject kept =
      QJsonDocument::fromJson(QByteArray::fromStdString(workspace_.state().looks)).object();
  if (kept != view()) setView(kept);
}

void LayersPanel::styleEdited(const LayerStyle& style) {
  const std::optional<SceneLayer> layer = layerOf(tree_->currentItem());
  if (!layer) return;
  LayerStyle& kept = styles_[static_cast<std::size_t>(*layer)];
  const bool opacity = kept.opacity != style.opacity;
  kept = style;
  layerEdited(*layer);
  keep(opacity ? tr("Change opacity") : tr("Change colour"),
       opacity ? QStringLiteral("opacity-") + keyOf(*layer) : QString());
}

void LayersPanel::setView(const QJsonObject& view) {
  const QScopedValueRollback quiet(keeping_, false);
  for (std::size_t i = 0; i < kSceneLayerCount; ++i) {
    const auto layer = static_cast<SceneLayer>(i);
    setStyle(layer, toStyle(view[keyOf(layer)].toObject()));
  }
  for (const auto& [overlay, row] : overlays_)
    setShown(overlay, view[keyOf(overlay)].toBool(row->data(0, kShownAtFirst).toBool()));
  const bool byCluster = view[QStringLiteral("byCluster")].toBool();
  colours_->setCurrentIndex(
      colours_->findData(static_cast<int>(byCluster ? SceneColours::ByCluster : SceneColours::ByRole)));
}

void LayersPanel::setStyle(SceneLayer layer, const LayerStyle& style) {
  styles_[static_cast<std::size_t>(layer)] = style;
  rowOf(layer)->setCheckState(0, style.visible ? Qt::Checked : Qt::Unchecked);
  layerEdited(layer);
  currentChanged();
}

void LayersPanel::currentChanged() {
  const std::optional<SceneLayer> layer = layerOf(tree_->currentItem());
  styleRow_->setEnabled(layer.has_value());
  styleRow_->show(layer ? style(*layer) : LayerStyle{});
}

void LayersPanel::layerEdited(SceneLayer layer) {
  Q_EMIT layerStyled(layer, style(layer));
}

void LayersPanel::rebuildSurroundings() {
  const QSignalBlocker quiet(tree_);
  const auto& city = workspace_.state().city;
  const std::size_t count = city ? city->others.size() : 0;
  surroundings_->setHidden(count == 0);
  surroundings_->setText(
      0, (count == 1 ? tr("Surroundings, %L1 object") : tr("Surroundings, %L1 objects")).arg(count));
}

QTreeWidgetItem* LayersPanel::addRow(QTreeWidgetItem* parent, const QString& title, const QString& iconName,
                                     bool on) {
  auto* item = parent ? new QTreeWidgetItem(parent, {title}) : new QTreeWidgetItem(tree_, {title});
  item->setIcon(0, icon(iconName));
  item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  item->setCheckState(0, on ? Qt::Checked : Qt::Unchecked);
  return item;
}

QTreeWidgetItem* LayersPanel::addGroup(const QString& title, const QString& iconName) {
  auto* item = new QTreeWidgetItem(tree_, {title});
  item->setIcon(0, icon(iconName));
  item->setFlags(Qt::ItemIsEnabled);
  return item;
}

void LayersPanel::addOverlay(QTreeWidgetItem* group, Overlay overlay, const QString& title,
                             const QString& iconName, bool on, const QString& help) {
  QTreeWidgetItem* item = addRow(group, title, iconName, on);
  item->setToolTip(0, help);
  item->setWhatsThis(0, help);
  item->setData(0, kShownAtFirst, on);
  overlays_[overlay] = item;
}

void LayersPanel::rebuildCity() {
  const QSignalBlocker quiet(tree_);
  qDeleteAll(city_->takeChildren());
  const auto& city = workspace_.state().city;
  city_->setHidden(!city);
  if (!city) return;
  for (const Source& source : city->sources) {
    auto* item = new QTreeWidgetItem(city_, {QFileInfo(QString::fromStdString(source.path)).fileName()});
    item->setToolTip(0, QString::fromStdString(source.path + "\n" + source.format + " " + source.version));
    item->setFlags(Qt::ItemIsEnabled);
  }
  city_->setText(0, city->buildings.size() == 1
                        ? tr("City model, 1 building")
                        : tr("City model, %L1 buildings").arg(city->buildings.size()));
  city_->setExpanded(city->sources.size() < 8);
}

void LayersPanel::rebuildLines() {
  const QSignalBlocker quiet(tree_);
  qDeleteAll(lines_->takeChildren());
  const auto add = [this](const LineLayer& layer, const QString& what) {
    const QString name = layer.name.empty() ? what : QString::fromStdString(layer.name);
    const auto count = layer.lines.size();
    QTreeWidgetItem* item =
        addRow(lines_, (count == 1 ? tr("%1, %L2 line") : tr("%1, %L2 lines")).arg(name).arg(count),
               QStringLiteral("streets"), true);
    item->setToolTip(0, what);
  };
  if (workspace_.state().city) {
    for (const LineLayer& layer : workspace_.state().city->lines) add(layer, tr("Lines of the model"));
  }
  for (const LineLayer& layer : workspace_.barrierLines()) add(layer, tr("Barriers"));
  lines_->setHidden(lines_->childCount() == 0);
  lines_->setExpanded(true);
  Q_EMIT linesChanged();
}

std::vector<LineLayer> LayersPanel::shownLines() const {
  std::vector<LineLayer> all;
  if (workspace_.state().city) all = workspace_.state().city->lines;
  all.insert(all.end(), workspace_.barrierLines().begin(), workspace_.barrierLines().end());
  std::vector<LineLayer> shown;
  if (lines_->checkState(0) == Qt::Unchecked) return shown;
  for (std::size_t i = 0; i < all.size() && static_cast<int>(i) < lines_->childCount(); ++i) {
    if (lines_->child(static_cast<int>(i))->checkState(0) == Qt::Checked) shown.push_back(std::move(all[i]));
  }
  return shown;
}

void LayersPanel::itemChanged(QTreeWidgetItem* item) {
  const bool on = item->checkState(0) == Qt::Checked;
  if (!item->parent()) {
    if (const std::optional<SceneLayer> layer = layerOf(item)) {
      styles_[static_cast<std::size_t>(*layer)].visible = on;
      if (item == tree_->currentItem()) styleRow_->show(style(*layer));
      layerEdited(*layer);
      keep((on ? tr("Show %1") : tr("Hide %1")).arg(item->text(0)));
    }
  }
  if (item == lines_ || item->parent() == lines_) Q_EMIT linesChanged();
  for (const auto& [overlay, row] : overlays_) {
    if (row != item) continue;
    Q_EMIT overlayChanged(overlay, on);
    keep((on ? tr("Show %1") : tr("Hide %1")).arg(item->text(0)));
  }
}

bool LayersPanel::isShown(Overlay overlay) const {
  const auto found = overlays_.find(overlay);
  return found == overlays_.end() || found->second->checkState(0) == Qt::Checked;
}

void LayersPanel::setShown(Overlay overlay, bool shown) {
  const auto found = overlays_.find(overlay);
  if (found != overlays_.end()) found->second->setCheckState(0, shown ? Qt::Checked : Qt::Unchecked);
}

}  // namespace lodestone
