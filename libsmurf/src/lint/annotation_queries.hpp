// SPDX-License-Identifier: BSD-3-Clause
// Questions that several rules ask of annotations.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lint/queries.hpp"

namespace smurf {

/// The mapping of an entry, including keys without a member.
yaml::View mapping_of(const LinkedModel& model, const Annotation& entry);

/// The finite number under a key; none if it is absent or not a number.
std::optional<double> number_at(yaml::View mapping, std::string_view key);
/// The scalar under a key, with its place.
std::optional<Spanned<std::string>> text_at(yaml::View mapping, std::string_view key);

/// Whether an unknown key is a misspelling of `key`, which is then reported elsewhere.
bool has_misspelt(yaml::View mapping, std::string_view key);
/// The same for a rule that then reports nothing. To readers, the key is missing, so the
/// misspelling is also marked as a fault of this rule.
bool is_slip(yaml::View mapping, std::string_view key, Findings& findings);

/// Reports `name: 5` and `name: yes` of an entry, which Phobos reads as values of Python.
void report_name_read_as_value(yaml::View entry, Findings& findings);
/// Reports keys that Phobos reads as numbers, which stop it in entries.
void report_number_keys(yaml::View entry, Findings& findings);

/// A top-level key of the main file or of an annotation file.
struct TopLevelKey {
  const ModelFile& file;
  yaml::View value;
};
/// All top-level keys in the order in which MARS reads them: main file first, then `files`.
/// Repeated keys are omitted.
std::vector<TopLevelKey> top_level_keys(const LinkedModel& model);

/// The entry in `files` for the file of this source; empty if it is absent or was not read.
Span place_in_files(const LinkedModel& model, SourceId source);

/// The motors, except for motors that drive the joint of an earlier motor, which is reported.
std::vector<const Motor*> leading_motors(const LinkedModel& model);

/// The length of the quaternion of an orientation; none for other forms.
std::optional<double> quaternion_length(yaml::View orientation);

/// The control mode of a motor in MARS, by its type.
enum class MotorControl : std::uint8_t { position, velocity, torque };
MotorControl control_in_mars(const Motor& motor);

/// The joint that a motor drives; null if it is unknown.
const urdf::Joint* joint_of(const LinkedModel& model, const Motor& motor);
/// The joint that an entry of a pose names, or the joint of the named motor; null if it is
/// unknown.
const urdf::Joint* joint_of(const LinkedModel& model, const JointPoseSet::Entry& entry);

/// Bounds of the commanded position in MARS: the newer names take precedence.
const Field<double>& lower_bound(const Motor& motor);
const Field<double>& upper_bound(const Motor& motor);

/// Whether two bounds are equal up to rounding, such as 2.094 and 2.0944.
bool is_clearly_less(double a, double b);

/// Whether no thing of this kind has the name, but the author probably meant one: the name
/// resembles a known name, or is the name of a thing of another kind.
bool is_slip(const LinkedModel& model, NameKind kind, std::string_view name);

}  // namespace smurf
