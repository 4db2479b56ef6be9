#include "model/io/cityjson/cityjson_writer.h"

#include <algorithm>
#include <numeric>
#include <system_error>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "model/io/cityjson/cityjson_stream.h"
#include "model/io/json_writing.h"
#include "model/io/output_failure.h"

namespace lodestone {
namespace {

/// Objects made at a time, in parallel; what bounds the memory.
constexpr std::size_t kBatch = 512;

class ChainWriter {
 public:
  ChainWriter(const LodChain& chain, const WriteOptions& options, CityJsonStream& stream,
              const Progress& progress)
      : chain_(chain), city_(*chain.city), stream_(stream), progress_(progress), levels_(options.levels) {
    if (levels_.empty()) {
      levels_.resize(chain.levels.size());
      std::iota(levels_.begin(), levels_.end(), std::size_t{0});
    }
    for (const std::size_t k : levels_) {
      const LodLevel& level = chain.levels.at(k);
      total_ += level.objectCount;
      if (level.isCity) original_ = &level;
    }
    total_ += city_.buildings.size();
  }

  void write() {
    stream_.begin(description());
    drawnBy_.assign(city_.buildings.size(), {});
    landmarkIn_.assign(city_.buildings.size(), {});
    for (const std::size_t k : levels_) {
      if (&chain_.levels[k] != original_) writeClusters(k);
    }
    writeBuildings();
    if (original_) {
      for (const CityObject& object : city_.others) stream_.add({&object, nullptr, nullptr});
    }
  }

 private:
  struct DrawnBy {
    const LodLevel* level = nullptr;
    std::size_t object = 0;
  };

  /// Levels and recipe: metadata.lodestone.
  [[nodiscard]] std::string description() const {
    std::string levels;
    for (const std::size_t k : levels_) {
      const LodLevel& level = chain_.levels[k];
      levels += fmt::format(R"({}{{"level":{},"name":{},"method":{},"error":{},"switchDistance":{}}})",
                            levels.empty() ? "" : ",", k, jsonQuoted(level.name), jsonQuoted(level.method),
                            jsonNumber(level.error), jsonNumber(level.switchDistance));
    }
    std::string recipe = chain_.recipe;  // a sequence's header is one line
    std::erase_if(recipe, [](char c) { return c == '\n' || c == '\r'; });
    return fmt::format(R"({{"levels":[{}]{}{}}})", levels, recipe.empty() ? "" : ",\"recipe\":", recipe);
  }

  /// Calls `use(i, object)` in order for objects that `make(i)` makes in parallel.
  template <class Make, class Use>
  void inBatches(std::size_t count, Make&& make, Use&& use) {
    std::vector<LevelObject> batch(std::min(kBatch, count));
    for (std::size_t begin = 0; begin < count; begin += kBatch) {
      const std::size_t size = std::min(kBatch, count - begin);
      tbb::parallel_for(std::size_t{0}, size, [&](std::size_t i) {
        if (!progress_.stopRequested()) batch[i] = make(begin + i);
      });
      progress_.checkpoint();
      for (std::size_t i = 0; i < size; ++i) use(begin + i, batch[i]);
      done_ += size;
      progress_.report(static_cast<double>(done_) / static_cast<double>(total_));
    }
  }

  void writeClusters(std::size_t k) {
    const LodLevel& level = chain_.levels[k];
    inBatches(level.objectCount, level.object, [&](std::size_t i, const LevelObject& object) {
      if (object.role == DrawRole::Cluster) {
        writeGroup(k, object);
        return;
      }
      for (const std::uint32_t building : object.buildings) {
        if (!drawnBy_[building].level) drawnBy_[building] = {&level, i};
        if (object.role == DrawRole::Landmark) {
          std::string& list = landmarkIn_[building];
          list += (list.empty() ? "" : ",") + jsonQuoted(groupId(k, object.of));
        }
      }
    });
  }

  static std::string groupId(std::size_t k, NodeId node) { return fmt::format("L{}-cluster-{}", k, node); }

