// SPDX-License-Identifier: BSD-3-Clause
// One URDF of the whole scene: every model's own text with a prefix before all names, joined to the
// link `world`. Only names and file names of a model are changed.
#include <algorithm>
#include <map>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/edits.hpp"
#include "base/text/utf8.hpp"
#include "convert/xml_edits.hpp"
#include "syntax/strict_xml.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/parts/scene_parts.hpp"
#include "write/text/raw_xml.hpp"
#include "write/text/xml_text.hpp"

namespace smurf::scene_urdf_file {
namespace {

/// An attribute with a name of the model. `element` is empty for any element.
struct NameAttribute {
  std::string_view element, attribute;
};

/// Names that clash when two models share a file: links, joints and materials, and references to
/// them in the extensions of ROS and Gazebo.
constexpr NameAttribute kNames[] = {
    {"link", "name"},     {"joint", "name"},        {"material", "name"},
    {"parent", "link"},   {"child", "link"},        {"parent", "joint"},
    {"mimic", "joint"},   {"gazebo", "reference"},  {"transmission", "name"},
    {"actuator", "name"}, {"ros2_control", "name"}, {"sensor", "name"},
};

/// <gazebo> contains SDF with separate names.
bool is_inside_gazebo(const xml::Document& document, const xml::Element& element) {
  for (xml::ElementId at = element.parent; at != xml::kNoElement;
       at = document.elements[static_cast<std::size_t>(at)].parent) {
    if (document.elements[static_cast<std::size_t>(at)].name() == "gazebo") return true;
  }
  return false;
}

/// Whether an attribute gets a prefix. The element is not in <gazebo>.
bool is_name(const xml::Element& element, const xml::Attribute& attribute) {
  const auto is_this = [&](const NameAttribute& name) {
    return name.element == element.name() && name.attribute == attribute.name();
  };
  return !attribute.value().empty() && std::any_of(std::begin(kNames), std::end(kNames), is_this);
}

RepeatedParts repeated_parts(const LinkedModel& model) {
  const xml::Document& document = model.robot->document;
  RepeatedParts parts;
  for (const xml::Element& element : document.elements) {
    if (element.parent == xml::kNoElement || is_inside_gazebo(document, element)) continue;
    for (std::uint32_t k = 0; k < element.attribute_count; ++k) {
      parts.names += is_name(element, document.attributes[element.first_attribute + k]) ? 1 : 0;
    }
  }
  return parts;
}

class UrdfMerger {
 public:
  explicit UrdfMerger(const SceneExport& scene)
      : scene_(scene), losses_(scene, SceneColumn::urdf, "URDF"), names_(safe_names(scene.flat)) {}

  std::string run() {
    open_robot();
    xml_.empty("link", {{"name", "world"}});
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (scene_.flat.instances[i].X_WE && !xml_.is_full()) add_instance(i);
    }
    losses_.table();
    losses_.files_in_archives();
    return with_namespaces(xml_.finish());
  }

 private:
  const FlatInstance& flat(std::size_t i) const { return scene_.flat.instances[i]; }

  const LinkedModel* robot_of(std::size_t i) const { return smurf::robot_of(scene_.scene, i); }

  /// The latest version that one of the models needs; without a version, readers assume 1.0.
  void open_robot() {
    for (const LinkedModel& model : scene_.scene.models) {
      if (model.robot) version_ = std::max(version_, model.robot->version.value_or(version_));
    }
    if (version_ == "1.0") {
      xml_.open("robot", {{"name", "scene"}});
    } else {
      xml_.open("robot", {{"name", "scene"}, {"version", version_}});
    }
  }

  void add_instance(std::size_t i) {
    const LinkedModel* model = robot_of(i);
    if (model != nullptr) {
      xml_.raw(prefixed(*model, i));
    } else if (!flat(i).shapes.empty()) {
      if (!add_solid(i)) return;
    } else {
      losses_.entity(i, "URDF knows no entities of type `" + flat(i).type + "`");
      return;
    }
    add_world_joint(i, model);
  }

  std::string prefix(std::size_t i) const { return names_[i] + "__"; }

