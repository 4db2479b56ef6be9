// Text that is cut off, hostile, foreign or in another encoding.
#include <gtest/gtest.h>

#include "tests/support/citygml_text.h"

namespace lodestone::test {
namespace {

TEST(CityGml, TruncatedAnywhereKeepsWhatWasComplete) {
  const std::string whole = kHead2 + building(multi("1", member(polygon())), "a") +
                            building(multi("1", member(polygon())), "b") + "</c:CityModel>";
  const std::size_t firstEnds = whole.find("</b:Building>") + 13;
  const std::size_t secondEnds = whole.rfind("</b:Building>") + 13;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    const auto model = readText(whole.substr(0, length));
    EXPECT_TRUE(hasErrors(model.diagnostics)) << length;
    const std::size_t buildings = model ? model->buildings.size() : 0;
    EXPECT_EQ(buildings, (length >= firstEnds ? 1U : 0U) + (length >= secondEnds ? 1U : 0U)) << length;
    if (buildings > 0) {
      EXPECT_EQ(model.diagnostics[0].code, Code::FileTruncated) << length;
    }
  }
}

TEST(CityGml, HostileAndForeignTextIsRefusedWithItsCode) {
  const auto code = [](const std::string& text) {
    const auto result = readText(text);
    return result.diagnostics.empty() ? Code::Internal : result.diagnostics[0].code;
  };
  EXPECT_EQ(code(""), Code::FileEmpty);
  EXPECT_EQ(code("<a/>"), Code::FormatUnknown);
  EXPECT_EQ(code("not xml"), Code::FileMalformed);
  EXPECT_EQ(code("<!DOCTYPE a [<!ENTITY b 'c'>]><a>&b;</a>"), Code::EntityRefused);
  EXPECT_EQ(code("<!DOCTYPE a SYSTEM 'file:///etc/passwd'><a/>"), Code::EntityRefused);
  EXPECT_EQ(code(kHead2 + building("&lol;") + "</c:CityModel>"), Code::EntityRefused);
  EXPECT_EQ(code("<?xml version='1.0' encoding='utf-8'?><a>\xE4</a>"), Code::EncodingBad);
  EXPECT_EQ(code("<?xml version='1.0' encoding='no-such'?><a/>"), Code::EncodingBad);
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "<a>";
  EXPECT_EQ(code(deep), Code::NestingTooDeep);
}

TEST(CityGml, OneByteEncodingsAreRead) {
  for (const char* encoding : {"ISO-8859-1", "windows-1252", "ISO-8859-15"}) {
    const auto model = readText("<?xml version='1.0' encoding='" + std::string(encoding) + "'?>" + kHead2 +
                                building("<g:name>Stra\xDF"
                                         "e</g:name>") +
                                "</c:CityModel>");
    ASSERT_TRUE(model) << encoding;
    EXPECT_EQ(only(model).attributes.text("name"), "Straße") << encoding;
  }
}

}  // namespace
}  // namespace lodestone::test
