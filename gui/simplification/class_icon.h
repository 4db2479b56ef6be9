// The sign of a class of vertices, as the stage draws it.
#pragma once

#include <QIcon>

#include "model/component_mesh.h"

namespace lodestone {

[[nodiscard]] QIcon classIcon(VertexClass vertexClass);

}  // namespace lodestone
