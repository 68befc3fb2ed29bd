// SPDX-License-Identifier: BSD-3-Clause
#include "diff/values.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/lists.hpp"
#include "link/describe.hpp"

namespace smurf {
namespace {

std::string with_unit(std::string text, std::string_view unit) {
  if (!unit.empty()) text.append(" ").append(unit);
  return text;
}

/// Nine digits are enough for robots. If two numbers then look the same, all digits are shown.
std::string short_number(double value) { return format_rounded(value, 9); }

std::string numbers_text(std::span<const double> values, std::string (*show)(double)) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : " ") + show(value);
  return text;
}

ValueTexts pair_of(std::span<const double> before, std::span<const double> after) {
  ValueTexts pair{numbers_text(before, short_number), numbers_text(after, short_number)};
  if (pair.before == pair.after) {
    pair = {numbers_text(before, format_number), numbers_text(after, format_number)};
  }
  return pair;
}

std::string arrow(const ValueTexts& pair) { return pair.before + " -> " + pair.after; }

std::string numbers_change(const std::vector<double>& before, const std::vector<double>& after,
                           const Difference& difference) {
  if (difference.parts.size() != before.size() || before.size() != after.size()) {
    return with_unit(arrow(pair_of(before, after)), difference.unit);
  }
  std::string text;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (before[i] == after[i]) continue;
    const ValueTexts pair = pair_of(std::span(&before[i], 1), std::span(&after[i], 1));
    text += (text.empty() ? "" : ", ") + std::string(difference.parts[i]) + " " + arrow(pair);
  }
  return with_unit(std::move(text), difference.unit);
}

std::string number_change(double before, double after, const Difference& difference) {
  std::string text = with_unit(arrow(pair_of({&before, 1}, {&after, 1})), difference.unit);
  const std::string percentage = percentage_of(difference);
  return percentage.empty() ? text : text + " (" + percentage + ")";
}

std::string pose_change(const Pose& before, const Pose& after) {
  double distance = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    distance = hypotenuse(distance, before.position[i] - after.position[i]);
  }
  std::string text;
  if (distance > 0) text = "xyz " + arrow(pair_of(before.position, after.position)) + " m";
  const double angle = angle_between(before.orientation, after.orientation);
  if (angle > 0) {
    text += (text.empty() ? "" : ", ") + std::string("rpy ") +
            arrow(pair_of(to_rpy(before.orientation), to_rpy(after.orientation))) + " rad";
  }
  return text;
}

/// The default of readers for an absent value.
std::string absent_text(const Difference& difference) {
  if (difference.fallback.empty()) return "none";
  return std::string(difference.fallback) + " (default)";
}

std::string text_of(const DiffValue& value, std::string_view unit,
                    std::span<const std::string_view> parts, std::string (*show)(double)) {
  if (const auto* boolean = std::get_if<bool>(&value)) return *boolean ? "true" : "false";
  if (const auto* number = std::get_if<double>(&value)) return with_unit(show(*number), unit);
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* pose = std::get_if<Pose>(&value)) {
    return "xyz " + numbers_text(pose->position, show) + " m rpy " +
           numbers_text(to_rpy(pose->orientation), show) + " rad";
  }
  if (const auto* rotation = std::get_if<Quaternion>(&value)) {
    return "rpy " + numbers_text(to_rpy(*rotation), show) + " rad";
  }
  if (const auto* numbers = std::get_if<std::vector<double>>(&value)) {
    if (parts.size() != numbers->size()) return with_unit(numbers_text(*numbers, show), unit);
    std::string text;
    for (std::size_t i = 0; i < numbers->size(); ++i) {
      if ((*numbers)[i] == 0) continue;
      text += (text.empty() ? "" : " ") + std::string(parts[i]) + " " + show((*numbers)[i]);
    }
    return text.empty() ? "0" : with_unit(std::move(text), unit);
  }
  if (const auto* items = std::get_if<std::vector<std::string>>(&value)) {
    return "[" + listed(*items) + "]";
  }
  return "none";
}

/// A value of a difference; for an absent value, the default of readers.
std::string text_in(const Difference& difference, const DiffValue& value,
                    std::string (*show)(double)) {
  if (std::holds_alternative<std::monostate>(value)) return absent_text(difference);
  return text_of(value, difference.unit, difference.parts, show);
}

}  // namespace

std::string label_of(std::string_view property) {
  constexpr std::string_view kLimit = "limit.";
  constexpr std::string_view kPlain[] = {"inertial.", "dynamics.", "material.name"};
  if (property.starts_with(kLimit)) return std::string(property.substr(kLimit.size())) + " limit";
  if (property == kPlain[2]) return "material";
  for (const std::string_view plain : kPlain) {
    if (property.starts_with(plain)) property.remove_prefix(plain.size());
  }
  if (property == "center_of_mass") return "center of mass";
  std::string label(property);
  std::replace(label.begin(), label.end(), '.', ' ');
  return label;
}

std::string value_text(const DiffValue& value, std::string_view unit,
                       std::span<const std::string_view> parts) {
  return text_of(value, unit, parts, short_number);
}

ValueTexts value_texts(const Difference& difference) {
  const auto shown_by = [&](std::string (*show)(double)) -> ValueTexts {
    return {text_in(difference, difference.before, show),
            text_in(difference, difference.after, show)};
  };
  ValueTexts texts = shown_by(short_number);
  return texts.before == texts.after ? shown_by(format_number) : texts;
}

std::string percentage_of(const Difference& difference) {
  const auto* before = std::get_if<double>(&difference.before);
  const auto* after = std::get_if<double>(&difference.after);
  if (before == nullptr || after == nullptr) return {};
  const double percent = 100 * (*after - *before) / std::fabs(*before);
  const bool is_moderate = std::fabs(percent) < 1000;  // false for NaN
  if (!is_moderate) return {};
  return (percent > 0 ? "+" : "") + format_rounded(percent, 3) + " %";
}

std::string change_text(const Difference& difference) {
  const DiffValue& before = difference.before;
  const DiffValue& after = difference.after;
  if (before.index() == after.index()) {
    if (const auto* number = std::get_if<double>(&before)) {
      return number_change(*number, std::get<double>(after), difference);
    }
    if (const auto* numbers = std::get_if<std::vector<double>>(&before)) {
      return numbers_change(*numbers, std::get<std::vector<double>>(after), difference);
    }
    if (const auto* pose = std::get_if<Pose>(&before)) {
      return pose_change(*pose, std::get<Pose>(after));
    }
    if (const auto* rotation = std::get_if<Quaternion>(&before)) {
      return pose_change({{}, *rotation}, {{}, std::get<Quaternion>(after)});
    }
  }
  return text_in(difference, before, short_number) + " -> " +
         text_in(difference, after, short_number);
}

}  // namespace smurf
