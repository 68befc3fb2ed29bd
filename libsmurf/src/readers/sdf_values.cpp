// SPDX-License-Identifier: BSD-3-Clause
// Sources: sdformat 12.3.0 src/Param.cc:380-780.
#include "readers/sdf_values.hpp"

#include <optional>

namespace smurf::sdf {
namespace {

std::string_view attribute_of(xml::View element, std::string_view name) {
  const xml::Attribute* attribute = element.attribute(name);
  return attribute == nullptr ? std::string_view() : trimmed_text(attribute->value());
}

bool is_pose(std::string_view text, xml::View element) {
  const std::string_view format = attribute_of(element, "rotation_format");
  const bool is_quaternion = format == "quat_xyzw";
  if (!is_quaternion && !format.empty() && format != "euler_rpy") return false;
  if (is_quaternion && read_flag(attribute_of(element, "degrees")).value_or(false)) return false;
  return text.empty() || read_pose(text, is_quaternion);
}

}  // namespace

std::string_view given_value(xml::View element) {
  const xml::Attribute* value = element.attribute("value");
  return value != nullptr ? value->value() : element.text();
}

std::string_view trimmed_text(std::string_view text) {
  constexpr std::string_view kTrimmed = " \t\n";
  const std::size_t begin = text.find_first_not_of(kTrimmed);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kTrimmed) - begin + 1);
}

bool is_readable(const Part& part, std::string_view text, xml::View element) {
  text = trimmed_text(text);
  if (part.value == 'p') return is_pose(text, element);
  if (text.empty()) return !part.is_required;
  switch (part.value) {
  case 'b': return read_flag(text).has_value();
  case 'c': return read_color(text).has_value();
  case '2': return streamed_numbers(text, 2).size() == 2;
  case '3': return read_vector(text).has_value();
  case 's': return true;
  default: break;
  }
  const std::optional<double> number = read_scalar(part.value, text);
  return number && is_within(*number, part.range);
}

std::string_view wanted(const Part& part) {
  switch (part.value) {
  case 'p': return "six numbers: x y z in m, roll pitch yaw in rad";
  case 'b': return "`true` or `false`";
  case 'c': return "four numbers from 0 to 1: red green blue alpha";
  case '2': return "two numbers";
  case '3': return "three numbers";
  case 's': return "a text";
  case 'i': return "an integer";
  case 'u': return "an integer of at least 0";
  default: return part.range.empty() ? "a number" : "a number in the range that SDF allows";
  }
}

}  // namespace smurf::sdf