  void writeGroup(std::size_t k, const LevelObject& object) {
    CityObject group;
    group.id = groupId(k, object.node);
    group.type = ObjectType::ObjectGroup;
    std::string children;
    for (const std::uint32_t building : object.buildings) {
      children += (children.empty() ? "[" : ",") + jsonQuoted(city_.buildings[building].object.id);
    }
    group.attributes.set("children", JsonText{children + "]"});
    group.attributes.set("lodestone:level", static_cast<std::int64_t>(k));
    group.attributes.set("lodestone:node", static_cast<std::int64_t>(object.node));
    group.attributes.set("lodestone:negative", object.negative);
    group.attributes.set("lodestone:base", object.base);
    group.attributes.set("lodestone:height", object.height);
    stream_.add({&group, &object.geometries, nullptr});
  }

  /// Each building once: whole where the city itself is asked for, else as the levels draw it, so that the
  /// groups' children are always there.
  void writeBuildings() {
    const auto ownGeometry = [&](std::size_t b) {
      bool any = false;
      forEachObject(city_.buildings[b].object,
                    [&](const CityObject& o) { any = any || !o.geometries.empty(); });
      return original_ && any;
    };
    const auto make = [&](std::size_t b) {
      if (ownGeometry(b)) return LevelObject{};
      if (original_) return original_->object(b);
      return drawnBy_[b].level ? drawnBy_[b].level->object(drawnBy_[b].object) : LevelObject{};
    };
    inBatches(city_.buildings.size(), make, [&](std::size_t b, const LevelObject& drawn) {
      Attributes more;
      if (!landmarkIn_[b].empty()) more.set("lodestone:landmarkIn", JsonText{"[" + landmarkIn_[b] + "]"});
      writeBuilding(city_.buildings[b].object, ownGeometry(b) ? nullptr : &drawn.geometries, more);
    });
  }

  void writeBuilding(const CityObject& object, const std::vector<Geometry>* geometries,
                     const Attributes& more) {
    if (original_ || object.children.empty()) {
      stream_.add({&object, geometries, &more});
      return;
    }
    CityObject alone;  // its parts have their say in the level's geometry, or in none
    alone.id = object.id;
    alone.type = object.type;
    alone.attributes = object.attributes;
    stream_.add({&alone, geometries, &more});
  }

  const LodChain& chain_;
  const CityModel& city_;
  CityJsonStream& stream_;
  const Progress& progress_;
  std::vector<std::size_t> levels_;
  const LodLevel* original_ = nullptr;   ///< the level that is the city itself
  std::vector<DrawnBy> drawnBy_;         ///< by building: the first level that draws it by itself
  std::vector<std::string> landmarkIn_;  ///< by building: groups beside which it stands, as JSON
  std::size_t done_ = 0;
  std::size_t total_ = 0;
};

Result<WriteReport> write(const LodChain& chain, const std::filesystem::path& path,
                          const WriteOptions& options, const Progress& progress, CityJsonLayout layout) {
  Result<WriteReport> result;
  const bool known = std::all_of(options.levels.begin(), options.levels.end(),
                                 [&](std::size_t k) { return k < chain.levels.size(); });
  if (!known) return diagnose(Code::OptionBadValue, "the chain has no such level");
  try {
    CityJsonStream stream(*chain.city, path, layout);
    ChainWriter(chain, options, stream, progress).write();
    result.value = WriteReport{stream.finish()};
    for (const std::string& loss : stream.losses())
      result.diagnostics.push_back(diagnose(Code::OutputLossy, loss));
  } catch (const std::system_error& error) {
    return outputFailure(error, path);
  }
  return result;
}

}  // namespace

Result<WriteReport> writeCityJson(const LodChain& chain, const std::filesystem::path& path,
                                  const WriteOptions& options, const Progress& progress) {
  return write(chain, path, options, progress, CityJsonLayout::Document);
}

Result<WriteReport> writeCityJsonSeq(const LodChain& chain, const std::filesystem::path& path,
                                     const WriteOptions& options, const Progress& progress) {
  return write(chain, path, options, progress, CityJsonLayout::Sequence);
}

}  // namespace lodestone
