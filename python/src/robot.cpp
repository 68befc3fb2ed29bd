// SPDX-License-Identifier: BSD-3-Clause
// The contents of a URDF.
#include <array>
#include <variant>

#include "model.hpp"
#include "reference.hpp"
#include "smurf/urdf.hpp"

namespace smurf::python {
namespace {

py::str name_of(urdf::JointType type) {
  static constexpr std::array<const char*, 7> kNames = {
      "revolute", "continuous", "prismatic", "fixed", "floating", "planar", "unknown"};
  return {kNames[static_cast<std::size_t>(type)]};
}

py::object geometry_of(const OwnerPtr& owner, const urdf::Geometry& geometry) {
  return std::visit(
      [&](const auto& shape) -> py::object {
        using Shape = std::decay_t<decltype(shape)>;
        if constexpr (std::is_same_v<Shape, std::monostate>) {
          return py::none();
        } else {
          return py::cast(Ref<Shape>{owner, &shape});
        }
      },
      geometry.shape);
}

void bind_shapes(py::module_& module) {
  ReferenceClass<urdf::Box>(module, "Box", "A box around its origin.")
      .field("size", &urdf::Box::size, "Full edge lengths: array of shape (3,), m.");
  ReferenceClass<urdf::Sphere>(module, "Sphere", "A sphere around its origin.")
      .field("radius", &urdf::Sphere::radius, "m.");
  ReferenceClass<urdf::Cylinder>(module, "Cylinder", "A cylinder around its origin, along z.")
      .field("radius", &urdf::Cylinder::radius, "m.")
      .field("length", &urdf::Cylinder::length, "m.");
  ReferenceClass<urdf::Capsule>(module, "Capsule", "A capsule around its origin, along z.")
      .field("radius", &urdf::Capsule::radius, "m.")
      .field("length", &urdf::Capsule::length, "Of the cylindrical part, m.");
  ReferenceClass<urdf::Mesh>(module, "Mesh", "A mesh file.")
      .field("filename", &urdf::Mesh::filename, "As it is written.")
      .field("scale", &urdf::Mesh::scale, "Array of shape (3,).")
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

void bind_parts(py::module_& module) {
  ReferenceClass<urdf::Material>(module, "Material", "A material of the URDF.")
      .field("name", &urdf::Material::name, "Name.")
      .field("rgba", &urdf::Material::rgba, "Red, green, blue, alpha, each 0 to 1.")
      .field("texture", &urdf::Material::texture, "Image file, as it is written.");
  ReferenceClass<urdf::Inertial>(module, "Inertial", "Mass and inertia of a link.")
      .field("mass", &urdf::Inertial::mass, "kg.")
      .attribute(
          "X_LI", [](const Ref<urdf::Inertial>& self) { return to_matrix4(to_pose(self->origin)); },
          "Pose of the inertial frame I, whose origin is the centre of mass, in the link: array of "
          "shape (4, 4), m.")
      .attribute(
          "inertia",
          [](const Ref<urdf::Inertial>& self) -> py::object {
            const auto& [xx, xy, xz, yy, yz, zz] =
                std::tie(self->ixx, self->ixy, self->ixz, self->iyy, self->iyz, self->izz);
            for (const Field<double>* part : {&xx, &xy, &xz, &yy, &yz, &zz}) {
              if (!*part) return py::none();
            }
            py::array_t<double> matrix = new_array({3, 3});
            auto to = matrix.mutable_unchecked<2>();
            to(0, 0) = *xx;
            to(1, 1) = *yy;
            to(2, 2) = *zz;
            to(0, 1) = to(1, 0) = *xy;
            to(0, 2) = to(2, 0) = *xz;
            to(1, 2) = to(2, 1) = *yz;
            return matrix;
          },
          "About the centre of mass, in the inertial frame: array of shape (3, 3), kg m^2. None "
          "when one of the six numbers is missing.");
  ReferenceClass<urdf::Visual>(module, "Visual", "What is seen of a link.")
      .field("name", &urdf::Visual::name, "Name.")
      .attribute(
          "X_LV", [](const Ref<urdf::Visual>& self) { return to_matrix4(to_pose(self->origin)); },
          "Pose in the link: array of shape (4, 4), m.")
      .attribute(
          "geometry",
          [](const Ref<urdf::Visual>& self) { return geometry_of(self.owner, self->geometry); },
          "smurf.Box, Sphere, Cylinder, Capsule or Mesh; None when there is none.")
      .attribute(
          "material",
          [](const Ref<urdf::Visual>& self) { return to_optional(self.owner, self->material); },
          "smurf.Material or None.");
  ReferenceClass<urdf::Collision>(module, "Collision",
                                  "The shape of a link for collision detection.")
      .field("name", &urdf::Collision::name, "Name.")
      .attribute(
          "X_LC",
          [](const Ref<urdf::Collision>& self) { return to_matrix4(to_pose(self->origin)); },
          "Pose in the link: array of shape (4, 4), m.")
      .attribute(
          "geometry",
          [](const Ref<urdf::Collision>& self) { return geometry_of(self.owner, self->geometry); },
          "smurf.Box, Sphere, Cylinder, Capsule or Mesh; None when there is none.");
  ReferenceClass<urdf::Link>(module, "Link", "A link.")
      .method("__reduce__", [](const Ref<urdf::Link>& self) { return reduce(self); })
      .field("name", &urdf::Link::name, "Name.")
      .attribute(
          "inertial",
          [](const Ref<urdf::Link>& self) { return to_optional(self.owner, self->inertial); },
          "smurf.Inertial or None.")
      .attribute(
          "visuals", [](const Ref<urdf::Link>& self) { return to_list(self.owner, self->visuals); },
          "A new list of smurf.Visual.")
      .attribute(
          "collisions",
          [](const Ref<urdf::Link>& self) { return to_list(self.owner, self->collisions); },
          "A new list of smurf.Collision.");
}

void bind_joint(py::module_& module) {
  ReferenceClass<urdf::Limit>(module, "Limit", "Limits of a joint.")
      .field("lower", &urdf::Limit::lower, "Lowest position, rad or m.")
      .field("upper", &urdf::Limit::upper, "Highest position, rad or m.")
      .field("effort", &urdf::Limit::effort, "N m or N.")
      .field("velocity", &urdf::Limit::velocity, "rad/s or m/s.");
  ReferenceClass<urdf::Dynamics>(module, "Dynamics", "Damping and friction of a joint.")
      .field("damping", &urdf::Dynamics::damping, "N m s/rad or N s/m.")
      .field("friction", &urdf::Dynamics::friction, "N m or N.");
  ReferenceClass<urdf::Mimic>(module, "Mimic", "A joint follows another one.")
      .field("joint", &urdf::Mimic::joint, "Name of the joint that it follows.")
      .field("multiplier", &urdf::Mimic::multiplier, "1 when it is not written.")
      .field("offset", &urdf::Mimic::offset, "rad or m; 0 when it is not written.");
  ReferenceClass<urdf::Joint>(module, "Joint", "A joint.")
      .method("__reduce__", [](const Ref<urdf::Joint>& self) { return reduce(self); })
      .field("name", &urdf::Joint::name, "Name.")
      .attribute(
          "type", [](const Ref<urdf::Joint>& self) { return name_of(self->type); },
          "\"revolute\", \"continuous\", \"prismatic\", \"fixed\", \"floating\", \"planar\" or "
          "\"unknown\".")
      .field("parent", &urdf::Joint::parent, "Name of the parent link.")
      .field("child", &urdf::Joint::child, "Name of the child link.")
      .field("axis", &urdf::Joint::axis,
             "As written, in the joint's frame: array of shape (3,), not normalised. (1, 0, 0) "
             "when it is None.")
      .attribute(
          "X_PJ", [](const Ref<urdf::Joint>& self) { return to_matrix4(to_pose(self->origin)); },
          "Pose of the joint's frame, which is that of the child link at position zero, in the "
          "parent link: array of shape (4, 4), m.")
      .attribute(
          "limit",
          [](const Ref<urdf::Joint>& self) { return to_optional(self.owner, self->limit); },
          "smurf.Limit or None.")
      .attribute(
          "dynamics",
          [](const Ref<urdf::Joint>& self) { return to_optional(self.owner, self->dynamics); },
          "smurf.Dynamics or None.")
      .attribute(
          "mimic",
          [](const Ref<urdf::Joint>& self) { return to_optional(self.owner, self->mimic); },
          "smurf.Mimic or None.")
      .attribute(
          "is_movable", [](const Ref<urdf::Joint>& self) { return self->is_movable(); },
          "True for a joint that can move.");
}

}  // namespace

void bind_robot(py::module_& module) {
  bind_shapes(module);
  bind_parts(module);
  bind_joint(module);
}

}  // namespace smurf::python
