// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/fix.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <iterator>
#include <utility>
#include <vector>

#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/text/counted.hpp"
#include "render/printable.hpp"
#include "smurf-lint/line_diff.hpp"
#include "smurf/confine.hpp"
#include "smurf/fix.hpp"

namespace smurf::tools {
namespace {

/// A fix may uncover the next fault; this bounds the number of rounds.
constexpr int kRounds = 10;
/// Includes rounds that only fix findings omitted earlier because there were too many.
constexpr int kMostRounds = 100;

std::string diff_of(const std::string& path, const Change& change) {
  const bool is_relative = !path.starts_with('/');
  const std::string name = render::escape(path);
  return "--- " + (is_relative ? "a/" + name : name) + "\n" + "+++ " +
         (is_relative ? "b/" + name : name) + "\n" + unified_hunks(change.before, change.after);
}

/// The cost of a check, as `rechecked-bytes` counts it.
std::uint64_t cost_of(const Report& report, const SourceMap& sources) {
  std::uint64_t cost = report.diagnostics.size() * kBytesOfFinding;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    cost += sources.text(SourceId{static_cast<std::uint32_t>(i)}).size();
  }
  return cost;
}

bool has_left_out(const Report& report) {
  return std::any_of(report.diagnostics.begin(), report.diagnostics.end(),
                     [](const Diagnostic& one) { return one.left_out != nullptr; });
}

/// The sources that the fixes change, by path.
std::map<std::string_view, SourceId> sources_of(const AppliedFixes& fixes,
                                                const SourceMap& sources) {
  std::map<std::string_view, SourceId> found;
  for (const Edit& edit : fixes.edits) {
    found.emplace(sources.path(edit.span.source), edit.span.source);
  }
  return found;
}

/// True if a path leads out of its project, so a symbolic link cannot redirect a fix.
bool leads_outside(const std::string& path, const LintOptions& options) {
  if (options.allow_outside) return false;
  const std::string folder(path::parent(path));
  ConfinedFiles project;
  confine_to_projects(project, std::array{folder.empty() ? std::string(".") : folder});
  return project.is_denied(path);
}

/// Decides which fixes may be applied.
class Changeable {
 public:
  Changeable(const LintOptions& options, const LintPlan& plan) : input_(plan.standard_input) {
    confine_to_changeable(files_, options, plan);
  }

  void keep_own(std::vector<Diagnostic>& diagnostics, const SourceMap& sources) {
    for (Diagnostic& one : diagnostics) {
      std::erase_if(one.fixes, [&](const Fix& fix) {
        return std::any_of(fix.edits.begin(), fix.edits.end(), [&](const Edit& edit) {
          return is_foreign(sources.path(edit.span.source));
        });
      });
    }
  }

 private:
  /// A file may have thousands of fixes.
  bool is_foreign(const std::string& path) {
    const auto [known, is_new] = known_.try_emplace(path);
    if (is_new) known->second = path != input_ && files_.is_denied(path);
    return known->second;
  }

  ConfinedFiles files_;
  const std::string input_;
  std::map<std::string, bool> known_;
};

}  // namespace

namespace {

/// The findings with fixes that are at least so severe.
std::vector<Diagnostic> fixable(std::span<const Diagnostic> all, Severity least) {
  std::vector<Diagnostic> found;
  std::copy_if(all.begin(), all.end(), std::back_inserter(found),
               [&](const Diagnostic& one) { return !one.fixes.empty() && one.severity >= least; });
  return found;
}

}  // namespace

Fixed fix_all(const LintOptions& options, const LintPlan& plan, Session& session, Report report,
              Severity least, const std::function<Report()>& check) {
  const Applicability most = options.unsafe_fixes ? Applicability::unsafe : Applicability::safe;
  Fixed fixed;
  fixed.report = std::move(report);
  std::uint64_t total = 0;
  int counted = 0;
  Changeable changeable(options, plan);
  for (int round = 0;; ++round) {
    changeable.keep_own(fixed.report.diagnostics, session.sources());
    AppliedFixes applied =
        apply_fixes(fixable(fixed.report.diagnostics, least), session.sources(), most);
    if (applied.texts.empty()) return fixed;
    if (counted == kRounds) {
      fixed.end = FixEnd::no_end;
      return fixed;
    }
    const std::uint64_t cost = cost_of(fixed.report, session.sources());
    total += cost;
    if (round > 0 && (total + cost > options.limits.rechecked_bytes || round == kMostRounds)) {
      fixed.end = FixEnd::limit;
      return fixed;
    }
    if (!has_left_out(fixed.report)) ++counted;
    fixed.count += applied.count;
    fixed.places += applied.edits.size();
    const std::map<std::string_view, SourceId> read = sources_of(applied, session.sources());
    for (FixedText& file : applied.texts) {
      const auto [change, is_new] = fixed.changes.try_emplace(file.path);
      if (is_new) change->second.before = session.sources().text(read.at(file.path));
      change->second.after = file.text;
      session.set_text(file.path, std::move(file.text));
    }
    fixed.report = check();
  }
}

bool write_changes(const std::map<std::string, Change>& changes, const LintPlan& plan,
                   const LintOptions& options) {
  std::vector<OutputFile> files;
  for (const auto& [path, change] : changes) {
    if (path == plan.standard_input || !leads_outside(path, options)) continue;
    complain(kSmurfLint, "cannot fix '" + path +
                             "': it is a link that leads out of its project; name "
                             "the file itself, or add --allow-outside; nothing was fixed");
    return false;
  }
  for (const auto& [path, change] : changes) {
    if (path == plan.standard_input) continue;
    files.push_back(named_by_user(path, change.after));
    files.back().replaces = change.before;
  }
  return write_files(kSmurfLint, files, true);
}

std::string unified_diff(const std::map<std::string, Change>& changes) {
  std::string text;
  for (const auto& [path, change] : changes) text += diff_of(path, change);
  return text;
}

std::string fix_remarks(const Fixed* fixed, std::span<const Diagnostic> left, Severity least) {
  std::size_t safe = 0;
  std::size_t unsafe = 0;
  for (const Diagnostic& diagnostic : left) {
    if (diagnostic.severity < least) continue;
    for (const Fix& fix : diagnostic.fixes) {
      ++(fix.applicability == Applicability::safe ? safe : unsafe);
    }
  }
  std::string text;
  if (fixed != nullptr && fixed->count > 0) {
    text += "fixed " + counted(fixed->count, "finding") + " at " + counted(fixed->places, "place") +
            " in " + counted(fixed->changes.size(), "file") + "\n";
  }
  std::string fixable;
  if (safe > 0) fixable = std::to_string(safe) + " fixable with `--fix`";
  if (unsafe > 0) {
    const std::string_view more = safe > 0 ? " more with" : " fixable with";
    fixable += (safe > 0 ? ", " : "") + std::to_string(unsafe);
    fixable.append(more).append(" `--fix --unsafe-fixes`");
  }
  return fixable.empty() ? text : text + fixable + "\n";
}

}  // namespace smurf::tools
