// SPDX-License-Identifier: BSD-3-Clause
// Diagnostics for people: the full layout, the one-line layout, the summary and the statistics.
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"
#include "render/advice.hpp"
#include "render/frame.hpp"
#include "render/paint.hpp"
#include "render/printable.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

using render::escape;
using render::Ink;
using render::Painter;

bool has_source(Span span, const SourceMap& sources) {
  return static_cast<std::size_t>(span.source) < sources.size();
}

/// A file that could not be read or is empty has no line to show.
bool has_text(Span span, const SourceMap& sources) {
  return has_source(span, sources) && sources.is_readable(span.source) &&
         !sources.text(span.source).empty();
}

Span clamp(Span span, const SourceMap& sources) {
  const auto size = static_cast<std::uint32_t>(sources.text(span.source).size());
  span.begin = std::min(span.begin, size);
  span.end = std::clamp(span.end, span.begin, size);
  return span;
}

std::string place(Span span, const SourceMap& sources) {
  const Position position = sources.position(span.source, clamp(span, sources).begin);
  return escape(sources.path(span.source)) + ":" + std::to_string(position.line) + ":" +
         std::to_string(position.column);
}

std::string arrow(std::size_t indent, std::string_view where, const Painter& paint) {
  return std::string(indent, ' ') + paint(Ink::frame, "-->") + " " + std::string(where) + "\n";
}

/// A note about a fix without a help text.
std::string describe(const Fix& fix, const SourceMap& sources) {
  constexpr std::size_t kLongest = 60;
  if (fix.edits.size() == 1 && has_source(fix.edits[0].span, sources)) {
    const Edit& edit = fix.edits[0];
    const std::string_view old = sources.text(clamp(edit.span, sources));
    if (edit.text.empty() && old.size() <= kLongest) return "delete `" + std::string(old) + "`";
    if (edit.text.size() <= kLongest) {
      return (old.empty() ? "insert `" : "write `") + edit.text + "`";
    }
  }
  return "see the fix with `--diff`";
}

std::string header(const Diagnostic& diagnostic, const Painter& paint) {
  const std::string severity =
      std::string(to_string(diagnostic.severity)) + "[" + std::string(diagnostic.rule->id) + "]";
  return paint(render::ink_of(diagnostic.severity), severity) +
         paint(Ink::strong, ": " + escape(diagnostic.message)) + "\n";
}

/// "= note: ..." rows under a frame.
std::string remarks(const Diagnostic& diagnostic, const SourceMap& sources, std::size_t indent,
                    const Painter& paint) {
  const auto remark = [&](std::string_view kind, std::string_view text) {
    return std::string(indent + 1, ' ') + paint(Ink::frame, "=") + " " + paint(Ink::strong, kind) +
           ": " + escape(text) + "\n";
  };
  std::string out;
  for (const std::string& note : diagnostic.notes) out += remark("note", note);
  std::string help = render::advice_on(diagnostic);
  if (!diagnostic.fixes.empty()) {
    const Fix& fix = diagnostic.fixes.front();
    if (help.empty()) help = describe(fix, sources);
    help += fix.applicability == Applicability::safe ? " [safe fix]" : " [unsafe fix]";
  }
  if (!help.empty()) out += remark("help", help);
  return out;
}

/// A label in another file than the diagnostic.
std::string note_frame(const Label& label, const SourceMap& sources, const TextStyle& style) {
  const Painter paint(style.color);
  std::string out = paint(Ink::strong, "note: " + escape(label.message)) + "\n";
  if (!has_source(label.span, sources)) return out;
  if (!has_text(label.span, sources)) {
    return out + arrow(1, escape(sources.path(label.span.source)), paint);
  }
  // As for labels in the same file, the first line is enough: a call may have twenty.
  Span shown = clamp(label.span, sources);
  const Span line = sources.line_span(shown.source, sources.line_of(shown.source, shown.begin));
  shown.end = std::clamp(shown.end, shown.begin, std::max(shown.begin, line.end));
  const render::Frame frame(sources, style, {shown, {}, Ink::frame, '-'}, {}, 0);
  return out + arrow(frame.gutter(), place(label.span, sources), paint) + frame.draw();
}

