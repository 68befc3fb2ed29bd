// SPDX-License-Identifier: BSD-3-Clause
// Block style; mappings of numbers and short lists of names stay on one line. Texts are quoted only
// where a reader of YAML 1.1 or 1.2 would read another type.
#include "write/text/yaml_text.hpp"

#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/utf8.hpp"

namespace smurf {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

bool is_word_byte(char c) {
  return is_letter(c) || (c >= '0' && c <= '9') || c == '-' || c == '.' || c == '/';
}

bool is_plain(std::string_view text) {
  constexpr std::array<std::string_view, 7> kOtherTypes = {"yes",  "no",    "on",  "off",
                                                           "true", "false", "null"};
  const bool is_path = text.starts_with("../");
  if (text.empty() || (!is_letter(text.front()) && !is_path)) return false;
  if (!std::all_of(text.begin(), text.end(), is_word_byte)) return false;
  return std::find(kOtherTypes.begin(), kOtherTypes.end(), path::to_lower(text)) ==
         kOtherTypes.end();
}

/// Not printable in YAML, or a line break in YAML 1.1, or a mark that changes the direction of
/// writing, or, like U+FEFF, removed by some readers.
bool is_escaped_in_yaml(char32_t c) {
  return utf8::is_control(c) || utf8::is_layout(c) || c == 0xFEFF || c == 0xFFFE || c == 0xFFFF;
}

bool is_one_line(std::string_view text) {
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    if (is_escaped_in_yaml(point.value) || point.value == 0xFFFD) return false;
    text.remove_prefix(point.size);
  }
  return true;
}

std::string double_quoted(std::string_view text) {
  std::string quoted = "\"";
  while (!text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    if (point.value == '\n') {
      quoted += "\\n";
    } else if (is_escaped_in_yaml(point.value)) {
      utf8::append_escape(quoted, point.value);
    } else {
      if (point.value == '"' || point.value == '\\') quoted += '\\';
      quoted += point.value == 0xFFFD ? utf8::kReplacement : text.substr(0, point.size);
    }
    text.remove_prefix(point.size);
  }
  return quoted + "\"";
}

/// A literal block preserves line breaks and everything else, except for leading tabs and special
/// characters.
bool fits_block(std::string_view text) {
  if (text.find('\n') == std::string_view::npos || text.ends_with('\n')) return false;
  if (text.front() == ' ' || text.front() == '\t' || text.front() == '\n') return false;
  std::string one_line(text);
  std::replace(one_line.begin(), one_line.end(), '\n', ' ');
  std::replace(one_line.begin(), one_line.end(), '\t', ' ');
  return is_one_line(one_line);
}

/// YAML limits a key before its colon to 1,024 characters; only after `? ` it may be longer.
bool is_long_key(std::string_view written) { return written.size() > 1000; }

/// Comments may contain names from a file, so line ends in them are replaced.
std::string comment_text(std::string_view text) {
  return is_one_line(text) ? std::string(text) : double_quoted(text);
}

class Writer {
 public:
  std::string out;

  /// "key: value" at a depth; the first line is already indented if `is_begun`.
  void member(const NewValue& value, int depth, bool is_begun = false) {
    const bool has_comment_above = !value.comment.empty() && !is_scalar(value);
    if (has_comment_above && !is_begun) comment(value.comment, depth);
    if (!is_begun) indent(depth);
    const std::string written = yaml_scalar(value.key);
    key(written, depth);
    if (is_scalar(value)) {
      out += " " + scalar(value, depth);
      if (!value.comment.empty()) out += "  # " + comment_text(value.comment);
      out += "\n";
    } else if (value.is_on_one_line || value.children.empty()) {
      out += " " + one_line(value) + "\n";
    } else {
      out += "\n";
      // A list has the depth of its key, as in the examples of the format.
      const bool has_depth_of_key = value.kind == NewValue::Kind::list && !is_long_key(written);
      children(value, has_depth_of_key ? depth : depth + 1);
    }
  }

 private:
  static bool is_scalar(const NewValue& value) {
    return value.kind != NewValue::Kind::list && value.kind != NewValue::Kind::mapping;
  }

  void key(const std::string& written, int depth) {
    if (!is_long_key(written)) {
      out += written + ":";
      return;
    }
    out += "? " + written + "\n";
    indent(depth);
    out += ":";
  }

  void indent(int depth) { out.append(static_cast<std::size_t>(depth) * 2, ' '); }

  void comment(const std::string& text, int depth) {
    indent(depth);
    out += "# " + comment_text(text) + "\n";
  }

  void children(const NewValue& value, int depth) {
    for (const NewValue& child : value.children) {
      if (value.kind == NewValue::Kind::mapping) {
        member(child, depth);
      } else {
        entry(child, depth);
      }
    }
  }

  void entry(const NewValue& value, int depth) {
    if (!value.comment.empty()) comment(value.comment, depth);
    indent(depth);
    out += "- ";
    if (is_scalar(value)) {
      out += scalar(value, depth) + "\n";
    } else if (value.is_on_one_line || value.children.empty()) {
      out += one_line(value) + "\n";
    } else {
      bool is_first = true;
      for (const NewValue& child : value.children) {
        member(child, depth + 1, is_first);
        is_first = false;
      }
    }
  }

  static std::string scalar(const NewValue& value, int depth) {
    if (value.kind == NewValue::Kind::boolean) return value.boolean ? "true" : "false";
    if (value.kind == NewValue::Kind::number) return yaml_number(value.number);
    if (!fits_block(value.text)) return yaml_scalar(value.text);
    std::string block = "|-\n";
    const std::string indentation(static_cast<std::size_t>(depth + 1) * 2, ' ');
    std::string_view rest = value.text;
    while (true) {
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      if (!line.empty()) block.append(indentation).append(line);
      if (end == std::string_view::npos) return block;
      block += '\n';
      rest.remove_prefix(end + 1);
    }
  }

  static std::string one_line(const NewValue& value) {
    const bool is_list = value.kind == NewValue::Kind::list;
    std::string text;
    for (const NewValue& child : value.children) {
      text += text.empty() ? "" : ", ";
      if (!is_list) text += key_in_flow(yaml_scalar(child.key));
      text += is_scalar(child) ? in_flow(child) : one_line(child);
    }
    return is_list ? "[" + text + "]" : "{" + text + "}";
  }

  static std::string key_in_flow(const std::string& written) {
    return is_long_key(written) ? "? " + written + " : " : written + ": ";
  }

  static std::string in_flow(const NewValue& value) {
    return value.kind == NewValue::Kind::text ? yaml_scalar(value.text) : scalar(value, 0);
  }
};

}  // namespace

std::string yaml_scalar(std::string_view text) {
  if (is_plain(text)) return std::string(text);
  if (!is_one_line(text)) return double_quoted(text);
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "''" : std::string(1, c);
  return quoted + "'";
}

std::string yaml_number(double number) {
  std::string text = format_number(number);
  const std::size_t exponent = text.find('e');
  if (exponent != std::string::npos && text.find('.') == std::string::npos) {
    text.insert(exponent, ".0");
  }
  return text;
}

std::string yaml_comment(std::string_view text) {
  std::string comment;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    comment += "# " + comment_text(text.substr(0, end)) + "\n";
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return comment;
}

std::string yaml_text(const NewValue& member) {
  Writer writer;
  writer.member(member, 0);
  return writer.out;
}

}  // namespace smurf
