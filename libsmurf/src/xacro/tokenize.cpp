// SPDX-License-Identifier: BSD-3-Clause
// xacro.tokenize(): a text cut at separators.
#include <algorithm>
#include <cctype>
#include <iterator>

#include "base/text/utf8.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"

namespace smurf::xacro {
namespace {

/// What stands between `[` and `]` of a regular expression: characters, ranges, `^` and classes.
class Separators {
 public:
  /// False if it means something else: such a text ends before its end, or is no expression.
  bool read(std::string_view text) {
    if (text.starts_with('^')) {
      is_negated_ = true;
      text.remove_prefix(1);
    }
    if (text.empty()) return false;
    for (bool is_first = true; !text.empty(); is_first = false) {
      char32_t from = 0;
      if (text[0] == ']' && !is_first) return false;
      if (!take(text, from)) return false;
      if (from == kClass) continue;
      char32_t to = from;
      if (text.size() > 1 && text[0] == '-') {
        text.remove_prefix(1);
        if (text[0] == ']' || !take(text, to) || to == kClass || to < from) return false;
      }
      ranges_.emplace_back(from, to);
    }
    merge();
    return true;
  }
  bool has(char32_t c) const {
    const auto after = std::upper_bound(
        ranges_.begin(), ranges_.end(), c,
        [](char32_t one, const std::pair<char32_t, char32_t>& range) { return one < range.first; });
    const bool is_in = after != ranges_.begin() && c <= std::prev(after)->second;
    return (is_in || (has_blanks_ && is_python_blank(c))) != is_negated_;
  }

 private:
  static constexpr char32_t kClass = 0xFFFFFFFF;

  /// In order, without overlaps.
  void merge() {
    std::sort(ranges_.begin(), ranges_.end());
    std::vector<std::pair<char32_t, char32_t>> merged;
    for (const auto& range : ranges_) {
      if (!merged.empty() && range.first <= merged.back().second) {
        merged.back().second = std::max(merged.back().second, range.second);
      } else {
        merged.push_back(range);
      }
    }
    ranges_ = std::move(merged);
  }

  /// The next character; kClass for `\s`, which is kept.
  bool take(std::string_view& text, char32_t& character) {
    const utf8::CodePoint point = utf8::decode(text);
    text.remove_prefix(point.size);
    character = point.value;
    if (character != '\\') return true;
    if (text.empty()) return false;
    const char escaped = text[0];
    text.remove_prefix(1);
    if (escaped == 's') {
      has_blanks_ = true;
      character = kClass;
      return true;
    }
    constexpr std::string_view kNames = "tnrfv";
    constexpr std::string_view kMeanings = "\t\n\r\f\v";
    const std::size_t name = kNames.find(escaped);
    character =
        static_cast<unsigned char>(name != std::string_view::npos ? kMeanings[name] : escaped);
    const bool is_mark = std::ispunct(static_cast<unsigned char>(escaped)) != 0;
    return name != std::string_view::npos || is_mark;
  }

  std::vector<std::pair<char32_t, char32_t>> ranges_;
  bool has_blanks_ = false;
  bool is_negated_ = false;
};

}  // namespace

Value tokenize(Call& call) {
  const Value* separators = call.take(1, "sep");
  const Value* skip_empty = call.take(2, "skip_empty");
  const Value* whole = call.take(0, "s");
  Evaluator& evaluator = call.evaluator;
  if (whole == nullptr || !whole->is_text() || !call.has_count(1, 3) ||
      (separators != nullptr && !separators->is_text())) {
    return evaluator.fail("`tokenize()` needs texts");
  }
  Separators marks;
  if (separators != nullptr) evaluator.step(separators->text->size());
  if (!marks.read(separators != nullptr ? *separators->text : ",; ")) {
    return evaluator.fail_unsupported("this list of separators");
  }
  const bool keeps_empty = skip_empty != nullptr && !is_true(*skip_empty);
  std::vector<Value> items;
  const std::string_view text = *whole->text;
  evaluator.step(text.size());
  std::size_t begin = 0;
  const auto add = [&](std::size_t end) {
    if (end > begin || keeps_empty)
      items.push_back(evaluator.text(std::string(text.substr(begin, end - begin))));
  };
  for (std::size_t at = 0; at < text.size();) {
    const utf8::CodePoint point = utf8::decode(text.substr(at));
    if (marks.has(point.value)) {
      add(at);
      begin = at + point.size;
    }
    at += point.size;
  }
  add(text.size());
  return evaluator.list(std::move(items));
}

}  // namespace smurf::xacro
