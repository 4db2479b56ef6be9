#include "model/lod_rank.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

struct Named {
  const char* lod;
  double outside;    ///< as model/exterior.cpp asks
  double footprint;  ///< as algorithms/footprints/footprints.cpp asks
};

TEST(LodRank, IsTheNumberInTheName) {
  for (const Named& named :
       {Named{"0", 0, 0}, Named{"0.3", 0.3, 0.3}, Named{"1", 1, 1}, Named{"1.3", 1.3, 1.3}, Named{"2", 2, 2},
        Named{"2.2", 2.2, 2.2}, Named{"3", 3, 3}, Named{"3.3", 3.3, 3.3}, Named{"4", 4, 1.95},
        Named{"lod3", 3, 3}, Named{"LoD2.1", 2.1, 2.1}, Named{"2.x", 2, 2}, Named{"lod4", 4, 1.95},
        Named{"", 1, 2}, Named{"fine", 1, 2}}) {
    EXPECT_DOUBLE_EQ(lodRank(named.lod, {.unsaid = 1}), named.outside) << named.lod;
    EXPECT_DOUBLE_EQ(lodRank(named.lod, {.unsaid = 2, .interior = 1.95}), named.footprint) << named.lod;
  }
}

}  // namespace
}  // namespace lodestone
