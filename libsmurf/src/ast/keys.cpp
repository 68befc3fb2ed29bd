// SPDX-License-Identifier: BSD-3-Clause
#include "ast/keys.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ast/key_renames.hpp"
#include "ast/notation.hpp"
#include "ast/wrong_type.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

std::string name_of(const KeySpec& spec) { return quoted(spec.name); }

/// A help with an edit that replaces the value. The fix is unsafe, because some reader understands
/// the old value.
void offer(Diagnostic& diagnostic, std::string help, Span place, std::string_view text) {
  diagnostic.help(std::move(help));
  diagnostic.fixes.push_back({Applicability::unsafe, {{place, std::string(text)}}});
}

Diagnostic& report_type(const KeySpec& spec, const Circumstance& wanted, yaml::View value,
                        std::string_view expected, DiagnosticSink& sink) {
  return report_wrong_type(
      wanted, value,
      name_of(spec) + " must be " + std::string(expected) + ", not " + describe(value), sink);
}

void report_not_number(const KeySpec& spec, yaml::View value, std::string_view expected,
                       DiagnosticSink& sink) {
  Diagnostic& diagnostic = report_type(spec, cases::kValueWanted, value, expected, sink);
  const yaml::ScalarType type = type_without_quotes(value);
  if (type == yaml::ScalarType::integer || type == yaml::ScalarType::number) {
    offer(
        diagnostic,
        "remove the quotes: MARS reads a number, but readers that know the types of YAML read a text",
        value.span(), value.text());
  } else if (value.is_scalar() && !spec.unit.empty()) {
    diagnostic.help("write the number alone; its unit is " + std::string(spec.unit));
  }
}

/// Numbers in a list where a mapping is needed, as `{r: 0.8, g: 0.2, b: 0.2, a: 1}`. Empty if the
/// list does not have as many numbers as the mapping; the `a` of a colour may be missing.
std::string as_mapping(const KeySpec& spec, yaml::View list) {
  const auto names = components_of(spec.type);
  const std::size_t least = spec.type == ValueType::color ? 3 : names.size();
  if (!list.is_sequence() || list.size() < least || list.size() > names.size()) return {};
  std::string text = "{";
  const std::string_view quote = is_json(list.document()) ? "\"" : "";
  std::size_t next = 0;
  const auto add = [&](std::string_view number) {
    text.append(next == 0 ? "" : ", ").append(quote).append(names[next]).append(quote);
    text.append(": ").append(number);
    ++next;
  };
  for (const yaml::View item : list) {
    if (!item.is_scalar() || !item.number()) return {};
    add(item.text());
  }
  if (next < names.size()) add("1");
  return text + "}";
}

void report_not_mapping(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  Diagnostic& diagnostic =
      report_type(spec, cases::kMappingWanted, value, describe(spec.type), sink);
  const std::string mapping = as_mapping(spec, value);
  if (!mapping.empty()) {
    diagnostic.help("write `" + mapping + "`");
  } else if (spec.type == ValueType::color && value.is_sequence() && value.size() > 1) {
    // Phobos reads a list of three or four numbers, and no others.
    diagnostic.when(cases::kHasItems);
  }
}

/// Differences between readers with other grammars for numbers and texts. In JSON, all readers
/// agree.
void check_notation(const KeySpec& spec, yaml::View value, double number, bool is_whole,
                    DiagnosticSink& sink) {
  if (is_in_all_notations(value.text(), is_whole)) return;
  const std::optional<std::string> in_mars = read_by_scanf(value.text(), is_whole);
  const std::optional<std::string> in_yaml11 = number_by_yaml11(value.text());
  if ((!in_mars && !in_yaml11) || is_json(value.document())) return;
  if (in_mars) {
    Diagnostic& diagnostic = sink.report(rules::sml4006_number_notation, value.span(),
                                         "MARS reads `" + std::string(value.text()) + "` of " +
                                             name_of(spec) + " as " + *in_mars);
    offer(diagnostic, "write " + format_number(number), value.span(), format_number(number));
  } else {
    Diagnostic& diagnostic = sink.report(rules::sml4007_yaml_version, value.span(),
                                         "Phobos reads `" + std::string(value.text()) + "` of " +
                                             name_of(spec) + " as " + *in_yaml11);
    const std::string text = in_all_notations(number);
    offer(diagnostic, "write " + text, value.span(), text);
  }
}

