// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/joint_order.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include "base/findings/readers.hpp"
#include "link/mujoco_compiler.hpp"

namespace smurf {
namespace {

constexpr std::string_view kWorld = "world";

/// A walk through the tree, and how the reader makes joints and bodies of it. Every row was
/// compared with the reader, see tests/verdicts/joint_order_test.py.
struct OrderRow {
  enum class Siblings { as_in_file, by_name };
  enum class Bodies {
    all,            ///< in the order of the walk
    without_world,  ///< without a root that is named `world`
    in_file_order,  ///< in the order of the file, without a root that is named `world`
    merged,         ///< the world instead of the root, and the children of movable joints
  };
  const Reader* reader;
  std::string_view basis;
  Siblings siblings;
  Bodies bodies;
  bool has_fixed = false;     ///< fixed joints have indices, too
  std::size_t first = 0;      ///< the first index
  bool has_base = false;      ///< the joint of a root that is not named `world` has the first index
  bool indexes_file = false;  ///< the indices are places in the file
  bool splits_planar = false;  ///< a planar joint becomes three
  bool fixes_floating = false;
};

using enum OrderRow::Siblings;
using enum OrderRow::Bodies;

constexpr OrderRow kRows[] = {
    {.reader = &readers::pybullet,
     .basis = "PyBullet 3.2.7, executed; the indices count fixed joints",
     .siblings = as_in_file,
     .bodies = all,
     .has_fixed = true,
     .fixes_floating = true},
    {.reader = &readers::dart,
     .basis =
         "DART 6.20.0, executed; the indices count fixed joints, and that of the root, which is "
         "free unless it is named `world`",
     .siblings = by_name,
     .bodies = without_world,
     .has_fixed = true,
     .has_base = true},
    {.reader = &readers::mujoco,
     .basis = "MuJoCo 2.3.7, 3.1.6, 3.3.7 and 4.0.0, executed",
     .siblings = as_in_file,
     .bodies = merged,
     .splits_planar = true},
    {.reader = &readers::drake,
     .basis =
         "Drake 1.51.1, executed; the indices count fixed joints, and are those in the order of "
         "the file; the root is free, with positions before these, unless it is named `world`",
     .siblings = as_in_file,
     .bodies = in_file_order,
     .indexes_file = true},
    {.reader = &readers::pinocchio,
     .basis = "Pinocchio 4.1.0, executed; the joint of index 0 is that of the universe",
     .siblings = by_name,
     .bodies = all,
     .first = 1},
    {.reader = &readers::newton,
     .basis = "Newton 1.8.0, executed; the indices count fixed joints, and begin with the base",
     .siblings = as_in_file,
     .bodies = all,
     .has_fixed = true,
     .first = 1},
};

constexpr std::string_view kNoTree =
    "not known, because the links are not one tree; repair the errors that smurf-lint reports";
constexpr std::string_view kSeparateTrees =
    "not known, because Drake makes a separate tree of what is below a floating joint";
constexpr std::string_view kIgnoresParts =
    "not known, because `drake_ignore` leaves out parts of the robot";
constexpr std::string_view kCarriesNames =
    "not executed; programs of ROS and Gazebo exchange joints by name";
constexpr std::string_view kNeedsCard =
    "not executed, because it needs a graphics card; print `robot.joint_names` in Isaac Lab";
constexpr std::string_view kNotRun = "not executed";

/// Releases build the same as their reader.
const OrderRow* find_row(const Reader& reader) {
  const auto* const row =
      std::find_if(std::begin(kRows), std::end(kRows), [&](const OrderRow& one) {
        return one.reader == &reader || (!reader.parts.empty() && one.reader == reader.like);
      });
  return row == std::end(kRows) ? nullptr : row;
}

std::string_view why_unknown(const Reader& reader) {
  const auto is_of = [&](const Reader& one) { return &reader == &one || reader.like == &one; };
  if (is_of(readers::isaac)) return kNeedsCard;
  const bool is_of_ros = is_of(readers::ros) || is_of(readers::gazebo) || is_of(readers::moveit) ||
                         is_of(readers::ros2_control);
  return is_of_ros ? kCarriesNames : kNotRun;
}

/// "" if the order is known.
std::string_view why_unknown_in_drake(const LinkedModel& model) {
  for (const urdf::Joint& joint : model.robot->joints) {
    if (joint.type == urdf::JointType::floating) return kSeparateTrees;
  }
  for (const xml::View element : model.robot->document.view()) {
    if (element.attribute("drake_ignore") != nullptr) return kIgnoresParts;
  }
  return "";
}

bool is_one_tree(const LinkedModel& model) {
  if (!model.robot || model.tree.roots.size() != 1) return false;
  const urdf::Robot& robot = *model.robot;
  return model.tree.order.size() == robot.links.size() &&
         robot.joints.size() + 1 == robot.links.size() &&
         model.link_names.names().size() == robot.links.size() &&
         model.joint_names.names().size() == robot.joints.size() &&
         std::none_of(robot.joints.begin(), robot.joints.end(), [](const urdf::Joint& joint) {
           return joint.type == urdf::JointType::unknown;
         });
}

/// All joints, parents before children, depth first.
std::vector<JointIndex> walk(const LinkedModel& model, OrderRow::Siblings siblings) {
  std::vector<JointIndex> order, open;
  const auto add_joints_of = [&](LinkIndex link) {
    std::vector<JointIndex> joints = model.tree.child_joints[to_size(link)];
    if (siblings == by_name) {
      std::sort(joints.begin(), joints.end(), [&](JointIndex a, JointIndex b) {
        return *model.joint(a).name < *model.joint(b).name;
      });
    }
    open.insert(open.end(), joints.rbegin(), joints.rend());
  };
  add_joints_of(model.tree.roots.front());
  while (!open.empty()) {
    const JointIndex joint = open.back();
    open.pop_back();
    order.push_back(joint);
    add_joints_of(*model.tree.joint_child[to_size(joint)]);
  }
  return order;
}

std::string name_of(const LinkedModel& model, LinkIndex link) { return *model.link(link).name; }

void add_bodies(const LinkedModel& model, const OrderRow& row, const std::vector<JointIndex>& walk,
                std::vector<std::string>& bodies) {
  const LinkIndex root = model.tree.roots.front();
  const bool is_merged = row.bodies == merged && fuses_fixed_links(model);
  if (row.bodies == merged) bodies.emplace_back(kWorld);
  if (row.bodies == in_file_order) {
    for (const urdf::Link& link : model.robot->links) {
      if (*link.name != kWorld) bodies.push_back(*link.name);
    }
    return;
  }
  const bool has_root = row.bodies == all || name_of(model, root) != kWorld;
  if (has_root && !is_merged) bodies.push_back(name_of(model, root));
  for (const JointIndex joint : walk) {
    if (is_merged && model.joint(joint).type == urdf::JointType::fixed) continue;
    bodies.push_back(name_of(model, *model.tree.joint_child[to_size(joint)]));
  }
}

void add_joints(const LinkedModel& model, const OrderRow& row, const std::vector<JointIndex>& walk,
                JointOrder& order) {
  const bool is_on_world = name_of(model, model.tree.roots.front()) == kWorld;
  std::size_t next = row.first + (row.has_base && !is_on_world ? 1 : 0);
  for (const JointIndex index : walk) {
    const urdf::Joint& joint = model.joint(index);
    const bool is_fixed = joint.type == urdf::JointType::fixed ||
                          (row.fixes_floating && joint.type == urdf::JointType::floating);
    if (is_fixed) {
      if (row.has_fixed) ++next;
      continue;
    }
    const bool is_split = row.splits_planar && joint.type == urdf::JointType::planar;
    const std::vector<std::string> endings =
        is_split ? std::vector<std::string>{"_TX", "_TY", "_RZ"} : std::vector<std::string>{""};
    for (const std::string& ending : endings) {
      order.joints.push_back(*joint.name + ending);
      order.indices.push_back(row.indexes_file ? to_size(index) : next++);
    }
  }
}

}  // namespace

JointOrder joint_order(const LinkedModel& model, const Reader& reader) {
  JointOrder order;
  order.reader = &reader;
  order.basis = why_unknown(reader);
  const OrderRow* row = find_row(reader);
  if (row == nullptr) return order;
  order.basis = kNoTree;
  if (!is_one_tree(model)) return order;
  if (row->reader == &readers::drake) {
    order.basis = why_unknown_in_drake(model);
    if (!order.basis.empty()) return order;
  }
  order.is_known = true;
  order.basis = row->basis;
  order.walk = row->siblings == by_name ? "depth first, the joints of a link by name"
                                        : "depth first, the joints of a link as in the file";
  const std::vector<JointIndex> walked = walk(model, row->siblings);
  add_joints(model, *row, walked, order);
  add_bodies(model, *row, walked, order.bodies);
  return order;
}

std::vector<const Reader*> readers_with_joint_order() {
  std::vector<const Reader*> readers;
  for (const Reader* reader : all_readers()) {
    if (find_row(*reader) != nullptr) readers.push_back(reader);
  }
  return readers;
}

std::vector<std::optional<std::size_t>> permutation(std::span<const std::string> from,
                                                    std::span<const std::string> to) {
  std::map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < from.size(); ++i) places.emplace(from[i], i);
  std::vector<std::optional<std::size_t>> found;
  for (const std::string& name : to) {
    const auto place = places.find(name);
    found.push_back(place == places.end() ? std::nullopt : std::optional(place->second));
  }
  return found;
}

}  // namespace smurf
