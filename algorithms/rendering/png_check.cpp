#include "algorithms/rendering/png_check.h"

#include <cstdint>

#include <boost/crc.hpp>
#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kImageData = "IDAT";
constexpr std::size_t kFrame = 12;  // a chunk's length, type and checksum

std::uint32_t numberAt(std::string_view bytes, std::size_t at) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// Readers do without the others.
bool isCritical(std::string_view type) {
  return type[0] >= 'A' && type[0] <= 'Z';
}

}  // namespace

std::string whyBrokenPng(std::string_view bytes) {
  if (!bytes.starts_with(kSignature)) return {};
  bool first = true;
  bool inImage = false;
  for (std::size_t at = kSignature.size(); !inImage || at < bytes.size();) {
    const std::size_t left = bytes.size() - at;
    const std::size_t length = left < kFrame ? 0 : numberAt(bytes, at);
    if (left < kFrame || length > left - kFrame)
      return fmt::format("it is cut off, or damaged, after {} bytes", bytes.size() - left);
    const std::string_view type = bytes.substr(at + 4, 4);
    if (inImage && type != kImageData) break;
    inImage = type == kImageData;
    boost::crc_32_type sum;
    sum.process_bytes(bytes.data() + at + 4, 4 + length);
    const bool whole = sum.checksum() == numberAt(bytes, at + 8 + length);
    if ((first && type != "IHDR") || (isCritical(type) && !whole))
      return fmt::format("it is damaged at byte {}", at);
    first = false;
    at += kFrame + length;
  }
  return {};
}

}  // namespace lodestone
