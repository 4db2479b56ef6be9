// The JSON array of {"height": 12, "polygon": [[lon, lat], …]} that deck.gl's examples use.
#pragma once

#include <string_view>

#include "model/city_model.h"
#include "model/result.h"

namespace lodestone {

[[nodiscard]] bool looksLikeDeckGl(std::string_view head);
/// Buildings with their outlines as they stand (longitude, latitude), all other members as attributes; or why
/// not.
[[nodiscard]] Result<std::vector<Building>> parseDeckGl(std::string_view text);

}  // namespace lodestone
