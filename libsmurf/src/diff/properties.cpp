// SPDX-License-Identifier: BSD-3-Clause
#include "diff/properties.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "diff/values.hpp"

namespace smurf {
namespace {

using Form = Property::Form;

Property leaf(std::string_view key, Form form, Span span) {
  Property property;
  property.key = key;
  property.form = form;
  property.span = span;
  return property;
}

/// The tolerance is absolute for lengths and angles, and for directions, scales and colours, which
/// have no unit. It is relative for all others.
bool is_absolute(const Property& property) {
  const std::string_view unit = property.unit;
  return unit == "m" || unit == "rad" || unit == "rad or m" || unit == "deg" ||
         (unit.empty() && property.form == Form::numbers);
}

/// Rotating a tensor causes rounding errors of this size.
constexpr double kNoise = 1e-14;

bool are_same_numbers(const Property& before, const Property& after, double tolerance) {
  if (before.numbers.size() != after.numbers.size()) return false;
  const bool is_tensor = !after.parts.empty();
  double largest = 0;
  if (is_tensor) {
    for (const double value : before.numbers) largest = std::max(largest, std::fabs(value));
  }
  for (std::size_t i = 0; i < before.numbers.size(); ++i) {
    const double a = before.numbers[i];
    const double b = after.numbers[i];
    const double scale = is_absolute(after) ? 1 : std::max(std::fabs(a), std::fabs(b));
    const double difference = std::fabs(a - b);
    if (!(difference <= std::max(tolerance * scale, kNoise * largest))) return false;
  }
  return true;
}

bool is_same_pose(const Pose& a, const Pose& b, double tolerance) {
  return hypotenuse(a.position[0] - b.position[0], a.position[1] - b.position[1],
                    a.position[2] - b.position[2]) <= tolerance &&
         angle_between(a.orientation, b.orientation) <= tolerance;
}

std::string summary_of_texts(const Property& property) {
  std::string text;
  for (const Spanned<std::string_view>& one : property.texts) {
    if (!text.empty()) text += ", ";
    text += one.value;
  }
  return text.empty() ? "empty" : text;
}

}  // namespace

Property number_property(std::string_view key, double value, Span span, std::string_view unit) {
  Property property = leaf(key, Form::number, span);
  property.numbers = {value};
  property.unit = unit;
  return property;
}

Property text_property(std::string_view key, std::string_view text, Span span) {
  Property property = leaf(key, Form::text, span);
  property.text = text;
  return property;
}

Property texts_property(std::string_view key, std::vector<Spanned<std::string_view>> texts,
                        Span span) {
  Property property = leaf(key, Form::texts, span);
  property.texts = std::move(texts);
  return property;
}

Property numbers_property(std::string_view key, std::vector<double> values, Span span,
                          std::string_view unit) {
  Property property = leaf(key, Form::numbers, span);
  property.numbers = std::move(values);
  property.unit = unit;
  return property;
}

Property pose_property(std::string_view key, const Pose& pose, Span span) {
  Property property = leaf(key, Form::pose, span);
  const Quaternion& q = pose.orientation;
  property.numbers = {pose.position[0], pose.position[1], pose.position[2], q.w, q.x, q.y, q.z};
  property.is_default = is_same_pose(pose, {}, 0);
  return property;
}

Property rotation_property(std::string_view key, const Quaternion& q, Span span) {
  Property property = leaf(key, Form::rotation, span);
  property.numbers = {q.w, q.x, q.y, q.z};
  return property;
}

Property group_property(std::string_view key, Span span) { return leaf(key, Form::group, span); }

void add_member(Property& group, Property member) {
  if (member.form == Form::absent) return;
  group.members.push_back(std::move(member));
}

Pose pose_of(const Property& property) {
  const std::vector<double>& n = property.numbers;
  return {{n[0], n[1], n[2]}, {n[3], n[4], n[5], n[6]}};
}

Quaternion rotation_of(const Property& property) {
  const std::vector<double>& n = property.numbers;
  return {n[0], n[1], n[2], n[3]};
}

DiffValue value_of(const Property& property, const NameAt& name_at) {
  const auto name = [&](std::string_view text, Span place) {
    return name_at ? name_at(text, place) : std::string(text);
  };
  switch (property.form) {
  case Form::absent: return {};
  case Form::boolean: return property.numbers[0] != 0;
  case Form::number: return property.numbers[0];
  case Form::text: return name(property.text, property.span);
  case Form::file: return property.text;
  case Form::numbers: return property.numbers;
  case Form::rotation: return rotation_of(property);
  case Form::pose: return pose_of(property);
  case Form::group:
  case Form::choice: return summary_of(property);
  case Form::texts:
  case Form::list: break;
  }
  std::vector<std::string> items;
  items.reserve(property.texts.size() + property.members.size());
  for (const Spanned<std::string_view>& one : property.texts) {
    items.push_back(name(one.value, one.span));
  }
  for (const Property& member : property.members) {
    const bool is_name = name_at && member.form == Form::text;
    items.push_back(is_name ? name(member.text, member.span) : summary_of(member));
  }
  return items;
}

std::string summary_of(const Property& property) {
  if (property.form == Form::texts) return summary_of_texts(property);
  if (!property.has_members()) return value_text(value_of(property), property.unit, property.parts);
  std::string text = property.form == Form::choice ? property.text : "";
  for (const Property& member : property.members) {
    if (member.is_default) continue;
    if (!text.empty()) text += property.form == Form::choice && text == property.text ? " " : ", ";
    if (property.form != Form::list) text += label_of(member.key) + " ";
    text += summary_of(member);
  }
  return text.empty() ? "empty" : text;
}

bool is_same_leaf(const Property& before, std::string_view text_before, const Property& after,
                  double tolerance) {
  if (before.form != after.form) return false;
  switch (after.form) {
  case Form::absent: return true;
  case Form::text: return text_before == after.text;
  case Form::boolean: return before.numbers == after.numbers;
  case Form::number:
  case Form::numbers: return are_same_numbers(before, after, tolerance);
  case Form::rotation: return angle_between(rotation_of(before), rotation_of(after)) <= tolerance;
  case Form::pose: return is_same_pose(pose_of(before), pose_of(after), tolerance);
  case Form::file: return before.text == after.text || before.path == after.path;
  case Form::texts:
  case Form::list:
  case Form::group:
  case Form::choice: break;
  }
  return false;
}

}  // namespace smurf
