// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/geometry_queries.hpp"

namespace smurf::rules::sml1440_rpy_gimbal_snap_file {
namespace {

/// Joints and inertials keep their pose (parser_urdf.cc:2802).
void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  for_each_geometry(model, [&](const GeometryUse& use) {
    if (!use.origin.rpy || (*use.origin.rpy)[1] == 0) return;
    const xml::Attribute* rpy =
        xml::View(model.robot->document, use.origin.element).attribute("rpy");
    if (rpy == nullptr) return;
    const std::vector<WrittenNumber> angles = written_numbers(*rpy);
    if (angles.size() != 3 || !is_rpy_snapped(angles)) return;
    const WrittenNumber& pitch = angles[1];
    // A rounded right angle becomes a right angle, as intended (SML1439).
    if (intended_right_angle(pitch)) return;
    const double exact = std::copysign(std::numbers::pi / 2, pitch.value);
    Diagnostic& diagnostic =
        findings.report(pitch.span, "the pitch " + std::string(pitch.text) + " is " +
                                        format_rounded(std::fabs(pitch.value - exact), 2) +
                                        " rad off a right angle, and Gazebo rounds it to one");
    diagnostic.help("write " + format_number(exact));
    diagnostic.fixes.push_back({Applicability::unsafe, {{pitch.span, format_number(exact)}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdfdom, Effect::changes,
     "treats the pitch as pi/2 when it converts the rotation to angles, which turns the part by "
     "up to 0.0045 rad",
     "urdfdom pose.h:118-126"},
    {&readers::gazebo, Effect::changes,
     "treats the pitch as pi/2 when it converts the rotation to angles, which turns the part by "
     "up to 0.0045 rad",
     "sdformat parser_urdf.cc:3223, 3269, run"},
};

}  // namespace

extern constinit const Rule sml1440_rpy_gimbal_snap{
    .id = "SML1440",
    .name = "rpy-gimbal-snap",
    .severity = Severity::warning,
    .summary = "The pitch of a visual or collision is almost, but not quite, a right angle.",
    .why = "Parts of the link no longer fit together.",
    .remedy = "Write the pitch with all digits: 1.5707963267948966.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1440_rpy_gimbal_snap_file
