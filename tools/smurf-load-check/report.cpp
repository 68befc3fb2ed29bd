// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "common/command.hpp"

namespace smurf::load_check {
namespace {

using Json = nlohmann::ordered_json;

std::string place_text(Span place, const SourceMap& sources) {
  return sources.path(place.source) + ":" +
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
  const char* codes[] = {"\x1b[32m", "\x1b[33m", "\x1b[31m", "\x1b[2m"};
  return codes[static_cast<std::size_t>(verdict)] + std::string(text) + "\x1b[0m";
}

/// "  HANG   pass     gap          2.7e-04 m    at most 0.001 m   joint `a` arm.urdf:12"
std::string figure_text(const Figure& figure, const SourceMap& sources) {
  const std::string_view unit = bound_info(figure.bound).unit;
  std::string line = padded(figure.bound, 12) + padded(with_unit(figure.value, unit), 14) +
                     "at most " + padded(with_unit(figure.limit, unit), 11);
  if (!figure.worst.empty()) line += figure.worst + "  " + place_text(figure.place, sources);
  line.erase(line.find_last_not_of(' ') + 1);
  return line;
}

std::string stage_text(const StageResult& stage, const SourceMap& sources, const TextStyle& style) {
  const std::string blank(2 + 8 + 9, ' ');
  std::string head =
      "  " + padded(std::string(to_string(stage.stage)), 8) +
      painted(stage.verdict, padded(std::string(to_string(stage.verdict)), 9), style);
  std::string out;
  const auto add = [&](const std::string& line) {
    out += (out.empty() ? head : blank) + line + "\n";
  };
  if (!stage.note.empty()) add(stage.note);
  for (const Figure& figure : stage.figures) add(figure_text(figure, sources));
  if (out.empty()) add("");
  return out;
}

std::string check_text(const Checked& checked, const SourceMap& sources, const TextStyle& style) {
  const Verdict verdict = checked.verdict();
  const std::string word =
      checked.result.stages.empty() ? "not run" : std::string(to_string(verdict));
  std::string out = checked.job->path + ": " + painted(verdict, word, style) + "\n";
  for (const StageResult& stage : checked.result.stages) out += stage_text(stage, sources, style);
  return out + "\n";
}

/// JSON has no infinity and no NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json to_json(const Figure& figure, const SourceMap& sources) {
  Json json{{"name", figure.bound},
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

Json to_json(const Checked& checked, const SourceMap& sources) {
  Json stages = Json::array();
  for (const StageResult& stage : checked.result.stages) {
    Json figures = Json::array();
    for (const Figure& figure : stage.figures) figures.push_back(to_json(figure, sources));
    Json json{{"stage", to_string(stage.stage)}, {"verdict", to_string(stage.verdict)}};
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
  std::string out;
  for (const Checked& checked : report.checked) {
    if (report.quiet && checked.verdict() == Verdict::pass) continue;
    out += check_text(checked, report.sources, style);
  }
  for (const Diagnostic& diagnostic : report.diagnostics) {
    out += render_full(diagnostic, report.sources, style);
  }
  return report.quiet ? out : out + render_summary(report.summary, style);
}

std::string render_json(const Report& report) {
  Json json = Json::parse(smurf::render_json(report.diagnostics, report.sources, report.summary,
                                             {"smurf-load-check", tools::kVersion}));
  Json checks = Json::array();
  for (const Checked& checked : report.checked) checks.push_back(to_json(checked, report.sources));
  json["checks"] = checks;
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace smurf::load_check
