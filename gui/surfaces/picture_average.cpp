#include "gui/surfaces/picture_average.h"

namespace lodestone {
namespace {

double halton(int index, int base) {
  double result = 0;
  for (double part = 1.0 / base; index > 0; index /= base, part /= base) result += part * (index % base);
  return result;
}

}  // namespace

std::array<double, 2> PictureAverage::shift(int i) {
  return {halton(i + 1, 2) - 0.5, halton(i + 1, 3) - 0.5};
}

void PictureAverage::add(const QImage& picture) {
  const auto bytes =
      static_cast<std::size_t>(picture.width()) * static_cast<std::size_t>(picture.height()) * 4;
  if (count_ == 0 || picture.size() != first_.size()) {
    first_ = picture;
    sums_.assign(bytes, 0);
    count_ = 0;
  }
  // RGB32 has no padding between rows.
  const uchar* from = picture.constBits();
  for (std::size_t i = 0; i < bytes; ++i) sums_[i] = static_cast<std::uint16_t>(sums_[i] + from[i]);
  ++count_;
}

QImage PictureAverage::mean() const {
  if (count_ == 0) return {};
  QImage result(first_.size(), QImage::Format_RGB32);
  uchar* to = result.bits();
  for (std::size_t i = 0; i < sums_.size(); ++i) to[i] = static_cast<uchar>((sums_[i] + count_ / 2) / count_);
  result.setDevicePixelRatio(first_.devicePixelRatio());
  return result;
}

}  // namespace lodestone
