// SPDX-License-Identifier: BSD-3-Clause
// Findings, pushed to the client and pulled by it.
#include <algorithm>
#include <functional>
#include <map>
#include <mutex>
#include <utility>

#include "common/cli/command.hpp"
#include "render/advice.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/uri.hpp"
#include "smurf/render.hpp"
#include "smurf/verdict.hpp"

namespace smurf::lsp {
namespace {

constexpr int kUnnecessary = 1;  // DiagnosticTag

int severity_of(Severity severity) {
  switch (severity) {
  case Severity::error: return 1;
  case Severity::warning: return 2;
  case Severity::info: return 3;
  }
  return 3;
}

/// Whether it is a fact about this rule alone, and not about a family of rules.
bool is_about(const Fact& fact, const Rule& rule) {
  return std::any_of(rule.facts.begin(), rule.facts.end(),
                     [&](const Fact& one) { return &one == &fact; });
}

/// Whether all readers with a fact about the finding ignore it.
bool has_no_effect(const Diagnostic& diagnostic) {
  const std::vector<const Fact*> facts = facts_about(*diagnostic.rule);
  bool is_ignored = std::any_of(facts.begin(), facts.end(),
                                [](const Fact* fact) { return fact->effect == Effect::ignores; });
  if (!is_ignored) return false;  // a quick test for nearly all rules
  is_ignored = false;
  for (const Reader* reader : all_readers()) {
    const Fact* fact = find_fact(*reader, diagnostic);
    if (fact == nullptr) continue;
    if (fact->effect == Effect::takes && is_about(*fact, *diagnostic.rule)) return false;
    if (fact->effect == Effect::takes) continue;  // the reader never looks at such things
    if (fact->effect != Effect::ignores) return false;
    is_ignored = true;
  }
  return is_ignored;
}

std::string message_of(const Diagnostic& diagnostic) {
  std::string text = diagnostic.message;
  if (const std::string help = render::advice_on(diagnostic); !help.empty()) text += "\n" + help;
  for (const std::string& note : diagnostic.notes) text += "\n" + note;
  return text;
}

/// The report of a file; "unchanged" when the client has it already.
Json file_report(Context& context, std::string items, const std::string& previous) {
  const std::string id = std::to_string(std::hash<std::string>{}(items));
  if (id == previous) return {{"kind", "unchanged"}, {"resultId", id}};
  return {{"kind", "full"}, {"resultId", id}, {"items", context.lists.add(std::move(items))}};
}

/// Reports the progress of checking the folders. Several threads call it.
class ProgressTeller {
 public:
  ProgressTeller(Context& context, Json token) : context_(context), token_(std::move(token)) {}

  void tell(std::size_t done, std::size_t of) {
    const std::lock_guard lock(mutex_);
    if (token_.is_null() || of == 0) return;
    const auto percent = static_cast<int>(done * 100 / of);
    if (!has_begun_) {
      has_begun_ = true;
      send({{"kind", "begin"}, {"title", "smurf-lint"}, {"percentage", percent}});
    } else if (percent > last_) {
      send({{"kind", "report"},
            {"message", std::to_string(done) + " of " + std::to_string(of)},
            {"percentage", percent}});
    }
    last_ = percent;
  }
  void end() {
    if (has_begun_) send({{"kind", "end"}});
  }

 private:
  void send(Json value) {
    context_.send({{"jsonrpc", "2.0"},
                   {"method", "$/progress"},
                   {"params", {{"token", token_}, {"value", std::move(value)}}}});
  }

