// SPDX-License-Identifier: BSD-3-Clause
#include "write/usd/usd_physics.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "write/parts/body_inertia.hpp"

namespace smurf {
namespace {

/// USD has angles in degrees, and the stiffness of a drive per degree.
constexpr double kDegrees = 180 / std::numbers::pi;

bool is_linear(const urdf::Joint& joint) { return joint.type == urdf::JointType::prismatic; }
double unit_of(const urdf::Joint& joint) { return is_linear(joint) ? 1 : kDegrees; }

Vector3 unit_axis(const urdf::Joint& joint) {
  Vector3 axis = joint.axis.value_or({1, 0, 0});
  const double length = hypotenuse(axis[0], axis[1], axis[2]);
  if (!(length > 0) || !std::isfinite(length)) return {1, 0, 0};
  for (double& component : axis) component /= length;
  return axis;
}

/// A frame whose x axis is the axis of a joint, relative to the frame of the joint.
Pose axis_frame(const urdf::Joint& joint) {
  return {{}, rotation_onto({1, 0, 0}, unit_axis(joint))};
}

std::string rel(const std::string& name, const std::string& path) {
  return "rel " + name + " = <" + path + ">";
}

using Followers = std::map<const urdf::Joint*, DrivenFollower>;

/// Makes each joint follow the end of its chain of leaders, because PhysX does not support chains.
/// In a cycle, leaders stay followers.
void skip_leaders(Followers& followers) {
  std::set<const urdf::Joint*> seen;
  std::set<const urdf::Joint*> done;
  for (const auto& [joint, follower] : followers) {
    std::vector<Followers::iterator> chain;
    for (auto at = followers.find(joint); at != followers.end() && seen.insert(at->first).second;
         at = followers.find(at->second.leader)) {
      chain.push_back(at);
    }
    while (!chain.empty()) {
      DrivenFollower& last = chain.back()->second;
      if (done.contains(last.leader)) {
        const DrivenFollower& next = followers.at(last.leader);
        last.offset += last.multiplier * next.offset;
        last.multiplier *= next.multiplier;
        last.leader = next.leader;
      }
      done.insert(chain.back()->first);
      chain.pop_back();
    }
  }
}

}  // namespace

namespace {

using JointRange = std::pair<double, double>;

std::optional<JointRange> limits_of(const urdf::Joint& joint) {
  if (joint.type == urdf::JointType::continuous || !joint.limit) return std::nullopt;
  const JointRange limits{joint.limit->lower.value_or(0), joint.limit->upper.value_or(0)};
  return limits.first <= limits.second ? std::optional(limits) : std::nullopt;
}

/// Those that follow from the limits of the leader.
std::optional<JointRange> limits_of_follower(const DrivenFollower& follower) {
  const auto leader = limits_of(*follower.leader);
  if (!leader) return std::nullopt;
  const double first = leader->first * follower.multiplier + follower.offset;
  const double second = leader->second * follower.multiplier + follower.offset;
  return JointRange{std::min(first, second), std::max(first, second)};
}

}  // namespace

const UsdPhysics::Model& UsdPhysics::model_of(std::size_t instance) {
  const LinkedModel& robot = this->robot(instance);
  const auto [known, is_new] = models_.try_emplace(&robot);
  Model& model = known->second;
  if (!is_new) return model;
  model.layout = usd_layout(robot);
  find_joints(robot, model);
  for (const JointDrive& drive : joint_drives(robot, scene_.motors))
    model.drives.emplace(drive.joint, drive);
  find_followers(robot, model);
  return model;
}

void UsdPhysics::find_joints(const LinkedModel& robot, Model& model) {
  const KinematicTree& tree = robot.tree;
  UniqueNames names;
  for (std::size_t i = 0; i < robot.robot->joints.size(); ++i) {
    const auto child = carried_link(robot, i);
    if (!tree.joint_parent[i] || !child || !model.layout.is_body(*child)) continue;
    const UsdLink& on = *model.layout.links[to_size(*tree.joint_parent[i])];
    const urdf::Joint& joint = robot.robot->joints[i];
    model.index.emplace(&joint, model.joints.size());
    model.joints.push_back({&joint, on.body, *child, on.X_BL * urdf::to_pose(joint.origin),
                            names.add(safe_name(joint.name.value_or({})))});
  }
  model.anchor = names.add("anchor");
  model.own_collisions = names.add("own_collisions");
}

std::size_t UsdPhysics::robots_with_joints(std::size_t instance) {
  if (bases_.empty()) find_bases();
  return robots_with_joints_[bases_[instance]];
}

void UsdPhysics::find_bases() {
  const std::size_t count = scene_.flat.instances.size();
  robots_with_joints_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t base = i;
    for (std::size_t steps = 0; carrying_link(base) != nullptr && steps < count; ++steps) {
      base = scene_.flat.instances[base].anchor.index;
    }
    bases_.push_back(base);
    const bool has_joints = robot_of(scene_.scene, i) != nullptr && !model_of(i).joints.empty();
    if (has_joints) ++robots_with_joints_[base];
  }
}

