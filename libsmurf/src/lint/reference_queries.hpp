// SPDX-License-Identifier: BSD-3-Clause
// References to unknown names: where they are, and their messages.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "lint/queries.hpp"

namespace smurf {

/// The place of a name in the annotations.
struct AnnotationPlace {
  std::string_view section;  ///< canonical ("motors"); empty in a URDF
  std::string_view key;      ///< of the entry; what is inside of its value has the same
  yaml::View entry;
};
AnnotationPlace annotation_place(const LinkedModel& model, const Reference& reference);

/// The name with its quotes, which is where findings point.
Span place_of(const Reference& reference);

/// The element of a URDF in which it stands; false for annotations.
xml::View element_of(const LinkedModel& model, const Reference& reference);

/// Withdraws a fix that writes this name, which would be another mistake at this place. The hint
/// stays: it may tell what went wrong.
void withhold_fix(Diagnostic* diagnostic, std::string_view name);

/// The other end of the joint whose `<parent>` or `<child>` this is.
std::string_view other_link(xml::View end);

/// "motor `elbow`", "this joint entry": who names it in the annotations.
std::string subject_of(const AnnotationPlace& place);
/// "joint `elbow`" of an element, or "a joint without name".
std::string subject_of(xml::View joint);

/// As check_reference(), for what annotations name.
Diagnostic* report_unknown(const LinkedModel& model, const Reference& reference,
                           Findings& findings);
/// Reports all names of a kind that annotations need and nothing has, but for those of joint poses
/// and those at places that are to be passed over.
void report_unknown(const LinkedModel& model, NameKind kind, Findings& findings,
                    const std::function<bool(const AnnotationPlace&)>& is_passed_over = {});

}  // namespace smurf
