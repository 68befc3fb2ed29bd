// SPDX-License-Identifier: BSD-3-Clause
// Questions that several rules ask of annotations.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lint/queries.hpp"

namespace smurf {

/// The mapping of an entry as written, with the keys that have no member.
yaml::View mapping_of(const LinkedModel& model, const Annotation& entry);

/// The finite number under a key; none when it is absent or no number.
std::optional<double> number_at(yaml::View mapping, std::string_view key);
/// The scalar under a key, with its place.
std::optional<Spanned<std::string>> text_at(yaml::View mapping, std::string_view key);
/// The scalars of the list under a key.
NameList texts_at(yaml::View mapping, std::string_view key);

/// True when an unknown key of the mapping is a misspelling of `key`, which is then reported.
bool has_misspelt(yaml::View mapping, std::string_view key);
/// Same, for a rule that reports nothing then. To readers the key is missing, so the misspelling is
/// marked as a fault of this rule, too.
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
/// All of them in the order in which MARS meets them: main file first, then `files`. Repeated keys
/// are left out.
std::vector<TopLevelKey> top_level_keys(const LinkedModel& model);

/// Where `files` lists the file of this source; empty when it does not, or a file was not read.
Span place_in_files(const LinkedModel& model, SourceId source);

/// The motors without those that drive a joint which an earlier one drives, and which is reported.
std::vector<const Motor*> leading_motors(const LinkedModel& model);

/// The length of the quaternion that an orientation is written as; none for other forms.
std::optional<double> quaternion_length(yaml::View orientation);

/// How MARS controls a motor, by its type.
enum class MotorControl : std::uint8_t { position, velocity, torque };
MotorControl control_in_mars(const Motor& motor);

/// The joint that a motor drives; null when it is unknown.
const urdf::Joint* joint_of(const LinkedModel& model, const Motor& motor);
/// The joint that an entry of a pose names, or the joint of the motor that it names; null when it
/// is unknown.
const urdf::Joint* joint_of(const LinkedModel& model, const JointPoseSet::Entry& entry);

/// Bounds of the commanded position as MARS reads them: the newer names win.
const Field<double>& lower_bound(const Motor& motor);
const Field<double>& upper_bound(const Motor& motor);

/// Numbers of 2.094 and 2.0944 are the same bound.
bool is_clearly_less(double a, double b);

/// True when no thing of this kind has the name, but the author meant one: the name resembles that
/// of such a thing, or is the name of another kind of thing.
bool is_slip(const LinkedModel& model, NameKind kind, std::string_view name);

}  // namespace smurf
