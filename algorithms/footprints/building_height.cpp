#include "algorithms/footprints/building_height.h"

namespace lodestone {

void assignHeightFromAttributes(Building& building, const HeightRule& rule, Diagnostics& diagnostics) {
  const HeightRule::Found found = rule.find(building.object.attributes);
  building.height = found.height;
  building.heightSource = found.source;
  const auto say = [&](Code code, const std::string& detail = {}) {
    diagnostics.push_back(diagnose(code, detail, building.object.id));
  };
  if (!found.notUnderstood.empty()) {
    say(Code::HeightNotUnderstood, found.notUnderstood);
  } else if (found.source == HeightSource::Default) {
    say(found.notPositive ? Code::HeightNotPositive : Code::HeightMissing);
  }
}

}  // namespace lodestone
