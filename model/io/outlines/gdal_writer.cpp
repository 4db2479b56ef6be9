#include "model/io/outlines/gdal_writer.h"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <set>
#include <system_error>

#include <cpl_conv.h>
#include <fmt/format.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include "model/io/atomic_file.h"
#include "model/io/gdal_support.h"
#include "model/io/places/georeference.h"

namespace lodestone {
namespace fs = std::filesystem;
namespace {

fs::path makeFolderBeside(const fs::path& path) {
  const fs::path parent = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::string name = (parent / ("." + path.stem().string() + ".XXXXXX")).string();
  if (!::mkdtemp(name.data())) throw std::system_error(errno, std::generic_category(), path.string());
  return name;
}

/// A folder beside the output, gone when this is gone, and with it the folders that were made on the way,
/// unless kept.
class FolderBeside {
 public:
  explicit FolderBeside(const fs::path& path) : made_(path), folder_(makeFolderBeside(path)) {}
  [[nodiscard]] const fs::path& path() const { return folder_.path(); }
  void keep() { made_.keep(); }

 private:
  MadeFolders made_;
  Unfinished folder_;
};

/// Times that drivers write into their files, fixed as long as this lives.
class FixedDate {
 public:
  FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z"); }
  ~FixedDate() { CPLSetThreadLocalConfigOption("OGR_CURRENT_DATE", nullptr); }
  FixedDate(const FixedDate&) = delete;
  FixedDate& operator=(const FixedDate&) = delete;
};

/// GDAL does not hand on the number of the error: its first words say what happened, the rest follows from
/// it. SQLite has often freed what it wrote by the time that one could look at the disk.
[[noreturn]] void fail(const fs::path& path, const GdalErrors& errors) {
  const std::string words = errors.failures().empty() ? std::string() : errors.failures().front();
  const bool saysFull =
      words.find("disk is full") != std::string::npos || words.find("No space left") != std::string::npos;
  const std::errc why = saysFull || isFull(path) ? std::errc::no_space_on_device : std::errc::io_error;
  throw std::system_error(std::make_error_code(why), path.string() + ": " + words);
}

OGRFieldType fieldType(OutlineColumn::Type type) {
  switch (type) {
    case OutlineColumn::Type::Integer:
      return OFTInteger64;
    case OutlineColumn::Type::Real:
      return OFTReal;
    default:
      return OFTString;
  }
}

void closeInto(OGRLinearRing& target, const Ring& ring) {
  const auto count = static_cast<int>(ring.size());
  target.setNumPoints(count + 1, FALSE);
  for (int i = 0; i <= count; ++i) {
    const Vec2& p = ring[static_cast<std::size_t>(i % count)];
    target.setPoint(i, p.x(), p.y());
  }
}

std::unique_ptr<OGRPolygon> polygonFrom(const Polygon& polygon) {
  auto result = std::make_unique<OGRPolygon>();
  const auto add = [&](const Ring& ring) {
    auto target = std::make_unique<OGRLinearRing>();
    closeInto(*target, ring);
    result->addRingDirectly(target.release());
  };
  add(polygon.outer);
  for (const Ring& hole : polygon.holes) add(hole);
  return result;
}

std::unique_ptr<OGRGeometry> geometryFrom(const MultiPolygon& outline, bool multi) {
  if (outline.empty()) return nullptr;
  if (!multi) return polygonFrom(outline.front());
  auto result = std::make_unique<OGRMultiPolygon>();
  for (const Polygon& polygon : outline) result->addGeometryDirectly(polygonFrom(polygon).release());
  return result;
}

void setValue(OGRFeature& feature, int field, const OutlineValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value))
    feature.SetField(field, static_cast<GIntBig>(*whole));
  if (const auto* real = std::get_if<double>(&value)) feature.SetField(field, *real);
  if (const auto* text = std::get_if<std::string>(&value)) feature.SetField(field, text->c_str());
}

