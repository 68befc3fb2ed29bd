// SPDX-License-Identifier: BSD-3-Clause
// Links on fixed joints become part of the link that carries them: shapes move with their poses,
// masses are added up about the common centre of mass, joints hang on the carrying link.
#include <algorithm>
#include <set>

#include "base/edits.hpp"
#include "base/numbers.hpp"
#include "convert/mass_properties.hpp"
#include "convert/passes.hpp"

namespace smurf::passes {
namespace {

/// Every text and attribute value of an extension that is the name of a link or joint.
void names_in(const LinkedModel& model, xml::View element, std::set<std::string_view>& names) {
  const auto add = [&](std::string_view text) {
    if (model.link_names.contains(text) || model.joint_names.contains(text)) names.insert(text);
  };
  for (const xml::Attribute* one = element.attributes_begin(); one != element.attributes_end();
       ++one) {
    add(one->value);
  }
  add(element.element().text);
  for (const xml::View child : element) names_in(model, child, names);
}

class Collapse {
 public:
  Collapse(const LinkedModel& model, std::string_view text, const std::vector<bool>& kept,
           XmlEdits& edits)
      : model_(model), text_(text), kept_(kept), edits_(edits) {}

  void run() {
    const std::size_t count = model_.robot->links.size();
    carrier_.resize(count);
    X_CL_.resize(count);
    bodies_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      carrier_[i] = i;
      bodies_[i] = mass_properties(model_.robot->links[i]);
    }
    for (const LinkIndex index : model_.tree.order) place(to_size(index));
    for (const LinkIndex index : model_.tree.order) {
      const std::size_t link = to_size(index);
      if (carrier_[link] != link) move(link);
    }
    for (const std::size_t carrier : heavier_) write_inertial(carrier);
  }

 private:
  void place(std::size_t link) {
    const auto parent_joint = model_.tree.parent_joint[link];
    if (kept_[link] || !parent_joint) return;
    const std::size_t parent = to_size(*model_.tree.joint_parent[to_size(*parent_joint)]);
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
    edits_.remove(edits_.view(link.element));
    edits_.remove(edits_.view(model_.joint(*model_.tree.parent_joint[index]).element));
  }

  void rehang(const urdf::Joint& joint, std::size_t old_parent) {
    const xml::View element = edits_.view(joint.element);
    edits_.set_attribute(element.child("parent"), "link",
                         *model_.robot->links[carrier_[old_parent]].name);
    const Pose X_CJ = X_CL_[old_parent] * urdf::to_pose(joint.origin);
    const std::string origin = new_element("origin", origin_attributes(X_CJ));
    if (joint.origin.element == xml::kNoElement) {
      edits_.add_child(element, origin);
    } else {
      edits_.replace(edits_.view(joint.origin.element).span(), origin);
    }
  }

  /// The element's text with its pose in the carrier's frame, without its own indentation.
  std::string moved(xml::ElementId id, const urdf::Origin& origin, const Pose& X_CL) const {
    const xml::View element = edits_.view(id);
    const std::string new_origin =
        new_element("origin", origin_attributes(X_CL * urdf::to_pose(origin)));
    const std::string_view text =
        text_.substr(element.span().begin, element.span().end - element.span().begin);
    Edit edit{element.tag_span(), new_origin};
    edit.span.begin = edit.span.end;
    if (origin.element != xml::kNoElement) {
      edit.span = edits_.view(origin.element).span();
    } else if (element.begin() != element.end()) {  // a line of its own, if the others have one
      const std::uint32_t first_child = (*element.begin()).span().begin;
      const std::string_view blanks = text_.substr(edit.span.end, first_child - edit.span.end);
      const bool is_blank = blanks.find_first_not_of(" \t\r\n") == std::string_view::npos;
      if (is_blank) edit.text = std::string(blanks) + edit.text;
    }
    edit.span.begin -= element.span().begin;
    edit.span.end -= element.span().begin;
    std::size_t line = element.span().begin;
    while (line > 0 && text_[line - 1] != '\n') --line;
    std::string indentation = "\n";
    while (text_[line] == ' ' || text_[line] == '\t') indentation += text_[line++];
    const std::string result = apply_edits(text, {&edit, 1});
    return without(result, indentation);
  }

  /// Line ends with blanks become line ends.
  static std::string without(std::string_view text, std::string_view line_start) {
    std::string result;
    for (std::size_t at = text.find(line_start); at != std::string_view::npos;
         at = text.find(line_start)) {
      result.append(text.substr(0, at)).append("\n");
      text.remove_prefix(at + line_start.size());
    }
    result.append(text);
    std::erase(result, '\r');
    return result;
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
  std::string_view text_;
  const std::vector<bool>& kept_;
  XmlEdits& edits_;
  std::vector<std::size_t> carrier_;    ///< by link
  std::vector<Pose> X_CL_;              ///< by link, in its carrier's frame
  std::vector<MassProperties> bodies_;  ///< by link, with all that it carries
  std::set<std::size_t> heavier_;
};

}  // namespace

std::vector<bool> kept_links(const LinkedModel& model, const std::vector<std::string>& keep) {
  std::set<std::string_view> named(keep.begin(), keep.end());
  for (const xml::View element : extension_elements(*model.robot)) names_in(model, element, named);
  for (const urdf::Joint& joint : model.robot->joints) {
    if (joint.mimic && joint.mimic->joint) named.insert(*joint.mimic->joint);
  }
  std::vector<bool> kept(model.robot->links.size(), true);
  for (const LinkIndex index : model.tree.order) {
    const auto joint_index = model.tree.parent_joint[to_size(index)];
    if (!joint_index) continue;
    const urdf::Joint& joint = model.joint(*joint_index);
    const urdf::Link& link = model.link(index);
    const urdf::Link& parent = model.link(*model.tree.joint_parent[to_size(*joint_index)]);
    const bool is_named =
        (link.name && named.contains(*link.name)) || (joint.name && named.contains(*joint.name));
    // `world` stands for the world in Gazebo and MuJoCo; nothing becomes part of it.
    const bool is_on_world = parent.name && *parent.name == "world";
    kept[to_size(index)] = joint.type != urdf::JointType::fixed || is_named || is_on_world;
  }
  return kept;
}

void collapse_fixed(const LinkedModel& model, std::string_view text, const UrdfExport& options,
                    XmlEdits& edits) {
  const std::vector<bool> kept = kept_links(model, options.keep);
  Collapse(model, text, kept, edits).run();
}

}  // namespace smurf::passes
