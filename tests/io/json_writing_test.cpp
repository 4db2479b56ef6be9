#include "model/io/json_writing.h"

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace lodestone {
namespace {

TEST(JsonWriting, QuotesWhatJsonCannotHold) {
  EXPECT_EQ(jsonQuoted("a\"b\\c\n"), "\"a\\\"b\\\\c\\u000a\"");
  EXPECT_EQ(jsonQuoted("Gebäude 東"), "\"Gebäude 東\"");
  EXPECT_EQ(jsonQuoted("a\xFFz"), "\"a\xEF\xBF\xBDz\"");
  EXPECT_EQ(jsonQuoted("\xC3"), "\"\xEF\xBF\xBD\"");
}

// Any bytes at all become a text that an independent parser takes.
TEST(JsonWriting, EveryTextIsValidJson) {
  std::mt19937 random(7);
  for (int round = 0; round < 20000; ++round) {
    std::string text(random() % 8, '\0');
    for (char& c : text) c = static_cast<char>(random() % 256);
    EXPECT_TRUE(nlohmann::json::accept(jsonQuoted(text)));
  }
}

TEST(JsonWriting, NumbersReadBackAsTheSameDoubles) {
  EXPECT_EQ(jsonNumber(5), "5.0");
  EXPECT_EQ(jsonNumber(0.1), "0.1");
  EXPECT_EQ(jsonNumber(std::numeric_limits<double>::quiet_NaN()), "null");
  EXPECT_EQ(jsonNumber(-std::numeric_limits<double>::infinity()), "null");
  std::mt19937_64 random(8);
  for (int round = 0; round < 20000; ++round) {
    const std::uint64_t bits = random();
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const auto parsed = nlohmann::json::parse(jsonNumber(value));
    EXPECT_TRUE(parsed.is_number_float());
    EXPECT_EQ(parsed.get<double>(), value);
  }
}

}  // namespace
}  // namespace lodestone
