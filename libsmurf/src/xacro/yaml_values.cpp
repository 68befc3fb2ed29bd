// SPDX-License-Identifier: BSD-3-Clause
// Values of YAML 1.1, as PyYAML's safe loader makes them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "syntax/yaml_reader.hpp"
#include "xacro/expander.hpp"
#include "xacro/python_text.hpp"
#include "xacro/xacro_cases.hpp"

namespace smurf::xacro {
namespace {

struct Unit {
  std::string_view tag;
  double factor;
};
constexpr std::array kUnits = {Unit{"!radians", 1.0}, Unit{"!degrees", std::numbers::pi / 180.0},
                               Unit{"!meters", 1.0},  Unit{"!millimeters", 0.001},
                               Unit{"!foot", 0.3048}, Unit{"!inches", 0.0254}};

/// The word that ends at a place, and where it begins.
std::string_view word_before(std::string_view source, std::size_t& end) {
  while (end > 0 && is_blank(source[end - 1])) --end;
  std::size_t begin = end;
  while (begin > 0 && !is_blank(source[begin - 1]) && source[begin - 1] != ',' &&
         source[begin - 1] != '[' && source[begin - 1] != '{') {
    --begin;
  }
  const std::string_view word = source.substr(begin, end - begin);
  end = begin;
  return word;
}

/// Whether a place is in a comment that ends its line.
bool is_in_comment(std::string_view source, std::size_t at) {
  const std::size_t line = source.rfind('\n', at) + 1;
  const std::string_view before = source.substr(line, at - line);
  return before.starts_with('#') || before.find(" #") != std::string_view::npos;
}

/// The tag in front of a value, such as "!degrees"; it is not part of the value's bytes.
std::string_view tag_before(std::string_view source, Span value) {
  std::size_t end = value.begin;
  if (value.end > value.begin && source[value.begin] == '!') {
    return source.substr(value.begin,
                         std::min(source.find_first_of(" \t\r\n,]}", value.begin), source.size()) -
                             value.begin);
  }
  std::string_view word = word_before(source, end);
  if (word.starts_with('&')) word = word_before(source, end);
  if (!word.starts_with('!')) return {};
  const bool is_on_line =
      source.substr(end, value.begin - end).find('\n') == std::string_view::npos;
  return is_on_line || !is_in_comment(source, end) ? word : std::string_view();
}

/// The tag of an absent value, on its line.
std::string_view tag_of_absent(std::string_view source, Span place) {
  const std::size_t begin = source.find_first_not_of(" \t", place.end);
  if (!place.empty() || begin == std::string_view::npos || source[begin] != '!') return {};
  return source.substr(begin,
                       std::min(source.find_first_of(" \t\r\n,]}", begin), source.size()) - begin);
}

/// "1:30:00" in base 60.
std::optional<double> sexagesimal(std::string_view digits) {
  double value = 0;
  while (true) {
    const std::size_t colon = std::min(digits.find(':'), digits.size());
    const auto part = read_float(digits.substr(0, colon));
    if (!part) return std::nullopt;
    value = value * 60 + *part;
    if (colon == digits.size()) return value;
    digits.remove_prefix(colon + 1);
  }
}

/// "30:00": numbers below 60.
bool are_sixtieths(std::string_view text) {
  while (true) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view number = text.substr(0, colon);
    const bool is_part = !number.empty() && number.size() <= 2 &&
                         std::all_of(number.begin(), number.end(), is_digit) &&
                         (number.size() == 1 || number[0] <= '5');
    if (!is_part || colon == text.size()) return is_part;
    text.remove_prefix(colon + 1);
  }
}

/// Whether a text is an integer of YAML 1.1, and its digits and base; 60 for "1:30".
bool is_yaml_integer(std::string_view text, std::string& digits, unsigned& base) {
  if (text.starts_with('-') || text.starts_with('+')) text.remove_prefix(1);
  if (text.empty() || !is_digit(text[0])) return false;
  const auto only = [](std::string_view rest, std::string_view allowed) {
    return !rest.empty() && rest.find_first_not_of(allowed) == std::string_view::npos;
  };
  base = 10;
  std::string_view rest = text;
  if (text.starts_with("0b")) {
    base = 2;
    rest = text.substr(2);
    if (!only(rest, "01_")) return false;
  } else if (text.starts_with("0x")) {
    base = 16;
    rest = text.substr(2);
    if (!only(rest, "0123456789abcdefABCDEF_")) return false;
  } else if (text.size() > 1 && text[0] == '0') {
    base = 8;
    rest = text.substr(1);
    if (!only(rest, "01234567_")) return false;
  } else if (text.find(':') != std::string_view::npos) {
    base = 60;
    if (text[0] == '0' || !only(text.substr(0, text.find(':')), "0123456789_")) return false;
    if (!are_sixtieths(text.substr(text.find(':') + 1))) return false;
  } else if (!only(text, "0123456789_")) {
    return false;
  }
  digits = rest;
  std::erase(digits, '_');
  return !digits.empty();
}

/// A float of YAML 1.1 has a point, and its exponent a sign.
bool is_yaml_float(std::string_view text) {
  // "-.5" is a text, as in PyYAML.
  if (text.size() > 1 && (text[0] == '-' || text[0] == '+') && text[1] != '.')
    text.remove_prefix(1);
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos) return false;
  const std::string_view whole = text.substr(0, point);
  std::string_view rest = text.substr(point + 1);
  constexpr std::string_view kDigits = "0123456789_";
  if (whole.find(':') != std::string_view::npos) {
    return is_digit(whole[0]) && are_sixtieths(whole.substr(whole.find(':') + 1)) &&
           whole.substr(0, whole.find(':')).find_first_not_of(kDigits) == std::string_view::npos &&
           rest.find_first_not_of(kDigits) == std::string_view::npos;
  }
  if (whole.find_first_not_of(kDigits) != std::string_view::npos) return false;
  if (!whole.empty() && !is_digit(whole[0])) return false;
  const std::size_t digits_end = std::min(rest.find_first_not_of(kDigits), rest.size());
  if (whole.empty() && (digits_end == 0 || !is_digit(rest[0]))) return false;
  rest.remove_prefix(digits_end);
  if (rest.empty()) return true;
  if ((rest[0] != 'e' && rest[0] != 'E') || rest.size() < 3) return false;
  if (rest[1] != '-' && rest[1] != '+') return false;
  return std::all_of(rest.begin() + 2, rest.end(), is_digit);
}

