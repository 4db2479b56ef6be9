#include "model/io/citygml/citygml.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "model/io/citygml/citygml_reader.h"
#include "model/io/input_file.h"
#include "model/io/read_archive.h"

namespace lodestone {
namespace citygml {
namespace {

/// What is said when a file cannot be opened or read on.
Diagnostic fileFailure(const std::system_error& error, const std::string& name) {
  Code code = Code::FileUnreadable;
  if (error.code() == std::errc::no_such_file_or_directory) code = Code::FileNotFound;
  if (error.code() == std::errc::file_too_large) code = Code::ArchiveUnsafe;
  return diagnose(code, error.what(), {}, name);
}

/// The reading of one document, in as many passes as it takes.
class Document {
 public:
  Document(std::string path, std::string name, const ImportOptions& options, const Progress& progress)
      : path_(std::move(path)),
        name_(std::move(name)),
        progress_(progress),
        lasting_(name_),
        table_(path_, options.allowOutside, lasting_) {}

  Result<CityModel> read() {
    Pass pass = run(Purpose::Build, {}, progress_.part(0, 0.8));
    if (fetch(pass.wanted) || pass.appearancesLate) {
      knowledge_.appearancesKnown = true;
      pass = run(Purpose::Build, {}, progress_.part(0.9, 1));
    }
    return result(std::move(pass));
  }

 private:
  struct Pass {
    CityModel model;
    Diagnostics diagnostics;
    std::unordered_set<std::uint64_t> wanted;
    std::string version;
    std::string title;
    std::uint64_t bytes = 0;
    std::size_t unnamed = 0;
    bool appearancesLate = false;
    bool failed = false;
  };

  /// Gets what links across objects lead to; false when there is nothing to get.
  bool fetch(const std::unordered_set<std::uint64_t>& wanted) {
    const auto known = [&](std::uint64_t id) { return knowledge_.shared.contains(id); };
    if (!std::all_of(wanted.begin(), wanted.end(), known)) {
      (void)run(Purpose::Fetch, wanted, progress_.part(0.8, 0.9));
    }
    return std::any_of(wanted.begin(), wanted.end(), known);
  }

  Pass run(Purpose purpose, const std::unordered_set<std::uint64_t>& wanted, const Progress& progress) {
    Pass pass;
    Reports reports(name_);
    Reader reader(knowledge_, table_, reports, purpose);
    reader.wanted = wanted;
    try {
      InputFile file(path_);
      const auto source = [&](char* buffer, std::size_t size) {
        progress.checkpoint();
        progress.report(file.shareRead());
        return file.read(buffer, size);
      };
      const auto failure = parseXml(source, reader);
      pass.bytes = file.bytesRead();
      if (failure) {
        pass.diagnostics.push_back(diagnose(pass.bytes == 0 ? Code::FileEmpty : failure->code, failure->text,
                                            {}, fmt::format("{}:{}", name_, failure->line)));
      }
    } catch (const std::system_error& error) {
      pass.diagnostics.push_back(fileFailure(error, name_));
    }
    pass.failed = !pass.diagnostics.empty();
    Diagnostics said = reports.take();
    pass.diagnostics.insert(pass.diagnostics.end(), said.begin(), said.end());
    pass.model = std::move(reader.model);
    pass.wanted = std::move(reader.wanted);
    pass.version = std::move(reader.version);
    pass.title = std::move(reader.title);
    pass.unnamed = reader.unnamed;
    pass.appearancesLate = reader.appearancesLate;
    return pass;
  }

  Result<CityModel> result(Pass pass) {
    Diagnostics diagnostics = lasting_.take();
    diagnostics.insert(diagnostics.end(), pass.diagnostics.begin(), pass.diagnostics.end());
    const bool nothing = pass.model.buildings.empty() && pass.model.others.empty();
    if (pass.failed && nothing) return Result<CityModel>::failure(std::move(diagnostics));
    if (pass.version.empty()) {
      diagnostics.push_back(diagnose(Code::FormatUnknown, "XML, but not CityGML", {}, name_));
      return Result<CityModel>::failure(std::move(diagnostics));
    }
    if (pass.unnamed > 0) {
      diagnostics.push_back(diagnose(Code::IdMissing, std::to_string(pass.unnamed), {}, name_));
    }
    table_.moveTo(pass.model);
    pass.model.sources.push_back({path_, "citygml", pass.version, pass.title});
    return {std::move(pass.model), std::move(diagnostics)};
  }

  std::string path_;
  std::string name_;
  Progress progress_;
  Reports lasting_;  ///< what appearances have to say, which are read once
  AppearanceTable table_;
  Knowledge knowledge_;
};

int probe(const std::filesystem::path& path, std::string_view head) {
  const auto has = [&](std::string_view text) { return head.find(text) != std::string_view::npos; };
  if (has("http://www.opengis.net/citygml/") || has("http://www.citygml.org/citygml/")) return 100;
  // A long comment may stand before the root element.
  const std::string ending = path.extension().string();
  return has("<?xml") && (ending == ".gml" || ending == ".citygml") ? 5 : 0;
}

Result<CityModel> read(const std::filesystem::path& path, const ImportOptions& options,
                       const Progress& progress) {
  if (isArchive(path)) {
    const auto isOurs = [](const std::string& member) { return probe(member, readHead(member)) > 0; };
    const auto readMember = [&](const std::string& member, const std::string& name, std::size_t,
                                const Progress& share) {
      return Document(member, name, options, share).read();
    };
    return readArchive(path, options, {isOurs, readMember}, progress);
  }
  return Document(virtualPath(path), path.filename().string(), options, progress).read();
}

}  // namespace
}  // namespace citygml

Format cityGmlFormat() {
  return {.id = "citygml",
          .title = "CityGML 1.0, 2.0, 3.0",
          .extensions = {".gml", ".citygml", ".xml", ".gml.gz", ".xml.gz", ".citygml.gz", ".zip"},
          .probe = &citygml::probe,
          .read = &citygml::read,
          .write = nullptr,
          .losses = {}};
}

}  // namespace lodestone
