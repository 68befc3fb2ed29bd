// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/bodies.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers.hpp"
#include "base/rules.hpp"
#include "lint/inertia.hpp"
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

/// By how much the largest moment exceeds the sum of the others, relative to itself.
double triangle_excess(const std::array<double, 3>& moments) {
  return (moments[2] - moments[1] - moments[0]) / moments[2];
}

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
      sink_.report(rules::sml6101_body_without_mass, place_of(model),
                   "no link of this robot has a mass");
      return {};
    }
    for (std::size_t i = 0; i < plan_.bodies.size(); ++i) check_body(i);
    Figure axis{"axis", 0, bounds_["axis"], {}, {}};
    Figure ratio{"mass-ratio", 1, bounds_["mass-ratio"], {}, {}};
    for (const JointPlan& joint : plan_.joints) {
      check_axis(joint, axis);
      check_ratio(joint, ratio);
    }
    return {axis, ratio};
  }

 private:
  bool is_drawing() const {
    return !plan_.bodies.empty() &&
           std::none_of(plan_.links.begin(), plan_.links.end(), [&](const LinkPlan& link) {
             return plan_.link(link).inertial.has_value();
           });
  }

  void check_body(std::size_t index) {
    const MassProperties& mass = plan_.bodies[index].mass;
    const LinkPlan* heaviest = nullptr;
    for (const std::size_t member : members_[index]) {
      const LinkPlan& link = plan_.links[member];
      if (!plan_.link(link).inertial) continue;
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
    Diagnostic& diagnostic = sink_.report(rules::sml6101_body_without_mass, body.place,
                                          body.name + " moves and has no mass");
    const auto above = joint_above_.find(index);
    if (above == joint_above_.end()) return;
    const Named joint = name_of(plan_, plan_.joints[above->second]);
    diagnostic.labels.push_back({joint.place, "moved by this joint"});
  }

  void report_bad_mass(const LinkPlan& link, double mass) {
    const urdf::Inertial& inertial = *plan_.link(link).inertial;
    const Span place =
        inertial.mass ? inertial.mass.span : tag_name(plan_.model_of(link), inertial.element);
    sink_
        .report(rules::sml6101_body_without_mass, place,
                "ODE takes no body with the mass of " + title(plan_.link(link)))
        .caret = format_rounded(mass) + " kg";
  }

  void check_inertia(std::size_t index, const LinkPlan& heaviest) {
    constexpr double kRounding = 1e-2;  // flat parts printed with few digits stay below
    const std::array<double, 3> moments = principal_moments(plan_.bodies[index].mass.inertia);
    const bool is_positive = is_positive_definite(moments);
    if (is_positive && triangle_excess(moments) <= kRounding) return;
    const LinkPlan& link = culprit(index, heaviest);
    const Rule& rule =
        is_positive ? rules::sml6103_inertia_impossible : rules::sml6102_inertia_refused;
    std::string message =
        is_positive ? "no body can have the inertia of " : "ODE takes no body with the inertia of ";
    message += title(plan_.link(link));
    Diagnostic& diagnostic = sink_.report(
        rule, inertia_place(plan_.model_of(link), *plan_.link(link).inertial), std::move(message));
    diagnostic.caret = moments_text(moments);
    if (members_[index].size() > 1) {
      diagnostic.notes.push_back("the moments are those of " +
                                 std::to_string(members_[index].size()) +
                                 " links that are fixed to each other");
    }
  }

  /// The link whose own inertia is as bad, else the heaviest.
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
      sink_.report(rules::sml6105_axis_zero, plan.form_place,
                   name_of(plan_, plan).name + " has no second axis to turn about");
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
      sink_.report(rules::sml6105_axis_zero, joint.axis.span,
                   named.name + (plan.kind == JointKind::slider ? " slides along no axis"
                                                                : " turns about no axis"));
    } else if (error > figure.limit) {
      Diagnostic& diagnostic = sink_.report(rules::sml6104_axis_not_unit, joint.axis.span,
                                            "the axis of " + named.name + " is no unit vector");
      diagnostic.caret = "length " + format_rounded(length);
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
    Diagnostic& diagnostic =
        sink_.report(rules::sml6106_mass_ratio, joint.place,
                     joint.name + " connects masses that are too far apart for ODE");
    diagnostic.caret = format_rounded(parent) + " kg above, " + format_rounded(child) + " kg below";
  }

  const Plan& plan_;
  const Bounds& bounds_;
  DiagnosticSink& sink_;
  std::vector<std::vector<std::size_t>> members_;  ///< links of each body
  std::map<std::size_t, std::size_t> joint_above_;
};

}  // namespace

std::vector<Figure> check_bodies(const Plan& plan, const Bounds& bounds, DiagnosticSink& sink) {
  return BodyCheck(plan, bounds, sink).run();
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
