// Prints, as Markdown, what perception-driven simplification does to real buildings: the tables of
// resources/docs/perception.md. For each stage what is admitted and removed (the paper's table 2), and how
// far the result and other methods' of equally many triangles are from the original by mean ꟻLIP over views
// that were not used to classify. Arguments: options of `perceive` (--size 512 …), then files.
#include <algorithm>
#include <exception>
#include <filesystem>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "algorithms/footprints/import.h"
#include "algorithms/geometry/components.h"
#include "algorithms/perception/comparison.h"
#include "algorithms/perception/perceiving.h"
#include "algorithms/perception/viewpoints.h"
#include "algorithms/simplification/classification.h"
#include "algorithms/simplification/settled_simplification.h"
#include "algorithms/simplification/simplification.h"

namespace lodestone {
namespace {

/// A stage of the paper, with or without what no picture shows.
struct Case {
  int stage = 1;
  bool unseen = false;
  [[nodiscard]] std::string name() const { return fmt::format("{}{}", stage, unseen ? " + unseen" : ""); }
};
const std::vector<Case> kCases{{1, false}, {2, false}, {3, false}, {1, true}, {3, true}};

struct Peer {
  std::string name;
  SimplifyOptions options;
};

std::vector<Peer> peers() {
  std::vector<Peer> list{{"perception", {.method = SimplifyMethod::Perception}},
                         {"combined", {.method = SimplifyMethod::Combined}},
                         {"QEM", {.method = SimplifyMethod::Qem}},
                         {"QEM, rim planes", {.method = SimplifyMethod::Qem, .rimPlanes = true}},
                         {"topology", {.method = SimplifyMethod::Topology}}};
  return list;
}

/// A model with what is asked of it again and again.
class Model {
 public:
  Model(const std::filesystem::path& path, const PerceiveOptions& options)
      : name_(path.stem().string()), options_(options) {
    Result<CityModel> city = importCity({path});
    if (!city) throw std::runtime_error(path.string() + ": " + city.diagnostics.front().text);
    std::vector<std::uint32_t> all(city->buildings.size());
    std::iota(all.begin(), all.end(), 0U);
    mesh_ = makeComponentMesh(*city, all);
    look_ = readModelLook(*city, mesh_);
    classes_ = classify(mesh_);
    renderer_.emplace(mesh_, look_);
    perception_ = perceive(*renderer_, viewpointsAround(bounds(mesh_), options), options, {}, {},
                           closerViewpoints(bounds(mesh_), options));
    others_ = viewpointsAround(bounds(mesh_), options, 0.5);
  }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::uint32_t triangles() const { return mesh_.triangleCount(); }
  /// Triangles of class slight or above: what any stage can touch.
  [[nodiscard]] std::size_t latent() const { return admitted({3, false}); }
  [[nodiscard]] std::size_t admitted(const Case& one) const {
    const auto triangles = admittedTriangles(perception_, one.stage, one.unseen);
    return static_cast<std::size_t>(std::count(triangles.begin(), triangles.end(), true));
  }
  [[nodiscard]] Simplified simplified(SimplifyOptions options, const Case& one) const {
    options.stage = one.stage;
    options.unseen = one.unseen;
    if (!needsPerception(options.method)) return simplify(mesh_, classes_, options);
    return simplifySettled(mesh_, classes_, perception_, options).simplified;
  }
  /// Mean ꟻLIP over the other views.
  [[nodiscard]] double flipOf(const Simplified& level) const {
    const ModelRenderer renderer(level.mesh, look_);
    return compareModels(*renderer_, renderer, others_, options_.pixelsPerDegree()).all.flip;
  }