/// One output under construction.
class VectorOutput {
 public:
  /// `path`: where the output is going to be, for messages; `file`: where it is written.
  VectorOutput(const fs::path& path, const fs::path& file, const std::string& driver) : path_(path) {
    GDALDriver* found = GetGDALDriverManager()->GetDriverByName(driver.c_str());
    if (!found) fail(path_, errors_);
    dataset_.reset(found->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    if (!dataset_) fail(path_, errors_);
    dataset_->StartTransaction(FALSE);
  }

  void write(const OutlineTable& table, OGRSpatialReference* srs, const Progress& progress) {
    const OGRwkbGeometryType type = table.multi ? wkbMultiPolygon : wkbPolygon;
    OGRLayer* layer = dataset_->CreateLayer(unique(table.name).c_str(), srs, type, nullptr);
    if (!layer) fail(path_, errors_);
    std::vector<std::size_t> columns;  // lists are for tables of their own
    for (std::size_t c = 0; c < table.columns.size(); ++c) {
      if (table.columns[c].type == OutlineColumn::Type::TextList) continue;
      OGRFieldDefn field(table.columns[c].name.c_str(), fieldType(table.columns[c].type));
      if (layer->CreateField(&field) != OGRERR_NONE) fail(path_, errors_);
      columns.push_back(c);
    }
    inOrder(table.rows, progress, table.row, [&](const OutlineRow& row) {
      OGRFeature feature(layer->GetLayerDefn());
      for (std::size_t f = 0; f < columns.size(); ++f)
        setValue(feature, static_cast<int>(f), row.values[columns[f]]);
      feature.SetGeometryDirectly(geometryFrom(row.outline, table.multi).release());
      if (layer->CreateFeature(&feature) != OGRERR_NONE) fail(path_, errors_);
      if (table.seen) table.seen(row);
    });
  }

  void write(const PlainTable& table) {
    if (!dataset_->TestCapability(ODsCCreateLayer)) return;
    OGRLayer* layer = dataset_->CreateLayer(unique(table.name).c_str(), nullptr, wkbNone, nullptr);
    if (!layer) fail(path_, errors_);
    for (const std::string& name : table.columns) {
      OGRFieldDefn field(name.c_str(), OFTString);
      if (layer->CreateField(&field) != OGRERR_NONE) fail(path_, errors_);
    }
    table.fill([&](const std::vector<std::string>& row) {
      OGRFeature feature(layer->GetLayerDefn());
      for (std::size_t f = 0; f < row.size(); ++f) feature.SetField(static_cast<int>(f), row[f].c_str());
      if (layer->CreateFeature(&feature) != OGRERR_NONE) fail(path_, errors_);
    });
  }

  void close() {
    dataset_->CommitTransaction();
    dataset_.reset();
    if (!errors_.failures().empty()) fail(path_, errors_);
  }

 private:
  std::string unique(const std::string& name) {
    std::string result = name;
    for (int i = 2; !names_.insert(result).second; ++i) result = fmt::format("{}_{}", name, i);
    return result;
  }

  const FixedDate date_;
  const GdalErrors errors_;
  fs::path path_;
  DatasetPtr dataset_;
  std::set<std::string> names_;
};

std::vector<fs::path> moveAll(const fs::path& from, const fs::path& path) {
  std::vector<fs::path> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(from))
    names.push_back(entry.path().filename());
  // The main file last: who sees it sees all of them.
  std::sort(names.begin(), names.end(), [&](const fs::path& a, const fs::path& b) {
    return std::pair(a == path.filename(), a) < std::pair(b == path.filename(), b);
  });
  std::vector<fs::path> files;
  for (const fs::path& name : names) files.push_back(fileToReplace(path.parent_path() / name));
  for (std::size_t i = 0; i < names.size(); ++i) fs::rename(from / names[i], files[i]);
  std::reverse(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<fs::path> writeVector(const fs::path& wanted, const std::string& driver, const Crs& crs,
                                  const std::vector<OutlineTable>& tables,
                                  const std::vector<PlainTable>& plain, const Progress& progress) {
  useGdal();
  const fs::path path = fileToReplace(wanted);  // beside what a link leads to: that may be another disk
  FolderBeside beside(path);
  const auto srs = horizontalReference(crs);
  VectorOutput output(path, beside.path() / path.filename(), driver);
  const auto share = static_cast<double>(std::max<std::size_t>(tables.size(), 1));
  for (std::size_t t = 0; t < tables.size(); ++t) {
    output.write(tables[t], srs.get(),
                 progress.part(static_cast<double>(t) / share, static_cast<double>(t + 1) / share));
  }
  for (const PlainTable& table : plain) output.write(table);
  output.close();
  std::vector<fs::path> files = moveAll(beside.path(), path);
  beside.keep();
  return files;
}

}  // namespace lodestone
