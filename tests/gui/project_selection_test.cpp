// What is selected stays so when buildings are clustered again.

#include "gui/workspace/same_clusters.h"
#include "tests/gui/project_support.h"
#include "tests/gui/scene_support.h"

namespace lodestone {
namespace {

/// A tree that joins its buildings in pairs, or one after the other.
ClusterTree treeOf(std::uint32_t leaves, bool inPairs) {
  ClusterTree tree;
  tree.nodes.resize(2 * static_cast<std::size_t>(leaves) - 1);
  for (NodeId next = leaves; next < tree.nodes.size(); ++next) {
    const NodeId merge = next - leaves;
    const NodeId a = inPairs ? 2 * merge : merge == 0 ? 0 : next - 1;
    const NodeId b = inPairs ? 2 * merge + 1 : merge + 1;
    tree.nodes[next].a = a;
    tree.nodes[next].b = b;
    tree.nodes[next].size = tree.nodes[a].size + tree.nodes[b].size;
    tree.nodes[a].parent = tree.nodes[b].parent = next;
  }
  return tree;
}

}  // namespace

class ProjectSelectionTest : public ProjectWindow {
  Q_OBJECT

 private Q_SLOTS:
  void init() { open(); }
  void cleanup() { window_.reset(); }

  void aClusterStaysSelectedByItsBuildings();
  void clustersAreComparedByTheirBuildings();
  void largeClustersAreComparedBySizeFirst();
};

void ProjectSelectionTest::aClusterStaysSelectedByItsBuildings() {
  openSample();
  const auto tree = workspace().state().tree;
  const NodeId pair = workspace().state().tree->dendrogram->leafCount;  // the first merge
  const NodeId root = tree->dendrogram->root();
  workspace().select({3, pair, root});
  ClusterOptions options = workspace().state().clusterOptions;
  options.linkage = Linkage::Complete;
  workspace().setClusterOptions(options, QStringLiteral("linkage"));
  workspace().cluster();
  waitForTasks();
  const auto after = workspace().state().tree;
  QVERIFY(after != tree);
  QCOMPARE(workspace().selection(), sameClusters(tree.get(), after.get(), {3, pair, root}));
  QCOMPARE(workspace().selection().front(), NodeId{3});
  QCOMPARE(workspace().selection().back(), after->dendrogram->root());
  QCOMPARE(window_->viewport().scene().selection(), workspace().selection());
  workspace().session().undo();
  workspace().session().undo();
  workspace().session().undo();
  QVERIFY(!workspace().state().tree);
  QCOMPARE(workspace().selection(), std::vector<NodeId>{3});
}

void ProjectSelectionTest::clustersAreComparedByTheirBuildings() {
  const auto city = test::smallTown(4);
  const auto one = test::handMadeTree(*city);
  // The same buildings joined in another order: node numbers differ, some sets of buildings do not.
  auto other = std::make_shared<ClusterTree>(*one);
  std::swap(other->nodes[16].a, other->nodes[17].a);
  std::swap(other->nodes[16].b, other->nodes[17].b);
  for (const NodeId node : {NodeId{16}, NodeId{17}}) {
    other->nodes[other->nodes[node].a].parent = node;
    other->nodes[other->nodes[node].b].parent = node;
  }
  QCOMPARE(sameClusters(one.get(), other.get(), {16, 17, 5, 18}), (std::vector<NodeId>{17, 16, 5, 18}));
  std::swap(other->nodes[18].b, other->nodes[19].b);
  for (const NodeId node : {NodeId{18}, NodeId{19}}) other->nodes[other->nodes[node].b].parent = node;
  QCOMPARE(sameClusters(one.get(), other.get(), {18, 19}), std::vector<NodeId>{});
  QCOMPARE(sameClusters(one.get(), nullptr, {1, 20, 2}), (std::vector<NodeId>{1, 2}));
}

void ProjectSelectionTest::largeClustersAreComparedBySizeFirst() {
  const std::uint32_t leaves = 1U << 16;
  const ClusterTree chain = treeOf(leaves, false);
  const ClusterTree pairs = treeOf(leaves, true);
  std::vector<NodeId> all;
  for (NodeId node = leaves; node < chain.nodes.size(); ++node) all.push_back(node);
  // All their buildings listed would be 2·10⁹ of them, more than the test has time for.
  QCOMPARE(sameClusters(&chain, &pairs, all).size(), std::size_t{16});  // those of 2, 4, 8, … buildings
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::ProjectSelectionTest>(argc, argv);
}
#include "project_selection_test.moc"
