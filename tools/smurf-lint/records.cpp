// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/records.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "common/cli/progress.hpp"
#include "common/files/new_file.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/check.hpp"
#include "smurf/each.hpp"

namespace smurf::tools {
namespace {

constexpr std::string_view kRecordBegin = "{\"path\":";
constexpr std::size_t kLongestLine = 64U << 20U;  // bytes: more is no record of one robot

/// Calls `take` with each line of a file, until it returns false, and returns what comes after the
/// last line end; nothing if the file is absent.
std::string for_each_line(const std::string& path,
                          const std::function<bool(const std::string&)>& take) {
  std::string line, buffer(1U << 16U, '\0');
  const int number = sys::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (number < 0) return line;
  bool goes_on = true;
  for (ssize_t count = 0; goes_on && line.size() < kLongestLine &&
                          (count = sys::read(number, buffer.data(), buffer.size())) > 0;) {
    std::string_view left(buffer.data(), static_cast<std::size_t>(count));
    for (std::size_t end = left.find('\n'); goes_on && end != left.npos; end = left.find('\n')) {
      line += left.substr(0, end);
      goes_on = take(line);
      line.clear();
      left.remove_prefix(end + 1);
    }
    line += left;
  }
  sys::close(number);
  return line;
}

/// Whether a run that was stopped may have left this at the end of its records.
bool may_be_unfinished(std::string_view line) {
  return line.size() < kLongestLine &&
         line.substr(0, kRecordBegin.size()) == kRecordBegin.substr(0, line.size());
}

/// The records of an earlier run.
struct OldRecords {
  std::set<std::string> paths;
  std::uint64_t bytes = 0;        ///< of the lines that are complete
  std::set<std::string> targets;  ///< of the first record
  Summary summary;                ///< of all: the end is that of a run without a stop
};

/// The record in a line; none if it is something else.
std::optional<nlohmann::json> record_in(const std::string& line) {
  if (!line.starts_with(kRecordBegin)) return std::nullopt;
  nlohmann::json record = nlohmann::json::parse(line, nullptr, false);
  const auto has = [&](const char* key, nlohmann::json::value_t type) {
    return record.is_object() && record.contains(key) && record[key].type() == type;
  };
  using Type = nlohmann::json::value_t;
  if (!has("path", Type::string) || !has("loads", Type::object) || !has("counts", Type::object))
    return std::nullopt;
  const nlohmann::json& counts = record["counts"];
  const bool are_numbers = std::all_of(counts.begin(), counts.end(),
                                       [](const auto& one) { return one.is_number_unsigned(); });
  if (!are_numbers) return std::nullopt;
  return record;
}

/// Reads the records in `path`. A run that was stopped leaves a last line without a line end, which
/// does not count. A line that is no record is reported; the result is then none.
std::optional<OldRecords> read_records(const std::string& path) {
  OldRecords old;
  std::size_t number = 0;
  bool are_records = true;
  const std::string rest = for_each_line(path, [&](const std::string& line) {
    ++number;
    const auto record = record_in(line);
    are_records = record.has_value();
    if (!are_records) return false;
    if (number == 1) {
      for (const auto& [target, answer] : (*record)["loads"].items()) old.targets.insert(target);
    }
    const nlohmann::json& counts = (*record)["counts"];
    old.summary.errors += counts.value("errors", std::size_t{0});
    old.summary.warnings += counts.value("warnings", std::size_t{0});
    old.summary.infos += counts.value("infos", std::size_t{0});
    old.paths.insert((*record)["path"].get<std::string>());
    old.bytes += line.size() + 1;
    return true;
  });
  if (are_records && !may_be_unfinished(rest)) {
    are_records = false;
    ++number;
  }
  if (are_records) return old;
  complain(kSmurfLint, "line " + std::to_string(number) + " of '" + path +
                           "' is no record of --format jsonl; name another file");
  return std::nullopt;
}

/// Whether a file may be replaced: it is absent, empty, no file, or has records.
bool may_be_replaced(const std::string& path) {
  if (!places::is_plain_file(places::canonical(path).value_or(path))) return true;
  const bool is_empty = DiskFiles().read(path, 0).status == ReadStatus::ok;
  bool has_record = false;
  for_each_line(path, [&](const std::string& line) {
    has_record = record_in(line).has_value();
    return false;
  });
  return is_empty || has_record;
}

/// Where the lines go.
class RecordFile {
 public:
  RecordFile() = default;
  ~RecordFile() {
    if (number_ >= 0) sys::close(number_);
  }
  RecordFile(const RecordFile&) = delete;
  RecordFile& operator=(const RecordFile&) = delete;

  /// Opens a file that keeps its first bytes; "-" and "" are standard output. False, after a
  /// report, if it cannot be written.
  bool open(const std::string& path, std::uint64_t kept_bytes) {
    if (path.empty() || path == "-") return true;
    path_ = path;
    number_ = sys::open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NOCTTY, 0666);
    if (number_ < 0) return fail(errno);
    const bool is_cut = sys::ftruncate(number_, static_cast<off_t>(kept_bytes)) == 0;
    return is_cut || errno == EINVAL || fail(errno);  // a device has no length
  }

