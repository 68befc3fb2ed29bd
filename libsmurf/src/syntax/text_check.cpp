// SPDX-License-Identifier: BSD-3-Clause
// yaml-cpp and tinyxml2 accept bytes that other readers refuse, so this file checks the bytes.
#include "syntax/text_check.hpp"

#include <algorithm>
#include <cstring>

#include "base/findings/cases.hpp"
#include "base/findings/file_cases.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"
#include "base/text/utf8.hpp"
#include "syntax/xml_prolog.hpp"

namespace smurf {

namespace {

/// A byte order mark, or a NUL beside the first character, because our files begin with ASCII.
bool is_wide(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE")) return true;
  if (text.starts_with("\0\0\xFE\xFF"sv) || text.starts_with("\0\0\0"sv)) return true;
  return text.size() >= 2 && (text[0] == '\0') != (text[1] == '\0');
}

bool is_forbidden(char c, TextFormat format) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte < 0x20 && c != '\n' && c != '\r' && c != '\t') ||
         (byte == 0x7F && format == TextFormat::yaml);
}

/// Offset of the first one; the size of the text when there is none.
std::size_t find_control_character(std::string_view text, TextFormat format) {
  std::size_t at = 0;
  while (at < text.size()) {
    // Skips eight bytes per step, as long as all are ASCII, not 0x7F, and at least 0x20 or a line
    // end. The highest bit of each byte shows the result, because no sum with an ASCII byte carries
    // into the next byte.
    for (; at + sizeof(std::uint64_t) <= text.size(); at += sizeof(std::uint64_t)) {
      constexpr std::uint64_t kHighest = 0x8080808080808080U;
      std::uint64_t word = 0;
      std::memcpy(&word, text.data() + at, sizeof word);
      const std::uint64_t is_delete = word + 0x0101010101010101U;
      const std::uint64_t is_visible = word + 0x6060606060606060U;
      const std::uint64_t is_no_line_end = (word ^ 0x0A0A0A0A0A0A0A0AU) + 0x7F7F7F7F7F7F7F7FU;
      if (((word | is_delete | (is_no_line_end & ~is_visible)) & kHighest) != 0) break;
    }
    for (std::size_t end = std::min(at + sizeof(std::uint64_t), text.size()); at < end; ++at) {
      if (is_forbidden(text[at], format)) return at;
    }
  }
  return text.size();
}

std::string hex(char c) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  const auto byte = static_cast<unsigned char>(c);
  return {kDigits[byte / 16], kDigits[byte % 16]};
}

}  // namespace

std::uint32_t byte_order_mark_size(std::string_view text) {
  return text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
}

std::string_view without_padding(std::string_view text) {
  using namespace std::string_view_literals;
  const std::size_t last = text.find_last_not_of("\0 \t\r\n"sv);
  return text.substr(0, text.find('\0', last == std::string_view::npos ? 0 : last));
}

bool check_text(const SourceMap& sources, SourceId id, TextFormat format, DiagnosticSink& sink) {
  const std::string_view text = sources.text(id);
  if (is_wide(text)) {
    sink.report(rules::sml0005_unsupported_encoding, {id, 0, 0},
                "the file is not UTF-8 but UTF-16 or UTF-32")
        .help("save it as UTF-8");
    return false;
  }
  if (const std::size_t control = find_control_character(text, format); control < text.size()) {
    const auto at = static_cast<std::uint32_t>(control);
    Diagnostic& diagnostic = sink.report(rules::sml0004_control_character, {id, at, at + 1},
                                         "the control character U+00" + hex(text[control]) +
                                             " is not allowed in a text file");
    diagnostic.help("delete it");
    // Readers of XML stop only at a NUL.
    const std::string_view content = without_padding(text);
    if (format == TextFormat::yaml) return false;
    if (content.find('\0') != std::string_view::npos) {
      diagnostic.when(kUncertain);
      return false;
    }
    diagnostic.when(control < content.size() ? cases::kInUrdf : cases::kPadding);
  }
  if (const std::optional<std::size_t> at = utf8::find_invalid(text)) {
    const auto begin = static_cast<std::uint32_t>(*at);
    Diagnostic& diagnostic =
        sink.report(rules::sml0003_invalid_utf8, {id, begin, begin + 1},
                    "the byte 0x" + hex(text[begin]) + " is not valid UTF-8 here");
    diagnostic.help("save the file as UTF-8");
    if (format == TextFormat::yaml) return false;
    // Readers of XML take the bytes as they are.
    diagnostic.when(cases::kInUrdf);
    if (!other_encoding(text, id).empty()) diagnostic.when(cases::kOtherEncoding);
  }
  return true;
}

}  // namespace smurf
