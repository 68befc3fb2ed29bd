// SPDX-License-Identifier: BSD-3-Clause
// The contents of a URDF. What URDF calls an attribute is a property by its row in the tables of
// the library.
#include <variant>

#include "ast/urdf_attributes.hpp"
#include "link/inertia.hpp"
#include "model.hpp"
#include "reference.hpp"

namespace smurf::python {
namespace {

/// "Lowest position, rad or m; None means 0."
std::string doc_of(const urdf::AttributeSpec& spec, bool is_array) {
  std::string doc(spec.doc.substr(0, spec.doc.size() - 1));
  if (!spec.unit.empty()) doc.append(", ").append(spec.unit);
  if (!spec.fallback.empty()) doc.append("; None means ").append(spec.fallback);
  return doc + (is_array ? ". As written: array of shape (3,)." : ".");
}

/// The class of an element.
template <class T>
class ElementClass : public ReferenceClass<T> {
 public:
  ElementClass(py::module_& module, const char* name, std::string_view element)
      : ReferenceClass<T>(module, name, urdf::find_element_spec(element)->doc.data()) {}

  /// A property for each row with a member.
  ElementClass& attributes(urdf::Rows<T> rows) {
    for (const urdf::Attribute<T>& row : rows) {
      std::visit([&](auto member) { this->row(row.spec, member); }, row.member);
    }
    return *this;
  }

  /// An optional member, or a list.
  template <class Part>
  ElementClass& part(const char* name, Part T::*member, const char* doc) {
    const auto get = [member](const Ref<T>& self) {
      const Part& value = (*self).*member;
      if constexpr (requires { value.begin(); }) {
        return to_list(self.owner, value);
      } else {
        return to_optional(self.owner, value);
      }
    };
    this->attribute(name, get, doc);
    return *this;
  }
  ElementClass& pose(const char* name, const char* doc) {
    this->attribute(
        name, [](const Ref<T>& self) { return to_matrix4(to_pose(self->origin)); }, doc);
    return *this;
  }
  ElementClass& geometry() {
    this->attribute(
        "geometry",
        [](const Ref<T>& self) {
          return std::visit([&](const auto& shape) { return to_object(self.owner, shape); },
                            self->geometry.shape);
        },
        "smurf.Box, Sphere, Cylinder, Capsule or Mesh; None when there is none.");
    return *this;
  }

 private:
  void row(const urdf::AttributeSpec&, std::monostate) {}
  template <class V>
  void row(const urdf::AttributeSpec& spec, Field<V> T::*member) {
    // Names are literals, which end in a null character.
    this->field(spec.member_name().data(), member,
                doc_of(spec, std::is_same_v<V, Vector3>).c_str());
  }

