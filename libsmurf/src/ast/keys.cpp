// SPDX-License-Identifier: BSD-3-Clause
#include "ast/keys.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/rules.hpp"
#include "base/suggest.hpp"

namespace smurf {
namespace {

std::string name_of(const KeySpec& spec) { return "`" + std::string(spec.name) + "`"; }

void report_type(const KeySpec& spec, yaml::View value, std::string_view expected,
                 DiagnosticSink& sink) {
  sink.report(rules::sml4001_wrong_type, value.place(),
              name_of(spec) + " takes " + std::string(expected) + ", not " + describe(value));
}

/// A finite number, reported otherwise.
std::optional<double> finite_number(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  const std::optional<double> number = value.number();
  if (number && std::isfinite(*number)) return number;
  report_type(spec, value, "a number", sink);
  return std::nullopt;
}

bool check_range(const KeySpec& spec, yaml::View value, double number, DiagnosticSink& sink) {
  if (number >= spec.minimum && number <= spec.maximum) return true;
  const std::string bound =
      number < spec.minimum ? "at least " + format_number(spec.minimum)
                            : "at most " + format_number(spec.maximum);
  sink.report(rules::sml4003_out_of_range, value.span(),
              name_of(spec) + " is " + format_number(number) + ", but must be " + bound);
  return false;
}

bool check_choice(const KeySpec& spec, yaml::View value, DiagnosticSink& sink) {
  if (spec.choices.empty()) return true;
  if (std::find(spec.choices.begin(), spec.choices.end(), value.text()) != spec.choices.end()) {
    return true;
  }
  Diagnostic& diagnostic = sink.report(
      rules::sml4002_unknown_value, value.span(),
      "`" + std::string(value.text()) + "` is not a value of " + name_of(spec));
  if (const auto near = nearest(value.text(), spec.choices)) {
    diagnostic.help = "did you mean `" + std::string(*near) + "`?";
    diagnostic.fixes.push_back({Applicability::unsafe, {{value.span(), std::string(*near)}}});
  } else {
    diagnostic.help = "known values:";
    for (const std::string_view choice : spec.choices) {
      diagnostic.help += " `" + std::string(choice) + "`";
    }
  }
  return false;
}

template <class T>
void store(Target target, yaml::View value, std::optional<T> read) {
  if (Field<T>* const* field = std::get_if<Field<T>*>(&target)) {
    (*field)->value = std::move(read);
    (*field)->span = value.place();
    (*field)->written = true;
  }
}

void read_text(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  std::optional<std::string> text;
  if (value.is_scalar()) {
    check_choice(spec, value, sink);
    text = std::string(value.text());
  } else {
    report_type(spec, value, "a text", sink);
  }
  store(target, value, std::move(text));
}

void read_number(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  const std::optional<double> number = finite_number(spec, value, sink);
  if (number) check_range(spec, value, *number, sink);
  store(target, value, number);
}

void read_integer(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  const std::optional<std::int64_t> number = value.integer();
  if (number) {
    check_range(spec, value, static_cast<double>(*number), sink);
  } else {
    report_type(spec, value, "a whole number", sink);
  }
  store(target, value, number);
}

void read_boolean(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  std::optional<bool> boolean = value.boolean();
  // configmaps (MARS) reads 0 and 1 as booleans as well.
  if (const auto number = value.integer(); number && (*number == 0 || *number == 1)) {
    boolean = *number == 1;
  }
  if (!boolean) report_type(spec, value, "true or false", sink);
  store(target, value, boolean);
}

void read_names(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  if (!value.is_sequence()) {
    report_type(spec, value, "a list of names", sink);
    return store<NameList>(target, value, std::nullopt);
  }
  NameList names;
  for (const yaml::View item : value) {
    if (item.is_scalar()) {
      names.push_back({std::string(item.text()), item.span()});
    } else {
      report_type(spec, item, "a list of names", sink);
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
      if (const auto number = finite_number(spec, item, sink)) numbers.push_back(*number);
    }
  } else {
    report_type(spec, value, count == 0 ? "a list of numbers" : "a list of three numbers", sink);
  }
  std::optional<Vector3> vector;
  if (count == 3 && numbers.size() == 3) vector = Vector3{numbers[0], numbers[1], numbers[2]};
  store(target, value, vector);
}

/// A mapping whose known members must be numbers, e.g. x, y, z. Absent members stay absent.
bool read_components(const KeySpec& spec, yaml::View value,
                     std::span<const std::string_view> members, std::span<Field<double>> out,
                     DiagnosticSink& sink) {
  if (!value.is_mapping()) {
    std::string expected = "a mapping with";
    for (std::size_t i = 0; i < members.size(); ++i) {
      expected += (i == 0 ? " `" : ", `") + std::string(members[i]) + "`";
    }
    report_type(spec, value, expected, sink);
    return false;
  }
  for (std::size_t i = 0; i < members.size(); ++i) {
    const yaml::View member = value.find(members[i]);
    if (!member) continue;
    out[i].written = true;
    out[i].span = member.place();
    out[i].value = finite_number(spec, member, sink);
  }
  return true;
}

constexpr std::string_view kXyz[] = {"x", "y", "z"};
constexpr std::string_view kWxyz[] = {"w", "x", "y", "z"};
constexpr std::string_view kRgba[] = {"r", "g", "b", "a"};

void read_vector3(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  Field<double> parts[3];
  std::optional<Vector3> vector;
  if (read_components(spec, value, kXyz, parts, sink)) {
    vector = Vector3{parts[0].value_or(0), parts[1].value_or(0), parts[2].value_or(0)};
  }
  store(target, value, vector);
}

void read_color(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  Field<double> parts[4];
  std::optional<Color> color;
  if (read_components(spec, value, kRgba, parts, sink)) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (parts[i] && (*parts[i] < 0 || *parts[i] > 1)) {
        sink.report(rules::sml4003_out_of_range, parts[i].span,
                    name_of(spec) + " has " + std::string(kRgba[i]) + " = " +
                        format_number(*parts[i]) + ", but colours lie between 0 and 1");
      }
    }
    color = Color{parts[0], parts[1], parts[2], parts[3]};
  }
  store(target, value, std::move(color));
}

}  // namespace

