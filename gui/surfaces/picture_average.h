// The mean of several pictures of the same size: smooth edges out of frames shifted by parts of a pixel.
#pragma once

#include <QImage>
#include <array>
#include <cstdint>
#include <vector>

namespace lodestone {

class PictureAverage {
 public:
  /// Begins anew.
  void clear() { count_ = 0; }
  /// Adds a picture; one of another size begins anew. \pre Format_RGB32; at most 256 pictures.
  void add(const QImage& picture);
  [[nodiscard]] int count() const { return count_; }
  [[nodiscard]] QImage mean() const;

  /// Shift of the i-th picture, parts of a pixel in ±0.5: Halton's sequence in bases 2 and 3, evenly spread
  /// however many are taken.
  [[nodiscard]] static std::array<double, 2> shift(int i);

 private:
  QImage first_;  // size and pixel ratio
  std::vector<std::uint16_t> sums_;
  int count_ = 0;
};

}  // namespace lodestone
