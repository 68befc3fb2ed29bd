// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/yaml_errors.hpp"

#include <algorithm>
#include <cctype>
#include <string>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "syntax/text_check.hpp"

namespace smurf {
namespace {

/// yaml-cpp's messages are about its grammar; these are about the file.
std::string explain(std::string_view words) {
  struct Row {
    std::string_view yaml_cpp;
    std::string_view ours;
  };
  constexpr Row kRows[] = {
      {"bad file", "the lists and mappings are nested too deeply to be read"},
      {"illegal map value", "a second `:` on this line, or a value where none is allowed; quote "
                            "the value if it contains a colon"},
      {"end of map not found", "this line does not fit the mapping above: its indentation or a "
                               "missing `:` breaks it"},
      {"end of sequence not found", "this line does not fit the list above: its indentation or a "
                                    "missing `-` breaks it"},
  };
  for (const Row& row : kRows) {
    if (words == row.yaml_cpp) return std::string(row.ours);
  }
  return std::string(words);
}

/// Counts brackets without parsing their contents, because only the wording depends on the result.
bool is_closed(std::string_view text, std::uint32_t bracket) {
  int depth = 0;
  for (const char c : text.substr(bracket)) {
    if (c == '[' || c == '{') ++depth;
    if ((c == ']' || c == '}') && --depth == 0) return true;
  }
  return false;
}

/// The innermost open bracket at a place that the parser has not reported yet. Comments are
/// skipped, texts are not.
Span open_before(std::string_view text, std::uint32_t at, SourceId id) {
  std::vector<std::uint32_t> open;
  bool is_comment = false;
  for (std::uint32_t i = 0; i < at && i < text.size(); ++i) {
    const char c = text[i];
    is_comment = c != '\n' && (is_comment || (c == '#' && (i == 0 || text[i - 1] == ' ')));
    if (is_comment) continue;
    if (c == '[' || c == '{') open.push_back(i);
    if ((c == ']' || c == '}') && !open.empty()) open.pop_back();
  }
  return open.empty() ? Span{id, 0, 0} : Span{id, open.back(), open.back() + 1};
}

/// Reports text in brackets where only a comma or the closing bracket is allowed.
void report_in_brackets(std::uint32_t at, Span bracket, std::string_view text,
                        DiagnosticSink& sink) {
  const std::string open(text.substr(bracket.begin, 1));
  if (at <= bracket.begin || at >= text.size() || !is_closed(text, bracket.begin)) {
    sink.report(rules::sml0010_yaml_syntax, bracket, "this `" + open + "` is never closed");
    return;
  }
  sink.report(rules::sml0010_yaml_syntax, {bracket.source, at, at + 1},
              "a `,` or `" + std::string(open == "[" ? "]" : "}") + "` is missing before this")
      .label(bracket, "opened here");
}

/// The words of the line before `at` if a key there lacks its `:`, as in "- name elbow". The parser
/// takes this line and the next one for a single text, and stops at the `:` of the next one.
Span key_without_colon(std::string_view text, std::uint32_t at, SourceId id) {
  const std::size_t line = text.rfind('\n', at) + 1;
  if (line < 2) return {};
  const std::size_t before = text.rfind('\n', line - 2) + 1;
  const std::size_t begin = text.find_first_not_of(" -", before);
  std::size_t end = line - 1;
  while (end > before && (text[end - 1] == ' ' || text[end - 1] == '\r')) --end;
  if (begin >= end) return {};
  const std::string_view words = text.substr(begin, end - begin);
  const bool is_key = std::isalpha(static_cast<unsigned char>(words.front())) != 0;
  const bool is_aligned = text.find_first_not_of(' ', line) - line == begin - before;
  if (!is_key || !is_aligned || words.find(':') != std::string_view::npos) return {};
  return {id, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(end)};
}

}  // namespace

void report_parser_error(std::string_view words, int place, Span bracket, const SourceMap& sources,
                         DiagnosticSink& sink) {
  const SourceId id = bracket.source;
  const std::string_view text = sources.text(id);
  const std::uint32_t shift = byte_order_mark_size(text);
  const auto size = static_cast<std::uint32_t>(text.size());
  std::uint32_t at = std::min(static_cast<std::uint32_t>(std::max(place, 0)) + shift, size);
  const bool is_in_brackets = !bracket.empty() && bracket.begin < size;
  if (is_in_brackets && (words.ends_with("flow not found") || !is_closed(text, bracket.begin))) {
    return report_in_brackets(at, bracket, text, sink);
  }
  if (words.starts_with("illegal block entry") && bracket.empty()) {
    const Span open = open_before(text, at, id);
    if (!open.empty()) return report_in_brackets(size, open, text, sink);
  }
  if (words == "illegal map value" && bracket.empty() && at > 0) {
    if (const Span key = key_without_colon(text, at - 1, id); !key.empty()) {
      sink.report(rules::sml0010_yaml_syntax, key, quoted(sources.text(key)) + " has no `:`")
          .help("write `KEY: VALUE`");
      return;
    }
  }
  std::string message = explain(words);
  std::string help;  // "": that of the rule
  // yaml-cpp reports a tab in the indentation at the following colon, with another message.
  const std::size_t line_start = at == 0 ? 0 : text.rfind('\n', at - 1) + 1;
  const std::size_t content = std::min(text.find_first_not_of(" \t", line_start), text.size());
  const std::string_view indent = text.substr(line_start, content - line_start);
  if (const std::size_t tab = indent.find('\t'); tab != std::string_view::npos && bracket.empty()) {
    at = static_cast<std::uint32_t>(line_start + tab);
    message = "a tab is used for indentation; YAML allows only spaces there";
    help = "replace the tab by spaces, so that the line begins where its neighbours do";
  }
  const bool is_escape = words.starts_with("unknown escape character") ||
                         words.starts_with("bad character found while scanning hex") ||
                         words.starts_with("invalid unicode");
  if (const std::size_t escape = text.rfind('\\', at); is_escape && escape != text.npos) {
    at = static_cast<std::uint32_t>(escape);
  }
  const std::uint32_t end = at < size && text[at] != '\n' && text[at] != '\r' ? at + 1 : at;
  Diagnostic& found = sink.report(rules::sml0010_yaml_syntax, {id, at, end}, message);
  if (!help.empty()) found.help(std::move(help));
}

}  // namespace smurf