  bool write(const std::string& line) const {
    if (number_ < 0) return write_output(kSmurfLint, "-", line);
    const int error = write_all(number_, line);
    return error == 0 || fail(error);
  }

 private:
  bool fail(int error) const {
    complain(kSmurfLint, "cannot write '" + path_ + "': " + sys::error_text(error));
    return false;
  }

  std::string path_;
  int number_ = -1;
};

/// The record of one robot, and what the exit code depends on.
struct Answered {
  std::string line;  ///< "": it is only a part of robots
  std::size_t errors = 0, warnings = 0, infos = 0;
  std::set<std::string> targets;
  ReportSettings settings;  ///< only what judge() needs
};

constexpr std::string_view kAnswerForm = "record 1";
constexpr int kNever = -1;  // of FailOn

/// An answer for a cache: what is not in the record, and the record.
std::string text_of(const Answered& one) {
  nlohmann::json head = {{"errors", one.errors},
                         {"warnings", one.warnings},
                         {"infos", one.infos},
                         {"targets", one.targets}};
  const ReportSettings& settings = one.settings;
  if (settings.max_warnings) head["max_warnings"] = *settings.max_warnings;
  if (settings.fail_on) {
    const auto least = settings.fail_on->least;
    head["fail_on"] = least ? static_cast<int>(*least) : kNever;
  }
  return head.dump() + '\n' + one.line;
}

/// None if it is another text.
std::optional<Answered> answer_in(const std::string& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  try {
    const nlohmann::json head =
        nlohmann::json::parse(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end));
    Answered one;
    one.line = text.substr(std::min(end + 1, text.size()));
    one.errors = head.at("errors").get<std::size_t>();
    one.warnings = head.at("warnings").get<std::size_t>();
    one.infos = head.at("infos").get<std::size_t>();
    one.targets = head.at("targets").get<std::set<std::string>>();
    if (head.contains("max_warnings")) one.settings.max_warnings = head["max_warnings"].get<int>();
    if (!head.contains("fail_on")) return one;
    const int least = head["fail_on"].get<int>();
    one.settings.fail_on.emplace();
    if (least != kNever) one.settings.fail_on->least = Severity{static_cast<std::uint8_t>(least)};
    return one;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  }
}

/// Those of another form are not found in a cache.
std::string answer_form(const LintOptions& options) {
  const auto& least = options.min_severity;
  return std::string(kAnswerForm) + (least ? " " + std::string(to_string(*least)) : "");
}

CheckSettings record_settings(const LintOptions& options) {
  CheckSettings settings = check_settings(options);
  settings.allows_outside = options.allow_outside;
  return settings;
}

/// The check of one robot, or what a cache says about it.
Answered answer_about(const std::string& path, EachCheck check, const LintOptions& options) {
  if (const auto known = check.known()) {
    if (auto answered = answer_in(*known)) return *std::move(answered);
  }
  Answered answered;
  Report report = check.check();
  if (!check.is_only_part()) {
    if (options.min_severity) leave_out_below(*options.min_severity, report);
    answered.line = render_record({.path = path,
                                   .diagnostics = report.diagnostics,
                                   .summary = report.summary,
                                   .targets = report.targets,
                                   .size = report.size,
                                   .digest = check.digest()},
                                  check.sources());
    for (const TargetVerdict& one : report.targets) answered.targets.emplace(one.reader->name);
    answered.errors = report.summary.errors;
    answered.warnings = report.summary.warnings;
    answered.infos = report.summary.infos;
    answered.settings.fail_on = report.settings.fail_on;
    answered.settings.max_warnings = report.settings.max_warnings;
  }
  check.keep(text_of(answered));
  return answered;
}

/// Why the records of another run cannot be continued; empty if they can.
std::string why_not_continued(const OldRecords& old, const std::set<std::string>& targets) {
  if (old.paths.empty() || old.targets == targets) return {};
  const auto names = [](const std::set<std::string>& all) {
    std::string text;
    for (const std::string& one : all) text += (text.empty() ? "" : ",") + one;
    return text.empty() ? "without a target" : "with --target " + text;
  };
  return "was written " + names(old.targets) + ", and this run is " + names(targets) +
         "; use the same settings, or another file";
}

/// Nothing to write is a mistake in the paths: an empty file would look like a data set without
/// findings.
std::string why_no_records(const LintOptions& options) {
  std::string place = "the named files and folders";
  if (options.paths.size() < 2)
    place = "'" + (options.paths.empty() ? "." : options.paths.front()) + "'";
  return "no robot or scene in " + place +
         ", and records are about them; leave out --format jsonl, --resume and --cache to check "
         "other files";
}

bool is_records(const ReportRequest& one) { return one.format->name == kRecords; }

