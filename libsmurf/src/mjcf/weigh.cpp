// SPDX-License-Identifier: BSD-3-Clause
// The mass of each body, as the compiler of MuJoCo decides about it.
#include <algorithm>
#include <cmath>
#include <functional>

#include "base/findings/rules.hpp"
#include "base/numbers/vectors.hpp"
#include "base/text/quoted.hpp"
#include "mjcf/model.hpp"

namespace smurf::mjcf {
namespace {

constexpr double kLeastMass = 1e-15;

/// What `<inertial>` says.
std::optional<MassProperties> written_mass(const Body& body, Reporter& reporter) {
  const Settings s(body.inertial, nullptr);
  MassProperties result;
  const View element = body.inertial;
  for (const std::string_view name : {"pos", "mass"}) {
    if (element.attribute(name) == nullptr) {
      reporter.refuse(element.name_span(), "`inertial` needs " + quoted(name), "write it");
      return std::nullopt;
    }
  }
  const Pose pose = pose_of(s, body.file->compiler(), reporter);
  result.mass = s.number("mass", 0, reporter);
  if (result.mass < 0)
    reporter.refuse(s.place({"mass"}).origin, "the mass is negative",
                    "write a number of at least 0");
  const Attribute* full = element.attribute("fullinertia");
  if (full != nullptr) {
    for (const std::string_view other : {"quat", "axisangle", "xyaxes", "zaxis", "euler"}) {
      if (const Attribute* turn = element.attribute(other))
        reporter.refuse(turn->name_span(),
                        quoted(other) + " beside `fullinertia`, which has a direction of its own",
                        "delete one of the two");
    }
    if (const Attribute* diagonal = element.attribute("diaginertia"))
      reporter.refuse(diagonal->name_span(), "`diaginertia` beside `fullinertia`",
                      "delete one of the two");
    std::array<double, 6> n{};
    if (s.numbers("fullinertia", n, 6, reporter) < 6) return std::nullopt;
    result.inertia = n;
  } else {
    Vector3 diagonal{};
    s.numbers("diaginertia", diagonal, 3, reporter);
    result.inertia = {diagonal[0], diagonal[1], diagonal[2], 0, 0, 0};
  }
  return result.in(pose);
}

/// The sum of the shapes that count; none if one of them is unknown, and nothing if there are none.
std::optional<MassProperties> sum_of_geoms(const Body& body, bool& has_some) {
  MassProperties sum;
  const auto& groups = body.file->compiler().inertiagrouprange;
  for (const Geom& geom : body.geoms) {
    if (geom.group < groups[0] || geom.group > groups[1]) continue;
    if (geom.shape == Shape::plane || geom.shape == Shape::hfield) continue;
    has_some = true;
    if (!geom.mass) return std::nullopt;
    sum.add(*geom.mass);
  }
  return sum;
}

void bound(const Body& body, MassProperties& mass, Reporter& reporter) {
  const Compiler& c = body.file->compiler();
  mass.mass = std::max(mass.mass, c.boundmass);
  Principal principal = imports::principal_of(mass.inertia);
  Vector3& m = principal.moments;
  bool is_changed = false;
  for (double& one : m) {
    if (one < c.boundinertia) one = c.boundinertia, is_changed = true;
  }
  const View place = body.inertial ? body.inertial : body.element;
  if (m[2] < 0 && m[2] > -1e-12 * m[0]) m[2] = 0;
  if (*std::min_element(m.begin(), m.end()) < 0) {
    reporter.refuse(Settings(place, nullptr).place({"fullinertia", "diaginertia"}).origin,
                    "a moment of inertia is negative", "write the inertia of a real body");
    return;
  }
  const double largest = std::max({m[0], m[1], m[2]});
  if (m[0] + m[1] + m[2] - largest < largest * (1 - 1e-12)) {
    if (c.balanceinertia) {
      m[0] = m[1] = m[2] = (m[0] + m[1] + m[2]) / 3;
      is_changed = true;
    } else {
      reporter.refuse(
          Settings(place, nullptr).place({"fullinertia", "diaginertia"}).origin,
          "no body has these moments of inertia: two of them together are smaller than the third",
          "write the inertia of a real body, or `<compiler balanceinertia=\"true\"/>`");
    }
  }
  if (is_changed) mass.inertia = imports::tensor_of(principal);
}

class Weighing {
 public:
  Weighing(Model& model, Reporter& reporter)
      : model_(model), reporter_(reporter), children_(model.bodies.size()) {
    for (std::uint32_t i = 1; i < model.bodies.size(); ++i)
      children_[model.bodies[i].parent].push_back(i);
  }

  void run() {
    for (std::size_t i = 1; i < model_.bodies.size(); ++i) weigh(model_.bodies[i]);
    model_.bodies[0].mass = MassProperties{};
    scale();
    for (std::uint32_t i = 1; i < model_.bodies.size(); ++i) {
      const Body& body = model_.bodies[i];
      if (body.joints.empty() || has_mass(i)) continue;
      reporter_.refuse(body.element.name_span(), "this body moves and has no mass",
                       "give it a shape or `<inertial>`, or delete its joint");
    }
  }

 private:
  void weigh(Body& body) {
    const Compiler& c = body.file->compiler();
    if (body.point) {
      body.mass = body.point;
      return;
    }
    if (body.inertial) body.mass = written_mass(body, reporter_);
    if (c.inertiafromgeom == InertiaFromGeom::yes ||
        (!body.inertial && c.inertiafromgeom == InertiaFromGeom::automatic)) {
      bool has_some = false;
      const auto sum = sum_of_geoms(body, has_some);
      if (has_some || !body.inertial) body.mass = has_some ? sum : MassProperties{};
    } else if (!body.inertial) {
      body.mass = MassProperties{};
    }
    if (body.mass) bound(body, *body.mass, reporter_);
  }

  void scale() {
    const double total = model_.bodies[0].file->compiler().settotalmass;
    if (!(total > 0)) return;
    double sum = 0;
    for (const Body& body : model_.bodies) {
      if (!body.mass) return;
      sum += body.mass->mass;
    }
    for (Body& body : model_.bodies) body.mass->scale(total / std::max(kLeastMass, sum));
  }

  bool has_mass(std::uint32_t index) const {
    const Body& body = model_.bodies[index];
    if (!body.mass) return true;  // unknown
    const Principal p = imports::principal_of(body.mass->inertia);
    if (body.mass->mass >= kLeastMass &&
        std::min({p.moments[0], p.moments[1], p.moments[2]}) >= kLeastMass)
      return true;
    return std::any_of(children_[index].begin(), children_[index].end(), [&](std::uint32_t child) {
      return model_.bodies[child].joints.empty() && has_mass(child);
    });
  }

  Model& model_;
  Reporter& reporter_;
  std::vector<std::vector<std::uint32_t>> children_;
};

}  // namespace

void weigh(Model& model, Reporter& reporter) { Weighing(model, reporter).run(); }

}  // namespace smurf::mjcf
