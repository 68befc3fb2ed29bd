// SPDX-License-Identifier: BSD-3-Clause
// SARIF 2.1.0 (OASIS), with the requirements of GitHub code scanning beyond the schema: rules with
// texts of at most 1024 characters, complete regions, paths from the top of the repository,
// fingerprints.
#include <map>

#include "base/files/uri.hpp"
#include "base/text/utf8.hpp"
#include "render/json_text.hpp"
#include "render/line_hash.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

using render::Json;
using render::text;

constexpr std::string_view kSchema =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";
constexpr std::size_t kLongestDescription = 1024;

std::string_view level(Severity severity) {
  switch (severity) {
  case Severity::error: return "error";
  case Severity::warning: return "warning";
  case Severity::info: break;
  }
  return "note";
}

/// "unknown-joint" as "UnknownJoint".
std::string pascal_case(std::string_view name) {
  std::string out;
  bool starts_word = true;
  for (const char c : name) {
    const bool is_lower = c >= 'a' && c <= 'z';
    if (c != '-') out += starts_word && is_lower ? static_cast<char>(c - 'a' + 'A') : c;
    starts_word = c == '-';
  }
  return out;
}

/// A path as a URI reference; what lies outside the repository becomes a file: URI.
std::string to_uri(const std::string& path) {
  return (path.starts_with('/') ? "file://" : "") + encoded_uri(path, "-._~/!$&'()*+,;=@");
}

/// The reason of the rule and the facts about readers; the summary if there are none.
std::string full_description(const Rule& rule) {
  std::string description(rule.why);
  for (const Fact* fact : facts_about(rule)) {
    description += (description.empty() ? "" : " ") + describe(*fact) + ".";
  }
  return description.empty() ? std::string(rule.summary) : description;
}

/// A name such as "[click](http://...)" would be a link in a message (SARIF 3.11.6).
std::string without_links(std::string_view message) {
  std::string out;
  for (const char c : message) {
    if (c == '(' && out.ends_with(']')) out.insert(out.size() - 1, 1, '\\');
    out += c;
  }
  return out;
}

std::string cut(std::string_view description) {
  if (description.size() <= kLongestDescription) return std::string(description);
  std::size_t end = kLongestDescription - 3;
  while (end > 0 && utf8::is_continuation(description[end])) --end;
  return std::string(description.substr(0, end)) + "...";
}

class Log {
 public:
  Log(const SourceMap& sources, std::span<const Rule* const> rules,
      const RepositoryPath& in_repository)
      : sources_(sources), rules_(rules), in_repository_(in_repository) {
    for (std::size_t i = 0; i < rules.size(); ++i) rule_index_.emplace(rules[i]->id, i);
  }

  Json driver(const ToolName& tool, std::string_view site) const {
    Json rules = Json::array();
    for (const Rule* rule : rules_) {
      rules.push_back({{"id", text(rule->id)},
                       {"name", pascal_case(rule->name)},
                       {"shortDescription", {{"text", cut(rule->summary)}}},
                       {"fullDescription", {{"text", cut(full_description(*rule))}}},
                       {"help", {{"text", text(rule->remedy)}}},
                       {"helpUri", rule_address(*rule, site)},
                       {"defaultConfiguration", {{"level", text(level(rule->severity))}}},
                       {"properties",
                        {{"tags", {"robotics", "smurf"}},
                         {"problem.severity", rule->severity == Severity::info
                                                  ? Json("recommendation")
                                                  : text(to_string(rule->severity))}}}});
    }
    return {{"name", text(tool.name)},
            {"version", text(tool.version)},
            {"semanticVersion", text(tool.version)},
            {"informationUri", text(site)},
            {"rules", std::move(rules)}};
  }

  Json result(const Diagnostic& diagnostic) {
    Json result;
    result["ruleId"] = text(diagnostic.rule->id);
    if (const auto index = rule_index_.find(diagnostic.rule->id); index != rule_index_.end()) {
      result["ruleIndex"] = index->second;
    }
    result["level"] = text(level(diagnostic.severity));
    std::string message = diagnostic.message;
    if (!diagnostic.help_text.empty()) message += "; " + diagnostic.help_text;
    result["message"] = {{"text", without_links(message)}};
    Json location = place(diagnostic.span);
    if (!diagnostic.pointer.empty()) {
      location["logicalLocations"] = {{{"fullyQualifiedName", diagnostic.pointer}}};
    }
    result["locations"] = Json::array({std::move(location)});
    for (std::size_t i = 0; i < diagnostic.labels.size(); ++i) {
      const Label& label = diagnostic.labels[i];
      Json related = place(label.span);
      related["id"] = i + 1;
      related["message"] = {{"text", without_links(label.message)}};
      result["relatedLocations"].push_back(std::move(related));
    }
    result["partialFingerprints"] = {{"primaryLocationLineHash", fingerprint(diagnostic.span)}};
    for (const Fix& one : diagnostic.fixes) result["fixes"].push_back(fix(one, diagnostic));
    return result;
  }

