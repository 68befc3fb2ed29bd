// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "link/link_overlaps.hpp"
#include "lint/model_answers.hpp"
#include "lint/rigid_shapes.hpp"

namespace smurf::rules::sml1663_root_far_from_shapes_file {
namespace {

constexpr double kFar = 2;  // of the diagonal of the root

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || model.tree.roots.size() != 1) return;
  const urdf::Link& link = model.link(model.tree.roots.front());
  const std::optional<Extent>& own = findings.answers().extent(link);
  if (!own) return;
  const Box box{own->low, own->high};
  const double distance = distance_to(box, {});
  if (!(diagonal_of(box) > 0) || distance < kFar * diagonal_of(box) || distance > kFarthestOrigin) {
    return;  // SML1442 is about what is still farther
  }
  // The frame may be that of the feet, or of the middle of the robot.
  const auto poses = forward_kinematics(model, {});
  std::optional<Box> all;
  for (const RigidShape& shape : rigid_shapes(model, poses, bodies_of(model))) {
    if (!shape.is_known) return;
    if (shape.box) all = all ? united(*all, *shape.box) : *shape.box;
  }
  if (!all || distance_to(*all, {}) < diagonal_of(box)) return;
  findings
      .report(name_place(model, link), "the shapes of " + title(link) + ", the root, lie " +
                                           format_rounded(distance, 2) + " m from its frame")
      .help("move the assembly to the origin of the drawing and export it again, or subtract the "
            "offset in the root and in the origins of its joints");
}

}  // namespace

extern constinit const Rule sml1663_root_far_from_shapes{
    .id = "SML1663",
    .name = "root-far-from-shapes",
    .severity = Severity::warning,
    .summary = "The whole robot lies far beside the frame of its root.",
    .why =
        "Whoever places the robot places its frame: it appears elsewhere, and turns about a point "
        "beside it. The assembly did not stand at the origin of the drawing.",
    .remedy = "Move the assembly to the origin, and export it again.",
    .sources = "Bounding boxes of all shapes; PingTi-Arm issue 6.",
    .check_model = check,
    .about = About::robot};

}  // namespace smurf::rules::sml1663_root_far_from_shapes_file