  static py::object to_object(const OwnerPtr&, std::monostate) { return py::none(); }
  template <class Shape>
  static py::object to_object(const OwnerPtr& owner, const Shape& shape) {
    return py::cast(Ref<Shape>{owner, &shape});
  }
};

void bind_shapes(py::module_& module) {
  ElementClass<urdf::Box>(module, "Box", "box").attributes(urdf::kBox);
  ElementClass<urdf::Sphere>(module, "Sphere", "sphere").attributes(urdf::kSphere);
  ElementClass<urdf::Cylinder>(module, "Cylinder", "cylinder").attributes(urdf::kCylinder);
  ElementClass<urdf::Capsule>(module, "Capsule", "capsule").attributes(urdf::kCapsule);
  ElementClass<urdf::Mesh>(module, "Mesh", "mesh")
      .attributes(urdf::kMesh)
      .attribute(
          "path",
          [](const Ref<urdf::Mesh>& self) -> py::object {
            const MeshReference* mesh = self.owner->mesh_at(self->filename.span);
            if (mesh == nullptr || mesh->path.empty()) return py::none();
            return to_path(mesh->path);
          },
          "Where the file is, as URDF readers look for it; None when it is unknown.")
      .attribute(
          "exists",
          [](const Ref<urdf::Mesh>& self) {
            const MeshReference* mesh = self.owner->mesh_at(self->filename.span);
            return mesh != nullptr && mesh->exists;
          },
          "Whether there is a file.");
}

py::object inertia_of(const Ref<urdf::Inertial>& self) {
  const auto entries = entries_of(*self);
  for (const Field<double>* entry : entries) {
    if (!*entry) return py::none();
  }
  const auto& [xx, xy, xz, yy, yz, zz] = entries;
  py::array_t<double> matrix = new_array({3, 3});
  auto to = matrix.mutable_unchecked<2>();
  to(0, 0) = **xx;
  to(1, 1) = **yy;
  to(2, 2) = **zz;
  to(0, 1) = to(1, 0) = **xy;
  to(0, 2) = to(2, 0) = **xz;
  to(1, 2) = to(2, 1) = **yz;
  return matrix;
}

void bind_link(py::module_& module) {
  ElementClass<urdf::Material>(module, "Material", "material")
      .attributes(urdf::kMaterial)
      .attributes(urdf::kColor)
      .attributes(urdf::kTexture);
  ElementClass<urdf::Inertial>(module, "Inertial", "inertial")
      .attributes(urdf::kMass)
      .pose("X_LI",
            "Pose of the inertial frame I, whose origin is the centre of mass, in the link: array "
            "of shape (4, 4), m.")
      .attribute("inertia", inertia_of,
                 "About the centre of mass, in the inertial frame: array of shape (3, 3), kg m^2. "
                 "None when one of the six numbers is missing.");
  ElementClass<urdf::Visual>(module, "Visual", "visual")
      .attributes(urdf::kVisual)
      .pose("X_LV", "Pose in the link: array of shape (4, 4), m.")
      .geometry()
      .part("material", &urdf::Visual::material, "smurf.Material or None.");
  ElementClass<urdf::Collision>(module, "Collision", "collision")
      .attributes(urdf::kCollision)
      .pose("X_LC", "Pose in the link: array of shape (4, 4), m.")
      .geometry();
  ElementClass<urdf::Link>(module, "Link", "link")
      .attributes(urdf::kLink)
      .part("inertial", &urdf::Link::inertial, "smurf.Inertial or None.")
      .part("visuals", &urdf::Link::visuals, "A new list of smurf.Visual.")
      .part("collisions", &urdf::Link::collisions, "A new list of smurf.Collision.")
      .method("__reduce__", [](const Ref<urdf::Link>& self) { return reduce(self); });
}

void bind_joint(py::module_& module) {
  using urdf::Joint;
  ElementClass<urdf::Limit>(module, "Limit", "limit").attributes(urdf::kLimit);
  ElementClass<urdf::Dynamics>(module, "Dynamics", "dynamics").attributes(urdf::kDynamics);
  ElementClass<urdf::Mimic>(module, "Mimic", "mimic").attributes(urdf::kMimic);
  ElementClass<urdf::SafetyController>(module, "SafetyController", "safety_controller")
      .attributes(urdf::kSafetyController);
  ElementClass<urdf::Calibration>(module, "Calibration", "calibration")
      .attributes(urdf::kCalibration);
  ElementClass<Joint>(module, "Joint", "joint")
      .attributes(urdf::kJoint)
      .attributes(urdf::kParent)
      .attributes(urdf::kChild)
      .attributes(urdf::kAxis)
      .pose("X_PJ",
            "Pose of the joint's frame, which is that of the child link at position zero, in the "
            "parent link: array of shape (4, 4), m.")
      .part("limit", &Joint::limit, "smurf.Limit or None.")
      .part("dynamics", &Joint::dynamics, "smurf.Dynamics or None.")
      .part("mimic", &Joint::mimic, "smurf.Mimic or None.")
      .part("safety_controller", &Joint::safety_controller, "smurf.SafetyController or None.")
      .part("calibration", &Joint::calibration, "smurf.Calibration or None.")
      .method("__reduce__", [](const Ref<Joint>& self) { return reduce(self); })
      .attribute(
          "type", [](const Ref<Joint>& self) { return py::str(std::string(name_of(self->type))); },
          "\"revolute\", \"continuous\", \"prismatic\", \"fixed\", \"floating\", \"planar\" or "
          "\"unknown\".")
      .attribute(
          "is_movable", [](const Ref<Joint>& self) { return self->is_movable(); },
          "True for a joint that can move.");
}

}  // namespace

void bind_robot(py::module_& module) {
  bind_shapes(module);
  bind_link(module);
  bind_joint(module);
}

}  // namespace smurf::python