const UsdLink* UsdPhysics::carrying_link(std::size_t instance) {
  const FlatInstance& flat = scene_.flat.instances[instance];
  if (flat.anchor.kind != Attachment::Kind::link || !flat.X_WE) return nullptr;
  if (robot_of(scene_.scene, instance) == nullptr && !is_body(instance)) return nullptr;
  const std::optional<std::size_t> link = anchor_link(scene_, instance);
  if (!link) return nullptr;
  const auto& on = layout_of(flat.anchor.index).links[*link];
  return on ? &*on : nullptr;
}

bool UsdPhysics::is_articulation(std::size_t instance) {
  return robots_with_joints(instance) > 0 && bases_[instance] == instance;
}

void UsdPhysics::find_followers(const LinkedModel& robot, Model& model) {
  for (const urdf::Joint& joint : robot.robot->joints) {
    if (!joint.mimic || !joint.has_one_axis()) continue;
    const urdf::Joint* leader =
        joint.mimic->joint ? robot.find_joint(*joint.mimic->joint) : nullptr;
    model.followers.emplace(&joint,
                            DrivenFollower{&joint, leader, joint.mimic->multiplier.value_or(1),
                                           joint.mimic->offset.value_or(0)});
  }
  for (const DrivenFollower& follower : driven_followers(robot)) {
    model.followers.emplace(follower.joint, follower);
  }
  skip_leaders(model.followers);
}

void UsdPhysics::number(const std::string& name, double value) {
  if (std::isfinite(value)) text_.line("float " + name + " = " + format_number(value));
}

void UsdPhysics::add_scene() {
  const Vector3 g = scene_.flat.physics.gravity.value_or(kUsualGravity);
  const double magnitude = hypotenuse(g[0], g[1], g[2]);
  text_.open("PhysicsScene", "Physics");
  if (magnitude > 0) {
    text_.line("vector3f physics:gravityDirection = " +
               UsdaText::tuple({g[0] / magnitude, g[1] / magnitude, g[2] / magnitude}));
  }
  number("physics:gravityMagnitude", magnitude);
  text_.close();
}

std::vector<std::string> UsdPhysics::schemas_of_robot(std::size_t instance) {
  if (!is_articulation(instance)) return {};
  return {"PhysicsArticulationRootAPI", "PhysxArticulationAPI"};
}

void UsdPhysics::add_articulation(std::size_t instance) {
  if (!is_articulation(instance)) return;
  // Without a choice, nothing in a robot touches: the convex hulls of neighbours overlap. NVIDIA's
  // importer of URDFs writes the same. Robots that are fixed to each other do collide;
  // add_own_collisions() leaves out what is within one.
  const bool can_touch = has_own_contacts() || robots_with_joints(instance) > 1;
  text_.line(std::string("bool physxArticulation:enabledSelfCollisions = ") +
             (can_touch ? "1" : "0"));
}

/// A group that does not collide with itself.
void UsdPhysics::add_own_collisions(std::size_t instance) {
  const Model& model = model_of(instance);
  text_.open("PhysicsCollisionGroup", model.own_collisions, {"CollectionAPI:colliders"});
  text_.line(rel("collection:colliders:includes", path(instance)));
  text_.line(rel("physics:filteredGroups",
                 path(instance) + "/" + model.layout.joints + "/" + model.own_collisions));
  text_.close();
}

