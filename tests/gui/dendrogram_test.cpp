// The dendrogram's pixels against a drawing that leaves nothing out, and what the widget does with mouse and
// keys.
#include <QTest>
#include <random>

#include "gui/city/dendrogram_raster.h"

namespace lodestone {
namespace {

/// Merges that take two random clusters, weights never falling.
std::shared_ptr<const Dendrogram> randomDendrogram(std::uint32_t leaves, unsigned seed) {
  auto dendrogram = std::make_shared<Dendrogram>();
  dendrogram->leafCount = leaves;
  std::mt19937 random(seed);
  std::vector<NodeId> roots(leaves);
  for (NodeId i = 0; i < leaves; ++i) roots[i] = i;
  double weight = 0;
  while (roots.size() > 1) {
    const std::size_t i = random() % roots.size();
    std::swap(roots[i], roots.back());
    const NodeId a = roots.back();
    roots.pop_back();
    const std::size_t j = random() % roots.size();
    weight = weight * 1.0001 + (random() % 3 == 0 ? 0 : static_cast<double>(random() % 100) / 100);
    dendrogram->merges.push_back({std::min(a, roots[j]), std::max(a, roots[j]), 1, weight, 0, 2});
    roots[j] = dendrogram->nodeCount() - 1;
  }
  return dendrogram;
}

/// Every pixel that a bar or a stem goes through, one by one.
std::vector<std::uint32_t> drawSlowly(const DendrogramLayout& layout, const DendrogramWindow& window) {
  std::vector<std::uint32_t> counts(static_cast<std::size_t>(window.width * window.height), 0);
  const auto mark = [&](int column, int row) {
    if (column < 0 || column >= window.width || row < 0 || row >= window.height) return;
    ++counts[static_cast<std::size_t>(row * window.width + column)];
  };
  for (NodeId node = layout.dendrogram->leafCount; node < layout.dendrogram->nodeCount(); ++node) {
    const Merge& merge = layout.dendrogram->merge(node);
    const int row = static_cast<int>(std::floor(window.row(layout.height[node])));
    const auto column = [&](NodeId child) {
      return static_cast<int>(std::floor(window.column(layout.x[child])));
    };
    for (int c = column(merge.a); c <= column(merge.b); ++c) mark(c, row);
    for (const NodeId child : {merge.a, merge.b}) {
      const int to = static_cast<int>(std::floor(window.row(layout.height[child])));
      for (int r = row; r <= to; ++r) mark(column(child), r);
    }
  }
  return counts;
}

DendrogramWindow windowOn(const DendrogramLayout& layout, double left, double right, int width, int height) {
  return {left, right, kLeafHeight, layout.top * 1.05, width, height};
}

}  // namespace

class DendrogramTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void equalsTheSlowDrawingWhereLeavesAreWide() {
    for (unsigned seed = 0; seed < 20; ++seed) {
      const DendrogramLayout layout = makeLayout(randomDendrogram(2 + seed * 13, seed));
      const double leaves = layout.dendrogram->leafCount;
      const double left = seed % 2 == 0 ? 0 : leaves * 0.3;
      const double right = seed % 2 == 0 ? leaves : leaves * 0.7;
      const DendrogramWindow window = windowOn(layout, left, right, 3 * static_cast<int>(leaves) + 50, 90);
      DendrogramRaster raster;
      raster.draw(layout, window, {});
      const std::vector<std::uint32_t> slow = drawSlowly(layout, window);
      for (int row = 0; row < window.height; ++row) {
        for (int column = 0; column < window.width; ++column) {
          QCOMPARE(raster.above(column, row), slow[static_cast<std::size_t>(row * window.width + column)]);
        }
      }
    }
  }