  /// The text between the start and the end tag of <robot>.
  std::string prefixed(const LinkedModel& model, std::size_t i) {
    const xml::Document& document = model.robot->document;
    std::vector<Edit> edits;
    for (const xml::Element& element : document.elements) edit(document, element, i, edits);
    const xml::Element& root = document.elements[static_cast<std::size_t>(document.root)];
    if (version_ == "1.0") replace_capsules(model, i, edits);
    keep_namespaces(document.view(), edits);
    const std::string_view text = source_text(model);
    const std::size_t end = text.substr(0, root.span.end).rfind("</");
    if (end == std::string_view::npos || end < root.tag_span().end) return {};  // <robot/>
    for (Edit& each : edits) {
      each.span.begin -= root.tag_span().end;
      each.span.end -= root.tag_span().end;
    }
    return "  <!-- " + comment(flat(i).path) + " -->" +
           strict_xml(
               apply_edits(text.substr(root.tag_span().end, end - root.tag_span().end), edits)) +
           "\n";
  }

  /// URDF 1.0 has no capsules: a cylinder in the place of each, and two spheres at its ends.
  void replace_capsules(const LinkedModel& model, std::size_t i, std::vector<Edit>& edits) const {
    for (const urdf::Link& link : model.robot->links) {
      for (const urdf::Visual& visual : link.visuals) {
        replace_capsule(model, visual, i, edits);
      }
      for (const urdf::Collision& collision : link.collisions) {
        replace_capsule(model, collision, i, edits);
      }
    }
  }

  void replace_capsule(const LinkedModel& model, const auto& shape, std::size_t i,
                       std::vector<Edit>& edits) const {
    const auto* capsule = std::get_if<urdf::Capsule>(&shape.geometry.shape);
    if (capsule == nullptr || !capsule->radius || !capsule->length) return;
    const xml::Document& document = model.robot->document;
    const xml::View element(document, shape.element);
    const std::string radius = format_number(*capsule->radius);
    edits.push_back({xml::View(document, shape.geometry.shape_element).span(),
                     new_element("cylinder", {{"radius", radius},
                                              {"length", format_number(*capsule->length)}})});
    std::string spheres;
    for (const auto& [end, z] :
         {std::pair{"_top", *capsule->length / 2}, std::pair{"_bottom", -*capsule->length / 2}}) {
      const Pose X_LS = urdf::to_pose(shape.origin) * Pose{{0, 0, z}, {}};
      spheres += "<" + std::string(element.name());
      if (shape.name) spheres += " name=\"" + escape_xml(*shape.name + end) + "\"";
      spheres += ">" + new_element("origin", origin_attributes(X_LS)) + "<geometry>" +
                 new_element("sphere", {{"radius", radius}}) + "</geometry>" +
                 material_of(element, i) + "</" + std::string(element.name()) + ">";
    }
    const Span span = element.span();
    edits.push_back({{span.source, span.end, span.end}, spheres});
  }

  /// The material of a visual, or "".
  std::string material_of(xml::View visual, std::size_t i) const {
    const xml::View material = visual.child("material");
    const xml::Attribute* name = material ? material.attribute("name") : nullptr;
    if (name == nullptr) return {};
    std::string text = "<material name=\"" + escape_xml(prefix(i) + std::string(name->value()));
    const xml::View color = material.child("color");
    const xml::Attribute* rgba = color ? color.attribute("rgba") : nullptr;
    if (rgba == nullptr) return text + "\"/>";
    return text + "\">" + new_element("color", {{"rgba", std::string(rgba->value())}}) +
           "</material>";
  }

  std::string_view source_text(const LinkedModel& model) const {
    return scene_.sources.text(model.robot->document.source);
  }

  static std::string comment(std::string_view path) {
    std::string safe;
    for (const char c : utf8::replace_controls(path)) {
      safe += c == '-' && safe.ends_with('-') ? ' ' : c;
    }
    return safe;
  }

  void edit(const xml::Document& document, const xml::Element& element, std::size_t i,
            std::vector<Edit>& edits) const {
    const bool is_root = element.parent == xml::kNoElement;
    if (is_root || is_inside_gazebo(document, element)) return;
    for (std::uint32_t k = 0; k < element.attribute_count; ++k) {
      const xml::Attribute& attribute = document.attributes[element.first_attribute + k];
      if (is_name(element, attribute)) {
        const Span begin{attribute.value_span().source, attribute.value_span().begin,
                         attribute.value_span().begin};
        edits.push_back({begin, prefix(i)});
      }
      const bool is_file = attribute.name() == "filename" &&
                           (element.name() == "mesh" || element.name() == "texture");
      if (is_file) add_file_edit(attribute, i, edits);
    }
  }