bool UsdPhysics::is_body(std::size_t instance) const {
  const FlatInstance& flat = scene_.flat.instances[instance];
  return !flat.shapes.empty() && is_movable(flat);
}

void UsdPhysics::add_mass(std::size_t instance, std::size_t link) {
  const urdf::Link& written = robot(instance).robot->links[link];
  const ChosenMass mass = link_mass(scene_, robot(instance), written);
  const bool is_root = link == to_size(robot(instance).tree.roots.front());
  const bool is_held =
      is_root && scene_.flat.instances[instance].anchor.kind == Attachment::Kind::world;
  const bool is_said = mass.chosen != kInventedMasses || !is_held;
  if (!mass.chosen.empty() && is_said) {
    losses_.note(mass.chosen, written.span, written.name.value_or({}));
  }
  write_mass(mass.mass, written.span, written.name.value_or({}));
}

void UsdPhysics::add_mass(std::size_t instance) {
  const FlatInstance& flat = scene_.flat.instances[instance];
  const FlatShape& shape = flat.shapes.front();
  LinkInertial mass = solid_mass(shape.geometry, mass_of(flat));
  mass.X_LC = shape.X_ES;
  write_mass(mass, place_of(*scene_.flat.instances[instance].entity), flat.path);
}

void UsdPhysics::write_mass(const LinkInertial& mass, Span span, const std::string& name) {
  // USD computes moments of 0 from the shapes. This is the smallest value in MJCF.
  constexpr double kLeast = 1e-14;
  const BodyInertia body = principal_inertia(mass, kLeast);
  if (body.is_changed) losses_.note(kRefusedInertias, span, name);
  const LinkInertial& given = body.mass;
  number("physics:mass", given.mass);
  text_.line("point3f physics:centerOfMass = " + UsdaText::tuple(given.X_LC.position));
  text_.line("float3 physics:diagonalInertia = " +
             UsdaText::tuple({given.ixx, given.iyy, given.izz}));
  text_.line("quatf physics:principalAxes = " + UsdaText::tuple(given.X_LC.orientation));
}

void UsdPhysics::open_joint(std::string_view type, const std::string& name,
                            const std::vector<std::string>& schemas, const Ends& ends) {
  text_.open(type, name, schemas);
  if (!ends.body0.empty()) text_.line(rel("physics:body0", ends.body0));
  text_.line(rel("physics:body1", ends.body1));
  // What is fixed to each other cannot move apart.
  if (scene_.contacts.choice == SelfCollision::all && type != "PhysicsFixedJoint") {
    text_.line("bool physics:collisionEnabled = 1");
  }
  text_.line("point3f physics:localPos0 = " + UsdaText::tuple(ends.X_0J.position));
  text_.line("quatf physics:localRot0 = " + UsdaText::tuple(ends.X_0J.orientation));
  text_.line("point3f physics:localPos1 = " + UsdaText::tuple(ends.X_1J.position));
  text_.line("quatf physics:localRot1 = " + UsdaText::tuple(ends.X_1J.orientation));
}

std::optional<UsdPhysics::Ends> UsdPhysics::anchor_of(std::size_t i, LinkFrames& frames) {
  const FlatInstance& instance = scene_.flat.instances[i];
  const FlatAttachment& anchor = instance.anchor;
  const bool has_robot = robot_of(scene_.scene, i) != nullptr;
  if (anchor.kind == Attachment::Kind::none || (!has_robot && !is_body(i))) return std::nullopt;
  const std::string body1 = has_robot ? path(i, to_size(robot(i).tree.roots.front())) : path(i);
  if (anchor.kind == Attachment::Kind::world) return Ends{"", *instance.X_WE, body1};
  const UsdLink* on = carrying_link(i);
  const std::optional<Pose> X_LE = pose_on_anchor(scene_, i, frames);
  if (on == nullptr || !X_LE) {
    losses_.anchor(i, "there is no link to attach it to");
    return std::nullopt;
  }
  return Ends{path(anchor.index, on->body), on->X_BL * *X_LE, body1};
}

