// SPDX-License-Identifier: BSD-3-Clause
// Proves a conversion: compares the quantities that a simulator computes from the two models.
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "convert/annotation_values.hpp"
#include "convert/mass_properties.hpp"
#include "convert/passes.hpp"
#include "link/gazebo_names.hpp"
#include "smurf/convert.hpp"

namespace smurf {
namespace {

/// Relative to the larger of the two, and absolute below 1.
double relative_difference(double a, double b) {
  return std::fabs(a - b) / std::max({1.0, std::fabs(a), std::fabs(b)});
}

class Comparison {
 public:
  Comparison(const LinkedModel& source, const LinkedModel& result, const ProofScope& scope)
      : source_(source),
        result_(result),
        scope_(scope),
        source_values_(source),
        result_values_(result) {}

  Proof run() {
    for (const urdf::Link& link : source_.robot->links) merges(link);
    same_names("link", source_.link_names, result_.link_names, merged_links_);
    same_names("joint", source_.joint_names, result_.joint_names, merged_joints_);
    if (!proof_.difference.empty()) return proof_;
    proof_.links = source_.robot->links.size();
    if (!scope_.may_change_limits) same_limits();
    same_masses();
    same_looks();
    same_contacts();
    constexpr int kConfigurations = 5;
    std::mt19937 random(20260101);  // fixed seed, so that every run gives the same proof
    for (int i = 0; i < kConfigurations; ++i) same_poses(i == 0 ? JointPositions{} : draw(random));
    return proof_;
  }

 private:
  static constexpr double kTolerance = 1e-12;  // promised: equal to 1e-12 relative

  void note(const std::string& difference) {
    if (proof_.difference.empty()) proof_.difference = difference;
  }

  /// Whether a link on a fixed joint may have been merged into another link.
  void merges(const urdf::Link& link) {
    const auto index = link.name ? source_.link_names.find(*link.name) : std::nullopt;
    if (!scope_.may_merge_links || !index || !source_.tree.parent_joint[*index]) return;
    const urdf::Joint& joint = source_.joint(*source_.tree.parent_joint[*index]);
    if (joint.type != urdf::JointType::fixed ||
        result_.link_names.contains(renamed_link(*link.name))) {
      return;
    }
    merged_links_.insert(*link.name);
    if (joint.name) merged_joints_.insert(*joint.name);
  }

  std::string renamed(std::string_view name) const { return scope_.prefix + std::string(name); }

  std::string renamed_link(std::string_view name) const {
    return passes::is_world(name) ? std::string(name) : renamed(name);
  }

  void same_names(const std::string& kind, const NameTable& a, const NameTable& b,
                  const std::set<std::string_view>& merged) {
    std::set<std::string> expected;
    for (const std::string_view name : a.names()) {
      if (merged.contains(name)) continue;
      const std::string new_name = kind == "link" ? renamed_link(name) : renamed(name);
      expected.insert(new_name);
      if (!b.contains(new_name)) note("the " + kind + " `" + std::string(name) + "` is lost");
    }
    for (const std::string_view name : b.names()) {
      const bool is_base = scope_.may_add_base && name.starts_with("world");
      if (!is_base && !expected.contains(std::string(name))) {
        note("the " + kind + " `" + std::string(name) + "` is new");
      }
    }
  }

  const urdf::Joint& result_joint(const urdf::Joint& joint) const {
    return result_.robot->joints[*result_.joint_names.find(renamed(*joint.name))];
  }

  void same_limits() {
    const std::vector<urdf::Joint>& joints = source_.robot->joints;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const urdf::Joint& joint = joints[i];
      if (!joint.name || merged_joints_.contains(*joint.name)) continue;
      if (*source_.joint_names.find(*joint.name) != i) continue;  // readers ignore a second one
      const urdf::Joint& other = result_joint(joint);
      bool differs = joint.type != other.type;
      const bool is_limited =
          joint.type != urdf::JointType::fixed && joint.type != urdf::JointType::floating;
      const urdf::Limit a = is_limited ? joint.limit.value_or(urdf::Limit{}) : urdf::Limit{};
      const urdf::Limit b = is_limited ? other.limit.value_or(urdf::Limit{}) : urdf::Limit{};
      differs = differs || (is_limited && joint.limit.has_value() != other.limit.has_value());
      const auto compare = [&](const Field<double>& x, const Field<double>& y) {
        if (x.has_value() != y.has_value()) differs = true;
        const double difference = relative_difference(x.value_or(0), y.value_or(0));
        proof_.limits = std::max(proof_.limits, difference);
        if (difference > kTolerance) differs = true;
      };
      compare(a.lower, b.lower);
      compare(a.upper, b.upper);
      compare(a.effort, b.effort);
      compare(a.velocity, b.velocity);
      if (differs) note("type or limits of the joint `" + *joint.name + "` differ");
    }
  }

  void same_masses() {
    const MassProperties a = total(source_, forward_kinematics(source_, {}));
    const MassProperties b = total(result_, forward_kinematics(result_, {}));
    proof_.mass = a.mass == b.mass ? 0 : std::fabs(a.mass - b.mass) / std::fabs(a.mass);
    proof_.center_of_mass = (a.center - b.center).norm();
    const double difference = (a.inertia - b.inertia).norm();
    proof_.inertia = difference == 0 ? 0 : difference / a.inertia.norm();
    if (!(proof_.mass <= kTolerance)) note("the total mass differs");
    if (proof_.center_of_mass > kTolerance * std::max(1.0, a.center.norm())) {
      note("the centre of mass differs");
    }
    if (!(proof_.inertia <= kTolerance)) note("the inertia differs");
  }

