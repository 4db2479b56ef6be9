#include "gui/view3d/surface_overlay.h"

#include <algorithm>
#include <map>

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>
#include <vtkUnsignedCharArray.h>

#include "model/level_colours.h"

namespace lodestone {
namespace {

/// `repeated`: coordinates go beyond the image. Else its opposite edges must not show through at its own.
vtkSmartPointer<vtkTexture> textureOf(const SurfaceImage& image, bool repeated) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::copy(image.rgba.begin(), image.rgba.end(), static_cast<std::uint8_t*>(data->GetScalarPointer()));
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(data);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetRepeat(repeated);
  texture->SetEdgeClamp(!repeated);
  return texture;
}

Rgb lookOf(const SurfaceInfo& surface, const SurfaceLook& look) {
  const auto material = static_cast<std::size_t>(surface.material);
  if (surface.material >= 0 && material < look.materials.size()) return look.materials[material];
  return surfaceColour(DrawRole::Building, surface.type);
}

/// The image that a triangle shows: null where it has none, or does not say what of it.
std::shared_ptr<const SurfaceImage> imageOf(const ComponentMesh& mesh, std::uint32_t triangle,
                                            const SurfaceLook& look) {
  const std::int32_t texture = mesh.surfaces[triangle].texture;
  if (texture < 0 || static_cast<std::size_t>(texture) >= look.textures.size()) return nullptr;
  if (mesh.textureCoordinates.empty()) return nullptr;
  const auto& corners = mesh.textureCoordinates[triangle];
  const bool known =
      std::all_of(corners.begin(), corners.end(), [](const Vec2f& st) { return st.allFinite(); });
  return known ? look.textures[static_cast<std::size_t>(texture)] : nullptr;
}

}  // namespace

SurfaceOverlay::SurfaceOverlay(vtkRenderer* renderer) : renderer_(renderer) {}

SurfaceOverlay::~SurfaceOverlay() {
  clear();
}

void SurfaceOverlay::clear() {
  for (const auto& actor : actors_) renderer_->RemoveActor(actor);
  actors_.clear();
}

void SurfaceOverlay::show(const std::shared_ptr<const ComponentMesh>& mesh, const std::vector<bool>& drawn,
                          const std::shared_ptr<const SurfaceLook>& look,
                          const std::shared_ptr<const PaintedTriangles>& painted) {
  const auto paint = painted && painted->mesh == mesh ? painted : nullptr;
  if (mesh == mesh_ && look == look_ && paint == painted_ && drawn == drawn_) return;
  mesh_ = mesh;
  look_ = look;
  painted_ = paint;
  drawn_ = drawn;
  clear();
  if (!mesh || (!look && !painted_)) return;
  std::map<std::shared_ptr<const SurfaceImage>, std::vector<std::uint32_t>> byImage;
  for (std::size_t c = 0; c < mesh->components.size(); ++c) {
    const Component& component = mesh->components[c];
    for (std::uint32_t t = component.firstTriangle; drawn[c] && t < component.endTriangle(); ++t)
      byImage[painted_ ? nullptr : imageOf(*mesh, t, *look)].push_back(t);
  }
  for (const auto& [image, triangles] : byImage) addActor(triangles, image);
}

Rgb SurfaceOverlay::colourOf(std::uint32_t triangle) const {
  return painted_ ? painted_->colours[triangle] : lookOf(mesh_->surfaces[triangle], *look_);
}

void SurfaceOverlay::addActor(const std::vector<std::uint32_t>& triangles,
                              const std::shared_ptr<const SurfaceImage>& image) {
  const auto corners = static_cast<vtkIdType>(3 * triangles.size());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(corners);
  vtkNew<vtkFloatArray> coordinates;
  coordinates->SetNumberOfComponents(2);
  coordinates->SetNumberOfTuples(image ? corners : 0);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetNumberOfComponents(3);
  vtkNew<vtkCellArray> cells;
  vtkIdType next = 0;
  bool repeated = false;
  for (const std::uint32_t t : triangles) {
    cells->InsertNextCell({next, next + 1, next + 2});
    const Rgb colour = image ? Rgb{1, 1, 1} : colourOf(t);
    for (std::size_t i = 0; i < 3; ++i, ++next) {
      points->SetPoint(next, mesh_->vertices[mesh_->triangles[t][i]].data());
      if (!image) continue;
      const Vec2f& st = mesh_->textureCoordinates[t][i];
      coordinates->SetTypedTuple(next, st.data());
      repeated = repeated || st.minCoeff() < 0 || st.maxCoeff() > 1;
    }
    for (const float part : colour)
      colours->InsertNextValue(static_cast<unsigned char>(std::clamp(part, 0.0F, 1.0F) * 255 + 0.5F));
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  if (image) data->GetPointData()->SetTCoords(coordinates);
  data->GetCellData()->SetScalars(colours);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->StaticOn();
  mapper->SetResolveCoincidentTopologyToPolygonOffset();
  mapper->SetRelativeCoincidentTopologyPolygonOffsetParameters(1, 2);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->PickableOff();
  actor->UseBoundsOff();
  actor->GetProperty()->SetInterpolationToFlat();
  actor->GetProperty()->SetAmbient(0.55);
  actor->GetProperty()->SetDiffuse(0.5);
  if (image) actor->SetTexture(textureOf(*image, repeated));
  actors_.push_back(actor);
  renderer_->AddActor(actor);
}

}  // namespace lodestone