std::string main_frame(const Diagnostic& diagnostic, const SourceMap& sources,
                       const TextStyle& style) {
  const Painter paint(style.color);
  if (!has_source(diagnostic.span, sources)) return remarks(diagnostic, sources, 1, paint);
  if (!has_text(diagnostic.span, sources)) {
    return arrow(1, escape(sources.path(diagnostic.span.source)), paint) +
           remarks(diagnostic, sources, 1, paint);
  }
  // The lines of a text in UTF-16 would be marks for what cannot be read.
  if (diagnostic.rule == &rules::sml0005_unsupported_encoding) {
    return arrow(1, place(diagnostic.span, sources), paint) +
           remarks(diagnostic, sources, 1, paint);
  }
  constexpr std::size_t kMostMarks = 5;  // a finding about thirty links is still one
  std::vector<render::Mark> others;
  for (const Label& label : diagnostic.labels) {
    if (label.span.source != diagnostic.span.source || others.size() == kMostMarks) continue;
    others.push_back({clamp(label.span, sources), label.message, Ink::frame, '-'});
  }
  const render::Frame frame(
      sources, style,
      {clamp(diagnostic.span, sources), diagnostic.caret, render::ink_of(diagnostic.severity), '^'},
      std::move(others), 1);
  return arrow(frame.gutter(), place(diagnostic.span, sources), paint) + frame.draw() +
         remarks(diagnostic, sources, frame.gutter(), paint);
}

}  // namespace

Summary summarize(std::span<const Diagnostic> diagnostics) {
  Summary summary;
  for (const Diagnostic& diagnostic : diagnostics) {
    switch (diagnostic.severity) {
    case Severity::error: ++summary.errors; break;
    case Severity::warning: ++summary.warnings; break;
    case Severity::info: ++summary.infos; break;
    }
  }
  return summary;
}

std::string render_full(const Diagnostic& diagnostic, const SourceMap& sources,
                        const TextStyle& style) {
  const Painter paint(style.color);
  std::string out = header(diagnostic, paint) + main_frame(diagnostic, sources, style);
  for (const Label& label : diagnostic.labels) {
    if (label.span.source != diagnostic.span.source || !has_text(diagnostic.span, sources)) {
      out += note_frame(label, sources, style);
    }
  }
  return out + "\n";
}

std::string render_concise(const Diagnostic& diagnostic, const SourceMap& sources,
                           const TextStyle& style) {
  const Painter paint(style.color);
  std::string out;
  if (has_source(diagnostic.span, sources)) out = place(diagnostic.span, sources) + ": ";
  out += paint(render::ink_of(diagnostic.severity), to_string(diagnostic.severity));
  out += "[" + std::string(diagnostic.rule->id) + "] " + escape(diagnostic.message);
  if (!diagnostic.help_text.empty()) out += " (" + escape(diagnostic.help_text) + ")";
  return out + "\n";
}

std::string render_brief(const Diagnostic& diagnostic, const SourceMap& sources, bool has_help,
                         const TextStyle& style) {
  const Painter paint(style.color);
  std::string out = header(diagnostic, paint);
  if (has_source(diagnostic.span, sources)) out += arrow(2, place(diagnostic.span, sources), paint);
  Diagnostic advice;
  advice.rule = diagnostic.rule;
  advice.severity = Severity::info;
  if (has_help) advice.help_text = render::advice_on(diagnostic);
  return out + remarks(advice, sources, 2, paint);
}

namespace {

/// "2 SRDFs and 1 controllers.yaml"
/// Of SRDFs that a user named: the robots with which they were compared.
std::string robots_of_srdfs(const Summary& summary) {
  constexpr std::size_t kMostShown = 3;
  std::vector<std::string> shown;
  for (const std::string& robot : summary.robots_of_srdfs) {
    if (!robot.empty()) shown.push_back(quoted(render::escape(robot)));
  }
  const bool has_lone = summary.robots_of_srdfs.contains("");
  if (shown.size() > kMostShown) return ", compared with " + counted(shown.size(), "robot");
  std::string text = shown.empty() ? "" : ", compared with " + enumerated(shown);
  return text + (has_lone ? ", an SRDF without its robot" : "");
}

/// Values of arguments from launch files, and what targets judge instead of a file.
std::string assumptions(const Summary& summary) {
  constexpr std::size_t kMostShown = 6;
  std::string text;
  std::size_t count = 0;
  for (const std::string& one : summary.assumptions) {
    if (++count <= kMostShown) text += "checked " + render::escape(one) + "\n";
  }
  if (count > kMostShown) {
    text +=
        "checked " + counted(count - kMostShown, "more robot") + " with values in launch files\n";
  }
  return text;
}

/// The companions that were not compared, those with the same reason together.
std::string not_compared(const Summary& summary) {
  constexpr std::size_t kMostShown = 3;  // files of a reason
  constexpr std::size_t kMostReasons = 8;
  std::vector<std::pair<const NotCompared*, std::vector<std::string>>> groups;
  for (const NotCompared& one : summary.not_compared) {
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& other) {
      return other.first->reason == one.reason && other.first->next == one.next;
    });
    if (group == groups.end()) group = groups.insert(groups.end(), {&one, {}});
    group->second.push_back(quoted(render::escape(one.path)));
  }
  std::string text;
  for (std::size_t i = 0; i < groups.size() && i < kMostReasons; ++i) {
    const auto& [first, files] = groups[i];
    text += (summary.is_strict ? "error: not compared: " : "not compared: ") +
            enumerated_to(kMostShown, files) + ": " + render::escape(first->reason) + "; " +
            render::escape(first->next) + "\n";
  }
  if (groups.size() > kMostReasons) {
    text += "not compared: files with " + counted(groups.size() - kMostReasons, "more reason") +
            "; --format json lists all of them\n";
  }
  return text;
}

