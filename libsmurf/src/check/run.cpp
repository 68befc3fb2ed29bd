// SPDX-License-Identifier: BSD-3-Clause
#include "check/run.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <initializer_list>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>

#include "base/files/canonical_paths.hpp"
#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/text/lists.hpp"
#include "check/given_arguments.hpp"
#include "check/in_time.hpp"
#include "check/load_planned.hpp"
#include "check/missing_packages.hpp"
#include "check/parallel.hpp"
#include "check/seen_companions.hpp"
#include "check/told_findings.hpp"
#include "check/with_variants.hpp"
#include "check/xacro_places.hpp"
#include "check/xacro_share.hpp"
#include "verdict/targets.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostParsed = 16U << 20U;  // bytes of texts; trees need five times as much

class Run {
 public:
  Run(const CheckSettings& settings, const RunContext& context, SourceMap& sources)
      : settings_(settings),
        context_(context),
        memory_(context.memory),
        sources_(sources),
        jobs_(count_of_jobs(settings.jobs)),
        shared_search_(std::make_shared<PackageSearch>(context.check.files, settings.folders)),
        seen_(context.check, *shared_search_),
        loader_{settings, context, seen_, shared_search_},
        given_(context.check) {}

  void configure(std::vector<std::string> configs) {
    if (configs.empty()) configs.emplace_back();
    if (!can_keep_configurations(configs)) read_configurations(configs);
    merge(settings_, context_.check.paths, memory_.groups);
    sources_ = memory_.sources;
    found_.resize(configs.size());
    targets_ = targets_of(memory_.groups);
  }

  /// A robot of xacro in the configuration is checked with each set of its arguments.
  std::vector<PlannedFile> with_variants(const std::vector<PlannedFile>& planned) {
    return smurf::with_variants(planned, memory_.groups, context_.check, found_);
  }

  /// Divides one budget among all expansions of the run.
  void share_steps(std::initializer_list<const std::vector<PlannedFile>*> all) {
    std::vector<std::string_view> paths;
    for (const auto* planned : all) {
      for (const PlannedFile& one : *planned) paths.push_back(one.path);
    }
    loader_.xacro_steps = xacro_steps_of_each(paths, context_.check.limits);
  }

  void check(const std::vector<PlannedFile>& planned) {
    std::vector<const PlannedFile*> left;
    for (const PlannedFile& file : planned) {
      if (read_.contains(identity_of(file.path))) {
        advance();
      } else {
        left.push_back(&file);
      }
    }
    if (is_over_ || is_cancelled_) return;
    std::vector<Outcome> outcomes(left.size());
    for_each_in_order(
        left.size(), jobs_,
        [&](std::size_t, std::size_t i) {
          if (is_cancelled()) return;
          outcomes[i] = check(*left[i]);
          advance();
        },
        [&](std::size_t i) {
          if (is_cancelled_) return false;
          Outcome outcome = is_remembering() ? copy_of(outcomes[i]) : std::move(outcomes[i]);
          take(std::move(outcome), *left[i]);
          return !is_over_;
        });
    if (is_remembering()) remember(left, std::move(outcomes));
  }

