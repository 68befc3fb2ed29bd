// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <ctime>
#include <deque>
#include <memory>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "check/group.hpp"
#include "check/in_time.hpp"
#include "check/pipeline.hpp"
#include "check/run.hpp"
#include "check/snapshot.hpp"
#include "check/xacro_share.hpp"
#include "link/imported_world.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/check.hpp"
#include "smurf/companions.hpp"
#include "smurf/confine.hpp"

namespace smurf {
namespace {

std::string text_of(const struct timespec& time) {
  return std::to_string(time.tv_sec) + "." + std::to_string(time.tv_nsec);
}

bool is_readable(const std::string& path, const FileReader& files) {
  const ReadStatus status = files.read(path, 0).status;  // without content
  return status == ReadStatus::ok || status == ReadStatus::too_large;
}

/// Whether a YAML file belongs to a robot of ROS.
bool is_companion(const std::string& path, const FileReader& files) {
  constexpr std::uint64_t kMostBytes = 1U << 20U;
  const FileContent content = files.read(path, kMostBytes);
  return content.status == ReadStatus::ok && find_companion_kind(path, content.text) != nullptr;
}

/// The configuration of a file. A configuration that cannot be read is ignored.
std::string config_for(const std::string& path, const CheckSettings& settings,
                       const FileReader& files) {
  if (settings.is_isolated) return {};
  if (!settings.config.empty()) return settings.config;
  std::string config = nearest_config(path, files);
  return config.empty() || is_readable(config, files) ? config : std::string();
}

}  // namespace

FileStamp stamp_on_disk(const std::string& path) {
  // A file that was just written may change again within the resolution of its time stamps.
  constexpr std::time_t kResolution = 2;  // s
  sys::Status status{};
  if (path.find('\0') != std::string::npos || sys::stat(path.c_str(), &status) != 0) {
    return {"missing " + std::to_string(errno), true};
  }
  std::string text = text_of(status.st_mtim) + " " + text_of(status.st_ctim);
  for (const auto number :
       {static_cast<std::uint64_t>(status.st_size), static_cast<std::uint64_t>(status.st_ino),
        static_cast<std::uint64_t>(status.st_dev), static_cast<std::uint64_t>(status.st_mode)}) {
    text += " " + std::to_string(number);
  }
  const std::time_t last = std::max(status.st_mtim.tv_sec, status.st_ctim.tv_sec);
  return {std::move(text), std::time(nullptr) - last >= kResolution};
}

struct LoadedWith {
  std::shared_ptr<CheckGroups> groups;  ///< one
  MeshLibrary meshes;
  std::size_t first_source = 0;

  const CheckGroup& group() const { return groups->front(); }
};

std::uint64_t max_seconds_of(const Loaded& loaded) {
  return loaded.loaded_with->group().settings.max_seconds;
}

struct Session::State {
  State(const FileReader* reader, const Limits& of_user, StampOf stamps)
      : limits(of_user), given(reader), stamp_of_file(std::move(stamps)) {
    open();
  }

  /// Unpacks archives and follows links again.
  void open() {
    if (given == nullptr) {
      disk.emplace();
      confine(*disk, asked_for, asked_packages, allows_outside);
      disk->allow(baseline);
    }
    archives.emplace(given == nullptr ? *disk : *given, limits);
    if (!files) {  // otherwise, it has the same texts and archives
      files.emplace(&*archives);
      for (const auto& [path, text] : texts) files->add(path, text.first);
    }
    paths.emplace();
  }

  /// The same, with further files that may be read. Loaded results stay valid.
  void open(std::span<const std::string> inputs, const CheckSettings& settings) {
    asked_for.insert(asked_for.end(), inputs.begin(), inputs.end());
    if (!settings.config.empty()) asked_for.push_back(settings.config);
    std::sort(asked_for.begin(), asked_for.end());
    asked_for.erase(std::unique(asked_for.begin(), asked_for.end()), asked_for.end());
    for (const auto& [name, folder] : settings.packages) asked_packages[name] = folder;
    allows_outside = settings.allows_outside;
    baseline = settings.baseline;
    open();
  }

