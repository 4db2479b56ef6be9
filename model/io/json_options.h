// Options as JSON, for recipes and project files.
#pragma once

#include <nlohmann/json.hpp>

#include "model/options.h"

namespace lodestone {

[[nodiscard]] nlohmann::ordered_json toJson(const OptionValues& values);
/// Numbers, text and flags of a JSON object; anything else is left out and said.
[[nodiscard]] OptionValues optionValuesFrom(const nlohmann::ordered_json& object, Diagnostics& diagnostics);

}  // namespace lodestone
