// SPDX-License-Identifier: BSD-3-Clause
#include "lint/angle_queries.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

/// "0 0 0" and similar texts, which are the most frequent.
bool is_plainly_zero(std::string_view numbers) {
  return std::all_of(numbers.begin(), numbers.end(),
                     [](char c) { return c == '0' || c == '.' || c == ' '; });
}

}  // namespace

bool looks_like_degrees(double angle) {
  constexpr double kTwoTurns = 4 * std::numbers::pi;
  constexpr double kPlaceholder = 1000;
  return std::fabs(angle) > kTwoTurns && std::fabs(angle) < kPlaceholder;
}

std::vector<WrittenNumber> written_numbers(const xml::Attribute& attribute) {
  const std::string_view value = attribute.value();
  const Span whole = attribute.value_span();
  if (whole.end - whole.begin != value.size()) return {};  // entities were decoded
  std::vector<WrittenNumber> numbers;
  numbers.reserve(3);
  std::size_t at = 0;
  for (std::string_view word = next_word(value, at); !word.empty(); word = next_word(value, at)) {
    const auto number = parse_number(word);
    if (!number) return {};
    const std::uint32_t end = whole.begin + static_cast<std::uint32_t>(at);
    numbers.push_back(
        {word, *number, {whole.source, end - static_cast<std::uint32_t>(word.size()), end}});
  }
  return numbers;
}

void for_each_turn(const urdf::Robot& robot,
                   const std::function<void(const xml::Attribute&)>& visit) {
  for (const xml::Attribute& attribute : robot.document.attributes) {
    if (is_same(attribute.name(), "rpy") && !is_plainly_zero(attribute.value())) visit(attribute);
  }
}

std::optional<double> intended_right_angle(const WrittenNumber& angle) {
  constexpr double kExact = 1e-6;  // rad
  constexpr double kRightAngle = std::numbers::pi / 2;
  const std::size_t point = angle.text.find('.');
  if (point == std::string_view::npos || angle.text.find_first_of("eE") != std::string_view::npos) {
    return std::nullopt;
  }
  const std::size_t decimals = angle.text.size() - point - 1;
  const double turns = std::round(angle.value / kRightAngle);
  if (decimals < 2 || turns == 0 || std::fabs(turns) > 4) return std::nullopt;
  const double intended = turns * kRightAngle;
  const double error = std::fabs(angle.value - intended);
  // The error of a truncated number is below one unit of the last decimal; of a rounded number,
  // below half a unit.
  if (error <= kExact || error >= std::pow(10.0, -static_cast<double>(decimals))) {
    return std::nullopt;
  }
  return intended;
}

std::optional<double> degrees_of_radians(double number) {
  constexpr double kAngles[] = {30, 45, 60, 90, 120, 135, 150, 180, 270, 360};
  constexpr double kRelativeTolerance = 1.2e-3;  // the error of pi with three digits
  for (const double degrees : kAngles) {
    const double radians = degrees * std::numbers::pi / 180;
    if (std::fabs(std::fabs(number) - radians) > kRelativeTolerance * radians) continue;
    return std::copysign(degrees, number);
  }
  return std::nullopt;
}

bool is_rpy_snapped(const std::vector<WrittenNumber>& rpy) {
  constexpr double kSnapped = 4.47e-3;  // rad; acos of 0.99999, rounded down
  constexpr double kVisible = 1e-4;     // rad; 0.1 mm at the end of a metre
  const double off = std::fabs(std::fabs(rpy[1].value) - std::numbers::pi / 2);
  return off > kVisible && off < kSnapped;
}

}  // namespace smurf