void UsdPhysics::add_anchor(std::size_t instance, LinkFrames& frames, const std::string& name) {
  const std::optional<Ends> ends = anchor_of(instance, frames);
  if (!ends) return;
  open_joint("PhysicsFixedJoint", name, {}, *ends);
  text_.close();
}

void UsdPhysics::add_joints(std::size_t instance, LinkFrames& frames) {
  if (robot_of(scene_.scene, instance) == nullptr) return add_anchor(instance, frames, "anchor");
  const Model& model = model_of(instance);
  const bool is_free = scene_.flat.instances[instance].anchor.kind == Attachment::Kind::none;
  if (is_free && model.joints.empty()) return;
  text_.open("Scope", model.layout.joints);
  add_anchor(instance, frames, model.anchor);
  for (const Joint& joint : model.joints) add_joint(instance, joint);
  const bool has_several = robots_with_joints(instance) > 1 && !model.joints.empty();
  if (has_several && !has_own_contacts()) add_own_collisions(instance);
  text_.close();
}

void UsdPhysics::add_joint(std::size_t i, const Joint& joint) {
  const Ends ends{path(i, joint.body0), joint.X_0J, path(i, joint.body1)};
  const urdf::Joint& urdf = *joint.urdf;
  if (urdf.has_one_axis()) {
    add_axis(i, joint, ends);
  } else if (urdf.type == urdf::JointType::planar || urdf.type == urdf::JointType::floating) {
    add_locked(joint, ends);
  } else {
    if (urdf.type != urdf::JointType::fixed && reported_.insert(&urdf).second) {
      losses_.joint(urdf, "fixed");
    }
    open_joint("PhysicsFixedJoint", joint.name, {}, ends);
  }
  text_.line("custom string smurf:joint = " + UsdaText::quoted(urdf.name.value_or({})));
  text_.close();
}

/// Writes a joint with free axes, except for locked ones, whose limits are swapped.
void UsdPhysics::add_locked(const Joint& joint, Ends ends) {
  std::vector<std::string> locked;
  if (joint.urdf->type == urdf::JointType::planar) {
    ends.X_1J = axis_frame(*joint.urdf);  // x is the normal
    ends.X_0J = ends.X_0J * ends.X_1J;
    locked = {"transX", "rotY", "rotZ"};
  }
  std::vector<std::string> schemas;
  for (const std::string& axis : locked) schemas.push_back("PhysicsLimitAPI:" + axis);
  open_joint("PhysicsJoint", joint.name, schemas, ends);
  for (const std::string& axis : locked) {
    number("limit:" + axis + ":physics:low", 1);
    number("limit:" + axis + ":physics:high", -1);
  }
  // Articulations support joints with one axis only.
  text_.line("uniform bool physics:excludeFromArticulation = 1");
}

void UsdPhysics::add_axis(std::size_t i, const Joint& joint, Ends ends) {
  const urdf::Joint& urdf = *joint.urdf;
  const Model& model = model_of(i);
  ends.X_1J = axis_frame(urdf);
  ends.X_0J = ends.X_0J * ends.X_1J;
  const std::string kind = is_linear(urdf) ? "linear" : "angular";
  const auto found = model.drives.find(&urdf);
  const JointDrive* drive = found == model.drives.end() ? nullptr : &found->second;
  const std::optional<DrivenFollower> follower = leader_of(model, urdf);
  std::vector<std::string> schemas{"PhysicsDriveAPI:" + kind};
  const double speed = drive != nullptr && drive->speed ? *drive->speed
                       : urdf.limit                     ? urdf.limit->velocity.value_or(0)
                                                        : 0;
  const double friction = urdf.dynamics ? urdf.dynamics->friction.value_or(0) : 0;
  const double start = start_of(i, urdf);
  if (start != 0) schemas.push_back("PhysicsJointStateAPI:" + kind);
  if (speed > 0 || friction > 0) schemas.emplace_back("PhysxJointAPI");
  if (follower) schemas.emplace_back("PhysxMimicJointAPI:rotX");
  open_joint(is_linear(urdf) ? "PhysicsPrismaticJoint" : "PhysicsRevoluteJoint", joint.name,
             schemas, ends);
  text_.line("uniform token physics:axis = \"X\"");
  add_limits(urdf, follower);
  add_drive(i, urdf, drive);
  if (start != 0) number("state:" + kind + ":physics:position", start * unit_of(urdf));
  if (drive != nullptr) {
    text_.line("custom string smurf:motor = " + UsdaText::quoted(drive->name));
    if (drive->controller != nullptr) {
      text_.line("custom string smurf:controller = " +
                 UsdaText::quoted(origin_of(*drive->controller)));
    }
  }
  if (speed > 0) number("physxJoint:maxJointVelocity", speed * unit_of(urdf));
  if (friction > 0) number("physxJoint:jointFriction", friction);
  if (follower) add_leader(i, *follower);
}

