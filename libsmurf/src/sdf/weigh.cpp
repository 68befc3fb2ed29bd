// SPDX-License-Identifier: BSD-3-Clause
// Masses of links: as they are written, as SDF assumes them, or of the collisions.
#include <algorithm>
#include <cmath>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "mesh/mesh_reader.hpp"
#include "sdf/model.hpp"
#include "sdf/shapes.hpp"

namespace smurf::sdformat {
namespace {

constexpr double kDensity = 1000;  // kg/m^3: that of water, unless another is written

class Scales {
 public:
  Scales(Model& model, Files& files, Reporter& reporter)
      : model_(model), files_(files), reporter_(reporter), frames_(reporter) {}

  void run() {
    for (Link& link : model_.links) weigh(link);
  }

 private:
  void weigh(Link& link) {
    const View inertial = link.vertex->element.child("inertial");
    const xacro::FrameId frame = link.vertex->scope->frame;
    link.has_inertial = static_cast<bool>(inertial);
    const View base = inertial ? inertial : link.vertex->element;
    link.of_mass = place_in(base, "mass", frame);
    link.of_center = place_in(base, "pose", frame);
    link.of_inertia = place_in(base, "inertia", frame);
    if (inertial && sdf::read_flag(attribute_of(inertial, "auto")).value_or(false) &&
        link.vertex->scope->file->version >= 10) {
      weigh_collisions(link, inertial);
      return;
    }
    MassProperties mass;
    mass.mass = number_in(inertial, "mass", 1);
    const View inertia = inertial ? inertial.child("inertia") : View();
    mass.inertia = {number_in(inertia, "ixx", 1), number_in(inertia, "iyy", 1),
                    number_in(inertia, "izz", 1), number_in(inertia, "ixy", 0),
                    number_in(inertia, "ixz", 0), number_in(inertia, "iyz", 0)};
    link.X_inertial = pose_in(inertial ? inertial.child("pose") : View()).value_or(Pose{});
    link.mass = mass;
    if (!link.is_static) report_defaults(link, inertial, inertia);
    if (inertial) check(link, inertia);
  }

  void report_defaults(const Link& link, View inertial, View inertia) {
    const bool has_mass = inertial && inertial.child("mass");
    if (has_mass && (inertia || !(link.mass->mass > 0))) return;
    const View place = inertial ? inertial : link.vertex->element;
    reporter_
        .report(rules::sml9315_mass_by_default, place.name_span(),
                has_mass ? quoted(link.vertex->name) +
                               " has a mass but no `<inertia>`, so its moments are 1 kg m^2"
                         : quoted(link.vertex->name) + " has no " +
                               (inertial ? "`<mass>`" : "`<inertial>`") + ", so it weighs 1 kg" +
                               (inertia ? "" : " and its moments are 1 kg m^2"))
        .help(inertial ? "write the " + std::string(has_mass ? "`<inertia>`" : "`<mass>`") +
                             " of the link"
                       : "write the `<inertial>` of the link");
  }

  void check(const Link& link, View inertia) {
    const MassProperties& mass = *link.mass;
    if (!(mass.mass >= 0)) {
      reporter_.refuse(link.of_mass.origin,
                       mass.mass < 0 ? "the mass is negative" : "the mass is not a number",
                       "write the mass in kg");
      return;
    }
    if (!inertia) return;
    if (!std::all_of(mass.inertia.begin(), mass.inertia.end(),
                     [](double one) { return std::isfinite(one); })) {
      reporter_.refuse(inertia.name_span(), "a moment of inertia is not finite",
                       "compute the tensor again, about the centre of mass");
      return;
    }
    const Vector3 moments = imports::principal_of(mass.inertia).moments;
    const double large = moments[0];
    const double small = std::min(moments[1], moments[2]);
    const double others = moments[1] + moments[2];
    constexpr double kRounding = 1e-13;
    if (small < -kRounding * std::fabs(large)) {
      reporter_.refuse(inertia.name_span(), "a moment of inertia is negative",
                       "compute the tensor again, about the centre of mass");
    } else if (large > others + kRounding * large) {
      reporter_.refuse(inertia.name_span(),
                       "no body has these moments of inertia: " + format_rounded(large) +
                           " is more than the sum of the others, " + format_rounded(others),
                       "compute the tensor again, about the centre of mass");
    }
  }