  void add_file_edit(const xml::Attribute& attribute, std::size_t i,
                     std::vector<Edit>& edits) const {
    // Addresses and absolute paths resolve from anywhere, but do not name a copy.
    const bool resolves_anywhere = attribute.value().find("://") != std::string_view::npos ||
                                   path::is_absolute(attribute.value());
    if (resolves_anywhere && !scene_.names_copies) return;
    const auto& resources = scene_.flat.models[*flat(i).model].resources;
    const auto known = resources.find(attribute.value());
    if (known == resources.end() || known->first == known->second) return;
    edits.push_back({attribute.value_span(), escape_xml(known->second)});
  }

  /// Extensions may use prefixes that their <robot> declares. The declarations of the first model
  /// are kept. If another model declares a prefix differently, each of its elements declares it.
  /// URDF has no default namespace.
  void keep_namespaces(xml::View root, std::vector<Edit>& edits) {
    for (const xml::Attribute& at : root.attributes()) {
      if (!at.name().starts_with("xmlns:")) continue;
      const auto [known, is_new] = namespaces_.emplace(at.name(), at.value());
      if (known->second != at.value()) declare_prefix(root, at, edits);
    }
  }

  std::string with_namespaces(std::string text) const {
    constexpr std::string_view kRoot = "<robot name=\"scene\"";
    std::string declarations;
    for (const auto& [name, value] : namespaces_) {
      declarations += " " + std::string(name) + "=\"" + escape_xml(value) + "\"";
    }
    text.insert(text.find(kRoot) + kRoot.size(), declarations);
    return text;
  }

  void add_origin(const Pose& pose) {
    xml_.empty("origin", {{"xyz", join_numbers(pose.position)},
                          {"rpy", join_numbers(to_rpy(pose.orientation))}});
  }

  void add_world_joint(std::size_t i, const LinkedModel* model) {
    std::string parent = "world";
    Pose X_PE = *flat(i).X_WE;
    bool is_fixed = flat(i).anchor.kind == Attachment::Kind::world;
    if (flat(i).anchor.kind == Attachment::Kind::link) is_fixed = hang_on_link(i, parent, X_PE);
    if (model == nullptr) is_fixed = !is_movable(flat(i));
    const std::string root = model != nullptr ? root_link_name(*model) : "link";
    xml_.open("joint",
              {{"name", prefix(i) + "placement"}, {"type", is_fixed ? "fixed" : "floating"}});
    xml_.empty("parent", {{"link", parent}});
    xml_.empty("child", {{"link", prefix(i) + root}});
    add_origin(X_PE);
    xml_.close();
  }

  /// Writes the joint to the link that an instance is anchored to; false if this is impossible.
  bool hang_on_link(std::size_t i, std::string& parent, Pose& X_PE) {
    const FlatAttachment& anchor = flat(i).anchor;
    const std::size_t other = anchor.index;
    const std::optional<Pose> X_LE = pose_on_anchor(scene_, i, frames_);
    if (!X_LE || closes_circle(i)) {
      losses_.anchor(i, "there is no link to attach it to");
      return false;
    }
    parent = prefix(other) + anchor.link;
    X_PE = *X_LE;
    return true;
  }

  /// Whether an instance is the end of a cycle of anchors.
  bool closes_circle(std::size_t i) const { return groups_[i] == i; }

