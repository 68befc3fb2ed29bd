// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/reading.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <system_error>

#include "base/numbers/floating.hpp"

namespace smurf::sdformat {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr double kDegree = 3.14159265358979323846 / 180;

std::string lower_case(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return result;
}

/// Reads the number at the start of the text, and removes it from the text.
std::optional<double> take_number(std::string_view& text) {
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  std::string_view rest = text;
  const bool is_negative = rest.starts_with('-');
  if (is_negative || rest.starts_with('+')) rest.remove_prefix(1);
  const double sign = is_negative ? -1 : 1;
  const std::string word = lower_case(rest.substr(0, 8));
  double value = 0;
  if (word.starts_with("inf")) {
    rest.remove_prefix(word.starts_with("infinity") ? 8 : 3);
    value = std::numeric_limits<double>::infinity();
  } else if (word.starts_with("nan")) {
    rest.remove_prefix(3);
    value = std::numeric_limits<double>::quiet_NaN();
  } else {
    constexpr std::string_view kDigits = "0123456789abcdef.";
    const bool is_hexadecimal = word.size() > 2 && word.starts_with("0x") &&
                                kDigits.find(word[2]) != std::string_view::npos;
    if (is_hexadecimal) rest.remove_prefix(2);
    if (rest.starts_with('-') || rest.starts_with('+')) return std::nullopt;
    const auto result = is_hexadecimal ? read_hexadecimal(rest, value) : read_floating(rest, value);
    if (result.ptr == rest.data()) return std::nullopt;
    const auto size = static_cast<std::size_t>(result.ptr - rest.data());
    // As strtod(): 1e999 is infinite, 1e-999 is zero.
    if (result.ec != std::errc() && word.find("e-") == std::string::npos)
      value = std::numeric_limits<double>::infinity();
    rest.remove_prefix(size);
  }
  text = rest;
  return sign * value;
}

/// The number at the beginning of each word; none if one has none, or if it is not finite.
std::optional<std::vector<double>> numbers_of_words(std::string_view rest) {
  std::vector<double> numbers;
  while (true) {
    rest.remove_prefix(std::min(rest.find_first_not_of(kBlanks), rest.size()));
    if (rest.empty()) return numbers;
    const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
    std::string_view word = rest.substr(0, end);
    const auto number = take_number(word);
    if (!number || !std::isfinite(*number) || numbers.size() > 8) return std::nullopt;
    numbers.push_back(*number);
    rest.remove_prefix(end);
  }
}

}  // namespace

std::string_view text_of(View element) {
  if (!element) return {};
  std::string_view text = element.text();
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  return text.substr(0, text.find_last_not_of(kBlanks) + 1);
}

std::string_view text_in(View element, std::string_view child) {
  return text_of(element.child(child));
}

std::optional<double> leading_number(std::string_view text) { return take_number(text); }

std::vector<double> leading_numbers(std::string_view text, std::size_t most) {
  std::vector<double> numbers;
  while (numbers.size() < most) {
    const auto number = take_number(text);
    if (!number) break;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<bool> truth_in(std::string_view text) {
  const std::string word = lower_case(text);
  if (word == "1" || word == "true") return true;
  if (word == "0" || word == "false") return false;
  return std::nullopt;
}

double number_in(View element, std::string_view child, double usual) {
  const View found = element ? element.child(child) : View();
  return found ? leading_number(text_of(found)).value_or(usual) : usual;
}

bool truth_in(View element, std::string_view child, bool usual) {
  const View found = element ? element.child(child) : View();
  return found ? truth_in(text_of(found)).value_or(usual) : usual;
}

Vector3 vector_in(View element, std::string_view child, const Vector3& usual) {
  const View found = element ? element.child(child) : View();
  const auto numbers = found ? leading_numbers(text_of(found), 3) : std::vector<double>();
  return numbers.size() == 3 ? Vector3{numbers[0], numbers[1], numbers[2]} : usual;
}

std::optional<std::array<double, 4>> colour_in(std::string_view text) {
  const auto numbers = numbers_of_words(text);
  if (!numbers || numbers->size() < 3 || numbers->size() > 4) return std::nullopt;
  if (std::any_of(numbers->begin(), numbers->end(), [](double one) { return one < 0; }))
    return std::nullopt;
  return std::array<double, 4>{(*numbers)[0], (*numbers)[1], (*numbers)[2],
                               numbers->size() == 4 ? (*numbers)[3] : 1};
}

std::optional<Pose> pose_in(View pose) {
  const std::string_view text = text_of(pose);
  if (text.empty()) return Pose{};
  const std::string_view format = attribute_of(pose, "rotation_format");
  const bool is_quaternion = format == "quat_xyzw";
  if (!format.empty() && !is_quaternion && format != "euler_rpy") return std::nullopt;
  const bool is_degree = truth_in(attribute_of(pose, "degrees")).value_or(false);
  if (is_degree && is_quaternion) return std::nullopt;
  const auto written = numbers_of_words(text);
  if (!written) return std::nullopt;
  const std::vector<double>& numbers = *written;
  if (numbers.size() != (is_quaternion ? 7U : 6U)) return std::nullopt;
  Pose result{{numbers[0], numbers[1], numbers[2]}, {}};
  if (is_quaternion) {
    const Quaternion q{numbers[6], numbers[3], numbers[4], numbers[5]};
    if (norm(q) > 0) result.orientation = normalized(q);
  } else {
    const double unit = is_degree ? kDegree : 1;
    result.orientation = from_rpy({numbers[3] * unit, numbers[4] * unit, numbers[5] * unit});
  }
  return result;
}

Place tag_of(View element, xacro::FrameId frame) {
  return {element.name_span(), element.tag_span(), frame};
}

Place place_of(View element, xacro::FrameId frame) {
  const Span text = text_of(element).empty() ? element.name_span() : element.text_span();
  return {text, element.tag_span(), frame};
}

Place place_in(View element, std::string_view child, xacro::FrameId frame) {
  const View found = element ? element.child(child) : View();
  return found ? place_of(found, frame) : tag_of(element, frame);
}

}  // namespace smurf::sdformat
