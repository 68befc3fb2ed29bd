// SPDX-License-Identifier: BSD-3-Clause
#include "diff/yaml_properties.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

using enum ValueType;

std::optional<double> finite(yaml::View value) {
  const std::optional<double> number = value.number();
  return number && std::isfinite(*number) ? number : std::nullopt;
}

bool are_all_numbers(yaml::View value) {
  return value.size() > 0 && std::all_of(value.begin(), value.end(), finite);
}

std::vector<double> numbers_in(yaml::View value) {
  std::vector<double> numbers;
  for (const yaml::View item : value) numbers.push_back(*finite(item));
  return numbers;
}

/// The type of scalars without a row: text, not numbers or booleans.
bool are_all_texts(yaml::View value) {
  return value.size() > 0 && std::all_of(value.begin(), value.end(), [](yaml::View item) {
           return item.is_scalar() && !finite(item) && !item.boolean();
         });
}

std::optional<bool> boolean_of(yaml::View value) {
  if (const auto number = value.number(); number && (*number == 0 || *number == 1)) {
    return *number == 1;
  }
  return value.boolean();
}

Property boolean_property(std::string_view key, bool value, Span span) {
  Property property = number_property(key, value ? 1 : 0, span);
  property.form = Property::Form::boolean;
  return property;
}

std::vector<const KeySpec*> rows_of(KeyTable table) {
  std::vector<const KeySpec*> rows;
  for (const KeySpec& row : table.keys()) rows.push_back(&row);
  return rows;
}

/// The key by which the items of a list are paired.
std::string_view name_in(yaml::View item) {
  if (!item.is_mapping()) return {};
  const yaml::View name = item.find("name");
  return name && name.is_scalar() ? name.text() : std::string_view();
}

bool is_list_of_numbers(ValueType type) {
  return type == number_list || type == vector3_list || type == position;
}

bool has_components(ValueType type) {
  return type == vector2 || type == vector3 || type == quaternion || type == position;
}

}  // namespace

Property YamlProperties::mapping(std::string_view key, yaml::View value, Rows rows,
                                 bool (*is_wanted)(std::string_view key)) {
  Property group = group_property(key, value.span());
  for (const yaml::View member : value) {
    if (member.is_repeated() || member.is_null()) continue;
    if (is_wanted != nullptr && !is_wanted(member.key())) continue;
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const KeySpec* one) { return one->name == member.key(); });
    Property property = this->value(member.key(), member, row == rows.end() ? nullptr : *row);
    property.key_span = member.key_span();
    add_member(group, std::move(property));
  }
  return group;
}

Property YamlProperties::value(std::string_view key, yaml::View value, const KeySpec* row) {
  if (value.is_null()) return {};
  if (row == nullptr) return untyped(key, value);
  Property property = typed(*row, value);
  property.unit = row->unit;
  if (row->fallback.empty()) return property;
  property.fallback = row->fallback;
  const Property& fallback = fallback_of(*row);
  property.is_default = is_same_leaf(fallback, fallback.text, property, 0);
  return property;
}

/// A value of the wrong type is compared as it is written.
Property YamlProperties::typed(const KeySpec& row, yaml::View value) {
  const Span span = value.place();
  const bool is_text = row.type == text || row.type == frame || row.type == names;
  if (value.is_scalar() && row.type == names) {
    return texts_property(row.name, {{value.text(), span}}, span);
  }
  if (value.is_scalar() && is_text) return text_property(row.name, value.text(), span);
  if (value.is_scalar() && row.type == boolean) {
    if (const auto known = boolean_of(value)) return boolean_property(row.name, *known, span);
  }
  if (value.is_sequence() && (row.type == names || row.type == name_list)) {
    return list_of_names(row.name, value);
  }
  if (value.is_sequence() && is_list_of_numbers(row.type) && are_all_numbers(value)) {
    return numbers_property(row.name, numbers_in(value), span);
  }
  if (value.is_mapping() && has_components(row.type)) return components(row, value);
  if (value.is_mapping()) return mapping(row.name, value, rows_of(row.members));
  if (value.is_sequence()) return list(row.name, value, row.members);
  return untyped(row.name, value);
}

Property YamlProperties::list_of_names(std::string_view key, yaml::View value) {
  if (std::all_of(value.begin(), value.end(), [](yaml::View item) { return item.is_scalar(); })) {
    std::vector<Spanned<std::string_view>> texts;
    texts.reserve(value.size());
    for (const yaml::View item : value) texts.push_back({item.text(), item.span()});
    return texts_property(key, std::move(texts), value.place());
  }
  Property list = group_property(key, value.place());
  list.form = Property::Form::list;
  for (const yaml::View item : value) {
    list.members.push_back(item.is_scalar() ? text_property({}, item.text(), item.span())
                                            : untyped({}, item));
  }
  return list;
}

/// MARS reads absent components as 0.
Property YamlProperties::components(const KeySpec& row, yaml::View value) {
  const std::span<const std::string_view> names = components_of(row.type);
  std::vector<double> numbers(names.size());
  for (const yaml::View member : value) {
    const auto name = std::find(names.begin(), names.end(), member.key());
    const auto number = finite(member);
    if (name == names.end() || !number) return untyped(row.name, value);
    if (!member.is_repeated()) numbers[static_cast<std::size_t>(name - names.begin())] = *number;
  }
  if (row.type != quaternion) return numbers_property(row.name, std::move(numbers), value.place());
  const Quaternion rotation{numbers[0], numbers[1], numbers[2], numbers[3]};
  const double length = norm(rotation);
  if (!(length > 0) || !std::isfinite(length)) return untyped(row.name, value);
  return rotation_property(row.name, normalized(rotation), value.place());
}

Property YamlProperties::list(std::string_view key, yaml::View value, KeyTable members) {
  Property list = group_property(key, value.place());
  list.form = Property::Form::list;
  list.members.reserve(value.size());
  const std::vector<const KeySpec*> rows = rows_of(members);
  for (const yaml::View item : value) {
    Property property = item.is_mapping() ? mapping({}, item, rows) : untyped({}, item);
    property.key = name_in(item);
    list.members.push_back(std::move(property));
  }
  return list;
}

Property YamlProperties::untyped(std::string_view key, yaml::View value) {
  const Span span = value.place();
  switch (value.kind()) {
  case yaml::Kind::null: break;
  case yaml::Kind::mapping: return mapping(key, value, {});
  case yaml::Kind::sequence:
    if (are_all_numbers(value)) return numbers_property(key, numbers_in(value), span);
    return are_all_texts(value) ? list_of_names(key, value) : list(key, value, {});
  case yaml::Kind::scalar:
    if (const auto number = finite(value)) return number_property(key, *number, span);
    if (const auto known = value.boolean()) return boolean_property(key, *known, span);
    return text_property(key, value.text(), span);
  }
  Property none;
  none.key = key;
  none.span = span;
  return none;
}

/// The table has defaults as JSON, which YAML contains.
const Property& YamlProperties::fallback_of(const KeySpec& row) {
  const auto [place, is_new] = fallbacks_.try_emplace(&row);
  if (!is_new) return place->second.value;
  auto& [sources, document, fallback] = place->second;
  DiagnosticSink ignored(0, 0);
  const SourceId id = sources.add("", std::string(row.fallback));
  document = parse_yaml(sources, id, {}, ignored);
  if (document && document->view()) fallback = typed(row, document->view());
  fallback.unit = row.unit;
  return fallback;
}

}  // namespace smurf
