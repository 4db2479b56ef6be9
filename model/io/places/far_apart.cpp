#include "model/io/places/far_apart.h"

#include <algorithm>
#include <filesystem>
#include <limits>

#include <fmt/format.h>

namespace lodestone {
namespace {

constexpr double kFar = 20e3;  // metres
constexpr std::size_t kNamed = 3;

/// Sources near each other, at any number of steps.
struct Group {
  std::vector<std::size_t> sources;
  std::size_t buildings = 0;
};

struct SourceBox {
  Box2 box;
  std::size_t buildings = 0;
};

std::vector<SourceBox> boxesOf(const CityModel& model) {
  std::vector<SourceBox> boxes(model.sources.size());
  for (const Building& building : model.buildings) {
    const Box3 box = bounds(building);
    if (box.empty() || building.source >= boxes.size()) continue;
    SourceBox& of = boxes[building.source];
    of.box.add(box.min.head<2>());
    of.box.add(box.max.head<2>());
    ++of.buildings;
  }
  return boxes;
}

double gap(const Box2& a, const Box2& b) {
  return (a.min - b.max).cwiseMax(b.min - a.max).cwiseMax(0.0).norm();
}

std::vector<Group> groupsOf(const std::vector<SourceBox>& boxes) {
  std::vector<Group> groups;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].box.empty()) continue;
    Group joined{{i}, boxes[i].buildings};
    const auto isNear = [&](const Group& group) {
      return std::any_of(group.sources.begin(), group.sources.end(),
                         [&](std::size_t k) { return gap(boxes[i].box, boxes[k].box) <= kFar; });
    };
    for (const Group& group : groups) {
      if (!isNear(group)) continue;
      joined.sources.insert(joined.sources.end(), group.sources.begin(), group.sources.end());
      joined.buildings += group.buildings;
    }
    std::erase_if(groups, isNear);
    std::sort(joined.sources.begin(), joined.sources.end());
    groups.push_back(std::move(joined));
  }
  std::sort(groups.begin(), groups.end(),
            [](const Group& a, const Group& b) { return a.sources.front() < b.sources.front(); });
  return groups;
}

std::string namesOf(const CityModel& model, const Group& group) {
  std::string names;
  for (std::size_t i = 0; i < std::min(kNamed, group.sources.size()); ++i) {
    names += (i == 0 ? "" : ", ") +
             std::filesystem::path(model.sources[group.sources[i]].path).filename().string();
  }
  if (group.sources.size() > kNamed) names += fmt::format(" and {} more", group.sources.size() - kNamed);
  return names;
}

double gap(const std::vector<SourceBox>& boxes, const Group& a, const Group& b) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : a.sources) {
    for (const std::size_t k : b.sources) smallest = std::min(smallest, gap(boxes[i].box, boxes[k].box));
  }
  return smallest;
}

}  // namespace

Diagnostics sayFarApart(const CityModel& model) {
  Diagnostics diagnostics;
  if (model.sources.size() < 2) return diagnostics;
  const std::vector<SourceBox> boxes = boxesOf(model);
  const std::vector<Group> groups = groupsOf(boxes);
  const auto main = std::max_element(
      groups.begin(), groups.end(), [](const Group& a, const Group& b) { return a.buildings < b.buildings; });
  for (auto group = groups.begin(); group != groups.end(); ++group) {
    if (group == main) continue;
    diagnostics.push_back(
        diagnose(Code::InputsFarApart, fmt::format("{} {} {:.0f} km from {}", namesOf(model, *group),
                                                   group->sources.size() == 1 ? "is" : "are",
                                                   gap(boxes, *group, *main) / 1000, namesOf(model, *main))));
  }
  return diagnostics;
}

}  // namespace lodestone