bool is_ascii_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool is_special(std::string_view text, std::string_view name) {
  // ".inf", ".Inf", ".INF"
  if (text.size() != name.size()) return false;
  if (text.front() != '.' || path::to_lower(text) != name) return false;
  const std::string_view letters = text.substr(1);
  const bool is_lower = letters == name.substr(1);
  const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
  const bool has_upper = std::all_of(letters.begin(), letters.end(), is_upper);
  const bool is_title = is_upper(letters[0]) && letters.substr(1) == name.substr(2);
  return is_lower || has_upper || is_title || text == ".NaN";
}

/// True or false for the words of YAML 1.1.
std::optional<bool> truth_of_word(std::string_view text) {
  if (text.size() < 2 || text.size() > 5) return std::nullopt;
  for (const std::string_view word : {"yes", "true", "on", "no", "false", "off"}) {
    if (text.size() != word.size() || path::to_lower(text) != word) continue;
    const bool is_lower = text == word;
    const bool is_title = text.substr(1) == word.substr(1);
    const auto is_upper = [](char c) { return c >= 'A' && c <= 'Z'; };
    if (!is_lower && !is_title && !std::all_of(text.begin(), text.end(), is_upper))
      return std::nullopt;
    return word == "yes" || word == "true" || word == "on";
  }
  return std::nullopt;
}

/// "2020-01-31", alone or before a time of day: a date in YAML 1.1.
bool is_timestamp(std::string_view text) {
  constexpr std::string_view kDate = "0000-00-00";
  const auto is_like = [](std::string_view part, std::string_view form) {
    return part.size() == form.size() &&
           std::equal(part.begin(), part.end(), form.begin(),
                      [](char c, char of) { return of == '0' ? is_digit(c) : c == of; });
  };
  if (is_like(text, kDate)) return true;
  if (text.size() < 5 || !is_like(text.substr(0, 5), kDate.substr(0, 5))) return false;
  const std::size_t blank = text.find_first_of("tT \t");
  if (blank == std::string_view::npos) return false;
  const std::string_view day = text.substr(0, blank);
  const std::string_view time = without_blanks(text.substr(blank + 1));
  return day.size() <= kDate.size() && day.find_first_not_of("0123456789-") == day.npos &&
         std::count(day.begin(), day.end(), '-') == 2 &&
         std::count(time.begin(), time.end(), ':') >= 2 &&
         time.find_first_not_of("0123456789:.+-Z \t") == time.npos;
}