 private:
  std::string name_;
  PerceiveOptions options_;
  ComponentMesh mesh_;
  std::shared_ptr<const ModelLook> look_;
  Classification classes_;
  Perception perception_;
  std::optional<ModelRenderer> renderer_;
  std::vector<Camera> others_;
};

struct Row {
  std::string model;
  Case one;
  std::uint32_t triangles = 0;
  std::size_t latent = 0;
  std::size_t admitted = 0;
  std::uint32_t left = 0;
  std::vector<double> flips;          ///< by peer
  std::vector<std::uint32_t> counts;  ///< of triangles left, by peer
  [[nodiscard]] std::uint32_t removed() const { return triangles - left; }
};

Row rowOf(const Model& model, const Case& one) {
  Row row{model.name(), one, model.triangles(), model.latent(), model.admitted(one), 0, {}, {}};
  SimplifyOptions all{.method = SimplifyMethod::Perception, .rate = 1};
  row.left = model.simplified(all, one).mesh.triangleCount();
  if (row.removed() == 0) return row;
  for (Peer& peer : peers()) {
    peer.options.rate = static_cast<double>(row.removed()) / row.triangles;
    const Simplified level = model.simplified(peer.options, one);
    row.flips.push_back(model.flipOf(level));
    row.counts.push_back(level.mesh.triangleCount());
  }
  return row;
}

void printStages(const std::vector<Row>& rows) {
  fmt::print(
      "| model | triangles | stage | slight or above | admitted | removed | of admitted | of all |\n"
      "|---|--:|---|--:|--:|--:|--:|--:|\n");
  for (const Row& row : rows)
    fmt::print("| {} | {} | {} | {} | {} | {} | {:.2f}% | {:.2f}% |\n", row.model, row.triangles,
               row.one.name(), row.latent, row.admitted, row.removed(),
               row.admitted ? 100.0 * row.removed() / static_cast<double>(row.admitted) : 0.0,
               100.0 * row.removed() / row.triangles);
}

std::string cell(double value) {
  return fmt::format("{:.3f}", 1000 * value);
}

void printFlips(const std::vector<Row>& rows) {
  fmt::print("\n| model | stage | triangles left |");
  for (const Peer& peer : peers()) fmt::print(" {} |", peer.name);
  fmt::print("\n|---|---|--:|{}\n", std::string("--:|--:|--:|--:|--:|"));
  std::map<std::string, std::vector<std::vector<double>>> byStage;
  for (const Row& row : rows) {
    if (row.flips.empty()) continue;
    byStage[row.one.name()].push_back(row.flips);
    fmt::print("| {} | {} | {} |", row.model, row.one.name(), row.left);
    for (std::size_t p = 0; p < row.flips.size(); ++p) {
      // An operation removes two triangles, so that counts differ a little; where more, it is said.
      const bool equal = row.counts[p] <= row.left + 2 && row.left <= row.counts[p] + 2;
      fmt::print(" {}{} |", cell(row.flips[p]), equal ? "" : fmt::format(" ({} left)", row.counts[p]));
    }
    fmt::print("\n");
  }
  for (const auto& [stage, all] : byStage) {
    fmt::print("| **mean of {}** | {} | |", all.size(), stage);
    for (std::size_t p = 0; p < peers().size(); ++p) {
      double sum = 0;
      for (const auto& flips : all) sum += flips[p];
      fmt::print(" **{}** |", cell(sum / static_cast<double>(all.size())));
    }
    fmt::print("\n");
  }
}

void run(int argc, char** argv) {
  PerceiveOptions options;
  std::vector<Row> rows;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--") && i + 1 < argc) {
      const Diagnostics bad = setValues(options, {{word.substr(2), FieldValue(std::string(argv[++i]))}});
      if (!bad.empty()) throw std::invalid_argument(bad.front().text);
      continue;
    }
    const Model model(word, options);
    for (const Case& one : kCases) {
      rows.push_back(rowOf(model, one));
      fmt::print(stderr, "{} {}\n", rows.back().model, rows.back().one.name());
    }
  }
  printStages(rows);
  printFlips(rows);
}

}  // namespace
}  // namespace lodestone

int main(int argc, char** argv) {
  try {
    lodestone::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 2;
  }
}
