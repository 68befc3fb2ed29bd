// SPDX-License-Identifier: BSD-3-Clause
// References to unknown names: where they are, and their messages.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lint/queries.hpp"
#include "smurf/references.hpp"

namespace smurf {

/// The names to which no other reference of the same sort leads, although each should have one. A
/// misspelt name means one of them rather than a name that is already used.
struct UnusedNames {
  std::vector<std::string_view> names;
  std::string_view own;  ///< the name of the entry; suggested if it is among them
  std::string reason;    ///< "which no motor drives"
};
/// What a name may mean.
struct Meanings {
  std::function<UnusedNames()> unused = {};  ///< one of these is suggested if possible
  std::string_view own = {};                 ///< the thing itself, to which the name cannot refer
  /// Other names that would be another mistake: a joint that leads to its own parent.
  std::function<bool(std::string_view name)> is_impossible = {};
};
/// As in lint/queries.hpp.
Diagnostic* check_reference(const LinkedModel& model, NameKind kind, std::string_view name,
                            Span place, const Subject& subject, Findings& findings,
                            const Meanings& meanings);

/// The place of a name in the annotations.
struct AnnotationPlace {
  std::string_view section;  ///< canonical name ("motors"); empty in a URDF
  std::string_view key;      ///< key of the entry; nested values have the same
  yaml::View entry;
};
AnnotationPlace annotation_place(const LinkedModel& model, const Reference& reference);

/// The name with its quotes, to which findings point.
Span place_of(const Reference& reference);

/// Gets the element of a URDF that contains the name; false for annotations.
xml::View element_of(const LinkedModel& model, const Reference& reference);

/// The link at the other end of the joint with this `<parent>` or `<child>`.
std::string_view other_link(xml::View end);

/// The subject of a message, for annotations: "motor `elbow`", "this joint entry".
std::string subject_of(const AnnotationPlace& place);
/// The subject of a message, for elements: "joint `elbow`", or "a joint without name".
std::string subject_of(xml::View joint);

/// check_reference() for names in annotations.
Diagnostic* report_unknown(const LinkedModel& model, const Reference& reference,
                           Findings& findings);
/// Reports all unknown names of a kind in annotations, except for those in joint poses and at
/// places to skip.
void report_unknown(const LinkedModel& model, NameKind kind, Findings& findings,
                    const std::function<bool(const AnnotationPlace&)>& is_passed_over = {});

}  // namespace smurf