  FileStamp stamp_of(const std::string& path) const {
    const auto text = texts.find(path::normalize(path));
    if (text != texts.end()) return {"text " + std::to_string(text->second.second), true};
    return stamp_of_file && !is_in_archive(path) ? stamp_of_file(path) : FileStamp{};
  }

  CheckContext context_from(std::size_t first_source) const {
    return {*files, limits, *paths, first_source};
  }

  void announce(std::span<const std::string> inputs, const CheckSettings& settings) {
    open(inputs, settings);
    announced = {inputs.begin(), inputs.end()};
    steps_of_each = xacro_steps_of_each({inputs.begin(), inputs.end()}, limits);
    announced_groups.clear();
    read = std::make_shared<ReadFiles>();
  }

  /// The context in which a model or scene is loaded.
  Loaded prepare(const std::string& path, const CheckSettings& settings) {
    const bool is_announced = announced.erase(path) > 0;
    if (!is_announced) {
      open(std::span(&path, 1), settings);
      announced_groups.clear();
      read->lists.clear();
      steps_of_each = limits.xacro_steps;
    }
    LoadedWith& with = loaded_with.emplace_back();
    with.first_source = loaded_sources.size();
    const std::string config = config_for(path, settings, *files);
    std::shared_ptr<CheckGroups>& groups = announced_groups[config];
    if (groups == nullptr) {
      groups = std::make_shared<CheckGroups>(
          read_configurations({config}, settings, *files, loaded_sources));
      merge(settings, *paths, *groups);
    }
    with.groups = groups;
    return {&loaded_sources, DiagnosticSink(limits), &with};
  }

  Plan plan(std::span<const std::string> inputs, const CheckSettings& settings) {
    open(inputs, settings);
    PlanSettings wanted;
    wanted.paths.assign(inputs.begin(), inputs.end());
    wanted.config = settings.config;
    wanted.is_isolated = settings.is_isolated;
    wanted.limits = limits;
    return make_plan(wanted, *files);
  }

  /// Call it after open().
  Report run(const Plan& plan, const CheckSettings& settings) {
    if (!settings.remembers) {
      snapshot.reset();
      memory = {};
    } else if (!snapshot) {
      snapshot.emplace(*files, [this](const std::string& path) { return stamp_of(path); });
    } else {
      snapshot->begin();
    }
    const RunContext context{context_from(0), snapshot ? &*snapshot : nullptr, memory};
    checked = &sources;
    try {
      return run_check(plan, settings, context, sources);
    } catch (const OutOfTime&) {
      memory = {};  // parts of it were moved into the report
      throw;
    }
  }

  /// Loads something for `path`, or reports that it takes too long.
  template <class Work>
  void load(const std::string& path, Loaded& loaded, const Work& work) {
    const std::uint64_t seconds = max_seconds_of(loaded);
    run_in_time(seconds, work, [&] {
      report_out_of_time(path, seconds, loaded_sources, loaded.found);
      read = std::make_shared<ReadFiles>();  // it may have been half read
    });
  }

  template <class Linked>
  Report judge_in_time(Linked& linked, const std::string& path, Loaded& loaded) {
    const CheckGroup& group = loaded.loaded_with->group();
    const std::uint64_t seconds = max_seconds_of(loaded);
    DiagnosticSink found = loaded.found;  // a later check reports them again
    Judged judged;
    run_in_time(
        seconds,
        [&] { judged = judge(linked, loaded_sources, group.selection, found, *expansions); },
        [&] {
          found = loaded.found;
          report_out_of_time(path, seconds, loaded_sources, found);
          judged.diagnostics = found.take();
        });
    return report(std::move(judged), loaded);
  }

