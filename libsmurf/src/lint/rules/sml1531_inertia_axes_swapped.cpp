// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/axis_order.hpp"
#include "lint/inertia_slips.hpp"
#include "lint/model_answers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1531_inertia_axes_swapped_file {
namespace {

void check_link(const LinkedModel& model, const urdf::Link& link, Findings& findings) {
  const AxisOrder* order = likely_axis_order(model, link, findings.answers());
  if (order == nullptr) return;
  const Pose X = urdf::to_pose(link.inertial->origin);
  const Tensor tensor = rotated(tensor_of(*link.inertial), X.orientation);
  const Tensor shape = *findings.answers().shape_inertia(link);
  const double mass = *link.inertial->mass;
  Diagnostic& diagnostic = findings.report(inertia_place(model, *link.inertial),
                                           "the inertia of " + title(link) +
                                               " fits its shape when " + std::string(order->words));
  if (mass <= kNegligibleMass) diagnostic.severity = Severity::info;
  diagnostic.caret = "about x, y, z: " + format_rounded(tensor[0], 3) + ", " +
                     format_rounded(tensor[1], 3) + ", " + format_rounded(tensor[2], 3);
  diagnostic.note("a full shape with this mass has " + format_rounded(mass * shape[0], 3) + ", " +
                  format_rounded(mass * shape[1], 3) + ", " + format_rounded(mass * shape[2], 3));
  if (X.orientation != Quaternion{} || !is_diagonal(*link.inertial)) return;
  const auto& axes = order->axes;
  if (auto fix =
          fix_of(*link.inertial, {tensor[axes[0]], tensor[axes[1]], tensor[axes[2]], 0, 0, 0})) {
    diagnostic.help("swap the moments");
    diagnostic.fixes.push_back(std::move(*fix));
  }
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) { check_link(model, link, findings); });
}

}  // namespace

extern constinit const Rule sml1531_inertia_axes_swapped{
    .id = "SML1531",
    .name = "inertia-axes-swapped",
    .severity = Severity::warning,
    .summary = "An inertia has the moments of the shape about other axes.",
    .why = "A cylinder of URDF lies along z. If its inertia was computed for another axis, the "
           "link resists turning about the wrong axis: a wheel spins up too slowly or too fast.",
    .remedy = "Swap the moments, or turn the inertial with `rpy`.",
    .sources = "The 12 rotors of the legs of a public quadruped.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1531_inertia_axes_swapped_file