/// `input` is the text of standard input, if the plan has it.
ExitCode write_records(const LintOptions& options, const LintPlan& plan, std::string input) {
  const bool is_resumed = !options.resume.empty();
  std::string place = is_resumed ? options.resume : options.reports.front().file;
  if (place.empty()) place = options.output;
  std::optional<OldRecords> old = OldRecords{};
  if (is_resumed) {
    old = read_records(place);
    if (!old) return kFailed;
  } else if (!place.empty() && place != "-" && !may_be_replaced(place)) {
    complain(kSmurfLint, "cannot write '" + place +
                             "': it has something else than records; name "
                             "another file, or delete it");
    return kFailed;
  }
  EachChecks checks(plan, record_settings(options), options.limits);
  checks.leave_out([&](const PlannedFile& one) { return old->paths.contains(one.path); });
  if (!plan.standard_input.empty()) checks.set_text(plan.standard_input, std::move(input));
  if (!options.cache.empty()) checks.use_cache(options.cache, answer_form(options));
  const std::vector<EachFile>& each = checks.files();
  RecordFile out;
  bool is_open = false;
  bool is_failed = false;
  Summary all = old->summary;
  Threshold threshold = options.threshold;
  Progress progress("checked", each.size(), options.quiet);
  std::vector<std::unique_ptr<Answered>> answers(each.size());  // those that wait to be written
  for_each_of(
      each.size(), static_cast<unsigned>(options.jobs.value_or(0)),
      [&](std::size_t i) {
        answers[i] =
            std::make_unique<Answered>(answer_about(each[i].planned->path, checks.of(i), options));
        progress.advance();
      },
      [&](std::size_t i) {
        const auto answer = std::move(answers[i]);
        const Answered& one = *answer;
        if (one.line.empty()) return true;
        if (!is_open) {
          const std::string reason = why_not_continued(*old, one.targets);
          if (!reason.empty()) complain(kSmurfLint, "'" + place + "' " + reason);
          is_open = reason.empty() && out.open(place, old->bytes);
          threshold = merge_run(one.settings, options).threshold;
        }
        all.errors += one.errors;
        all.warnings += one.warnings;
        all.infos += one.infos;
        is_failed = !is_open || !out.write(one.line);
        return !is_failed;
      });
  if (!is_open && !is_failed && old->paths.empty() && plan.problems.empty()) {
    complain(kSmurfLint, why_no_records(options));
    return kFailed;
  }
  if (!is_open && !is_failed && !out.open(place, old->bytes)) is_failed = true;
  if (const std::string problem = checks.cache_problem(); !problem.empty()) {
    complain(kSmurfLint, "--cache: " + problem + "; the records are complete without it");
  }
  return is_failed || !plan.problems.empty() ? kFailed : judge(all, threshold);
}

}  // namespace

bool writes_records(const LintOptions& options) {
  return !options.resume.empty() ||
         std::any_of(options.reports.begin(), options.reports.end(), is_records);
}

std::vector<Option> record_options(LintOptions& options) {
  return {
      {.group = "Output",
       .name = "resume",
       .metavar = "FILE",
       .help =
           "Write records (--format jsonl) to FILE for robots that have none there: goes on after "
           "a run that was stopped.",
       .set = set_text(options.resume)},
      {.group = "Output",
       .name = "cache",
       .metavar = "DIR",
       .help =
           "Keep records (--format jsonl) in this folder, and check only robots for which a file, the "
           "settings or the version has changed since.",
       .set = set_text(options.cache)},
  };
}

std::optional<std::string> records_conflict(const LintOptions& options) {
  if (!writes_records(options)) {
    if (options.cache.empty()) return std::nullopt;
    return "--cache keeps only the records of --format jsonl: write --format jsonl or --resume FILE, "
           "or leave --cache out";
  }
  const bool is_resumed = !options.resume.empty();
  if (is_resumed && (!options.reports.empty() || !options.output.empty())) {
    return "--resume FILE says where the records go; leave out --format and --output";
  }
  if (options.reports.size() > 1) {
    return "--format jsonl is written while robots are checked, and alone";
  }
  if (options.fix || options.fix_only || options.diff || options.fix_inertia ||
      options.renames_names() || options.generate_baseline || options.watch || options.opens) {
    return "--format jsonl only reports; make changes in another run";
  }
  return std::nullopt;
}

ExitCode run_records(const LintOptions& options) {
  LintPlan plan;
  std::string input;
  {  // what the readers remember about a data set is as large as the plan
    ConfinedFiles disk;
    confine_to_inputs(disk, options);
    const ArchiveFiles archives(disk, options.limits);
    MemoryFiles files(&archives);
    if (!can_read_named(options, files)) return kFailed;
    plan = make_plan(options, files);
    const std::string& name = plan.standard_input;
    if (!name.empty()) input = files.read(name, options.limits.file_bytes).text;
  }
  return write_records(options, plan, std::move(input));
}

}  // namespace smurf::tools
