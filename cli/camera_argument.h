// CAM: x,y,z,tx,ty,tz[,fov[,WxH]] or fit[:direction][,WxH].
#pragma once

#include <string>

#include "model/camera.h"
#include "model/city_model.h"

namespace lodestone::cli {

/// What --help says of CAM.
inline constexpr const char* kCameraHelp =
    "x,y,z,tx,ty,tz[,fov[,WxH]], or fit[:n|ne|e|se|s|sw|w|nw|top][,WxH]: all but strays in the picture, "
    "looking that way (fit alone: nw); 1280x800 pixels where no size is given";

/// The camera in local metres. Numbers are in the input's CRS; for geographic input they are metres east,
/// north and up of the centre that `info` prints. Directions to look in: n, ne, e, se, s, sw, w, nw, top;
/// `fit` alone looks north-west from above. It frames withoutStrays(), as the workbench does. \throw Failure
/// (503) when the text cannot be understood.
[[nodiscard]] Camera parseCamera(const std::string& text, const CityModel& city);
/// Takes WxH pixels into the camera; `text` is what was given, for the message. \throw Failure (503)
void parseSize(const std::string& text, const std::string& size, Camera& camera);
/// The other way: a camera in local metres as parseCamera() takes its numbers.
[[nodiscard]] Camera asGiven(Camera camera, const CityModel& city);

}  // namespace lodestone::cli