  /// What a reader of a URDF shows: the colour and the texture of a visual, or those of the
  /// definition of its material, which may be in another link.
  struct Look {
    std::optional<std::array<double, 4>> color;
    bool has_texture = false;
    friend bool operator==(const Look&, const Look&) = default;
  };
  static Look look_of(const urdf::Visual& visual, const AnnotationValues& values) {
    if (!visual.material) return {};
    const urdf::Material* material = &*visual.material;
    const bool is_shared = material->name && !material->name->empty();
    if (is_shared && !material->rgba && !material->texture) {
      material = values.definition(*material->name);
    }
    return {material->rgba.value(), material->texture.has_value()};
  }
  /// The look that the annotations give a visual, if they may be applied.
  Look expected_look(const urdf::Visual& visual) const {
    Look look = look_of(visual, source_values_);
    const Field<std::string> name = visual.material ? visual.material->name : Field<std::string>();
    if (!scope_.may_change_materials || !name || name->empty()) return look;
    for (const MaterialAnnotation& entry : source_.annotations.materials) {
      if (!entry.name || *entry.name != *name) continue;
      if (!entry.diffuse_color && !entry.diffuse_texture) continue;
      if (entry.diffuse_color) look.color = rgba_of(*entry.diffuse_color);
      if (entry.diffuse_texture) look.has_texture = true;
      return look;
    }
    return look;
  }

  void same_looks() {
    for (const urdf::Link& link : source_.robot->links) {
      if (!link.name || merged_links_.contains(*link.name)) continue;
      const auto index = result_.link_names.find(renamed_link(*link.name));
      if (!index) continue;
      const auto& others = result_.robot->links[*index].visuals;
      // The visuals of merged links follow, and those that replace capsules.
      if (others.size() < link.visuals.size()) {
        note("the link `" + *link.name + "` has fewer visuals");
        continue;
      }
      for (std::size_t i = 0; i < link.visuals.size(); ++i) {
        if (expected_look(link.visuals[i]) == look_of(others[i], result_values_)) continue;
        note("the material of a visual of the link `" + *link.name + "` differs");
      }
    }
  }

  /// Contact sensors that find their collisions in Gazebo still do. All may be removed.
  void same_contacts() {
    const bool has_any = !contact_names(result_).empty();
    if (has_any && passes::known_contacts(result_) < passes::known_contacts(source_)) {
      note("a contact sensor names a collision that Gazebo does not have");
    }
  }

  JointPositions draw(std::mt19937& random) const {
    JointPositions positions;
    for (const urdf::Joint& joint : source_.robot->joints) {
      if (!joint.name || !joint.has_one_axis() || joint.mimic) continue;
      double low = -1;
      double high = 1;
      if (joint.limit && joint.limit->lower && joint.limit->upper) {
        low = std::clamp(*joint.limit->lower, -3.0, 3.0);
        high = std::clamp(*joint.limit->upper, low, 3.0);
      }
      // std::uniform_real_distribution differs between standard libraries.
      const double unit = static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
      positions[*joint.name] = low + (high - low) * unit;
    }
    return positions;
  }

  void same_poses(const JointPositions& positions) {
    ++proof_.joint_positions;
    const auto a = forward_kinematics(source_, positions);
    JointPositions renamed_positions;
    for (const auto& [name, position] : positions) renamed_positions[renamed(name)] = position;
    const auto b = forward_kinematics(result_, renamed_positions);
    for (std::size_t i = 0; i < a.size(); ++i) {
      const urdf::Link& link = source_.robot->links[i];
      if (!link.name || source_.link_names.find(*link.name) != i) continue;
      if (merged_links_.contains(*link.name)) continue;
      const std::optional<Pose>& other = b[*result_.link_names.find(renamed_link(*link.name))];
      if (a[i].has_value() != other.has_value()) {
        note("the link `" + *link.name + "` is connected in one model only");
        continue;
      }
      if (!a[i]) continue;
      double distance = 0;
      double size = 1;
      for (std::size_t k = 0; k < 3; ++k) {
        distance = hypotenuse(distance, a[i]->position[k] - other->position[k]);
        size = std::max(size, std::fabs(a[i]->position[k]));
      }
      const double angle = angle_between(a[i]->orientation, other->orientation);
      proof_.position = std::max(proof_.position, distance);
      proof_.angle = std::max(proof_.angle, angle);
      if (distance > kTolerance * size || angle > kTolerance) {
        note("the pose of the link `" + *link.name + "` differs by " + format_rounded(distance) +
             " m and " + format_rounded(angle) + " rad");
      }
    }
  }

  const LinkedModel& source_;
  const LinkedModel& result_;
  const ProofScope& scope_;
  AnnotationValues source_values_, result_values_;
  std::set<std::string_view> merged_links_, merged_joints_;
  Proof proof_;
};

}  // namespace

ProofScope proof_scope(const UrdfExport& options) {
  return {.prefix = options.prefix,
          .may_merge_links = options.collapses_fixed,
          .may_add_base = options.base != BaseJoint::as_is,
          .may_change_limits = options.apply.limits,
          .may_change_materials = options.apply.materials};
}

Proof compare_models(const LinkedModel& source, const LinkedModel& result,
                     const ProofScope& scope) {
  return Comparison(source, result, scope).run();
}

}  // namespace smurf
