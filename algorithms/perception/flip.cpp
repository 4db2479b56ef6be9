#include "algorithms/perception/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "algorithms/geometry/parallel.h"
#include "algorithms/geometry/vector_clones.h"
#include "algorithms/perception/flip_colours.h"
#include "algorithms/perception/flip_filters.h"
#include "algorithms/perception/vector_math.h"

namespace lodestone {
namespace {

constexpr std::size_t kPixelsAPiece = 1 << 15;

/// A picture as it is filtered: three planes of floats.
struct OpponentImage {
  std::size_t width;
  std::size_t height;
  std::vector<float> y;
  std::vector<float> cx;
  std::vector<float> cz;
};

std::size_t rowsAPiece(std::size_t width) {
  return std::max<std::size_t>(1, kPixelsAPiece / width);
}

OpponentImage opponentImage(const Picture& picture, const Progress& progress) {
  const auto width = static_cast<std::size_t>(picture.width);
  const auto height = static_cast<std::size_t>(picture.height);
  const std::size_t pixels = width * height;
  OpponentImage image{width, height, std::vector<float>(pixels), std::vector<float>(pixels),
                      std::vector<float>(pixels)};
  forPieces(0, height, rowsAPiece(width), progress, [&](std::size_t first, std::size_t last) {
    const std::size_t at = first * width;
    toOpponent(&picture.rgba[4 * at], (last - first) * width, {&image.y[at], &image.cx[at], &image.cz[at]});
  });
  return image;
}

/// Edges and points of one row: the two components of each.
struct FeatureRow {
  std::vector<float> edgeX;
  std::vector<float> edgeY;
  std::vector<float> pointX;
  std::vector<float> pointY;
};

struct FilteredRow {
  std::vector<float> y;
  std::vector<float> cx;
  std::vector<float> cz;
  FeatureRow features;

  explicit FilteredRow(std::size_t width) : y(width), cx(width), cz(width) {
    for (auto* row : {&features.edgeX, &features.edgeY, &features.pointX, &features.pointY})
      row->resize(width);
  }
  [[nodiscard]] OpponentRow colours() { return {y.data(), cx.data(), cz.data()}; }
};

/// Filters of both directions.
struct Filters {
  FlipFilters along;  ///< of rows
  FlipFilters down;   ///< of columns
};

/// Makes the filtered rows of an image one by one: down the columns into one row, then along it. So nothing
/// but a few rows is kept between the two, whatever the picture's size.
class RowFilter {
 public:
  RowFilter(const OpponentImage& image, const Filters& filters)
      : image_(image),
        filters_(filters),
        reachDown_(filters.down.reach()),
        reachAlong_(filters.along.reach()),
        rows_(2 * reachDown_ + 1),
        shifts_(2 * reachAlong_ + 1),
        padded_(image.width + 2 * reachAlong_) {
    for (std::size_t k = 0; k < shifts_.size(); ++k) shifts_[k] = padded_.data() + k;
  }

  void make(std::size_t row, FilteredRow& out) {
    const FlipFilters& along = filters_.along;
    const FlipFilters& down = filters_.down;
    choose(image_.y, row);
    filter(down.lightness, along.lightness, out.y);
    filter(down.gaussian, along.edge, out.features.edgeX);
    applyFilter(along.point, middleOfShifts(), image_.width, out.features.pointX.data());
    filter(down.edge, along.gaussian, out.features.edgeY);
    filter(down.point, along.gaussian, out.features.pointY);
    choose(image_.cx, row);
    filter(down.redGreen, along.redGreen, out.cx);
    choose(image_.cz, row);
    filter(down.blueYellow[0], along.blueYellow[0], out.cz);
    filterDown(down.blueYellow[1]);
    addFilter(along.blueYellow[1], middleOfShifts(), image_.width, out.cz.data());
  }

 private:
  [[nodiscard]] TapRows middleOfShifts() const { return shifts_.data() + reachAlong_; }

