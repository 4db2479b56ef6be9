// Repaints of the dendrogram dock at 370,000 leaves, beside a drawing of every merge.
#include <QApplication>
#include <QImage>
#include <QPainter>
#include <algorithm>
#include <chrono>
#include <random>

#include <fmt/format.h>

#include "algorithms/clustering/clustering.h"
#include "algorithms/merging/merging.h"
#include "algorithms/synthesis/synthesis.h"
#include "gui/city/dendrogram_view.h"
#include "gui/workspace/workspace.h"

namespace {

using namespace lodestone;
using Clock = std::chrono::steady_clock;

double millisecondsOf(const std::function<void()>& work) {
  const auto begin = Clock::now();
  work();
  return std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
}

struct Times {
  std::vector<double> all;
  [[nodiscard]] double share(double s) {
    std::sort(all.begin(), all.end());
    return all.empty() ? 0 : all[static_cast<std::size_t>(s * static_cast<double>(all.size() - 1))];
  }
};

/// The peer: every merge drawn with Qt's own lines, as a picture of this size shows it.
double drawEveryMerge(const DendrogramLayout& layout, QImage& image) {
  return millisecondsOf([&] {
    image.fill(Qt::white);
    QPainter painter(&image);
    const DendrogramWindow window{0,
                                  static_cast<double>(layout.dendrogram->leafCount),
                                  kLeafHeight,
                                  layout.top,
                                  image.width(),
                                  image.height()};
    for (NodeId node = layout.dendrogram->leafCount; node < layout.dendrogram->nodeCount(); ++node) {
      const Merge& merge = layout.dendrogram->merge(node);
      const auto at = [&](NodeId child, NodeId level) {
        return QPointF(window.column(layout.x[child]), window.row(layout.height[level]));
      };
      const QPointF lines[] = {at(merge.a, merge.a), at(merge.a, node), at(merge.b, node),
                               at(merge.b, merge.b)};
      painter.drawPolyline(lines, 4);
    }
  });
}

ProjectState charlotte() {
  SynthOptions options;
  options.preset = CityPreset::Charlotte;
  ProjectState state;
  state.city = std::make_shared<const CityModel>(synthesiseCity(options));
  auto footprints = std::make_shared<const FootprintTable>(footprintTable(*state.city));
  auto dendrogram = std::make_shared<const Dendrogram>(makeDendrogram(*footprints, {}));
  state.tree = std::make_shared<const ClusterTree>(makeClusterTree(footprints, dendrogram));
  return state;
}

int measure() {
  Workspace workspace;
  DendrogramView view(workspace);
  view.resize(1400, 300);
  workspace.session().reset(charlotte());
  const DendrogramLayout& layout = view.layoutOfNodes();
  QImage image(view.size(), QImage::Format_ARGB32_Premultiplied);
  std::mt19937 random(1);
  Times still, moved, zoomed;
  for (int i = 0; i < 200; ++i) still.all.push_back(millisecondsOf([&] { view.render(&image); }));
  for (int i = 0; i < 200; ++i) {
    const double weight = weightOfHeight(layout.top * (i + 1) / 201.0);
    moved.all.push_back(millisecondsOf([&] {
      workspace.setCutChoice({CutMode::Weight, weight});
      view.render(&image);
    }));
  }
  for (int i = 0; i < 400; ++i) {
    view.zoomTo(
        static_cast<NodeId>(layout.dendrogram->leafCount + random() % layout.dendrogram->merges.size()));
    zoomed.all.push_back(millisecondsOf([&] { view.render(&image); }));
  }
  const double peer = drawEveryMerge(layout, image);
  fmt::print("{} leaves, depth {}, 1400 × 300 pixels; the peer, every merge drawn: {:.0f} ms\n\n",
             layout.dendrogram->leafCount, layout.dendrogram->depth, peer);
  fmt::print(
      "| repaint | median ms | 95% ms | longest ms | 95% / peer | 95% within 33 ms "
      "|\n|---|--:|--:|--:|--:|---|\n");
  bool kept = true;
  const auto row = [&](const char* name, Times& times) {
    const double most = times.share(0.95);
    kept = kept && most <= 33;
    fmt::print("| {} | {:.1f} | {:.1f} | {:.1f} | {:.3f} | {} |\n", name, times.share(0.5), most,
               times.share(1), most / peer, most <= 33 ? "yes" : "NO");
  };
  row("the whole tree", still);
  row("cut line moved, cut made anew", moved);
  row("zoomed to random clusters", zoomed);
  return kept ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");
  const QApplication app(argc, argv);
  return measure();
}
