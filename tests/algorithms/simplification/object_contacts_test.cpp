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

/// Of models in which every object is a building.
ObjectContacts follow(const ComponentMesh& original, const ComponentMesh& other, double rounding = 0) {
  return followObjects({original, {}}, {other, {}}, rounding);
}

TEST(ObjectContacts, AreKeptSeparatedOrLostByName) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10), boxAt(20), boxAt(30)});
  ComponentMesh other = meshOfParts({boxAt(0), boxAt(10), boxAt(20.5)});
  const ObjectContacts same = follow(row, row);
  EXPECT_EQ(fates(same), (std::vector<ContactFate>(3, ContactFate::Kept)));
  EXPECT_EQ(same.named, 4U);
  const ObjectContacts changed = follow(row, other);
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
  EXPECT_EQ(fates(follow(row, turned)), (std::vector<ContactFate>(2, ContactFate::Kept)));
}

TEST(ObjectContacts, NamesThatSeveralObjectsHaveAreNotFollowed) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10), boxAt(20)});
  ComponentMesh twice = row;
  twice.objects[twice.components[2].object].id = "part-1";
  for (const auto& [a, b] : {std::pair(row, twice), std::pair(twice, row)}) {
    const ObjectContacts contacts = follow(a, b);
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
  const ObjectContacts contacts = follow(original, meshOfParts({apart, boxAt(20)}));
  EXPECT_EQ(fates(contacts), (std::vector<ContactFate>{ContactFate::Kept}));
}

TEST(ObjectContacts, WhatFilesRoundAwayIsNoGap) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10)});
  const ComponentMesh rounded = meshOfParts({boxAt(0), boxAt(10.001)});
  EXPECT_EQ(fates(follow(row, rounded)), (std::vector<ContactFate>{ContactFate::Separated}));
  const ObjectContacts contacts = follow(row, rounded, 0.002);
  EXPECT_EQ(fates(contacts), (std::vector<ContactFate>{ContactFate::Kept}));
  EXPECT_EQ(contacts.contacts[0].gap, 0);
}

/// Two buildings of two parts each, wall to wall: a format without parts has each of them as one object.
TEST(ObjectContacts, PartsThatTheOtherFormatDoesNotKnowAreNotLost) {
  ComponentMesh parts = meshOfParts({boxAt(0), boxAt(10), boxAt(20), boxAt(30)});
  const std::vector<std::string> ids{"left", "right"};
  parts.objects[0].id = "left";  // has a geometry of its own beside its part
  for (std::size_t i = 0; i < 4; ++i) parts.objects[i].building = i < 2 ? 0 : 1;
  Faces left = boxAt(0);
  for (const auto& face : boxFaces({10, 0, 0}, {20, 8, 6})) left.push_back(face);
  Faces right = boxAt(20);
  for (const auto& face : boxFaces({30, 0, 0}, {40, 8, 6})) right.push_back(face);
  ComponentMesh whole = meshOfParts({left, right});
  whole.objects[0].id = "left";
  whole.objects[1].id = "right";
  whole.objects[1].building = 0;  // as a mesh is read: groups of one building that is named as its file
  const std::vector<std::string> file{"file"};
  for (const ObjectContacts& contacts :
       {followObjects({parts, ids}, {whole, file}), followObjects({whole, file}, {parts, ids})}) {
    EXPECT_EQ(fates(contacts), (std::vector<ContactFate>{ContactFate::Kept}));
    EXPECT_EQ(contacts.named, 2U);
  }
  EXPECT_TRUE(followObjects({parts, ids}, {whole, file}).partsUnknown);
  EXPECT_FALSE(followObjects({whole, file}, {parts, ids}).partsUnknown);
  EXPECT_EQ(followObjects({parts, ids}, {whole, file}).objects, 4U);
  EXPECT_EQ(fates(followObjects({parts, ids}, {parts, ids})),
            (std::vector<ContactFate>(3, ContactFate::Kept)));
}

TEST(ObjectContacts, OfNothingThereAreNone) {
  const ComponentMesh row = meshOfParts({boxAt(0), boxAt(10)});
  EXPECT_EQ(fates(follow(row, {})), (std::vector<ContactFate>{ContactFate::Lost}));
  EXPECT_EQ(follow(row, {}).named, 0U);
  EXPECT_TRUE(follow({}, row).contacts.empty());
}

}  // namespace
}  // namespace lodestone
