#include "algorithms/rendering/png_check.h"

#include <array>
#include <cstdint>

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

/// Of each byte, what it makes of the checksum (annex D of the standard).
constexpr std::array<std::uint32_t, 256> kSums = [] {
  constexpr std::uint32_t kPolynomial = 0xEDB88320U;
  std::array<std::uint32_t, 256> sums{};
  for (std::uint32_t byte = 0; byte < sums.size(); ++byte) {
    std::uint32_t sum = byte;
    for (int bit = 0; bit < 8; ++bit) sum = (sum & 1U) != 0 ? kPolynomial ^ (sum >> 1U) : sum >> 1U;
    sums[byte] = sum;
  }
  return sums;
}();

std::uint32_t checksum(std::string_view bytes) {
  std::uint32_t sum = 0xFFFFFFFFU;
  for (const char byte : bytes) sum = kSums[(sum ^ static_cast<unsigned char>(byte)) & 0xFFU] ^ (sum >> 8U);
  return ~sum;
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
    const bool whole = checksum(bytes.substr(at + 4, 4 + length)) == numberAt(bytes, at + 8 + length);
    if ((first && type != "IHDR") || (isCritical(type) && !whole))
      return fmt::format("it is damaged at byte {}", at);
    first = false;
    at += kFrame + length;
  }
  return {};
}

}  // namespace lodestone
