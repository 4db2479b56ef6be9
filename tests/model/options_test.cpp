#include "model/options.h"

#include <set>

#include <gmock/gmock.h>

#include "model/cluster_options.h"
#include "model/import_options.h"

namespace lodestone {
namespace {

TEST(Options, RoundTripThroughNamesAndValues) {
  ClusterOptions options;
  options.linkage = Linkage::Complete;
  options.neighbours = 7;
  options.barrierFactor = 2.5;
  options.attribute = "height=0.5";
  ClusterOptions copy;
  EXPECT_TRUE(setValues(copy, values(options)).empty());
  EXPECT_EQ(copy, options);
}

TEST(Options, TextIsTurnedIntoTheFieldsKind) {
  CutOptions options;
  EXPECT_TRUE(setValues(options, {{"epsilon", std::string("250")}, {"alpha", std::int64_t{4}}}).empty());
  EXPECT_EQ(options.epsilon, 250);
  EXPECT_EQ(options.alpha, 4);
}

TEST(Options, BadValuesAreSaidAndChangeNothing) {
  ClusterOptions options;
  const Diagnostics said = setValues(
      options, {{"neighbours", std::int64_t{0}}, {"linkage", std::string("nearest")}, {"colour", true}});
  ASSERT_EQ(said.size(), 3U);
  EXPECT_EQ(said[0].code, Code::OptionOutOfRange);
  EXPECT_EQ(said[1].code, Code::OptionBadValue);
  EXPECT_EQ(said[2].code, Code::OptionUnknown);
  EXPECT_EQ(options, ClusterOptions{});
}

TEST(Options, CheckFindsValuesOutOfRange) {
  MergeOptions options;
  EXPECT_TRUE(check(options).empty());
  options.edgeRatio = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(check(options).empty());
}

template <class O>
void expectDocumented() {
  std::set<std::string> names;
  for (const auto& field : fields<O>()) {
    EXPECT_TRUE(names.insert(field.name).second) << field.name;
    EXPECT_FALSE(field.help.empty()) << field.name;
    EXPECT_FALSE(field.label.empty()) << field.name;
  }
  EXPECT_TRUE(check(O{}).empty()) << "defaults must be in range";
}

TEST(Options, EveryFieldIsDocumentedAndItsDefaultIsInRange) {
  expectDocumented<ClusterOptions>();
  expectDocumented<MergeOptions>();
  expectDocumented<CutOptions>();
  expectDocumented<ImportOptions>();
}

}  // namespace
}  // namespace lodestone
