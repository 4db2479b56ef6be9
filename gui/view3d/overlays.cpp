#include "gui/view3d/overlays.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

namespace lodestone {

LineOverlay::LineOverlay(vtkRenderer* renderer, double width, double opacity)
    : renderer_(renderer), actor_(vtkSmartPointer<vtkActor>::New()), width_(width) {
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetColorModeToDirectScalars();
  mapper->StaticOn();
  // Lines lie on faces: they are drawn a little nearer.
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyLineOffsetParameters(-2, -8);
  actor_->SetMapper(mapper);
  actor_->PickableOff();
  actor_->UseBoundsOff();
  actor_->GetProperty()->LightingOff();
  actor_->GetProperty()->SetOpacity(opacity);
  actor_->VisibilityOff();
  setPixelRatio(1);
  renderer_->AddActor(actor_);
}

LineOverlay::~LineOverlay() {
  renderer_->RemoveActor(actor_);
}

void LineOverlay::setLines(const LineSegments& lines) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(lines.segments.size() * 2));
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(lines.segments.size()),
                       static_cast<vtkIdType>(lines.segments.size() * 2));
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("colour");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(lines.segments.size() * 2));
  vtkIdType next = 0;
  for (std::size_t i = 0; i < lines.segments.size(); ++i) {
    std::array<unsigned char, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
      rgb[c] = static_cast<unsigned char>(lines.colours[i][c] * 255.0F + 0.5F);
    std::array<vtkIdType, 2> ends{};
    for (std::size_t end = 0; end < 2; ++end) {
      points->SetPoint(next, lines.segments[i][end].data());
      colours->SetTypedTuple(next, rgb.data());
      ends[end] = next++;
    }
    cells->InsertNextCell(2, ends.data());
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(cells);
  data->GetPointData()->SetScalars(colours);
  vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->SetInputData(data);
}

void LineOverlay::setVisible(bool visible) {
  const bool drawable = vtkPolyDataMapper::SafeDownCast(actor_->GetMapper())->GetInput() != nullptr;
  actor_->SetVisibility(visible && drawable);
}

void LineOverlay::setOpacity(double opacity) {
  actor_->GetProperty()->SetOpacity(opacity);
}

void LineOverlay::setPixelRatio(double ratio) {
  actor_->GetProperty()->SetLineWidth(static_cast<float>(width_ * ratio));
}

}  // namespace lodestone
