// SPDX-License-Identifier: BSD-3-Clause
// Collects the things of a URDF: elements and attributes by the table of URDF, extensions as
// written.
#include <algorithm>
#include <array>
#include <map>
#include <unordered_map>

#include "ast/urdf_attributes.hpp"
#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "diff/collect.hpp"
#include "syntax/xml_values.hpp"

namespace smurf {
namespace {

using urdf::AttributeSpec;
using urdf::ElementSpec;

const AttributeSpec* find_attribute(const ElementSpec* spec, std::string_view name) {
  return spec == nullptr ? nullptr : spec->attribute(name);
}

bool is_text(const AttributeSpec* spec) {
  return spec != nullptr && spec->form == urdf::Form::text;
}

/// Reads a list of numbers; joins the words of any other text by single spaces.
Property property_of_text(std::string_view key, std::string_view text, Span span, bool is_text) {
  std::vector<double> numbers;
  std::string words;
  bool are_numbers = !is_text;
  std::size_t at = 0;
  for (std::string_view word = next_word(text, at); !word.empty(); word = next_word(text, at)) {
    const auto number = are_numbers ? parse_number(word) : std::nullopt;
    are_numbers = number.has_value();
    if (number) numbers.push_back(*number);
    words += (words.empty() ? "" : " ") + std::string(word);
  }
  if (is_text) return text_property(key, text, span);
  if (!are_numbers || numbers.empty()) return text_property(key, words, span);
  if (numbers.size() == 1) return number_property(key, numbers.front(), span);
  return numbers_property(key, std::move(numbers), span);
}

Property property_of(const xml::Attribute& attribute, const AttributeSpec* spec) {
  Property property =
      property_of_text(attribute.name(), attribute.value(), attribute.value_span(), is_text(spec));
  if (spec == nullptr) return property;
  property.unit = spec->unit;
  property.fallback = spec->fallback;
  if (spec->fallback.empty()) return property;
  const Property fallback = property_of_text({}, spec->fallback, {}, is_text(spec));
  property.is_default = is_same_leaf(fallback, fallback.text, property, 0);
  return property;
}

/// The inertia about the centre of mass, in the axes of the link: R I R^T.
std::vector<double> inertia_in_link(const urdf::Inertial& inertial) {
  const auto value = [](const Field<double>& field) { return field.value_or(0); };
  const double xy = value(inertial.ixy);
  const double xz = value(inertial.ixz);
  const double yz = value(inertial.iyz);
  const std::array<double, 9> I{value(inertial.ixx), xy, xz, xy, value(inertial.iyy), yz, xz, yz,
                                value(inertial.izz)};
  const std::array<double, 9> R = to_matrix(to_pose(inertial.origin).orientation);
  const auto turned = [&](std::size_t row, std::size_t column) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) sum += R[3 * row + i] * I[3 * i + k] * R[3 * column + k];
    }
    return sum;
  };
  return {turned(0, 0), turned(0, 1), turned(0, 2), turned(1, 1), turned(1, 2), turned(2, 2)};
}

class RobotCollector {
 public:
  RobotCollector(const LinkedModel& model, Things& things)
      : model_(model), robot_(*model.robot), things_(things) {
    for (const MeshReference& mesh : model.meshes) files_.emplace(mesh.span.begin, &mesh);
  }

  void run() {
    things_.tree = &model_.tree;
    const xml::View root = robot_.document.view();
    Thing& robot = add("robot", {}, {}, root.name_span());
    attributes(root, urdf::find_element_spec("robot"), robot.properties);
    for (const urdf::Material& material : robot_.materials) this->material(material);
    for (const urdf::Link& link : robot_.links) this->link(link);
    for (const urdf::Joint& joint : robot_.joints) this->joint(joint);
    for (const xml::ElementId id : robot_.extensions) extension(view(id));
  }

 private:
  xml::View view(xml::ElementId id) const { return {robot_.document, id}; }

  Thing& add(std::string_view kind, const Field<std::string>& name, std::optional<NameKind> names,
             Span place, std::size_t parent = kNone) {
    Thing& thing = things_.all.emplace_back();
    thing.kind = kind;
    thing.name = name.value_or("");
    thing.place = name.written ? name.span : place;
    thing.names = names;
    thing.parent = parent;
    thing.properties = group_property({}, place);
    return thing;
  }

