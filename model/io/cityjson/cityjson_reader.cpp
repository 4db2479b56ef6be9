#include "model/io/cityjson/cityjson_reader.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "model/io/cityjson/cityjson_document.h"
#include "model/io/input_file.h"
#include "model/io/read_archive.h"

namespace lodestone {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
/// Broken lines that are said one by one.
constexpr std::size_t kSaidLines = 20;

/// End of the JSON value that starts at `begin`, by its brackets; npos when they do not close.
std::size_t endOfValue(std::string_view text, std::size_t begin) {
  std::size_t depth = 0;
  for (std::size_t i = begin; i < text.size(); ++i) {
    switch (text[i]) {
      case '"':
        for (++i; i < text.size() && text[i] != '"'; ++i) {
          if (text[i] == '\\') ++i;
        }
        break;
      case '{':
      case '[':
        ++depth;
        break;
      case '}':
      case ']':
        if (depth <= 1) return i + 1;
        --depth;
        break;
      default:
        break;
    }
  }
  return std::string_view::npos;
}

Code codeOf(simdjson::error_code error, bool closes) {
  switch (error) {
    case simdjson::UTF8_ERROR:
      return Code::EncodingBad;
    case simdjson::DEPTH_ERROR:
      return Code::NestingTooDeep;
    case simdjson::CAPACITY:
    case simdjson::MEMALLOC:
      return Code::CountImplausible;
    case simdjson::EMPTY:
      return Code::FileEmpty;
    default:
      return closes ? Code::FileMalformed : Code::FileTruncated;
  }
}

/// Walks a text of one or more documents. A text whose first line is a document by itself has one a line, and
/// starts anew at every line: a broken one costs no other.
class DocumentWalker {
 public:
  DocumentWalker(std::string& text, CityJsonDocuments& documents, std::string name, Diagnostics& diagnostics,
                 const Progress& progress)
      : size_(text.size()),
        documents_(documents),
        name_(std::move(name)),
        diagnostics_(diagnostics),
        progress_(progress) {
    text.append(simdjson::SIMDJSON_PADDING, ' ');  // simdjson reads that far beyond a document's end
    text_ = text;
  }

  /// Number of documents understood. \throw Cancelled
  std::size_t walk() {
    std::size_t understood = 0;
    while (skipBlank()) {
      const std::size_t begin = at_;
      const std::size_t lineEnd = std::min(text_.find('\n', begin), size_);
      bool good = parse(begin, lineEnd);
      if (good) {
        byLine_ = true;
        at_ = lineEnd;
      } else if (byLine_ || looksWhole(begin, lineEnd)) {
        byLine_ = true;
        at_ = lineEnd;
        sayBroken(begin, lineEnd);
      } else {
        const std::size_t end = std::min(endOfValue(text_.substr(0, size_), begin), size_);
        good = parse(begin, end);
        if (!good) sayBroken(begin, end);
        at_ = good ? end : size_;
      }
      if (good && documents_.add(root_, placeOf(begin), progressFrom(begin))) ++understood;
    }
    if (broken_ > kSaidLines) {
      const std::string more = fmt::format("{} more lines", broken_ - kSaidLines);
      diagnostics_.push_back(diagnose(Code::FileMalformed, more, {}, name_));
    }
    return understood;
  }

