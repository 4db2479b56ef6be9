#include "gui/view3d/city_prop.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <numbers>

#include <Eigen/Geometry>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLShaderCache.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>
#include <vtk_glew.h>

#include "gui/view3d/city_shaders.h"
#include "gui/view3d/gl_program.h"
#include "gui/view3d/gpu_mesh.h"
#include "gui/view3d/pixel_buffer.h"

namespace lodestone {
namespace {

constexpr int kColoursWidth =
    2048;  // of the texture that holds one colour a node; every OpenGL 3 allows as much

/// The camera of one frame in the form that the shaders take.
struct FrameView {
  Eigen::Matrix4d clipFromWorld = Eigen::Matrix4d::Identity();
  Vec3 eye, right, up, forward;
  bool parallel = false;
  double halfWidth = 1;  ///< of the picture: metres when parallel, else at distance 1
  double halfHeight = 1;
  Vec2 jitter = Vec2::Zero();
  double nearest = 1, farthest = 2;
  int width = 1, height = 1;
  int x = 0, y = 0;  ///< of the renderer's corner in the window, pixels from the lower left
  bool operator==(const FrameView&) const = default;
};

FrameView viewOf(vtkRenderer* renderer) {
  FrameView view;
  vtkCamera* camera = renderer->GetActiveCamera();
  renderer->GetTiledSizeAndOrigin(&view.width, &view.height, &view.x, &view.y);
  const double aspect = renderer->GetTiledAspectRatio();
  const vtkMatrix4x4* matrix = camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column)
      view.clipFromWorld(row, column) = matrix->GetElement(row, column);
  }
  const vtkMatrix4x4* axes = camera->GetViewTransformMatrix();
  for (int i = 0; i < 3; ++i) {
    view.right[i] = axes->GetElement(0, i);
    view.up[i] = axes->GetElement(1, i);
    view.forward[i] = -axes->GetElement(2, i);
  }
  camera->GetPosition(view.eye.data());
  view.parallel = camera->GetParallelProjection() != 0;
  view.halfHeight =
      view.parallel ? camera->GetParallelScale() : std::tan(camera->GetViewAngle() * std::numbers::pi / 360);
  view.halfWidth = view.halfHeight * aspect;
  camera->GetWindowCenter(view.jitter.data());
  camera->GetClippingRange(view.nearest, view.farthest);
  return view;
}

/// From the viewer's upper left. Looking at a slant it comes from behind the viewer, on a plan from the upper
/// left of the sheet, as maps are shaded.
Vec3 sunOf(const FrameView& view) {
  const Vec3 ahead = view.forward + view.up;
  const Vec3 heading = Vec3(ahead.x(), ahead.y(), 0).normalized();
  const double steep = std::pow(std::abs(view.forward.z()), 6);
  return (-0.62 * view.right + (0.75 * steep - 0.40) * heading + 0.80 * Vec3::UnitZ()).normalized();
}

/// Grid lines 1, 2 or 5 · 10^n metres apart, about a fifteenth of the height of the eye.
double gridStepFor(double height) {
  const double wish = std::max(height, 10.0) / 12;
  const double decade = std::pow(10, std::floor(std::log10(wish)));
  return decade;
}

}  // namespace

struct CityProp::Impl {
  std::array<GpuMesh, PartCount> parts;
  std::vector<std::array<std::uint8_t, 4>> colours;  ///< padded to whole rows when uploaded
  std::size_t colourCount = 0;
  Palette palette = lightPalette();
  double groundHeight = 0;
  bool ground = true;
  bool grid = true;
  bool edges = true;
  float buildingOpacity = 1, contextOpacity = 1;
  double pixelRatio = 1;
  double hazeDistance = 1e4;

  GlProgram geometryProgram{"city geometry", kGeometryVertexShader, kGeometryFragmentShader};
  GlProgram pictureProgram{"city picture", kPictureVertexShader, kPictureFragmentShader};
  PixelBuffer pixels;
  FrameView drawnView;
  bool geometryStale = true;
  bool coloursStale = true;
  unsigned coloursTexture = 0;
  unsigned quadArray = 0;
  unsigned quadVertices = 0;

  void drawGeometry(vtkOpenGLState& state, const FrameView& view);
  void drawPicture(vtkOpenGLState& state, const FrameView& view);
  void uploadColours();
  void makeQuad();
  void setPictureUniforms(const FrameView& view);
};

vtkStandardNewMacro(CityProp);

CityProp::CityProp() : impl_(std::make_unique<Impl>()) {}
CityProp::~CityProp() = default;

