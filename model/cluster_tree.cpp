#include "model/cluster_tree.h"

namespace lodestone {

const char* toString(DrawRole role) {
  switch (role) {
    case DrawRole::Cluster:
      return "cluster";
    case DrawRole::Building:
      return "building";
    case DrawRole::Landmark:
      return "landmark";
  }
  return "";
}

}  // namespace lodestone