/// The first tab outside of quotes, block scalars and comments, which PyYAML refuses.
std::optional<std::uint32_t> refused_tab(const yaml::Document& document, std::string_view source) {
  if (source.find('\t') == std::string_view::npos) return std::nullopt;
  std::vector<Span> texts;
  for (const yaml::Node& node : document.nodes) {
    const Span key = node.key_span();
    if (!key.empty() && (source[key.begin] == '"' || source[key.begin] == '\''))
      texts.push_back(key);
    if (node.kind() != yaml::Kind::scalar || node.style == yaml::Style::plain) continue;
    Span text = node.span;
    const char first = source[std::min<std::size_t>(text.begin, source.size() - 1)];
    if (first == '|' || first == '>') {
      // Only a comment may have tabs on the first line.
      const std::size_t end = std::min(source.find_first_of("#\n", text.begin), source.size());
      text.begin = offset(end);
    }
    texts.push_back(text);
  }
  std::sort(texts.begin(), texts.end(), [](Span a, Span b) { return a.begin < b.begin; });
  auto text = texts.begin();
  for (std::size_t at = 0; at < source.size(); ++at) {
    while (text != texts.end() && text->end <= at) ++text;
    if (text != texts.end() && text->begin <= at) {
      at = text->end - 1;
    } else if (source[at] == '#' && (at == 0 || is_blank(source[at - 1]))) {
      at = std::min(source.find('\n', at), source.size());
    } else if (source[at] == '\t') {
      return offset(at);
    }
  }
  return std::nullopt;
}

/// The exact bytes of a scalar, without quotes.
Place place_of(std::string_view source, std::string_view text, Span span) {
  const std::string_view written = source.substr(span.begin, span.end - span.begin);
  if (written == text) return {span, true};
  if (written.size() == text.size() + 2 && written.substr(1, text.size()) == text) {
    ++span.begin;
    --span.end;
    return {span, true};
  }
  return {span, false};
}

}  // namespace

Value Expander::yaml_unit(std::string_view text, double factor, Span span) {
  const Value value = evaluator_.evaluate(heap_.keep(without_blanks(text)), *functions_);
  if (value.is_failed()) {
    evaluator_.failure().span = span;
    return value;
  }
  const auto number = value.is_text() ? read_float(*value.text) : to_real(value);
  if (!number) {
    const Value fault = evaluator_.fail("a value with a unit must be a number");
    evaluator_.failure().span = span;
    return fault;
  }
  return Value::of(*number * factor).at(heap_.add({span, false}));
}

Value Expander::fail_yaml(const std::string& message, Span span, bool is_unsupported) {
  const Value fault =
      is_unsupported ? evaluator_.fail_unsupported(message) : evaluator_.fail(message);
  evaluator_.failure().span = span;
  return fault;
}

std::optional<Value> Expander::yaml_integer(std::string_view text) {
  std::string digits;
  unsigned base = 10;
  if (!is_yaml_integer(text, digits, base)) return std::nullopt;
  const bool is_negative = text[0] == '-';
  if (base == 60) {
    const auto value = static_cast<std::int64_t>(sexagesimal(digits).value_or(0));
    return Value::of(is_negative ? -value : value);
  }
  return read_integer((is_negative ? "-" : "") + digits, heap_, base);
}