void CityProp::setMesh(Part part, std::shared_ptr<const NodeMesh> mesh) {
  impl_->parts[part].setMesh(std::move(mesh));
  impl_->geometryStale = true;
}

void CityProp::setRanges(Part part, std::vector<MeshRange> ranges) {
  impl_->parts[part].setRanges(ranges);
  impl_->geometryStale = true;
}

void CityProp::setColours(std::vector<std::array<std::uint8_t, 4>> colours) {
  impl_->colourCount = colours.size();
  impl_->colours = std::move(colours);
  impl_->coloursStale = true;
}

void CityProp::setPalette(const Palette& palette) {
  impl_->palette = palette;
}

void CityProp::setGround(double height, bool shown, bool grid) {
  impl_->groundHeight = height;
  impl_->ground = shown;
  impl_->grid = grid;
}

void CityProp::setEdges(bool on) {
  impl_->edges = on;
}
void CityProp::setOpacity(float buildings, float context) {
  impl_->buildingOpacity = buildings;
  impl_->contextOpacity = context;
}
void CityProp::setPixelRatio(double ratio) {
  impl_->pixelRatio = ratio;
}
void CityProp::setHazeDistance(double metres) {
  impl_->hazeDistance = metres;
}

// The scene sets the clipping range itself: without bounds VTK leaves this prop out of its own guesses.
double* CityProp::GetBounds() {
  return nullptr;
}

