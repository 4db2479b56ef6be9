#include "model/io/cityjson/cityjson_document.h"

#include <array>
#include <limits>

#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Vec3 readPoint(const std::optional<JsonElement>& element) {
  JsonBeside values(element);
  Vec3 point;
  for (int axis = 0; axis < 3; ++axis) point[axis] = numberOf(values.next()).value_or(kNone);
  return point;
}

bool isKnownVersion(std::string_view version) {
  return version == "1.0" || version == "1.1" || version == "2.0" || version.starts_with("1.0.") ||
         version.starts_with("1.1.") || version.starts_with("2.0.");
}

}  // namespace

CityJsonDocuments::CityJsonDocuments(CityModel& model, const std::filesystem::path& file,
                                     const ImportOptions& options, Diagnostics& diagnostics)
    : model_(model),
      diagnostics_(diagnostics),
      tables_(model, ImagePaths(file, options.allowOutside), diagnostics),
      objects_(model, diagnostics) {}

bool CityJsonDocuments::add(const JsonElement& element, const std::string& place, const Progress& progress) {
  const auto root = as<JsonObject>(element);
  const auto type = root ? memberAs<std::string_view>(*root, "type").value_or("") : "";
  const bool feature = type == "CityJSONFeature";
  if (!feature && type != "CityJSON") {
    diagnostics_.push_back(diagnose(Code::FileMalformed, "its type is not CityJSON", {}, place));
    return false;
  }
  if (!feature) readHeader(*root, place);
  const auto objects = memberAs<JsonObject>(*root, "CityObjects");
  if (!objects) {
    // Some sequences start with a header that is no more than that.
    if (!feature && !member(*root, "vertices")) return true;
    diagnostics_.push_back(diagnose(Code::FileMalformed, "it has no CityObjects", {}, place));
    return false;
  }
  if (feature && member(*root, "transform")) readTransform(*root, place);
  if (feature) checkFeature(*root, *objects, place);

  CityJsonContext context;
  context.vertices = readVertices(member(*root, "vertices"), true);
  if (!memberAs<JsonArray>(*root, "vertices")) {
    diagnostics_.push_back(diagnose(Code::FileMalformed, "it has no list of vertices", {}, place));
  }
  const auto appearance = member(*root, "appearance");
  context.appearance = appearance ? readAppearance(appearance, tables_) : appearance_;
  context.templates = &templates_;
  context.placed = &placed_;
  objects_.add(*objects, context, progress);
  return true;
}

void CityJsonDocuments::readHeader(const JsonObject& root, const std::string& place) {
  templates_.clear();
  readVersion(root, place);
  hasTransform_ = false;
  scale_ = Vec3::Ones();
  translate_ = Vec3::Zero();
  const bool needed = model_.sources.back().version >= "1.1";
  if (member(root, "transform")) {
    readTransform(root, place);
  } else if (needed) {
    diagnostics_.push_back(diagnose(Code::TransformMissing, {}, {}, place));
  }
  readReferenceSystem(root);
  if (const auto extensions = memberAs<JsonObject>(root, "extensions"))
    model_.sources.back().extensions = simdjson::minify(*extensions);
  appearance_ = readAppearance(member(root, "appearance"), tables_);
  readTemplates(root);
}

void CityJsonDocuments::readVersion(const JsonObject& root, const std::string& place) {
  const auto version = memberAs<std::string_view>(root, "version");
  Source& source = model_.sources.back();
  source.version = version.value_or("");
  if (!version || !isKnownVersion(*version)) {
    const std::string given = version ? std::string(*version) : "none given";
    diagnostics_.push_back(diagnose(Code::VersionUnsupported, given, {}, place));
  }
}

void CityJsonDocuments::readTransform(const JsonObject& root, const std::string& place) {
  const auto transform = memberAs<JsonObject>(root, "transform");
  const Vec3 scale = readPoint(transform ? member(*transform, "scale") : std::nullopt);
  const Vec3 translate = readPoint(transform ? member(*transform, "translate") : std::nullopt);
  if (scale.allFinite() && translate.allFinite()) {
    scale_ = scale;
    translate_ = translate;
    hasTransform_ = true;
  } else {
    diagnostics_.push_back(
        diagnose(Code::FileMalformed, "transform needs three numbers in scale and translate", {}, place));
  }
}

void CityJsonDocuments::readReferenceSystem(const JsonObject& root) {
  const auto metadata = memberAs<JsonObject>(root, "metadata");
  if (!metadata) return;
  if (const auto name = memberAs<std::string_view>(*metadata, "referenceSystem")) {
    model_.crs.source = *name;
  } else if (const auto crs = memberAs<JsonObject>(*metadata, "crs")) {  // CityJSON 0.8 and before
    if (const auto code = indexOf(member(*crs, "epsg"))) model_.crs.source = fmt::format("EPSG:{}", *code);
  }
  model_.sources.back().title = memberAs<std::string_view>(*metadata, "title").value_or("");
}

void CityJsonDocuments::readTemplates(const JsonObject& root) {
  const auto templates = memberAs<JsonObject>(root, "geometry-templates");
  if (!templates) return;
  CityJsonContext context;
  context.vertices = readVertices(member(*templates, "vertices-templates"), false);
  context.appearance = appearance_;
  CityJsonGeometryReader reader(context);
  ObjectDiagnostics said;
  JsonBeside list(member(*templates, "templates"));
  while (const auto entry = list.next()) {
    const auto json = as<JsonObject>(*entry);
    templates_.push_back(json ? reader.read(*json, said) : Geometry{});
  }
  said.flush("geometry-templates", diagnostics_);
}

/// A feature names the object that it is about.
void CityJsonDocuments::checkFeature(const JsonObject& root, const JsonObject& objects,
                                     const std::string& place) {
  const auto id = memberAs<std::string_view>(root, "id");
  if (!id) {
    diagnostics_.push_back(diagnose(Code::IdMissing, "feature", {}, place));
  } else if (!member(objects, *id)) {
    diagnostics_.push_back(
        diagnose(Code::ParentMissing, "the feature names none of its objects", std::string(*id), place));
  }
  if (!hasTransform_ && model_.sources.back().version.empty()) {
    diagnostics_.push_back(
        diagnose(Code::TransformMissing, "feature before any CityJSON document", {}, place));
    hasTransform_ = true;  // said once
  }
}

std::vector<Vec3> CityJsonDocuments::readVertices(const std::optional<JsonElement>& list,
                                                  bool transformed) const {
  std::vector<Vec3> vertices;
  JsonBeside points(list);
  while (const auto point = points.next()) {
    const Vec3 p = readPoint(*point);
    vertices.push_back(transformed ? Vec3(p.cwiseProduct(scale_) + translate_) : p);
  }
  return vertices;
}

}  // namespace lodestone
