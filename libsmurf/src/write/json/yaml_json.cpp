// SPDX-License-Identifier: BSD-3-Clause
// Values are read by the functions of the key rows, so that they equal those of a model.
#include "write/json/yaml_json.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace smurf {
namespace {

class TypedPrinter {
 public:
  explicit TypedPrinter(JsonPrinter& json) : json_(json) {}

  void print_mapping(yaml::View mapping, std::span<const KeySpec* const> keys) {
    json_.begin_object();
    for (const yaml::View value : mapping) {
      if (value.is_repeated()) continue;
      const auto row = std::find_if(keys.begin(), keys.end(),
                                    [&](const KeySpec* spec) { return spec->name == value.key(); });
      if (row == keys.end()) {
        json_.key(value.key());
        print_untyped(json_, value);
      } else {
        print_member(**row, value);
      }
    }
    json_.end();
  }

 private:
  /// Writes the value with its key, if it is readable.
  void print_member(const KeySpec& spec, yaml::View value) {
    if (value.is_null()) return;
    switch (spec.type) {
    case ValueType::text:
    case ValueType::frame:
      return print<std::string>(spec, value, [&](const std::string& text) { json_.text(text); });
    case ValueType::number:
      return print<double>(spec, value, [&](double number) { json_.number(number); });
    case ValueType::integer:
      return print<std::int64_t>(spec, value, [&](std::int64_t whole) { json_.integer(whole); });
    case ValueType::boolean:
      return print<bool>(spec, value, [&](bool boolean) { json_.boolean(boolean); });
    case ValueType::names:
    case ValueType::name_list:
      return print<NameList>(spec, value, [&](const NameList& names) {
        json_.begin_list();
        for (const Spanned<std::string>& name : names) json_.text(name.value);
        json_.end();
      });
    case ValueType::vector3:
    case ValueType::vector3_list:
    case ValueType::position:
      return print<Vector3>(spec, value, [&](const Vector3& vector) { json_.vector(vector); });
    case ValueType::color:
      return print<Color>(spec, value, [&](const Color& color) { print_color(color); });
    case ValueType::mapping:
      if (!value.is_mapping()) return;
      json_.key(spec.name);
      return print_members(spec, value);
    case ValueType::list:
      if (!value.is_sequence()) return;
      json_.key(spec.name);
      json_.begin_list();
      for (const yaml::View item : value) print_members(spec, item);
      return json_.end();
    case ValueType::number_list:
    case ValueType::number_map:
    case ValueType::vector2:
    case ValueType::quaternion:
    case ValueType::orientation:
    case ValueType::rotation: return print_numbers(spec, value);
    case ValueType::any: break;
    }
    json_.key(spec.name);
    print_untyped(json_, value);
  }

  template <class T, class Print>
  void print(const KeySpec& spec, yaml::View value, const Print& print_value) {
    DiagnosticSink already_reported(0, 0);
    Field<T> field;
    read_value(spec, value, &field, already_reported);
    if (!field) return;
    json_.key(spec.name);
    print_value(*field);
  }

  void print_color(const Color& color) {
    json_.begin_object();
    for (const auto& [name, part] : {std::pair("r", &color.r), std::pair("g", &color.g),
                                     std::pair("b", &color.b), std::pair("a", &color.a)}) {
      if (!*part) continue;
      json_.key(name);
      json_.number(**part);
    }
    json_.end();
  }

  void print_members(const KeySpec& spec, yaml::View value) {
    if (!value.is_mapping() || spec.members.size == 0) return print_untyped(json_, value);
    std::vector<const KeySpec*> members;
    for (const KeySpec& member : spec.members.keys()) members.push_back(&member);
    print_mapping(value, members);
  }

  static bool is_finite_number(yaml::View value) {
    const std::optional<double> number = value.number();
    return number && std::isfinite(*number);
  }

  /// A number, or a list or mapping of numbers. A list must be complete; from a mapping, readable
  /// numbers are written.
  void print_numbers(const KeySpec& spec, yaml::View value) {
    const bool is_mapping = value.is_mapping();
    const bool is_whole =
        value.is_scalar() ? is_finite_number(value)
                          : is_mapping || std::all_of(value.begin(), value.end(), is_finite_number);
    if (!is_whole) return;
    json_.key(spec.name);
    if (!is_mapping) return print_untyped(json_, value);
    json_.begin_object();
    for (const yaml::View member : value) {
      if (member.is_repeated() || !is_finite_number(member)) continue;
      json_.key(member.key());
      json_.number(*member.number());
    }
    json_.end();
  }

  JsonPrinter& json_;
};

void print_scalar(JsonPrinter& json, yaml::View value) {
  switch (value.type()) {
  case yaml::ScalarType::null: return json.null();
  case yaml::ScalarType::boolean:
    if (const auto boolean = value.boolean()) return json.boolean(*boolean);
    break;
  case yaml::ScalarType::integer:
  case yaml::ScalarType::number:
    if (const auto integer = value.integer()) return json.integer(*integer);
    if (const auto number = value.number(); number && std::isfinite(*number)) {
      return json.number(*number);
    }
    break;
  case yaml::ScalarType::text: break;
  }
  json.text(value.text());
}

}  // namespace

void print_untyped(JsonPrinter& json, yaml::View value) {
  if (json.is_full()) return;
  switch (value.kind()) {
  case yaml::Kind::null: return json.null();
  case yaml::Kind::scalar: return print_scalar(json, value);
  case yaml::Kind::mapping:
    json.begin_object();
    for (const yaml::View member : value) {
      if (member.is_repeated()) continue;
      json.key(member.key());
      print_untyped(json, member);
    }
    return json.end();
  case yaml::Kind::sequence: break;
  }
  json.begin_list();
  for (const yaml::View item : value) print_untyped(json, item);
  json.end();
}

void print_typed(JsonPrinter& json, yaml::View mapping, std::span<const KeySpec* const> keys) {
  TypedPrinter(json).print_mapping(mapping, keys);
}

}  // namespace smurf
