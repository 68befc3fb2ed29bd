// SPDX-License-Identifier: BSD-3-Clause
// The report as a page: web/report around the JSON report, with the rules, the lines around each
// mark and the changes of the fixes. web/report/main.js reads the members and documents them.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "render/fix_hunks.hpp"
#include "render/printable.hpp"
#include "render/report_json.hpp"
#include "render/report_page.hpp"
#include "render/verdict_text.hpp"

namespace smurf {
namespace {

using render::Json;
using render::text;

constexpr std::uint32_t kContext = 2;  ///< lines before and after each mark
/// Lines shown of one mark; a longer mark shows only its first and last lines.
constexpr std::uint32_t kMostExcerptLines = 12;
constexpr std::size_t kMostText = 16'000'000;  ///< bytes of lines in a page

struct Lines {
  std::uint32_t first = 1;
  std::uint32_t last = 1;
  friend bool operator<(const Lines& a, const Lines& b) { return a.first < b.first; }
};

/// Names and messages as in the terminal, with visible control characters.
void make_visible(Json& json) {
  if (json.is_string()) {
    json = render::escape(json.get_ref<const std::string&>());
  } else if (json.is_structured()) {
    for (Json& part : json) make_visible(part);
  }
}

/// The lines around the marks of a source, each line once.
class Excerpts {
 public:
  explicit Excerpts(const SourceMap& sources) : sources_(sources) {}

  void add(Span span) {
    if (!has_text(span)) return;
    const SourceId source = span.source;
    const auto size = static_cast<std::uint32_t>(sources_.text(source).size());
    const std::uint32_t begin = std::min(span.begin, size);
    const std::uint32_t first = sources_.line_of(source, begin);
    const std::uint32_t last = sources_.line_of(source, std::clamp(span.end, begin, size));
    if (last - first <= kMostExcerptLines) {
      add(source, first, last);
    } else {
      add(source, first, first + kMostExcerptLines / 2);
      add(source, last - kMostExcerptLines / 2, last);
    }
  }

  /// By number of the source: [{"first", "lines"}], or "" for an omitted source.
  Json json() {
    Json all = Json::object();
    std::size_t left = kMostText;
    for (auto& [source, marked] : lines_) {
      std::sort(marked.begin(), marked.end());
      Json parts = Json::array();
      bool fits = true;
      for (std::size_t i = 0; i < marked.size() && fits;) {
        Lines part = marked[i++];
        while (i < marked.size() && marked[i].first <= part.last + 1) {
          part.last = std::max(part.last, marked[i++].last);
        }
        const std::string text = text_of(source, part);
        fits = text.size() <= left;
        left -= fits ? text.size() : 0;
        parts.push_back({{"first", part.first}, {"lines", text}});
      }
      all[std::to_string(static_cast<std::uint32_t>(source))] = fits ? std::move(parts) : Json("");
    }
    return all;
  }

 private:
  bool has_text(Span span) const {
    return static_cast<std::size_t>(span.source) < sources_.size() &&
           sources_.is_readable(span.source) && !sources_.text(span.source).empty();
  }

  void add(SourceId source, std::uint32_t first, std::uint32_t last) {
    std::uint32_t end = sources_.line_count(source);
    // The last line end begins an empty line that no editor shows.
    if (end > last && sources_.line_span(source, end).empty()) --end;
    lines_[source].push_back(
        {first - std::min(first - 1, kContext), last + std::min(end - last, kContext)});
  }

  std::string text_of(SourceId source, Lines lines) const {
    std::string text;
    for (std::uint32_t line = lines.first; line <= lines.last; ++line) {
      if (line > lines.first) text += '\n';
      text += render::visible_lines(sources_.text(sources_.line_span(source, line)));
    }
    return text;
  }

  const SourceMap& sources_;
  std::map<SourceId, std::vector<Lines>> lines_;
};

class PageData {
 public:
  PageData(const SourceMap& sources, std::span<const TargetVerdict> targets)
      : sources_(sources), targets_(targets) {}

  Json diagnostic(const Diagnostic& diagnostic) const {
    Json json = render::finding_json(diagnostic, sources_);
    if (!diagnostic.caret.empty()) json["caret"] = diagnostic.caret;
    if (diagnostic.named_pointer != diagnostic.pointer) json["names"] = diagnostic.named_pointer;
    make_visible(json);
    json["source"] = static_cast<std::uint32_t>(diagnostic.span.source);
    for (std::size_t i = 0; i < diagnostic.labels.size(); ++i) {
      json["labels"][i]["source"] = static_cast<std::uint32_t>(diagnostic.labels[i].span.source);
    }
    for (const TargetVerdict& target : targets_) {
      const Fact* fact = find_fact(*target.reader, diagnostic);
      if (fact == nullptr || fact->effect <= Effect::ignores) continue;
      json["effects"][std::string(target.reader->name)] = text(to_string(fact->effect));
    }
    if (diagnostic.fixes.empty()) return json;
    const Fix& fix = diagnostic.fixes.front();
    json["fix"] = {{"is_safe", fix.applicability == Applicability::safe},
                   {"hunks", render::fix_hunks(fix, sources_)}};
    return json;
  }

 private:
  const SourceMap& sources_;
  std::span<const TargetVerdict> targets_;
};

/// The rules of all findings and verdicts, as an object with the rule ids as keys.
Json rules_of(std::span<const Diagnostic> diagnostics, std::span<const TargetVerdict> targets) {
  std::map<std::string_view, const Rule*> rules;
  for (const Diagnostic& one : diagnostics) rules[one.rule->id] = one.rule;
  for (const TargetVerdict& target : targets) {
    if (target.fact != nullptr) rules[target.rule->id] = target.rule;
    for (const Rule* rule : target.unknown_rules) rules[rule->id] = rule;
  }
  Json json = Json::object();
  for (const auto& [id, rule] : rules) {
    Json entry = render::rule_json(*rule);
    for (const Fact* fact : facts_about(*rule)) {
      entry["facts"].push_back({{"text", describe(*fact)}, {"evidence", evidence_of(*fact)}});
    }
    json[std::string(id)] = std::move(entry);
  }
  return json;
}

}  // namespace

std::string render_html(std::span<const Diagnostic> diagnostics, const SourceMap& sources,
                        const Summary& summary, const ToolName& tool,
                        std::span<const TargetVerdict> targets, const PageParts& parts) {
  Json report = render::report_json(sources, summary, tool, targets);
  for (const TargetVerdict& target : targets) {
    Json& json = report["targets"][std::string(target.reader->name)];
    make_visible(json);
    json["title"] = text(target.reader->title);
    json["answer"] = render::verdict_of(target, render::Painter(false));
  }
  for (const RobotAnswers& robot : parts.robots) {
    Json answers = Json::array();
    for (const Answer answer : robot.answers) answers.push_back(text(to_string(answer)));
    report["robots"].push_back({{"file", render::escape(robot.path)}, {"answers", answers}});
  }
  report["remarks"] = text(parts.remarks);
  if (!parts.picture.empty()) report["picture"] = text(parts.picture);
  report["rules"] = rules_of(diagnostics, targets);
  Excerpts excerpts(sources);
  for (const Diagnostic& one : diagnostics) {
    excerpts.add(one.span);
    for (const Label& label : one.labels) excerpts.add(label.span);
  }
  report["sources"] = excerpts.json();
  const PageData data(sources, targets);
  return page_around(report_page(), render::dump_with_list(report, "diagnostics", 1, diagnostics,
                                                           [&](const Diagnostic& one) {
                                                             return data.diagnostic(one);
                                                           }));
}

}  // namespace smurf