  Report finish(const Plan& plan) {
    if (!is_cancelled_) {
      std::erase_if(memory_.outcomes, [&](const auto& one) { return !used_.contains(one.first); });
    }
    for (CompanionFindings::Found& one : shared_.finish()) {
      found_[one.config].diagnostics.push_back(std::move(one.diagnostic));
    }
    seen_.report_broken(compared(), sources_, found_);
    seen_.report_misspelt(compared(), ties_of(memory_.groups), sources_, found_);
    given_.report(settings_.xacro.arguments, memory_.groups, sources_, found_);
    join_missing_packages(found_, sources_, context_.check.files);
    Report report = make_report(std::move(found_), memory_.groups, context_.check, sources_);
    report.summary.models = models_.size();
    report.summary.scenes = scenes_.size();
    for (const CompanionSpec& spec : companion_kinds()) {
      const auto count = std::count_if(companions_.begin(), companions_.end(),
                                       [&](const auto& one) { return one.second == spec.kind; });
      if (count == 0) continue;
      report.summary.companions.emplace_back(spec.title, static_cast<std::size_t>(count));
    }
    report.summary.robots_of_srdfs = std::move(robots_of_srdfs_);
    report.summary.assumptions = std::move(assumptions_);
    report.summary.not_compared = seen_.not_compared(compared(), ties_of(memory_.groups));
    report.problems = plan.problems;
    note_worst(report.diagnostics);
    report.robots = std::move(robots_);
    report.size = size_;
    report.is_stopped = is_stopped_ || is_cancelled_;
    if (plan.problems.empty()) return report;
    for (TargetVerdict& verdict : report.targets) {
      verdict.add_unknown(rules::sml0001_unreadable_file, plan.problems.size());
    }
    return report;
  }

  void see_companions(const Plan& plan) { seen_.read(plan); }

  /// Loads robots that nobody asked for, for companions that no robot has so far.
  void check_helpers() {
    const std::vector<PlannedFile> helpers = seen_.helpers(compared(), ties_of(memory_.groups));
    expected_ += helpers.size();
    check(with_variants(helpers));
  }

  /// Announces the number of files.
  void expect(std::size_t files) {
    expected_ = files;
    if (settings_.on_progress) settings_.on_progress(0, expected_);
  }
  void expect_robots(std::size_t count) { loader_.has_several_robots = count > 1; }

 private:
  bool is_remembering() const { return context_.snapshot != nullptr; }

  /// Files that a robot or a model has, by identity.
  std::set<std::string> compared() const {
    std::set<std::string> known = read_;
    for (const auto& [file, kind] : companions_) known.insert(file);
    return known;
  }

  std::string identity_of(const std::string& path) const {
    return identity(path, context_.check.paths, context_.check.files);
  }

  /// Called by several threads.
  bool is_cancelled() {
    if (settings_.is_cancelled && settings_.is_cancelled()) is_cancelled_ = true;
    return is_cancelled_;
  }

  void advance() {
    const std::size_t done = ++done_;
    if (settings_.on_progress) settings_.on_progress(done, expected_);
  }

  void remember(const std::vector<const PlannedFile*>& planned, std::vector<Outcome>&& outcomes) {
    for (std::size_t i = 0; i < planned.size(); ++i) {
      if (outcomes[i].answers.empty()) continue;  // not checked: a limit, or cancelled
      parsed_bytes_ += outcomes[i].parsed.bytes();
      if (parsed_bytes_ > kMostParsed) outcomes[i].parsed = {};
      const std::string key = key_of(*planned[i]);
      memory_.outcomes[key] = std::move(outcomes[i]);
      used_.insert(key);
    }
  }

  bool can_keep_configurations(const std::vector<std::string>& configs) const {
    return is_remembering() && !memory_.is_empty && memory_.configs == configs &&
           is_same(memory_.settings, settings_) &&
           is_unchanged(memory_.answers, *context_.snapshot);
  }

  void read_configurations(const std::vector<std::string>& configs) {
    memory_ = {};
    memory_.is_empty = !is_remembering();
    memory_.configs = configs;
    memory_.settings = settings_;
    if (is_remembering()) {
      Recorder recorder(*context_.snapshot);
      memory_.groups = smurf::read_configurations(configs, settings_, recorder, memory_.sources);
      memory_.answers = recorder.take();
    } else {
      memory_.groups =
          smurf::read_configurations(configs, settings_, context_.check.files, memory_.sources);
    }
  }

