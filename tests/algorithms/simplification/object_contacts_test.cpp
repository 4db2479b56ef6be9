#include "algorithms/simplification/object_contacts.h"

#include <gtest/gtest.h>

#include "tests/support/part_models.h"

namespace lodestone {
namespace {

/// Boxes of 10 m side by side from x on, each an object of its own.
Faces boxAt(double x) {
  return boxFaces({x, 0, 0}, {x + 10, 8, 6});
}

std::vector<ContactFate> fates(const ObjectContacts& contacts) {
  std::vector<ContactFate> result;
  for (const ContactReport& contact : contacts.contacts) result.push_back(contact.fate);
  return result;
}

TEST(ObjectContacts, AreKeptSeparatedOrLostByName) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10), boxAt(20), boxAt(30)});
  ComponentMesh other = meshOfParts({boxAt(0), boxAt(10), boxAt(20.5)});
  const ObjectContacts same = followObjects(row, row);
  EXPECT_EQ(fates(same), (std::vector<ContactFate>(3, ContactFate::Kept)));
  EXPECT_EQ(same.named, 4U);
  const ObjectContacts changed = followObjects(row, other);
  EXPECT_EQ(fates(changed),
            (std::vector<ContactFate>{ContactFate::Kept, ContactFate::Separated, ContactFate::Lost}));
  EXPECT_NEAR(changed.contacts[1].gap, 0.5, 1e-9);
  EXPECT_EQ(changed.contacts[1].first, 1U);
  EXPECT_EQ(changed.contacts[1].second, 2U);
  EXPECT_EQ(changed.named, 3U);
  EXPECT_EQ(changed.unfollowed, 0U);
}

/// In whatever order they stand, and whatever else the other model has.
TEST(ObjectContacts, NamesAndNotPlacesInTheFileCount) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10), boxAt(20)});
  ComponentMesh turned = meshOfParts({boxAt(100), boxAt(20), boxAt(10), boxAt(0)});
  for (std::size_t i = 0; i < 4; ++i)
    turned.objects[turned.components[i].object].id = i == 0 ? "new" : "part-" + std::to_string(3 - i);
  EXPECT_EQ(fates(followObjects(row, turned)), (std::vector<ContactFate>(2, ContactFate::Kept)));
}

TEST(ObjectContacts, NamesThatSeveralObjectsHaveAreNotFollowed) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10), boxAt(20)});
  ComponentMesh twice = row;
  twice.objects[twice.components[2].object].id = "part-1";
  for (const auto& [a, b] : {std::pair(row, twice), std::pair(twice, row)}) {
    const ObjectContacts contacts = followObjects(a, b);
    EXPECT_EQ(contacts.unfollowed, 2U);
    EXPECT_TRUE(contacts.contacts.empty());
    EXPECT_EQ(contacts.named, 1U);
  }
}

/// Two boxes that touch are one object in the original: what they do to each other is not asked.
TEST(ObjectContacts, AnObjectIsAllItsComponents) {
  Faces pair = boxAt(0);
  for (const auto& face : boxFaces({10, 1, 0}, {20, 7, 5})) pair.push_back(face);
  const ComponentMesh original = meshOfParts({pair, boxAt(20)});
  ASSERT_EQ(original.components.size(), 3U);
  Faces apart = boxAt(-3);
  for (const auto& face : boxFaces({10, 1, 0}, {20, 7, 5})) apart.push_back(face);
  const ObjectContacts contacts = followObjects(original, meshOfParts({apart, boxAt(20)}));
  EXPECT_EQ(fates(contacts), (std::vector<ContactFate>{ContactFate::Kept}));
}

TEST(ObjectContacts, OfNothingThereAreNone) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10)});
  EXPECT_EQ(fates(followObjects(row, {})), (std::vector<ContactFate>{ContactFate::Lost}));
  EXPECT_EQ(followObjects(row, {}).named, 0U);
  EXPECT_TRUE(followObjects({}, row).contacts.empty());
}

}  // namespace
}  // namespace lodestone
