// SPDX-License-Identifier: BSD-3-Clause
#include "plan/xacro_text.hpp"

#include <algorithm>
#include <array>

namespace smurf {
namespace {

constexpr std::string_view kBlank = " \t\r\n";
constexpr std::string_view kNameEnd = " \t\r\n/>=\"'<";
constexpr std::string_view kPrefix = "xacro:";
constexpr std::string_view kWordLetters =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_";

bool is_word(char c) { return kWordLetters.find(c) != std::string_view::npos; }

class TagReader {
 public:
  explicit TagReader(std::string_view text) : text_(text) {}

  std::vector<XacroTag> run() {
    while (at_ < text_.size()) {
      at_ = std::min(text_.find('<', at_), text_.size());
      if (at_ == text_.size()) break;
      const bool is_other =
          skip("<!--", "-->") || skip("<![CDATA[", "]]>") || skip("<?", "?>") || skip("<!", ">");
      if (!is_other) tag();
    }
    for (const std::size_t open : open_) tags_[open].end = text_.size();
    return std::move(tags_);
  }

 private:
  bool skip(std::string_view from, std::string_view to) {
    if (!text_.substr(at_).starts_with(from)) return false;
    const std::size_t found = text_.find(to, at_ + from.size());
    at_ = found == text_.npos ? text_.size() : found + to.size();
    return true;
  }

  TextRange name() {
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(kNameEnd, at_), text_.size());
    return {begin, at_};
  }

  void skip_blanks() { at_ = std::min(text_.find_first_not_of(kBlank, at_), text_.size()); }

  void tag() {
    const std::size_t begin = at_++;
    if (at_ < text_.size() && text_[at_] == '/') {
      ++at_;
      end_tag(name().of(text_));
      return;
    }
    XacroTag tag;
    tag.name = name();
    bool is_closed = false;
    while (at_ < text_.size()) {
      skip_blanks();
      if (at_ == text_.size() || text_[at_] == '<') break;
      if (text_[at_] == '>') {
        ++at_;
        break;
      }
      if (text_[at_] == '/') {
        is_closed = text_.substr(at_).starts_with("/>");
        ++at_;
        continue;
      }
      attribute(tag);
    }
    tag.tag = {begin, at_};
    tag.end = at_;
    if (!open_.empty()) tag.parent = open_.back();
    for (auto around = open_.rbegin(); around != open_.rend(); ++around) {
      if (tags_[*around].name.of(text_) != "xacro:macro") continue;
      tag.macro = *around;
      break;
    }
    tags_.push_back(std::move(tag));
    if (!is_closed) open_.push_back(tags_.size() - 1);
  }

  void attribute(XacroTag& tag) {
    XacroAttribute one;
    one.name = name();
    if (one.name.begin == one.name.end) {
      ++at_;  // no name: skip it
      return;
    }
    const std::size_t behind = at_;
    skip_blanks();
    if (at_ == text_.size() || text_[at_] != '=') {
      at_ = behind;
      one.value = {behind, behind};
      tag.attributes.push_back(one);
      return;
    }
    ++at_;
    skip_blanks();
    if (at_ == text_.size() || (text_[at_] != '"' && text_[at_] != '\'')) return;
    const std::size_t value = at_ + 1;
    const std::size_t end = std::min(text_.find(text_[at_], value), text_.size());
    one.value = {value, end};
    at_ = std::min(end + 1, text_.size());
    tag.attributes.push_back(one);
  }

  void end_tag(std::string_view name) {
    const std::size_t close = std::min(text_.find('>', at_), text_.size());
    at_ = std::min(close + 1, text_.size());
    const auto found = std::find_if(open_.rbegin(), open_.rend(), [&](std::size_t one) {
      return tags_[one].name.of(text_) == name;
    });
    if (found == open_.rend()) return;
    for (auto one = open_.rbegin(); one != found + 1; ++one) tags_[*one].end = at_;
    open_.erase(found.base() - 1, open_.end());
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::vector<XacroTag> tags_;
  std::vector<std::size_t> open_;
};

/// The parameters of a macro: NAME, NAME:=DEFAULT, *BLOCK and so on.
class ParameterReader {
 public:
  ParameterReader(std::string_view text, TextRange place, std::size_t macro)
      : text_(text), at_(place.begin), end_(place.end), macro_(macro) {}

  void run(std::vector<XacroName>& names) {
    while (true) {
      skip_blanks();
      if (at_ >= end_) return;
      names.push_back(parameter());
    }
  }

 private:
  void skip_blanks() {
    while (at_ < end_ && kBlank.find(text_[at_]) != kBlank.npos) ++at_;
  }

  XacroName parameter() {
    XacroName one;
    one.kind = XacroNameKind::parameter;
    one.macro = one.tag = macro_;
    const std::size_t begin = at_;
    while (at_ < end_ && text_[at_] == '*') {
      one.kind = XacroNameKind::block;
      ++at_;
    }
    one.place.begin = at_;
    while (at_ < end_ && kBlank.find(text_[at_]) == kBlank.npos && text_[at_] != '=' &&
           !text_.substr(at_, 2).starts_with(":=")) {
      ++at_;
    }
    one.place.end = at_;
    one.name = one.place.of(text_);
    if (at_ == begin) ++at_;  // a stray sign
    const std::size_t behind = at_;
    skip_blanks();
    const std::string_view rest = text_.substr(at_, end_ - at_);
    if (rest.starts_with(":=") || rest.starts_with('=')) {
      at_ += rest.starts_with(':') ? 2 : 1;
      skip_blanks();
      const std::size_t value = at_;
      skip_default();
      one.value = text_.substr(value, at_ - value);
      one.has_value = !one.value.empty();
    } else {
      at_ = behind;
    }
    one.whole = {begin, at_};
    return one;
  }

