// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/records.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "common/cli/progress.hpp"
#include "common/files/new_file.hpp"
#include "smurf-lint/settings.hpp"
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
  Summary summary;
  Threshold threshold;
  std::set<std::string> targets;
};

class RecordRun {
 public:
  RecordRun(const LintOptions& options, const LintPlan& plan, const FileReader& given)
      : options_(options), plan_(plan), settings_(check_settings(options)) {
    settings_.jobs = 1;
    settings_.remembers = false;
    const std::string& name = plan.standard_input;
    if (!name.empty()) text_ = given.read(name, options.limits.file_bytes).text;
  }

  Answered check(const EachFile& file) const {
    CheckSettings settings = settings_;
    settings.folders = folder_.of(file);
    LintPlan alone;
    static_cast<Plan&>(alone) = plan_of(file, plan_);
    // A reader of its own: what it remembers about folders and links would grow with the robots.
    ConfinedFiles files;
    confine_to_found(files, options_, alone);
    Session session(files, options_.limits);
    if (!plan_.standard_input.empty()) session.set_text(plan_.standard_input, text_);
    Report report = session.check(alone, settings);
    if (is_only_part(file, report)) return {};
    if (options_.min_severity) leave_out_below(*options_.min_severity, report);
    Answered answered;
    answered.line = render_record({.path = file.planned->path,
                                   .diagnostics = report.diagnostics,
                                   .summary = report.summary,
                                   .targets = report.targets,
                                   .size = report.size},
                                  session.sources());
    for (const TargetVerdict& one : report.targets) answered.targets.emplace(one.reader->name);
    answered.threshold = merge_run(report.settings, options_).threshold;
    answered.summary = std::move(report.summary);
    return answered;
  }

 private:
  const LintOptions& options_;
  const LintPlan& plan_;
  CheckSettings settings_;
  mutable SharedFolder folder_;
  std::string text_;  ///< of standard input
};

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

bool is_records(const ReportRequest& one) { return one.format->name == kRecords; }

}  // namespace

bool writes_records(const LintOptions& options) {
  return !options.resume.empty() ||
         std::any_of(options.reports.begin(), options.reports.end(), is_records);
}

std::optional<std::string> records_conflict(const LintOptions& options) {
  if (!writes_records(options)) return std::nullopt;
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

ExitCode write_records(const LintOptions& options, const LintPlan& plan, const FileReader& given) {
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
  std::vector<EachFile> each = each_file(plan);
  std::erase_if(each, [&](const EachFile& one) { return old->paths.contains(one.planned->path); });

  const RecordRun run(options, plan, given);
  RecordFile out;
  bool is_open = false;
  bool is_failed = false;
  Summary all = old->summary;
  Threshold threshold = options.threshold;
  Progress progress("checked", each.size(), options.quiet);
  std::vector<Answered> answers(each.size());
  for_each_of(
      each.size(), static_cast<unsigned>(options.jobs.value_or(0)),
      [&](std::size_t i) {
        answers[i] = run.check(each[i]);
        progress.advance();
      },
      [&](std::size_t i) {
        const Answered one = std::move(answers[i]);
        answers[i] = {};
        if (one.line.empty()) return true;
        if (!is_open) {
          const std::string reason = why_not_continued(*old, one.targets);
          if (!reason.empty()) complain(kSmurfLint, "'" + place + "' " + reason);
          is_open = reason.empty() && out.open(place, old->bytes);
          threshold = one.threshold;
        }
        all.errors += one.summary.errors;
        all.warnings += one.summary.warnings;
        all.infos += one.summary.infos;
        is_failed = !is_open || !out.write(one.line);
        return !is_failed;
      });
  if (!is_open && !is_failed && !out.open(place, old->bytes)) is_failed = true;
  return is_failed || !plan.problems.empty() ? kFailed : judge(all, threshold);
}

}  // namespace smurf::tools
