// The images of a city, decoded once for all who look at parts of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

#include "algorithms/rendering/model_look.h"

namespace lodestone {

/// Hundreds of buildings share an atlas: to decode it takes as long as to look at a small one of them. What
/// was used longest ago goes first when all takes more than the budget. Safe to call from several threads.
class TextureCache {
 public:
  /// `city` must outlive this.
  explicit TextureCache(const CityModel& city, std::size_t budget = std::size_t{512} << 20U);

  [[nodiscard]] const CityModel& city() const { return city_; }
  /// The image of a texture; null where it is not to be had, of which (Code::TextureBad) whoever asks first
  /// is told. \pre texture < city().textures.size()
  [[nodiscard]] std::shared_ptr<const TexturePyramid> get(std::size_t texture, Diagnostics* diagnostics);

 private:
  struct Entry {
    std::mutex decoding;
    bool isBad = false;
    std::shared_ptr<const TexturePyramid> image;  ///< guarded by `mutex_`, as what follows
    std::uint64_t lastUse = 0;
  };
  [[nodiscard]] std::shared_ptr<const TexturePyramid> known(Entry& entry);
  void keep(Entry& entry, const std::shared_ptr<const TexturePyramid>& image);

  const CityModel& city_;
  std::size_t budget_;
  std::mutex mutex_;
  std::deque<Entry> entries_;  ///< by texture
  std::size_t bytes_ = 0;      ///< of all images that are kept
  std::uint64_t uses_ = 0;
};

/// readModelLook() by images that others may have decoded.
[[nodiscard]] std::shared_ptr<const ModelLook> readModelLook(TextureCache& cache, const ComponentMesh& mesh,
                                                             Diagnostics* diagnostics = nullptr,
                                                             const Progress& progress = {});

}  // namespace lodestone
