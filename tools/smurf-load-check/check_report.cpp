// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/check_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/lists.hpp"
#include "common/cli/command.hpp"
#include "render/json_text.hpp"
#include "render/printable.hpp"
#include "smurf-load-check/stage_run.hpp"

namespace smurf::load_check {
namespace {

using OrderedJson = nlohmann::ordered_json;

/// Folders are shown by the diagnostics and the headline; a table has no space for them.
std::string place_text(Span place, const SourceMap& sources) {
  return render::escape(path::file_name(sources.path(place.source))) + ":" +
         std::to_string(sources.line_of(place.source, place.begin));
}

std::string with_unit(double value, std::string_view unit) {
  const std::string number = std::isnan(value) ? "nan" : format_rounded(value, 3);
  return unit.empty() ? number : number + " " + std::string(unit);
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

std::string painted(Verdict verdict, std::string_view text, const TextStyle& style) {
  if (!style.color) return std::string(text);
  const char* codes[] = {"\x1b[32m", "\x1b[33m", "\x1b[33m", "\x1b[31m", "\x1b[2m"};
  return codes[static_cast<std::size_t>(verdict)] + std::string(text) + "\x1b[0m";
}

constexpr std::size_t kStageWidth = 10;  // with its indentation
constexpr std::size_t kVerdictWidth = 9;
constexpr std::size_t kLineWidth = 80;

/// "gap          0.00027 m     at most 0.001 m    joint `a`, arm.urdf:12"; the joint gets a
/// separate line if the row would be too long.
std::vector<std::string> figure_lines(const Figure& figure, const SourceMap& sources,
                                      std::size_t indent) {
  const std::string_view unit = bound_info(figure.bound).unit;
  std::string line = padded(figure.bound, 13) + padded(with_unit(figure.value, unit), 14) +
                     "at most " + with_unit(figure.limit, unit);
  if (figure.worst.empty()) return {line};
  const std::string worst = render::escape(figure.worst) + ", " + place_text(figure.place, sources);
  constexpr std::size_t kWorstColumn = 46;
  if (indent + kWorstColumn + worst.size() <= kLineWidth) {
    return {padded(line, kWorstColumn) + worst};
  }
  return {line, "  " + worst};
}

/// The verdict with a description or the reason for skipping, then the figures; a stage with only
/// one figure is one line.
std::string stage_text(const StageResult& stage, const SourceMap& sources, const TextStyle& style) {
  std::vector<std::string> lines;
  if (!stage.note.empty()) lines.push_back(render::escape(stage.note));
  for (const Figure& figure : stage.figures) {
    for (std::string& line : figure_lines(figure, sources, kStageWidth + kVerdictWidth)) {
      lines.push_back(std::move(line));
    }
  }
  std::string out = padded("  " + std::string(to_string(stage.stage)), kStageWidth) +
                    painted(stage.verdict, to_string(stage.verdict), style);
  if (lines.empty()) return out + "\n";
  out.append(kVerdictWidth - to_string(stage.verdict).size(), ' ');
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (i > 0) out.append(kStageWidth + kVerdictWidth, ' ');
    out += lines[i] + "\n";
  }
  return out;
}

std::string_view headline_of(const Checked& checked, Verdict verdict) {
  if (checked.result.stages.empty()) {
    const bool is_read = checked.job->model == nullptr || checked.job->model->robot;
    return is_read ? "not run: its files have errors" : "not run: its URDF cannot be read";
  }
  return verdict == Verdict::none ? "no verdict" : to_string(verdict);
}

/// "51 models: 37 passed, 3 with warnings, 9 failed, 2 without verdict".
std::string tally_text(const Report& report) {
  const Tally tally = tally_of(report.checked);
  std::vector<std::string> kinds;
  if (report.summary.models > 0)
    kinds.push_back(count_of(report.summary.models, "model", "models"));
  if (report.summary.scenes > 0)
    kinds.push_back(count_of(report.summary.scenes, "scene", "scenes"));
  std::string text = listed(kinds) + ": " + std::to_string(tally.passed) + " passed";
  if (tally.warned > 0) text += ", " + std::to_string(tally.warned) + " with warnings";
  if (tally.failed > 0) text += ", " + std::to_string(tally.failed) + " failed";
  if (tally.undecided > 0) text += ", " + std::to_string(tally.undecided) + " without verdict";
  return text + "\n";
}

std::string headline_text(const Checked& checked, const TextStyle& style) {
  const Verdict verdict = checked.verdict();
  return render::escape(checked.job->path) + ": " +
         painted(verdict, headline_of(checked, verdict), style);
}

std::string check_text(const Checked& checked, const SourceMap& sources, const TextStyle& style) {
  std::string out = headline_text(checked, style) + "\n";
  for (const StageResult& stage : checked.result.stages) out += stage_text(stage, sources, style);
  return out + "\n";
}

/// "arm.smurf: pass; 7 moving bodies, 6 joints, 9 shapes"
std::string passed_line(const Checked& checked, const TextStyle& style) {
  std::string out = headline_text(checked, style);
  for (const StageResult& stage : checked.result.stages) {
    if (!stage.note.empty()) out += "; " + render::escape(stage.note);
  }
  return out + "\n";
}

/// Lines of passed checks are adjacent; a blank line separates them from the tables.
std::string checks_text(const Report& report, const TextStyle& style) {
  std::string out;
  bool follows_line = false;
  for (const Checked& checked : report.checked) {
    const bool is_line = checked.verdict() == Verdict::pass && !report.all;
    if (is_line && report.quiet) continue;
    if (follows_line && !is_line) out += "\n";
    out += is_line ? passed_line(checked, style) : check_text(checked, report.sources, style);
    follows_line = is_line;
  }
  return follows_line ? out + "\n" : out;
}

/// JSON has no infinity and no NaN.
OrderedJson number(double value) {
  return std::isfinite(value) ? OrderedJson(value) : OrderedJson();
}

OrderedJson to_json(const Figure& figure, const SourceMap& sources) {
  OrderedJson json{{"name", figure.bound},
                   {"value", number(figure.value)},
                   {"bound", figure.limit},
                   {"unit", bound_info(figure.bound).unit},
                   {"is_within", figure.is_within()}};
  if (!figure.worst.empty()) {
    json["worst"] = {{"name", figure.worst},
                     {"file", sources.path(figure.place.source)},
                     {"line", sources.line_of(figure.place.source, figure.place.begin)}};
  }
  return json;
}

OrderedJson to_json(const Checked& checked, const SourceMap& sources) {
  OrderedJson stages = OrderedJson::array();
  for (const StageResult& stage : checked.result.stages) {
    OrderedJson figures = OrderedJson::array();
    for (const Figure& figure : stage.figures) figures.push_back(to_json(figure, sources));
    OrderedJson json{{"stage", to_string(stage.stage)}, {"verdict", to_string(stage.verdict)}};
    if (!stage.note.empty()) json["note"] = stage.note;
    json["figures"] = figures;
    stages.push_back(json);
  }
  return {{"file", checked.job->path},
          {"kind", checked.job->model != nullptr ? "model" : "scene"},
          {"verdict", to_string(checked.verdict())},
          {"stages", stages}};
}

}  // namespace

std::string render_text(const Report& report, const TextStyle& style) {
  std::string out = checks_text(report, style);
  for (const Diagnostic& diagnostic : report.diagnostics) {
    out += render_full(diagnostic, report.sources, style);
  }
  if (report.quiet) return out;
  out += render_summary(report.summary, style);
  return report.checked.size() > 1 ? out + tally_text(report) : out;
}

std::string render_json(const Report& report) {
  OrderedJson json = OrderedJson::parse(smurf::render_json(
      report.diagnostics, report.sources, report.summary, {"smurf-load-check", tools::kVersion}));
  OrderedJson checks = OrderedJson::array();
  for (const Checked& checked : report.checked) checks.push_back(to_json(checked, report.sources));
  const Tally tally = tally_of(report.checked);
  json["verdicts"] = {{"pass", tally.passed},
                      {"warn", tally.warned},
                      {"fail", tally.failed},
                      {"none", tally.undecided}};
  json["checks"] = checks;
  return render::dump(json);
}

}  // namespace smurf::load_check