  /// Called by several threads.
  Outcome check(const PlannedFile& planned) {
    Outcome outcome;
    if (!is_remembering()) {
      load_in_time(planned, context_.check.files, shared_meshes_, outcome);
      return outcome;
    }
    const auto known = memory_.outcomes.find(key_of(planned));
    if (known != memory_.outcomes.end() && known->second.config == planned.config &&
        known->second.near == seen_.near()) {
      if (is_unchanged(known->second.answers, *context_.snapshot)) {
        return std::move(known->second);
      }
      outcome.parsed = std::move(known->second.parsed);
      keep_meshes(std::move(known->second), outcome);
    }
    Recorder recorder(*context_.snapshot);
    // What was stopped is not kept: its answers are empty, and the next check tries again.
    if (!load_in_time(planned, recorder, outcome.meshes, outcome)) return outcome;
    outcome.answers.merge(recorder.take());
    outcome.config = planned.config;
    outcome.near = seen_.near();
    return outcome;
  }

  /// The meshes of the last check, if only texts have changed.
  void keep_meshes(Outcome&& known, Outcome& outcome) const {
    std::erase_if(known.answers, [&](const auto& one) {
      return is_of_source(one.first, one.second, known.sources);
    });
    if (!is_unchanged(known.answers, *context_.snapshot)) return;
    outcome.meshes = std::move(known.meshes);
    outcome.answers = std::move(known.answers);
  }

  /// False if the file takes too long; the outcome is then only that.
  bool load_in_time(const PlannedFile& planned, const FileReader& files, MeshLibrary& meshes,
                    Outcome& outcome) {
    return run_in_time(
        settings_.max_seconds, [&] { loader_.load(planned, files, meshes, outcome); },
        [&] {
          is_stopped_ = true;
          outcome = outcome_out_of_time(planned, identity_of(planned.path), settings_.max_seconds,
                                        memory_.sources);
        });
  }

  /// Records the files that were read for an outcome. Thousands of models may share one large URDF,
  /// and each checks it again; returns false if that exceeds the limit.
  bool has_room(const Outcome& outcome) {
    std::set<SourceId> again;
    for (std::size_t i = memory_.sources.size(); i < outcome.sources.size(); ++i) {
      const SourceId source{static_cast<std::uint32_t>(i)};
      if (sources_read_.insert(identity_of(outcome.sources.path(source))).second) continue;
      again.insert(source);
      rechecked_ += outcome.sources.text(source).size();
    }
    for (const Diagnostic& diagnostic : outcome.judged.diagnostics) {
      if (again.contains(diagnostic.span.source)) rechecked_ += kBytesOfFinding;
    }
    return rechecked_ <= context_.check.limits.rechecked_bytes;
  }

  /// Records findings. A file that is checked alone has its own limit, in the sink.
  bool has_room_for_findings(const Outcome& outcome) {
    const bool is_first = count_found_ == 0;
    count_found_ += outcome.judged.diagnostics.size();
    return is_first || count_found_ <= context_.check.limits.all_findings;
  }

  /// `excess` names the exceeded limit: "more than 3 bytes are read".
  void end_with(const PlannedFile& planned, const std::string& excess, std::string_view limit) {
    is_over_ = true;
    DiagnosticSink sink;
    const Span place{sources_.add_unreadable(path::normalize(planned.path)), 0, 0};
    sink.report(rules::sml0002_file_too_large, place,
                "with this file, " + excess + "; this file and all later ones were not checked")
        .help(raise_limit(limit));
    append(sink.take(), found_[planned.config].diagnostics);
  }

