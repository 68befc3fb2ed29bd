// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/bodies.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::load_check {
namespace {

std::string moments_text(const std::array<double, 3>& moments) {
  return "principal moments " + format_rounded(moments[0], 4) + ", " +
         format_rounded(moments[1], 4) + ", " + format_rounded(moments[2], 4);
}

std::array<double, 3> principal_moments(const Eigen::Matrix3d& inertia) {
  const double scale = inertia.cwiseAbs().maxCoeff();
  if (!(scale > 0)) return {0, 0, 0};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia / scale,
                                                              Eigen::EigenvaluesOnly);
  const Eigen::Vector3d moments = solver.eigenvalues() * scale;
  return {moments[0], moments[1], moments[2]};
}

/// The amount by which the largest moment exceeds the sum of the others, relative to itself.
double triangle_excess(const std::array<double, 3>& moments) {
  return (moments[2] - moments[1] - moments[0]) / moments[2];
}

constexpr std::string_view kNoMass =
    "ODE refuses a body without positive mass; MARS invents a gram or less, and the joints tear";
constexpr std::string_view kNoInertia = "ODE refuses a body whose inertia is not positive definite";
constexpr std::string_view kTooLarge =
    "ODE does not test it: the body gains energy when it turns fast";
constexpr std::string_view kNoAxis = "ODE and MARS stop at a joint whose axis has no direction";

class BodyCheck {
 public:
  BodyCheck(const Plan& plan, const Bounds& bounds, DiagnosticSink& sink)
      : plan_(plan), bounds_(bounds), sink_(sink), members_(plan.bodies.size()) {
    for (std::size_t i = 0; i < plan.links.size(); ++i) {
      const std::size_t body = plan.links[i].body;
      if (body != kWorld) members_[body].push_back(i);
    }
    for (std::size_t i = 0; i < plan.joints.size(); ++i) joint_above_[plan.joints[i].child] = i;
  }

  std::vector<Figure> run() {
    if (is_drawing()) {
      const LinkedModel& model = *plan_.models.front().model;
      report(rules::sml1502_no_inertial_anywhere, place_of(model),
             "no link of this robot has an inertial", kNoMass);
      return {};
    }
    report_negative_masses();
    for (std::size_t i = 0; i < plan_.bodies.size(); ++i) check_body(i);
    Figure axis{"axis", 0, bounds_["axis"], {}, {}};
    Figure ratio{"mass-ratio", 1, bounds_["mass-ratio"], {}, {}};
    for (const JointPlan& joint : plan_.joints) {
      check_axis(joint, axis);
      check_ratio(joint, ratio);
    }
    return {axis, ratio};
  }

  void check_mass(std::size_t index) {
    if (!(plan_.bodies[index].mass.mass > 0)) check_body(index);
  }

 private:
  bool is_drawing() const {
    return !plan_.bodies.empty() &&
           std::none_of(plan_.links.begin(), plan_.links.end(), [&](const LinkPlan& link) {
             return plan_.link(link).inertial.has_value();
           });
  }

  /// Reports negative masses of all links, including fixed bases and links that are merged with
  /// heavier ones.
  void report_negative_masses() {
    for (const LinkPlan& link : plan_.links) {
      if (has_negative_mass(link)) report_bad_mass(link, mass_of(link));
    }
  }

  bool has_negative_mass(const LinkPlan& link) const {
    return plan_.link(link).inertial && mass_of(link) < 0;
  }

  void check_body(std::size_t index) {
    const MassProperties& mass = plan_.bodies[index].mass;
    const LinkPlan* heaviest = nullptr;
    for (const std::size_t member : members_[index]) {
      const LinkPlan& link = plan_.links[member];
      if (!plan_.link(link).inertial) continue;
      if (has_negative_mass(link)) return;
      if (heaviest == nullptr || mass_of(link) > mass_of(*heaviest)) heaviest = &link;
    }
    if (heaviest == nullptr) {
      report_massless(index);
    } else if (!(mass.mass > 0)) {
      report_bad_mass(*heaviest, mass.mass);
    } else {
      check_inertia(index, *heaviest);
    }
  }

  double mass_of(const LinkPlan& link) const { return plan_.link(link).inertial->mass.value_or(0); }

  void report_massless(std::size_t index) {
    const Named body = name_of_body(plan_, index);
    Diagnostic& diagnostic = report(rules::sml1501_moving_link_without_inertial, body.place,
                                    body.name + " moves and has no mass", kNoMass);
    const auto above = joint_above_.find(index);
    if (above == joint_above_.end()) return;
    const Named joint = name_of(plan_, plan_.joints[above->second]);
    diagnostic.label(joint.place, "moved by this joint");
  }

  void report_bad_mass(const LinkPlan& link, double mass) {
    const urdf::Inertial& inertial = *plan_.link(link).inertial;
    const Span tag = tag_name(plan_.model_of(link), inertial.element);
    if (!inertial.mass.written) {
      report(rules::sml1504_mass_missing, tag,
             "the inertial of " + title(plan_.link(link)) + " has no mass", kNoMass);
      return;
    }
    const Rule& rule = mass < 0 ? rules::sml1509_mass_negative : rules::sml1508_mass_zero;
    report(rule, inertial.mass ? inertial.mass.span : tag,
           "the mass of " + title(plan_.link(link)) + " is " + format_rounded(mass) + " kg",
           kNoMass);
  }

