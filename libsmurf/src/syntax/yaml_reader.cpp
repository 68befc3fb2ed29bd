// SPDX-License-Identifier: BSD-3-Clause
// Builds our tree from yaml-cpp's events, never from YAML::Node (which loses duplicate keys and is
// slow), and reports constructs that yaml-cpp accepts but stricter readers refuse.
#include "syntax/yaml_reader.hpp"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <streambuf>
#include <utility>
#include <vector>

#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "syntax/plain_yaml.hpp"
#include "syntax/text_check.hpp"
#include "syntax/yaml_builder.hpp"
#include "syntax/yaml_errors.hpp"
#include "syntax/yaml_events.hpp"

namespace smurf {
namespace {

/// Reads from memory owned by the caller.
class ViewBuffer final : public std::streambuf {
 public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // never written to: no put area is set
    setg(begin, begin, begin + text.size());
  }
};

/// Notices a second document and ignores its contents.
class SecondDocument final : public YAML::EventHandler {
 public:
  void OnDocumentStart(const YAML::Mark& mark) override { start = mark; }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark&, YAML::anchor_t) override {}
  void OnAlias(const YAML::Mark&, YAML::anchor_t) override { found(); }
  void OnScalar(const YAML::Mark&, const std::string&, YAML::anchor_t,
                const std::string&) override {
    found();
  }
  void OnSequenceStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    found();
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark&, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    found();
  }
  void OnMapEnd() override {}

  YAML::Mark start;
  bool has_content = false;

 private:
  void found() {
    has_content = true;
    throw StopParsing();
  }
};

/// `first_end` is the end of the content of the first document.
void check_second_document(YAML::Parser& parser, std::string_view text, std::uint32_t first_end,
                           SourceId id, DiagnosticSink& sink) {
  SecondDocument second;
  try {
    parser.HandleNextDocument(second);
  } catch (const StopParsing&) {
  } catch (const YAML::Exception&) {
    second.has_content = true;
  }
  if (!second.has_content) return;
  const std::uint32_t at = std::min(static_cast<std::uint32_t>(std::max(second.start.pos, 0)) +
                                        byte_order_mark_size(text),
                                    static_cast<std::uint32_t>(text.size()));
  // yaml-cpp ends a document at a line that does not fit; only document marks may end it.
  const std::string_view between = text.substr(first_end, std::max(at, first_end) - first_end);
  const bool has_mark =
      text.substr(at).starts_with("---") || between.find("\n...") != std::string_view::npos;
  if (!has_mark) {
    sink.report(rules::sml0010_yaml_syntax, {id, at, at + 1},
                "this line does not fit the lines above it");
    return;
  }
  sink.report(rules::sml0013_several_documents, {id, at, at}, "a second YAML document begins here")
      .note("MARS reads the first document and drops the rest, PyYAML (Phobos) refuses the file");
}

/// yaml-cpp reads merge conflict markers as text, or silently ends the document there.
std::optional<Span> find_merge_mark(std::string_view text, SourceId id) {
  std::size_t first = std::string_view::npos;
  for (const std::string_view mark : {"<<<<<<< ", ">>>>>>> "}) {
    std::size_t at = text.find(mark);
    while (at != std::string_view::npos && at > 0 && text[at - 1] != '\n' && text[at - 1] != '\r') {
      at = text.find(mark, at + 1);
    }
    first = std::min(first, at);
  }
  if (first == std::string_view::npos) return std::nullopt;
  const std::size_t end = std::min(text.find_first_of("\r\n", first), text.size());
  return Span{id, static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(end)};
}

bool is_content(std::string_view line) {
  const std::size_t first = line.find_first_not_of(" \t");
  return first != std::string_view::npos && line[first] != '#';
}

