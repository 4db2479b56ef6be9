#include "algorithms/clustering/links.h"

#include <gtest/gtest.h>

namespace lodestone {
namespace {

TEST(SpareLists, GiveRoomForWhatIsAsked) {
  SpareLists spare;
  for (std::size_t size = 1; size < 300; ++size) {
    spare.put(LinkList(size));
    EXPECT_GE(spare.take(size).capacity(), size);
  }
}

TEST(SpareLists, GiveBackWhatWasPutIn) {
  SpareLists spare;
  LinkList list(64);
  const Link* memory = list.span().data();
  spare.put(std::move(list));
  const LinkList larger = spare.take(65);
  const LinkList same = spare.take(33);
  const LinkList other = spare.take(33);
  EXPECT_NE(larger.span().data(), memory);
  EXPECT_EQ(same.span().data(), memory);
  EXPECT_NE(other.span().data(), memory);
}

TEST(SpareLists, TakeNothingFromEmptyLists) {
  SpareLists spare;
  spare.put(LinkList());
  EXPECT_EQ(spare.take(1).capacity(), 1U);
}

}  // namespace
}  // namespace lodestone
