// A mesh drawn with either axis up, for somebody to say which is right.
#pragma once

#include <QImage>
#include <QString>

#include "model/geometry.h"
#include "model/progress.h"

namespace lodestone {

struct MeshPictures {
  Vec3 size = Vec3::Zero();  ///< along the file's own axes, in its own unit
  QImage zUp, yUp;           ///< null where the file cannot be read
  QString trouble;           ///< why it cannot
};

/// Reads the file and draws it twice. \throw Cancelled
[[nodiscard]] MeshPictures drawMesh(const QString& path, const QSize& size, const Progress& progress);

}  // namespace lodestone
