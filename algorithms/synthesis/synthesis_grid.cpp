#include "algorithms/synthesis/synthesis_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "algorithms/synthesis/synthesis_random.h"

namespace lodestone {
namespace {

struct Kind {
  const char* use;
  double width, depth;
  int storeys;
  double storey;   ///< height, metres
  double roof;     ///< height of its gable, metres; 0: flat, with a parapet
  int bays;        ///< boxes that stand out at the front
  double spacing;  ///< from window to window, metres
};

constexpr std::array<Kind, 4> kKinds{{{"house", 12, 9, 2, 3, 4, 1, 2.5},
                                      {"terrace", 32, 11, 3, 3, 5, 4, 2.5},
                                      {"office", 24, 18, 9, 3.5, 0, 2, 2.0},
                                      {"hall", 36, 24, 1, 8, 3, 2, 4.0}}};
constexpr std::array<const char*, 4> kLods{"1.2", "2.2", "3.0", "3.3"};

/// A wall of a block: from its lower left corner, seen from outside.
struct Facade {
  Vec3 corner, along, outward;
  double length = 0;
};

/// One level of one building, about the middle of its ground.
class GridBuilding {
 public:
  GridBuilding(const Kind& kind, const Vec3& at) : kind_(kind), at_(at) {}

  Geometry level(std::size_t detail) {
    geometry_ = {};
    geometry_.lod = kLods[detail];
    const double w = kind_.width / 2;
    const double d = kind_.depth / 2;
    const double eaves = kind_.storeys * kind_.storey;
    if (detail == 0) {
      addBox({-w, -d, 0}, {w, d, eaves + kind_.roof / 2}, SurfaceType::Wall, true);
      return std::move(geometry_);
    }
    addBody(w, d, eaves);
    addBays(w, d, eaves);
    if (detail >= 2) addOpenings(w, d, detail == 3);
    return std::move(geometry_);
  }

 private:
  void add(SurfaceType type, std::vector<Vec3> ring) {
    for (Vec3& p : ring) p += at_;
    geometry_.addRing(ring);
    geometry_.finishSurface({type, -1, -1});
  }

