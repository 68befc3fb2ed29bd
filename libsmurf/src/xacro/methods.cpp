// SPDX-License-Identifier: BSD-3-Clause
// Methods of texts.
#include <algorithm>
#include <array>
#include <cctype>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/utf8.hpp"
#include "xacro/evaluator.hpp"
#include "xacro/python_text.hpp"
#include "xacro/text_methods.hpp"
#include "xacro/text_search.hpp"

namespace smurf::xacro {
namespace {

/// Changes of case are known for ASCII only.
Value with_case(Call& call, std::string (*change)(std::string)) {
  if (!call.has_count(0, 0)) return Value::failure();
  call.evaluator.meter().copy(self_of(call).size());
  if (!is_ascii(self_of(call))) {
    return call.evaluator.fail_unsupported("`" + std::string(call.name) +
                                           "()` of other letters than ASCII");
  }
  call.evaluator.meter().scan(self_of(call).size());
  return call.evaluator.text(change(self_of(call)));
}

char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }
char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

Value to_lower(Call& call) {
  return with_case(call, [](std::string text) { return path::to_lower(text); });
}
Value to_upper(Call& call) {
  return with_case(call, [](std::string text) {
    for (char& c : text) c = upper(c);
    return text;
  });
}
Value capitalize(Call& call) {
  return with_case(call, [](std::string text) {
    for (char& c : text) c = lower(c);
    if (!text.empty()) text[0] = upper(text[0]);
    return text;
  });
}
Value title(Call& call) {
  return with_case(call, [](std::string text) {
    bool is_inside = false;
    for (char& c : text) {
      c = is_inside ? lower(c) : upper(c);
      is_inside = is_letter(c);
    }
    return text;
  });
}
Value swapcase(Call& call) {
  return with_case(call, [](std::string text) {
    for (char& c : text) c = std::isupper(static_cast<unsigned char>(c)) != 0 ? lower(c) : upper(c);
    return text;
  });
}

/// Removes characters, not a word: '"tool_link".rstrip("_link")' is "too".
Value strip(Call& call) {
  if (!call.has_count(0, 1)) return Value::failure();
  std::string_view text = self_of(call);
  const bool at_begin = call.name != "rstrip";
  const bool at_end = call.name != "lstrip";
  const bool has_set = call.count() == 1 && call.values[0].kind != Kind::none;
  const std::string* set = has_set ? text_at(call, 0) : nullptr;
  if (has_set && set == nullptr) return Value::failure();
  std::vector<char32_t> characters;
  for (std::string_view rest = set != nullptr ? std::string_view(*set) : std::string_view();
       !rest.empty();) {
    const utf8::CodePoint point = utf8::decode(rest);
    characters.push_back(point.value);
    rest.remove_prefix(point.size);
  }
  call.evaluator.meter().scan(text.size());
  if (set != nullptr) call.evaluator.step(set->size());
  std::sort(characters.begin(), characters.end());
  characters.erase(std::unique(characters.begin(), characters.end()), characters.end());
  if (characters.size() > 256) call.evaluator.meter().scan(text.size());
  const auto goes = [&](char32_t c) {
    if (set == nullptr) return is_python_blank(c);
    return std::binary_search(characters.begin(), characters.end(), c);
  };
  while (at_begin && !text.empty()) {
    const utf8::CodePoint point = utf8::decode(text);
    if (!goes(point.value)) break;
    text.remove_prefix(point.size);
  }
  while (at_end && !text.empty()) {
    std::size_t begin = text.size() - 1;
    while (begin > 0 && utf8::is_continuation(text[begin])) --begin;
    if (!goes(utf8::decode(text.substr(begin)).value)) break;
    text = text.substr(0, begin);
  }
  return call.evaluator.text(std::string(text));
}

/// The words of a text; at most `most` cuts, from the end if wanted.
std::vector<std::string_view> words_of(std::string_view text, std::int64_t most, bool from_end,
                                       std::size_t most_words) {
  std::vector<std::string_view> words;
  text = without_blanks(text);
  while (!text.empty() && words.size() <= most_words) {
    if (most-- == 0) {
      words.push_back(text);
      break;
    }
    if (from_end) {
      std::size_t begin = text.size();
      while (begin > 0) {
        std::size_t before = begin - 1;
        while (before > 0 && utf8::is_continuation(text[before])) --before;
        if (is_python_blank(utf8::decode(text.substr(before)).value)) break;
        begin = before;
      }
      words.push_back(text.substr(begin));
      text = without_blanks(text.substr(0, begin));
    } else {
      std::size_t end = 0;
      while (end < text.size()) {
        const utf8::CodePoint point = utf8::decode(text.substr(end));
        if (is_python_blank(point.value)) break;
        end += point.size;
      }
      words.push_back(text.substr(0, end));
      text = without_blanks(text.substr(end));
    }
  }
  return words;
}

std::vector<std::string_view> cut(std::string_view text, std::string_view at, std::int64_t most,
                                  bool from_end, std::size_t most_parts, Meter& meter) {
  using Direction = TextSearch::Direction;
  const TextSearch search(at, meter, from_end ? Direction::backwards : Direction::forwards);
  std::vector<std::string_view> parts;
  while (parts.size() <= most_parts) {
    const std::size_t found = most-- == 0 ? std::string_view::npos : search.find(text);
    if (found == std::string_view::npos) break;
    parts.push_back(from_end ? text.substr(found + at.size()) : text.substr(0, found));
    text = from_end ? text.substr(0, found) : text.substr(found + at.size());
  }
  parts.push_back(text);
  return parts;
}

Value split(Call& call) {
  const Value* separator = call.take(0, "sep");
  const Value* most = call.take(1, "maxsplit");
  const bool from_end = call.name == "rsplit";
  const std::int64_t count = most != nullptr && most->kind == Kind::integer ? most->integer : -1;
  const std::size_t most_items = call.evaluator.limits().xacro_items;  // one more is reported
  std::vector<std::string_view> parts;
  if (separator == nullptr || separator->kind == Kind::none) {
    call.evaluator.meter().scan(self_of(call).size());
    parts = words_of(self_of(call), count, from_end, most_items);
  } else {
    if (!separator->is_text() || separator->text->empty()) {
      return call.evaluator.fail("the separator of `split()` is no text, or is empty");
    }
    parts =
        cut(self_of(call), *separator->text, count, from_end, most_items, call.evaluator.meter());
  }
  if (from_end) std::reverse(parts.begin(), parts.end());
  call.evaluator.step(parts.size());
  std::vector<Value> items;
  for (const std::string_view part : parts) items.push_back(call.evaluator.text(std::string(part)));
  return call.evaluator.list(std::move(items));
}

Value splitlines(Call& call) {
  if (!call.has_count(0, 0)) return Value::failure();
  std::vector<Value> items;
  std::string_view rest = self_of(call);
  call.evaluator.meter().scan(rest.size());
  while (!rest.empty()) {
    call.evaluator.step();
    const std::size_t end = std::min(rest.find_first_of("\r\n"), rest.size());
    items.push_back(call.evaluator.text(std::string(rest.substr(0, end))));
    const bool is_pair = rest.substr(end).starts_with("\r\n");
    rest.remove_prefix(std::min(rest.size(), end + (is_pair ? 2 : 1)));
  }
  return call.evaluator.list(std::move(items));
}

Value partition(Call& call) {
  const std::string* separator = text_at(call, 0);
  if (separator == nullptr) return Value::failure();
  if (separator->empty()) return call.evaluator.fail("the separator is empty");
  const std::string& text = self_of(call);
  const bool from_end = call.name == "rpartition";
  using Direction = TextSearch::Direction;
  const std::size_t at = TextSearch(*separator, call.evaluator.meter(),
                                    from_end ? Direction::backwards : Direction::forwards)
                             .find(text);
  std::string parts[3] = {text, "", ""};
  if (at != std::string::npos) {
    parts[0] = text.substr(0, at);
    parts[1] = *separator;
    parts[2] = text.substr(at + separator->size());
  } else if (from_end) {
    std::swap(parts[0], parts[2]);
  }
  std::vector<Value> items;
  for (std::string& part : parts) items.push_back(call.evaluator.text(std::move(part)));
  return call.evaluator.list(std::move(items), Kind::tuple);
}

Value join(Call& call) {
  if (!call.has_count(1, 1)) return Value::failure();
  std::vector<Value> items;
  if (!call.evaluator.items_of(call.values[0], items)) return Value::failure();
  std::string text;
  for (std::size_t i = 0; i < items.size(); ++i) {
    if (!items[i].is_text()) {
      return call.evaluator.fail("`join()` needs texts, and item " + std::to_string(i) + " is " +
                                 std::string(kind_name(items[i])));
    }
    if (i > 0) text += self_of(call);
    text += *items[i].text;
    call.evaluator.meter().copy(self_of(call).size() + items[i].text->size());
    if (text.size() > call.evaluator.limits().xacro_text_bytes) break;
  }
  return call.evaluator.text(std::move(text));
}

Value replace(Call& call) {
  const std::string* old = text_at(call, 0);
  const std::string* with = old != nullptr ? text_at(call, 1) : nullptr;
  if (with == nullptr || !call.has_count(2, 3)) return Value::failure();
  std::int64_t left =
      call.count() == 3 && call.values[2].kind == Kind::integer ? call.values[2].integer : -1;
  const std::string& text = self_of(call);
  std::string result;
  std::size_t begin = 0;
  if (old->empty()) {
    // The new text comes before each character, and at the end.
    call.evaluator.step(text.size());
    for (; left != 0 && begin <= text.size(); --left) {
      result += *with;
      if (begin == text.size()) break;
      const std::size_t size = utf8::decode(std::string_view(text).substr(begin)).size;
      result.append(text, begin, size);
      begin += size;
      if (result.size() > call.evaluator.limits().xacro_text_bytes) break;
    }
    result.append(text, begin);
    return call.evaluator.text(std::move(result));
  }
  const TextSearch search(*old, call.evaluator.meter());
  for (; left != 0; --left) {
    const std::size_t at = search.find(text, begin);
    if (at == std::string::npos) break;
    result.append(text, begin, at - begin);
    result += *with;
    begin = at + old->size();
    if (result.size() > call.evaluator.limits().xacro_text_bytes) break;
  }
  result.append(text, begin);
  return call.evaluator.text(std::move(result));
}

Value remove_end(Call& call) {
  const std::string* end = text_at(call, 0);
  if (end == nullptr) return Value::failure();
  call.evaluator.meter().copy(self_of(call).size());
  std::string text = self_of(call);
  if (call.name == "removeprefix") {
    if (text.starts_with(*end)) text.erase(0, end->size());
  } else if (!end->empty() && text.ends_with(*end)) {
    text.resize(text.size() - end->size());
  }
  return call.evaluator.text(std::move(text));
}

/// The column of a text in a width: center, ljust, rjust, zfill.
Value fill(Call& call) {
  if (!call.has_count(1, 2) || call.values[0].kind != Kind::integer) {
    return call.evaluator.fail("`" + std::string(call.name) + "()` needs a width");
  }
  const bool has_fill = call.count() == 2;
  const std::string* filler = has_fill ? text_at(call, 1) : nullptr;
  if (has_fill && filler == nullptr) return Value::failure();
  call.evaluator.meter().scan(self_of(call).size());
  std::string text = self_of(call);
  const auto size = static_cast<std::int64_t>(utf8::count_code_points(text));
  const auto most = static_cast<std::int64_t>(call.evaluator.limits().xacro_text_bytes) + size;
  const std::int64_t room = std::min(call.values[0].integer, most) - size;
  if (room <= 0) return call.self;
  const auto times = [&](std::int64_t count) {
    const std::string one = filler != nullptr ? *filler : " ";
    std::string result;
    call.evaluator.meter().scan(static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) result += one;
    return result;
  };
  if (call.name == "zfill") {
    const bool has_sign = text.starts_with('-') || text.starts_with('+');
    text.insert(has_sign ? 1 : 0, static_cast<std::size_t>(room), '0');
  } else if (call.name == "ljust") {
    text += times(room);
  } else if (call.name == "rjust") {
    text = times(room) + text;
  } else {
    const std::int64_t left = room / 2 + (room & call.values[0].integer & 1);
    text = times(left) + text + times(room - left);
  }
  return call.evaluator.text(std::move(text));
}

Value expand_tabs(Call& call) {
  const Value* width = call.take(0, "tabsize");
  if (!call.has_count(0, 1)) return Value::failure();
  const auto given = width == nullptr       ? 8
                     : width->is_integral() ? to_big(*width).to_int64()
                                            : std::nullopt;
  if (!given) return call.evaluator.fail("`expandtabs()` needs an integer");
  const std::uint64_t most = call.evaluator.limits().xacro_text_bytes;
  const std::size_t size = *given <= 0 ? 0 : std::min(static_cast<std::uint64_t>(*given), most + 1);
  std::string result;
  std::size_t column = 0;
  call.evaluator.meter().scan(self_of(call).size());
  for (const char c : self_of(call)) {
    if (c == '\t' && size > 0) {
      const std::size_t blanks = size - column % size;
      result.append(blanks, ' ');
      column += blanks;
    } else if (c != '\t') {
      result.push_back(c);
      column += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1 : 0;
      if (c == '\n' || c == '\r') column = 0;
    }
    if (result.size() > most) break;
  }
  return call.evaluator.text(std::move(result));
}

constexpr std::array kText = {Method{"capitalize", capitalize},
                              Method{"casefold", to_lower},
                              Method{"center", fill},
                              Method{"count", count_text},
                              Method{"encode", nullptr},
                              Method{"endswith", has_end},
                              Method{"expandtabs", expand_tabs},
                              Method{"find", find_text},
                              Method{"format", brace_format},
                              Method{"format_map", nullptr},
                              Method{"index", find_text},
                              Method{"isalnum", is_class},
                              Method{"isalpha", is_class},
                              Method{"isascii", is_class},
                              Method{"isdecimal", is_class},
                              Method{"isdigit", is_class},
                              Method{"isidentifier", is_class},
                              Method{"islower", is_class},
                              Method{"isnumeric", is_class},
                              Method{"isprintable", is_class},
                              Method{"isspace", is_class},
                              Method{"istitle", is_class},
                              Method{"isupper", is_class},
                              Method{"join", join},
                              Method{"ljust", fill},
                              Method{"lower", to_lower},
                              Method{"lstrip", strip},
                              Method{"maketrans", nullptr},
                              Method{"partition", partition},
                              Method{"removeprefix", remove_end},
                              Method{"removesuffix", remove_end},
                              Method{"replace", replace},
                              Method{"rfind", find_text},
                              Method{"rindex", find_text},
                              Method{"rjust", fill},
                              Method{"rpartition", partition},
                              Method{"rsplit", split},
                              Method{"rstrip", strip},
                              Method{"split", split},
                              Method{"splitlines", splitlines},
                              Method{"startswith", has_end},
                              Method{"strip", strip},
                              Method{"swapcase", swapcase},
                              Method{"title", title},
                              Method{"translate", nullptr},
                              Method{"upper", to_upper},
                              Method{"zfill", fill}};

}  // namespace

const Method* find_method(std::span<const Method> rows, std::string_view name) {
  const auto found =
      std::find_if(rows.begin(), rows.end(), [&](const Method& one) { return one.name == name; });
  return found == rows.end() ? nullptr : &*found;
}

std::span<const Method> text_methods() { return kText; }

}  // namespace smurf::xacro
