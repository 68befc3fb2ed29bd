// SPDX-License-Identifier: BSD-3-Clause
// From paths to findings: what smurf-lint reports, for programs.
//
//     smurf::Session session;
//     const smurf::Report report = session.check("arm.smurf");
//     for (const smurf::Diagnostic& d : report.diagnostics) {
//       std::cout << smurf::render_concise(d, session.sources());
//     }
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/diagnostic.hpp"
#include "smurf/file_reader.hpp"
#include "smurf/limits.hpp"
#include "smurf/linked.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"
#include "smurf/old_scene.hpp"
#include "smurf/plan.hpp"
#include "smurf/render.hpp"
#include "smurf/source.hpp"

namespace smurf {

class CompanionFolders;

/// The default of CheckSettings::max_seconds: twelve times what a file of ten megabytes may take.
inline constexpr std::uint64_t kMaxSeconds = 120;

/// Settings of a check, which override those of a configuration.
struct CheckSettings {
  std::string config;        ///< a file; "": the nearest configuration above the checked file
  bool is_isolated = false;  ///< read no configuration
  /// Names that `format` of a configuration may have; empty: any.
  std::vector<std::string> formats;

  RuleSelection selection;
  std::map<std::string, std::string> packages;  ///< package:// names to folders
  std::vector<std::string> package_folders = ros_package_folders();
  XacroSettings xacro;  ///< arguments override those of a configuration
  bool opens_meshes = true;
  /// Whether a session that reads from the disk follows models to files anywhere. When false, it
  /// reads only what confine() (smurf/confine.hpp) allows.
  bool allows_outside = false;

  bool heeds_comments = true;  ///< comments suppress findings
  bool heeds_baseline = true;  ///< the baseline suppresses findings
  std::string baseline;        ///< a file; "": the baseline named in the configuration
  unsigned jobs = 0;           ///< threads; 0: as many as the machine has
  /// Seconds of processor time for each file that is named or found, with all that it loads; 0: no
  /// end. A file that takes longer is left, with a finding (SML0002): the limits bound all work
  /// that is known, and this bounds the rest.
  std::uint64_t max_seconds = kMaxSeconds;
  /// Keep data for the next check. Uses memory, and changes no result.
  bool remembers = true;
  /// Set by what checks many files of a folder one by one, while no file changes; null: each check
  /// lists the folder.
  std::shared_ptr<CompanionFolders> folders;
  /// Called with 0 first, then after each file, possibly from several threads.
  std::function<void(std::size_t done, std::size_t of)> on_progress;
  /// Called before each file, possibly from several threads. True ends the check: its report lacks
  /// the files that were not checked yet.
  std::function<bool()> is_cancelled;
};

/// The lowest severity that fails a check.
struct FailOn {
  std::optional<Severity> least;  ///< none: never
};

/// Settings of the configuration of the first path that concern the report.
struct ReportSettings {
  std::vector<std::string> formats;  ///< "FORMAT[=FILE]"
  std::optional<FailOn> fail_on;
  std::optional<int> max_warnings;
  std::string baseline;  ///< a file; the setting overrides it
};

/// The result of a check.
struct Report {
  std::vector<Diagnostic> diagnostics;  ///< sorted, without repetitions
  Summary summary;
  /// One verdict per target of the settings and all configurations, including suppressed findings.
  std::vector<TargetVerdict> targets;
  std::vector<RobotAnswers> robots;   ///< when several files were planned
  std::optional<RobotSize> size;      ///< of the first robot that could be read
  std::vector<std::string> problems;  ///< of the plan
  ReportSettings settings;
  /// A file took too long, or the check was cancelled: another check may find more.
  bool is_stopped = false;
};

struct LoadedWith;

/// A loaded model or scene, and the findings of reading it. Points into the sources of its session,
/// which must outlive it.
struct Loaded {
  const SourceMap* sources = nullptr;
  DiagnosticSink found;
  LoadedWith* loaded_with = nullptr;  ///< the settings, the configuration and the meshes
};
/// The result of Session::load_model().
struct LoadedModel : Loaded {
  LinkedModel model;
};
/// The result of Session::load_xacro().
struct LoadedExpansion : Loaded {
  xacro::Expansion expansion;
};
/// The result of Session::load_scene().
struct LoadedScene : Loaded {
  LinkedScene scene;
  OldScenes old_scenes;
};

/// Whether a text is a baseline that Session::baseline_of() made.
bool is_baseline(std::string_view text);

/// Detects changes of a file without reading it.
struct FileStamp {
  std::string text;         ///< empty: unknown
  bool is_settled = false;  ///< false: the file may change again without a new stamp
};
using StampOf = std::function<FileStamp(const std::string& path)>;
/// From the times and the size of the file.
FileStamp stamp_on_disk(const std::string& path);

/// Files on disk, unsaved texts that replace them, and results kept between checks. Use it in one
/// thread; a check starts several.
class Session {
 public:
  /// Reads from disk, within the projects of the files that the caller names.
  explicit Session(const Limits& limits = {});
  /// Reads from `files`, which must outlive it. Without stamps, a second check reads all files
  /// again and compares them.
  explicit Session(const FileReader& files, const Limits& limits = {}, StampOf stamp_of = {});
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Replaces the text of a file, which need not exist.
  void set_text(const std::string& path, std::string text);
  void clear_text(const std::string& path);