int CityProp::RenderOpaqueGeometry(vtkViewport* viewport) {
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  vtkOpenGLState& state = *window->GetState();
  window->GetShaderCache()->ReleaseCurrentShader();  // or VTK would take our program for its own
  vtkOpenGLState::ScopedglEnableDisable blend(&state, GL_BLEND);
  vtkOpenGLState::ScopedglEnableDisable depthTest(&state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable scissor(&state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable culling(&state, GL_CULL_FACE);
  vtkOpenGLState::ScopedglViewport area(&state);
  vtkOpenGLState::ScopedglDepthFunc depthFunction(&state);
  state.vtkglDisable(GL_BLEND);
  state.vtkglDisable(GL_SCISSOR_TEST);
  state.vtkglDisable(GL_CULL_FACE);
  state.vtkglEnable(GL_DEPTH_TEST);
  const FrameView view = viewOf(renderer);
  try {
    if (impl_->geometryStale || !impl_->pixels.fits(view.width, view.height) || !(view == impl_->drawnView)) {
      impl_->drawGeometry(state, view);
    }
    impl_->drawPicture(state, view);
  } catch (const std::exception& problem) {
    vtkErrorMacro(<< problem.what());
    return 0;
  }
  return 1;
}

void CityProp::Impl::drawGeometry(vtkOpenGLState& state, const FrameView& view) {
  state.PushFramebufferBindings();
  pixels.begin(state, view.width, view.height);
  state.vtkglDepthFunc(GL_LEQUAL);
  glPolygonOffset(1, 4);
  geometryProgram.use();
  geometryProgram.set3("forward", view.forward);
  geometryProgram.set("parallel", view.parallel ? 1 : 0);
  for (GpuMesh& part : parts) {
    if (part.empty()) continue;
    const Vec3& anchor = part.mesh()->anchor;
    Eigen::Matrix4d fromMesh = Eigen::Matrix4d::Identity();
    fromMesh.block<3, 1>(0, 3) = anchor;
    const Eigen::Matrix4f clip = (view.clipFromWorld * fromMesh).cast<float>();
    geometryProgram.setMatrix("clipFromMesh", clip.data());
    geometryProgram.set3("meshFromEye", Vec3(anchor - view.eye));
    // A landmark's wall may lie in its cluster's: clusters stand back by a hair.
    if (&part == &parts[Clusters]) glEnable(GL_POLYGON_OFFSET_FILL);
    part.draw();
    glDisable(GL_POLYGON_OFFSET_FILL);
  }
  state.PopFramebufferBindings();
  drawnView = view;
  geometryStale = false;
}

void CityProp::Impl::uploadColours() {
  if (coloursTexture == 0) {
    glGenTextures(1, &coloursTexture);
    coloursStale = true;
  }
  glBindTexture(GL_TEXTURE_2D, coloursTexture);
  if (!coloursStale) return;
  coloursStale = false;
  const std::size_t rows = std::max<std::size_t>(1, (colours.size() + kColoursWidth - 1) / kColoursWidth);
  colours.resize(rows * kColoursWidth);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, kColoursWidth, static_cast<GLsizei>(rows), 0, GL_RGBA,
               GL_UNSIGNED_BYTE, colours.data());
}

void CityProp::Impl::makeQuad() {
  if (quadArray != 0) return;
  constexpr std::array<float, 12> kCorners{-1, -1, 0, 1, -1, 0, -1, 1, 0, 1, 1, 0};
  glGenVertexArrays(1, &quadArray);
  glBindVertexArray(quadArray);
  glGenBuffers(1, &quadVertices);
  glBindBuffer(GL_ARRAY_BUFFER, quadVertices);
  glBufferData(GL_ARRAY_BUFFER, sizeof(kCorners), kCorners.data(), GL_STATIC_DRAW);
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void CityProp::Impl::setPictureUniforms(const FrameView& view) {
  GlProgram& program = pictureProgram;
  program.set("corner", static_cast<float>(view.x), static_cast<float>(view.y));
  program.set("pixels", 0);
  program.set("depths", 1);
  program.set("nodeColours", 2);
  program.set("nodeColoursWidth", kColoursWidth);
  program.set("nodeColoursCount", static_cast<int>(colourCount));
  program.set("nearFar", static_cast<float>(view.nearest), static_cast<float>(view.farthest));
  program.set("parallel", view.parallel ? 1 : 0);
  program.set("jitter", static_cast<float>(view.jitter.x()), static_cast<float>(view.jitter.y()));
  const Vec3 x = view.right * view.halfWidth;
  const Vec3 y = view.up * view.halfHeight;
  const Vec3 none = Vec3::Zero();
  program.set3("rayForward", view.forward);
  program.set3("rayX", view.parallel ? none : x);
  program.set3("rayY", view.parallel ? none : y);
  program.set3("rayOriginX", view.parallel ? x : none);
  program.set3("rayOriginY", view.parallel ? y : none);
  const double eyeHeight = view.eye.z() - groundHeight;
  const double scale = view.parallel ? view.halfHeight * 2 : eyeHeight;
  const double step = gridStepFor(scale);
  program.set("eyeHeight", static_cast<float>(eyeHeight));
  program.set("eyePlan", static_cast<float>(std::fmod(view.eye.x(), step * 10)),
              static_cast<float>(std::fmod(view.eye.y(), step * 10)));
  program.set("gridStep", grid ? static_cast<float>(step) : 0.0F);
  program.set("showGround", ground ? 1 : 0);
  program.set("edgeStrength", edges ? 0.55F : 0.0F);
  program.set("buildingOpacity", buildingOpacity);
  program.set("contextOpacity", contextOpacity);
  program.set("pixelRatio", static_cast<float>(pixelRatio));
  program.set("hazeDistance", static_cast<float>(hazeDistance));
  program.set3("sun", sunOf(view));
  program.set3("skyTop", palette.skyTop);
  program.set3("skyHorizon", palette.skyHorizon);
  program.set3("groundColour", palette.ground);
  program.set3("gridColour", palette.grid);
  program.set3("ink", palette.ink);
  program.set3("selectedLine", palette.selectionLine);
  program.set3("hoverLine", palette.hoverLine);
}

void CityProp::Impl::drawPicture(vtkOpenGLState& state, const FrameView& view) {
  state.vtkglViewport(view.x, view.y, view.width, view.height);
  state.vtkglDepthFunc(GL_ALWAYS);
  state.vtkglDepthMask(GL_TRUE);
  pictureProgram.use();
  setPictureUniforms(view);
  pixels.bindTextures();
  glActiveTexture(GL_TEXTURE2);
  uploadColours();
  makeQuad();
  glBindVertexArray(quadArray);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindVertexArray(0);
  glUseProgram(0);
  for (const GLenum unit : {GL_TEXTURE2, GL_TEXTURE1, GL_TEXTURE0}) {
    glActiveTexture(unit);
    glBindTexture(GL_TEXTURE_2D, 0);
  }
  state.ResetGLActiveTexture();
}

void CityProp::ReleaseGraphicsResources(vtkWindow*) {
  for (GpuMesh& part : impl_->parts) part.release();
  impl_->geometryProgram.release();
  impl_->pictureProgram.release();
  impl_->pixels.release();
  if (impl_->coloursTexture != 0) glDeleteTextures(1, &impl_->coloursTexture);
  if (impl_->quadArray != 0) {
    glDeleteVertexArrays(1, &impl_->quadArray);
    glDeleteBuffers(1, &impl_->quadVertices);
  }
  impl_->coloursTexture = impl_->quadArray = impl_->quadVertices = 0;
  impl_->geometryStale = true;
}

}  // namespace lodestone