  /// Records a robot or scene, one of several, and what each target makes of it. As for the
  /// verdicts on all files, comments and the baseline do not count.
  void judge_robot(const Outcome& outcome, const PlannedFile& planned) {
    if (expected_ < 2 || (outcome.models.empty() && outcome.scenes.empty())) return;
    RobotAnswers& robot = robots_.emplace_back();
    const std::string shown = shown_arguments(planned);
    robot.path = planned.path + (shown.empty() ? "" : " " + shown);
    robot.is_unknown = !outcome.notes.unknown_robot.empty();
    OfRobot& of_robot = places_.emplace_back();
    of_robot.path = planned.path;
    for (const Diagnostic& one : outcome.judged.diagnostics) {
      const std::string file = identity_of(sources_.path(one.span.source));
      // A launch file starts many things, and its faults are not those of the robot.
      if (outcome.surroundings.contains(file)) continue;
      of_robot.places.push_back({{one.rule, sources_.path(one.span.source), one.span.begin},
                                 outcome.companions.contains(file) ? file : ""});
    }
    if (targets_.empty()) return;
    const RuleSelection& selection = memory_.groups[planned.config].selection;
    const std::vector<Diagnostic> found =
        apply_selection(std::vector(outcome.judged.diagnostics), sources_, selection);
    for (const Reader* target : targets_) {
      robot.answers.push_back(judge_target(*target, found).answer());
    }
  }

