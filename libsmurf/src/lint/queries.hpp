// SPDX-License-Identifier: BSD-3-Clause
// Questions that several rules ask.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "base/text/quoted.hpp"
#include "smurf/lint.hpp"
#include "smurf/names.hpp"

namespace smurf {

/// The names of a kind with a table in the model: not nodes, poses, entities, groups and
/// extensions.
const NameTable& names(const LinkedModel& model, NameKind kind);
/// The place where the thing of this kind and name is defined.
Span definition(const LinkedModel& model, NameKind kind, std::string_view name);

/// Whether names of this kind can be checked: all files that define such names were read.
bool can_judge(const LinkedModel& model, NameKind kind);

/// The subject of a message. The text is made only when something is reported, which is rare; until
/// then, this refers to the entry or element.
class Subject {
 public:
  Subject(const char* words) : words_(words) {}
  /// "motor `elbow`", or "this motor" without a name.
  Subject(std::string_view kind, const Field<std::string>& name) : words_(kind), name_(&name) {}

  std::string text() const;
  operator std::string() const { return text(); }
  friend std::string operator+(const Subject& a, std::string_view b) { return a.text().append(b); }
  friend std::string operator+(std::string a, const Subject& b) { return std::move(a) + b.text(); }

 private:
  std::string_view words_;
  const Field<std::string>* name_ = nullptr;
};
/// "motor `elbow`", or "this motor" for an entry without name.
inline Subject subject(std::string_view kind, const Annotation& annotation) {
  return {kind, annotation.name};
}
/// As title().
Subject subject(const urdf::Joint& joint);

/// Reports a reference to an unknown name: "`subject` names the joint `x`, ...". Notes a thing
/// of another kind with this name, or suggests the nearest name. Returns null if the name is
/// known.
Diagnostic* check_reference(const LinkedModel& model, NameKind kind, std::string_view name,
                            Span place, const Subject& subject, Findings& findings);

/// The place of a YAML scalar within its quotes, if it has any, so that an edit keeps them.
Span within_quotes(const LinkedModel& model, Span place);

/// Calls `visit` for every link (or joint) of the robot, if there is one.
void for_each_link(const LinkedModel& model, const std::function<void(const urdf::Link&)>& visit);
void for_each_joint(const LinkedModel& model, const std::function<void(const urdf::Joint&)>& visit);

/// Calls `visit` for every material definition or use: robot level, then visuals.
void for_each_material(const LinkedModel& model,
                       const std::function<void(const urdf::Material&)>& visit);

/// The main kind of the names in `id` of a sensor of this type; none if MARS does not read `id`.
std::optional<NameKind> sensor_target(std::string_view type);
bool is_section_name(std::string_view key);
/// The words of a text that are numbers, in order; the reader of the URDF reports the
/// others.
std::vector<double> numbers_in(std::string_view text);

/// "link `a`" at its name; "link" at its element when it has none.
std::string title(const urdf::Link& link);
std::string title(const urdf::Joint& joint);
/// The name's place, or the place of the element's name if it has none.
Span name_place(const LinkedModel& model, const urdf::Link& link);
Span name_place(const LinkedModel& model, const urdf::Joint& joint);
/// The `inertia` element's name, or the inertial's.
Span inertia_place(const LinkedModel& model, const urdf::Inertial& inertial);
/// Whether the element has an attribute or a child with a name similar to `name`.
bool has_slip(const LinkedModel& model, xml::ElementId element, std::string_view name);
/// The same for a rule that then reports nothing, because the misspelling is reported at its place.
/// To readers, the element is missing, so the misspelling is also marked as a fault of this rule.
bool is_slip(const LinkedModel& model, xml::ElementId element, std::string_view name,
             Findings& findings);
/// Whether a URDF is `<robot>` with comments only: the empty.urdf that xacro files of several
/// vendors include when a user names no other.
bool has_only_comments(const xml::Document& document);
/// Place of an element's name in its start tag.
Span tag_name(const LinkedModel& model, xml::ElementId element);

}  // namespace smurf