std::optional<Value> Expander::yaml_float(std::string_view text) {
  if (is_yaml_float(text)) {
    std::string plain(text);
    std::erase(plain, '_');
    const bool is_negative = plain[0] == '-';
    if (is_negative || plain[0] == '+') plain.erase(0, 1);
    const auto value =
        plain.find(':') != std::string::npos ? sexagesimal(plain) : read_float(plain);
    if (value) return Value::of(is_negative ? -*value : *value);
  }
  const bool has_sign = text.starts_with('-') || text.starts_with('+');
  if (is_special(text.substr(has_sign ? 1 : 0), ".inf")) {
    const double infinity = *read_float("inf");
    return Value::of(text[0] == '-' ? -infinity : infinity);
  }
  if (is_special(text, ".nan")) return Value::of(*read_float("nan"));
  return std::nullopt;
}

Value Expander::yaml_tagged(std::string_view text, std::string_view tag, Span span) {
  std::optional<Value> value;
  if (tag == "!!null") value = Value();
  if (tag == "!!int") value = yaml_integer(text);
  if (tag == "!!float") {
    value = yaml_float(text);
    const auto whole = value ? std::nullopt : read_float(text);
    if (whole) value = Value::of(*whole);
  }
  if (tag == "!!bool") {
    if (const auto truth = truth_of_word(path::to_lower(text))) value = Value::of(*truth);
  }
  if (value) return *value;
  if (is_one_of(tag, {"!!binary", "!!timestamp"}))
    return fail_yaml("the tag " + quoted(tag), span, true);
  return fail_yaml(is_one_of(tag, {"!!int", "!!float", "!!bool"})
                       ? quoted(text) + " is no value for the tag " + quoted(tag)
                       : "the tag " + quoted(tag) + " is unknown",
                   span, false);
}

Value Expander::yaml_scalar(std::string_view text, yaml::Style style, std::string_view tag,
                            Span span) {
  const OriginId origin = heap_.add(place_of(context_.sources.text(span.source), text, span));
  if (!tag.empty() && tag != "!" && tag != "!!str") {
    for (const Unit& unit : kUnits) {
      if (unit.tag == tag) return yaml_unit(text, unit.factor, span);
    }
    return yaml_tagged(text, tag, span).at(origin);
  }
  if (style != yaml::Style::plain || tag == "!!str") {
    return heap_.text(std::string(text)).at(origin);
  }
  if (text.empty() || is_one_of(text, {"~", "null", "Null", "NULL"})) return Value().at(origin);
  if (const auto truth = truth_of_word(text)) return Value::of(*truth).at(origin);
  if (is_ascii_letter(text.front())) return heap_.text(std::string(text)).at(origin);
  if (const auto integer = yaml_integer(text)) return integer->at(origin);
  if (const auto real = yaml_float(text)) return real->at(origin);
  if (text == "=" || text == "<<") {
    return fail_yaml(quoted(text) + " is no value; put it in quotes", span, false);
  }
  Value value = heap_.text(std::string(text));
  if (is_timestamp(text)) value.kind = Kind::date;
  return value.at(origin);
}

Value Expander::yaml_mapping(yaml::View view, std::string_view source) {
  Dict dict;
  std::vector<yaml::View> merged;
  for (const yaml::View member : view) {
    if (member.key() != "<<" || source[member.key_span().begin] == '\'' ||
        source[member.key_span().begin] == '"')
      continue;
    if (member.is_sequence()) {
      for (const yaml::View one : member) merged.push_back(one);
    } else {
      merged.push_back(member);
    }
  }
  for (auto one = merged.rbegin(); one != merged.rend(); ++one) {
    const Value inner = yaml_value(*one, source);
    if (inner.is_failed()) return inner;
    if (inner.kind != Kind::dict) return evaluator_.fail("`<<` needs a mapping");
    for (const auto& [key, value] : inner.dict->items) insert(dict, key, value, meter_);
  }
  for (const yaml::View member : view) {
    const char first = source[member.key_span().begin];
    const bool is_quoted = first == '\'' || first == '"';
    if (member.key() == "<<" && !is_quoted) continue;
    const yaml::Style style = is_quoted ? yaml::Style::single_quoted : yaml::Style::plain;
    const std::string_view tag = has_yaml_tags_ ? tag_before(source, member.key_span()) : "";
    if (!tag.empty() && !is_one_of(tag, {"!", "!!map", "!!str"})) {
      return fail_yaml("the tag " + quoted(tag) + " of a key", member.key_span(), true);
    }
    const Value key = yaml_scalar(member.key(), style, {}, member.key_span());
    if (key.is_failed()) return key;
    const Value value = yaml_value(member, source);
    if (value.is_failed()) return value;
    insert(dict, key, value, meter_);
    evaluator_.step(2);
  }
  return heap_.dict(std::move(dict));
}

