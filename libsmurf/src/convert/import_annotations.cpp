// SPDX-License-Identifier: BSD-3-Clause
// Materials and joint damping of the URDF, poses of an SRDF, and the text of everything else.
#include <algorithm>
#include <map>
#include <set>

#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "convert/import.hpp"
#include "convert/xml_edits.hpp"

namespace smurf::import {
namespace {

class MaterialMaker {
 public:
  explicit MaterialMaker(const Context& context) : context_(context) {
    for (const MeshReference& reference : context.model.meshes) {
      if (reference.is_texture && reference.exists) {
        textures_[reference.span.begin] = reference.path;
      }
    }
  }

  std::vector<NewValue> make() {
    for (const urdf::Material& material : context_.robot().materials) add(material);
    for (const urdf::Link& link : context_.robot().links) {
      for (const urdf::Visual& visual : link.visuals) {
        if (visual.material) add(*visual.material);
      }
    }
    return std::move(entries_);
  }

 private:
  /// The first definition of a name applies; an element without colour and texture is not a
  /// definition.
  void add(const urdf::Material& material) {
    if (!material.name || (!material.rgba && !material.texture)) return;
    // Exporters leave the names of all materials empty; each visual keeps its own in the URDF.
    if (material.name->empty()) return;
    std::vector<NewValue> members = {text_value("name", *material.name)};
    // An invalid colour of the URDF is not copied to an annotation.
    if (material.rgba && std::all_of(material.rgba->begin(), material.rgba->end(),
                                     [](double part) { return part >= 0 && part <= 1; })) {
      const auto& [r, g, b, a] = *material.rgba;
      members.push_back(numbers_value("diffuseColor", {{"r", r}, {"g", g}, {"b", b}, {"a", a}}));
    }
    if (material.texture) {
      const auto texture = textures_.find(material.texture.span.begin);
      if (texture != textures_.end()) {
        members.push_back(
            text_value("diffuseTexture", texture_path(context_.options, texture->second)));
      }
    }
    if (members.size() == 1 || !seen_.insert(*material.name).second) return;
    entries_.push_back(mapping_value({}, std::move(members)));
    entries_.back().comment = context_.line_of(material.span);
  }

