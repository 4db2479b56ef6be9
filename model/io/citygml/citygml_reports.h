// Diagnostics of one file: the first of each kind in full, the rest counted.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "model/diagnostics.h"

namespace lodestone::citygml {

class Reports {
 public:
  explicit Reports(std::string file = {}) : file_(std::move(file)) {}
  /// Where the reader stands; asked only when there is something to say, for counting lines costs a pass over
  /// the text.
  void setLine(std::function<std::size_t()> line) { line_ = std::move(line); }
  void add(Code code, std::string detail, std::string object = {});
  /// The place is put in here.
  void add(Diagnostic diagnostic);
  /// Says a thing once a file, whatever the number of objects it is true of.
  void once(Code code, const std::string& detail, const std::string& object = {});
  /// All of them, with one line more for each code that was said too often.
  [[nodiscard]] Diagnostics take();

 private:
  static constexpr std::size_t kMostOfOneCode = 50;
  std::string file_;
  std::function<std::size_t()> line_;
  Diagnostics diagnostics_;
  std::map<Code, std::size_t> counts_;
  std::map<std::pair<Code, std::string>, bool> said_;
};

}  // namespace lodestone::citygml
