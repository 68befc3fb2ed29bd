// SPDX-License-Identifier: BSD-3-Clause
// Names in URDF and SRDF. Sources: the parsers of urdf_reader.cpp; srdfdom model.cpp; extensions as
// read by ros_control, ros2_control, gazebo_ros_pkgs, sdformat (parser_urdf.cc), Drake.
#include <algorithm>

#include "ast/urdf_schema.hpp"
#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "link/extension_names.hpp"
#include "link/reference_finder.hpp"
#include "syntax/xml_values.hpp"

namespace smurf {
namespace {

using Notation = Reference::Notation;

constexpr NameKinds kFrames = NameKind::link | NameKind::joint;

std::uint32_t number_of(xml::View element) { return static_cast<std::uint32_t>(element.id()); }

/// Attributes of extensions whose names do not show what they refer to.
struct AttributeNames {
  std::string_view parent;  ///< "": any
  std::string_view element, attribute;
  Naming names;
  /// A reader needs it; other texts are references only if something has that name.
  bool is_needed = false;
};
constexpr AttributeNames kAttributes[] = {
    {"", "gazebo", "reference", {kFrames}, true},
    {"transmission", "joint", "name", {NameKind::joint}, true},
    {"", "joint", "name", {NameKind::joint}},
    {"", "link", "name", {NameKind::link}},
    {"robot", "passive_joint", "name", {NameKind::joint}},
    {"robot", "virtual_joint", "name", {}},
    {"robot", "group", "name", defines(NameKind::group)},
    {"group", "group", "name", {NameKind::group}},
    {"robot", "group_state", "group", {NameKind::group}},
    {"robot", "end_effector", "group", {NameKind::group}},
    {"robot", "end_effector", "parent_group", {NameKind::group}},
    {"robot", "end_effector", "parent_link", {NameKind::link}},
    {"robot", "virtual_joint", "child_link", {NameKind::link}},
    {"group", "chain", "base_link", {NameKind::link}},
    {"group", "chain", "tip_link", {NameKind::link}},
    {"robot", "disable_collisions", "link1", {NameKind::link}},
    {"robot", "disable_collisions", "link2", {NameKind::link}},
    {"robot", "enable_collisions", "link1", {NameKind::link}},
    {"robot", "enable_collisions", "link2", {NameKind::link}},
    {"robot", "disable_default_collisions", "link", {NameKind::link}},
    {"robot", "link_sphere_approximation", "link", {NameKind::link}},
    {"robot", "joint_property", "joint_name", {NameKind::joint}},
    {"", "", "reference", {kFrames}},
};

const AttributeNames* find_row(std::string_view parent, std::string_view element,
                               std::string_view attribute) {
  for (const AttributeNames& row : kAttributes) {
    if (!is_same(row.attribute, attribute)) continue;
    if (!row.element.empty() && !is_same(row.element, element)) continue;
    if (row.parent.empty() || parent == row.parent) return &row;
  }
  return nullptr;
}

const AttributeNames* find_row(xml::View element, std::string_view attribute) {
  const std::string_view parent = element.parent() ? element.parent().name() : std::string_view();
  return find_row(parent, element.name(), attribute);
}

/// The kinds of things that an attribute may name, guessed from the name of the attribute or of its
/// element: <flexJoint name="...">.
NameKinds kinds_of(xml::View element, std::string_view attribute) {
  if (attribute == "name") {
    if (element.parent() && element.parent().name() == "robot") return {};  // its own name
    return path::to_lower(element.name()).ends_with("joint") ? NameKinds(NameKind::joint)
                                                             : NameKinds();
  }
  const NameKinds kinds = kinds_in_word(attribute);
  return kinds == NameKind::link || kinds == NameKind::joint ? kinds : NameKinds();
}

/// Removes the first `word` in `text` and everything after it.
std::string_view before(std::string_view text, std::string_view word) {
  return text.substr(0, text.find(word));
}

}  // namespace

NameKinds names_in_extension(std::string_view parent, std::string_view element,
                             std::string_view attribute) {
  const AttributeNames* row = find_row(parent, element, attribute);
  return row != nullptr && !row->names.defines ? row->names.kinds : NameKinds();
}

NamePlace place_of_value(xml::View element, const xml::Attribute& attribute) {
  return {Notation::xml_attribute, number_of(element), attribute.value_span(),
          attribute.value_span()};
}

void ReferenceFinder::read_field(const Naming& naming, const Field<std::string>& field,
                                 xml::ElementId element) {
  if (!field || field->empty()) return;
  add(naming, *field,
      {Notation::xml_attribute, static_cast<std::uint32_t>(element), field.span, field.span});
}

/// All materials of a visual, though readers use one.
void ReferenceFinder::read_material(xml::View material) {
  const xml::Attribute* name = material.attribute("name");
  if (name == nullptr || name->value().empty()) return;
  const bool is_defined = material.begin() != material.end() ||
                          !find(NameKind::material, name->value());  // readers ignore it
  add({NameKind::material, is_defined}, name->value(), place_of_value(material, *name));
}

void ReferenceFinder::read_link(const urdf::Link& link) {
  read_field(defines(NameKind::link), link.name, link.element);
  const xml::Document& document = model_.robot->document;
  for (const urdf::Visual& visual : link.visuals) {
    read_field(defines(NameKind::visual), visual.name, visual.element);
    for (const xml::View child : xml::View(document, visual.element)) {
      if (child.name() == "material") read_material(child);
    }
  }
  for (const urdf::Collision& collision : link.collisions) {
    read_field(defines(NameKind::collision), collision.name, collision.element);
  }
  read_inner(xml::View(document, link.element));
}

void ReferenceFinder::read_end(const urdf::Joint& joint, std::string_view end,
                               const Field<std::string>& link) {
  const std::size_t before = found_.size();
  read_field({NameKind::link}, link, joint.element);
  if (found_.size() == before) return;
  const xml::View element = xml::View(model_.robot->document, joint.element).child(end);
  if (element) found_.back().place = number_of(element);
}

void ReferenceFinder::read_urdf() {
  if (!model_.robot) return;
  const urdf::Robot& robot = *model_.robot;
  const xml::View root = robot.document.view();
  if (keeps_all()) {
    read_groups(root);
    for (const urdf::Material& material : robot.materials) {
      read_field(defines(NameKind::material), material.name, material.element);
    }
    for (const urdf::Link& link : robot.links) read_link(link);
  }
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const urdf::Joint& joint = robot.joints[i];
    read_field(defines(NameKind::joint), joint.name, joint.element);
    // Names in the tree are known.
    if (keeps_all() || !model_.tree.joint_parent[i]) read_end(joint, "parent", joint.parent);
    if (keeps_all() || !model_.tree.joint_child[i]) read_end(joint, "child", joint.child);
    if (joint.mimic) read_field({NameKind::joint}, joint.mimic->joint, joint.mimic->element);
    if (keeps_all()) read_inner(xml::View(robot.document, joint.element));
  }
  for (const xml::ElementId id : robot.extensions) {
    const xml::View element(robot.document, id);
    if (keeps_all()) {
      const xml::Attribute* name = element.attribute("name");
      const AttributeNames* row = find_row(element, "name");
      if (name != nullptr && (row == nullptr || row->names.kinds.empty())) {
        add(defines(NameKind::extension), name->value(), place_of_value(element, *name));
      }
      read_extension(element);
    } else if (element.name() == "gazebo") {
      read_attributes(element);
    } else if (element.name() == "transmission") {
      for (const xml::View child : element) read_attributes(child);
    }
  }
}