  /// Checks one file with all files that it loads (a .smurf, .smurfs, .smurfa, .svg, .urdf, .xacro
  /// or annotation file), or the files in a folder on disk, as make_plan() finds them.
  Report check(const std::string& path, const CheckSettings& settings = {});
  /// Checks the files that `smurf-lint PATH...` checks. The paths are files and folders.
  Report check(std::span<const std::string> paths, const CheckSettings& settings = {});
  /// What check() of these files and folders checks.
  Plan plan(std::span<const std::string> paths, const CheckSettings& settings = {});
  /// Checks a plan: scenes, models that no scene loads, and other files that no model loads.
  Report check(const Plan& plan, const CheckSettings& settings = {});
  /// The texts of the last check; its findings point into them.
  const SourceMap& sources() const;
  /// The text of a baseline file at `path` with the findings of the last check.
  std::string baseline_of(const Report& report, const std::string& path) const;

  /// Loads a .smurf, a .urdf or an annotation file.
  LoadedModel load_model(const std::string& path, const CheckSettings& settings = {});
  /// Expands a xacro file. Its findings are in `found`, with places in the xacro files.
  LoadedExpansion load_xacro(const std::string& path, const CheckSettings& settings = {});
  /// Loads a scene; a .smurf or .urdf is loaded as a scene of one model.
  LoadedScene load_scene(const std::string& path, const CheckSettings& settings = {});
  /// Allows these files to be loaded, each once. Announcing all of them first is faster: links are
  /// followed and configurations are read only once. Loaded models stay valid; reading their files
  /// again does not count as repeated reading.
  void announce(std::span<const std::string> paths, const CheckSettings& settings = {});
  /// Releases all loaded results; they must not be used afterwards.
  void forget_loaded();
  /// The texts of all loaded files, also `Loaded::sources`.
  const SourceMap& loaded_sources() const;
  /// For reading other files, such as an SRDF, into the same sources and findings.
  LoadContext context_of(Loaded& loaded);
  /// Checks loaded files. Findings in `loaded.found` are included in the report.
  Report check(LoadedModel& loaded);
  Report check(LoadedScene& loaded);
  /// Makes a report of findings from other code: locates and sorts them and applies the
  /// settings.
  std::vector<Diagnostic> settle(const LoadedModel& loaded, std::vector<Diagnostic> found) const;
  std::vector<Diagnostic> settle(const LoadedScene& loaded, std::vector<Diagnostic> found) const;
  /// Checks only the files of one model of the scene, in a time that does not depend on the
  /// scene.
  std::vector<Diagnostic> settle(const LoadedScene& loaded, const LinkedModel& model,
                                 std::vector<Diagnostic> found) const;

  /// Reads the disk or the given reader, archives as folders, and the unsaved texts.
  const FileReader& files() const;
  const Limits& limits() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace smurf
