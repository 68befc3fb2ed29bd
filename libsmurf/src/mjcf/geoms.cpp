// SPDX-License-Identifier: BSD-3-Clause
// Shapes with their poses, sizes and masses.
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/findings/rules.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/meshes.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

constexpr double kDensity = 1000;

Extent extent_of(Shape shape, const std::array<double, 3>& size, bool is_shell) {
  switch (shape) {
  case Shape::sphere: return imports::sphere(size[0], is_shell);
  case Shape::capsule: return imports::capsule(size[0], size[1], is_shell);
  case Shape::cylinder: return imports::cylinder(size[0], size[1], is_shell);
  case Shape::ellipsoid: return imports::ellipsoid(size, is_shell);
  case Shape::box: return imports::box(size, is_shell);
  default: return {};
  }
}

std::size_t sizes_of(Shape shape) {
  switch (shape) {
  case Shape::sphere: return 1;
  case Shape::capsule:
  case Shape::cylinder: return 2;
  case Shape::ellipsoid:
  case Shape::box: return 3;
  default: return 0;
  }
}

/// The length, the middle and the direction of a shape between two points.
void read_fromto(const Settings& s, Geom& geom, Reporter& reporter) {
  std::array<double, 6> points{};
  if (s.numbers("fromto", points, 6, reporter) < 6) return;
  const Span place = s.place({"fromto"}).origin;
  if (geom.shape != Shape::capsule && geom.shape != Shape::cylinder && geom.shape != Shape::box &&
      geom.shape != Shape::ellipsoid) {
    reporter.refuse(place, "`fromto` is for capsules, cylinders, boxes and ellipsoids",
                    "write `type`, or `pos` and `size`");
    return;
  }
  const Vector3 from{points[0], points[1], points[2]};
  const Vector3 to{points[3], points[4], points[5]};
  const Vector3 d = difference(from, to);
  const double length = std::sqrt(dot(d, d));
  if (!(length >= 1e-14)) {
    reporter.refuse(place, "the two points of `fromto` are the same", "move one of them");
    return;
  }
  geom.size[1] = length / 2;
  if (geom.shape == Shape::box || geom.shape == Shape::ellipsoid) {
    geom.size[2] = geom.size[1];
    geom.size[1] = geom.size[0];
  }
  for (std::size_t i = 0; i < 3; ++i) geom.pose.position[i] = (from[i] + to[i]) / 2;
  geom.pose.orientation = normalized(turn_from_z({d[0] / length, d[1] / length, d[2] / length}));
}

/// A primitive that stands for a mesh: one of the same inertia, or of the same box.
void fit(const Mesh& mesh, double scale, bool by_box, Geom& geom) {
  if (!mesh.properties) return;
  const MassProperties& m = *mesh.properties;
  const Principal principal = imports::principal_of(m.inertia);
  Vector3 half{};
  Vector3 center{};
  if (by_box) {
    for (std::size_t i = 0; i < 3; ++i) {
      half[i] = (mesh.high[i] - mesh.low[i]) / 2;
      center[i] = (mesh.high[i] + mesh.low[i]) / 2;
    }
  } else {
    const double sum = principal.moments[0] + principal.moments[1] + principal.moments[2];
    for (std::size_t i = 0; i < 3; ++i)
      half[i] = std::sqrt(std::max(0.0, 6 * (sum - 2 * principal.moments[i]) / m.mass)) / 2;
  }
  switch (geom.shape) {
  case Shape::sphere:
    geom.size[0] =
        by_box ? std::max({half[0], half[1], half[2]}) : (half[0] + half[1] + half[2]) / 3;
    break;
  case Shape::capsule:
    geom.size[0] = by_box ? std::max(half[0], half[1]) : (half[0] + half[1]) / 2;
    geom.size[1] =
        by_box ? std::max(0.0, half[2] - geom.size[0]) : std::max(0.0, half[2] - geom.size[0] / 2);
    break;
  case Shape::cylinder:
    geom.size[0] = by_box ? std::max(half[0], half[1]) : (half[0] + half[1]) / 2;
    geom.size[1] = half[2];
    break;
  default: geom.size = {half[0], half[1], half[2]}; break;
  }
  for (double& one : geom.size) one *= scale;
  const Pose inertial{m.center, principal.axes};
  geom.pose = geom.pose * (inertial * Pose{center, {}});
}

/// False if MuJoCo refuses the size.
bool check_size(const Settings& s, const Geom& geom, Reporter& reporter) {
  for (std::size_t i = 0; i < sizes_of(geom.shape); ++i) {
    if (geom.size[i] > 0) continue;
    const Attribute* written = s.find("size");
    if (written == nullptr) {
      reporter.refuse(s.element().name_span(), "this shape has no size",
                      "write `size`, with half of each length");
    } else {
      reporter.refuse(written->value_span(),
                      "the " +
                          std::string(i == 0   ? "first"
                                      : i == 1 ? "second"
                                               : "third") +
                          " size is not positive",
                      "write half of the length");
    }
    return false;
  }
  return true;
}

/// The sides of a plane may be 0, for one without an end; its third size is the distance of the
/// lines of its grid.
bool check_plane(const Settings& s, const Geom& geom, Reporter& reporter) {
  if (geom.size[2] > 0) return true;
  const Attribute* written = s.find("size");
  reporter.refuse(written != nullptr ? written->value_span() : s.element().name_span(),
                  "the third size of a plane is not positive",
                  "write three numbers, such as `size=\"0 0 1\"` for a plane without an end");
  return false;
}

