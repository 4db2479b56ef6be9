// What the program has to say about its input: stable codes, one text each, with advice. The table is in
// diagnostics.cpp and printed for people in resources/docs/diagnostics.md (a test keeps the two equal).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace lodestone {

enum class Severity { Info, Warning, Error };
[[nodiscard]] const char* toString(Severity severity);

/// 1xx files, 2xx geometry, 3xx references and appearance, 4xx coordinate systems, 5xx options, 6xx stages,
/// 7xx output. A code never changes its meaning; add at the end of its hundred.
enum class Code : int {
  FileNotFound = 101,
  FileUnreadable = 102,
  FormatUnknown = 103,
  FileTruncated = 104,
  FileMalformed = 105,
  FileEmpty = 106,
  NoBuildings = 107,
  EncodingBad = 108,
  NestingTooDeep = 109,
  EntityRefused = 110,
  CountImplausible = 111,
  ArchiveUnsafe = 112,
  VersionUnsupported = 113,
  DuplicateId = 114,
  LayerMissing = 115,
  FieldMissing = 116,
  ObjectSkipped = 117,
  IdMissing = 118,
  BarrierFileBad = 119,
  ParentMissing = 120,
  ArchiveEmpty = 121,
  MemberSkipped = 122,
  ByteOrderMark = 123,
  InputLeftOut = 124,
  InputReadInPart = 125,
  LayerChosen = 126,

  RingTooShort = 201,
  RingZeroArea = 202,
  RingSelfIntersecting = 203,
  CoordinateBad = 204,
  FootprintMissing = 206,
  FootprintRepaired = 207,
  HeightMissing = 208,
  HeightNotPositive = 209,
  HoleOutside = 210,
  FootprintFromOutline = 211,
  GeometryUnsupported = 213,
  IndexOutOfRange = 214,
  GeometryEmpty = 216,
  FootprintInvalid = 217,
  HoleDropped = 218,
  SemanticsBad = 219,
  TrianglesDropped = 220,
  HeightNotUnderstood = 221,

  XlinkUnresolved = 301,
  XlinkOutside = 302,
  TextureMissing = 303,
  TextureOutside = 304,
  TextureBad = 305,
  TemplateMissing = 306,
  AppearanceBad = 307,
  XlinkCycle = 308,

  CrsMissing = 401,
  CrsUnknown = 402,
  CrsMixed = 403,
  CrsTransformFailed = 404,
  CoordinatesLookGeographic = 405,
  UnitsConverted = 406,
  TransformMissing = 407,
  CrsAssumed = 408,
  OutsideAreaOfUse = 409,
  MercatorStraightened = 410,
  UpAxisAssumed = 411,
  InputsFarApart = 412,

  OptionOutOfRange = 501,
  OptionUnknown = 502,
  OptionBadValue = 503,
  OptionUnused = 504,
  OptionsContradict = 505,
  InputsUnlike = 506,

  ClusterTooFew = 601,
  Cancelled = 603,
  LineIgnored = 604,
  AttributeMissing = 605,
  TriangulationFallback = 606,
  LeafWithoutFootprint = 607,
  BarriersFarAway = 608,
  BarriersTaken = 609,
  LevelNotLighter = 610,
  BuildingGone = 611,
  RateNotMet = 612,
  ModelNotSeen = 613,
  NothingAdmitted = 614,
  ChartsInTheWay = 615,
  PictureUnreadable = 616,
  PicturesUnlike = 617,
  ModelEmpty = 618,
  LookingTakesLong = 619,
  LookedAtByGroup = 620,
  ErrorUnbounded = 621,

  OutputExists = 701,
  OutputUnwritable = 702,
  OutputLossy = 703,
  OutputFormatUnknown = 704,
  OutputDiskFull = 705,
  ProjectBad = 706,
  OutputLeftOver = 708,

  Internal = 901,
};

struct Diagnostic {
  Code code = Code::Internal;
  Severity severity = Severity::Warning;
  std::string object;  ///< id of the city object; empty when it is about the file
  std::string place;   ///< "tile.gml:1204", a JSON pointer, a layer and feature number
  std::string text;    ///< what is wrong, with the particulars
};
using Diagnostics = std::vector<Diagnostic>;

/// One row of the table.
struct DiagnosticInfo {
  Code code;
  Severity severity;
  std::string_view title;   ///< what is wrong, in general
  std::string_view advice;  ///< what to do about it
};
[[nodiscard]] std::span<const DiagnosticInfo> diagnosticTable();
[[nodiscard]] const DiagnosticInfo& info(Code code);

/// A diagnostic with the table's severity and text "title: detail".
[[nodiscard]] Diagnostic diagnose(Code code, std::string detail = {}, std::string object = {},
                                  std::string place = {});
[[nodiscard]] bool hasErrors(const Diagnostics& diagnostics);
/// "warning 204 [id] text (place). advice"
[[nodiscard]] std::string format(const Diagnostic& diagnostic);

}  // namespace lodestone
