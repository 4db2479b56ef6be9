// Flags of perception analysis.
#pragma once

#include "cli/flags.h"
#include "model/perceive_options.h"

namespace lodestone::cli {

/// Those of the field table. Pictures are square: --size takes 1024x1024 for 1024.
inline void addPerceiveFlags(CLI::App& app, PerceiveOptions& options) {
  addFlags(app, options);
  app.get_option("--size")->transform([](const std::string& text) {
    const std::size_t times = text.find('x');
    const bool square = times != std::string::npos && text.substr(0, times) == text.substr(times + 1);
    return square ? text.substr(0, times) : text;
  });
}

}  // namespace lodestone::cli