/// None where it is that of the density: not written, blank, or NaN, which MuJoCo has for that.
std::optional<double> mass_of(const Settings& s, Reporter& reporter) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  const double mass = s.number("mass", kNone, reporter);
  return std::isnan(mass) ? std::nullopt : std::optional(mass);
}

/// Written as no mass; then the volume does not matter.
bool mass_is_zero(const Settings& s, Reporter& reporter) {
  const std::optional<double> mass = mass_of(s, reporter);
  return mass ? *mass == 0 : s.number("density", kDensity, reporter) == 0;
}

void read_colour(const Settings& s, Geom& geom, Reporter& reporter) {
  std::array<double, 4> rgba{0.5, 0.5, 0.5, 1};
  if (s.numbers("rgba", rgba, 4, reporter) > 0) geom.rgba = rgba;
  geom.material = s.text("material");
}

}  // namespace

std::optional<Geom> read_geom(View element, const Surroundings& around, Meshes& meshes,
                              bool is_world, Reporter& reporter) {
  Geom geom;
  const ModelFile& file = *around.file;
  geom.file = &file;
  geom.frame = around.frame;
  geom.settings = Settings(element, file.class_of(element, around.childclass));
  const Settings& s = geom.settings;
  if (const Attribute* type = s.find("type")) {
    constexpr std::string_view kTypes[] = {"plane",    "hfield", "sphere", "capsule", "ellipsoid",
                                           "cylinder", "box",    "mesh",   "sdf"};
    geom.shape = static_cast<Shape>(word_of(*type, kTypes, reporter).value_or(2));
  }
  s.numbers("size", geom.size, 0, reporter);
  geom.pose = pose_of(s, file.compiler(), reporter);
  if (s.has("fromto")) read_fromto(s, geom, reporter);
  geom.group = s.integer("group", 0, reporter);
  geom.contype = s.integer("contype", 1, reporter);
  geom.conaffinity = s.integer("conaffinity", 1, reporter);
  read_colour(s, geom, reporter);
  geom.mesh = s.text("mesh");
  bool is_shell = false;
  if (const Attribute* shell = s.find("shellinertia"))
    is_shell = truth_of(*shell, reporter).value_or(false);
  const bool is_meshed = geom.shape == Shape::mesh || geom.shape == Shape::sdf;
  const auto& groups = file.compiler().inertiagrouprange;
  const bool is_light = mass_is_zero(s, reporter);
  const bool counts = !is_world && around.weighs_geoms && !is_light && geom.group >= groups[0] &&
                      geom.group <= groups[1];
  const std::optional<double> written_mass = mass_of(s, reporter);
  const double mass = written_mass.value_or(0);
  const double density = s.number("density", kDensity, reporter);
  if (mass < 0 || density < 0) {
    reporter.refuse(s.place({mass < 0 ? "mass" : "density"}).origin, "a negative mass",
                    "write a number of at least 0");
  }
  const Mesh* mesh = nullptr;
  if (!geom.mesh.empty()) {
    const bool is_fitted = !is_meshed;
    mesh = meshes.find(file, geom.mesh, is_fitted || (counts && geom.shape == Shape::mesh));
    if (mesh == nullptr) {
      reporter.refuse_name(s.place({"mesh"}).origin, "there is no mesh " + quoted(geom.mesh),
                           "add it to `<asset>`");
      return std::nullopt;
    }
    if (is_fitted && geom.shape != Shape::plane && geom.shape != Shape::hfield) {
      if (!mesh->properties) {
        geom.size.fill(std::numeric_limits<double>::quiet_NaN());  // so no shape is written
        return geom;
      }
      fit(*mesh, s.number("fitscale", 1, reporter), file.compiler().fitaabb, geom);
    }
  } else if (is_meshed) {
    reporter.refuse(element.name_span(), "this shape needs a `mesh`",
                    "write the name of a mesh of `<asset>`");
    return std::nullopt;
  }
  if (geom.shape == Shape::mesh) geom.mesh_pose = geom.pose * mesh->origin;
  if (geom.shape == Shape::plane && !check_plane(s, geom, reporter)) return std::nullopt;
  if (!is_meshed && geom.shape != Shape::plane && geom.shape != Shape::hfield &&
      !check_size(s, geom, reporter))
    return geom;
  MassProperties result;
  if (geom.shape == Shape::plane || geom.shape == Shape::hfield || !counts || mass < 0 ||
      density < 0) {
    geom.mass = result;
    return geom;
  }
  if (is_meshed) {
    if (written_mass && mass == 0) {
      geom.mass = result;
    } else if (mesh->properties) {
      result = mesh->properties->in(geom.pose);
      result.scale(written_mass ? mass / mesh->properties->mass : density);
      geom.mass = result;
    } else if (!mesh->settings.has("builtin") && mesh->is_refused) {
      reporter.refuse(mesh->settings.place({"file", "vertex"}).origin,
                      "the volume of the mesh is too small, or its faces look inward",
                      "turn its faces outward, or write `inertia=\"convex\"`");
    }
    return geom;
  }
  const Extent extent = extent_of(geom.shape, geom.size, is_shell);
  result.mass = written_mass ? mass : density * extent.volume;
  result.inertia = {result.mass * extent.moments[0],
                    result.mass * extent.moments[1],
                    result.mass * extent.moments[2],
                    0,
                    0,
                    0};
  geom.mass = result.in(geom.pose);
  return geom;
}

}  // namespace smurf::mjcf
