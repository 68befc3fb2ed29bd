// SPDX-License-Identifier: BSD-3-Clause
#include "link/gazebo_names.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "syntax/xml_values.hpp"

namespace smurf {
namespace {

class Namer {
 public:
  Namer(const LinkedModel& model, const NameOfCollision& name_of)
      : model_(model), name_of_(name_of), kept_(joints_kept_by_gazebo(model)) {
    const std::size_t links = model.robot->links.size();
    for (std::size_t link = 0; link < links; ++link) {
      names_.bodies.push_back(link);
      names_.collisions.emplace_back(model.robot->links[link].collisions.size());
    }
  }

  GazeboNames run() {
    if (model_.tree.roots.empty()) return std::move(names_);
    std::vector<std::size_t> bodies{to_size(model_.tree.roots.front())};
    while (!bodies.empty()) {
      const std::size_t body = bodies.back();
      bodies.pop_back();
      name_body(body, bodies);
    }
    return std::move(names_);
  }

 private:
  /// urdfdom sorts joints by name.
  std::vector<JointIndex> joints_below(std::size_t link) const {
    std::vector<JointIndex> joints = model_.tree.child_joints[link];
    std::stable_sort(joints.begin(), joints.end(), [&](JointIndex a, JointIndex b) {
      return model_.joint(a).name.value_or({}) < model_.joint(b).name.value_or({});
    });
    return joints;
  }

  bool is_merged(const urdf::Joint& joint, std::size_t parent) const {
    return joint.type == urdf::JointType::fixed && joint.name && !kept_.contains(*joint.name) &&
           model_.robot->links[parent].name.value_or({}) != "world";
  }

  /// Names the collisions of all links that become `body`: first its own, then those of each merged
  /// link after those that were merged into that. Appends the bodies below.
  void name_body(std::size_t body, std::vector<std::size_t>& below) {
    struct Step {
      std::size_t link;
      std::vector<JointIndex> joints;
      std::size_t next = 0;
    };
    std::size_t count = 0;
    // A link is named when it is reached: its own collisions precede those merged into it.
    const auto enter = [&](std::size_t link) {
      names_.bodies[link] = body;
      add_names(body, link, count);
      return Step{link, joints_below(link)};
    };
    std::vector<Step> open;
    open.push_back(enter(body));
    while (!open.empty()) {
      Step& step = open.back();
      if (step.next == step.joints.size()) {
        open.pop_back();
        continue;
      }
      const JointIndex joint = step.joints[step.next++];
      const auto& child = model_.tree.joint_child[to_size(joint)];
      if (!child || model_.tree.parent_joint[to_size(*child)] != joint) continue;
      if (is_merged(model_.joint(joint), step.link)) {
        open.push_back(enter(to_size(*child)));
      } else {
        below.push_back(to_size(*child));
      }
    }
  }

  void add_names(std::size_t body, std::size_t link, std::size_t& count) {
    constexpr std::string_view kLump = "_fixed_joint_lump__";
    const std::string body_name = model_.robot->links[body].name.value_or({});
    const urdf::Link& part = model_.robot->links[link];
    for (std::size_t i = 0; i < part.collisions.size(); ++i) {
      std::string name = name_of_ ? name_of_(link, i) : part.collisions[i].name.value_or({});
      if (name.empty()) name = part.name.value_or({});
      name += "_collision";
      if (count > 0) name += "_" + std::to_string(count);
      ++count;
      if (!name.starts_with(body_name)) name = body_name + std::string(kLump) + name;
      names_.collisions[link][i] = std::move(name);
    }
  }

  const LinkedModel& model_;
  const NameOfCollision& name_of_;
  std::set<std::string_view> kept_;
  GazeboNames names_;
};

}  // namespace

bool is_set_for_gazebo(xml::View flag) {
  const xml::Attribute* value = flag.attribute("value");
  const std::string text = path::to_lower(trimmed(value != nullptr ? value->value() : flag.text()));
  return text == "true" || text == "yes" || text == "1";
}

std::set<std::string_view> joints_kept_by_gazebo(const LinkedModel& model) {
  std::set<std::string_view> kept;
  if (!model.robot) return kept;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    const xml::Attribute* joint = gazebo.attribute("reference");
    if (gazebo.name() != "gazebo" || joint == nullptr) continue;
    for (const xml::View flag : gazebo) {
      const bool is_about_fixed_joints =
          flag.name() == "preserveFixedJoint" || flag.name() == "disableFixedJointLumping";
      if (is_about_fixed_joints && is_set_for_gazebo(flag)) kept.insert(joint->value());
    }
  }
  return kept;
}

GazeboNames gazebo_names(const LinkedModel& model, const NameOfCollision& name_of) {
  return model.robot ? Namer(model, name_of).run() : GazeboNames();
}

std::vector<ContactName> contact_names(const LinkedModel& model) {
  std::vector<ContactName> found;
  if (!model.robot) return found;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    const auto link = model.link_names.find(attribute_of(gazebo, "reference"));
    if (!link) continue;
    for (const xml::View sensor : gazebo) {
      if (sensor.name() != "sensor") continue;
      for (const xml::View contact : sensor) {
        if (contact.name() != "contact") continue;
        for (const xml::View collision : contact) {
          if (collision.name() != "collision") continue;
          found.push_back({collision, std::string(trimmed(collision.text())), *link});
        }
      }
    }
  }
  return found;
}

std::optional<CollisionPlace> find_collision(const GazeboNames& names, std::size_t link,
                                             std::string_view name) {
  const std::size_t body = names.bodies[link];
  for (std::size_t i = 0; i < names.bodies.size(); ++i) {
    if (names.bodies[i] != body) continue;
    for (std::size_t k = 0; k < names.collisions[i].size(); ++k) {
      if (names.collisions[i][k] == name) return CollisionPlace{i, k};
    }
  }
  return std::nullopt;
}

}  // namespace smurf