  /// Its sides, its top as a roof where it is a building's, and the ground.
  void addBox(const Vec3& low, const Vec3& high, SurfaceType sides, bool isBody) {
    const auto p = [&](int x, int y, int z) {
      return Vec3(x ? high.x() : low.x(), y ? high.y() : low.y(), z ? high.z() : low.z());
    };
    add(sides, {p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1)});
    add(sides, {p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1)});
    add(sides, {p(1, 1, 0), p(0, 1, 0), p(0, 1, 1), p(1, 1, 1)});
    add(sides, {p(0, 1, 0), p(0, 0, 0), p(0, 0, 1), p(0, 1, 1)});
    add(isBody ? SurfaceType::Roof : sides, {p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1)});
    add(isBody ? SurfaceType::Ground : sides, {p(0, 1, 0), p(1, 1, 0), p(1, 0, 0), p(0, 0, 0)});
  }

  void addBody(double w, double d, double eaves) {
    if (kind_.roof == 0) {
      addBox({-w, -d, 0}, {w, d, eaves}, SurfaceType::Wall, true);
      addBox({-w, -d, eaves}, {w, -d + 0.3, eaves + 1}, SurfaceType::Wall, false);
      addBox({-w, d - 0.3, eaves}, {w, d, eaves + 1}, SurfaceType::Wall, false);
      return;
    }
    using enum SurfaceType;
    const double ridge = eaves + kind_.roof;
    add(Ground, {{-w, d, 0}, {w, d, 0}, {w, -d, 0}, {-w, -d, 0}});
    add(Wall, {{-w, -d, 0}, {w, -d, 0}, {w, -d, eaves}, {-w, -d, eaves}});
    add(Wall, {{w, d, 0}, {-w, d, 0}, {-w, d, eaves}, {w, d, eaves}});
    add(Wall, {{w, -d, 0}, {w, d, 0}, {w, d, eaves}, {w, 0, ridge}, {w, -d, eaves}});
    add(Wall, {{-w, d, 0}, {-w, -d, 0}, {-w, -d, eaves}, {-w, 0, ridge}, {-w, d, eaves}});
    add(Roof, {{-w, -d, eaves}, {w, -d, eaves}, {w, 0, ridge}, {-w, 0, ridge}});
    add(Roof, {{w, d, eaves}, {-w, d, eaves}, {-w, 0, ridge}, {w, 0, ridge}});
  }

  void addBays(double w, double d, double eaves) {
    for (int i = 0; i < kind_.bays; ++i) {
      const double x = -w + (i + 0.5) * 2 * w / kind_.bays;
      addBox({x - 1.5, -d - 1, 0}, {x + 1.5, -d, std::min(eaves, 2 * kind_.storey)}, SurfaceType::Wall, true);
    }
  }

  void addOpenings(double w, double d, bool fine) {
    const std::array<Facade, 4> facades{{{{-w, -d, 0}, Vec3::UnitX(), -Vec3::UnitY(), 2 * w},
                                         {{w, -d, 0}, Vec3::UnitY(), Vec3::UnitX(), 2 * d},
                                         {{w, d, 0}, -Vec3::UnitX(), Vec3::UnitY(), 2 * w},
                                         {{-w, d, 0}, -Vec3::UnitY(), -Vec3::UnitX(), 2 * d}}};
    for (const Facade& facade : facades) {
      const int windows = static_cast<int>(facade.length / kind_.spacing);
      for (int row = 0; row < kind_.storeys; ++row) {
        for (int i = 0; i < windows; ++i)
          addWindow(facade, (i + 0.5) * facade.length / windows, (row + 0.35) * kind_.storey, fine);
      }
    }
  }

  /// On the wall, since a hole in it would make its polygons hard for no use.
  void addWindow(const Facade& facade, double along, double height, bool fine) {
    const double width = 0.45 * kind_.spacing;
    const double tall = 0.45 * kind_.storey;
    const auto box = [&](double from, double to, double low, double high, double out, SurfaceType type) {
      const Vec3 a = facade.corner + from * facade.along + low * Vec3::UnitZ();
      const Vec3 b = facade.corner + to * facade.along + high * Vec3::UnitZ() + out * facade.outward;
      addBox(a.cwiseMin(b), a.cwiseMax(b), type, false);
    };
    const double left = along - width / 2;
    const double right = along + width / 2;
    box(left, right, height, height + tall, 0.05, SurfaceType::Window);
    if (!fine) return;
    constexpr double kBar = 0.06;
    for (const double x : {left, along - kBar / 2, right - kBar})
      box(x, x + kBar, height, height + tall, 0.1, SurfaceType::Wall);
    for (const double z : {height, height + tall / 2, height + tall - kBar})
      box(left, right, z, z + kBar, 0.1, SurfaceType::Wall);
    box(left - 0.1, right + 0.1, height - 0.08, height, 0.25, SurfaceType::Wall);
  }

  Kind kind_;
  Vec3 at_;
  Geometry geometry_;
};

Building gridBuilding(int number, const Kind& kind, const Vec2& middle) {
  Building building;
  building.object.id = "plot-" + std::to_string(number + 1);
  building.object.type = ObjectType::Building;
  GridBuilding maker(kind, {middle.x(), middle.y(), 0});
  for (std::size_t detail = 0; detail < kLods.size(); ++detail)
    building.object.geometries.push_back(maker.level(detail));
  const double w = kind.width / 2;
  const double d = kind.depth / 2;
  building.footprint = {
      {{middle + Vec2(-w, -d), middle + Vec2(w, -d), middle + Vec2(w, d), middle + Vec2(-w, d)}, {}}};
  building.height = kind.storeys * kind.storey + (kind.roof > 0 ? kind.roof : 1);
  building.heightSource = HeightSource::Geometry;
  building.object.attributes.set("use", std::string(kind.use));
  building.object.attributes.set("height", building.height);
  return building;
}

}  // namespace

void addGridCity(CityModel& model, int buildings, int seed) {
  const int side = static_cast<int>(std::ceil(std::sqrt(buildings)));
  std::vector<std::size_t> kinds;
  for (int i = 0; i < buildings; ++i) kinds.push_back(static_cast<std::size_t>(i) % kKinds.size());
  SynthRandom random(static_cast<std::uint64_t>(seed));
  for (int i = buildings - 1; i > 0; --i)
    std::swap(kinds[static_cast<std::size_t>(i)], kinds[static_cast<std::size_t>(random.between(0, i))]);
  for (int i = 0; i < buildings; ++i) {
    const Vec2 middle =
        kGridPlot * Vec2(i % side - (side - 1) / 2.0, std::floor(i / side) - (side - 1) / 2.0);
    model.buildings.push_back(gridBuilding(i, kKinds[kinds[static_cast<std::size_t>(i)]], middle));
  }
}

}  // namespace lodestone