/// Words that YAML 1.1 reads as booleans, times and dates.
void check_text(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  if (value.style() != yaml::Style::plain) return;
  const std::optional<std::string> in_yaml11 = text_by_yaml11(value.text());
  if (!in_yaml11 || value.number()) return;  // types and versions may be numbers
  Diagnostic& diagnostic = sink.report(rules::sml4007_yaml_version, value.span(),
                                       "Phobos reads `" + std::string(value.text()) + "` of " +
                                           name_of(spec) + " as " + *in_yaml11);
  diagnostic.help("put it in quotes");
  diagnostic.fixes.push_back(
      {Applicability::safe, {{value.span(), "'" + std::string(value.text()) + "'"}}});
}

bool has_range(const KeySpec& spec) {
  return spec.type == ValueType::color || std::isfinite(bounds_of(spec).maximum);
}

/// Returns a finite number. Reports a number outside of its range, but returns it. Reports other
/// values and returns none.
std::optional<double> usable_number(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  const std::optional<double> number = value.number();
  if (!number || !std::isfinite(*number)) {
    report_not_number(spec, value, "a number", sink);
    return std::nullopt;
  }
  if (spec.is_limit || has_range(spec) || is_quantity(*number)) return number;
  sink.report(rules::sml4003_out_of_range, value.span(),
              name_of(spec) + " is " + format_number(*number) + ", too large to compute with");
  return std::nullopt;
}

bool check_range(const KeySpec& spec, yaml::View value, double number, DiagnosticSink& sink) {
  const Bounds bounds = bounds_of(spec);
  const bool is_low = number < bounds.minimum || (spec.positive && number <= 0);
  if (!is_low && number <= bounds.maximum) return true;
  const std::string bound = !is_low         ? "at most " + format_number(bounds.maximum)
                            : spec.positive ? std::string("above 0")
                                            : "at least " + format_number(bounds.minimum);
  Diagnostic& diagnostic =
      sink.report(rules::sml4003_out_of_range, value.span(),
                  name_of(spec) + " is " + format_number(number) + ", but must be " + bound);
  if (number < 0) diagnostic.when(cases::kNegative);
  return false;
}

/// Compares numeric choices (types of old MARS files) as numbers.
bool is_choice(const KeySpec& spec, yaml::View value) {
  const std::optional<double> number = value.number();
  return std::any_of(spec.choices.begin(), spec.choices.end(), [&](std::string_view choice) {
    return choice == value.text() || (number && parse_number(choice) == number);
  });
}

void check_choice(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  if (spec.choices.empty() || is_choice(spec, value)) return;
  Diagnostic& diagnostic =
      sink.report(rules::sml4002_unknown_value, value.span(),
                  quoted(value.text()) + " is not a value of " + name_of(spec));
  if (const auto near = only_nearest(value.text(), spec.choices)) {
    return offer(diagnostic, "did you mean `" + std::string(*near) + "`?", within_quotes(value),
                 *near);
  }
  diagnostic.help("known values:");
  for (const std::string_view choice : spec.choices) {
    diagnostic.help_text += " `" + std::string(choice) + "`";
  }
}

template <class T>
void store(Target target, yaml::View value, std::optional<T> read) {
  if (Field<T>* const* field = std::get_if<Field<T>*>(&target)) {
    **field = Field<T>(std::move(read), value.place());
  }
}