  /// All attributes but the name.
  void attributes(xml::View element, const ElementSpec* spec, Property& group) {
    const bool is_thing = group.key.empty();
    for (const xml::Attribute& at : element.attributes()) {
      if (is_thing && at.name() == "name" && element.name() != "robot") continue;
      Property property = property_of(at, find_attribute(spec, at.name()));
      if (const auto file = files_.find(at.value_span().begin); file != files_.end()) {
        property.form = Property::Form::file;
        property.path = file->second->path;
      }
      add_member(group, std::move(property));
    }
  }

  Property group_of(xml::View element) {
    Property group = group_property(element.name(), element.tag_span());
    attributes(element, urdf::find_element_spec(path::to_lower(element.name())), group);
    children(element, group, [](std::string_view) { return false; });
    if (const std::string_view text = trimmed(element.text()); !text.empty()) {
      add_member(group, property_of_text("text", text, element.text_span(), false));
    }
    return group;
  }

  /// Converts a child element to a group of properties. An element that has only one attribute, or
  /// only text, becomes a single value.
  Property element(xml::View element) {
    const ElementSpec* spec = urdf::find_element_spec(path::to_lower(element.name()));
    Property group = group_of(element);
    if (group.members.size() != 1 || group.members[0].has_members()) return group;
    const bool is_attribute = spec != nullptr && spec->attributes.size() == 1 &&
                              group.members[0].key == spec->attributes[0].name;
    if (!is_attribute && (spec != nullptr || group.members[0].key != "text")) return group;
    Property only = std::move(group.members[0]);
    only.key = group.key;
    return only;
  }

  /// The child elements that are compared. Of elements that may occur once, readers use the first;
  /// others are paired by name if all have a name.
  template <class IsLeftOut>
  void children(xml::View parent, Property& group, IsLeftOut is_left_out) {
    const ElementSpec* spec = urdf::find_element_spec(path::to_lower(parent.name()));
    std::map<std::string_view, Siblings> siblings;
    for (const xml::View child : parent) {
      Siblings& same = siblings[child.name()];
      same.have_names = same.have_names && !attribute_of(child, "name").empty();
    }
    for (const xml::View child : parent) {
      if (is_left_out(path::to_lower(child.name()))) continue;
      Siblings& same = siblings[child.name()];
      const bool is_first = !std::exchange(same.is_known, true);
      const urdf::ChildSpec* row = spec == nullptr ? nullptr : spec->child(child.name());
      if (row != nullptr && row->single) {
        if (is_first) add_member(group, element(child));
        continue;
      }
      if (!same.have_names) {
        add_member(group, element(child));
        continue;
      }
      if (is_first) {
        same.list = group.members.size();
        group.members.push_back(group_property(child.name(), child.tag_span()));
        group.members.back().form = Property::Form::list;
      }
      Property item = group_of(child);
      item.key = attribute_of(child, "name");
      item.key_span = child.attribute("name")->value_span();
      group.members[same.list].members.push_back(std::move(item));
    }
  }

  /// The child elements of one name.
  struct Siblings {
    bool have_names = true;
    bool is_known = false;     ///< the first element was read
    std::size_t list = kNone;  ///< the member of the group that contains them
  };

  void material(const urdf::Material& material) {
    Thing& thing = add("material", material.name, NameKind::material, material.span);
    attributes(view(material.element), urdf::find_element_spec("material"), thing.properties);
    children(view(material.element), thing.properties, [](std::string_view) { return false; });
  }

  void link(const urdf::Link& link) {
    things_.links.push_back(things_.all.size());
    const std::size_t index = things_.all.size();
    Thing& thing = add("link", link.name, NameKind::link, link.span);
    attributes(view(link.element), urdf::find_element_spec("link"), thing.properties);
    if (link.inertial) add_member(thing.properties, inertial(link));
    children(view(link.element), thing.properties, [](std::string_view name) {
      return name == "inertial" || name == "visual" || name == "collision";
    });
    for (const urdf::Visual& visual : link.visuals)
      shape("visual", NameKind::visual, visual, index);
    for (const urdf::Collision& collision : link.collisions) {
      shape("collision", NameKind::collision, collision, index);
    }
  }

