// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/reading.hpp"

#include <algorithm>

namespace smurf::sdformat {
namespace {

constexpr std::string_view kBlanks = " \t\r\n\v\f";
constexpr double kDegree = 3.14159265358979323846 / 180;

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

double number_in(View element, std::string_view child, double usual) {
  const View found = element ? element.child(child) : View();
  return found ? sdf::read_scalar('d', text_of(found)).value_or(usual) : usual;
}

bool truth_in(View element, std::string_view child, bool usual) {
  const View found = element ? element.child(child) : View();
  return found ? sdf::read_flag(text_of(found)).value_or(usual) : usual;
}

Vector3 vector_in(View element, std::string_view child, const Vector3& usual) {
  const View found = element ? element.child(child) : View();
  return found ? sdf::read_vector(text_of(found)).value_or(usual) : usual;
}

std::optional<std::array<double, 4>> colour_in(std::string_view text) {
  const auto numbers = sdf::read_color(text);
  if (!numbers) return std::nullopt;
  return std::array<double, 4>{(*numbers)[0], (*numbers)[1], (*numbers)[2],
                               numbers->size() == 4 ? (*numbers)[3] : 1};
}

std::optional<Pose> pose_in(View pose) {
  const std::string_view text = text_of(pose);
  if (text.empty()) return Pose{};
  const std::string_view format = attribute_of(pose, "rotation_format");
  const bool is_quaternion = format == "quat_xyzw";
  if (!format.empty() && !is_quaternion && format != "euler_rpy") return std::nullopt;
  const bool is_degree = sdf::read_flag(attribute_of(pose, "degrees")).value_or(false);
  if (is_degree && is_quaternion) return std::nullopt;
  const auto written = sdf::read_pose(text, is_quaternion);
  if (!written) return std::nullopt;
  const std::vector<double>& numbers = *written;
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

bool is_plain_pose(std::string_view text) { return sdf::read_pose(text, false).has_value(); }

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
