// SPDX-License-Identifier: BSD-3-Clause
// Questions that methods of texts answer: where something is, and what a text consists of.
#include <algorithm>
#include <cctype>
#include <optional>

#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "xacro/python_text.hpp"
#include "xacro/text_methods.hpp"
#include "xacro/text_search.hpp"

namespace smurf::xacro {

const std::string* text_at(Call& call, std::size_t position) {
  if (position < call.count() && call.values[position].is_text()) {
    return call.values[position].text;
  }
  call.evaluator.fail("`" + std::string(call.name) + "()` needs a text");
  return nullptr;
}

bool is_ascii(std::string_view text) { return utf8::ascii_prefix(text) == text.size(); }

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }

namespace {

/// The part of a text between the positions that a call names, and where it begins in the text.
/// None after a failure, or if the part would begin behind the end.
struct Part {
  std::string_view text;
  std::int64_t begin = 0;  ///< in characters
};
std::optional<Part> part_of(Call& call) {
  Part part{self_of(call), 0};
  if (!call.has_count(1, 3) || call.count() == 1) {
    return call.evaluator.has_failed() ? std::nullopt : std::optional(part);
  }
  call.evaluator.meter().scan(part.text.size());
  const auto size = static_cast<std::int64_t>(utf8::count_code_points(part.text));
  std::int64_t ends[2] = {0, size};
  for (std::size_t i = 1; i < call.count(); ++i) {
    const Value& value = call.values[i];
    if (value.kind == Kind::none) continue;
    const auto at = value.is_integral() ? to_big(value).to_int64() : std::nullopt;
    if (!at) {
      call.evaluator.fail("`" + std::string(call.name) + "()` needs integers as positions");
      return std::nullopt;
    }
    const std::int64_t from_begin = *at < 0 ? std::max<std::int64_t>(*at, -size) + size : *at;
    ends[i - 1] = i == 1 ? from_begin : std::min(from_begin, size);
  }
  if (ends[0] > size || ends[0] > ends[1]) return std::nullopt;
  std::string_view rest = part.text;
  for (std::int64_t i = 0; i < ends[0]; ++i) rest.remove_prefix(utf8::decode(rest).size);
  std::string_view after = rest;
  for (std::int64_t i = ends[0]; i < ends[1]; ++i) after.remove_prefix(utf8::decode(after).size);
  return Part{rest.substr(0, rest.size() - after.size()), ends[0]};
}

/// Capitals begin words, and only there.
bool is_title(std::string_view text) {
  bool has_letter = false;
  char before = ' ';
  for (const char c : text) {
    const bool is_upper = std::isupper(static_cast<unsigned char>(c)) != 0;
    if (is_letter(c) && is_letter(before) == is_upper) return false;
    has_letter = has_letter || is_letter(c);
    before = c;
  }
  return has_letter;
}

}  // namespace

Value has_end(Call& call) {
  const bool at_begin = call.name == "startswith";
  const auto part = part_of(call);
  if (call.evaluator.has_failed()) return Value::failure();
  std::vector<Value> ends{call.values[0]};
  if (call.values[0].kind == Kind::tuple) {
    call.evaluator.step(call.values[0].list->items.size());
    ends = call.values[0].list->items;
  }
  for (const Value& end : ends) {
    if (!end.is_text())
      return call.evaluator.fail("`" + std::string(call.name) + "()` needs a text");
    call.evaluator.step();
    call.evaluator.meter().copy(end.text->size());
    if (!part) continue;
    const std::string_view text = part->text;
    if (at_begin ? text.starts_with(*end.text) : text.ends_with(*end.text)) return Value::of(true);
  }
  return Value::of(false);
}

Value find_text(Call& call) {
  const std::string* wanted = text_at(call, 0);
  if (wanted == nullptr) return Value::failure();
  const auto part = part_of(call);
  if (call.evaluator.has_failed()) return Value::failure();
  const std::string_view text = part ? part->text : std::string_view();
  const bool from_end = call.name == "rfind" || call.name == "rindex";
  Meter& meter = call.evaluator.meter();
  using Direction = TextSearch::Direction;
  const TextSearch search(*wanted, meter, from_end ? Direction::backwards : Direction::forwards);
  const std::size_t at = search.find(text);
  if (part && at != std::string::npos) {
    meter.scan(at);
    const std::size_t count = utf8::count_code_points(text.substr(0, at));
    return Value::of(part->begin + static_cast<std::int64_t>(count));
  }
  if (call.name == "find" || call.name == "rfind") return Value::of(std::int64_t{-1});
  return call.evaluator.fail("the text " + quoted(*wanted) + " is not in it");
}

Value count_text(Call& call) {
  const std::string* wanted = text_at(call, 0);
  if (wanted == nullptr) return Value::failure();
  const auto part = part_of(call);
  if (call.evaluator.has_failed()) return Value::failure();
  if (!part) return Value::of(std::int64_t{0});
  const std::string_view text = part->text;
  if (wanted->empty()) {
    call.evaluator.meter().scan(text.size());
    return Value::of(static_cast<std::int64_t>(utf8::count_code_points(text)) + 1);
  }
  std::int64_t count = 0;
  const TextSearch search(*wanted, call.evaluator.meter());
  for (std::size_t at = search.find(text); at != std::string::npos;
       at = search.find(text, at + wanted->size())) {
    call.evaluator.step();
    ++count;
  }
  return Value::of(count);
}

Value is_class(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  const std::string& text = self_of(call);
  call.evaluator.meter().scan(text.size());
  if (call.name == "isascii") return Value::of(is_ascii(text));
  if (!is_ascii(text)) {
    return call.evaluator.fail_unsupported("`" + std::string(call.name) +
                                           "()` of other letters than ASCII");
  }
  const std::string_view name = call.name;
  if (name == "istitle") return Value::of(is_title(text));
  if (name == "isprintable") {
    return Value::of(
        std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c < 0x7f; }));
  }
  if (name == "isupper" || name == "islower") {
    const bool wants_upper = name == "isupper";
    bool has_letter = false;
    for (const char c : text) {
      if (!is_letter(c)) continue;
      has_letter = true;
      if ((std::isupper(static_cast<unsigned char>(c)) != 0) != wants_upper)
        return Value::of(false);
    }
    return Value::of(has_letter);
  }
  if (name == "isidentifier") {
    const bool begins = !text.empty() && (is_letter(text[0]) || text[0] == '_');
    return Value::of(begins && std::all_of(text.begin(), text.end(), [](char c) {
                       return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
                     }));
  }
  const auto belongs = [&](char c) {
    const auto byte = static_cast<unsigned char>(c);
    if (name == "isalpha") return std::isalpha(byte) != 0;
    if (name == "isalnum") return std::isalnum(byte) != 0;
    if (name == "isspace") return is_python_blank(byte);
    return std::isdigit(byte) != 0;
  };
  return Value::of(!text.empty() && std::all_of(text.begin(), text.end(), belongs));
}

}  // namespace smurf::xacro
