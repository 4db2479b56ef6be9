// Camera paths as JSON (resources/schemas/path.json).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "model/flight_path.h"
#include "model/result.h"

namespace lodestone {

/// Coordinates as they stand in the file. Keys without times follow one another at the path's "speed" (20 m/s
/// where none is given). Fails (FileMalformed) on keys that make no camera, on times that do not rise, and
/// where some keys have a time and others have none.
[[nodiscard]] Result<FlightPath> parseFlightPath(std::string_view text);
[[nodiscard]] Result<FlightPath> loadFlightPath(const std::filesystem::path& path);
[[nodiscard]] std::string flightPathText(const FlightPath& path);

}  // namespace lodestone