  Report report(Judged&& judged, Loaded& loaded) {
    checked = &loaded_sources;
    std::vector<Judged> found;
    found.push_back(std::move(judged));
    return make_report(std::move(found), *loaded.loaded_with->groups,
                       context_from(loaded.loaded_with->first_source), loaded_sources);
  }

  Limits limits;
  const FileReader* given;  ///< null: the disk
  std::optional<ConfinedFiles> disk;
  std::vector<std::string> asked_for;
  std::map<std::string, std::string> asked_packages;
  bool allows_outside = false;
  std::string baseline;  ///< "": no file was named
  StampOf stamp_of_file;
  std::optional<ArchiveFiles> archives;
  std::optional<MemoryFiles> files;
  std::optional<CanonicalPaths> paths;
  std::map<std::string, std::pair<std::string, std::uint64_t>> texts;  ///< with their numbers
  std::uint64_t last_text = 0;

  std::optional<Snapshot> snapshot;
  Memory memory;
  SourceMap sources;  ///< of the last check of paths
  SourceMap loaded_sources;
  const SourceMap* checked = &sources;                              ///< of the last check
  std::shared_ptr<ReadFiles> read = std::make_shared<ReadFiles>();  ///< into loaded_sources
  std::shared_ptr<xacro::Expansions> expansions = std::make_shared<xacro::Expansions>();
  std::deque<LoadedWith> loaded_with;
  std::set<std::string> announced;
  std::uint64_t steps_of_each = limits.xacro_steps;  ///< of expansions, see xacro_steps_of_each()
  std::map<std::string, std::shared_ptr<CheckGroups>> announced_groups;  ///< by configuration
};

Session::Session(const Limits& limits)
    : state_(std::make_unique<State>(nullptr, limits, stamp_on_disk)) {}
Session::Session(const FileReader& files, const Limits& limits, StampOf stamp_of)
    : state_(std::make_unique<State>(&files, limits, std::move(stamp_of))) {}
Session::~Session() = default;

void Session::set_text(const std::string& path, std::string text) {
  const std::string name = path::normalize(path);
  state_->files->add(name, text);
  state_->texts[name] = {std::move(text), ++state_->last_text};
}

void Session::clear_text(const std::string& path) {
  if (state_->texts.erase(path::normalize(path)) == 0) return;
  state_->files.reset();
  state_->open();
}

Report Session::check(const Plan& plan, const CheckSettings& settings) {
  std::vector<std::string> inputs = plan.configs;
  for (const auto* files : {&plan.scenes, &plan.models, &plan.others, &plan.companions}) {
    for (const PlannedFile& file : *files) inputs.push_back(file.path);
  }
  state_->open(inputs, settings);
  return state_->run(plan, settings);
}

Plan Session::plan(std::span<const std::string> paths, const CheckSettings& settings) {
  return state_->plan(paths, settings);
}

Report Session::check(std::span<const std::string> paths, const CheckSettings& settings) {
  return check(state_->plan(paths, settings), settings);
}

Report Session::check(const std::string& path, const CheckSettings& settings) {
  Plan plan;
  if (places::is_folder(path)) {
    Plan found = state_->plan(std::span(&path, 1), settings);
    const bool is_nothing = found.scenes.empty() && found.models.empty() && found.others.empty();
    if (!is_nothing) return check(found, settings);
    plan.problems = std::move(found.problems);  // and a finding, which nobody overlooks
  }
  state_->open(std::span(&path, 1), settings);
  const InputKind kind = input_kind(path);
  if (kind == InputKind::annotation && is_companion(path, *state_->files)) {
    return check(state_->plan(std::span(&path, 1), settings), settings);
  }
  plan.configs.push_back(config_for(path, settings, *state_->files));
  const bool is_scene = is_scene_file(path, *state_->files, limits());
  PlannedFile& one = (is_scene ? plan.scenes : plan.models).emplace_back();
  one.path = path;
  one.is_named = true;
  return state_->run(plan, settings);
}

const SourceMap& Session::sources() const { return *state_->checked; }

std::string Session::baseline_of(const Report& report, const std::string& path) const {
  return write_baseline(report.diagnostics, *state_->checked, path);
}

void Session::announce(std::span<const std::string> paths, const CheckSettings& settings) {
  state_->announce(paths, settings);
}

void Session::forget_loaded() {
  state_->announced.clear();
  state_->announced_groups.clear();
  state_->loaded_with.clear();
  state_->loaded_sources = {};
  state_->expansions = std::make_shared<xacro::Expansions>();
  state_->read = std::make_shared<ReadFiles>();
}

const SourceMap& Session::loaded_sources() const { return state_->loaded_sources; }

LoadContext Session::context_of(Loaded& loaded) {
  LoadedWith& with = *loaded.loaded_with;
  const CheckGroup& group = with.group();
  Limits limits = state_->limits;
  limits.xacro_steps = state_->steps_of_each;
  return {state_->loaded_sources,
          *state_->files,
          loaded.found,
          limits,
          group.packages,
          group.settings.package_folders,
          group.settings.opens_meshes ? &with.meshes : nullptr,
          &group.config.schemas,
          state_->read,
          nullptr,
          group.settings.xacro,
          state_->expansions,
          group.ties};
}

LoadedExpansion Session::load_xacro(const std::string& path, const CheckSettings& settings) {
  LoadedExpansion loaded{state_->prepare(path, settings), {}};
  LoadContext context = context_of(loaded);
  state_->load(path, loaded, [&] { loaded.expansion = smurf::load_xacro(path, context); });
  return loaded;
}

LoadedModel Session::load_model(const std::string& path, const CheckSettings& settings) {
  LoadedModel loaded{state_->prepare(path, settings), {}};
  LoadContext context = context_of(loaded);
  state_->load(path, loaded, [&] { loaded.model = smurf::load_model(path, context); });
  return loaded;
}

LoadedScene Session::load_scene(const std::string& path, const CheckSettings& settings) {
  LoadedScene loaded{state_->prepare(path, settings), {}, {}};
  LoadContext context = context_of(loaded);
  state_->load(path, loaded, [&] {
    loaded.scene = smurf::load_scene(path, context);
    loaded.old_scenes = load_old_scenes(loaded.scene, context);
  });
  return loaded;
}

Report Session::check(LoadedModel& loaded) {
  Report report = state_->judge_in_time(loaded.model, loaded.model.path, loaded);
  report.summary.models = 1;
  return report;
}

Report Session::check(LoadedScene& loaded) {
  const std::vector<SceneFile>& files = loaded.scene.scenes;
  Report report =
      state_->judge_in_time(loaded.scene, files.empty() ? "" : files.front().path, loaded);
  report.summary.models = loaded.scene.models.size();
  report.summary.scenes = loaded.scene.scenes.size();
  return report;
}

std::vector<Diagnostic> Session::settle(const LoadedModel& loaded,
                                        std::vector<Diagnostic> found) const {
  return settle_others(loaded.model, std::move(found), *loaded.sources,
                       loaded.loaded_with->group().selection, *state_->expansions);
}

std::vector<Diagnostic> Session::settle(const LoadedScene& loaded,
                                        std::vector<Diagnostic> found) const {
  return settle_others(loaded.scene, std::move(found), *loaded.sources,
                       loaded.loaded_with->group().selection, *state_->expansions);
}

std::vector<Diagnostic> Session::settle(const LoadedScene& loaded, const LinkedModel& model,
                                        std::vector<Diagnostic> found) const {
  return settle_others(model, std::move(found), *loaded.sources,
                       loaded.loaded_with->group().selection, *state_->expansions);
}

const FileReader& Session::files() const { return *state_->files; }
const Limits& Session::limits() const { return state_->limits; }

}  // namespace smurf