void read_text(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  std::optional<std::string> text;
  if (value.is_scalar()) {
    check_choice(spec, value, sink);
    if (spec.type != ValueType::frame) check_text(spec, value, sink);
    if (spec.required && value.text().empty()) {
      sink.report(rules::sml4008_incomplete_value, value.place(), name_of(spec) + " is empty");
    }
    text = std::string(value.text());
  } else {
    Diagnostic& diagnostic = report_type(spec, cases::kValueWanted, value, "a text", sink);
    if (spec.names.kinds.contains(NameKind::pose) && value.is_sequence()) {
      diagnostic.help("a pose is a named set of joint positions; the place of an entity is written "
                      "as `position` and `rotation`");
    }
  }
  store(target, value, std::move(text));
}

void read_number(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  const std::optional<double> number = usable_number(spec, value, sink);
  if (number && check_range(spec, value, *number, sink)) {
    check_notation(spec, value, *number, false, sink);
  }
  store(target, value, number);
}

/// 10.0 is whole, and configmaps reads it as 10.
void read_integer(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  const std::optional<double> number = value.number();
  std::optional<std::int64_t> whole;
  if (!number || !std::isfinite(*number) || std::trunc(*number) != *number) {
    report_not_number(spec, value, "a whole number", sink);
  } else if (check_range(spec, value, *number, sink)) {
    whole = static_cast<std::int64_t>(*number);
    check_notation(spec, value, *number, true, sink);
  }
  store(target, value, whole);
}

void read_boolean(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  std::optional<bool> boolean = value.boolean();
  // configmaps reads 0 and 1 as booleans as well.
  if (const auto number = value.number(); number && (*number == 0 || *number == 1)) {
    boolean = *number == 1;
  }
  if (!boolean) {
    Diagnostic& diagnostic = report_type(spec, cases::kValueWanted, value, "true or false", sink);
    if (is_one_of(value.text(), {"yes", "Yes", "YES", "on", "On", "ON", "y", "Y"})) {
      offer(diagnostic, "write `true`: MARS does not know this word", value.span(), "true");
    } else if (is_one_of(value.text(), {"no", "No", "NO", "off", "Off", "OFF", "n", "N"})) {
      offer(diagnostic, "write `false`: MARS does not know this word", value.span(), "false");
    } else if (type_without_quotes(value) == yaml::ScalarType::boolean) {
      offer(
          diagnostic,
          "remove the quotes: MARS reads a boolean, but readers that know the types of YAML read a text",
          value.span(), value.text());
    }
  }
  store(target, value, boolean);
}

void read_names(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  NameList names;
  if (spec.type == ValueType::names && value.is_scalar()) {
    check_text(spec, value, sink);
    names.push_back({std::string(value.text()), value.span()});
    return store(target, value, std::optional(std::move(names)));
  }
  if (!value.is_sequence()) {
    report_type(spec, cases::kNamesWanted, value, describe(spec.type), sink);
    return store<NameList>(target, value, std::nullopt);
  }
  for (const yaml::View item : value) {
    if (item.is_scalar()) {
      check_text(spec, item, sink);
      names.push_back({std::string(item.text()), item.span()});
    } else {
      report_type(spec, cases::kNamesWanted, item, "a list of names", sink);
    }
  }
  store(target, value, std::optional(std::move(names)));
}

void read_number_list(const KeySpec& spec, yaml::View value, std::size_t count, Target target,
                      DiagnosticSink& sink) {
  std::vector<double> numbers;
  const bool fits = value.is_sequence() && (count == 0 || value.size() == count);
  if (fits) {
    for (const yaml::View item : value) {
      if (const auto number = usable_number(spec, item, sink)) numbers.push_back(*number);
    }
  } else {
    Diagnostic& diagnostic =
        report_type(spec, cases::kNumbersWanted, value,
                    count == 0 ? "a list of numbers" : "a list of three numbers", sink);
    if (value.is_sequence()) diagnostic.message += " of " + std::to_string(value.size());
    if (count == 3) {
      const std::string unit = spec.unit.empty() ? "" : " in " + std::string(spec.unit);
      diagnostic.help("write three numbers" + unit + ", such as `[0, 0, 1]`");
    }
  }
  std::optional<Vector3> vector;
  if (count == 3 && numbers.size() == 3) vector = Vector3{numbers[0], numbers[1], numbers[2]};
  store(target, value, vector);
}