  Context& context_;
  Json token_;
  std::mutex mutex_;
  bool has_begun_ = false;
  int last_ = 0;
};

/// The client's progress token, or at the first check of the folders a new one of ours.
Json token_of(Context& context, const Json& params) {
  const Json& given = at(params, {"workDoneToken"});
  if (given.is_string() || given.is_number()) return given;
  if (!context.client.takes_progress || context.has_checked_folders) return nullptr;
  Json token = "smurf-lint-folders";
  context.ask("window/workDoneProgress/create", {{"token", token}});
  return token;
}

}  // namespace

Json to_json(const Context& context, const Diagnostic& diagnostic, const SourceMap& sources) {
  const Positions positions(sources, context.client.encoding);
  Json json = {{"range", positions.range(diagnostic.span)},
               {"severity", severity_of(diagnostic.severity)},
               {"code", diagnostic.rule->id},
               {"codeDescription", {{"href", rule_address(*diagnostic.rule, tools::kSite)}}},
               {"source", "smurf-lint"},
               {"message", message_of(diagnostic)},
               {"data", {{"name", diagnostic.rule->name}, {"message", diagnostic.message}}}};
  for (const Label& label : diagnostic.labels) {
    const std::string uri = context.workspace.uri_of(sources.path(label.span.source));
    json["relatedInformation"].push_back(
        {{"location", {{"uri", uri}, {"range", positions.range(label.span)}}},
         {"message", label.message}});
  }
  if (has_no_effect(diagnostic)) json["tags"] = {kUnnecessary};
  return json;
}

/// At the first line of the file.
Json to_json(const NotCompared& one) {
  const Json begin = {{"line", 0}, {"character", 0}};
  return {{"range", {{"start", begin}, {"end", begin}}},
          {"severity", severity_of(Severity::info)},
          {"code", "not-compared"},
          {"source", "smurf-lint"},
          {"message", "not compared with a robot: " + one.reason + "\n" + one.next}};
}

std::map<std::string, std::string> diagnostics_by_file(const Context& context, const Report& report,
                                                       const SourceMap& sources,
                                                       const std::string* only) {
  std::map<std::string, std::string> files;
  for (const Diagnostic& one : report.diagnostics) {
    const std::string& path = sources.path(one.span.source);
    if (only != nullptr && path != *only) continue;
    const auto [list, is_new] = files.try_emplace(path, "[");
    if (!is_new) list->second += ',';
    list->second += dump(to_json(context, one, sources));
  }
  for (const NotCompared& one : report.summary.not_compared) {
    if (only != nullptr && one.path != *only) continue;
    const auto [list, is_new] = files.try_emplace(one.path, "[");
    if (!is_new) list->second += ',';
    list->second += dump(to_json(one));
  }
  for (auto& [path, list] : files) list += ']';
  return files;
}

Json document_diagnostics(Context& context, const Json& params) {
  const std::string path = path_in(params);
  const Report& report = context.workspace.report();
  const std::string* only = context.client.takes_related_documents ? nullptr : &path;
  std::map<std::string, std::string> files =
      diagnostics_by_file(context, report, context.workspace.sources(), only);
  auto own = files.extract(files.try_emplace(path, kNoDiagnostics).first);
  Json answer =
      file_report(context, std::move(own.mapped()), text_at(params, {"previousResultId"}));
  for (auto& [other, items] : files) {
    answer["relatedDocuments"][context.workspace.uri_of(other)] =
        file_report(context, std::move(items), {});
  }
  return answer;
}

Json workspace_diagnostics(Context& context, const Json& params) {
  ProgressTeller progress(context, token_of(context, params));
  const Workspace::FolderReport checked = context.workspace.check_folders(
      [&](std::size_t done, std::size_t of) { progress.tell(done, of); }, context.is_cancelled);
  progress.end();
  if (context.is_cancelled()) throw RequestError(kRequestCancelled, "cancelled");
  context.has_checked_folders = true;
  std::map<std::string, std::string> previous;
  const Json& known = at(params, {"previousResultIds"});
  if (known.is_array()) {
    for (const Json& one : known) {
      previous[path_of_uri(text_at(one, {"uri"}))] = text_at(one, {"value"});
    }
  }
  std::map<std::string, std::string> files =
      diagnostics_by_file(context, checked.report, *checked.sources);
  // A file without findings is reported once more, to clear the old ones.
  for (const auto& [path, id] : previous) files.try_emplace(path, kNoDiagnostics);
  Json items = Json::array();
  for (auto& [path, list] : files) {
    const auto last = previous.find(path);
    Json report = file_report(context, std::move(list), last == previous.end() ? "" : last->second);
    const OpenDocument* open = context.workspace.document(path);
    report["uri"] = context.workspace.uri_of(path);
    report["version"] = open != nullptr ? Json(open->version) : Json(nullptr);
    items.push_back(std::move(report));
  }
  return {{"items", std::move(items)}};
}

}  // namespace smurf::lsp