  const Context& context_;
  std::map<std::uint32_t, std::string> textures_;  ///< existing files, by place in the URDF
  std::set<std::string> seen_;
  std::vector<NewValue> entries_;
};

/// The texts of elements, unindented, by their subject: "gazebo_base_link".
NewValue texts_by_subject(const Context& context, const std::string& section,
                          const std::vector<xml::View>& elements) {
  std::vector<NewValue> entries;
  std::map<std::string, std::size_t> places;
  // All are in one document, which may be one long line.
  const xml::Document& document = elements.front().document();
  const XmlEdits edits(document, context.sources.text(document.source));
  for (const xml::View element : elements) {
    std::string key(element.name());
    for (const char* attribute : {"reference", "name"}) {
      const std::string_view value = attribute_of(element, attribute);
      if (!value.empty()) {
        key += "_" + std::string(value);
        break;
      }
    }
    std::vector<Edit> changes;
    for (const Edit& edit : context.edits) {
      const Span& span = edit.span;
      const bool is_inside = span.source == document.source && span.begin >= element.span().begin &&
                             span.end <= element.span().end;
      if (is_inside) changes.push_back(edit);
    }
    const std::string text = edits.copy(element, std::move(changes));
    const auto [place, is_new] = places.emplace(key, entries.size());
    if (is_new) {
      entries.push_back(mapping_value(key, {text_value("xml", text)}));
      entries.back().comment = context.line_of(element.span());
    } else {
      entries[place->second].children.front().text += "\n" + text;
    }
  }
  return mapping_value(section, std::move(entries));
}

}  // namespace

Part materials(Context& context) {
  std::vector<NewValue> entries = MaterialMaker(context).make();
  if (entries.empty()) return std::nullopt;
  return NewFile{"materials", "materials; colours and textures are those of the URDF",
                 list_value("materials", std::move(entries))};
}

Part joints(Context& context) {
  std::vector<NewValue> entries;
  for (const urdf::Joint& joint : context.robot().joints) {
    if (!joint.name || !joint.has_one_axis() || !joint.dynamics) continue;
    const double damping = joint.dynamics->damping.value_or(0);
    const double friction = joint.dynamics->friction.value_or(0);
    if (!(damping > 0) && !(friction > 0)) continue;
    std::vector<NewValue> members = {text_value("name", *joint.name)};
    if (damping > 0) {
      // All four values, because some readers require all or none.
      members.push_back(number_value("springStiffness", 0));
      members.push_back(number_value("springDamping", damping));
      members.push_back(number_value("spring_const_constraint_axis1", 0));
      members.push_back(number_value("damping_const_constraint_axis1", damping));
    }
    if (friction > 0) members.push_back(number_value("friction", friction));
    entries.push_back(mapping_value({}, std::move(members)));
    entries.back().comment = context.line_of(joint.dynamics->span);
  }
  if (entries.empty()) return std::nullopt;
  const char* section = context.options.style == SmurfStyle::phobos ? "joints" : "joint";
  return NewFile{section, "joints; damping and friction are those of the URDF",
                 list_value(section, std::move(entries))};
}

Part poses(Context& context) {
  const xml::Document* srdf = context.options.srdf;
  if (srdf == nullptr) return std::nullopt;
  std::map<std::string_view, int> uses;
  for (const xml::View state : srdf->view()) {
    if (state.name() == "group_state") ++uses[attribute_of(state, "name")];
  }
  std::vector<NewValue> entries;
  UniqueNames names;
  for (const xml::View state : srdf->view()) {
    if (state.name() != "group_state") continue;
    std::string name(attribute_of(state, "name"));
    if (uses[attribute_of(state, "name")] > 1) {
      name = std::string(attribute_of(state, "group")) + "_" + name;
    }
    std::vector<NewValue> positions;
    std::set<std::string_view> seen;
    for (const xml::View joint : state) {
      const std::string_view joint_name = attribute_of(joint, "name");
      const auto position = parse_number(attribute_of(joint, "value"));
      if (joint.name() != "joint" || !seen.insert(joint_name).second) continue;
      if (position && context.model.joint_names.contains(joint_name)) {
        positions.push_back(number_value(std::string(joint_name), *position));
      } else {
        context.keep_as_text(joint.name_span(), "a position of `" + std::string(joint_name) + "`",
                             position ? "the URDF has no such joint" : "it is not one number");
      }
    }
    if (name.empty() || positions.empty()) continue;
    entries.push_back(mapping_value(
        {}, {text_value("name", names.add(name)), mapping_value("joints", std::move(positions))}));
    entries.back().comment = context.line_of(state.span());
  }
  if (entries.empty()) return std::nullopt;
  return NewFile{"poses", "named joint positions: rad or m",
                 list_value("poses", std::move(entries))};
}

Part urdf_extensions(Context& context) {
  std::vector<xml::View> elements;
  for (const xml::ElementId id : context.robot().extensions) {
    elements.emplace_back(context.robot().document, id);
  }
  if (elements.empty()) return std::nullopt;
  return NewFile{"urdf_extensions", "other contents of the URDF, as text",
                 texts_by_subject(context, "urdf_extensions", elements)};
}

Part srdf_extensions(Context& context) {
  if (context.options.srdf == nullptr) return std::nullopt;
  std::vector<xml::View> elements;
  for (const xml::View element : context.options.srdf->view()) elements.push_back(element);
  if (elements.empty()) return std::nullopt;
  return NewFile{"srdf_extensions", "the contents of the SRDF, as text",
                 texts_by_subject(context, "srdf_extensions", elements)};
}

}  // namespace smurf::import
