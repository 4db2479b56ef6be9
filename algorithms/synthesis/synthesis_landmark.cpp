#include "algorithms/synthesis/synthesis_landmark.h"

#include <map>

namespace lodestone {
namespace {

// Collects surfaces over shared vertices, so that the solid is closed by index and not by luck.
class SolidBuilder {
 public:
  explicit SolidBuilder(const Vec3& at) : at_(at) { geometry_.kind = GeometryKind::Solid; }

  void add(SurfaceType type, const std::vector<Vec3>& ring) {
    for (const Vec3& p : ring) geometry_.ringVertices.push_back(indexOf(p + at_));
    geometry_.ringStart.push_back(static_cast<std::uint32_t>(geometry_.ringVertices.size()));
    geometry_.finishSurface({type, -1, -1});
  }
  Geometry finish(std::string lod) {
    geometry_.lod = std::move(lod);
    geometry_.shellStart = {0, static_cast<std::uint32_t>(geometry_.surfaceCount())};
    geometry_.solidStart = {0, 1};
    return std::move(geometry_);
  }

 private:
  std::uint32_t indexOf(const Vec3& p) {
    const auto [it, isNew] =
        known_.try_emplace({p.x(), p.y(), p.z()}, static_cast<std::uint32_t>(geometry_.vertices.size()));
    if (isNew) geometry_.vertices.push_back(p);
    return it->second;
  }

  Vec3 at_;
  Geometry geometry_;
  std::map<std::array<double, 3>, std::uint32_t> known_;
};

// Walls and roofs of the nave; `joint` is where the tower's corners meet the gable.
void addNave(SolidBuilder& solid, const ChurchSize& s, double joint) {
  const double l = s.naveLength;
  const double w = s.naveWidth / 2;
  const double t = s.towerSide / 2;
  using enum SurfaceType;
  solid.add(Wall, {{0, -w, 0}, {l, -w, 0}, {l, -w, s.eaves}, {0, -w, s.eaves}});
  solid.add(Wall, {{l, w, 0}, {0, w, 0}, {0, w, s.eaves}, {l, w, s.eaves}});
  solid.add(Wall, {{l, -w, 0}, {l, w, 0}, {l, w, s.eaves}, {l, 0, s.ridge}, {l, -w, s.eaves}});
  solid.add(Wall, {{0, w, 0}, {0, t, 0}, {0, t, joint}, {0, w, s.eaves}});
  solid.add(Wall, {{0, -t, 0}, {0, -w, 0}, {0, -w, s.eaves}, {0, -t, joint}});
  solid.add(Roof, {{0, -w, s.eaves}, {l, -w, s.eaves}, {l, 0, s.ridge}, {0, 0, s.ridge}, {0, -t, joint}});
  solid.add(Roof, {{l, w, s.eaves}, {0, w, s.eaves}, {0, t, joint}, {0, 0, s.ridge}, {l, 0, s.ridge}});
}

void addTower(SolidBuilder& solid, const ChurchSize& s, double joint) {
  const double t = s.towerSide / 2;
  const double f = -s.towerSide;
  const double h = s.towerTop;
  const Vec3 tip(f / 2, 0, s.spireTop);
  using enum SurfaceType;
  solid.add(Wall, {{f, t, 0}, {f, -t, 0}, {f, -t, h}, {f, t, h}});
  solid.add(Wall, {{f, -t, 0}, {0, -t, 0}, {0, -t, joint}, {0, -t, h}, {f, -t, h}});
  solid.add(Wall, {{0, t, 0}, {f, t, 0}, {f, t, h}, {0, t, h}, {0, t, joint}});
  solid.add(Wall, {{0, -t, joint}, {0, 0, s.ridge}, {0, t, joint}, {0, t, h}, {0, -t, h}});
  solid.add(Roof, {{f, -t, h}, {0, -t, h}, tip});
  solid.add(Roof, {{0, -t, h}, {0, t, h}, tip});
  solid.add(Roof, {{0, t, h}, {f, t, h}, tip});
  solid.add(Roof, {{f, t, h}, {f, -t, h}, tip});
}

}  // namespace

Geometry makeChurch(const ChurchSize& s, const Vec3& at) {
  const double w = s.naveWidth / 2;
  const double t = s.towerSide / 2;
  const double l = s.naveLength;
  const double f = -s.towerSide;
  const double joint = s.eaves + (s.ridge - s.eaves) * (1 - t / w);
  SolidBuilder solid(at);
  solid.add(SurfaceType::Ground,
            {{f, t, 0}, {0, t, 0}, {0, w, 0}, {l, w, 0}, {l, -w, 0}, {0, -w, 0}, {0, -t, 0}, {f, -t, 0}});
  addNave(solid, s, joint);
  addTower(solid, s, joint);
  return solid.finish("2.2");
}

}  // namespace lodestone