/// The first line with content after `begin`, which is the beginning of a line.
std::optional<Span> find_content(std::string_view text, std::uint32_t begin, SourceId id) {
  for (std::size_t at = begin; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
    if (is_content(text.substr(at, end - at))) {
      return Span{id, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
    }
    at = std::max(text.find_first_not_of("\r\n", end), end);
    if (end == text.size() || at == std::string_view::npos) break;
  }
  return std::nullopt;
}

/// yaml-cpp continues after a directive; YAML and PyYAML require `---` first.
std::optional<Span> find_open_directive(std::string_view text, SourceId id) {
  std::optional<Span> directive;
  auto line = find_content(text, byte_order_mark_size(text), id);
  for (; line && text[line->begin] == '%'; line = find_content(text, line->end, id)) {
    directive = line;
  }
  if (line && text.substr(line->begin).starts_with("---")) return std::nullopt;
  return directive;
}

/// yaml-cpp may silently end a document at a line that does not fit. A document mark must
/// follow.
bool check_rest(std::string_view text, std::uint32_t first_end, SourceId id, DiagnosticSink& sink) {
  const std::size_t line_end = text.find_first_of("\r\n", first_end);
  if (line_end == std::string_view::npos) return true;
  const auto rest = find_content(text, static_cast<std::uint32_t>(line_end), id);
  if (!rest) return true;
  const auto at = static_cast<std::uint32_t>(text.find_first_not_of(" \t", rest->begin));
  for (const std::string_view mark : {"---", "...", "]", "}"}) {
    if (text.substr(at).starts_with(mark)) return true;
  }
  sink.report(rules::sml0010_yaml_syntax, {id, at, at + 1},
              "this line does not fit the lines above it");
  return false;
}

/// Reports the findings; for a text that is not YAML, only the reason, and returns false.
bool hand_on(DiagnosticSink& found, DiagnosticSink& sink) {
  std::vector<Diagnostic> all = found.take();
  const auto is_syntax = [](const Diagnostic& diagnostic) {
    return diagnostic.rule == &rules::sml0010_yaml_syntax;
  };
  const bool is_yaml = std::none_of(all.begin(), all.end(), is_syntax);
  for (Diagnostic& diagnostic : all) {
    if (!is_yaml && !is_syntax(diagnostic)) continue;
    sink.report(*diagnostic.rule, diagnostic.span, {}) = std::move(diagnostic);
  }
  return is_yaml;
}

/// The text up to a place where far more brackets seem to be open than any file needs, followed by
/// closing brackets; empty if there is no such place. Also counts brackets inside of texts and
/// comments.
std::string suspicious_part(std::string_view text, const Limits& limits) {
  const std::uint64_t suspicious = 4 * std::uint64_t{limits.yaml_depth};
  std::string closing;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '[' || text[at] == '{') closing += text[at] == '[' ? ']' : '}';
    if ((text[at] == ']' || text[at] == '}') && !closing.empty()) closing.pop_back();
    if (closing.size() <= suspicious) continue;
    std::reverse(closing.begin(), closing.end());
    return std::string(text.substr(0, at + 1)) + closing;
  }
  return {};
}

/// yaml-cpp needs 230 bytes per bracket before its first event. Therefore, the part of the text
/// that looks too deep is read separately; reports it and returns true if it is too deep.
bool is_too_deep(const SourceMap& sources, SourceId id, const Limits& limits,
                 DiagnosticSink& sink) {
  const std::string part = suspicious_part(sources.text(id), limits);
  if (part.empty()) return false;
  DiagnosticSink found;
  YamlBuilder builder(sources, id, limits, found);
  YamlEvents events(sources.text(id), builder, found);
  try {
    ViewBuffer buffer(part);
    std::istream stream(&buffer);
    YAML::Parser(stream).HandleNextDocument(events);
  } catch (const StopParsing&) {
  } catch (const YAML::Exception&) {
  }
  for (const Diagnostic& diagnostic : found.diagnostics()) {
    if (diagnostic.rule != &rules::sml0014_nesting_too_deep) continue;
    sink.report(*diagnostic.rule, diagnostic.span, {}) = diagnostic;
    return true;
  }
  return false;
}