 private:
  bool skipBlank() {
    at_ = text_.find_first_not_of(" \t\r\n\x1e", at_);  // RFC 7464 puts record separators between documents
    return at_ < size_;
  }
  bool parse(std::size_t begin, std::size_t end) {
    error_ = parser_.parse(text_.data() + begin, end - begin, false).get(root_);
    return error_ == simdjson::SUCCESS;
  }
  [[nodiscard]] bool looksWhole(std::size_t begin, std::size_t end) const {
    const std::size_t last = text_.substr(0, end).find_last_not_of(" \t\r\n");
    return last > begin && text_[last] == '}' && end < size_;
  }
  void sayBroken(std::size_t begin, std::size_t end) {
    if (++broken_ > kSaidLines) return;
    const bool closes = endOfValue(text_.substr(0, end), begin) != std::string_view::npos;
    diagnostics_.push_back(
        diagnose(codeOf(error_, closes), simdjson::error_message(error_), {}, placeOf(begin)));
  }
  std::string placeOf(std::size_t begin) {
    line_ += static_cast<std::size_t>(std::count(text_.begin() + static_cast<std::ptrdiff_t>(lineAt_),
                                                 text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n'));
    lineAt_ = begin;
    return fmt::format("{}:{}", name_, line_);
  }
  [[nodiscard]] Progress progressFrom(std::size_t begin) const {
    const auto share = [&](std::size_t i) { return static_cast<double>(i) / static_cast<double>(size_); };
    return progress_.part(share(begin), share(std::min(at_, size_)));
  }

  std::string_view text_;
  std::size_t size_;
  CityJsonDocuments& documents_;
  std::string name_;
  Diagnostics& diagnostics_;
  const Progress& progress_;
  simdjson::dom::parser parser_;
  JsonElement root_;
  simdjson::error_code error_ = simdjson::SUCCESS;
  std::size_t at_ = 0;
  std::size_t line_ = 1;
  std::size_t lineAt_ = 0;
  std::size_t broken_ = 0;
  bool byLine_ = false;
};

bool addText(std::string text, CityJsonDocuments& documents, const std::string& name,
             Diagnostics& diagnostics, const Progress& progress) {
  if (text.starts_with(kByteOrderMark)) {
    diagnostics.push_back(diagnose(Code::ByteOrderMark, {}, {}, name));
    text.erase(0, kByteOrderMark.size());
  } else if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
    diagnostics.push_back(diagnose(Code::EncodingBad, "it is UTF-16", {}, name));
    return false;
  }
  if (text.find_first_not_of(" \t\r\n") == std::string::npos) {
    diagnostics.push_back(diagnose(Code::FileEmpty, {}, {}, name));
    return false;
  }
  return DocumentWalker(text, documents, name, diagnostics, progress).walk() > 0;
}

Diagnostic openFailure(const std::system_error& error, const std::string& place) {
  const bool absent = error.code() == std::errc::no_such_file_or_directory;
  const Code code = error.code() == std::errc::file_too_large ? Code::ArchiveUnsafe
                    : absent                                  ? Code::FileNotFound
                                                              : Code::FileUnreadable;
  return diagnose(code, error.what(), {}, place);
}

CityModel modelOf(const std::filesystem::path& path, std::string_view format) {
  CityModel model;
  model.sources.push_back({path.string(), std::string(format), {}, {}});
  return model;
}

Result<CityModel> resultOf(bool any, CityModel model, Diagnostics diagnostics) {
  if (!any) return Result<CityModel>::failure(std::move(diagnostics));
  return {std::move(model), std::move(diagnostics)};
}

/// One file, plain, packed or of an archive; `name` is for messages.
Result<CityModel> readFile(const std::string& file, const std::string& name, std::string_view format,
                           const ImportOptions& options, const Progress& progress) {
  CityModel model = modelOf(file, format);
  Diagnostics diagnostics;
  CityJsonDocuments documents(model, file, options, diagnostics);
  bool any = false;
  try {
    any = addText(readWholeFile(file), documents, name, diagnostics, progress);
  } catch (const std::system_error& error) {
    diagnostics.push_back(openFailure(error, name));
  }
  progress.checkpoint();
  return resultOf(any, std::move(model), std::move(diagnostics));
}

}  // namespace

Result<CityModel> parseCityJson(std::string text, const std::filesystem::path& name, std::string_view format,
                                const ImportOptions& options, const Progress& progress) {
  CityModel model = modelOf(name, format);
  Diagnostics diagnostics;
  CityJsonDocuments documents(model, name, options, diagnostics);
  const bool any = addText(std::move(text), documents, name.filename().string(), diagnostics, progress);
  return resultOf(any, std::move(model), std::move(diagnostics));
}

Result<CityModel> readCityJsonDocuments(const std::filesystem::path& path, std::string_view format,
                                        const ImportOptions& options, const Progress& progress) {
  if (!isArchive(path)) return readFile(path.string(), path.filename().string(), format, options, progress);
  const auto isOurs = [](const std::string& member) {
    return member.ends_with("json") || member.ends_with("jsonl");
  };
  const auto readMember = [&](const std::string& member, const std::string& name, std::size_t,
                              const Progress& share) {
    return readFile(member, name, format, options, share);
  };
  return readArchive(path, options, {isOurs, readMember}, progress);
}

}  // namespace lodestone