/// `r`, `g`, `b`.
std::string in_words(std::span<const std::string_view> names) {
  std::string words;
  for (const std::string_view name : names) {
    words += (words.empty() ? "`" : ", `") + std::string(name) + "`";
  }
  return words;
}

/// Components that must be complete; which ones are required depends on those that are present.
/// MARS reads missing components as 0, which may be intended for a position or a speed.
std::vector<std::string_view> missing_components(ValueType type, yaml::View value) {
  const auto names = components_of(type);
  std::span<const std::string_view> needed;
  if (type == ValueType::quaternion) needed = names;
  if (type == ValueType::color && value.size() > 0) needed = names.first(3);
  if (type == ValueType::orientation) {
    const auto quaternion = names.first(4);
    const bool is_quaternion =
        std::any_of(quaternion.begin(), quaternion.end(),
                    [&](std::string_view name) { return bool(value.find(name)); });
    if (is_quaternion) needed = quaternion;
  }
  std::vector<std::string_view> missing;
  for (const std::string_view name : needed) {
    if (!value.find(name)) missing.push_back(name);
  }
  return missing;
}

/// Reports unknown components, else missing ones, in one finding.
void check_components(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  const auto names = components_of(spec.type);
  for (const yaml::View member : value) {
    if (std::find(names.begin(), names.end(), member.key()) != names.end()) continue;
    Diagnostic& diagnostic =
        sink.report(rules::sml4005_misspelt_key, member.key_span(),
                    name_of(spec) + " has no component `" + std::string(member.key()) + "`");
    diagnostic.help("its components are " + in_words(names));
    const auto near = nearest(member.key(), names);
    KeyRenames renames(value);
    if (!near || renames.has(*near)) return;
    diagnostic.help("did you mean `" + std::string(*near) + "`?");
    return renames.offer(diagnostic.fixes, member, *near);
  }
  const auto missing = missing_components(spec.type, value);
  if (missing.empty()) return;
  sink.report(rules::sml4008_incomplete_value, value.place(),
              name_of(spec) + " has no " + in_words(missing) + ", which MARS reads as 0");
}

/// A mapping whose components must be numbers. Absent components stay absent.
bool read_components(const KeySpec& spec, yaml::View value, std::span<Field<double>> out,
                     DiagnosticSink& sink) {
  if (!value.is_mapping()) {
    report_not_mapping(spec, value, sink);
    return false;
  }
  const auto names = components_of(spec.type);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const yaml::View member = value.find(names[i]);
    if (!member || member.is_null()) continue;
    const std::optional<double> number = usable_number(spec, member, sink);
    if (i < out.size()) out[i] = {number, member.place()};
  }
  check_components(spec, value, sink);
  return true;
}

void read_vector3(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  Field<double> parts[3];
  std::optional<Vector3> vector;
  if (read_components(spec, value, parts, sink)) {
    vector = Vector3{parts[0].value_or(0), parts[1].value_or(0), parts[2].value_or(0)};
  }
  store(target, value, vector);
}

/// One finding for all components, because colours from 0 to 255 are wrong in each. `parts` are the
/// given components.
void check_color_range(const KeySpec& spec, std::span<const Field<double>, 4> parts,
                       DiagnosticSink& sink) {
  const auto names = components_of(spec.type);
  std::string wrong;
  Diagnostic* diagnostic = nullptr;
  std::vector<Edit> edits;
  bool is_byte = true;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!parts[i]) continue;
    const double value = *parts[i];
    is_byte = is_byte && value >= 0 && value <= 255 && std::trunc(value) == value;
    edits.push_back({parts[i].span, format_rounded(value / 255, 3)});
    if (value >= 0 && value <= 1) continue;
    wrong += (wrong.empty() ? "" : ", ") + std::string(names[i]) + " = " + format_number(value);
    if (diagnostic == nullptr) {
      diagnostic = &sink.report(rules::sml4003_out_of_range, parts[i].span, {});
    }
  }
  if (diagnostic == nullptr) return;
  diagnostic->message = name_of(spec) + " has " + wrong + ", but colours lie between 0 and 1";
  if (!is_byte) return;
  diagnostic->help("divide by 255");
  diagnostic->fixes.push_back({Applicability::unsafe, std::move(edits)});
}