  /// What was not compared with a robot is about the run, and no result.
  Json invocation(const Summary& summary) const {
    Json invocation = {{"executionSuccessful", true}};
    for (const NotCompared& one : summary.not_compared) {
      const Json file = {{"artifactLocation", {{"uri", to_uri(in_repository_(one.path))}}}};
      const std::string message = "not compared with a robot: " + one.reason + "; " + one.next;
      invocation["toolExecutionNotifications"].push_back(
          {{"descriptor", {{"id", "not-compared"}}},
           {"level", summary.is_strict ? "error" : "warning"},
           {"message", {{"text", without_links(message)}}},
           {"locations", Json::array({{{"physicalLocation", file}}})}});
    }
    return invocation;
  }

 private:
  Json artifact(Span span) const {
    return {{"uri", to_uri(in_repository_(render::path_of(span, sources_)))}};
  }

  Json region(Span span) const {
    const auto [begin, end] = render::region_of(span, sources_);
    return {{"startLine", begin.line},
            {"startColumn", begin.column},
            {"endLine", end.line},
            {"endColumn", end.column}};
  }

  Json place(Span span) const {
    Json location = {{"artifactLocation", artifact(span)}, {"region", region(span)}};
    constexpr std::uint32_t kMostSnippet = 4000;  // bytes; a longer text is omitted
    const bool is_known = static_cast<std::size_t>(span.source) < sources_.size();
    const bool is_short = span.end - span.begin <= kMostSnippet;
    if (is_known && is_short && !span.empty() && span.end <= sources_.text(span.source).size()) {
      location["region"]["snippet"] = {{"text", text(sources_.text(span))}};
    }
    return {{"physicalLocation", std::move(location)}};
  }

  Json fix(const Fix& fix, const Diagnostic& diagnostic) const {
    std::map<std::string, Json> changes;
    for (const Edit& edit : fix.edits) {
      Json replacement = {{"deletedRegion", region(edit.span)}};
      if (!edit.text.empty()) replacement["insertedContent"] = {{"text", edit.text}};
      Json& change = changes[render::path_of(edit.span, sources_)];
      change["artifactLocation"] = artifact(edit.span);
      change["replacements"].push_back(std::move(replacement));
    }
    Json list = Json::array();
    for (auto& [path, change] : changes) list.push_back(std::move(change));
    const std::string_view kind =
        fix.applicability == Applicability::safe ? "safe fix" : "unsafe fix";
    const std::string description = diagnostic.help_text.empty()
                                        ? std::string(kind)
                                        : diagnostic.help_text + " (" + std::string(kind) + ")";
    return {{"description", {{"text", without_links(description)}}},
            {"artifactChanges", std::move(list)}};
  }

  std::string fingerprint(Span span) {
    static const std::string kOfNoText = render::LineHashes("").of(0);
    if (static_cast<std::size_t>(span.source) >= sources_.size()) return kOfNoText;
    auto hashes = hashes_.find(span.source);
    if (hashes == hashes_.end()) {
      const render::LineHashes made(sources_.text(span.source));
      hashes = hashes_.emplace(span.source, made).first;
    }
    return hashes->second.of(render::region_of(span, sources_).begin.line - 1);
  }

  const SourceMap& sources_;
  std::span<const Rule* const> rules_;
  const RepositoryPath& in_repository_;
  std::map<std::string_view, std::size_t> rule_index_;
  std::map<SourceId, render::LineHashes> hashes_;
};

}  // namespace

std::string render_sarif(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                         std::span<const Rule* const> rules, const ToolName& tool,
                         std::string_view site, const RepositoryPath& in_repository,
                         const Summary& summary) {
  Log log(sources, rules, in_repository);
  const Json run = {{"tool", {{"driver", log.driver(tool, site)}}},
                    {"automationDetails", {{"id", std::string(tool.name) + "/"}}},
                    {"columnKind", "unicodeCodePoints"},
                    {"invocations", Json::array({log.invocation(summary)})},
                    {"results", Json::array()}};
  return render::dump_with_list({{"$schema", text(kSchema)}, {"version", "2.1.0"}, {"runs", {run}}},
                                "results", 3, diagnostics,
                                [&](const Diagnostic& one) { return log.result(one); });
}

}  // namespace smurf