  /// Narrow subtrees become spans: every column keeps its skyline to within a column, and none is empty.
  void keepsTheSkylineWhereLeavesAreNarrow() {
    const DendrogramLayout layout = makeLayout(randomDendrogram(20000, 7));
    const DendrogramWindow window = windowOn(layout, 0, 20000, 300, 120);
    DendrogramRaster raster;
    raster.draw(layout, window, {});
    const std::vector<std::uint32_t> slow = drawSlowly(layout, window);
    const auto skyline = [&](auto&& isSet, int column) {
      for (int row = 0; row < window.height; ++row) {
        if (isSet(column, row)) return row;
      }
      return window.height;
    };
    const auto fast = [&](int c, int r) { return raster.above(c, r) != 0; };
    const auto reference = [&](int c, int r) {
      return slow[static_cast<std::size_t>(r * window.width + c)] != 0;
    };
    for (int column = 1; column + 1 < window.width; ++column) {
      const int own = skyline(fast, column);
      QVERIFY(own < window.height);
      int highest = window.height;
      for (int c = column - 1; c <= column + 1; ++c) highest = std::min(highest, skyline(reference, c));
      QVERIFY2(own >= highest, qPrintable(QStringLiteral("column %1").arg(column)));
    }
    QVERIFY2(raster.visited() < 20000, "descended into subtrees narrower than a pixel");
  }

  void tellsWhatIsBelowTheCut() {
    const DendrogramLayout layout = makeLayout(randomDendrogram(64, 3));
    const DendrogramWindow window = windowOn(layout, 0, 64, 640, 100);
    std::vector<std::uint8_t> drawn(layout.dendrogram->nodeCount(), 0);
    const NodeId root = layout.dendrogram->root();
    const Merge& top = layout.dendrogram->merge(root);
    drawn[top.a] = 1;
    drawn[top.b] = 1;
    DendrogramRaster raster;
    raster.draw(layout, window, drawn);
    for (const NodeId child : {top.a, top.b})
      QCOMPARE(raster.owner(static_cast<int>(window.column(layout.x[child]))), child);
    QVERIFY(raster.above(static_cast<int>(window.column(layout.x[root])),
                         static_cast<int>(window.row(layout.height[root]))) > 0);
    std::size_t below = 0;
    for (int row = 0; row < window.height; ++row) {
      for (int column = 0; column < window.width; ++column) below += raster.below(column, row);
    }
    QVERIFY(below > 0);
  }

  void findsTheNodeUnderAPoint() {
    const DendrogramLayout layout = makeLayout(randomDendrogram(500, 11));
    std::mt19937 random(5);
    for (int i = 0; i < 2000; ++i) {
      const double x = static_cast<double>(random() % 5000) / 10;
      const double h = kLeafHeight + static_cast<double>(random() % 1000) / 1000 * (layout.top - kLeafHeight);
      NodeId expected = kNoNode;  // children come first: the first node that fits is the smallest
      for (NodeId node = 0; node < layout.dendrogram->nodeCount() && expected == kNoNode; ++node) {
        const double first = layout.order.first[node];
        if (x >= first && x < first + layout.order.count[node] && layout.height[node] >= h) expected = node;
      }
      const NodeId found = layout.nodeAt(x, h);
      if (expected == kNoNode) {
        QCOMPARE(found, kNoNode);
      } else {
        QCOMPARE(layout.height[found], layout.height[expected]);
      }
    }
    QCOMPARE(layout.nodeAt(-1, 0), kNoNode);
    QCOMPARE(layout.nodeAt(500, 0), kNoNode);
  }

  void weightsAndHeightsAreInverse() {
    for (const double weight : {0.0, 0.5, 1.0, 1e3, 1e12})
      QVERIFY(std::abs(weightOfHeight(heightOfWeight(weight)) - weight) <= 1e-9 * (1 + weight));
  }

  void standsAnEmptyAndASingleLeaf() {
    DendrogramRaster raster;
    raster.draw({}, {0, 1, 0, 1, 10, 10}, {});
    QCOMPARE(raster.visited(), std::size_t{0});
    const DendrogramLayout layout = makeLayout(randomDendrogram(1, 1));
    raster.draw(layout, {0, 1, 0, 1, 10, 10}, {});
    QCOMPARE(layout.nodeAt(0.5, kLeafHeight), NodeId{0});
  }
};

}  // namespace lodestone

QTEST_APPLESS_MAIN(lodestone::DendrogramTest)
#include "dendrogram_test.moc"