void ReferenceFinder::read_groups(xml::View root) {
  std::uint32_t number = 0;
  for (const xml::View element : root) {
    if (element.name() == "group") groups_.add(attribute_of(element, "name"), number++);
  }
}

void ReferenceFinder::read_inner(xml::View element) {
  const urdf::ElementSpec* spec = urdf::find_element_spec(element.name());
  if (spec == nullptr) return;
  for (const xml::View child : element) {
    if (spec->child(child.name()) != nullptr) {
      read_inner(child);
    } else {
      read_extension(child);
    }
  }
}

void ReferenceFinder::read_attributes(xml::View element) {
  for (const xml::Attribute& one : element.attributes()) {
    const std::string_view value = one.value();
    if (value.empty()) continue;
    const AttributeNames* row = find_row(element, one.name());
    if (row != nullptr && (row->is_needed || row->names.defines)) {
      add(row->names, value, place_of_value(element, one));
    } else if (keeps_all()) {
      const NameKinds kinds = row != nullptr ? row->names.kinds : kinds_of(element, one.name());
      add_if_known(kinds, value, place_of_value(element, one));
    }
  }
}

void ReferenceFinder::read_extension(xml::View element) {
  read_attributes(element);
  if (element.begin() == element.end()) read_text(element);
  for (const xml::View child : element) read_extension(child);
}