void read_value(const KeySpec& spec, yaml::View value, Target target, DiagnosticSink& sink) {
  // configmaps and PyYAML both treat a null as a key that says nothing.
  if (value.is_null()) return;
  switch (spec.type) {
    case ValueType::text: return read_text(spec, value, target, sink);
    case ValueType::number: return read_number(spec, value, target, sink);
    case ValueType::integer: return read_integer(spec, value, target, sink);
    case ValueType::boolean: return read_boolean(spec, value, target, sink);
    case ValueType::name_list: return read_names(spec, value, target, sink);
    case ValueType::number_list: return read_number_list(spec, value, 0, target, sink);
    case ValueType::vector3_list: return read_number_list(spec, value, 3, target, sink);
    case ValueType::vector3: return read_vector3(spec, value, target, sink);
    case ValueType::color: return read_color(spec, value, target, sink);
    case ValueType::position:
      if (value.is_mapping()) return read_vector3(spec, value, target, sink);
      return read_number_list(spec, value, 3, target, sink);
    case ValueType::rotation: return;  // its forms are told apart by the scene reader
    case ValueType::quaternion: {
      Field<double> parts[4];
      read_components(spec, value, kWxyz, parts, sink);
      return;
    }
    case ValueType::mapping:
      if (!value.is_mapping()) report_type(spec, value, describe(spec.type), sink);
      return;
    case ValueType::list:
      if (!value.is_sequence()) report_type(spec, value, describe(spec.type), sink);
      return;
    case ValueType::any: return;
  }
}

