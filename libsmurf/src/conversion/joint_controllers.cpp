// SPDX-License-Identifier: BSD-3-Clause
// Sources: ros2_controllers, the command_interface_configuration() of each class.
#include "conversion/joint_controllers.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "write/parts/joint_drives.hpp"

namespace smurf {
namespace {

/// The commands of one controller for one joint, in the order of preference.
struct Claim {
  std::string joint;  ///< as written
  std::vector<std::string_view> interfaces;
};

std::string_view text_of(yaml::View value) {
  return value && value.is_scalar() ? value.text() : std::string_view();
}

/// The interfaces that the controller commands, of "position", "velocity" and "effort", in this
/// order, which is that of preference.
std::vector<std::string_view> interfaces_of(const RosController& controller) {
  const std::string_view type = text_of(controller.type);
  std::vector<std::string_view> written;
  for (const std::string_view key : {"command_interfaces", "interface_names"}) {
    for (const yaml::View one : controller.list(key)) written.push_back(one.text());
  }
  for (const std::string_view key : {"interface_name", "command_interface"}) {
    const std::string_view one = text_of(controller.parameter(key));
    if (!one.empty()) written.push_back(one);
  }
  std::vector<std::string_view> found;
  for (const std::string_view one : {"position", "velocity", "effort"}) {
    const bool is_of_class = type.starts_with(std::string(one) + "_controllers/") ||
                             (one == "position" && type.starts_with("parallel_gripper_action"));
    const bool is_written = std::find(written.begin(), written.end(), one) != written.end();
    if (is_written || is_of_class) found.push_back(one);
  }
  return found;
}

/// Calls `visit` with each joint that a parameter names, in a list or alone.
void for_each_joint(const RosController& controller, std::string_view key,
                    const std::function<void(std::string_view)>& visit) {
  for (const yaml::View one : controller.list(key)) visit(one.text());
  if (const std::string_view one = text_of(controller.parameter(key)); !one.empty()) visit(one);
}

std::vector<Claim> claims_of(const RosController& controller) {
  std::vector<Claim> claims;
  const auto add = [&](std::string_view key, const std::vector<std::string_view>& interfaces) {
    if (interfaces.empty()) return;
    for_each_joint(controller, key, [&](std::string_view joint) {
      claims.push_back({std::string(joint), interfaces});
    });
  };
  const std::vector<std::string_view> own = interfaces_of(controller);
  const bool has_command_joints = !controller.list("command_joints").empty();
  add(has_command_joints ? "command_joints" : "joints", own);
  add("joint", own);
  add("dof_names", own);
  // Mobile bases. Of their wheels in front and at the back, Humble says which of them steer.
  for (const std::string_view key :
       {"left_wheel_names", "right_wheel_names", "wheel_names", "traction_joints_names",
        "traction_joint_name", "front_left_wheel_command_joint_name",
        "front_right_wheel_command_joint_name", "rear_right_wheel_command_joint_name",
        "rear_left_wheel_command_joint_name"}) {
    add(key, {"velocity"});
  }
  for (const std::string_view key : {"steering_joints_names", "steering_joint_name"}) {
    add(key, {"position"});
  }
  const bool steers_behind = text_of(controller.parameter("front_steering")) == "false";
  add("rear_wheels_names", {steers_behind ? "position" : "velocity"});
  add("front_wheels_names", {steers_behind ? "velocity" : "position"});
  return claims;
}

/// Finds a joint by its name in a file of controllers. The name may begin with `$(var prefix)`, a
/// launch argument that is usually empty. Null if there is no such joint.
const urdf::Joint* joint_named(const LinkedModel& model, std::string_view name) {
  if (const urdf::Joint* joint = model.find_joint(name)) return joint;
  if (!is_placeholder(name) || name.empty()) return nullptr;
  const std::size_t end = name.front() == '$'   ? name.find_first_of(")}")
                          : name.front() == '<' ? name.find('>')
                                                : name.npos;
  return end == name.npos ? nullptr : model.find_joint(name.substr(end + 1));
}

/// The interfaces by which ros2_control of the robot can command a joint.
using Declared = std::map<std::string_view, std::set<std::string_view>>;

Declared declared_interfaces(const LinkedModel& model) {
  Declared declared;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View system(model.robot->document, id);
    if (system.name() != "ros2_control") continue;
    for (const xml::View joint : system) {
      const xml::Attribute* name = joint.name() == "joint" ? joint.attribute("name") : nullptr;
      if (name == nullptr) continue;
      for (const xml::View part : joint) {
        const xml::Attribute* interface =
            part.name() == "command_interface" ? part.attribute("name") : nullptr;
        if (interface != nullptr) declared[name->value()].insert(interface->value());
      }
    }
  }
  return declared;
}

std::optional<double> above_zero(yaml::View gains, std::string_view key) {
  const yaml::View value = gains ? gains.find(key) : yaml::View();
  const auto number = value && value.is_scalar() ? value.number() : std::nullopt;
  constexpr double kMost = 1e12;
  return number && *number > 0 && *number < kMost ? number : std::nullopt;
}

/// The kind and the gains of a motor for an interface that a controller commands.
ControlledJoint controlled_joint(const RosController& controller, const std::string& joint,
                                 std::string_view interface) {
  ControlledJoint one{.kind = interface == "position"   ? MotorKind::position
                              : interface == "velocity" ? MotorKind::velocity
                                                        : MotorKind::effort,
                      .kp = {},
                      .kv = {},
                      .controller = std::string(controller.name),
                      .file = {}};
  if (one.kind != MotorKind::effort) return one;
  const yaml::View all = controller.parameter("gains");
  const yaml::View gains = all && all.is_mapping() ? all.find(joint) : yaml::View();
  if (!gains || !gains.is_mapping()) return one;
  const std::vector<yaml::View> followed = controller.list("reference_and_state_interfaces");
  if (!followed.empty() && followed.front().text() == "velocity") {
    one.kv = above_zero(gains, "p");
    if (one.kv) one.kind = MotorKind::velocity;
    return one;
  }
  one.kp = above_zero(gains, "p");
  if (!one.kp) return one;
  one.kind = MotorKind::position;
  one.kv = above_zero(gains, "d");
  return one;
}

std::string_view noun_of(const ControlledJoint& one) {
  switch (one.kind) {
  case MotorKind::velocity: return "speeds";
  case MotorKind::effort: return "efforts";
  default: return "positions";
  }
}

/// Whether a file is tied to the robot, or is near it and has the names of its joints.
bool belongs(const Companion& one) {
  return is_tie(one.evidence) ||
         (one.evidence <= Evidence::dependency && one.known_names > 0 && one.lost_prefix.empty());
}

/// The controllers of one model.
class Chooser {
 public:
  Chooser(const LinkedModel& model, const MotorOptions& motors) : model_(model), motors_(motors) {
    for (const JointDrive& drive : joint_drives(model)) {
      if (drive.motor != nullptr && (drive.kp || drive.kv)) with_gains_.insert(drive.joint);
    }
  }

