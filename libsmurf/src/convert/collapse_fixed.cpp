// SPDX-License-Identifier: BSD-3-Clause
// Links on fixed joints become part of the link that carries them: shapes move with their poses,
// masses are combined about the common centre of mass, joints move to the carrying link.
#include <algorithm>
#include <set>

#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "convert/link_references.hpp"
#include "convert/mass_properties.hpp"
#include "convert/passes.hpp"

namespace smurf::passes {
namespace {

class Collapse {
 public:
  Collapse(const LinkedModel& model, const std::vector<std::string>& keep, XmlEdits& edits)
      : model_(model), keep_(keep.begin(), keep.end()), references_(model), edits_(edits) {}

  std::vector<CollapsedLink> run() {
    const std::size_t count = model_.robot->links.size();
    carrier_.resize(count);
    X_CL_.resize(count);
    bodies_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      carrier_[i] = i;
      bodies_[i] = mass_properties(model_.robot->links[i]);
    }
    parents_.resize(count);
    for (const auto& child : model_.tree.joint_child) {
      if (child) ++parents_[to_size(*child)];
    }
    for (const LinkIndex index : model_.tree.order) place(to_size(index));
    std::vector<CollapsedLink> collapsed;
    for (const LinkIndex index : model_.tree.order) {
      const std::size_t link = to_size(index);
      if (carrier_[link] == link) continue;
      move(link);
      collapsed.push_back({name_of(link), name_of(carrier_[link])});
    }
    for (const std::size_t carrier : heavier_) write_inertial(carrier);
    return collapsed;
  }

 private:
  std::string name_of(std::size_t link) const {
    return model_.robot->links[link].name.value_or("");
  }

  bool is_kept(const Field<std::string>& name) const {
    return name && (keep_.contains(*name) || references_.needs(*name));
  }

  /// The parent has been handled before.
  bool may_collapse(const urdf::Link& link, const urdf::Joint& joint, std::size_t parent) const {
    if (joint.type != urdf::JointType::fixed || is_kept(link.name) || is_kept(joint.name)) {
      return false;
    }
    if (is_world(name_of(parent))) return false;  // no link is merged into it
    return references_.may_join(link, model_.robot->links[carrier_[parent]]);
  }

  void place(std::size_t link) {
    const auto parent_joint = model_.tree.parent_joint[link];
    if (!parent_joint || parents_[link] > 1) return;  // such a link is an error; it stays separate
    const std::size_t parent = to_size(*model_.tree.joint_parent[to_size(*parent_joint)]);
    if (!may_collapse(model_.robot->links[link], model_.joint(*parent_joint), parent)) return;
    carrier_[link] = carrier_[parent];
    X_CL_[link] = X_CL_[parent] * urdf::to_pose(model_.joint(*parent_joint).origin);
    if (bodies_[link].mass == 0 && bodies_[link].inertia.isZero(0)) return;
    const std::size_t carrier = carrier_[link];
    bodies_[carrier] = combined(bodies_[carrier], transformed(bodies_[link], X_CL_[link]));
    heavier_.insert(carrier);
  }

  void move(std::size_t index) {
    const urdf::Link& link = model_.robot->links[index];
    const xml::View carrier = edits_.view(model_.robot->links[carrier_[index]].element);
    for (const urdf::Visual& visual : link.visuals) {
      edits_.add_child(carrier, moved(visual.element, visual.origin, X_CL_[index]));
    }
    for (const urdf::Collision& collision : link.collisions) {
      edits_.add_child(carrier, moved(collision.element, collision.origin, X_CL_[index]));
    }
    for (const JointIndex child : model_.tree.child_joints[index]) {
      const auto link_of_child = model_.tree.joint_child[to_size(child)];
      if (link_of_child && carrier_[to_size(*link_of_child)] == to_size(*link_of_child)) {
        rehang(model_.joint(child), index);
      }
    }
    references_.move(name_of(index), name_of(carrier_[index]), X_CL_[index], edits_);
    edits_.remove(edits_.view(link.element));
    edits_.remove(edits_.view(model_.joint(*model_.tree.parent_joint[index]).element));
  }

  void rehang(const urdf::Joint& joint, std::size_t old_parent) {
    const xml::View element = edits_.view(joint.element);
    edits_.set_attribute(element.child("parent"), "link",
                         *model_.robot->links[carrier_[old_parent]].name);
    const Edit edit =
        edits_.origin_edit(element, joint.origin, X_CL_[old_parent] * urdf::to_pose(joint.origin));
    edits_.replace(edit.span, edit.text);
  }

  /// The element's text with its pose in the carrier's frame.
  std::string moved(xml::ElementId id, const urdf::Origin& origin, const Pose& X_CL) const {
    const xml::View element = edits_.view(id);
    return edits_.copy(element,
                       {edits_.origin_edit(element, origin, X_CL * urdf::to_pose(origin))});
  }

  void write_inertial(std::size_t index) {
    const MassProperties& body = bodies_[index];
    const urdf::Link& link = model_.robot->links[index];
    const Eigen::Matrix3d& I = body.inertia;
    const auto number = [](double value) { return format_number(value); };
    const std::string text =
        "<inertial>\n  " +
        new_element("origin",
                    {{"xyz", numbers_text({body.center.x(), body.center.y(), body.center.z()})},
                     {"rpy", "0 0 0"}}) +
        "\n  " + new_element("mass", {{"value", number(body.mass)}}) + "\n  " +
        new_element("inertia", {{"ixx", number(I(0, 0))},
                                {"ixy", number(I(0, 1))},
                                {"ixz", number(I(0, 2))},
                                {"iyy", number(I(1, 1))},
                                {"iyz", number(I(1, 2))},
                                {"izz", number(I(2, 2))}}) +
        "\n</inertial>";
    if (link.inertial) {
      edits_.replace_element(edits_.view(link.inertial->element), text);
    } else {
      edits_.add_child(edits_.view(link.element), text);
    }
  }

  const LinkedModel& model_;
  std::set<std::string_view> keep_;
  LinkReferences references_;
  XmlEdits& edits_;
  std::vector<std::size_t> parents_;    ///< by link: the joints of which it is the child
  std::vector<std::size_t> carrier_;    ///< by link
  std::vector<Pose> X_CL_;              ///< by link, in its carrier's frame
  std::vector<MassProperties> bodies_;  ///< by link, with all links that it carries
  std::set<std::size_t> heavier_;
};

}  // namespace

std::vector<CollapsedLink> collapse_fixed(const LinkedModel& model,
                                          const std::vector<std::string>& keep, XmlEdits& edits) {
  return Collapse(model, keep, edits).run();
}

}  // namespace smurf::passes
