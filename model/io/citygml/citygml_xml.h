// Expat, fed from an InputFile, with what a hostile or broken file must not do kept out.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "model/io/input_file.h"
#include "model/progress.h"

namespace lodestone::citygml {

/// Receives a document. Exceptions thrown by the handler stop the parser and leave parseXml().
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  /// Names are "namespace<kSeparator>local"; `attributes` as Expat gives them.
  virtual void startElement(const char* name, const char** attributes) = 0;
  virtual void endElement() = 0;

  [[nodiscard]] std::size_t line() const { return lineOf_ ? lineOf_() : 0; }

 protected:
  /// Character data is appended to text_ while this is set.
  bool collecting_ = false;
  std::string text_;

 private:
  friend class XmlSession;
  std::function<std::size_t()> lineOf_;
};

/// Gives the bytes of a document: fills the buffer, returns 0 at the end.
using ByteSource = std::function<std::size_t(char* buffer, std::size_t size)>;

struct XmlFailure {
  Code code = Code::FileMalformed;
  std::string text;
  std::size_t line = 0;
};

/// Parses to the end or to the first thing wrong: bad syntax, early end, a DOCTYPE, nesting over 256
/// elements. UTF-8, UTF-16 and every one-byte encoding that iconv knows. \throw whatever `source` and
/// `handler` throw. Cost: linear; memory: the longest piece of text.
[[nodiscard]] std::optional<XmlFailure> parseXml(const ByteSource& source, XmlHandler& handler);

}  // namespace lodestone::citygml