  void weigh_collisions(Link& link, View inertial) {
    const double usual = number_in(inertial, "density", kDensity);
    MassProperties sum;
    double heaviest = 0;
    link.X_inertial = {};
    bool is_known = true;
    for (const View collision : link.vertex->element) {
      if (collision.name() != "collision") continue;
      const Shape shape = read_shape(collision);
      const double density = number_in(collision, "density", usual);
      const auto one = solid(shape, *link.vertex->scope->file);
      if (!one) {
        is_known = is_known && shape.kind != Shape::Kind::mesh;
        continue;
      }
      MassProperties moved = one->in(pose_of_shape(collision, link, frames_));
      moved.scale(density);
      if (moved.mass > heaviest) {
        heaviest = moved.mass;
        const View size = collision.child("density") ? collision.child("density") : shape.element;
        link.of_mass = link.of_center = link.of_inertia = place_of(size, link.vertex->scope->frame);
      }
      sum.add(moved);
    }
    if (!is_known) {  // which has been reported; libsdformat then keeps its defaults
      link.mass = MassProperties{1, {}, {1, 1, 1, 0, 0, 0}};
      return;
    }
    if (!(sum.mass > 0)) {
      reporter_.refuse(inertial.name_span(),
                       "the mass of " + quoted(link.vertex->name) +
                           " comes from its collisions, and they have no volume",
                       "write the mass, or add a collision");
      return;
    }
    if (inertial.child("mass")) sum.scale(number_in(inertial, "mass", sum.mass) / sum.mass);
    link.mass = sum;
  }

  /// Of density 1, in the frame of the shape; none for a surface.
  std::optional<MassProperties> solid(const Shape& shape, const SdfFile& file) {
    imports::Extent extent;
    Vector3 center{};
    const auto& s = shape.size;
    switch (shape.kind) {
    case Shape::Kind::box: extent = imports::box({s[0] / 2, s[1] / 2, s[2] / 2}, false); break;
    case Shape::Kind::sphere: extent = imports::sphere(s[0], false); break;
    case Shape::Kind::cylinder: extent = imports::cylinder(s[0], s[1] / 2, false); break;
    case Shape::Kind::capsule: extent = imports::capsule(s[0], s[1] / 2, false); break;
    case Shape::Kind::ellipsoid: extent = imports::ellipsoid({s[0], s[1], s[2]}, false); break;
    case Shape::Kind::cone: {
      // Its frame is at half of its height; its centre is a quarter above the base.
      constexpr double kPi = 3.14159265358979323846;
      extent.volume = kPi * s[0] * s[0] * s[1] / 3;
      const double side = 3.0 / 80 * (4 * s[0] * s[0] + s[1] * s[1]);
      extent.moments = {side, side, 0.3 * s[0] * s[0]};
      center = {0, 0, -s[1] / 4};
      break;
    }
    case Shape::Kind::mesh: return mesh(shape, file);
    default: return std::nullopt;
    }
    MassProperties result;
    result.mass = extent.volume;
    result.center = center;
    for (std::size_t i = 0; i < 3; ++i) result.inertia[i] = extent.volume * extent.moments[i];
    return result;
  }

  std::optional<MassProperties> mesh(const Shape& shape, const SdfFile& file) {
    const View uri = shape.element.child("uri");
    const Span place = text_of(uri).empty() ? shape.element.name_span() : uri.text_span();
    const std::string path = files_.path_of(text_of(uri), file);
    Context& context = reporter_.context();
    FileContent content;
    if (!path.empty()) content = context.files.read(path, context.limits.mesh_bytes);
    if (path.empty() || content.status != ReadStatus::ok) {
      reporter_
          .report(rules::sml9315_mass_by_default, place,
                  "cannot read " + quoted(text_of(uri)) + ", so the link weighs 1 kg")
          .help("correct the address, or write `<mass>` and `<inertia>`");
      return std::nullopt;
    }
    const MeshFacts facts = read_mesh(content.text, path::to_lower(path::extension(path)));
    if (!facts.solid || !(facts.solid->volume > 0)) {
      reporter_
          .report(rules::sml9315_mass_by_default, place,
                  quoted(text_of(uri)) + " encloses no volume, so the link weighs 1 kg")
          .help("close the mesh, or write `<mass>` and `<inertia>`");
      return std::nullopt;
    }
    return scaled(*facts.solid, shape.size);
  }

  static MassProperties scaled(const Solid& solid, const std::array<double, 3>& scale) {
    MassProperties result;
    result.mass = solid.volume * std::fabs(scale[0] * scale[1] * scale[2]);
    const double factor = result.mass / solid.volume;
    std::array<double, 6> m{};  // xx, yy, zz, xy, xz, yz
    constexpr std::size_t kPairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
    for (std::size_t k = 0; k < 6; ++k)
      m[k] = solid.second[k] * factor * scale[kPairs[k][0]] * scale[kPairs[k][1]];
    for (std::size_t k = 0; k < 3; ++k) result.center[k] = solid.center[k] * scale[k];
    result.inertia = {m[1] + m[2], m[0] + m[2], m[0] + m[1], -m[3], -m[4], -m[5]};
    return result;
  }

  Model& model_;
  Files& files_;
  Reporter& reporter_;
  Frames frames_;
};

}  // namespace

void weigh(Model& model, Files& files, Reporter& reporter) { Scales(model, files, reporter).run(); }

}  // namespace smurf::sdformat