  /// Those of files that belong to the robot. `declared`: null for a file that the user named,
  /// which decides; the robot must not have its interfaces.
  void take(const Companions& companions, const SourceMap& sources, const Declared* declared) {
    for_each_controller_file(companions, [&](const ControllerFile& file) {
      if (declared != nullptr && !belongs(*file.companion)) return;
      for (const RosController& controller : file.controllers) {
        if (controller.section) {
          take(controller, sources.path(file.companion->source), declared);
        }
      }
    });
  }

  bool has_found_joints() const { return has_found_joints_; }
  bool is_empty() const { return found_.empty(); }

  void report(DiagnosticSink& sink) const {
    const Span place{model_.robot->document.source, 0, 0};
    std::map<std::string, std::string> files;  // what is commanded
    for (const auto& [key, count] : used_) {
      const auto& [file, controller, what] = key;
      std::string& text = files[file];
      text += (text.empty() ? "" : ", ") + quoted(controller) + " commands " + what + " of " +
              counted(count, "joint");
    }
    for (const auto& [file, text] : files) {
      Diagnostic& said =
          sink.report(rules::sml8212_chosen_value, place,
                      "motors of " + quoted(model_.path) + " follow " + quoted(file) + ": " + text);
      said.help("--actuator, --kp and --kv override it, and --controllers none ignores it");
      for (const auto& [other, count] : unused_) {
        if (other.first != file) continue;
        said.note(other.second + " " + counted(count, "joint") +
                  "; the first controller of a joint counts");
      }
    }
  }