  /// False if nothing can be written for it.
  bool add_solid(std::size_t i) {
    const FlatInstance& instance = flat(i);
    const Span place = place_of(*scene_.flat.instances[i].entity);
    std::vector<FlatShape> shapes;
    for (FlatShape shape : instance.shapes) {
      if (const auto* plane = std::get_if<FlatPlane>(&shape.geometry)) {
        constexpr double kThickness = 0.02;  // URDF has no planes
        shape.X_ES = shape.X_ES * Pose{{0, 0, -kThickness / 2}, {}};
        shape.geometry = FlatBox{{plane->length, plane->width, kThickness}};
      }
      if (std::holds_alternative<FlatHeightmap>(shape.geometry)) {
        losses_.shape(place, "the heightmap `" + instance.path + "`");
      } else if (std::holds_alternative<FlatCapsule>(shape.geometry)) {
        add_capsule(shape, shapes);
      } else {
        shapes.push_back(std::move(shape));
      }
    }
    if (shapes.empty()) return false;
    xml_.open("link", {{"name", prefix(i) + "link"}});
    if (is_movable(instance)) add_inertial(instance.shapes.front(), mass_of(instance));
    for (const std::string_view element : {"visual", "collision"}) {
      for (const FlatShape& shape : shapes) {
        xml_.open(element);
        add_origin(shape.X_ES);
        xml_.open("geometry");
        std::visit([&](const auto& geometry) { add_geometry(geometry); }, shape.geometry);
        xml_.close();
        if (element == "visual" && shape.color) add_material(prefix(i), *shape.color);
        xml_.close();
      }
    }
    xml_.close();
    return true;
  }

  /// Capsules need URDF 1.1, which readers of 1.0 refuse.
  static void add_capsule(const FlatShape& shape, std::vector<FlatShape>& shapes) {
    const FlatCapsule capsule = std::get<FlatCapsule>(shape.geometry);
    FlatShape part = shape;
    part.geometry = FlatCylinder{capsule.radius, capsule.length};
    shapes.push_back(part);
    part.geometry = FlatSphere{capsule.radius};
    for (const double end : {capsule.length / 2, -capsule.length / 2}) {
      part.X_ES = shape.X_ES * Pose{{0, 0, end}, {}};
      shapes.push_back(part);
    }
  }

  /// Materials with the same name must be equal.
  void add_material(const std::string& start, const Rgba& color) {
    const std::string rgba = join_numbers({color[0], color[1], color[2], color[3]});
    xml_.open("material", {{"name", start + rgba}});
    xml_.empty("color", {{"rgba", rgba}});
    xml_.close();
  }

  void add_inertial(const FlatShape& shape, double mass) {
    const LinkInertial properties = solid_mass(shape.geometry, mass);
    const auto text = [](double value) { return join_numbers({value}); };
    xml_.open("inertial");
    add_origin(shape.X_ES);
    xml_.empty("mass", {{"value", text(mass)}});
    xml_.empty("inertia", {{"ixx", text(properties.ixx)},
                           {"ixy", "0"},
                           {"ixz", "0"},
                           {"iyy", text(properties.iyy)},
                           {"iyz", "0"},
                           {"izz", text(properties.izz)}});
    xml_.close();
  }

  void add_geometry(const FlatBox& box) { xml_.empty("box", {{"size", join_numbers(box.size)}}); }
  void add_geometry(const FlatSphere& sphere) {
    xml_.empty("sphere", {{"radius", join_numbers({sphere.radius})}});
  }
  void add_geometry(const FlatCylinder& cylinder) {
    xml_.empty("cylinder", {{"radius", join_numbers({cylinder.radius})},
                            {"length", join_numbers({cylinder.length})}});
  }
  void add_geometry(const FlatMesh& mesh) {
    xml_.empty("mesh", {{"filename", mesh.file}, {"scale", join_numbers(mesh.scale)}});
  }
  void add_geometry(const FlatPlane&) {}      // already converted to a box
  void add_geometry(const FlatCapsule&) {}    // already converted to a cylinder and spheres
  void add_geometry(const FlatHeightmap&) {}  // reported

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  std::string version_ = "1.0";
  std::vector<std::size_t> groups_ = anchor_groups(scene_.flat);
  std::map<std::string, std::string, std::less<>> namespaces_;  ///< what prefixes mean
  LinkFrames frames_;
  XmlText xml_{scene_.most_bytes};
};

}  // namespace

extern constinit const SceneFormat scene_urdf{
    .name = "urdf",
    .help = "one URDF with a prefix before the names of each model",
    .write = [](const SceneExport& scene) { return UrdfMerger(scene).run(); },
    .repeats_models = true,
    .loses_link_pairs = true,
    .has_collisions = true,
    .fixes_world_roots = true,
    .repeated_parts = repeated_parts};

}  // namespace smurf::scene_urdf_file