  /// The mass properties in the frame of the link, so that the choice of the inertial frame makes
  /// no difference.
  Property inertial(const urdf::Link& link) {
    const urdf::Inertial& inertial = *link.inertial;
    Property group = group_property("inertial", view(inertial.element).tag_span());
    const xml::View mass = view(inertial.element).child("mass");
    if (mass) add_member(group, element(mass));
    const urdf::Origin& origin = inertial.origin;
    const Vector3 center = origin.xyz.value_or({});
    const Span place = origin.xyz.written ? origin.xyz.span : group.span;
    Property point =
        numbers_property("center_of_mass", {center[0], center[1], center[2]}, place, "m");
    point.is_default = center == Vector3{};
    point.fallback = "0 0 0";
    add_member(group, std::move(point));
    const xml::View tensor = view(inertial.element).child("inertia");
    if (!tensor) return group;
    Property inertia =
        numbers_property("inertia", inertia_in_link(inertial), tensor.tag_span(), "kg m^2");
    inertia.parts = urdf::kInertiaEntries;
    add_member(group, std::move(inertia));
    const ElementSpec* spec = urdf::find_element_spec("inertia");
    for (const xml::Attribute& at : tensor.attributes()) {
      const bool is_read = find_attribute(spec, at.name()) != nullptr;
      Property other = property_of(at, nullptr);
      if (!is_read || other.form != Property::Form::number) add_member(group, std::move(other));
    }
    return group;
  }

  Property pose(const urdf::Origin& origin, Span otherwise) {
    const bool is_written = origin.element != xml::kNoElement;
    return pose_property("pose", to_pose(origin),
                         is_written ? view(origin.element).tag_span() : otherwise);
  }

  template <class Part>
  void shape(std::string_view kind, NameKind names, const Part& part, std::size_t link) {
    const xml::View here = view(part.element);
    Thing& thing = add(kind, part.name, names, here.name_span(), link);
    attributes(here, urdf::find_element_spec(kind), thing.properties);
    add_member(thing.properties, pose(part.origin, here.name_span()));
    if (part.geometry.shape_element != xml::kNoElement) {
      Property property = group_of(view(part.geometry.shape_element));
      property.form = Property::Form::choice;
      property.text = std::exchange(property.key, "shape");
      add_member(thing.properties, std::move(property));
    }
    children(here, thing.properties,
             [](std::string_view name) { return name == "origin" || name == "geometry"; });
  }

  void joint(const urdf::Joint& joint) {
    things_.joints.push_back(things_.all.size());
    const xml::View here = view(joint.element);
    Thing& thing = add("joint", joint.name, NameKind::joint, joint.span);
    attributes(here, urdf::find_element_spec("joint"), thing.properties);
    add_member(thing.properties, pose(joint.origin, here.name_span()));
    children(here, thing.properties, [](std::string_view name) { return name == "origin"; });
    choose_units(thing.properties, joint);
  }

  void extension(xml::View element) {
    Field<std::string> name;
    for (const std::string_view key : {"name", "reference"}) {
      const xml::Attribute* attribute = element.attribute(key);
      if (attribute == nullptr || name) continue;
      name = {std::string(attribute->value()), attribute->value_span()};
    }
    Thing& thing = add(element.name(), name, {}, element.name_span());
    thing.properties = group_of(element);
    std::erase_if(thing.properties.members, [&](const Property& property) {
      return property.form == Property::Form::text && !name.span.empty() &&
             property.span == name.span;
    });
    thing.properties.key = {};
  }

  const LinkedModel& model_;
  const urdf::Robot& robot_;
  Things& things_;
  std::unordered_map<std::uint32_t, const MeshReference*> files_;  ///< by the place of the name
};

}  // namespace

void choose_units(Property& property, const urdf::Joint& joint) {
  constexpr std::string_view kOr = " or ";
  if (!joint.has_one_axis()) return;
  for (Property& member : property.members) choose_units(member, joint);
  const std::size_t at = property.unit.find(kOr);
  if (at == std::string_view::npos) return;
  property.unit = joint.type == urdf::JointType::prismatic ? property.unit.substr(at + kOr.size())
                                                           : property.unit.substr(0, at);
}

void collect_robot(const LinkedModel& model, Things& things) {
  if (model.robot) RobotCollector(model, things).run();
}

}  // namespace smurf
