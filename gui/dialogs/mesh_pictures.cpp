#include "gui/dialogs/mesh_pictures.h"

#include "algorithms/chains/chain_building.h"
#include "gui/widgets/picture_image.h"
#include "model/io/meshes/mesh_import.h"

namespace lodestone {
namespace {

/// The renderer's sky, haze and shadows suit buildings in metres: whatever the unit, it is drawn in this
/// size.
constexpr double kDrawnDiagonal = 30;

QImage draw(CityModel city, bool yUp, const Box3& box, const QSize& size, const Progress& progress) {
  const double scale = kDrawnDiagonal / box.size().norm();
  Box3 drawn;
  forEachObjectOf(city, [&](CityObject& object) {
    for (Geometry& geometry : object.geometries) {
      for (Vec3& p : geometry.vertices) {
        const Vec3 q = scale * (p - box.center());
        p = yUp ? Vec3(q.x(), -q.z(), q.y()) : q;
        drawn.add(p);
      }
    }
  });
  const auto chain = makeChain(std::make_shared<const CityModel>(std::move(city)), nullptr, {});
  if (!chain) return {};
  return toImage(renderLevel(chain->levels.front(),
                             fitCamera(drawn, Vec3(-0.6, 0.75, -0.4), 35, size.width(), size.height()),
                             progress));
}

}  // namespace

MeshPictures drawMesh(const QString& path, const QSize& size, const Progress& progress) {
  MeshPictures pictures;
  Result<CityModel> city = readMesh(path.toStdString(), {.upAxis = UpAxisOption::Z}, progress.part(0, 0.4));
  if (!city) {
    pictures.trouble = QString::fromStdString(format(city.diagnostics.front()));
    return pictures;
  }
  const Box3 box = bounds(*city);
  pictures.size = box.size();
  if (box.size().norm() > 0) {
    pictures.zUp = draw(*city, false, box, size, progress.part(0.4, 0.7));
    pictures.yUp = draw(std::move(*city), true, box, size, progress.part(0.7, 1));
  }
  return pictures;
}

}  // namespace lodestone