void report_missing(std::span<const KeySpec* const> missing, yaml::View mapping,
                    std::string_view what, DiagnosticSink& sink) {
  for (const KeySpec* spec : missing) {
    // The place is the entry's first line, not the whole entry.
    Span place = mapping.span();
    for (const yaml::View child : mapping) {
      place = child.key_span();
      break;
    }
    sink.report(rules::sml4004_missing_key, place,
                "this " + std::string(what) + " has no " + name_of(*spec));
  }
}

std::string_view describe(ValueType type) {
  switch (type) {
    case ValueType::text: return "a text";
    case ValueType::number: return "a number";
    case ValueType::integer: return "a whole number";
    case ValueType::boolean: return "true or false";
    case ValueType::name_list: return "a list of names";
    case ValueType::number_list: return "a list of numbers";
    case ValueType::vector3: return "a mapping with `x`, `y`, `z`";
    case ValueType::vector3_list: return "a list of three numbers";
    case ValueType::quaternion: return "a mapping with `w`, `x`, `y`, `z`";
    case ValueType::color: return "a mapping with `r`, `g`, `b`, `a`";
    case ValueType::position: return "a list of three numbers";
    case ValueType::rotation: return "one, three or four numbers";
    case ValueType::mapping: return "a mapping";
    case ValueType::list: return "a list";
    case ValueType::any: return "anything";
  }
  return "";
}

std::string describe(yaml::View value) {
  switch (value.kind()) {
    case yaml::Kind::null: return "nothing";
    case yaml::Kind::sequence: return "a list";
    case yaml::Kind::mapping: return "a mapping";
    case yaml::Kind::scalar: break;
  }
  constexpr std::size_t kLongest = 40;
  std::string text(value.text().substr(0, kLongest));
  if (value.text().size() > kLongest) text += "...";
  return (value.type() == yaml::ScalarType::text ? "the text `" : "`") + text + "`";
}

namespace rules {

constinit const Rule sml4001_wrong_type{
    .id = "SML4001",
    .name = "wrong-type",
    .severity = Severity::error,
    .summary = "A key holds a value of the wrong kind.",
    .why = "MARS keeps every scalar as text and reads uninitialised memory when it is not the number "
           "or boolean it needs (`yes`, `abc`, `.inf`); a list where it needs a mapping, or the "
           "reverse, is an uncaught exception.",
    .remedy = "Write the kind of value that the message names; `smurf-lint --explain` of the key's "
              "section and the schemas list them.",
    .sources = "configmaps ConfigAtom.hpp:83-91 and 335-386, MaterialData.cpp:53-80, Color.cpp:28-34 "
               "(run)."};

constinit const Rule sml4002_unknown_value{
    .id = "SML4002",
    .name = "unknown-value",
    .severity = Severity::error,
    .summary = "A key holds a word that is not one of its values.",
    .why = "MARS compares these words literally; an unknown one leaves the object undefined or stops "
           "the loading of everything that follows.",
    .remedy = "Use one of the known values; they are case-sensitive.",
    .sources = "MARS NodeData.cpp:98-286, JointData.cpp:89-164."};

constinit const Rule sml4003_out_of_range{
    .id = "SML4003",
    .name = "out-of-range",
    .severity = Severity::error,
    .summary = "A number lies outside what its key allows.",
    .why = "MARS takes the number as it is: a negative effort, size or rate is read as another "
           "number (unsigned keys wrap around) or makes the physics engine refuse the object.",
    .remedy = "Write a number within the bounds of the message.",
    .sources = "configmaps ConfigAtom.hpp:335-386 (run: -1 is read as 18446744073709551615)."};

constinit const Rule sml4004_missing_key{
    .id = "SML4004",
    .name = "missing-key",
    .severity = Severity::error,
    .summary = "An entry lacks a key without which it means nothing.",
    .why = "MARS reads an absent key as 0 or the empty text: a motor without joint drives joint 0, "
           "an entry without name matches nothing; Phobos stops with a KeyError.",
    .remedy = "Add the key.",
    .sources = "configmaps (run); MARS smurf.cpp:264; Phobos representation.py:2399."};

}  // namespace rules
}  // namespace smurf
