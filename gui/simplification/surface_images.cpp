#include "gui/simplification/surface_images.h"

#include <QBuffer>
#include <QImageReader>
#include <algorithm>
#include <exception>
#include <set>

#include "model/io/texture_image.h"

namespace lodestone {
namespace {

constexpr int kMostPixels = 2048;

std::shared_ptr<const SurfaceImage> decoded(const Texture& texture) {
  if (!hasImage(texture)) return nullptr;
  QByteArray bytes;
  try {
    bytes = QByteArray::fromStdString(readImage(texture));
  } catch (const std::exception&) {
    return nullptr;  // the import has said what is missing
  }
  QBuffer buffer(&bytes);
  QImageReader reader(&buffer);
  const QSize size = reader.size();
  if (std::max(size.width(), size.height()) > kMostPixels)
    reader.setScaledSize(size.scaled(kMostPixels, kMostPixels, Qt::KeepAspectRatio));
  const QImage image = reader.read().convertToFormat(QImage::Format_RGBA8888).mirrored();
  if (image.isNull()) return nullptr;
  auto result = std::make_shared<SurfaceImage>(SurfaceImage{image.width(), image.height(), {}});
  for (int row = 0; row < image.height(); ++row) {  // Qt may pad its lines
    const uchar* line = image.constScanLine(row);
    result->rgba.insert(result->rgba.end(), line, line + 4 * static_cast<std::ptrdiff_t>(image.width()));
  }
  return result;
}

}  // namespace

std::shared_ptr<const SurfaceLook> readSurfaceLook(const CityModel& city, const ComponentMesh& mesh,
                                                   const Progress& progress) {
  auto look = std::make_shared<SurfaceLook>();
  for (const Material& material : city.materials) look->materials.push_back(material.diffuse);
  look->textures.resize(city.textures.size());
  std::set<std::int32_t> shown;
  if (!mesh.textureCoordinates.empty()) {
    for (const SurfaceInfo& surface : mesh.surfaces) shown.insert(surface.texture);
  }
  for (const std::int32_t texture : shown) {
    progress.checkpoint();
    const auto index = static_cast<std::size_t>(texture);
    if (texture >= 0 && index < look->textures.size()) look->textures[index] = decoded(city.textures[index]);
  }
  return look;
}

bool hasOwnLook(const SurfaceLook& look) {
  return look.materials.size() > 1 || std::any_of(look.textures.begin(), look.textures.end(),
                                                  [](const auto& image) { return image != nullptr; });
}

}  // namespace lodestone
