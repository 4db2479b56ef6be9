#include "gui/city/method_panel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QGroupBox>
#include <QLabel>
#include <QListWidget>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "gui/city/cut_form.h"
#include "gui/widgets/icons.h"
#include "gui/widgets/parameter_panel.h"

namespace lodestone {
namespace {

constexpr int kMostBarrierRows = 4;  // more are scrolled

QString labelOf(const QString& name) {
  const auto find = [&](const auto& table) {
    for (const auto& field : table) {
      if (QString::fromStdString(field.name) == name) return QString::fromStdString(field.label);
    }
    return QString();
  };
  const QString label = find(fields<ClusterOptions>());
  return label.isEmpty() ? find(fields<MergeOptions>()) : label;
}

}  // namespace

MethodPanel::MethodPanel(Workspace& workspace, QWidget* parent)
    : QWidget(parent), workspace_(workspace), cut_(new CutForm(workspace, this)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->setSpacing(10);
  layout->addWidget(makeFigures());
  layout->addWidget(makeRun());
  layout->addWidget(cut_);
  layout->addWidget(makeClusterGroup());
  layout->addStretch(1);

  connect(&workspace_, &Workspace::stateChanged, this, &MethodPanel::showState);
  connect(&workspace_, &Workspace::cutChanged, this, &MethodPanel::showFigures);
  connect(&workspace_.tasks(), &TaskRunner::started, this, &MethodPanel::showRunButton);
  connect(&workspace_.tasks(), &TaskRunner::finished, this, &MethodPanel::showRunButton);
  showState();
  showFigures();
}

FieldSlider& MethodPanel::epsilon() {
  return cut_->epsilon();
}
FieldSlider& MethodPanel::alpha() {
  return cut_->alpha();
}

QWidget* MethodPanel::makeFigures() {
  auto* box = new QWidget(this);
  polygons_ = new QLabel(box);
  polygons_->setObjectName(QStringLiteral("polygonCount"));
  share_ = new QLabel(box);
  share_->setObjectName(QStringLiteral("polygonShare"));
  QFont large = font();
  large.setPointSizeF(large.pointSizeF() * 1.9);
  large.setWeight(QFont::DemiBold);
  polygons_->setFont(large);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(2, 0, 2, 0);
  layout->setSpacing(0);
  layout->addWidget(polygons_);
  layout->addWidget(share_);
  box->setToolTip(Workspace::polygonHelp());
  return box;
}

QWidget* MethodPanel::makeRun() {
  auto* box = new QWidget(this);
  run_ = new QPushButton(box);
  run_->setObjectName(QStringLiteral("run"));
  run_->setDefault(true);
  run_->setMinimumHeight(fontMetrics().height() * 2);
  run_->setToolTip(tr("Dendrogram and merged hulls of all buildings, with the parameters below"));
  outdated_ = new QLabel(tr("Parameters have changed since the tree was made."), box);
  outdated_->setWordWrap(true);
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(run_);
  layout->addWidget(outdated_);
  connect(run_, &QPushButton::clicked, this, [this] {
    if (workspace_.tasks().busy(Workspace::clusterTask())) {
      workspace_.tasks().cancel(Workspace::clusterTask());
    } else {
      workspace_.cluster();
    }
  });
  return box;
}

QWidget* MethodPanel::makeClusterGroup() {
  auto* group = new QGroupBox(tr("Legible simplification"), this);
  group->setWhatsThis(
      tr("Clusters, merged hulls and landmarks after Chang, Butkiewicz, Ziemkiewicz, Wartell, Pollard and "
         "Ribarsky: Legible Simplification of Textured Urban Models, 2008."));
  parameters_ = new ParameterPanel(group);
  parameters_->addFields<ClusterOptions>();
  parameters_->addFields<MergeOptions>();
  barriers_ = new QListWidget(group);
  barriers_->setObjectName(QStringLiteral("barriers"));
  barriers_->setToolTip(tr("Streets, rails and rivers that clusters should not cross"));
  barriers_->hide();
  auto* add = new QPushButton(icon(QStringLiteral("streets")), tr("Add barrier lines…"), group);
  auto* remove = new QPushButton(tr("Remove"), group);
  auto* row = new QHBoxLayout;
  row->addWidget(add, 1);
  row->addWidget(remove);
  auto* layout = new QVBoxLayout(group);
  layout->setSpacing(8);
  layout->addWidget(parameters_);
  layout->addWidget(barriers_);
  layout->addLayout(row);

  connect(parameters_, &ParameterPanel::edited, this, [this](const QString& name) {
    const QString what = tr("Change %1").arg(labelOf(name));
    // Both are read before the first is set, which shows the state's values again.
    const ClusterOptions clustering = parameters_->read(workspace_.state().clusterOptions);
    const MergeOptions merging = parameters_->read(workspace_.state().mergeOptions);
    workspace_.setClusterOptions(clustering, what);
    workspace_.setMergeOptions(merging, what);
  });
  connect(add, &QPushButton::clicked, this, &MethodPanel::addBarriers);
  connect(remove, &QPushButton::clicked, this, [this] {
    QStringList paths;
    for (int i = 0; i < barriers_->count(); ++i) {
      if (!barriers_->item(i)->isSelected() && barriers_->count() > 1) paths << barriers_->item(i)->toolTip();
    }
    workspace_.setBarriers(paths);
  });
  connect(this, &MethodPanel::barriersPresent, remove, &QWidget::setVisible);
  return group;
}

void MethodPanel::addBarriers() {
  const QStringList files = QFileDialog::getOpenFileNames(
      this, tr("Barrier lines"), {},
      tr("Vector layers (*.geojson *.json *.shp *.gpkg *.fgb *.osm *.pbf *.gz);;All files (*)"));
  if (files.isEmpty()) return;
  QStringList all;
  for (const std::string& path : workspace_.state().barriers) all << QString::fromStdString(path);
  workspace_.setBarriers(all + files);
}

void MethodPanel::showState() {
  const ProjectState& state = workspace_.state();
  parameters_->show(state.clusterOptions);
  parameters_->show(state.mergeOptions);
  barriers_->clear();
  for (const std::string& path : state.barriers) {
    auto* item = new QListWidgetItem(QFileInfo(QString::fromStdString(path)).fileName(), barriers_);
    item->setToolTip(QString::fromStdString(path));
  }
  if (const int rows = std::min(barriers_->count(), kMostBarrierRows); rows > 0)
    barriers_->setFixedHeight(rows * barriers_->sizeHintForRow(0) + 2 * barriers_->frameWidth());
  barriers_->setVisible(!state.barriers.empty());
  Q_EMIT barriersPresent(!state.barriers.empty());
  outdated_->setVisible(workspace_.treeOutdated());
  showRunButton();
}

void MethodPanel::showRunButton() {
  const bool running = workspace_.tasks().busy(Workspace::clusterTask());
  run_->setEnabled(running || workspace_.canCluster());
  run_->setText(running ? tr("Cancel") : workspace_.state().tree ? tr("Cluster again") : tr("Cluster"));
  run_->setIcon(icon(running ? QStringLiteral("cancel") : QStringLiteral("cluster")));
}

void MethodPanel::showFigures() {
  const QLocale locale;
  const bool open = workspace_.state().city != nullptr;
  const FaceCount& drawn = workspace_.facesDrawn();
  const FaceCount& all = workspace_.facesOfAll();
  polygons_->setText(open ? locale.toString(static_cast<qulonglong>(drawn.polygons)) : QStringLiteral("–"));
  share_->setText(open ? tr("polygons, %1% of %2")
                             .arg(locale.toString(100 * share(drawn, all), 'f', 1),
                                  locale.toString(static_cast<qulonglong>(all.polygons)))
                       : tr("polygons"));
}

}  // namespace lodestone
