// Building meshes: OBJ, glTF, STL, COLLADA and OFF, read by assimp; PLY (ply.h).
#pragma once

#include "model/io/format.h"

namespace lodestone {

/// One file is one building. Its objects stay apart as its parts: an OBJ group, a glTF or COLLADA node with
/// all its primitives; each is a BuildingInstallation named by the group, with one surface a face and
/// with its materials, textures and texture coordinates. Points and lines are left out and told.
///
/// Coordinates become metres, z up, by ImportOptions::unit and upAxis; where those say nothing: glTF is
/// metres, y up; COLLADA says both itself; an OBJ of ours says that z is up, any other is y up; PLY, STL and
/// OFF are z up. What was assumed is told (Code::UpAxisAssumed). There is no CRS: the frame is the file's
/// own.
[[nodiscard]] Result<CityModel> readMesh(const std::filesystem::path& path, const ImportOptions& options,
                                         const Progress& progress);

/// The axis that is up where nobody says otherwise.
struct UpAxis {
  bool y = false;
  bool assumed = false;  ///< the file says neither that nor its unit: somebody may want to be asked
};
[[nodiscard]] UpAxis upAxisOf(const std::filesystem::path& path);

/// Whether readMesh() reads its files; null does not.
[[nodiscard]] bool isMeshFormat(const Format* format);

/// Makes it a format whose files readMesh() reads.
void readsMeshes(Format& format);
/// Mesh formats that are read and not written.
[[nodiscard]] Format plyFormat();
[[nodiscard]] Format stlFormat();
[[nodiscard]] Format colladaFormat();
[[nodiscard]] Format offFormat();

/// Probes of the two that are written as well (obj.h, glb.h).
[[nodiscard]] int probeObj(const std::filesystem::path& path, std::string_view head);
[[nodiscard]] int probeGltf(const std::filesystem::path& path, std::string_view head);

}  // namespace lodestone
