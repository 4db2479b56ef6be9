#include "gui/view3d/point_overlay.h"

#include <string>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>

namespace lodestone {
namespace {

/// Depth units by which VTK's shader brings points forward: signs on a face lie a little before it, those on
/// top before everything.
constexpr double kForward = -24;
constexpr double kToTheFront = -60000;

/// How far a place of the sign is inside it (positive) or outside, where the sign reaches from −1 to 1.
std::string insideOf(PointShape shape) {
  switch (shape) {
    case PointShape::Circle:
      return "0.30 - abs(length(q) - 0.62)";
    case PointShape::Square:
      return "0.80 - max(abs(q.x), abs(q.y))";
    case PointShape::Cross:
      return "min(0.24 - min(abs(q.x - q.y), abs(q.x + q.y)) * 0.7071, 0.92 - max(abs(q.x), abs(q.y)))";
    case PointShape::Disc:
      break;
  }
  return "0.92 - length(q)";
}

/// After VTK's light: the colour as given within the sign, a dark rim, nothing outside.
std::string fragmentCode(PointShape shape) {
  return "//VTK::Light::Impl\n"
         "  vec2 q = gl_PointCoord * 2.0 - 1.0;\n"
         "  float inside = " +
         insideOf(shape) +
         ";\n"
         "  if (inside < 0.0) discard;\n"
         "  float rim = 1.0 - smoothstep(0.06, 0.18, inside);\n"
         "  fragOutput0 = vec4(fragOutput0.rgb * mix(1.0, 0.25, rim), 1.0);\n";
}

}  // namespace

PointOverlay::PointOverlay(vtkRenderer* renderer, PointShape shape, double size, bool onTop)
    : renderer_(renderer), actor_(vtkSmartPointer<vtkActor>::New()), size_(size) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->ScalarVisibilityOff();
  mapper->StaticOn();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPointOffsetParameter(onTop ? kToTheFront : kForward);
  actor_->SetMapper(mapper);
  actor_->PickableOff();
  actor_->UseBoundsOff();
  actor_->GetProperty()->LightingOff();
  actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, fragmentCode(shape),
                                                            false);
  actor_->VisibilityOff();
  setPixelRatio(1);
  renderer_->AddActor(actor_);
}

PointOverlay::~PointOverlay() {
  renderer_->RemoveActor(actor_);
}

void PointOverlay::setPoints(std::span<const Vec3> given) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(given.size()));
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const auto id = static_cast<vtkIdType>(i);
    points->SetPoint(id, given[i].data());
    cells->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(cells);
  vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(data);
}

void PointOverlay::setColour(const Rgb& colour) {
  actor_->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
}

void PointOverlay::setVisible(bool visible) {
  auto* data = vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->GetInput();
  actor_->SetVisibility(visible && data && data->GetNumberOfVerts() > 0);
}

void PointOverlay::setPixelRatio(double ratio) {
  actor_->GetProperty()->SetPointSize(static_cast<float>(size_ * ratio));
}

}  // namespace lodestone
