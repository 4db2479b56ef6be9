#include "model/io/citygml/citygml_reports.h"

namespace lodestone::citygml {

void Reports::add(Diagnostic diagnostic) {
  if (++counts_[diagnostic.code] > kMostOfOneCode) return;
  const std::size_t line = line_ ? line_() : 0;
  diagnostic.place = line == 0 ? file_ : file_ + ":" + std::to_string(line);
  diagnostics_.push_back(std::move(diagnostic));
}

void Reports::add(Code code, std::string detail, std::string object) {
  add(diagnose(code, std::move(detail), std::move(object)));
}

void Reports::once(Code code, const std::string& detail, const std::string& object) {
  if (said_.try_emplace({code, detail}, true).second) add(code, detail, object);
}

Diagnostics Reports::take() {
  for (const auto& [code, count] : counts_) {
    if (count > kMostOfOneCode) {
      diagnostics_.push_back(
          diagnose(code, std::to_string(count - kMostOfOneCode) + " more of these", {}, file_));
    }
  }
  counts_.clear();
  said_.clear();
  return std::move(diagnostics_);
}

}  // namespace lodestone::citygml