  /// Comments, a baseline and other robots with the same companions may have removed findings.
  /// Those in a companion count for the robots that it belongs to.
  void note_worst(std::span<const Diagnostic> left) {
    std::map<Found, Severity> severities;
    for (const Diagnostic& one : left) {
      const Found place{one.rule, sources_.path(one.span.source), one.span.begin};
      Severity& severity = severities.try_emplace(place, one.severity).first->second;
      severity = std::max(severity, one.severity);
    }
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      for (const Place& place : places_[i].places) {
        const auto severity = severities.find(place.found);
        if (severity == severities.end()) continue;
        const bool is_own =
            place.companion.empty() || shared_.belongs_to(place.companion, places_[i].path);
        if (!is_own) continue;
        robots_[i].worst = std::max(robots_[i].worst.value_or(Severity::info), severity->second);
      }
    }
  }

  /// Says for which targets not the file itself was judged.
  void note_made_urdfs(const std::set<Language>& languages) {
    for (const Language language : languages) {
      const Circumstance* mark = mark_of(language);
      if (mark == nullptr) continue;
      std::vector<std::string> others;
      for (const Reader* target : targets_) {
        if (!reads_itself(*target, *mark)) others.emplace_back(target->name);
      }
      if (others.empty()) continue;
      const std::string name = language == Language::mjcf ? "MJCF" : "SDF";
      assumptions_.insert("URDFs that smurf2urdf makes of " + name + " files, for " +
                          enumerated(others));
    }
  }

  void take(Outcome&& outcome, const PlannedFile& planned) {
    const Limits& limits = context_.check.limits;
    if (!has_room(outcome)) {
      return end_with(planned,
                      "more than " + std::to_string(limits.rechecked_bytes) +
                          " bytes of files that were read before are checked again",
                      "rechecked-bytes");
    }
    if (!has_room_for_findings(outcome)) {
      return end_with(planned,
                      "there are more than " + std::to_string(limits.all_findings) + " findings",
                      "all-findings");
    }
    const std::size_t common = memory_.sources.size();
    const SourceShift by = sources_.take(std::move(outcome.sources), common);
    for (Diagnostic& diagnostic : outcome.judged.diagnostics) shift(diagnostic, by);
    judge_robot(outcome, planned);
    for (const auto& [file, claim] : outcome.companions) companions_.emplace(file, claim.kind);
    robots_of_srdfs_.merge(outcome.notes.robots_of_srdfs);
    if (!size_) size_ = outcome.notes.size;
    if (!outcome.notes.assumption.empty()) assumptions_.insert(outcome.notes.assumption);
    note_made_urdfs(outcome.notes.languages);
    for (const auto& [file, one] : outcome.notes.rejected) seen_.add_rejected(file, one);
    if (!is_companion_path(planned.path) && (!outcome.models.empty() || !outcome.scenes.empty())) {
      given_.take(planned.path, planned.config, outcome.notes.arguments,
                  outcome.notes.unknown_robot.empty());
    }
    if (!outcome.notes.unknown_robot.empty()) seen_.add_unknown_robot(outcome.notes.unknown_robot);
    const auto file_of = [&](const Diagnostic& one) {
      return identity_of(sources_.path(one.span.source));
    };
    shared_.take(outcome.companions, planned.path, planned.config,
                 !shown_arguments(planned).empty(), file_of, outcome.judged.diagnostics);
    told_.leave_new(outcome.surroundings, file_of, outcome.judged.diagnostics);
    append(std::move(outcome.judged.diagnostics), found_[planned.config].diagnostics);
    found_[planned.config].comments.take(std::move(outcome.judged.comments), by);
    models_.merge(outcome.models);
    scenes_.merge(outcome.scenes);
    read_.merge(outcome.read);
  }

  const CheckSettings& settings_;
  const RunContext& context_;
  Memory& memory_;
  SourceMap& sources_;
  const std::size_t jobs_;
  MeshLibrary shared_meshes_;                        ///< of all threads, if nothing is kept
  std::shared_ptr<PackageSearch> shared_search_;     ///< the same
  std::vector<Judged> found_;                        ///< by configuration
  std::set<std::string> models_, scenes_, read_;     ///< by identity
  std::map<std::string, CompanionKind> companions_;  ///< by identity
  std::set<std::string> robots_of_srdfs_;            ///< see Summary
  ToldFindings told_;                                ///< in the surroundings of robots
  std::set<std::string> assumptions_;                ///< see Summary
  SeenCompanions seen_;                              ///< of the plan
  PlannedLoader loader_;
  GivenArguments given_;                ///< of the robots
  CompanionFindings shared_;            ///< findings in them
  std::set<std::string> sources_read_;  ///< by identity
  std::uint64_t rechecked_ = 0;         ///< bytes of files that were read before
  std::uint64_t count_found_ = 0;       ///< before settings and comments are applied
  bool is_over_ = false;                ///< the remaining files are not checked
  std::set<std::string> used_;          ///< paths of the outcomes used here
  std::size_t parsed_bytes_ = 0;        ///< of the texts whose trees are kept
  std::atomic<bool> is_cancelled_ = false;
  std::atomic<bool> is_stopped_ = false;  ///< a file took too long
  std::atomic<std::size_t> done_ = 0;
  std::size_t expected_ = 0;
  std::vector<const Reader*> targets_;
  std::vector<RobotAnswers> robots_;
  /// The rule, the path and the byte of a finding.
  using Found = std::tuple<const Rule*, std::string, std::uint32_t>;
  struct Place {
    Found found;
    std::string companion;  ///< in which it is, by identity; empty for other files
  };
  struct OfRobot {
    std::string path;
    std::vector<Place> places;
  };
  std::vector<OfRobot> places_;    ///< of each robot
  std::optional<RobotSize> size_;  ///< see Report
};

}  // namespace

Report run_check(const Plan& plan, const CheckSettings& settings, const RunContext& context,
                 SourceMap& sources) {
  Run run(settings, context, sources);
  run.configure(plan.configs);
  run.expect(plan.scenes.size() + plan.models.size() + plan.others.size());
  std::vector<PlannedFile> others = plan.others;
  const auto first_companion =
      std::stable_partition(others.begin(), others.end(),
                            [](const PlannedFile& one) { return !is_companion_path(one.path); });
  const std::vector<PlannedFile> companions(first_companion, others.end());
  others.erase(first_companion, others.end());
  run.expect_robots(plan.models.size() + others.size());
  run.see_companions(plan);
  const std::vector<PlannedFile> scenes = run.with_variants(plan.scenes);
  const std::vector<PlannedFile> models = run.with_variants(plan.models);
  const std::vector<PlannedFile> of_others = run.with_variants(others);
  const std::vector<PlannedFile> of_companions = run.with_variants(companions);
  run.share_steps({&scenes, &models, &of_others, &of_companions});
  for (const auto* planned : {&scenes, &models, &of_others}) run.check(*planned);
  run.check_helpers();
  run.check(of_companions);
  return run.finish(plan);
}

}  // namespace smurf
