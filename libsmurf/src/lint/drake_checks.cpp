// SPDX-License-Identifier: BSD-3-Clause
#include "lint/drake_checks.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "ast/urdf_numbers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "readers/drake_language.hpp"
#include "smurf/pose.hpp"

namespace smurf::drake {
namespace {

/// The place of the value of an attribute; without the attribute, the name of the element.
Span place_of(xml::View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return found == nullptr ? element.name_span() : found->value_span();
}

/// The number in an attribute; none if it is absent or not a number (reported elsewhere).
std::optional<double> number_in(xml::View element, std::string_view attribute) {
  const std::vector<double> numbers = read_leading_numbers(value_of(element, attribute));
  if (numbers.size() != 1) return std::nullopt;
  return numbers.front();
}

std::optional<Vector3> vector_in(xml::View element, std::string_view attribute) {
  const std::vector<double> numbers = read_leading_numbers(value_of(element, attribute));
  if (numbers.size() != 3) return std::nullopt;
  return Vector3{numbers[0], numbers[1], numbers[2]};
}

void report_unread(xml::View element, std::string message, Findings& findings) {
  findings.report(element.name_span(), std::move(message)).when(kUnread);
}

double length_of(const Vector3& v) { return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

bool is_standard_type(std::string_view type) {
  return type == "revolute" || type == "continuous" || type == "prismatic" || type == "fixed" ||
         type == "floating";
}

void check_type(xml::View joint, std::string_view type, Findings& findings) {
  const Span place = place_of(joint, "type");
  if (is_standard_type(type)) {
    findings.report(place, "a joint of the type " + quoted(type) + " is written `joint`")
        .help("write `joint` instead of `drake:joint`");
    return;
  }
  Diagnostic& diagnostic = findings.report(place, quoted(type) + " is not a type of `drake:joint`");
  constexpr std::array<std::string_view, 5> kTypes = {"ball", "curvilinear", "planar", "screw",
                                                      "universal"};
  if (const auto near = only_nearest(type, kTypes)) {
    diagnostic.help("did you mean " + quoted(*near) + "?");
  } else {
    diagnostic.help("write `ball`, `curvilinear`, `planar`, `screw` or `universal`");
  }
}

/// A planar joint has three numbers.
void check_damping(xml::View joint, std::string_view type, Findings& findings) {
  const xml::View dynamics = joint.child("dynamics");
  const xml::Attribute* damping = dynamics ? dynamics.attribute("damping") : nullptr;
  if (damping == nullptr || is_xacro(damping->value())) return;
  const std::size_t count = type == "planar" ? 3 : 1;
  const std::vector<double> numbers = read_leading_numbers(damping->value());
  if (numbers.size() != count) {
    findings.report(damping->value_span(), "the damping of a joint of the type " + quoted(type) +
                                               " must be " +
                                               (count == 1 ? "one number" : "three numbers"));
    return;
  }
  for (const double number : numbers) {
    if (number >= 0) continue;
    findings.report(damping->value_span(), "the damping must not be negative");
    return;
  }
}

void check_axis(xml::View joint, std::string_view type, Findings& findings) {
  const xml::View axis = joint.child("axis");
  if (!axis || type == "ball") return;
  constexpr double kShortest = 1e-8;  // detail_urdf_parser.cc:572
  const auto xyz = vector_in(axis, "xyz");
  if (xyz && length_of(*xyz) < kShortest) {
    findings.report(place_of(axis, "xyz"), "the axis has no length");
  }
}

/// Reports directions that Drake's PiecewiseConstantCurvatureTrajectory refuses.
void check_directions(xml::View joint, Findings& findings) {
  const xml::View tangent = joint.child("drake:initial_tangent");
  const xml::View normal = joint.child("drake:plane_normal");
  const Vector3 along = vector_in(tangent, "xyz").value_or(Vector3{1, 0, 0});
  const Vector3 up = vector_in(normal, "xyz").value_or(Vector3{0, 0, 1});
  const double scale = length_of(along) * length_of(up);
  const xml::View place = tangent ? tangent : normal ? normal : joint;
  // RotationMatrix::get_internal_tolerance_for_orthonormality()
  constexpr double kTolerance = 128 * std::numeric_limits<double>::epsilon();
  if (scale == 0) {
    const xml::View zero = tangent && length_of(along) == 0 ? tangent : normal;
    findings.report(place_of(zero, "xyz"), "this direction has no length");
  } else if (std::abs(along[0] * up[0] + along[1] * up[1] + along[2] * up[2]) > kTolerance) {
    findings.report(
        place_of(place, "xyz"),
        "the tangent at the start of the curves must be at right angles to the normal of their "
        "plane");
  }
}

double arc_length(xml::View curve) {
  if (curve.name() == "drake:line_segment") return number_in(curve, "length").value_or(1);
  return number_in(curve, "radius").value_or(1) * std::abs(number_in(curve, "angle").value_or(1));
}

void check_curves(xml::View curves, Findings& findings) {
  std::size_t count = 0;
  double end = 0;  // m along the curves
  for (const xml::View curve : curves) {
    ++count;
    const double start = end, length = arc_length(curve);
    end += length;
    // PiecewiseTrajectory::kEpsilonTime
    constexpr double kShortest = std::numeric_limits<double>::epsilon();
    if (number_in(curve, "angle") == 0.0) {
      findings.report(place_of(curve, "angle"), "the angle of an arc must not be 0");
    } else if (length > 0 && end - start < kShortest) {
      findings.report(curve.name_span(), "this curve is too short: its end is its start")
          .when(kTooShort);
    }
    if (curve.name() == "drake:line_segment" || curve.name() == "drake:circular_arc") continue;
    findings.report(curve.name_span(), quoted(curve.name()) + " is not a curve for Drake")
        .help("write `drake:line_segment` or `drake:circular_arc`");
  }
  if (count == 0) findings.report(curves.name_span(), "`drake:curves` contains no curve");
}

void check_joint(xml::View joint, const Names& names, Findings& findings) {
  const xml::Attribute* written = joint.attribute("type");
  if (written == nullptr || is_xacro(written->value())) return;
  const std::string_view type = written->value();
  const std::string_view name = value_of(joint, "name");
  const xml::View first = names.joint(name);
  if (first && first.id() != joint.id()) {
    findings.report(place_of(joint, "name"), "a second joint is named " + quoted(name))
        .label(place_of(first, "name"), "the first one");
  }
  const std::string_view link = value_of(joint.child("child"), "link");
  if (!link.empty() && link == value_of(joint.child("parent"), "link")) {
    findings.report(place_of(joint.child("child"), "link"), "this joint connects a link to itself");
  }
  if (link == "world") {
    findings.report(place_of(joint.child("child"), "link"),
                    "Drake has no reversed joint that leads to the world");
  } else if (names.closes_loop(joint) && link != value_of(joint.child("parent"), "link")) {
    findings.report(place_of(joint.child("child"), "link"),
                    "other joints connect the links of " + quoted(name) + " already");
  }
  if (!is_own_joint_type(type) && type != "planar") return check_type(joint, type, findings);
  check_damping(joint, type, findings);
  check_axis(joint, type, findings);
  if (type == "screw" && !joint.child("drake:screw_thread_pitch")) {
    findings.report(joint.name_span(), "a screw joint has no `drake:screw_thread_pitch`");
  }
  if (type != "curvilinear") return;
  check_directions(joint, findings);
  if (const xml::View curves = joint.child("drake:curves")) {
    check_curves(curves, findings);
  } else {
    findings.report(joint.name_span(), "a curvilinear joint has no `drake:curves`");
  }
}

void check_group(xml::View group, const Names& names, Findings& findings) {
  const std::string_view name = value_of(group, "name");
  if (name.empty()) return;
  const Span place = place_of(group, "name");
  if (name.find("::") != std::string_view::npos) {
    findings.report(place, "the name of a collision filter group must not contain `::`");
    return;
  }
  if (const xml::View first = names.group(name); first && first.id() != group.id()) {
    findings.report(place, "a second collision filter group is named " + quoted(name))
        .label(place_of(first, "name"), "the first one");
  }
  if (group.child("drake:member") || group.child("drake:member_group")) return;
  findings.report(group.name_span(),
                  "the collision filter group " + quoted(name) + " has no members");
}

/// Drake couples joints of one degree of freedom.
bool has_one_axis(std::string_view type) {
  return type == "revolute" || type == "continuous" || type == "prismatic" || type == "screw" ||
         type == "curvilinear";
}

void check_tendon(xml::View tendon, const Names& names, Findings& findings) {
  std::set<std::string_view> seen;
  for (const xml::View one : tendon) {
    if (one.name() != "drake:tendon_constraint_joint") continue;
    const std::string_view name = value_of(one, "name");
    const xml::View joint = names.joint(name);
    if (!seen.insert(name).second) {
      findings.report(place_of(one, "name"),
                      "the tendon names the joint " + quoted(name) + " twice");
    } else if (joint && !has_one_axis(value_of(joint, "type"))) {
      findings.report(place_of(one, "name"), "a tendon needs joints of one axis")
          .label(place_of(joint, "type"), "not of one axis");
    }
  }
  if (seen.empty()) {
    findings.report(tendon.name_span(),
                    "`drake:tendon_constraint` has no `drake:tendon_constraint_joint`");
  }
  const xml::View above = tendon.child("drake:tendon_constraint_lower_limit");
  const auto lower = number_in(above, "value");
  const auto upper = number_in(tendon.child("drake:tendon_constraint_upper_limit"), "value");
  if (lower && upper && *lower > *upper) {
    findings.report(place_of(above, "value"), "the lower limit " + format_rounded(*lower) +
                                                  " is above the upper limit " +
                                                  format_rounded(*upper));
  }
}

void check_ball(xml::View ball, const Names& names, Findings& findings) {
  const xml::View b = ball.child("drake:ball_constraint_body_B");
  const std::string_view name = value_of(b, "name");
  if (!names.is_body(name)) return;
  if (value_of(ball.child("drake:ball_constraint_body_A"), "name") != name) return;
  findings.report(place_of(b, "name"), "both bodies of this constraint are " + quoted(name));
}

/// What SceneGraph needs to make a hydroelastic shape.
void check_hydroelastic(xml::View proximity, xml::View kind, Findings& findings) {
  const xml::View geometry = proximity.parent().child("geometry");
  bool is_round = false;
  for (const xml::View shape : geometry) {
    is_round = is_round || is_one_of(shape.name(), {"sphere", "cylinder", "capsule",
                                                    "drake:capsule", "drake:ellipsoid"});
  }
  const bool is_rigid = kind.name() == "drake:rigid_hydroelastic";
  for (const std::string_view name : {"drake:mesh_resolution_hint", "drake:hydroelastic_modulus"}) {
    const bool is_hint = name == "drake:mesh_resolution_hint";
    if (is_hint ? !is_round : is_rigid) continue;
    const xml::View needed = proximity.child(name);
    if (!needed) {
      findings.report(kind.name_span(),
                      quoted(kind.name()) + " needs " + quoted(name) + " for this shape");
    } else if (const auto value = number_in(needed, "value"); value && *value <= 0) {
      findings.report(place_of(needed, "value"), quoted(name) + " must be positive");
    }
  }
}

void check_frame(xml::View frame, const Names& names, Findings& findings) {
  if (const xml::View first = names.earlier_frame(frame)) {
    findings
        .report(place_of(frame, "name"),
                "a second frame is named " + quoted(value_of(frame, "name")))
        .label(place_of(first, "name"), "the first one");
  }
}

/// An end of a joint of URDF whose link Drake is told to ignore.
void check_ends(xml::View joint, const Names& names, Findings& findings) {
  if (value_of(joint, "type") == "floating") return;
  for (const std::string_view end : {"parent", "child"}) {
    const std::string_view link = value_of(joint.child(end), "link");
    if (names.is_ignored(link)) {
      Names::report_ignored(link, place_of(joint.child(end), "link"), findings);
    }
  }
}

void check_proximity(xml::View proximity, const Names&, Findings& findings) {
  const xml::View rigid = proximity.child("drake:rigid_hydroelastic");
  const xml::View compliant = proximity.child("drake:compliant_hydroelastic");
  if (rigid && compliant) {
    findings
        .report(
            compliant.name_span(),
            "a collision cannot be `drake:rigid_hydroelastic` and `drake:compliant_hydroelastic`")
        .label(rigid.name_span(), "the other one");
  }
  if (rigid || compliant) check_hydroelastic(proximity, rigid ? rigid : compliant, findings);
  const xml::View modulus = proximity.child("drake:hydroelastic_modulus");
  if (rigid && modulus) {
    report_unread(modulus, "Drake does not read `drake:hydroelastic_modulus` of a rigid shape",
                  findings);
  }
  const xml::View sliding = proximity.child("drake:mu_dynamic");
  const auto dynamic = number_in(sliding, "value");
  const auto fixed = number_in(proximity.child("drake:mu_static"), "value");
  if (dynamic && fixed && *dynamic > *fixed) {
    findings.report(place_of(sliding, "value"),
                    "`drake:mu_dynamic` must not be larger than `drake:mu_static`");
  }
}

/// The number in the text of an element of `drake_compliance`; reports other texts.
std::optional<double> friction(xml::View compliance, std::string_view name, Findings& findings) {
  const xml::View element = compliance.child(name);
  if (!element) return std::nullopt;
  const std::vector<double> numbers = read_leading_numbers(element.text());
  if (!numbers.empty() && numbers.front() >= 0) return numbers.front();
  const bool is_empty = element.text_span().empty();
  findings.report(is_empty ? element.name_span() : element.text_span(),
                  quoted(name) + " must be a number that is not negative");
  return std::nullopt;
}

void check_compliance(xml::View compliance, const Names&, Findings& findings) {
  for (const std::string_view name : {"youngs_modulus", "dissipation"}) {
    const xml::View element = compliance.child(name);
    if (element)
      report_unread(element, "Drake does not read " + quoted(name) + " any more", findings);
  }
  const xml::View properties = compliance.parent().child("drake:proximity_properties");
  if (properties && (properties.child("drake:mu_dynamic") || properties.child("drake:mu_static"))) {
    return report_unread(compliance,
                         "Drake does not read `drake_compliance` beside the friction in "
                         "`drake:proximity_properties`",
                         findings);
  }
  const bool has_static = static_cast<bool>(compliance.child("static_friction"));
  const bool has_dynamic = static_cast<bool>(compliance.child("dynamic_friction"));
  const auto fixed = friction(compliance, "static_friction", findings);
  const auto dynamic = friction(compliance, "dynamic_friction", findings);
  if (has_static != has_dynamic) {
    findings.report(compliance.name_span(),
                    "`drake_compliance` has no " +
                        quoted(has_static ? "dynamic_friction" : "static_friction"));
  } else if (fixed && dynamic && *dynamic > *fixed) {
    findings.report(compliance.child("dynamic_friction").text_span(),
                    "`dynamic_friction` must not be larger than `static_friction`");
  }
}

void check_visual(xml::View visual, const Names&, Findings& findings) {
  const xml::View seen = visual.child("drake:illustration_properties");
  const xml::View sensed = visual.child("drake:perception_properties");
  if (value_of(seen, "enabled") == "false" && value_of(sensed, "enabled") == "false") {
    report_unread(visual, "this visual is neither for illustration nor for perception", findings);
  }
}

void check_surface_axis(xml::View surface, const Names&, Findings& findings) {
  if (value_of(surface.parent(), "name") == "world") {
    return report_unread(surface, "the link `world` has no moving surface", findings);
  }
  const auto axis = vector_in(surface, "axis");
  if (axis && length_of(*axis) == 0) {
    findings.report(place_of(surface, "axis"), "this direction has no length");
  }
}

struct Check {
  std::string_view element;
  void (*run)(xml::View, const Names&, Findings&);
};
constexpr Check kChecks[] = {
    {"joint", check_ends},
    {"frame", check_frame},
    {"drake:joint", check_joint},
    {"drake:collision_filter_group", check_group},
    {"drake:tendon_constraint", check_tendon},
    {"drake:ball_constraint", check_ball},
    {"drake:proximity_properties", check_proximity},
    {"drake_compliance", check_compliance},
    {"visual", check_visual},
    {"drake:surface_velocity_axis", check_surface_axis},
};

}  // namespace

void check_meaning(xml::View element, const Names& names, Findings& findings) {
  for (const Check& check : kChecks) {
    if (is_same(check.element, element.name())) return check.run(element, names, findings);
  }
}

bool is_read_in(xml::View joint, std::string_view child) {
  if (!child.starts_with("drake:")) return true;
  const bool is_screws = child == "drake:screw_thread_pitch";
  return value_of(joint, "type") == (is_screws ? "screw" : "curvilinear");
}

}  // namespace smurf::drake
