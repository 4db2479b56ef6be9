// What the workspace reads and writes: city models, projects, exports.
#include <QFileInfo>
#include <algorithm>

#include "algorithms/footprints/import.h"
#include "gui/workspace/jobs.h"
#include "gui/workspace/workspace.h"
#include "model/io/project_file.h"

namespace lodestone {
namespace {

std::vector<std::filesystem::path> toPaths(const std::vector<std::string>& texts) {
  return {texts.begin(), texts.end()};
}

QString titleOf(const QStringList& paths) {
  const QString first = paths.isEmpty() ? QString() : QFileInfo(paths.first()).fileName();
  return paths.size() > 1 ? Workspace::tr("%1 and %2 more").arg(first).arg(paths.size() - 1) : first;
}

}  // namespace

bool leavesAnyOut(const Diagnostics& diagnostics) {
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.code == Code::InputLeftOut; });
}

void Workspace::import(const QStringList& paths, const ImportOptions& options, bool thenCluster,
                       const QStringList& barriers) {
  ImportPlan plan;
  plan.wanted.sources = toStrings(paths);
  plan.wanted.importOptions = options;
  plan.wanted.barriers = toStrings(barriers);
  plan.wanted.clusterOptions = state().clusterOptions;
  plan.wanted.mergeOptions = state().mergeOptions;
  plan.wanted.chainOptions = state().chainOptions;
  plan.wanted.simplifyOptions = state().simplifyOptions;
  plan.wanted.comparedOptions = state().comparedOptions;
  plan.what = tr("Import %1").arg(titleOf(paths));
  plan.thenCluster = thenCluster;
  startImport(plan, tr("Opening %1").arg(titleOf(paths)));
}

void Workspace::addToModel(const QStringList& paths, const ImportOptions& options) {
  readModelWith(paths, options, tr("Add %1").arg(titleOf(paths)), tr("Adding %1").arg(titleOf(paths)));
}

void Workspace::readAgain(const ImportOptions& options) {
  readModelWith({}, options, tr("Unit and up axis"), tr("Reading again"));
}

void Workspace::readModelWith(const QStringList& more, const ImportOptions& options, const QString& what,
                              const QString& title) {
  ImportPlan plan;
  plan.wanted = state();
  plan.wanted.importOptions = options;
  for (std::string& path : toStrings(more)) {
    auto& sources = plan.wanted.sources;
    if (std::find(sources.begin(), sources.end(), path) == sources.end()) sources.push_back(std::move(path));
  }
  plan.what = what;
  plan.keepsProject = true;
  startImport(plan, title);
}

void Workspace::startImport(const ImportPlan& plan, const QString& title) {
  tasks_.start(
      importTask(), title,
      [sources = plan.wanted.sources, options = plan.wanted.importOptions](const Progress& progress) {
        return importCity(toPaths(sources), options, progress);
      },
      [this, plan](Result<CityModel> result) { commitImport(std::move(result), plan); });
}

void Workspace::commitImport(Result<CityModel> result, const ImportPlan& plan) {
  if (!result || (plan.keepsProject && leavesAnyOut(result.diagnostics))) {
    Q_EMIT importRejected(result.diagnostics);
    return;
  }
  if (plan.keepsProject && state().city != plan.wanted.city) {
    Q_EMIT importRejected({diagnose(Code::Cancelled, plan.what.toStdString())});  // undone under its feet
    return;
  }
  bool thenCluster = plan.thenCluster;
  if (plan.keepsProject) {
    thenCluster = state().tree || state().droppedTree || tasks_.busy(clusterTask());
    commitAdded(std::move(*result), plan);
  } else {
    ProjectState next = plan.wanted;
    next.city = std::make_shared<const CityModel>(std::move(*result));
    next.project = newProject(Home{});
    commitStep(std::move(next), plan.what);
  }
  // Messages come after the city that they are about.
  if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
  Q_EMIT imported();
  if (thenCluster) cluster();
}

void Workspace::commitAdded(CityModel city, const ImportPlan& plan) {
  ProjectState next = state();
  next.sources = plan.wanted.sources;
  next.importOptions = plan.wanted.importOptions;
  next.city = std::make_shared<const CityModel>(std::move(city));
  next.tree.reset();
  next.treeBarriers.clear();
  next.droppedTree.reset();
  commit(std::move(next), plan.what);
}

