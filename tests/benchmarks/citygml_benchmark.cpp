// CityGML reading against what it could cost at least (a bare Expat pass over the same bytes) and against
// libcitygml.
//
// citygml_benchmark FILE.gml [REPEATS]: prints MB/s, ratios, and peak memory against the size of the
// resulting model. Every run has a process of its own, so that peaks do not mix; the best of the repeats
// counts. The file is read once before, so that all find it in the page cache. Make a large one with
// repeat_citygml.py.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <expat.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef LODESTONE_HAS_LIBCITYGML
#include <citygml/citygml.h>
#include <citygml/citygmllogger.h>
#include <citygml/citymodel.h>
#endif

#include "model/io/citygml/citygml.h"

namespace {

constexpr double kMega = 1e6;
constexpr double kMebi = 1024.0 * 1024.0;

struct Figures {
  double seconds = 1e300;
  double peak = 0;   ///< bytes resident at most, above what the process had at its start
  double model = 0;  ///< bytes of the result, where it is known
  double objects = 0;
};

double peakResident() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) * 1024;
}

template <class T>
double bytesOf(const std::vector<T>& v) {
  return static_cast<double>(v.capacity() * sizeof(T));
}

double bytesOf(const std::string& text) {
  return text.capacity() > std::string().capacity() ? static_cast<double>(text.capacity() + 1) : 0;
}

double bytesOf(const lodestone::CityObject& object) {
  double sum = bytesOf(object.id) + bytesOf(object.geometries) + bytesOf(object.children);
  for (const auto& [name, value] : object.attributes) {
    sum += sizeof(lodestone::Attributes::Entry) + bytesOf(name);
    if (const auto* text = std::get_if<std::string>(&value)) sum += bytesOf(*text);
    if (const auto* json = std::get_if<lodestone::JsonText>(&value)) sum += bytesOf(json->text);
  }
  for (const lodestone::Geometry& g : object.geometries) {
    sum += bytesOf(g.vertices) + bytesOf(g.ringVertices) + bytesOf(g.ringStart) + bytesOf(g.surfaceStart) +
           bytesOf(g.surfaces) + bytesOf(g.textureCoordinates) + bytesOf(g.shellStart) +
           bytesOf(g.solidStart);
  }
  for (const auto& child : object.children) sum += bytesOf(child);
  return sum;
}

double bytesOf(const lodestone::CityModel& model) {
  double sum = bytesOf(model.buildings) + bytesOf(model.others);
  for (const auto& building : model.buildings) sum += bytesOf(building.object);
  for (const auto& object : model.others) sum += bytesOf(object);
  return sum;
}

/// The cheapest thing Expat can do: no namespaces, no handlers.
Figures runExpat(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  XML_Parser parser = XML_ParserCreate(nullptr);
  constexpr int kBuffer = 1 << 18;
  for (bool last = false; !last;) {
    void* buffer = XML_GetBuffer(parser, kBuffer);
    file.read(static_cast<char*>(buffer), kBuffer);
    last = file.gcount() < kBuffer;
    if (XML_ParseBuffer(parser, static_cast<int>(file.gcount()), last) != XML_STATUS_OK) std::exit(1);
  }
  XML_ParserFree(parser);
  return {};
}

Figures runLodestone(const std::string& path) {
  static lodestone::Result<lodestone::CityModel> result;
  result = lodestone::cityGmlFormat().read(path, {}, {});
  if (!result) std::exit(1);
  Figures figures;
  figures.model = bytesOf(*result);
  figures.objects = static_cast<double>(result->buildings.size());
  return figures;
}

#ifdef LODESTONE_HAS_LIBCITYGML
/// It complains of thousands of things; printing them is not its speed.
class Silent : public citygml::CityGMLLogger {
 public:
  void log(LOGLEVEL, const std::string&, const char*, int) const override {}
  bool isEnabledFor(LOGLEVEL) const override { return false; }
};

Figures runLibcitygml(const std::string& path) {
  citygml::ParserParams params;
  params.tesselate = false;  // we do not either
  params.keepVertices = true;
  const auto model = citygml::load(path, params, std::make_shared<Silent>());
  if (!model) std::exit(1);
  Figures figures;
  figures.objects = static_cast<double>(model->getNumRootCityObjects());
  return figures;
}
#endif

/// Runs `body` in a child process.
Figures inChild(const std::function<Figures()>& body) {
  int ends[2];
  if (pipe(ends) != 0) std::exit(1);
  const pid_t child = fork();
  if (child == 0) {
    const double before = peakResident();
    const auto start = std::chrono::steady_clock::now();
    Figures figures = body();
    figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    figures.peak = peakResident() - before;
    const bool written = write(ends[1], &figures, sizeof figures) == sizeof figures;
    _exit(written ? 0 : 1);
  }
  close(ends[1]);
  Figures figures;
  const bool complete = read(ends[0], &figures, sizeof figures) == sizeof figures;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  if (!complete || status != 0) {
    std::fprintf(stderr, "a run failed\n");
    std::exit(1);
  }
  return figures;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fprintf(stderr, "citygml_benchmark FILE.gml [REPEATS]\n");
    return 2;
  }
  const std::string path = argv[1];
  const int repeats = argc > 2 ? std::atoi(argv[2]) : 3;
  const double size = static_cast<double>(std::filesystem::file_size(path));
  struct Contender {
    const char* name;
    Figures (*run)(const std::string&);
    Figures best;
  };
  std::vector<Contender> contenders{{"Expat alone", &runExpat, {}}, {"Lodestone", &runLodestone, {}}};
#ifdef LODESTONE_HAS_LIBCITYGML
  contenders.push_back({"libcitygml", &runLibcitygml, {}});
#endif
  (void)inChild([&] { return runExpat(path); });
  for (int i = 0; i < repeats; ++i) {
    // Taking turns spreads what else the machine does over all of them.
    for (Contender& contender : contenders) {
      const Figures figures = inChild([&] { return contender.run(path); });
      if (figures.seconds < contender.best.seconds) contender.best = figures;
    }
  }
  const Figures& floor = contenders[0].best;
  const Figures& own = contenders[1].best;
  std::printf("%s, %.1f MB, best of %d\n\n", std::filesystem::path(path).filename().c_str(), size / kMega,
              repeats);
  std::printf("| reader | s | MB/s | of Expat | peak MiB | objects |\n|---|--:|--:|--:|--:|--:|\n");
  for (const Contender& contender : contenders) {
    const Figures& f = contender.best;
    std::printf("| %s | %.2f | %.1f | %.2f | %.1f | %.0f |\n", contender.name, f.seconds,
                size / kMega / f.seconds, floor.seconds / f.seconds, f.peak / kMebi, f.objects);
  }
  std::printf("\nMB/s of Expat alone: %.2f (wanted: 0.5 or more)\n", floor.seconds / own.seconds);
  if (contenders.size() > 2) {
    std::printf("MB/s of libcitygml: %.1f times (wanted: 2 or more)\n",
                contenders.back().best.seconds / own.seconds);
  }
  std::printf("peak memory of the model's %.1f MiB: %.2f times (wanted: below 1.5)\n", own.model / kMebi,
              own.peak / own.model);
  return 0;
}
