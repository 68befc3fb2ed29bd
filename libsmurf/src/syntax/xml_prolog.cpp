// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/xml_prolog.hpp"

#include <algorithm>
#include <string>

#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "base/text/words.hpp"
#include "syntax/text_check.hpp"
#include "syntax/xml_bytes.hpp"
#include "syntax/xml_lenient.hpp"

namespace smurf {
namespace {

constexpr std::string_view kDeclaration = "<?xml";

void check_position(std::string_view text, SourceId id, std::size_t begin, DiagnosticSink& sink) {
  const std::size_t declaration = text.find(kDeclaration);
  if (declaration == std::string_view::npos || declaration == begin) return;
  const std::size_t next = declaration + kDeclaration.size();
  if (next < text.size() && !is_blank(text[next])) return;  // <?xml-stylesheet
  if (text.substr(0, declaration).find('<') != std::string_view::npos) return;
  const Span junk{id, static_cast<std::uint32_t>(begin), static_cast<std::uint32_t>(declaration)};
  Diagnostic& diagnostic = sink.report(rules::sml1005_xml_junk_before_prolog, junk,
                                       "the XML declaration is not the first thing in the file");
  if (trimmed(text.substr(begin, declaration - begin)).empty()) diagnostic.when(cases::kBlanks);
  diagnostic.help("delete everything before it");
  diagnostic.fixes.push_back({Applicability::safe, {{junk, ""}}});
}

/// The name of the encoding without its quotes; empty if the declaration names none.
Span declared_encoding(std::string_view text, SourceId id, std::size_t begin) {
  const std::string_view declaration = text.substr(begin, text.find("?>", begin) - begin);
  const std::size_t word = declaration.find("encoding");
  const std::size_t open = declaration.find_first_of("\"'", std::min(word, declaration.size()));
  if (open == std::string_view::npos) return {};
  const std::size_t close = declaration.find(declaration[open], open + 1);
  if (close == std::string_view::npos) return {};
  return {id, static_cast<std::uint32_t>(begin + open + 1),
          static_cast<std::uint32_t>(begin + close)};
}

/// Reports a declared encoding other than UTF-8, because some readers decode the file with it.
void check_encoding(std::string_view text, SourceId id, DiagnosticSink& sink) {
  const Span place = other_encoding(text, id);
  if (place.empty()) return;
  const std::string written(text.substr(place.begin, place.end - place.begin));
  const std::string encoding = path::to_lower(written);
  const bool is_wide = encoding.starts_with("utf-16") || encoding.starts_with("utf-32") ||
                       encoding.starts_with("ucs-");
  const bool is_ascii = utf8::ascii_prefix(text) == text.size();
  if (!is_wide && is_ascii) return;      // the same bytes in every encoding that extends ASCII
  if (utf8::find_invalid(text)) return;  // SML0003
  Diagnostic& diagnostic = sink.report(rules::sml1008_xml_encoding, place,
                                       "the file is UTF-8, but declares `" + written + "`");
  if (is_wide) diagnostic.when(cases::kWide);
  diagnostic.help("write `UTF-8`");
  diagnostic.fixes.push_back(
      {is_wide ? Applicability::safe : Applicability::unsafe, {{place, "UTF-8"}}});
  if (is_wide) return;
  diagnostic.severity = Severity::warning;
  diagnostic.note("urdfdom and browsers decode names accordingly, tinyxml2 ignores it");
}

/// False if `subset` contains more than declarations.
bool check_declarations(Span doctype, std::string_view subset, DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      sink.report(rules::sml1013_dtd_or_xinclude, doctype,
                  "urdfdom finds no robot after the declarations of this document type");
  diagnostic.severity = Severity::error;
  diagnostic.when(cases::kDeclarations);
  diagnostic.note("neither does sdformat, which uses urdfdom; MuJoCo reads the robot");
  diagnostic.help("delete the document type, and write out what it declares");
  for (std::size_t at = subset.find('<'); at != std::string_view::npos;) {
    const std::size_t next = subset.find('<', at + 1);
    const std::string_view one = subset.substr(at, next - at);
    const bool is_declaration = one.size() > 2 && one.starts_with("<!") && one[2] != '-' &&
                                one[2] != '[' && one.find('>') != std::string_view::npos;
    if (!is_declaration) return false;
    at = next;
  }
  return true;
}

}  // namespace

std::optional<std::size_t> find_unsound(std::string_view instruction) {
  if (path::to_lower(instruction.substr(0, kDeclaration.size())) != kDeclaration) {
    return std::nullopt;
  }
  const std::string_view text = instruction.substr(0, instruction.size() - 2);
  const auto skip_blanks = [&](std::size_t from) {
    return std::min(text.find_first_not_of(kBlanks, from), text.size());
  };
  const auto is_one_of = [&](std::string_view any, std::size_t at) {
    return at < text.size() && any.find(text[at]) != std::string_view::npos;
  };
  std::size_t at = std::min(text.find_first_of(kBlanks, kDeclaration.size()), text.size());
  while ((at = skip_blanks(at)) < text.size()) {
    const std::size_t name = at;
    while (at < text.size() && is(text[at], name_char)) ++at;
    const std::size_t equals = skip_blanks(at);
    const bool ends = at == text.size() || equals > at || is_one_of("=", at);
    if (at == name || !ends) return at;
    const std::size_t quote = is_one_of("=", equals) ? skip_blanks(equals + 1) : text.size();
    if (!is_one_of("'\"", quote)) return name;
    const std::size_t close = text.find(text[quote], quote + 1);
    if (close == std::string_view::npos) return quote;
    at = close + 1;
    if (at < text.size() && !is_one_of(kBlanks, at)) return at;
  }
  return std::nullopt;
}

bool report_unquoted(std::string_view declaration, Span place, DiagnosticSink& sink) {
  std::string quoted;
  bool is_bare = false;  // inside a value without quotes
  char quote = '\0';
  for (std::size_t i = 0; i < declaration.size(); ++i) {
    const char c = declaration[i];
    const bool ends = kBlanks.find(c) != std::string_view::npos || c == '?' || c == '>';
    if (is_bare && ends) {
      quoted += '"';
      is_bare = false;
    }
    if (is_bare && (c == '"' || c == '\'' || c == '=' || c == '<')) return false;
    quoted += c;
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (!is_bare && (c == '"' || c == '\'')) {
      quote = c;
    } else if (!is_bare && c == '=' && i + 1 < declaration.size()) {
      const char next = declaration[i + 1];
      is_bare = next != '"' && next != '\'' && kBlanks.find(next) == std::string_view::npos;
      if (is_bare) quoted += '"';
    }
  }
  if (find_unsound(quoted)) return false;
  report_malformed(place, "this value in the XML declaration has no quotes",
                   cases::kUnquotedInDeclaration, sink)
      .help("write `<?xml version=\"1.0\" encoding=\"UTF-8\"?>`");
  return true;
}

void check_xml_version(Span declaration, std::string_view text, DiagnosticSink& sink) {
  const std::string_view inside =
      text.substr(declaration.begin, declaration.end - declaration.begin);
  if (!inside.starts_with(kDeclaration) || inside.size() < kDeclaration.size() + 2) return;
  const char behind = inside[kDeclaration.size()];
  if (behind != '?' && kBlanks.find(behind) == std::string_view::npos) return;
  const std::size_t word = inside.find("version");
  const std::size_t open = inside.find_first_of("\"'", std::min(word, inside.size()));
  const std::size_t close =
      open == std::string_view::npos ? open : inside.find(inside[open], open + 1);
  if (close == std::string_view::npos) {
    sink.report(rules::sml1018_xml_version, declaration, "the XML declaration has no version")
        .help("write `<?xml version=\"1.0\"?>`");
    return;
  }
  const std::string_view version = inside.substr(open + 1, close - open - 1);
  if (version.starts_with("1.") && version.size() == 3 && is_digit(version[2])) return;
  const Span place{declaration.source, declaration.begin + static_cast<std::uint32_t>(open + 1),
                   declaration.begin + static_cast<std::uint32_t>(close)};
  Diagnostic& diagnostic = sink.report(rules::sml1018_xml_version, place,
                                       "there is no version " + quoted(version) + " of XML");
  diagnostic.help("write `1.0`");
  diagnostic.fixes.push_back({Applicability::safe, {{place, "1.0"}}});
}

Span other_encoding(std::string_view text, SourceId id) {
  const std::size_t begin = byte_order_mark_size(text);
  if (!text.substr(begin).starts_with(kDeclaration)) return {id, 0, 0};
  const Span place = declared_encoding(text, id, begin);
  if (place.source != id) return {id, 0, 0};
  const std::string name = path::to_lower(text.substr(place.begin, place.end - place.begin));
  const bool is_part = name == "utf-8" || name == "us-ascii" || name == "ascii";
  return is_part ? Span{id, 0, 0} : place;
}

void check_xml_prolog(std::string_view text, SourceId id, DiagnosticSink& sink) {
  const std::size_t begin = byte_order_mark_size(text);
  check_position(text, id, begin, sink);
  check_encoding(text, id, sink);
}

std::optional<std::uint32_t> read_doctype(std::string_view text, Span start, DiagnosticSink& sink) {
  const std::size_t first_close = text.find('>', start.begin);
  const std::size_t subset = text.find('[', start.begin);
  std::size_t close = first_close;
  if (subset < first_close) {
    close = text.find('>', std::min(text.find(']', subset), text.size()));
  }
  if (close == std::string_view::npos) {
    report_malformed(start, "this document type is never closed", cases::kFault, sink);
    return std::nullopt;
  }
  if (first_close < close &&
      !check_declarations(start, text.substr(subset, close + 1 - subset), sink)) {
    return std::nullopt;
  }
  return static_cast<std::uint32_t>(close + 1);
}

}  // namespace smurf
