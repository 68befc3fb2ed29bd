// SPDX-License-Identifier: BSD-3-Clause
// The JSON report and the JSON rule list.
#include "render/report_json.hpp"

#include <string>
#include <utility>

#include "render/advice.hpp"

namespace smurf {
namespace {

using render::dump;
using render::dump_with_list;
using render::Json;
using render::text;

void add_place(Json& json, Span span, const SourceMap& sources) {
  const auto [begin, end] = render::region_of(span, sources);
  json["file"] = render::path_of(span, sources);
  json["line"] = begin.line;
  json["column"] = begin.column;
  json["end_line"] = end.line;
  json["end_column"] = end.column;
}

Json to_json(const Fix& fix, const SourceMap& sources) {
  Json edits = Json::array();
  for (const Edit& edit : fix.edits) {
    edits.push_back({{"file", sources.path(edit.span.source)},
                     {"begin", edit.span.begin},
                     {"end", edit.span.end},
                     {"text", edit.text}});
  }
  const bool is_safe = fix.applicability == Applicability::safe;
  return {{"applicability", is_safe ? "safe" : "unsafe"}, {"edits", std::move(edits)}};
}

Json to_json(const Fact& fact) {
  Json json = {{"reader", text(fact.reader->name)},
               {"where", describe(fact.where)},
               {"effect", text(to_string(fact.effect))},
               {"makes", text(fact.makes)},
               {"evidence", evidence_of(fact)}};
  if (!fact.cure.empty()) json["cure"] = text(fact.cure);
  return json;
}

Json to_json(const TargetVerdict& target, const SourceMap& sources) {
  Json json = {{"verdict", text(to_string(target.answer()))},
               {"refusals", target.refusals},
               {"unknown", target.unknown},
               {"losses", target.losses},
               {"ignored", target.ignored},
               {"in_baseline", target.in_baseline}};
  for (const Rule* rule : target.unknown_rules) json["unknown_rules"].push_back(text(rule->id));
  for (const TargetVerdict& later : target.newer) {
    json["later_releases"][std::string(later.reader->name)] = text(to_string(later.answer()));
  }
  for (const TargetVerdict& one : target.earlier) {
    json["earlier_releases"][std::string(one.reader->name)] = text(to_string(one.answer()));
  }
  if (target.fact == nullptr) return json;
  Json first = {{"id", text(target.rule->id)},
                {"effect", text(to_string(target.fact->effect))},
                {"makes", text(target.fact->makes)},
                {"source", evidence_of(*target.fact)}};
  add_place(first, target.span, sources);
  json["first"] = std::move(first);
  return json;
}

}  // namespace

namespace render {

Json finding_json(const Diagnostic& diagnostic, const SourceMap& sources) {
  Json json;
  json["id"] = text(diagnostic.rule->id);
  json["name"] = text(diagnostic.rule->name);
  json["severity"] = text(to_string(diagnostic.severity));
  json["message"] = diagnostic.message;
  add_place(json, diagnostic.span, sources);
  if (!diagnostic.pointer.empty()) json["pointer"] = diagnostic.pointer;
  if (std::string help = advice_on(diagnostic); !help.empty()) json["help"] = std::move(help);
  if (!diagnostic.notes.empty()) json["notes"] = diagnostic.notes;
  for (const Label& label : diagnostic.labels) {
    Json place;
    add_place(place, label.span, sources);
    place["message"] = label.message;
    json["labels"].push_back(std::move(place));
  }
  return json;
}

Json report_json(const SourceMap& sources, const Summary& summary, const ToolName& tool,
                 std::span<const TargetVerdict> targets) {
  Json report;
  report["schema_version"] = "1.0";
  report["tool"] = {{"name", text(tool.name)}, {"version", text(tool.version)}};
  report["summary"] = {{"error", summary.errors}, {"warning", summary.warnings},
                       {"info", summary.infos},   {"suppressed", summary.suppressed},
                       {"files", summary.files},  {"models", summary.models},
                       {"scenes", summary.scenes}};
  if (summary.links > 0) report["summary"]["links"] = summary.links;
  for (const auto& [title, count] : summary.companions) {
    report["summary"]["companions"][std::string(title)] = count;
  }
  for (const std::string& one : summary.assumptions) {
    report["summary"]["assumptions"].push_back(one);
  }
  for (const NotCompared& one : summary.not_compared) {
    report["summary"]["not_compared"].push_back({{"path", one.path},
                                                 {"kind", std::string(one.kind)},
                                                 {"reason", one.reason},
                                                 {"next", one.next}});
  }
  report["diagnostics"] = Json::array();
  for (const TargetVerdict& target : targets) {
    report["targets"][std::string(target.reader->name)] = to_json(target, sources);
  }
  return report;
}

Json rule_json(const Rule& rule) {
  Json entry = {{"id", text(rule.id)},
                {"name", text(rule.name)},
                {"severity", text(to_string(rule.severity))},
                {"needs_target", rule.needs_target},
                {"summary", text(rule.summary)},
                {"why", text(rule.why)},
                {"remedy", text(rule.remedy)},
                {"sources", sources_of(rule)}};
  if (const Tolerance& tolerance = rule.tolerance; !tolerance.meaning.empty()) {
    entry["tolerance"] = {{"value", tolerance.value},
                          {"unit", text(tolerance.unit)},
                          {"meaning", text(tolerance.meaning)}};
  }
  return entry;
}

}  // namespace render

namespace {

Json finding_with_fix(const Diagnostic& diagnostic, const SourceMap& sources) {
  Json json = render::finding_json(diagnostic, sources);
  if (!diagnostic.fixes.empty()) json["fix"] = to_json(diagnostic.fixes.front(), sources);
  return json;
}

}  // namespace

std::string render_json(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                        const Summary& summary, const ToolName& tool,
                        std::span<const TargetVerdict> targets) {
  return dump_with_list(render::report_json(sources, summary, tool, targets), "diagnostics", 1,
                        diagnostics,
                        [&](const Diagnostic& one) { return finding_with_fix(one, sources); });
}

std::string render_record(const Record& record, const SourceMap& sources) {
  const Summary& summary = record.summary;
  Json json = {{"path", record.path}};
  if (!record.digest.empty()) json["digest"] = record.digest;
  json["ok"] = summary.errors == 0;
  json["loads"] = Json::object();
  for (const TargetVerdict& target : record.targets) {
    json["loads"][std::string(target.reader->name)] = text(to_string(target.answer()));
  }
  json["counts"] = {{"errors", summary.errors},
                    {"warnings", summary.warnings},
                    {"infos", summary.infos},
                    {"suppressed", summary.suppressed}};
  if (record.size) {
    json["links"] = record.size->links;
    json["mass"] = record.size->mass;
  }
  json["findings"] = Json::array();
  for (const Diagnostic& one : record.diagnostics) {
    json["findings"].push_back(finding_with_fix(one, sources));
  }
  return render::dump_line(json);
}

std::string render_losses_json(std::span<const Diagnostic> losses, const SourceMap& sources,
                               const ToolName& tool) {
  Json report;
  report["schema_version"] = "1.0";
  report["tool"] = {{"name", text(tool.name)}, {"version", text(tool.version)}};
  report["losses"] = Json::array();
  return dump_with_list(report, "losses", 1, losses, [&](const Diagnostic& loss) {
    Json entry = {
        {"class", text(loss.rule->name)}, {"id", text(loss.rule->id)}, {"message", loss.message}};
    add_place(entry, loss.span, sources);
    entry["pointer"] = loss.pointer;
    return entry;
  });
}

std::string render_rule_list_json(std::span<const Rule* const> rules) {
  Json list = Json::array();
  for (const Rule* rule : rules) {
    Json entry = render::rule_json(*rule);
    for (const Fact* fact : facts_about(*rule)) entry["readers"].push_back(to_json(*fact));
    list.push_back(std::move(entry));
  }
  return dump(list);
}

}  // namespace smurf
