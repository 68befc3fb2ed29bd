// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1441_rpy_large_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  constexpr double kTurn = 2 * std::numbers::pi + 1e-3;
  for_each_turn(*model.robot, [&](const xml::Attribute& rpy) {
    for (const double angle : numbers_in(rpy.value())) {
      if (std::fabs(angle) <= kTurn) continue;
      findings
          .report(rpy.value_span(), "the angle " + format_number(angle) + " is " +
                                        format_rounded(angle / (2 * std::numbers::pi), 3) +
                                        " turns; is it in degrees?")
          .help(format_number(angle) + " degrees are " +
                format_rounded(angle / 180 * std::numbers::pi, 6) + " rad");
      break;
    }
  });
}

}  // namespace

extern constinit const Rule sml1441_rpy_large{
    .id = "SML1441",
    .name = "rpy-large",
    .severity = Severity::warning,
    .summary = "A roll, pitch or yaw is more than a full turn.",
    .why =
        "URDF angles are radians: 90 is more than 14 turns. Values of more than a turn are usually "
        "meant in degrees.",
    .remedy = "Multiply by pi/180.",
    .sources = "URDF specification; urdfdom pose.h.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1441_rpy_large_file