void UsdPhysics::add_limits(const urdf::Joint& joint,
                            const std::optional<DrivenFollower>& follower) {
  auto limits = limits_of(joint);
  if (!limits && follower) limits = limits_of_follower(*follower);
  if (!limits) return;
  number("physics:lowerLimit", limits->first * unit_of(joint));
  number("physics:upperLimit", limits->second * unit_of(joint));
}

/// Without a motor: a drive with damping only.
void UsdPhysics::add_drive(std::size_t i, const urdf::Joint& joint, const JointDrive* drive) {
  const double unit = unit_of(joint);
  const std::string prefix =
      std::string("drive:") + (is_linear(joint) ? "linear" : "angular") + ":physics:";
  const bool is_position = drive != nullptr && drive->kind == DriveKind::position;
  const DriveGains gains = drive != nullptr ? gains_of(*drive) : DriveGains();
  const double damping = joint.dynamics ? joint.dynamics->damping.value_or(0) : 0;
  const double effort = drive != nullptr && drive->effort ? *drive->effort
                        : joint.limit                     ? joint.limit->effort.value_or(0)
                                                          : 0;
  text_.line("uniform token " + prefix + "type = \"force\"");
  number(prefix + "stiffness", gains.kp / unit);
  number(prefix + "damping", (gains.kv + damping) / unit);
  if (effort > 0) number(prefix + "maxForce", effort);
  if (is_position) number(prefix + "targetPosition", start_of(i, joint) * unit);
}

double UsdPhysics::start_of(std::size_t i, const urdf::Joint& joint) const {
  return start_position(robot(i), joint, scene_.joint_positions(i));
}

/// If there is no leader, reports a finding and returns none.
std::optional<DrivenFollower> UsdPhysics::leader_of(const Model& model, const urdf::Joint& joint) {
  const auto found = model.followers.find(&joint);
  if (found == model.followers.end()) return std::nullopt;
  const DrivenFollower& follower = found->second;
  const bool has_end = follower.leader != nullptr && !model.followers.contains(follower.leader);
  if (has_end && model.index.contains(follower.leader) && follower.leader->has_one_axis() &&
      is_linear(*follower.leader) == is_linear(joint) && follower.multiplier != 0) {
    if (limits_of(joint) || limits_of_follower(follower)) return follower;
    if (reported_.insert(&joint).second) {
      losses_.joint(joint,
                    "free to move, since PhysX needs limits of the follower or of its leader,");
    }
    return std::nullopt;
  }
  if (reported_.insert(&joint).second) {
    losses_.joint(joint, "free to move, since there is no moving leader of the same kind,");
  }
  return std::nullopt;
}

/// PhysX: position + gearing * position of the leader + offset = 0 (PxArticulationMimicJoint.h).
void UsdPhysics::add_leader(std::size_t i, const DrivenFollower& follower) {
  const Model& model = model_of(i);
  const Joint& leader = model.joints[model.index.at(follower.leader)];
  const std::string prefix = "physxMimicJoint:rotX:";
  text_.line(
      rel(prefix + "referenceJoint", path(i) + "/" + model.layout.joints + "/" + leader.name));
  text_.line("uniform token " + prefix + "referenceJointAxis = \"rotX\"");
  number(prefix + "gearing", -follower.multiplier);
  number(prefix + "offset", -follower.offset * unit_of(*follower.joint));
}

}  // namespace smurf
