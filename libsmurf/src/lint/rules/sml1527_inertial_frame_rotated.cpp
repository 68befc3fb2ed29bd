// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1527_inertial_frame_rotated_file {
namespace {

/// One finding per file, because an exporter does so for every link.
void check(const LinkedModel& model, Findings& findings) {
  constexpr double kSmall = 1e-3;  // rad
  std::size_t count = 0;
  Span first;
  std::string whose;
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || !link.inertial->origin.rpy) return;
    const auto moments = principal_moments(*link.inertial);
    // The inertia of a sphere is the same in every frame.
    if (!moments || (*moments)[2] - (*moments)[0] <= kSmall * (*moments)[2]) return;
    const Quaternion rotation = from_rpy(*link.inertial->origin.rpy);
    if (angle_between(rotation, Quaternion{}) < kSmall) return;
    if (count++ > 0) return;
    first = link.inertial->origin.rpy.span;
    whose = title(link);
  });
  if (count == 0) return;
  Diagnostic& diagnostic = findings.report(first, "the inertial of " + whose + " is rotated");
  diagnostic.note("Phobos cannot merge such links");
  if (count > 1) {
    diagnostic.note(counted(count - 1, "more link") + " in this file");
  }
}

constexpr Fact kFacts[] = {
    {&readers::phobos, Effect::takes, "cannot merge such links",
     "Phobos io/representation.py:1680"},
    {&readers::mujoco, Effect::changes, "ignores `rpy`: the inertia is about other axes",
     "3.1.3, 3.1.6, 3.3.7, 3.12.0 and 3.13.0, run", since({3, 1, 3}).before({3, 14})},
};

}  // namespace

extern constinit const Rule sml1527_inertial_frame_rotated{
    .id = "SML1527",
    .name = "inertial-frame-rotated",
    .severity = Severity::info,
    .summary = "The frame of an inertial is rotated.",
    .why =
        "Some importers read the position of the origin only, and so use the tensor in the wrong frame.",
    .remedy =
        "Rotate the tensor into the axes of the link and write rpy=\"0 0 0\", if these readers "
        "matter.",
    .sources = "Isaac importer UrdfImporter.cpp:406-411; 41 of 322 "
               "files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1527_inertial_frame_rotated_file
