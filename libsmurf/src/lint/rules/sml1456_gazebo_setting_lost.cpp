// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "link/gazebo_names.hpp"
#include "lint/queries.hpp"
#include "lint/sdf_checks.hpp"

namespace smurf::rules::sml1456_gazebo_setting_lost_file {
namespace {

/// Elements that sdformat uses for links and their shapes only.
constexpr std::string_view kOfLinks[] = {"material",
                                         "collision",
                                         "visual",
                                         "turnGravityOff",
                                         "dampingFactor",
                                         "maxVel",
                                         "minDepth",
                                         "mu1",
                                         "mu2",
                                         "fdir1",
                                         "kp",
                                         "kd",
                                         "selfCollide",
                                         "maxContacts",
                                         "laserRetro",
                                         "gravity",
                                         "self_collide",
                                         "kinematic",
                                         "velocity_decay"};
/// Elements that sdformat uses for joints only.
constexpr std::string_view kOfJoints[] = {
    "springReference",    "springStiffness",         "stopCfm",    "stopErp",
    "fudgeFactor",        "provideFeedback",         "cfmDamping", "implicitSpringDamper",
    "preserveFixedJoint", "disableFixedJointLumping"};

/// What a <gazebo> refers to.
struct Target {
  bool is_link = false, is_joint = false;
  bool is_merged_joint = false;
};

class Check {
 public:
  Check(const LinkedModel& model, Findings& findings) : model_(model), findings_(findings) {}

  void run() {
    for (const xml::ElementId id : model_.robot->extensions) {
      const xml::View gazebo(model_.robot->document, id);
      const xml::Attribute* reference = gazebo.attribute("reference");
      if (gazebo.name() != "gazebo" || reference == nullptr) continue;
      const Target target = target_of(reference->value());
      for (const xml::View child : gazebo) check(child, target, reference->value());
    }
  }

 private:
  Target target_of(std::string_view name) {
    Target target;
    target.is_link = model_.link_names.contains(name);
    const auto joint = model_.joint_names.find(name);
    target.is_joint = joint.has_value();
    if (!joint || model_.robot->joints[*joint].type != urdf::JointType::fixed) return target;
    const auto parent = model_.tree.joint_parent[*joint];
    const bool is_on_world = parent && model_.link(*parent).name.value_or("") == "world";
    if (!kept_) kept_ = joints_kept_by_gazebo(model_);
    target.is_merged_joint = !is_on_world && !kept_->contains(name);
    return target;
  }

  void check(xml::View child, const Target& target, std::string_view name) {
    if (target.is_joint && !target.is_link) check_of_joint(child, target, name);
    if (!target.is_link) return;
    if (!target.is_joint && ranges::contains(kOfJoints, child.name())) {
      add(child,
          quoted(child.name()) + " is a setting of joints, but " + quoted(name) + " is a link");
    }
    const bool has_elements = child.begin() != child.end();
    const bool has_value = child.attribute("value") != nullptr || !trimmed(child.text()).empty();
    if (child.name() == "material" && has_elements && !has_value) {
      Diagnostic& diagnostic = findings_.report(
          child.name_span(), "Gazebo reads a name in `material`, and no other elements");
      diagnostic.help("write `<visual><material>...</material></visual>` around them");
    }
  }

  void check_of_joint(xml::View child, const Target& target, std::string_view name) {
    const std::string_view type = sdf::value_of(child, "type");
    if (child.name() == "sensor" && (target.is_merged_joint || type != "force_torque")) {
      const bool is_of_joints = type == "force_torque";
      Diagnostic& diagnostic =
          findings_.report(child.name_span(), "Gazebo drops this sensor of joint " + quoted(name));
      diagnostic.note(is_of_joints ? "Gazebo merges the links of a fixed joint"
                                   : "joints have sensors for force and torque only");
      diagnostic.help(is_of_joints
                          ? "keep the joint with `<preserveFixedJoint>true</preserveFixedJoint>`"
                          : "refer to the link that carries the sensor");
    } else if (target.is_merged_joint && child.name() == "provideFeedback") {
      add(child,
          "Gazebo merges the links of joint " + quoted(name) + ", which then has no feedback");
    } else if (ranges::contains(kOfLinks, child.name())) {
      add(child,
          quoted(child.name()) + " is a setting of links, but " + quoted(name) + " is a joint");
    }
  }

  void add(xml::View setting, std::string message) {
    const bool is_of_link = ranges::contains(kOfLinks, setting.name());
    findings_
        .report_habit(setting.name_span(), std::move(message), "such settings",
                      habits_.try_emplace(setting.name(), habits_.size()).first->second)
        .help(is_of_link ? "refer to the link"
                         : "refer to a joint that moves, or delete the setting");
  }

  const LinkedModel& model_;
  Findings& findings_;
  std::optional<std::set<std::string_view>> kept_;
  std::map<std::string_view, std::size_t> habits_;  ///< by the name of the setting
};

void check(const LinkedModel& model, Findings& findings) {
  if (model.robot) Check(model, findings).run();
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::loses, "ignores the element", kRun},
};

}  // namespace

extern constinit const Rule sml1456_gazebo_setting_lost{
    .id = "SML1456",
    .name = "gazebo-setting-lost",
    .severity = Severity::warning,
    .summary = "A Gazebo setting refers to a link or joint that has no such setting.",
    .why =
        "The conversion to SDF ignores, without a message, sensors and friction of joints, springs of links, and everything about fixed joints that it merges.",
    .remedy = "Refer to the link of a sensor or shape, and to the joint of a spring or stop.",
    .sources = "gz-sim issue 2961, sdformat issue 513.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1456_gazebo_setting_lost_file
