// SPDX-License-Identifier: BSD-3-Clause
#include "syntax/strict_xml.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <utility>
#include <vector>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/ranges.hpp"
#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "base/text/words.hpp"
#include "syntax/text_check.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/xml_references.hpp"

namespace smurf {
namespace {

constexpr std::string_view kSectionEnd = "]]>";
constexpr std::string_view kCommentBegin = "<!--";

/// U+FFFE and U+FFFF become U+FFFD.
std::string with_characters_of_xml(std::string_view text) {
  std::string result(text);
  for (std::size_t at = result.find("\xEF\xBF"); at != result.npos;
       at = result.find("\xEF\xBF", at + 1)) {
    char& last = result[std::min(at + 2, result.size() - 1)];
    if (last == '\xBE' || last == '\xBF') last = '\xBD';
  }
  return result;
}

/// A part of the text in which `&` is not a reference.
struct UnreadPart {
  std::size_t size = 0;  ///< 0 if there is none here
  bool is_comment = false;
};

UnreadPart unread_part(std::string_view text) {
  for (const auto& [begin, end] : {std::pair(kCommentBegin, std::string_view("-->")),
                                   std::pair(std::string_view("<![CDATA["), kSectionEnd),
                                   std::pair(std::string_view("<?"), std::string_view("?>"))}) {
    if (!text.starts_with(begin)) continue;
    const std::size_t found = text.find(end, begin.size());
    const std::size_t size = found == text.npos ? text.size() : found + end.size();
    return {size, begin == kCommentBegin};
  }
  return {};
}

/// A comment in which a blank separates the dashes.
void append_comment(std::string_view comment, std::string& result) {
  constexpr std::string_view kEnd = "-->";
  const bool is_closed = comment.size() >= kCommentBegin.size() + kEnd.size();
  if (!is_closed) {
    result += comment;
    return;
  }
  const std::string_view body =
      comment.substr(kCommentBegin.size(), comment.size() - kCommentBegin.size() - kEnd.size());
  result += kCommentBegin;
  char last = ' ';
  for (const char c : body) {
    if (last == '-' && c == '-') result += ' ';
    result += c;
    last = c;
  }
  if (last == '-') result += ' ';
  result += kEnd;
}

/// What the fixes of findings change that say that only strict readers refuse the text.
std::vector<Edit> edits_of_fixes(const DiagnosticSink& sink) {
  constexpr std::array kRepaired = {
      &rules::sml1003_xml_bare_ampersand, &rules::sml1005_xml_junk_before_prolog,
      &rules::sml1014_xml_missing_blank, &rules::sml1017_xml_less_than_in_value};
  std::vector<Edit> edits;
  for (const Diagnostic& finding : sink.diagnostics()) {
    if (!ranges::contains(kRepaired, finding.rule)) continue;
    for (const Fix& fix : finding.fixes) {
      edits.insert(edits.end(), fix.edits.begin(), fix.edits.end());
    }
  }
  return edits;
}

/// Whether strict_xml() may change the text.
bool needs_repair(std::string_view text, const DiagnosticSink& sink) {
  if (text.find(kSectionEnd) != text.npos || text.find("\xEF\xBF") != text.npos) return true;
  const auto& findings = sink.diagnostics();
  return std::any_of(findings.begin(), findings.end(), [](const Diagnostic& finding) {
    return finding.rule == &rules::sml1004_xml_comment_dashes ||
           finding.rule == &rules::sml1013_dtd_or_xinclude;
  });
}

bool is_number_of_xml(std::string_view version) {
  return version.size() > 2 && version.starts_with("1.") &&
         version.find_first_not_of("0123456789", 2) == version.npos;
}

/// Readers decode the bytes of other encodings in their own way, or not at all.
bool can_keep_encoding(std::string_view name, bool is_ascii) {
  const std::string lower = path::to_lower(name);
  if (lower == "utf-8" || lower.starts_with("iso-8859-") || lower.starts_with("windows-125")) {
    return true;
  }
  return lower == "us-ascii" && is_ascii;
}

/// `declaration` is the text between `<?xml` and `?>`. Precondition: find_unsound() finds nothing
/// in the whole instruction.
bool is_strict_declaration(std::string_view declaration, bool is_ascii) {
  constexpr std::array<std::string_view, 3> kNames = {"version", "encoding", "standalone"};
  std::size_t next = 0;  // of the names, which have this order
  for (std::string_view rest = trimmed(declaration); !rest.empty();) {
    const std::size_t equals = rest.find('=');
    if (equals == rest.npos) return false;
    const std::string_view name = trimmed(rest.substr(0, equals));
    const auto known = std::find(kNames.begin() + next, kNames.end(), name);
    if (known == kNames.end() || (next == 0 && known != kNames.begin())) return false;
    next = static_cast<std::size_t>(known - kNames.begin()) + 1;
    const std::size_t open = rest.find_first_of("'\"", equals);
    const std::size_t close = open == rest.npos ? open : rest.find(rest[open], open + 1);
    if (close == rest.npos) return false;
    const std::string_view value = rest.substr(open + 1, close - open - 1);
    if (name == "version" && !is_number_of_xml(value)) return false;
    if (name == "encoding" && !can_keep_encoding(value, is_ascii)) return false;
    if (name == "standalone" && value != "yes" && value != "no") return false;
    rest = trimmed(rest.substr(close + 1));
  }
  return next > 0;
}

/// Replaces the XML declaration unless strict readers accept it.
std::string with_strict_declaration(std::string text) {
  constexpr std::string_view kBegin = "<?xml";
  const std::size_t begin = byte_order_mark_size(text);
  const std::string_view rest = std::string_view(text).substr(begin);
  if (path::to_lower(rest.substr(0, kBegin.size())) != kBegin) return text;
  const std::size_t end = rest.find("?>");
  const std::string_view inner = rest.substr(kBegin.size(), end - kBegin.size());
  if (end == rest.npos || (!inner.empty() && !is_blank(inner.front()))) return text;
  const bool is_ascii = utf8::ascii_prefix(text) == text.size();
  if (rest.starts_with(kBegin) && is_strict_declaration(inner, is_ascii)) return text;
  return text.replace(begin, end + 2, R"(<?xml version="1.0" encoding="UTF-8"?>)");
}

using Range = std::pair<char32_t, char32_t>;
/// The characters of names from U+0080, in XML 1.0 since its fifth edition.
constexpr Range kNameCharacters[] = {
    {0xB7, 0xB7},     {0xC0, 0xD6},     {0xD8, 0xF6},      {0xF8, 0x37D},    {0x37F, 0x1FFF},
    {0x200C, 0x200D}, {0x203F, 0x2040}, {0x2070, 0x218F},  {0x2C00, 0x2FEF}, {0x3001, 0xD7FF},
    {0xF900, 0xFDCF}, {0xFDF0, 0xFFFD}, {0x10000, 0xEFFFF}};
/// Those that do not begin a name.
constexpr Range kLaterCharacters[] = {{0xB7, 0xB7}, {0x300, 0x36F}, {0x203F, 0x2040}};

bool is_in(std::span<const Range> ranges, char32_t character) {
  return ranges::any_of(
      ranges, [&](const Range& one) { return one.first <= character && character <= one.second; });
}

/// `name` was read by our reader, which accepts every character from U+0080.
bool is_allowed_name(std::string_view name) {
  bool is_first = true;
  for (std::string_view rest = name; !rest.empty(); is_first = false) {
    const utf8::CodePoint one = utf8::decode(rest);
    rest.remove_prefix(one.size);
    if (one.value < 0x80) continue;
    if (!is_in(kNameCharacters, one.value)) return false;
    if (is_first && is_in(kLaterCharacters, one.value)) return false;
  }
  return true;
}

}  // namespace

std::string strict_xml(std::string_view text) {
  const std::string whole = with_characters_of_xml(text);
  std::string_view rest = whole;
  std::string result;
  result.reserve(whole.size());
  while (!rest.empty()) {
    const std::size_t plain = std::min(rest.find_first_of("<&]"), rest.size());
    result += rest.substr(0, plain);
    rest.remove_prefix(plain);
    std::size_t size = std::min<std::size_t>(1, rest.size());
    if (const UnreadPart unread = unread_part(rest); unread.size > 0) {
      size = unread.size;
      if (unread.is_comment) {
        append_comment(rest.substr(0, size), result);
      } else {
        result += rest.substr(0, size);
      }
    } else if (rest.starts_with(kSectionEnd)) {
      size = kSectionEnd.size();
      result += "]]&gt;";
    } else if (rest.starts_with('&') &&
               read_reference(rest).kind != XmlReference::Kind::character) {
      result += "&amp;";
    } else {
      result += rest.substr(0, size);
    }
    rest.remove_prefix(size);
  }
  return result;
}

std::string strict_xml_file(const std::string& text) {
  SourceMap sources;
  DiagnosticSink sink;
  parse_xml(sources, sources.add("step.urdf", text), {}, sink);
  const std::vector<Edit> edits = edits_of_fixes(sink);
  std::string result = edits.empty() ? text : apply_edits(text, edits);
  if (needs_repair(result, sink)) result = strict_xml(result);
  return with_strict_declaration(std::move(result));
}

std::string why_strict_readers_refuse(const xml::Document& document, std::string_view text) {
  constexpr std::string_view kDoctype = "<!DOCTYPE";
  const std::string_view prolog = text.substr(0, document.view().span().begin);
  if (prolog.find(kDoctype) != prolog.rfind(kDoctype)) return "XML allows one document type";
  if (utf8::ascii_prefix(text) == text.size()) return {};
  const auto fault = [](std::string_view name) {
    return "XML does not allow the name " + quoted(name);
  };
  for (const xml::Element& element : document.elements) {
    if (!is_allowed_name(element.name())) return fault(element.name());
  }
  for (const xml::Attribute& attribute : document.attributes) {
    if (!is_allowed_name(attribute.name())) return fault(attribute.name());
  }
  return {};
}

}  // namespace smurf
