#include "model/io/outlines/geojson.h"

#include <cmath>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "model/io/atomic_file.h"
#include "model/io/json_writing.h"
#include "model/io/output_failure.h"

namespace lodestone {
namespace {

using Buffer = fmt::memory_buffer;

void append(Buffer& out, std::string_view text) {
  out.append(text.data(), text.data() + text.size());
}

void appendString(Buffer& out, std::string_view text) {
  append(out, jsonQuoted(text));
}

// JSON has no NaN and no infinity.
void appendNumber(Buffer& out, double value) {
  if (std::isfinite(value)) {
    fmt::format_to(std::back_inserter(out), "{}", value);
  } else {
    append(out, "null");
  }
}

struct ValueWriter {
  Buffer& out;
  void operator()(std::monostate) const { append(out, "null"); }
  void operator()(std::int64_t value) const { fmt::format_to(std::back_inserter(out), "{}", value); }
  void operator()(double value) const { appendNumber(out, value); }
  void operator()(const std::string& value) const { appendString(out, value); }
  void operator()(const std::vector<std::string>& values) const {
    out.push_back('[');
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) out.push_back(',');
      appendString(out, values[i]);
    }
    out.push_back(']');
  }
};

// GeoJSON closes its rings.
void appendRing(Buffer& out, const Ring& ring) {
  out.push_back('[');
  for (std::size_t i = 0; i <= ring.size() && !ring.empty(); ++i) {
    const Vec2& p = ring[i % ring.size()];
    append(out, i == 0 ? "[" : ",[");
    appendNumber(out, p.x());
    out.push_back(',');
    appendNumber(out, p.y());
    out.push_back(']');
  }
  out.push_back(']');
}

void appendPolygon(Buffer& out, const Polygon& polygon) {
  out.push_back('[');
  appendRing(out, polygon.outer);
  for (const Ring& hole : polygon.holes) {
    out.push_back(',');
    appendRing(out, hole);
  }
  out.push_back(']');
}

void appendGeometry(Buffer& out, const MultiPolygon& outline) {
  if (outline.empty()) return append(out, "null");
  const bool one = outline.size() == 1;
  append(out, one ? R"({"type":"Polygon","coordinates":)" : R"({"type":"MultiPolygon","coordinates":[)");
  for (std::size_t i = 0; i < outline.size(); ++i) {
    if (i > 0) out.push_back(',');
    appendPolygon(out, outline[i]);
  }
  append(out, one ? "}" : "]}");
}

std::string featureText(const OutlineTable& table, std::size_t i) {
  const OutlineRow row = table.row(i);
  Buffer out;
  append(out, R"({"type":"Feature","properties":{)");
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (table.columns[c].sparse && std::holds_alternative<std::monostate>(row.values[c])) continue;
    if (c > 0) out.push_back(',');
    appendString(out, table.columns[c].name);
    out.push_back(':');
    std::visit(ValueWriter{out}, row.values[c]);
  }
  append(out, R"(},"geometry":)");
  appendGeometry(out, row.outline);
  out.push_back('}');
  return fmt::to_string(out);
}

std::string crsMember(const Crs& crs) {
  if (crs.kind == CrsKind::Unknown || crs.kind == CrsKind::Local) return "null";
  Buffer out;
  append(out, R"({"type":"name","properties":{"name":)");
  constexpr int kWgs84 = 4326;
  if (crs.epsg == kWgs84) {
    appendString(out, "urn:ogc:def:crs:OGC:1.3:CRS84");
  } else {
    appendString(out, crs.epsg != 0 ? fmt::format("urn:ogc:def:crs:EPSG::{}", crs.epsg) : crs.source);
  }
  append(out, "}}");
  return fmt::to_string(out);
}

Result<WriteReport> write(const LodChain& chain, const std::filesystem::path& path,
                          const WriteOptions& options, const Progress& progress) {
  try {
    writeGeoJson(path, chain.city->crs, levelTables(chain, options.levels), chain.recipe, progress);
  } catch (const std::system_error& error) {
    return outputFailure(error);
  }
  return WriteReport{{path}};
}

}  // namespace

void writeGeoJson(const std::filesystem::path& path, const Crs& crs, const std::vector<OutlineTable>& tables,
                  const std::string& recipe, const Progress& progress) {
  AtomicFile file(path);
  std::ostream& out = file.stream();
  Buffer name;
  appendString(name, path.stem().string());
  out << "{\"type\":\"FeatureCollection\",\n\"name\":" << fmt::to_string(name)
      << ",\n\"crs\":" << crsMember(crs) << ",\n";
  if (!recipe.empty()) out << "\"recipe\":" << recipe << ",\n";
  out << "\"features\":[";
  const char* separator = "\n";
  for (std::size_t t = 0; t < tables.size(); ++t) {
    const auto share = static_cast<double>(tables.size());
    inOrder(
        tables[t].rows, progress.part(static_cast<double>(t) / share, static_cast<double>(t + 1) / share),
        [&](std::size_t i) { return featureText(tables[t], i); },
        [&](const std::string& text) {
          out << separator << text;
          separator = ",\n";
        });
  }
  out << "\n]}\n";
  file.commit();
}

Format geoJsonFormat() {
  Format format;
  format.id = "geojson";
  format.title = "GeoJSON outlines";
  format.extensions = {".geojson"};
  format.write = write;
  format.losses =
      "surfaces, semantics, materials and textures: outlines, heights, attributes and ids are kept";
  return format;
}

}  // namespace lodestone