bool has_too_many_nodes(const DiagnosticSink& found) {
  const auto& all = found.diagnostics();
  return !all.empty() && all.back().rule == &rules::sml0002_file_too_large;
}

/// Returns the place from which the text is not plain. None if the result is final: the text is
/// plain, or too large to be read twice.
std::optional<std::uint32_t> parse_plain(const SourceMap& sources, SourceId id,
                                         const Limits& limits, DiagnosticSink& sink,
                                         std::optional<yaml::Document>& document) {
  DiagnosticSink found(limits);  // used only if the text is accepted
  YamlBuilder builder(sources, id, limits, found);
  try {
    if (const auto end = scan_plain_yaml(sources.text(id), builder)) return end;
    document = builder.take();
  } catch (const StopParsing&) {
    if (!has_too_many_nodes(found)) return 0;
  }
  hand_on(found, sink);
  return std::nullopt;
}

/// A text for which yaml-cpp would need seconds.
void refuse_large(Span place, const Limits& limits, DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      sink.report(rules::sml0002_file_too_large, place,
                  "this is not plain YAML, and in files of more than " +
                      std::to_string(limits.yaml_cpp_bytes) + " bytes, only plain YAML is read");
  diagnostic.note("plain YAML has no anchors, tags, tabs, carriage returns or mistakes");
  diagnostic.help(raise_limit("yaml-cpp-bytes"));
}

}  // namespace

std::optional<yaml::Document> parse_yaml(const SourceMap& sources, SourceId id,
                                         const Limits& limits, DiagnosticSink& sink) {
  return parse_yaml_by(YamlEngine::scanner_first, sources, id, limits, sink);
}

std::optional<yaml::Document> parse_yaml_by(YamlEngine engine, const SourceMap& sources,
                                            SourceId id, const Limits& limits,
                                            DiagnosticSink& sink) {
  if (!check_text(sources, id, TextFormat::yaml, sink)) return std::nullopt;
  const std::string_view text = sources.text(id);
  if (const auto mark = find_merge_mark(text, id)) {
    sink.report(rules::sml0010_yaml_syntax, *mark, "a merge conflict left its markers here")
        .help("keep one of the two versions, and delete the markers");
    return std::nullopt;
  }
  const bool is_large = text.size() > limits.yaml_cpp_bytes;
  if (engine == YamlEngine::scanner_first || is_large) {
    DiagnosticSink unused;
    std::optional<yaml::Document> document;
    const bool counts = engine == YamlEngine::scanner_first;
    const auto end = parse_plain(sources, id, limits, counts ? sink : unused, document);
    if (!end && counts) return document;
    if (end && is_large) {
      refuse_large({id, *end, std::min(*end + 1, static_cast<std::uint32_t>(text.size()))}, limits,
                   sink);
      return std::nullopt;
    }
  }
  if (const auto directive = find_open_directive(text, id)) {
    sink.report(rules::sml0010_yaml_syntax, *directive, "no `---` follows this directive")
        .help("begin the line with `#` to make it a comment");
    return std::nullopt;
  }
  if (is_too_deep(sources, id, limits, sink)) return std::nullopt;
  DiagnosticSink found(limits);
  YamlBuilder builder(sources, id, limits, found);
  YamlEvents events(text, builder, found);
  try {
    ViewBuffer buffer(text);
    std::istream stream(&buffer);
    YAML::Parser parser(stream);
    if (parser.HandleNextDocument(events) && check_rest(text, builder.end(), id, found)) {
      check_second_document(parser, text, builder.end(), id, found);
    }
  } catch (const StopParsing&) {
    hand_on(found, sink);
    return std::nullopt;
  } catch (const YAML::Exception& error) {
    report_parser_error(error.msg, error.mark.is_null() ? 0 : error.mark.pos,
                        builder.open_bracket(), sources, found);
    hand_on(found, sink);
    return std::nullopt;
  }
  if (!hand_on(found, sink)) return std::nullopt;
  return builder.take();
}

}  // namespace smurf
