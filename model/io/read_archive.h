// Archives of city models: one rule for all formats that may be packed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "model/city_model.h"
#include "model/import_options.h"
#include "model/progress.h"
#include "model/result.h"

namespace lodestone {

/// How a format reads the members of an archive.
struct MemberReading {
  /// Whether a member, by its virtual path, is one of the format's.
  std::function<bool(const std::string& member)> isOurs;
  /// Reads one. `name` says in messages where it is: "tiles.zip!udx/a.gml"; `count`: of the format's members.
  std::function<Result<CityModel>(const std::string& member, const std::string& name, std::size_t count,
                                  const Progress& progress)>
      read;
  bool eastNorth = false;  ///< as settleCrs() wants to know
};

/// The members of one format as one model, which the archive is the one source of. The first system that a
/// member names is the model's: members in another are brought into it (CrsMixed), those that name none are
/// taken to be in it (CrsAssumed). A member that cannot be read is left out: its errors say so. Those of
/// other formats are named (MemberSkipped). Fails where no member could be read. \throw Cancelled
[[nodiscard]] Result<CityModel> readArchive(const std::filesystem::path& path, const ImportOptions& options,
                                            const MemberReading& reading, const Progress& progress);

/// Gives diagnostics that name no place this one.
void namePlace(Diagnostics& diagnostics, const std::string& place);

}  // namespace lodestone