  ControlledJoints found() && { return std::move(found_); }

 private:
  void take(const RosController& controller, const std::string& file, const Declared* declared) {
    for (const Claim& claim : claims_of(controller)) {
      const urdf::Joint* joint = joint_named(model_, claim.joint);
      if (joint == nullptr || !joint->has_one_axis() || joint->mimic) continue;
      has_found_joints_ = true;
      const std::string_view interface = interface_for(claim, *joint->name, declared);
      if (interface.empty() || with_gains_.contains(joint)) continue;
      ControlledJoint one = controlled_joint(controller, claim.joint, interface);
      one.file = file;
      // The caller chooses the kind: gains of another kind are of no use.
      const bool has_gains = one.kp || one.kv;
      const bool is_free =
          motors_.kind == MotorKind::as_written || motors_.kind == MotorKind::automatic;
      if (!is_free && (motors_.kind != one.kind || !has_gains)) continue;
      const std::string what = std::string(noun_of(one)) + (has_gains ? ", with its gains," : "");
      const auto [first, is_new] = found_.try_emplace(*joint->name, one);
      if (is_new) {
        ++used_[{file, one.controller, what}];
      } else if (first->second.kind != one.kind) {
        ++unused_[{first->second.file,
                   quoted(one.controller) +
                       (first->second.file == file ? "" : " of " + quoted(file)) + " commands " +
                       what + " of"}];
      }
    }
  }

  /// The best interface that the robot has; any, if it does not say which it has. "": none.
  static std::string_view interface_for(const Claim& claim, std::string_view joint,
                                        const Declared* declared) {
    const auto has = declared != nullptr ? declared->find(joint) : Declared::const_iterator();
    if (declared == nullptr || has == declared->end()) return claim.interfaces.front();
    for (const std::string_view one : claim.interfaces) {
      if (has->second.contains(one)) return one;
    }
    return {};
  }

  const LinkedModel& model_;
  const MotorOptions& motors_;
  std::set<const urdf::Joint*> with_gains_;  ///< whose SMURF motors state gains
  ControlledJoints found_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> used_;
  std::map<std::pair<std::string, std::string>, std::size_t> unused_;  ///< by the file that is used
  bool has_found_joints_ = false;
};

}  // namespace

Refusal add_controllers(LoadedScene& loaded, const SceneRequest& request, OwnCompanions& companions,
                        MotorOptions& motors) {
  if (request.controllers == kNoControllers) return {};
  std::optional<Companions> named;
  if (!request.controllers.empty()) {
    auto file = companions.named(request.controllers, CompanionKind::controllers);
    if (file) named.emplace().files.push_back(std::move(*file));
    if (!named) {
      return {"cannot be converted: " + quoted(request.controllers) +
                  " is no parameter file with controllers of ros2_control",
              Refusal::Cause::options};
    }
  }
  bool has_found_joints = false;
  for (const LinkedModel& model : loaded.scene.models) {
    if (!model.robot || model.robot->joints.empty()) continue;
    Chooser chooser(model, motors);
    if (named) {
      chooser.take(*named, companions.sources(), nullptr);
    } else {
      const Declared declared = declared_interfaces(model);
      chooser.take(companions.of(model), companions.sources(), &declared);
    }
    has_found_joints = has_found_joints || chooser.has_found_joints();
    if (chooser.is_empty()) continue;
    chooser.report(loaded.found);
    motors.controlled[&model] = std::move(chooser).found();
  }
  if (named && !has_found_joints) {
    return {"cannot be converted: the controllers in " + quoted(request.controllers) +
                " command no joint of it",
            Refusal::Cause::options};
  }
  return {};
}

}  // namespace smurf
