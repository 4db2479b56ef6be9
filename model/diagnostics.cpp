#include "model/diagnostics.h"

#include <algorithm>

#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr Severity kInfo = Severity::Info;
constexpr Severity kWarning = Severity::Warning;
constexpr Severity kError = Severity::Error;

constexpr DiagnosticInfo kTable[] = {
    {Code::FileNotFound, kError, "file not found", "Check the path."},
    {Code::FileUnreadable, kError, "file cannot be read",
     "Check its permissions and that the disk is there."},
    {Code::FormatUnknown, kError, "no reader knows this file",
     "See `lodestone-cli info --formats` for what can be read."},
    {Code::FileTruncated, kError, "file ends too early", "Fetch or export it again."},
    {Code::FileMalformed, kError, "file breaks its format's syntax", "Mend it at the place named."},
    {Code::FileEmpty, kError, "file is empty", "Fetch or export it again."},
    {Code::NoBuildings, kWarning, "no building in the input",
     "Check that it is the right file, layer or LoD."},
    {Code::EncodingBad, kError, "text is not in the encoding that the file names", "Convert it to UTF-8."},
    {Code::NestingTooDeep, kError, "elements are nested deeper than any city model needs",
     "The file is damaged or hostile."},
    {Code::EntityRefused, kError, "document type definitions and entities are refused",
     "Remove the DOCTYPE: city models need none."},
    {Code::CountImplausible, kError, "a count in the file cannot be true", "The file is damaged or hostile."},
    {Code::ArchiveUnsafe, kError, "archive member refused",
     "Its path leaves the archive, or it unpacks to too much; unpack it by hand if you trust it."},
    {Code::VersionUnsupported, kWarning, "version is not supported",
     "It was read as the nearest version that is."},
    {Code::DuplicateId, kWarning, "two objects share an id", "The later one was given a suffix."},
    {Code::LayerMissing, kError, "layer not found", "The layers are listed in the message."},
    {Code::FieldMissing, kError, "field not found", "The fields are listed in the message."},
    {Code::ObjectSkipped, kWarning, "object left out", "The rest was imported."},
    {Code::IdMissing, kInfo, "objects without an id", "They are named by their place in the file."},
    {Code::BarrierFileBad, kError, "no lines in the barrier layer",
     "Give a vector layer of lines: streets, rails, rivers."},
    {Code::ParentMissing, kWarning, "parent object is not in the file",
     "The object was kept as one of its own."},
    {Code::ArchiveEmpty, kError, "archive holds no city model", "Unpack it and look."},
    {Code::MemberSkipped, kInfo, "archive member not read", "It is not a city model."},
    {Code::ByteOrderMark, kInfo, "file starts with a byte order mark", "It was skipped."},
    {Code::InputLeftOut, kError, "input left out", "Nothing of it could be read; another message says why."},
    {Code::InputReadInPart, kWarning, "input read in part", "Another message says where it breaks."},
    {Code::LayerChosen, kInfo, "one of several layers was read", "Name another with --layer."},

    {Code::RingTooShort, kWarning, "ring with fewer than three different vertices",
     "Its surface was left out."},
    {Code::RingZeroArea, kWarning, "ring without area", "Its surface was left out."},
    {Code::RingSelfIntersecting, kWarning, "ring crosses itself", "It was repaired by the even-odd rule."},
    {Code::CoordinateBad, kWarning, "coordinate is not a finite number", "Its surface was left out."},
    {Code::FootprintMissing, kWarning, "building without a footprint",
     "It is not clustered, and stays in level 0 only."},
    {Code::FootprintRepaired, kWarning, "footprint repaired",
     "Compare it with the source if its shape matters."},
    {Code::HeightMissing, kInfo, "no height",
     "The default height was taken; name a field with --height or --floors."},
    {Code::HeightNotPositive, kWarning, "height is zero or less",
     "What else the input says was taken, or the default height."},
    {Code::HoleOutside, kWarning, "hole outside its outer ring", "The hole was left out."},
    {Code::FootprintFromOutline, kInfo, "footprint is the projected outline",
     "The building has no ground surface."},
    {Code::GeometryUnsupported, kWarning, "geometry type is not supported",
     "It was left out; the rest of the object was kept."},
    {Code::IndexOutOfRange, kWarning, "index points outside its list", "Its surface was left out."},
    {Code::GeometryEmpty, kWarning, "geometry without surfaces", "It was left out."},
    {Code::FootprintInvalid, kWarning, "footprint cannot be repaired", "The building was left out."},
    {Code::HoleDropped, kInfo, "hole without area left out", "Nothing to do."},
    {Code::SemanticsBad, kWarning, "semantic value does not fit its geometry",
     "The surface was kept without one."},
    {Code::TrianglesDropped, kInfo, "triangles without area or in the same place twice",
     "They were left out; nothing that is seen changes."},
    {Code::HeightNotUnderstood, kWarning, "height or floors not understood",
     "What else the input says was taken, or the default height; write one number, in metres or with its "
     "unit."},

    {Code::XlinkUnresolved, kWarning, "xlink leads nowhere",
     "Its target is not in the file; the reference was left out."},
    {Code::XlinkOutside, kWarning, "xlink to another file refused",
     "Merge the files first: only links inside a file are followed."},
    {Code::TextureMissing, kWarning, "texture image not found",
     "The surface keeps its coordinates and is drawn plain."},
    {Code::TextureOutside, kWarning, "texture path leaves the input's folder",
     "Refused; pass --allow-outside if you trust the file."},
    {Code::TextureBad, kWarning, "texture coordinates do not fit their ring", "They were left out."},
    {Code::TemplateMissing, kWarning, "geometry template not found", "The geometry was left out."},
    {Code::AppearanceBad, kWarning, "appearance entry is broken", "It was left out."},
    {Code::XlinkCycle, kWarning, "xlinks lead in a circle", "The reference was left out."},

    {Code::CrsMissing, kInfo, "no coordinate system given",
     "Coordinates are taken as metres; name one with --crs EPSG:N."},
    {Code::CrsUnknown, kWarning, "coordinate system not known",
     "Coordinates are taken as metres; name one with --crs EPSG:N."},
    {Code::CrsMixed, kInfo, "inputs have different coordinate systems",
     "All were turned into that of the first."},
    {Code::CrsTransformFailed, kError, "coordinates cannot be transformed",
     "Check the coordinate system with --crs EPSG:N."},
    {Code::CoordinatesLookGeographic, kWarning, "coordinates look like degrees",
     "They were taken as longitude and latitude; name the system with --crs EPSG:N."},
    {Code::UnitsConverted, kInfo, "units converted to metres", "Nothing to do."},
    {Code::TransformMissing, kWarning, "no transform", "The vertices were taken as they stand."},
    {Code::CrsAssumed, kWarning, "input without a coordinate system beside one with",
     "It was taken to be in the same; import it alone with --crs EPSG:N if it is not."},
    {Code::OutsideAreaOfUse, kWarning, "coordinates lie outside the coordinate system's area of use",
     "Lengths and places may be wrong; check the system with --crs EPSG:N."},
    {Code::MercatorStraightened, kInfo, "Mercator stretches lengths",
     "The model is in metres on the ground; outputs and cameras stay in the input's system."},

    {Code::UpAxisAssumed, kInfo, "the file does not say which axis is up",
     "If the model lies on its side, give --up-axis y or z, or choose File > Unit and up axis."},
    {Code::InputsFarApart, kWarning, "inputs lie far apart",
     "If they belong together, check their coordinate systems; else import them one by one."},
    {Code::OptionOutOfRange, kError, "option out of range", "See --help for the range."},
    {Code::OptionUnknown, kError, "option not known", "See --help for the options."},
    {Code::OptionBadValue, kError, "option value not understood", "See --help for the values."},
    {Code::OptionUnused, kWarning, "option has no effect on these inputs",
     "Check its spelling, and which inputs it is for."},
    {Code::OptionsContradict, kError, "options that mean nothing together",
     "Leave one of them out; --help says what each is for."},
    {Code::InputsUnlike, kError, "a picture and a model cannot be compared",
     "Give two pictures, or two models; `lodestone-cli perceive` and `render` make pictures of a model."},

    {Code::ClusterTooFew, kInfo, "fewer than two buildings", "There is nothing to cluster."},
    {Code::Cancelled, kInfo, "cancelled", "The last good state was kept."},
    {Code::LineIgnored, kInfo, "line ignored", "Nothing to do."},
    {Code::AttributeMissing, kWarning, "attribute missing on some buildings",
     "They count as equal to their neighbours."},
    {Code::TriangulationFallback, kWarning, "surface could not be triangulated as it is",
     "It is drawn by a fan of triangles."},
    {Code::LeafWithoutFootprint, kWarning, "building without a footprint is not clustered",
     "It stays in level 0 only."},
    {Code::BarriersFarAway, kWarning, "barriers lie nowhere near the buildings",
     "They separate nothing; check their coordinate system."},
    {Code::BarriersTaken, kInfo, "barriers", "Name another layer with --barrier-layer."},
    {Code::LevelNotLighter, kInfo, "a level has as many polygons as the finer one",
     "Clusters pay nothing there yet; leave the level out, or raise its tolerance."},
    {Code::BuildingGone, kInfo, "nothing is left of a building, and it is left out",
     "Ask for a lower rate to keep it."},
    {Code::RateNotMet, kInfo, "fewer triangles removed than asked for",
     "Nothing more could be removed but the last component whole, which a rate of 1 does; perception and "
     "combined also stop where nothing more is admitted, or at the error that is allowed: raise the stage or "
     "the error, or add --unseen."},
    {Code::ModelNotSeen, kWarning, "no picture shows the model",
     "Nothing is known of what people perceive of it; look from other viewpoints (--camera, --viewpoints)."},
    {Code::NothingAdmitted, kInfo, "no triangle may be simplified at this stage",
     "Raise the stage if it is below 3, add --unseen, or look from farther away (--distance)."},
    {Code::ChartsInTheWay, kInfo, "contractions were left out to keep textures and materials",
     "They would have drawn a texture over what it does not belong to; set an error to let it go astray so "
     "far, or take combined."},
    {Code::PictureUnreadable, kError, "picture cannot be read",
     "Give a PNG, JPEG, TIFF, WebP, BMP, PPM, PGM or TGA file."},
    {Code::PicturesUnlike, kError, "pictures of different size cannot be compared",
     "Make them with the same number of pixels each way."},
    {Code::ModelEmpty, kError, "nothing to look at: the model has no surfaces",
     "`lodestone-cli info` says what the file holds: buildings need surfaces, or a footprint and a height."},
    {Code::LookingTakesLong, kInfo, "many pixels to look at",
     "If that is too much, ask for fewer or smaller pictures: --views, --size."},
    {Code::LookedAtByGroup, kInfo, "perceive looks at a city as a whole, simplify at each group of buildings",
     "A building that fills the picture shows more detail than one in a city: to see what simplify sees, "
     "give "
     "perceive a file of that group alone."},
    {Code::ErrorUnbounded, kInfo, "a stage goes on until nothing more is admitted, whatever that costs",
     "Add --error to leave out what leads too far from the shape."},

    {Code::OutputExists, kError, "output exists and is not ours to replace", "Choose another place."},
    {Code::OutputUnwritable, kError, "output cannot be written",
     "Check the folder, its permissions and the disk."},
    {Code::OutputLossy, kInfo, "the format cannot hold everything", "What is lost is named in the message."},
    {Code::OutputFormatUnknown, kError, "no writer for this ending",
     "`lodestone-cli info --formats` lists the endings."},
    {Code::OutputDiskFull, kError, "disk full", "Nothing was written; make room and try again."},
    {Code::ProjectBad, kError, "project file cannot be understood", "It may come from a later version."},
    {Code::OutputLeftOver, kInfo, "files of an earlier run stand beside the new ones",
     "Nothing was deleted; delete them if nobody needs them."},

    {Code::Internal, kError, "internal error", "Please report it, with the file if you can."},
};

}  // namespace

const char* toString(Severity severity) {
  switch (severity) {
    case Severity::Info:
      return "info";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  return "";
}

std::span<const DiagnosticInfo> diagnosticTable() {
  return kTable;
}

const DiagnosticInfo& info(Code code) {
  const auto* it =
      std::find_if(std::begin(kTable), std::end(kTable), [&](const auto& row) { return row.code == code; });
  return it == std::end(kTable) ? *std::prev(std::end(kTable)) : *it;
}

Diagnostic diagnose(Code code, std::string detail, std::string object, std::string place) {
  const DiagnosticInfo& row = info(code);
  std::string text(row.title);
  if (!detail.empty()) text += ": " + detail;
  return {code, row.severity, std::move(object), std::move(place), std::move(text)};
}

bool hasErrors(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string format(const Diagnostic& d) {
  return fmt::format("{} {}{}{} {}{}. {}", toString(d.severity), static_cast<int>(d.code),
                     d.object.empty() ? "" : fmt::format(" [{}]", d.object), ":", d.text,
                     d.place.empty() ? "" : fmt::format(" ({})", d.place), info(d.code).advice);
}

}  // namespace lodestone
