// SPDX-License-Identifier: BSD-3-Clause
// The URDF of a model as written, in document order. Poses name their frames, X_PJ is that of a
// joint in its parent link.
#include <array>
#include <unordered_map>
#include <utility>
#include <variant>

#include "ast/urdf_attributes.hpp"
#include "write/json/model_json.hpp"

namespace smurf {

namespace {

using Layout = JsonPrinter::Layout;

class RobotPrinter {
 public:
  RobotPrinter(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources)
      : json_(json), model_(model), sources_(sources), robot_(*model.robot) {
    for (const MeshReference& mesh : model.meshes) files_.emplace(mesh.span.begin, &mesh);
  }

  void print() {
    list("materials", robot_.materials, [&](const urdf::Material& one) { material(one); });
    json_.key("roots");
    json_.begin_list();
    for (const LinkIndex root : model_.tree.roots) name(model_.link(root).name);
    json_.end();
    list("links", robot_.links, [&](const urdf::Link& one) { link(one); });
    list("joints", robot_.joints, [&](const urdf::Joint& one) { joint(one); });
    list("extensions", robot_.extensions, [&](xml::ElementId one) { extension(one); });
  }

 private:
  template <class Items, class Print>
  void list(std::string_view key, const Items& items, const Print& print,
            Layout layout = Layout::block) {
    json_.key(key);
    json_.begin_list(layout);
    for (const auto& item : items) print(item);
    json_.end();
  }

  void name(const Field<std::string>& field) {
    if (field) {
      json_.text(*field);
    } else {
      json_.null();
    }
  }

  void source(Span span) {
    json_.key("source");
    json_.place(span, sources_);
  }

  void pose(std::string_view key, const urdf::Origin& origin) {
    json_.key(key);
    json_.pose(to_pose(origin));
  }

  void material(const urdf::Material& material) {
    json_.begin_object();
    head(urdf::kMaterial, material);
    values(urdf::kColor, material);
    values(urdf::kTexture, material);
    json_.end();
  }

  /// Name, place and other attributes of an entry.
  template <class T>
  void head(urdf::Rows<T> rows, const T& entry) {
    print_field(json_, "name", entry.name);
    source(entry.span);
    values(rows.subspan(1), entry);
  }

  template <class T>
  void values(urdf::Rows<T> rows, const T& object) {
    urdf::for_each_field(rows, object, [&](const urdf::AttributeSpec& spec, const auto& field) {
      if (!spec.values.empty()) return;  // a JointType, which is printed instead of its word
      print_field(json_, spec.member_name(), field);
      if (spec.is_path && field) file(field.span);
    });
  }

  /// The file that was found for a path.
  void file(Span written) {
    const auto found = files_.find(written.begin);
    if (found == files_.end() || found->second->path.empty()) return;
    json_.member("file", found->second->path);
    json_.key("exists");
    json_.boolean(found->second->exists);
  }

  void link(const urdf::Link& link) {
    json_.begin_object(Layout::block);
    head(urdf::kLink, link);
    if (link.inertial) inertial(*link.inertial);
    list("visuals", link.visuals, [&](const urdf::Visual& one) {
      json_.begin_object();
      shape_of(urdf::kVisual, one, "X_LV");
      if (one.material) {
        json_.key("material");
        material(*one.material);
      }
      json_.end();
    });
    list("collisions", link.collisions, [&](const urdf::Collision& one) {
      json_.begin_object();
      shape_of(urdf::kCollision, one, "X_LC");
      json_.end();
    });
    json_.end();
  }

  void inertial(const urdf::Inertial& inertial) {
    json_.key("inertial");
    json_.begin_object();
    source(inertial.span);
    values(urdf::kMass, inertial);
    pose("X_LI", inertial.origin);
    object("inertia", urdf::kInertia, inertial);
    json_.end();
  }

  /// Members that visuals and collisions share.
  template <class T>
  void shape_of(urdf::Rows<T> rows, const T& part, std::string_view frames) {
    head(rows, part);
    pose(frames, part.origin);
    if (std::holds_alternative<std::monostate>(part.geometry.shape)) return;
    json_.key("geometry");
    json_.begin_object();
    json_.key("type");
    std::visit([&](const auto& shape) { this->shape(shape); }, part.geometry.shape);
    json_.end();
  }

  void shape(std::monostate) {}
  void shape(const urdf::Box& box) { shape("box", urdf::kBox, box); }
  void shape(const urdf::Sphere& sphere) { shape("sphere", urdf::kSphere, sphere); }
  void shape(const urdf::Cylinder& cylinder) { shape("cylinder", urdf::kCylinder, cylinder); }
  void shape(const urdf::Capsule& capsule) { shape("capsule", urdf::kCapsule, capsule); }
  void shape(const urdf::Mesh& mesh) { shape("mesh", urdf::kMesh, mesh); }
  template <class T>
  void shape(std::string_view type, urdf::Rows<T> rows, const T& shape) {
    json_.text(type);
    values(rows, shape);
  }

  void joint(const urdf::Joint& joint) {
    json_.begin_object(Layout::block);
    head(urdf::kJoint, joint);
    json_.member("type", name_of(joint.type));
    values(urdf::kParent, joint);
    values(urdf::kChild, joint);
    pose("X_PJ", joint.origin);
    values(urdf::kAxis, joint);
    if (joint.limit) object("limit", urdf::kLimit, *joint.limit);
    if (joint.dynamics) object("dynamics", urdf::kDynamics, *joint.dynamics);
    if (joint.mimic) object("mimic", urdf::kMimic, *joint.mimic);
    if (const auto& safety = joint.safety_controller) {
      object("safety_controller", urdf::kSafetyController, *safety);
    }
    if (joint.calibration) object("calibration", urdf::kCalibration, *joint.calibration);
    json_.end();
  }

  template <class T>
  void object(std::string_view key, urdf::Rows<T> rows, const T& part) {
    json_.key(key);
    json_.begin_object();
    values(rows, part);
    json_.end();
  }

  void extension(xml::ElementId id) {
    const xml::View element(robot_.document, id);
    json_.begin_object();
    json_.member("element", element.name());
    source(element.span());
    json_.end();
  }

  JsonPrinter& json_;
  const LinkedModel& model_;
  const SourceMap& sources_;
  const urdf::Robot& robot_;
  /// Meshes and textures, by the places of their names.
  std::unordered_map<std::uint32_t, const MeshReference*> files_;
};

}  // namespace

void print_robot(JsonPrinter& json, const LinkedModel& model, const SourceMap& sources) {
  if (model.robot) RobotPrinter(json, model, sources).print();
}

}  // namespace smurf
