// Whether a PNG is whole, before a library that prints what it dislikes reads it.
#pragma once

#include <string>
#include <string_view>

namespace lodestone {

/// What is wrong with the chunks up to the end of the image data (PNG, 3rd edition, 5.3): cut off, or damaged
/// by their checksums. Empty where nothing is, and of bytes that are no PNG. Cost: linear.
[[nodiscard]] std::string whyBrokenPng(std::string_view bytes);

}  // namespace lodestone