Value Expander::yaml_value(yaml::View view, std::string_view source) {
  if (!view) return {};
  evaluator_.step(2);
  const yaml::Node& node = view.document().nodes[static_cast<std::size_t>(view.id())];
  if (node.is_alias()) return yaml_value(yaml::View(view.document(), node.target()), source);
  if (has_yaml_tags_ && (view.is_mapping() || view.is_sequence())) {
    const std::string_view tag = tag_before(source, view.span());
    if (!tag.empty() && tag != "!" && tag != (view.is_mapping() ? "!!map" : "!!seq")) {
      return fail_yaml("the tag " + quoted(tag) + " in front of a list or a mapping", view.span(),
                       true);
    }
  }
  if (view.is_mapping()) return yaml_mapping(view, source);
  if (view.is_sequence()) {
    std::vector<Value> items;
    for (const yaml::View item : view) {
      items.push_back(yaml_value(item, source));
      if (items.back().is_failed()) return items.back();
    }
    return evaluator_.list(std::move(items));
  }
  if (view.is_null()) return Value().at(heap_.add({view.place(), false}));
  std::string_view tag = has_yaml_tags_ ? tag_before(source, view.span()) : "";
  if (has_yaml_tags_ && tag.empty()) tag = tag_of_absent(source, view.span());
  return yaml_scalar(view.text(), view.style(), tag, view.span());
}

Value Expander::load_yaml(const std::string& written) {
  if (written.empty()) {
    evaluator_.fail(rules::sml3310_xacro_missing_file, "the name of the YAML file is empty",
                    "write a path, or give the argument that names the file a value: `NAME:=PATH`");
    evaluator_.failure().which = &kEmptyFileName;
    return Value::failure();
  }
  const std::string path = whole_path(written);
  File* file = open(path, {});
  if (file == nullptr) {
    evaluator_.failure().is_missing_file = false;  // optional includes need it
    return Value::failure();
  }
  const auto known = yaml_files_.find(file->path);
  Value value;
  if (known != yaml_files_.end()) {
    value = known->second;
  } else {
    DiagnosticSink found(context_.limits);
    const auto document = parse_yaml(context_.sources, file->source, context_.limits, found);
    for (const Diagnostic& one : found.diagnostics()) {
      const bool is_several = one.rule == &rules::sml0013_several_documents;
      if (one.severity != Severity::error && !is_several) continue;
      if (one.rule == &rules::sml0011_duplicate_key) continue;
      if (is_several)
        return fail_yaml("a second YAML document begins here; xacro fails", one.span, false);
      const Value fault = evaluator_.fail(*one.rule, one.message, one.help_text);
      evaluator_.failure().span = one.span;
      return fault;
    }
    if (!document) return evaluator_.fail("the file " + quoted(file->path) + " is not YAML");
    if (const auto tab = refused_tab(*document, context_.sources.text(file->source))) {
      return fail_yaml("a tab is not allowed here; write blanks", {file->source, *tab, *tab + 1},
                       false);
    }
    file_stack_.push_back(file->path);
    const std::string_view text = context_.sources.text(file->source);
    const bool outer = std::exchange(has_yaml_tags_, text.find('!') != std::string_view::npos);
    value = yaml_value(document->view(), text);
    has_yaml_tags_ = outer;
    file_stack_.pop_back();
    if (value.is_failed()) return value;
    yaml_files_[file->path] = value;
  }
  return evaluator_.wrapped(value);
}

void Expander::say(std::string_view kind, const std::string& text) {
  if (kind != "warning" && kind != "error") return;
  // The place is that of the element being expanded, which a frame names.
  const Frame& frame = result_.frame(frame_);
  const Span place = frame.call.empty() ? Span{result_.root, 0, 0} : frame.call;
  if (!is_first_at(place)) return;
  context_.sink
      .report(rules::sml3405_xacro_message, place, "xacro." + std::string(kind) + ": " + text)
      .help("the author of the description wrote this; change the call, or the arguments");
}

}  // namespace smurf::xacro
