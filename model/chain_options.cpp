#include "model/chain_options.h"

namespace lodestone {
namespace {

/// A row of the table of a part: one range and one help for one thing.
Field<ChainOptions> ofCut(const Field<CutOptions>& row) {
  return {static_cast<const FieldInfo&>(row), [get = row.get](const ChainOptions& o) { return get(o.cut); },
          [set = row.set](ChainOptions& o, const FieldValue& v) { set(o.cut, v); }};
}

}  // namespace

template <>
const std::vector<Field<ChainOptions>>& fields<ChainOptions>() {
  using O = ChainOptions;
  static const std::vector<Field<O>> table = [] {
    std::vector<Field<O>> rows{
        text(&O::tolerances, "tolerances", "Tolerances",
             "Metres, rising, separated by commas: each adds a level whose clusters have at most the square "
             "of it as negative space (Chang et al. 2008, section 7)."),
    };
    for (const Field<CutOptions>& row : fields<CutOptions>()) rows.push_back(ofCut(row));
    rows.push_back(real(&O::fov, "fov", "Field of view", "°", 1, 170,
                        "Vertical; with the picture's height it sets the distances."));
    rows.push_back(integer(&O::pictureHeight, "picture-height", "Picture height", "px", 1, 100000,
                           "Of the picture for which the distances hold."));
    return rows;
  }();
  return table;
}

}  // namespace lodestone
