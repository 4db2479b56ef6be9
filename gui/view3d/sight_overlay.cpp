#include "gui/view3d/sight_overlay.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

namespace lodestone {
namespace {

constexpr double kAreaOpacity = 0.22;

vtkSmartPointer<vtkActor> areaIn(vtkRenderer* renderer) {
  auto actor = vtkSmartPointer<vtkActor>::New();
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->ScalarVisibilityOff();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->UseBoundsOff();
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetOpacity(kAreaOpacity);
  actor->VisibilityOff();
  renderer->AddActor(actor);
  return actor;
}

}  // namespace

SightOverlay::SightOverlay(vtkRenderer* renderer)
    : renderer_(renderer),
      area_(areaIn(renderer)),
      lines_(renderer, 2, 1),
      eye_(renderer, PointShape::Disc, 11, true),
      foot_(renderer, PointShape::Circle, 19, true),
      handles_(renderer, PointShape::Square, 11, true) {}

SightOverlay::~SightOverlay() {
  renderer_->RemoveActor(area_);
}

void SightOverlay::show(const std::optional<SightOptions>& sight, const Palette& palette) {
  area_->SetVisibility(sight.has_value());
  for (PointOverlay* points : {&eye_, &foot_, &handles_}) points->setVisible(false);
  lines_.setVisible(false);
  if (!sight) return;
  showArea(*sight, palette);
  LineSegments lines;
  const std::vector<Vec3> arc = arcOf(*sight);
  for (std::size_t i = 0; i + 1 < arc.size(); ++i) lines.add(arc[i], arc[i + 1], palette.sight);
  lines.add(sight->foot(), arc.front(), palette.sight);
  lines.add(sight->foot(), arc.back(), palette.sight);
  lines.add(sight->foot(), sight->eye(), palette.sight);
  lines_.setLines(lines);
  lines_.setVisible(true);
  eye_.setPoints(std::vector<Vec3>{sight->eye()});
  foot_.setPoints(std::vector<Vec3>{sight->foot()});
  std::vector<Vec3> handles;
  for (const SightHandle handle : {SightHandle::Far, SightHandle::Left, SightHandle::Right})
    handles.push_back(handlePoint(*sight, handle));
  handles_.setPoints(handles);
  for (PointOverlay* points : {&eye_, &foot_, &handles_}) {
    points->setColour(palette.sight);
    points->setVisible(true);
  }
}

void SightOverlay::showArea(const SightOptions& sight, const Palette& palette) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  points->InsertNextPoint(sight.foot().data());
  for (const Vec3& point : arcOf(sight)) {
    const vtkIdType id = points->InsertNextPoint(point.data());
    if (id < 2) continue;
    const std::array<vtkIdType, 3> corners{0, id - 1, id};
    cells->InsertNextCell(3, corners.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkPolyDataMapper::SafeDownCast(area_->GetMapper())->SetInputData(data);
  area_->GetProperty()->SetColor(palette.sight[0], palette.sight[1], palette.sight[2]);
}

void SightOverlay::setPixelRatio(double ratio) {
  lines_.setPixelRatio(ratio);
  for (PointOverlay* points : {&eye_, &foot_, &handles_}) points->setPixelRatio(ratio);
}

}  // namespace lodestone