/// In any extension: a text that is the name of a link or joint, or a list of such names.
void ReferenceFinder::read_text(xml::View element) {
  const Span span = element.text_span();
  const std::string_view text = trimmed(element.text());
  const NamePlace place{Notation::xml_text, number_of(element), span, span};
  if (text.empty()) return;
  const std::string_view own_name = attribute_of(element, "name");
  const std::string_view word =
      element.name() == "param" && !own_name.empty() ? own_name : element.name();
  if (is_address(word)) return;
  const NameKinds kinds = kinds_in_word(word);
  if (read_part(text, text, kinds, place)) return;
  if (text.size() != span.end - span.begin) return;  // offsets would differ from those in the file
  if (kinds == NameKind::collision || kinds == NameKind::visual) {
    return read_gazebo_name(text, place);
  }
  // Splits "base_link, tool0" or "robot::base_link"; prose contains other words as well.
  std::vector<std::string_view> parts;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \t\r\n,;:", at), text.size());
    if (end > at) parts.push_back(text.substr(at, end - at));
    at = end + 1;
  }
  const auto is_frame = [&](std::string_view part) {
    return find(NameKind::link, part) || find(NameKind::joint, part);
  };
  const bool is_path = text.find("::") != std::string_view::npos;
  const bool are_all = std::all_of(parts.begin(), parts.end(), is_frame);
  if (parts.size() < 2 || (!are_all && !(is_path && !kinds.empty()))) return;
  for (const std::string_view part : parts) read_part(text, part, kinds, place);
}

bool ReferenceFinder::read_part(std::string_view text, std::string_view part, NameKinds kinds,
                                const NamePlace& place) {
  const auto offset = static_cast<std::size_t>(part.data() - text.data());
  const NamePlace at = part.size() == text.size() ? place : part_of(place, offset, part.size());
  const bool is_joint = kinds == NameKind::joint;
  return add_if_known(is_joint ? NameKind::joint : NameKind::link, part, at) ||
         add_if_known(is_joint ? NameKind::link : NameKind::joint, part, at);
}

/// The name of a collision or visual in sdformat: LINK_collision or LINK_visual, with a
/// number from the second on, and LINK_fixed_joint_lump__PART_collision for a part of a
/// merged link.
void ReferenceFinder::read_gazebo_name(std::string_view text, const NamePlace& place) {
  constexpr std::string_view kLump = "_fixed_joint_lump__";
  const auto read_link_of = [&](std::string_view name) {
    for (const std::string_view suffix : {"_collision", "_visual"}) {
      const std::string_view link = before(name, suffix);
      if (link.size() == name.size() || find(NameKind::collision, name)) continue;
      const std::string_view rest = name.substr(link.size() + suffix.size());
      const bool is_number = std::all_of(rest.begin(), rest.end(),
                                         [](char c) { return c == '_' || (c >= '0' && c <= '9'); });
      if (is_number) read_part(text, link, NameKind::link, place);
    }
  };
  const std::string_view carrier = before(text, kLump);
  if (carrier.size() == text.size()) return read_link_of(text);
  read_part(text, carrier, NameKind::link, place);
  read_link_of(text.substr(carrier.size() + kLump.size()));
}

}  // namespace smurf
