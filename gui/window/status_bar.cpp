#include "gui/window/status_bar.h"

#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QToolButton>

#include "gui/widgets/icons.h"
#include "model/io/places/georeference.h"

namespace lodestone {
namespace {
constexpr int kBarSteps = 1000;
}

StatusBar::StatusBar(Workspace& workspace, QWidget* parent)
    : QStatusBar(parent),
      workspace_(workspace),
      point_(new QLabel(this)),
      polygons_(new QLabel(this)),
      frame_(new QLabel(this)),
      task_(new QLabel(this)),
      progress_(new QProgressBar(this)),
      cancel_(new QToolButton(this)) {
  point_->setToolTip(tr("Point under the cursor, in the coordinate system of the model"));
  polygons_->setObjectName(QStringLiteral("statusPolygons"));
  polygons_->setToolTip(Workspace::polygonHelp());
  frame_->setToolTip(tr("Time that the last frame took"));
  progress_->setRange(0, kBarSteps);
  progress_->setTextVisible(false);
  progress_->setFixedWidth(fontMetrics().averageCharWidth() * 24);
  progress_->setMaximumHeight(fontMetrics().height());
  cancel_->setObjectName(QStringLiteral("cancel"));
  cancel_->setText(tr("Cancel"));
  cancel_->setIcon(icon(QStringLiteral("cancel")));
  cancel_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  cancel_->setAutoRaise(true);
  cancel_->setShortcut(Qt::Key_Escape);
  addWidget(task_);
  addWidget(progress_);
  addWidget(cancel_);
  addPermanentWidget(point_);
  addPermanentWidget(polygons_);
  addPermanentWidget(frame_);
  setBusy(false);

  connect(cancel_, &QToolButton::clicked, &workspace_.tasks(), &TaskRunner::cancelAll);
  connect(&workspace_.tasks(), &TaskRunner::started, this, [this](const QString&, const QString& title) {
    task_->setText(title);
    progress_->setValue(0);
    setBusy(true);
  });
  connect(&workspace_.tasks(), &TaskRunner::progressed, this,
          [this](const QString& title, double done, const QString& stage) {
            task_->setText(stage.isEmpty() ? title : QStringLiteral("%1: %2").arg(title, stage));
            progress_->setValue(static_cast<int>(done * kBarSteps));
          });
  connect(&workspace_.tasks(), &TaskRunner::idle, this, [this] { setBusy(false); });
  connect(&workspace_, &Workspace::cutChanged, this, &StatusBar::showPolygons);
}

void StatusBar::setBusy(bool busy) {
  for (QWidget* widget :
       {static_cast<QWidget*>(task_), static_cast<QWidget*>(progress_), static_cast<QWidget*>(cancel_)}) {
    widget->setVisible(busy);
  }
}

void StatusBar::setCityShown(bool shown) {
  for (QLabel* label : {point_, polygons_, frame_}) label->setVisible(shown);
}

void StatusBar::showPoint(double x, double y, double z) {
  const auto& city = workspace_.state().city;
  if (!city) return;
  const QLocale locale;
  const Vec3 world = toWorld(*city, Vec3(x, y, z));
  const bool degrees = city->crs.kind == CrsKind::Geographic;
  const int decimals = degrees ? 6 : 1;
  const QString place =
      QStringLiteral("%1  %2  %3")
          .arg(locale.toString(world.x(), 'f', decimals), locale.toString(world.y(), 'f', decimals),
               locale.toString(world.z(), 'f', 1));
  const QString name = QString::fromStdString(city->crs.name);
  point_->setText(name.isEmpty() ? place : QStringLiteral("%1  (%2)").arg(place, name));
}

void StatusBar::showPolygons() {
  if (!workspace_.state().city) {
    polygons_->clear();
    return;
  }
  const QLocale locale;
  const FaceCount& drawn = workspace_.facesDrawn();
  polygons_->setText(tr("%1 polygons (%2%)")
                         .arg(locale.toString(static_cast<qulonglong>(drawn.polygons)),
                              locale.toString(100 * share(drawn, workspace_.facesOfAll()), 'f', 1)));
}

void StatusBar::showFrame(double ms) {
  frame_->setText(tr("%1 ms").arg(QLocale().toString(ms, 'f', ms < 10 ? 1 : 0)));
}

}  // namespace lodestone