std::string companions_of(const Summary& summary) {
  std::vector<std::string> parts;
  for (const auto& [title, count] : summary.companions) {
    const bool is_file_name = title.find('.') != std::string_view::npos;
    parts.push_back(is_file_name ? std::to_string(count) + " " + std::string(title)
                                 : counted(count, title));
  }
  return enumerated(parts);
}

}  // namespace

std::string render_summary(const Summary& summary, const TextStyle& style) {
  const Painter paint(style.color);
  std::vector<std::string> found;
  if (summary.errors > 0) found.push_back(paint(Ink::error, counted(summary.errors, "error")));
  if (summary.warnings > 0) {
    found.push_back(paint(Ink::warning, counted(summary.warnings, "warning")));
  }
  if (summary.infos > 0) found.push_back(paint(Ink::info, counted(summary.infos, "info")));
  std::string out = found.empty() ? "no findings" : "found " + enumerated(found);
  out += " in " + counted(summary.files, "file");

  std::vector<std::string> loaded;
  if (summary.models > 0) loaded.push_back(counted(summary.models, "model"));
  if (summary.scenes > 0) loaded.push_back(counted(summary.scenes, "scene"));
  if (loaded.size() == 2) {
    out += " (" + loaded[0] + ", " + loaded[1] + ")";
  } else if (loaded.size() == 1) {
    out += " (" + loaded[0] + ")";
  }
  if (!summary.companions.empty()) out += ", checked with " + companions_of(summary);
  out += robots_of_srdfs(summary);
  out += "\n";
  if (summary.suppressed > 0) out += std::to_string(summary.suppressed) + " suppressed\n";
  if (summary.links > 0) {
    const bool is_one = summary.links == 1;
    out += counted(summary.links, "symbolic link") + (is_one ? " that leads" : " that lead") +
           " out of the folder " + (is_one ? "was" : "were") +
           " not followed; name what to check there\n";
  }
  return out + assumptions(summary) + not_compared(summary);
}

std::string render_statistics(std::span<const Diagnostic> diagnostics, const TextStyle& style,
                              std::size_t most) {
  const Painter paint(style.color);
  using Key = std::pair<std::string_view, Severity>;
  std::map<Key, std::pair<const Rule*, std::size_t>> counts;
  std::size_t digits = 1;
  for (const Diagnostic& diagnostic : diagnostics) {
    auto& [rule, number] = counts[{diagnostic.rule->id, diagnostic.severity}];
    rule = diagnostic.rule;
    digits = std::max(digits, std::to_string(++number).size());
  }
  std::vector<std::pair<Key, std::pair<const Rule*, std::size_t>>> rows(counts.begin(),
                                                                        counts.end());
  std::stable_sort(rows.begin(), rows.end(),
                   [](const auto& a, const auto& b) { return a.second.second > b.second.second; });
  if (rows.size() > most) rows.resize(most);
  std::string out;
  for (const auto& [key, value] : rows) {
    const std::string number = std::to_string(value.second);
    const std::string_view severity = to_string(key.second);
    out += std::string(digits - number.size(), ' ') + number + "  ";
    out += paint(render::ink_of(key.second), severity) + std::string(9 - severity.size(), ' ');
    out += std::string(value.first->id) + " " + std::string(value.first->name) + "\n";
  }
  return out;
}

}  // namespace smurf
