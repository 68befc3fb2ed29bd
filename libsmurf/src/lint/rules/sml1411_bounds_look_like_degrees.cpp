// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1411_bounds_look_like_degrees_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::revolute || !joint.limit) return;
    for (const Field<double>* bound : {&joint.limit->lower, &joint.limit->upper}) {
      if (!*bound || !looks_like_degrees(**bound)) continue;
      const double size = std::fabs(**bound);
      findings
          .report(bound->span, "the limit " + format_number(**bound) + " of " + title(joint) +
                                   " is " + format_rounded(size / (2 * std::numbers::pi), 3) +
                                   " turns; is it in degrees?")
          .help(format_number(**bound) + " degrees are " +
                format_rounded(**bound * std::numbers::pi / 180, 6) + " rad");
      return;
    }
  });
}

}  // namespace

extern constinit const Rule sml1411_bounds_look_like_degrees{
    .id = "SML1411",
    .name = "bounds-look-like-degrees",
    .severity = Severity::warning,
    .summary = "The limits of a revolute joint look like degrees.",
    .why = "URDF angles are radians: a limit of 90 is 14 turns, so the joint has no limit at all.",
    .remedy = "Multiply by pi/180.",
    .sources = "Distribution of the limits of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1411_bounds_look_like_degrees_file