  void skip_default() {
    char quote = '\0', bracket = '\0';
    for (; at_ < end_; ++at_) {
      const char c = text_[at_];
      if (quote != '\0') {
        if (c == quote) quote = '\0';
      } else if (bracket != '\0') {
        if (c == bracket) bracket = '\0';
      } else if (c == '\'' || c == '"') {
        quote = c;
      } else if (text_.substr(at_).starts_with("${") || text_.substr(at_).starts_with("$(")) {
        bracket = text_[at_ + 1] == '{' ? '}' : ')';
      } else if (kBlank.find(c) != kBlank.npos) {
        return;
      }
    }
  }

  std::string_view text_;
  std::size_t at_, end_;
  std::size_t macro_;
};

XacroName definition(XacroNameKind kind, std::string_view text, const XacroTag& tag,
                     std::size_t index, const XacroAttribute& name) {
  XacroName one;
  one.kind = kind;
  one.place = name.value;
  one.name = name.value.of(text);
  one.whole = {tag.tag.begin, tag.end};
  one.tag = index;
  return one;
}

}  // namespace

const XacroAttribute* XacroTag::find(std::string_view text, std::string_view attribute) const {
  for (const XacroAttribute& one : attributes) {
    if (one.name.of(text) == attribute) return &one;
  }
  return nullptr;
}

std::vector<XacroTag> xacro_tags(std::string_view text) { return TagReader(text).run(); }

bool is_xacro_element(std::string_view name) {
  constexpr std::array<std::string_view, 10> kElements = {
      "arg",     "attribute",    "call",  "element",  "if",
      "include", "insert_block", "macro", "property", "unless"};
  return std::find(kElements.begin(), kElements.end(), name) != kElements.end();
}

std::string_view called_macro(std::string_view element) {
  if (!element.starts_with(kPrefix)) return {};
  element.remove_prefix(kPrefix.size());
  if (is_xacro_element(element)) return {};
  return element.substr(element.rfind('.') + 1);
}

XacroText read_xacro_text(std::string_view text) {
  XacroText found{xacro_tags(text), {}, {}};
  for (std::size_t i = 0; i < found.tags.size(); ++i) {
    const XacroTag& tag = found.tags[i];
    const std::string_view element = tag.name.of(text);
    if (!element.starts_with(kPrefix)) continue;
    const XacroAttribute* name = tag.find(text, "name");
    if (element == "xacro:include") {
      if (const XacroAttribute* file = tag.find(text, "filename")) {
        found.includes.push_back(file->value);
      }
    } else if (name == nullptr) {
      continue;
    } else if (element == "xacro:macro") {
      XacroName macro = definition(XacroNameKind::macro, text, tag, i, *name);
      const XacroAttribute* params = tag.find(text, "params");
      if (params != nullptr) macro.value = params->value.of(text);
      found.names.push_back(std::move(macro));
      if (params != nullptr) ParameterReader(text, params->value, i).run(found.names);
    } else if (element == "xacro:property" || element == "xacro:arg") {
      const bool is_argument = element == "xacro:arg";
      found.names.push_back(definition(
          is_argument ? XacroNameKind::argument : XacroNameKind::property, text, tag, i, *name));
      const XacroAttribute* value = tag.find(text, is_argument ? "default" : "value");
      if (value == nullptr) value = tag.find(text, "default");
      if (value == nullptr) continue;
      found.names.back().value = value->value.of(text);
      found.names.back().has_value = true;
    }
  }
  return found;
}

XacroExpression xacro_expression_at(std::string_view text, std::size_t at) {
  XacroExpression found;
  at = std::min(at, text.size());
  // Expressions do not cross the borders of attributes and tags.
  std::size_t begin = at;
  while (begin >= 2) {
    const std::string_view open = text.substr(begin - 2, 2);
    if (open == "${" || open == "$(") break;
    const char c = text[begin - 1];
    if (c == '<' || c == '>' || c == '}' || c == '"') return found;
    --begin;
  }
  if (begin < 2) return found;
  found.kind = text[begin - 1];
  const char close = found.kind == '{' ? '}' : ')';
  std::size_t end = begin;
  while (end < text.size() && text[end] != close && text[end] != '"' && text[end] != '<') ++end;
  if (end < at) return {};
  found.inner = {begin, end};
  const bool is_closed = end < text.size() && text[end] == close;
  found.whole = {begin - 2, is_closed ? end + 1 : end};
  found.word = {at, at};
  while (found.word.begin > begin && is_word(text[found.word.begin - 1])) --found.word.begin;
  while (found.word.end < end && is_word(text[found.word.end])) ++found.word.end;
  return found;
}

std::vector<TextRange> xacro_uses(std::string_view text, std::string_view name, bool is_argument) {
  std::vector<TextRange> uses;
  if (name.empty()) return uses;
  for (std::size_t at = text.find(name); at != text.npos; at = text.find(name, at + 1)) {
    const std::size_t end = at + name.size();
    const bool is_part =
        (at > 0 && is_word(text[at - 1])) || (end < text.size() && is_word(text[end]));
    if (is_part) continue;
    const XacroExpression around = xacro_expression_at(text, at);
    if (around.kind == '\0' || around.word.begin != at || around.word.end != end) continue;
    const std::string_view inner = around.inner.of(text);
    if ((around.kind == '(' && inner.starts_with("arg")) != is_argument) continue;
    if (around.kind == '(' && !is_argument && !inner.starts_with("eval")) continue;
    uses.push_back({at, end});
  }
  return uses;
}

}  // namespace smurf
