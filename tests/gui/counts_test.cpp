// The workbench and the command line count alike: the same cut of the same file, to the polygon.
#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "gui/workspace/jobs.h"
#include "tests/gui/workbench_support.h"
#include "tests/support/run_program.h"
#include "tests/support/shared_data.h"

namespace lodestone {

class CountsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init() { window_ = makeWindow(); }
  void cleanup() { window_.reset(); }

  void cutsAndLevels_data();
  void cutsAndLevels();

 private:
  [[nodiscard]] Workspace& workspace() { return window_->workspace(); }
  void openClustered(const QString& path) {
    workspace().import({path}, {}, true);
    QTRY_VERIFY_WITH_TIMEOUT(workspace().state().tree != nullptr, kLong);
    QTRY_VERIFY_WITH_TIMEOUT(!workspace().tasks().busy(), kLong);
  }
  /// The camera that is looked through, as the command line takes it.
  [[nodiscard]] std::string camera() {
    const Camera& camera = workspace().camera();
    const CityModel& city = *workspace().state().city;
    const Vec3 shift = city.crs.kind == CrsKind::Geographic ? Vec3::Zero() : city.origin;
    const Vec3 eye = camera.eye + shift;
    const Vec3 target = camera.target + shift;
    return fmt::format("{},{},{},{},{},{},{},{}x{}", eye.x(), eye.y(), eye.z(), target.x(), target.y(),
                       target.z(), camera.fov, camera.width, camera.height);
  }

  std::unique_ptr<MainWindow> window_;
};

namespace {

nlohmann::json run(const std::vector<std::string>& arguments, const std::filesystem::path& result) {
  std::vector<std::string> line{LODESTONE_CLI};
  line.insert(line.end(), arguments.begin(), arguments.end());
  const test::Outcome outcome = test::runProgram(line);
  if (outcome.status != 0 && outcome.status != 3) qWarning("%s", outcome.err.c_str());
  std::ifstream file(result);
  return nlohmann::json::parse(file, nullptr, false);
}

FaceCount facesIn(const nlohmann::json& json) {
  return {json.at("polygons").get<std::uint64_t>(), json.at("triangles").get<std::uint64_t>()};
}

}  // namespace

void CountsTest::cutsAndLevels_data() {
  QTest::addColumn<QString>("path");
  QTest::newRow("sample town") << samplePath();
  for (const char* path :
       {"A_citygml/nrw_lod2/LoD2_32_280_5657_1_NW.gml", "C_footprints/suzhou_pybdshadow/bd_demo.json"})
    QTest::newRow(path) << QString::fromStdString(test::sharedData(path).string());
}

void CountsTest::cutsAndLevels() {
  QFETCH(const QString, path);
  if (path.isEmpty()) QSKIP("no shared data");
  openClustered(path);
  const test::TemporaryFolder folder;
  const std::string input = path.toStdString();
  const std::string cut = (folder / "cut.json").string();
  for (const double epsilon : {10.0, 1000.0}) {
    workspace().setCutOptions({epsilon, 2}, QStringLiteral("test"));
    const auto json =
        run({"cut", input, "--camera", camera(), "--epsilon", fmt::format("{}", epsilon), "-o", cut},
            folder / "cut.json");
    QVERIFY(json.is_object());
    QVERIFY(facesIn(json) == workspace().facesDrawn());
    QVERIFY(workspace().facesDrawn() != workspace().facesOfAll());
  }

  const std::string report = (folder / "report.json").string();
  const auto json = run({"chain", input, "--formats", "geojson", "--tolerances", "10,40", "--report", report,
                         "-o", (folder / "chain").string()},
                        folder / "report.json");
  QVERIFY(json.is_object());
  const auto& levels = json.at("figures").at("levels");
  QVERIFY(facesIn(levels.at(0)) == workspace().facesOfAll());
  QVERIFY(facesIn(json.at("figures")) == workspace().facesOfAll());
  workspace().setCutOptions({100, 2}, QStringLiteral("test"));
  for (std::size_t i : {1U, 2U}) {
    workspace().setCutChoice({CutMode::Tolerance, i == 1 ? 10.0 : 40.0});
    QVERIFY(facesIn(levels.at(i)) == workspace().facesDrawn());
  }
}

}  // namespace lodestone

int main(int argc, char** argv) {
  return lodestone::runWorkbenchTest<lodestone::CountsTest>(argc, argv);
}
#include "counts_test.moc"
