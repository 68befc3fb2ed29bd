// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1412_prismatic_bounds_look_like_millimetres_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kLongest = 20;        // m
  constexpr double kPlaceholder = 1000;  // and more means "no limit"
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (joint.type != urdf::JointType::prismatic || !joint.limit) return;
    for (const Field<double>* bound : {&joint.limit->lower, &joint.limit->upper}) {
      if (!*bound || std::fabs(**bound) < kLongest || std::fabs(**bound) >= kPlaceholder) continue;
      findings
          .report(bound->span, "the limit " + format_number(**bound) + " of " + title(joint) +
                                   " is in metres; are millimetres meant?")
          .help(format_number(**bound) + " mm are " + format_rounded(**bound / 1000) + " m");
      return;
    }
  });
}

}  // namespace

extern constinit const Rule sml1412_prismatic_bounds_look_like_millimetres{
    .id = "SML1412",
    .name = "prismatic-bounds-look-like-millimetres",
    .severity = Severity::warning,
    .summary = "The limits of a prismatic joint look like millimetres.",
    .why = "URDF lengths are metres: a limit of 200 lets the joint travel 200 m, so it has no "
           "limit at all.",
    .remedy = "Divide by 1000.",
    .sources = "URDF specification; distribution of the limits of 322 files of the Tola/Corke "
               "dataset.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1412_prismatic_bounds_look_like_millimetres_file
