// SPDX-License-Identifier: BSD-3-Clause
#include "lint/annotation_queries.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "ast/notation.hpp"
#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"

namespace smurf {

yaml::View mapping_of(const LinkedModel& model, const Annotation& entry) {
  const yaml::Document* document = model.document(entry.span.source);
  return document == nullptr ? yaml::View() : yaml::View(*document, entry.node);
}

std::optional<double> number_at(yaml::View mapping, std::string_view key) {
  const yaml::View value = mapping ? mapping.find(key) : yaml::View();
  const std::optional<double> number = value ? value.number() : std::nullopt;
  return number && std::isfinite(*number) ? number : std::nullopt;
}

std::optional<Spanned<std::string>> text_at(yaml::View mapping, std::string_view key) {
  const yaml::View value = mapping ? mapping.find(key) : yaml::View();
  if (!value || !value.is_scalar()) return std::nullopt;
  return Spanned<std::string>{std::string(value.text()), value.span()};
}

bool has_misspelt(yaml::View mapping, std::string_view key) {
  const std::string_view known[] = {key};
  return std::any_of(mapping.begin(), mapping.end(),
                     [&](yaml::View member) { return nearest(member.key(), known).has_value(); });
}

bool is_slip(yaml::View mapping, std::string_view key, Findings& findings) {
  const std::string_view known[] = {key};
  bool is_found = false;
  for (const yaml::View member : mapping) {
    if (!nearest(member.key(), known)) continue;
    findings.add_consequence(member.key_span());
    is_found = true;
  }
  return is_found;
}

/// Whether PyYAML reads a number of the core schema as a text.
bool is_text_by_yaml11(std::string_view number) { return number_by_yaml11(number) == "a text"; }

void report_name_read_as_value(yaml::View entry, Findings& findings) {
  const yaml::View name = entry.is_mapping() ? entry.find("name") : yaml::View();
  if (!name || !name.is_scalar() || name.style() != yaml::Style::plain) return;
  const bool is_number = name.number() && !is_text_by_yaml11(name.text());
  if (!is_number && !name.boolean()) return;
  findings
      .report(name.span(), "Phobos reads " + quoted(name.text()) + " as something other than text")
      .help("put it in quotes");
}

void report_number_keys(yaml::View entry, Findings& findings) {
  if (!entry.is_mapping()) return;
  for (const yaml::View member : entry) {
    const Span place = member.key_span();
    const bool is_plain = place.end - place.begin == member.key().size();
    if (!is_plain || !parse_number(member.key()) || is_text_by_yaml11(member.key())) continue;
    findings.report(place, "Phobos accepts no number as a key").help("put it in quotes");
  }
}

std::vector<TopLevelKey> top_level_keys(const LinkedModel& model) {
  std::vector<TopLevelKey> keys;
  for (const ModelFile& file : model.files) {
    if (!file.document) continue;
    const yaml::View root = file.document->view();
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View value : root) {
      if (!value.is_repeated()) keys.push_back({file, value});
    }
  }
  return keys;
}

Span place_in_files(const LinkedModel& model, SourceId source) {
  if (!model.is_complete || !model.main.files) return {};
  std::size_t index = 0;  // number of the file in `files` of the model; the main file is the first
  std::set<std::string> read;
  for (const Spanned<std::string>& entry : *model.main.files) {
    const std::string extension = path::to_lower(path::extension(entry.value));
    const bool is_read =
        extension == ".urdf" || extension == ".yml" || extension == ".yaml" || extension == ".json";
    if (!is_read || !read.insert(path::normalize(entry.value)).second) continue;
    if (++index >= model.files.size()) return {};
    if (model.files[index].source == source) return entry.span;
  }
  return {};
}

std::vector<const Motor*> leading_motors(const LinkedModel& model) {
  std::vector<const Motor*> leading;
  NameTable driven;
  driven.reserve(model.annotations.motors.size());
  leading.reserve(model.annotations.motors.size());
  for (const Motor& motor : model.annotations.motors) {
    if (!motor.joint || !driven.add(*motor.joint, 0)) leading.push_back(&motor);
  }
  return leading;
}

std::optional<double> quaternion_length(yaml::View orientation) {
  if (!orientation || !orientation.is_mapping()) return std::nullopt;
  double sum = 0;
  for (const std::string_view name : {"w", "x", "y", "z"}) {
    const std::optional<double> number = number_at(orientation, name);
    if (!number) return std::nullopt;
    sum += *number * *number;
  }
  return std::sqrt(sum);
}

MotorControl control_in_mars(const Motor& motor) {
  const std::string type = motor.type.value_or("");
  if (is_one_of(type, {"2", "DC", "generic_dc"})) return MotorControl::velocity;
  if (is_one_of(type, {"7", "direct_torque", "direct_effort"})) return MotorControl::torque;
  return MotorControl::position;
}

const urdf::Joint* joint_of(const LinkedModel& model, const Motor& motor) {
  return motor.joint ? model.find_joint(*motor.joint) : nullptr;
}

const urdf::Joint* joint_of(const LinkedModel& model, const JointPoseSet::Entry& entry) {
  if (const urdf::Joint* joint = model.find_joint(entry.name.value)) return joint;
  const Motor* motor = model.find_motor(entry.name.value);
  return motor != nullptr ? joint_of(model, *motor) : nullptr;
}

const Field<double>& lower_bound(const Motor& motor) {
  return motor.min_position.written ? motor.min_position : motor.min_value;
}

const Field<double>& upper_bound(const Motor& motor) {
  return motor.max_position.written ? motor.max_position : motor.max_value;
}

bool is_clearly_less(double a, double b) {
  constexpr double kRounding = 0.002;  // relative; numbers often have only three digits
  return b - a > kRounding * std::max({1.0, std::fabs(a), std::fabs(b)});
}

bool is_slip(const LinkedModel& model, NameKind kind, std::string_view name) {
  if (!can_judge(model, kind) || names(model, kind).contains(name)) return false;
  for (const NameKind other : {NameKind::link, NameKind::joint, NameKind::visual,
                               NameKind::collision, NameKind::material}) {
    if (names(model, other).contains(name)) return true;
  }
  const auto near = nearest(name, names(model, kind).names());
  return near && edit_distance(name, *near, 1) <= 1 && !differ_only_in_digits(name, *near);
}

}  // namespace smurf