void Workspace::openSample() {
  const QString path = samplePath();
  if (path.isEmpty()) {
    Q_EMIT diagnosed({diagnose(Code::FileNotFound, "resources/sample")});
    return;
  }
  const QStringList streets = sampleStreets();
  import({path}, {}, true, streets);
}

void Workspace::close() {
  homes_.clear();
  session_.reset({});
}

void Workspace::loadProjectFile(const QString& path, bool recovered) {
  Result<LoadedProject> loaded = loadProject(path.toStdString());
  if (!loaded) {
    Q_EMIT importRejected(loaded.diagnostics);
    return;
  }
  const ProjectState wanted = loaded->state;
  const Diagnostics said = loaded.diagnostics;
  const QString layout = QString::fromStdString(loaded->layout);
  tasks_.start(
      importTask(), tr("Opening %1").arg(QFileInfo(path).fileName()),
      [wanted](const Progress& progress) {
        return importCity(toPaths(wanted.sources), wanted.importOptions, progress);
      },
      [this, wanted, said, path, layout, recovered](Result<CityModel> result) {
        Diagnostics diagnostics = said;
        diagnostics.insert(diagnostics.end(), result.diagnostics.begin(), result.diagnostics.end());
        if (!result) {
          Q_EMIT importRejected(diagnostics);
          return;
        }
        ProjectState next = wanted;
        next.city = std::make_shared<const CityModel>(std::move(*result));
        // The tree belongs to what was opened, and to all that is made of it before the tree is there.
        if (!next.city->buildings.empty())
          next.droppedTree = TreeRecipe{next.clusterOptions, next.mergeOptions, next.barriers};
        homes_.clear();
        next.project = newProject(Home{recovered ? QString() : path, recovered, false});
        session_.reset(next);
        if (recovered) session_.commit(std::move(next), tr("Recover work").toStdString());
        if (!diagnostics.empty()) Q_EMIT diagnosed(diagnostics);
        Q_EMIT imported();
        Q_EMIT projectOpened(path, layout);
      });
}

bool Workspace::saveProject(const QString& path, const QString& layout) {
  ProjectState toSave = state();
  toSave.camera = camera_;
  const Result<bool> saved = lodestone::saveProject(toSave, path.toStdString(), layout.toStdString());
  if (!saved.diagnostics.empty()) Q_EMIT diagnosed(saved.diagnostics);
  return saved.ok();
}

void Workspace::markSaved(const QString& path) {
  home() = Home{path, false, false};
  session_.markSaved();
}

void Workspace::exportChain(const ExportRequest& request) {
  const ProjectState snapshot = state();
  if (!snapshot.city) return;
  enqueueExport(request,
                [snapshot, request, camera = frozenCamera_.value_or(camera_)](const Progress& progress) {
                  return writeChain(snapshot, camera, request, progress);
                });
}

void Workspace::exportBuildings(const ExportRequest& request, std::function<LodChain()> make) {
  enqueueExport(request, [request, make = std::move(make)](const Progress& progress) {
    return writeFormats(make(), {}, request, progress);
  });
}

/// The source that one of the files would take the place of.
std::optional<std::string> Workspace::sourceReplacedBy(const ExportRequest& request) const {
  for (const std::string& id : request.formats) {
    const Format* format = formatById(id);
    if (!format) continue;
    const auto path = request.folder / (request.name + std::string(format->extensions.front()));
    for (const std::string& source : state().sources) {
      std::error_code notThere;
      if (std::filesystem::equivalent(path, source, notThere)) return source;
    }
  }
  return std::nullopt;
}

void Workspace::enqueueExport(const ExportRequest& request,
                              std::function<Result<WriteReport>(const Progress&)> write) {
  if (const auto source = sourceReplacedBy(request)) {
    Q_EMIT diagnosed({diagnose(Code::OutputExists, *source + " is a file of this model")});
    return;
  }
  tasks_.enqueue(exportTask(), tr("Exporting %1").arg(QString::fromStdString(request.name)), std::move(write),
                 [this](const Result<WriteReport>& result) {
                   if (!result.diagnostics.empty()) Q_EMIT diagnosed(result.diagnostics);
                   QStringList files;
                   if (result) {
                     for (const auto& file : result->files) files << QString::fromStdString(file.string());
                   }
                   Q_EMIT exported(files);
                 });
}

}  // namespace lodestone
