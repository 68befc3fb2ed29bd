// SPDX-License-Identifier: BSD-3-Clause
// The URDF of a model as written, in document order. Poses name their frames, X_PJ is that of a
// joint in its parent link.
#include <array>
#include <unordered_map>
#include <utility>
#include <variant>

#include "write/json/model_json.hpp"

namespace smurf {

void print_field(JsonPrinter& json, std::string_view key, const Field<std::string>& field) {
  if (!field) return;
  json.member(key, *field);
}

void print_field(JsonPrinter& json, std::string_view key, const Field<double>& field) {
  if (!field) return;
  json.key(key);
  json.number(*field);
}

void print_field(JsonPrinter& json, std::string_view key, const Field<Vector3>& field) {
  if (!field) return;
  json.key(key);
  json.vector(*field);
}

namespace {

using Layout = JsonPrinter::Layout;

std::string_view name_of(urdf::JointType type) {
  static constexpr std::array<std::string_view, 7> kNames = {
      "revolute", "continuous", "prismatic", "fixed", "floating", "planar", "unknown"};
  return kNames[static_cast<std::size_t>(type)];
}

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
    print_field(json_, "name", material.name);
    source(material.span);
    if (material.rgba) {
      json_.key("rgba");
      json_.numbers(*material.rgba);
    }
    if (material.texture) file("texture", material.texture);
    json_.end();
  }

  /// The value as written, and the file that was found for it.
  void file(std::string_view key, const Field<std::string>& filename) {
    if (!filename) return;
    print_field(json_, key, filename);
    const auto found = files_.find(filename.span.begin);
    if (found == files_.end() || found->second->path.empty()) return;
    json_.member("file", found->second->path);
    json_.key("exists");
    json_.boolean(found->second->exists);
  }

  void link(const urdf::Link& link) {
    json_.begin_object(Layout::block);
    print_field(json_, "name", link.name);
    source(link.span);
    if (link.inertial) inertial(*link.inertial);
    list("visuals", link.visuals, [&](const urdf::Visual& one) {
      json_.begin_object();
      shape_of(one, "X_LV");
      if (one.material) {
        json_.key("material");
        material(*one.material);
      }
      json_.end();
    });
    list("collisions", link.collisions, [&](const urdf::Collision& one) {
      json_.begin_object();
      shape_of(one, "X_LC");
      json_.end();
    });
    json_.end();
  }

  void inertial(const urdf::Inertial& inertial) {
    json_.key("inertial");
    json_.begin_object();
    source(inertial.span);
    print_field(json_, "mass", inertial.mass);
    pose("X_LI", inertial.origin);
    json_.key("inertia");
    json_.begin_object();
    for (const auto& [key, field] :
         {std::pair("ixx", &inertial.ixx), std::pair("ixy", &inertial.ixy),
          std::pair("ixz", &inertial.ixz), std::pair("iyy", &inertial.iyy),
          std::pair("iyz", &inertial.iyz), std::pair("izz", &inertial.izz)}) {
      print_field(json_, key, *field);
    }
    json_.end();
    json_.end();
  }

  /// Members that visuals and collisions share.
  template <class Part>
  void shape_of(const Part& part, std::string_view frames) {
    print_field(json_, "name", part.name);
    source(part.span);
    pose(frames, part.origin);
    if (std::holds_alternative<std::monostate>(part.geometry.shape)) return;
    json_.key("geometry");
    json_.begin_object();
    json_.key("type");
    std::visit([&](const auto& shape) { this->shape(shape); }, part.geometry.shape);
    json_.end();
  }

  void shape(std::monostate) {}
  void shape(const urdf::Box& box) {
    json_.text("box");
    print_field(json_, "size", box.size);
  }
  void shape(const urdf::Sphere& sphere) {
    json_.text("sphere");
    print_field(json_, "radius", sphere.radius);
  }
  void shape(const urdf::Cylinder& cylinder) {
    json_.text("cylinder");
    print_field(json_, "radius", cylinder.radius);
    print_field(json_, "length", cylinder.length);
  }
  void shape(const urdf::Capsule& capsule) {
    json_.text("capsule");
    print_field(json_, "radius", capsule.radius);
    print_field(json_, "length", capsule.length);
  }
  void shape(const urdf::Mesh& mesh) {
    json_.text("mesh");
    file("filename", mesh.filename);
    print_field(json_, "scale", mesh.scale);
  }

  void joint(const urdf::Joint& joint) {
    json_.begin_object(Layout::block);
    print_field(json_, "name", joint.name);
    source(joint.span);
    json_.member("type", name_of(joint.type));
    print_field(json_, "parent", joint.parent);
    print_field(json_, "child", joint.child);
    pose("X_PJ", joint.origin);
    print_field(json_, "axis", joint.axis);
    if (const auto& limit = joint.limit) {
      part("limit", {{"lower", &limit->lower},
                     {"upper", &limit->upper},
                     {"effort", &limit->effort},
                     {"velocity", &limit->velocity}});
    }
    if (const auto& dynamics = joint.dynamics) {
      part("dynamics", {{"damping", &dynamics->damping}, {"friction", &dynamics->friction}});
    }
    if (const auto& mimic = joint.mimic) {
      json_.key("mimic");
      json_.begin_object();
      print_field(json_, "joint", mimic->joint);
      print_field(json_, "multiplier", mimic->multiplier);
      print_field(json_, "offset", mimic->offset);
      json_.end();
    }
    if (const auto& safety = joint.safety_controller) {
      part("safety_controller", {{"soft_lower_limit", &safety->soft_lower_limit},
                                 {"soft_upper_limit", &safety->soft_upper_limit},
                                 {"k_position", &safety->k_position},
                                 {"k_velocity", &safety->k_velocity}});
    }
    if (const auto& calibration = joint.calibration) {
      part("calibration", {{"rising", &calibration->rising}, {"falling", &calibration->falling}});
    }
    json_.end();
  }

  void part(std::string_view key,
            std::initializer_list<std::pair<std::string_view, const Field<double>*>> numbers) {
    json_.key(key);
    json_.begin_object();
    for (const auto& [name, field] : numbers) print_field(json_, name, *field);
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