  void check_inertia(std::size_t index, const LinkPlan& heaviest) {
    const Eigen::Matrix3d& inertia = plan_.bodies[index].mass.inertia;
    const std::optional<InertiaFault> fault = fault_of(inertia);
    if (!fault) return;
    const LinkPlan& link = culprit(index, heaviest);
    const std::string whose = "the inertia of " + title(plan_.link(link));
    const Span place = inertia_place(plan_.model_of(link), *plan_.link(link).inertial);
    Diagnostic& diagnostic = inertia.isZero()
                                 ? report(rules::sml1511_inertia_all_zero, place,
                                          whose + " is zero, but its mass is not", kNoInertia)
                             : *fault == InertiaFault::refused
                                 ? report(rules::sml1512_not_positive_definite, place,
                                          whose + " is not physically possible", kNoInertia)
                                 : report(rules::sml1513_triangle_violated, place,
                                          whose + " is not physically possible", kTooLarge);
    diagnostic.caret = moments_text(principal_moments(inertia));
    if (members_[index].size() > 1) {
      diagnostic.note("the moments are those of " + std::to_string(members_[index].size()) +
                      " links that are fixed to each other");
    }
  }

  /// An error, even if its severity in the linter is lower, because it prevents a simulation.
  Diagnostic& report(const Rule& rule, Span place, std::string message, std::string_view ode) {
    Diagnostic& diagnostic = sink_.report(rule, place, std::move(message));
    diagnostic.severity = Severity::error;
    diagnostic.note(std::string(ode));
    return diagnostic;
  }

  /// The link whose own inertia has the same fault, otherwise the heaviest.
  const LinkPlan& culprit(std::size_t index, const LinkPlan& heaviest) const {
    for (const std::size_t member : members_[index]) {
      const LinkPlan& link = plan_.links[member];
      if (!plan_.link(link).inertial) continue;
      const auto moments = smurf::principal_moments(*plan_.link(link).inertial);
      if (moments && (!is_positive_definite(*moments) || triangle_excess(*moments) > 0)) {
        return link;
      }
    }
    return heaviest;
  }

  void check_axis(const JointPlan& plan, Figure& figure) {
    const urdf::Joint& joint = plan_.joint(plan);
    if (plan.kind == JointKind::universal && plan.axis2_W.isZero()) {
      report(rules::sml6105_axis_zero, plan.form_place,
             name_of(plan_, plan).name + " has no second axis to turn about", kNoAxis);
    }
    if (!joint.axis || joint.type == urdf::JointType::floating) return;
    const double length = axis_length(joint);
    const double error = std::fabs(length - 1);
    const Named named = name_of(plan_, plan);
    if (error > figure.value) {
      figure.value = error;
      figure.worst = named.name;
      figure.place = joint.axis.span;
    }
    if (length == 0) {
      report(rules::sml1421_axis_zero, joint.axis.span,
             "the axis of " + named.name + " has no direction", kNoAxis);
    } else if (error > figure.limit) {
      Diagnostic& diagnostic = report(
          rules::sml1422_axis_not_unit, joint.axis.span,
          "the axis of " + named.name + " has the length " + format_rounded(length) + ", not 1",
          "ODE scales it to 1; other readers multiply the joint's position by the length");
      diagnostic.severity = Severity::warning;
    }
  }

  void check_ratio(const JointPlan& plan, Figure& figure) {
    if (plan.parent == kWorld) return;
    const double parent = plan_.bodies[plan.parent].mass.mass;
    const double child = plan_.bodies[plan.child].mass.mass;
    if (!(parent > 0) || !(child > 0)) return;
    const double ratio = std::fmax(parent, child) / std::fmin(parent, child);
    const Named joint = name_of(plan_, plan);
    if (ratio > figure.value) {
      figure.value = ratio;
      figure.worst = joint.name;
      figure.place = joint.place;
    }
    if (ratio <= figure.limit) return;
    Diagnostic& diagnostic = report(
        rules::sml1525_mass_ratio, joint.place,
        joint.name + " connects masses that are too far apart for ODE",
        "its equations lose precision at such ratios: the light body trembles or is torn off");
    diagnostic.severity = Severity::warning;
    diagnostic.caret = format_rounded(parent) + " kg above, " + format_rounded(child) + " kg below";
  }

  const Plan& plan_;
  const Bounds& bounds_;
  DiagnosticSink& sink_;
  std::vector<std::vector<std::size_t>> members_;  ///< links of each body
  std::map<std::size_t, std::size_t> joint_above_;
};

}  // namespace

std::optional<InertiaFault> fault_of(const Eigen::Matrix3d& inertia) {
  constexpr double kRounding = 1e-2;  // flat parts printed with few digits stay below
  const std::array<double, 3> moments = principal_moments(inertia);
  if (!is_positive_definite(moments)) return InertiaFault::refused;
  if (triangle_excess(moments) > kRounding) return InertiaFault::impossible;
  return std::nullopt;
}

std::vector<Figure> check_bodies(const Plan& plan, const Bounds& bounds, DiagnosticSink& sink) {
  return BodyCheck(plan, bounds, sink).run();
}

void check_mass(const Plan& plan, std::size_t body, DiagnosticSink& sink) {
  BodyCheck(plan, Bounds(), sink).check_mass(body);
}

Named name_of(const Plan& plan, const LinkPlan& link) {
  return {title(plan.link(link)), name_place(plan.model_of(link), plan.link(link))};
}

Named name_of(const Plan& plan, const JointPlan& joint) {
  return {title(plan.joint(joint)),
          name_place(*plan.models[joint.instance].model, plan.joint(joint))};
}

Named name_of_body(const Plan& plan, std::size_t body) {
  return name_of(plan, plan.links[plan.bodies[body].first_link]);
}

Span place_of(const LinkedModel& model) {
  if (model.robot->name.written) return model.robot->name.span;
  return tag_name(model, model.robot->document.root);
}

}  // namespace smurf::load_check