  /// The rows of a plane around `row`, those beyond its ends being the ends.
  void choose(const std::vector<float>& plane, std::size_t row) {
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const std::size_t source = std::clamp(row + k, reachDown_, reachDown_ + image_.height - 1) - reachDown_;
      rows_[k] = plane.data() + source * image_.width;
    }
  }

  void filterDown(const HalfFilter& down) {
    float* middle = padded_.data() + reachAlong_;
    applyFilter(down, rows_.data() + reachDown_, image_.width, middle);
    std::fill_n(padded_.data(), reachAlong_, middle[0]);
    std::fill_n(middle + image_.width, reachAlong_, middle[image_.width - 1]);
  }

  void filter(const HalfFilter& down, const HalfFilter& along, std::vector<float>& out) {
    filterDown(down);
    applyFilter(along, middleOfShifts(), image_.width, out.data());
  }

  const OpponentImage& image_;
  const Filters& filters_;
  std::size_t reachDown_;
  std::size_t reachAlong_;
  std::vector<const float*> rows_;
  std::vector<const float*> shifts_;  ///< of the padded row, pixel by pixel
  std::vector<float> padded_;
};

/// How much the features at a pixel differ (ΔE_f, equation 7).
inline float featureDifference(float edgeA, float edgeB, float pointA, float pointB) {
  constexpr float kRootHalf = 0.70710678F;
  return std::sqrt(kRootHalf * std::max(std::abs(edgeA - edgeB), std::abs(pointA - pointB)));
}

LODESTONE_VECTOR_CLONES
void lengths(const float* x, const float* y, std::size_t count, float* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = std::sqrt(x[i] * x[i] + y[i] * y[i]);
}

/// Turns colour differences into ꟻLIP's errors ΔE_c^(1 − ΔE_f) (equation 8).
LODESTONE_VECTOR_CLONES
void amplify(const float* edgeA, const float* edgeB, const float* pointA, const float* pointB,
             std::size_t count, float* errors) {
  for (std::size_t i = 0; i < count; ++i) {
    const float feature = featureDifference(edgeA[i], edgeB[i], pointA[i], pointB[i]);
    errors[i] = raised(errors[i], 1 - std::min(feature, 1.0F));
  }
}

void errorsOf(FilteredRow& reference, FilteredRow& test, std::size_t width, float* out) {
  for (FeatureRow* row : {&reference.features, &test.features}) {
    lengths(row->edgeX.data(), row->edgeY.data(), width, row->edgeX.data());
    lengths(row->pointX.data(), row->pointY.data(), width, row->pointX.data());
  }
  colourDifferences(reference.colours(), test.colours(), width, out);
  amplify(reference.features.edgeX.data(), test.features.edgeX.data(), reference.features.pointX.data(),
          test.features.pointX.data(), width, out);
}

}  // namespace

FlipMap flip(const Picture& reference, const Picture& test, double pixelsPerDegree,
             const Progress& progress) {
  FlipMap map{reference.width, reference.height, std::vector<float>(reference.rgba.size() / 4), 0};
  if (map.errors.empty()) return map;
  const OpponentImage a = opponentImage(reference, progress);
  const OpponentImage b = opponentImage(test, progress);
  progress.checkpoint();
  const Filters filters{flipFilters(pixelsPerDegree, a.width), flipFilters(pixelsPerDegree, a.height)};
  std::vector<double> sums(a.height);
  forPiecesReported(a.height, rowsAPiece(a.width), progress, [&](std::size_t first, std::size_t last) {
    RowFilter filterA(a, filters);
    RowFilter filterB(b, filters);
    FilteredRow rowA(a.width);
    FilteredRow rowB(a.width);
    for (std::size_t row = first; row < last; ++row) {
      filterA.make(row, rowA);
      filterB.make(row, rowB);
      float* errors = &map.errors[row * a.width];
      errorsOf(rowA, rowB, a.width, errors);
      sums[row] = std::accumulate(errors, errors + a.width, 0.0);
    }
  });
  progress.checkpoint();
  map.mean = std::accumulate(sums.begin(), sums.end(), 0.0) / static_cast<double>(map.errors.size());
  return map;
}

}  // namespace lodestone
