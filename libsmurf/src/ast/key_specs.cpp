// SPDX-License-Identifier: BSD-3-Clause
// Queries on the rows of the key tables, for the reader, messages and schemas.
#include "ast/keys.hpp"

#include <cmath>
#include <limits>

namespace smurf {

Bounds bounds_of(const KeySpec& spec) {
  Bounds bounds{spec.minimum, spec.maximum};
  if (spec.type == ValueType::integer) {
    using Int = std::numeric_limits<std::int32_t>;
    if (!std::isfinite(bounds.minimum)) bounds.minimum = Int::min();
    if (!std::isfinite(bounds.maximum)) bounds.maximum = Int::max();
  }
  return bounds;
}

std::span<const std::string_view> components_of(ValueType type) {
  static constexpr std::string_view kXyz[] = {"x", "y", "z"};
  static constexpr std::string_view kOrientation[] = {"w", "x", "y", "z", "roll", "pitch", "yaw"};
  static constexpr std::string_view kRgba[] = {"r", "g", "b", "a"};
  switch (type) {
  case ValueType::vector2: return std::span(kXyz).first(2);
  case ValueType::vector3:
  case ValueType::position: return kXyz;
  case ValueType::quaternion:
  case ValueType::rotation: return std::span(kOrientation).first(4);
  case ValueType::orientation: return kOrientation;
  case ValueType::color: return kRgba;
  default: return {};
  }
}

const KeySpec* find_key(MoreKeys tables, std::string_view name) {
  for (const std::span<const KeySpec> table : tables) {
    for (const KeySpec& spec : table) {
      if (spec.name == name) return &spec;
    }
  }
  return nullptr;
}

/// The type of a quoted scalar without its quotes.
yaml::ScalarType type_without_quotes(yaml::View value) {
  return value.style() == yaml::Style::single_quoted || value.style() == yaml::Style::double_quoted
             ? yaml::classify(value.text(), yaml::Style::plain)
             : yaml::ScalarType::text;
}

Span within_quotes(yaml::View value) {
  const yaml::Node& own = value.document().nodes[static_cast<std::size_t>(value.id())];
  const bool is_quoted =
      own.style == yaml::Style::single_quoted || own.style == yaml::Style::double_quoted;
  const Span span = own.span;
  return is_quoted && !own.is_alias() ? Span{span.source, span.begin + 1, span.end - 1} : span;
}

std::optional<Span> within_quotes(Span scalar, std::string_view text) {
  const std::size_t around = scalar.end - scalar.begin - text.size();
  if (around == 0) return scalar;
  if (around == 2) return Span{scalar.source, scalar.begin + 1, scalar.end - 1};
  return std::nullopt;
}

std::string_view describe(ValueType type) {
  switch (type) {
  case ValueType::text:
  case ValueType::frame: return "a text";
  case ValueType::number: return "a number";
  case ValueType::integer: return "a whole number";
  case ValueType::boolean: return "true or false";
  case ValueType::names: return "a name or a list of names";
  case ValueType::name_list: return "a list of names";
  case ValueType::number_list: return "a list of numbers";
  case ValueType::number_map: return "a mapping from names to numbers";
  case ValueType::vector2: return "a mapping with `x`, `y`";
  case ValueType::vector3: return "a mapping with `x`, `y`, `z`";
  case ValueType::vector3_list: return "a list of three numbers";
  case ValueType::quaternion: return "a mapping with `w`, `x`, `y`, `z`";
  case ValueType::orientation:
    return "a mapping with `w`, `x`, `y`, `z` or with `roll`, `pitch`, `yaw`";
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
  if (type_without_quotes(value) != yaml::ScalarType::text) {
    return "`" + text + "`, which is quoted and therefore text";
  }
  return (value.type() == yaml::ScalarType::text ? "the text `" : "`") + text + "`";
}

}  // namespace smurf