void read_color(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  Field<double> parts[4];
  std::optional<Color> color;
  if (read_components(spec, value, parts, sink)) {
    check_color_range(spec, parts, sink);
    color = Color{parts[0], parts[1], parts[2], parts[3]};
  }
  store(target, value, std::move(color));
}

void check_number_map(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  if (!value.is_mapping()) {
    report_type(spec, cases::kMappingWanted, value, describe(spec.type), sink);
    return;
  }
  for (const yaml::View member : value) {
    if (member.is_repeated()) continue;
    if (member.is_null()) {
      sink.report(rules::sml4008_incomplete_value, member.place(),
                  quoted(member.key()) + " has no value and is ignored");
      continue;
    }
    const KeySpec inner{.name = member.key(), .type = ValueType::number};
    usable_number(inner, member, sink);
  }
}

void check_mapping(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  if (!value.is_mapping()) {
    report_type(spec, cases::kMappingWanted, value, describe(spec.type), sink);
  } else {
    check_keys(spec.members.keys(), value, spec.name, sink);
  }
}

void check_list(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  if (!value.is_sequence()) {
    report_type(spec, cases::kMappingWanted, value, describe(spec.type), sink);
    return;
  }
  if (spec.members.size == 0) return;
  const bool takes_names = !spec.names.kinds.empty();
  for (const yaml::View item : value) {
    if (item.is_mapping()) {
      check_keys(spec.members.keys(), item, spec.name, sink);
    } else if (!takes_names || !item.is_scalar() || item.is_null()) {
      report_type(spec, cases::kMappingWanted, item, "a list of mappings", sink);
    }
  }
}

}  // namespace

void read_value(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  // configmaps and PyYAML both treat a null as an absent key.
  if (value.is_null()) return;
  switch (spec.type) {
  case ValueType::text:
  case ValueType::frame: return read_text(spec, value, target, sink);
  case ValueType::number: return read_number(spec, value, target, sink);
  case ValueType::integer: return read_integer(spec, value, target, sink);
  case ValueType::boolean: return read_boolean(spec, value, target, sink);
  case ValueType::names:
  case ValueType::name_list: return read_names(spec, value, target, sink);
  case ValueType::number_list: return read_number_list(spec, value, 0, target, sink);
  case ValueType::number_map: return check_number_map(spec, value, sink);
  case ValueType::vector3_list: return read_number_list(spec, value, 3, target, sink);
  case ValueType::vector3: return read_vector3(spec, value, target, sink);
  case ValueType::color: return read_color(spec, value, target, sink);
  case ValueType::position:
    if (value.is_mapping()) return read_vector3(spec, value, target, sink);
    return read_number_list(spec, value, 3, target, sink);
  case ValueType::rotation: return;  // the scene reader distinguishes its forms
  case ValueType::vector2:
  case ValueType::quaternion:
  case ValueType::orientation: read_components(spec, value, {}, sink); return;
  case ValueType::mapping: return check_mapping(spec, value, sink);
  case ValueType::list: return check_list(spec, value, sink);
  case ValueType::any: return;
  }
}

void check_keys(std::span<const KeySpec> keys, yaml::View mapping, std::string_view what,
                DiagnosticSink& sink) {
  KeyDifference difference;
  for (const KeySpec& spec : keys) {
    const yaml::View value = mapping.find(spec.name);
    if (value) read_value(spec, value, {}, sink);
    if (spec.required && (!value || value.is_null())) difference.missing.push_back(&spec);
  }
  if (!difference.missing.empty()) {
    for (const yaml::View value : mapping) {
      if (find_key({keys}, value.key()) == nullptr) difference.unknown.push_back(value);
    }
  }
  report_difference(difference, mapping, what, sink);
}

}  // namespace smurf
