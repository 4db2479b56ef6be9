#include "model/io/footprints/footprint_heights.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

TEST(Lengths, AsPeopleWriteThem) {
  EXPECT_EQ(parseLength("12"), 12.0);
  EXPECT_EQ(parseLength(" 12.5 m "), 12.5);
  EXPECT_EQ(parseLength("12,5"), 12.5);
  EXPECT_EQ(parseLength("5 m"), 5.0);
  EXPECT_EQ(parseLength("12,5 M"), 12.5);
  EXPECT_EQ(parseLength("12 Meter"), 12.0);
  EXPECT_DOUBLE_EQ(*parseLength("16'"), 16 * 0.3048);
  EXPECT_DOUBLE_EQ(*parseLength("40 ft"), 40 * 0.3048);
  EXPECT_DOUBLE_EQ(*parseLength("5'10\""), 5 * 0.3048 + 10 * 0.0254);
  for (const char* bad :
       {"", "high", "12 floors", "m", "nan", "inf", "1e999", "12;15", "ca. 12 m", "10-12", "1.234,5"})
    EXPECT_FALSE(parseLength(bad)) << bad;
}

Attributes attributes(std::initializer_list<Attributes::Entry> entries) {
  Attributes result;
  for (const auto& [name, value] : entries) result.set(name, value);
  return result;
}

TEST(Heights, PrecedenceIsFieldFloorsDefault) {
  const HeightRule rule{ImportOptions{}};
  const auto both = rule.find(attributes({{"HEIGHT_ROOF", 12.5}, {"building:levels", std::string("2")}}));
  EXPECT_EQ(both.height, 12.5);
  EXPECT_EQ(both.source, HeightSource::Attribute);
  const auto floors = rule.find(attributes({{"building:levels", std::string("4")}}));
  EXPECT_EQ(floors.height, 12);
  EXPECT_EQ(floors.source, HeightSource::Floors);
  const auto nothing = rule.find(attributes({{"name", std::string("x")}, {"roof:height", std::string("3")}}));
  EXPECT_EQ(nothing.height, 10);
  EXPECT_EQ(nothing.source, HeightSource::Default);
}

TEST(Heights, NotPositiveIsPassedOver) {
  const HeightRule rule{ImportOptions{}};
  const auto found = rule.find(attributes({{"height", std::int64_t{0}}}));
  EXPECT_TRUE(found.notPositive);
  EXPECT_EQ(found.source, HeightSource::Default);
  const auto floors = rule.find(attributes({{"height", -3.0}, {"levels", std::int64_t{2}}}));
  EXPECT_TRUE(floors.notPositive);
  EXPECT_EQ(floors.height, 6);
}

TEST(Heights, TextsThatAreNoLengthsAreNamed) {
  const HeightRule rule{ImportOptions{}};
  const auto high = rule.find(attributes({{"height", std::string("hoch")}}));
  EXPECT_EQ(high.source, HeightSource::Default);
  EXPECT_EQ(high.notUnderstood, "height \"hoch\"");
  const auto floors =
      rule.find(attributes({{"height", std::string("12;14")}, {"building:levels", std::string("3")}}));
  EXPECT_EQ(floors.source, HeightSource::Floors);
  EXPECT_EQ(floors.notUnderstood, "height \"12;14\"");
  EXPECT_EQ(rule.find(attributes({{"levels", std::string("EG+2")}})).notUnderstood, "levels \"EG+2\"");
  // Said by another field, or by nobody: nothing is lost.
  EXPECT_EQ(rule.find(attributes({{"height", std::string("hoch")}, {"hgt", 9.0}})).notUnderstood, "");
  EXPECT_EQ(rule.find(attributes({{"height", std::string(" ")}})).notUnderstood, "");
}

TEST(Heights, ConstantAndNamedFields) {
  ImportOptions constant;
  constant.height = "7.5";
  EXPECT_EQ(HeightRule(constant).find(attributes({{"height", 3.0}})).height, 7.5);
  EXPECT_EQ(HeightRule(constant).find({}).source, HeightSource::Constant);
  ImportOptions named;
  named.height = "H_DACH";
  named.floors = "STOCK";
  named.floorHeight = 4;
  const HeightRule rule(named);
  EXPECT_EQ(rule.find(attributes({{"height", 3.0}, {"h_dach", 9.0}})).height, 9);
  EXPECT_EQ(rule.find(attributes({{"height", 3.0}, {"Stock", std::int64_t{2}}})).height, 8);
  EXPECT_EQ(rule.find(attributes({{"height", 3.0}})).source, HeightSource::Default);
}

TEST(Heights, EveryUsualFieldCounts) {
  const HeightRule rule{ImportOptions{}};
  for (const std::string_view name : usualHeightFields()) {
    EXPECT_EQ(rule.find(attributes({{std::string(name), 21.0}})).height, 21) << name;
  }
  for (const std::string_view name : usualFloorFields()) {
    EXPECT_EQ(rule.find(attributes({{std::string(name), 7.0}})).height, 21) << name;
  }
}

}  // namespace
}  // namespace lodestone
