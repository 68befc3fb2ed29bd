// SPDX-License-Identifier: BSD-3-Clause
// Code actions: fixes, comments that suppress a finding, and its effects on readers.
#include <algorithm>
#include <cstdint>
#include <map>
#include <utility>

#include "common/cli/command.hpp"
#include "lint/suppress.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf/fix.hpp"
#include "smurf/readers.hpp"
#include "smurf/render.hpp"

namespace smurf::lsp {
namespace {

constexpr const char* kExplain = "smurf.explainRule";
constexpr std::string_view kQuickFix = "quickfix";
constexpr std::string_view kFixAll = "source.fixAll";
/// Kinds of the protocol.
constexpr int kInfo = 3;
/// A longer menu would not be read.
constexpr std::size_t kMostFindings = 100;

/// Whether the client asks for actions of this kind or of a kind that contains it.
bool is_wanted(const Json& params, std::string_view kind) {
  const Json& only = at(params, {"context", "only"});
  if (!only.is_array()) return true;
  return std::any_of(only.begin(), only.end(), [&](const Json& one) {
    if (!one.is_string()) return false;
    const auto wanted = one.get<std::string>();
    return kind == wanted || (kind.starts_with(wanted) && kind[wanted.size()] == '.');
  });
}

std::string shortened(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  std::string line(text.substr(0, text.find('\n')));
  if (line.size() > kLongest || line.size() < text.size()) {
    line = line.substr(0, kLongest) + "...";
  }
  return line;
}

/// The title of a fix: "Replace `effrot` by `effort`".
std::string title_of(const Fix& fix, const SourceMap& sources) {
  const Edit& first = fix.edits.front();
  const std::string before = shortened(sources.text(first.span));
  const std::string after = shortened(first.text);
  std::string title = before.empty()  ? "Insert `" + after + "`"
                      : after.empty() ? "Delete `" + before + "`"
                                      : "Replace `" + before + "` by `" + after + "`";
  if (fix.edits.size() > 1) title += " and more";
  if (fix.applicability == Applicability::unsafe) title += " (may change the meaning of the model)";
  return title;
}

class Actions {
 public:
  Actions(Context& context, const Json& params)
      : context_(context), params_(params), path_(path_in(params)) {}

  Json run() {
    const Report& report = context_.workspace.report();
    const SourceMap& sources = context_.workspace.sources();
    std::size_t shown = 0;
    for (const Diagnostic& one : report.diagnostics) {
      const bool is_here = sources.path(one.span.source) == path_ && is_in_range(one.span);
      if (is_here && shown++ < kMostFindings) add(one);
    }
    if (is_wanted(params_, kFixAll)) fix_all(report);
    return std::move(actions_);
  }

 private:
  /// The range of the request, in each text of the file.
  std::pair<std::uint32_t, std::uint32_t> asked_in(SourceId source) {
    const auto [known, is_new] = asked_.try_emplace(source);
    if (is_new) {
      const Positions positions(context_.workspace.sources(), context_.client.encoding);
      const Json& range = at(params_, {"range"});
      known->second = {positions.offset(source, at(range, {"start"})),
                       positions.offset(source, at(range, {"end"}))};
    }
    return known->second;
  }

  bool is_in_range(Span span) {
    const auto [begin, end] = asked_in(span.source);
    return span.begin <= end && begin <= span.end;
  }

  void add(const Diagnostic& one) {
    const SourceMap& sources = context_.workspace.sources();
    const Json diagnostic = to_json(context_, one, sources);
    if (is_wanted(params_, kQuickFix)) {
      for (const Fix& fix : one.fixes) {
        if (fix.edits.empty()) continue;
        actions_.push_back({{"title", title_of(fix, sources)},
                            {"kind", kQuickFix},
                            {"diagnostics", {diagnostic}},
                            {"isPreferred", fix.applicability == Applicability::safe},
                            {"edit", workspace_edit(context_, fix.edits, sources)}});
      }
      for (const InertiaAction& action : inertia_actions(context_, one)) {
        actions_.push_back({{"title", action.title},
                            {"kind", kQuickFix},
                            {"diagnostics", {diagnostic}},
                            {"edit", workspace_edit(context_, action.edits,
                                                    context_.workspace.loaded_sources())}});
      }
      suppress(one, diagnostic);
      explain(*one.rule, diagnostic);
    }
  }

  void suppress(const Diagnostic& one, const Json& diagnostic) {
    const auto edit = suppression(one);
    if (!edit) return;
    const Json whole = workspace_edit(context_, std::span(&*edit, 1), context_.workspace.sources());
    actions_.push_back({{"title", "Ignore " + std::string(one.rule->id) + " (" +
                                      std::string(one.rule->name) + ") here"},
                        {"kind", kQuickFix},
                        {"diagnostics", {diagnostic}},
                        {"edit", whole}});
  }

  std::optional<Edit> suppression(const Diagnostic& one) {
    const std::string_view text = context_.workspace.sources().text(one.span.source);
    for (const FileView& view : context_.workspace.views(path_)) {
      if (view.yaml != nullptr) return suppress_here(one, *view.yaml, text);
      if (view.xml != nullptr) return suppress_here(one, *view.xml, text);
    }
    return std::nullopt;
  }

  void explain(const Rule& rule, const Json& diagnostic) {
    const std::string title = "Show how each reader handles " + std::string(rule.name);
    actions_.push_back(
        {{"title", title},
         {"kind", kQuickFix},
         {"diagnostics", {diagnostic}},
         {"command", {{"title", title}, {"command", kExplain}, {"arguments", {rule.id}}}}});
  }

  void fix_all(const Report& report) {
    const SourceMap& sources = context_.workspace.sources();
    std::vector<Diagnostic> own;
    for (const Diagnostic& one : report.diagnostics) {
      if (sources.path(one.span.source) == path_) own.push_back(one);
    }
    const AppliedFixes fixes = apply_fixes(own, sources, Applicability::safe);
    if (fixes.edits.empty()) return;
    actions_.push_back({{"title", "Apply all safe fixes"},
                        {"kind", kFixAll},
                        {"edit", workspace_edit(context_, fixes.edits, sources)}});
  }

  Context& context_;
  const Json& params_;
  std::string path_;
  std::map<SourceId, std::pair<std::uint32_t, std::uint32_t>> asked_;
  Json actions_ = Json::array();
};

}  // namespace

std::vector<std::string> commands() { return {kExplain}; }

Json code_actions(Context& context, const Json& params) { return Actions(context, params).run(); }

Json execute_command(Context& context, const Json& params) {
  const Json& arguments = at(params, {"arguments"});
  const bool is_known = text_at(params, {"command"}) == kExplain && arguments.is_array() &&
                        !arguments.empty() && arguments[0].is_string();
  const Rule* rule = is_known ? find_rule(arguments[0].get<std::string>()) : nullptr;
  if (rule == nullptr) throw RequestError(kInvalidParams, "there is no such command or rule");
  const std::string page = render_rule(*rule, {});
  context.send({{"jsonrpc", "2.0"},
                {"method", "window/showMessage"},
                {"params", {{"type", kInfo}, {"message", page}}}});
  return page;
}

}  // namespace smurf::lsp
