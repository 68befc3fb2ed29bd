// SPDX-License-Identifier: BSD-3-Clause
#include "write/mjcf/mjcf_loops.hpp"

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"

namespace smurf {

const std::vector<MjcfLoops::Ends>& MjcfLoops::ends_of(const LinkedModel& model) {
  const auto [known, is_new] = ends_.try_emplace(&model);
  if (!is_new) return known->second;
  constexpr double kClosed = 1e-6;  // m
  constexpr double kLever = 0.1;    // m: two points of the axis of a hinge
  const auto poses = forward_kinematics(model, {});
  for (Loop& loop : loops_of(model)) {
    Ends ends{.loop = std::move(loop)};
    const LoopGap gap = gap_of(ends.loop, poses);
    const Vector3& axis = ends.loop.axis;
    ends.anchors.push_back({0, 0, 0});
    if (ends.loop.kind == LoopKind::hinge && !is_planar(model, ends.loop, poses)) {
      ends.anchors.push_back({kLever * axis[0], kLever * axis[1], kLever * axis[2]});
    }
    const bool is_tilted = ends.anchors.size() > 1 && gap.angle > kClosed;
    ends.needs_sites = ends.loop.kind != LoopKind::fixed && (gap.distance > kClosed || is_tilted);
    known->second.push_back(std::move(ends));
  }
  return known->second;
}

std::string MjcfLoops::site(std::size_t i, const Ends& ends, std::size_t anchor,
                            bool of_child) const {
  return name(i, ends.loop.name) + (of_child ? "/child" : "/parent") +
         (anchor == 0 ? "" : "_" + std::to_string(anchor + 1));
}

void MjcfLoops::add_loop_sites(std::size_t i, std::size_t link) {
  for (const Ends& ends : ends_of(*robot_of(i))) {
    if (!ends.needs_sites) continue;
    for (const bool of_child : {false, true}) {
      if (link != (of_child ? ends.loop.child : ends.loop.parent)) continue;
      const Pose& X_LJ = of_child ? ends.loop.X_CJ : ends.loop.X_PJ;
      for (std::size_t at = 0; at < ends.anchors.size(); ++at) {
        const Pose X_LA = X_LJ * Pose{ends.anchors[at], {}};
        xml_.empty("site", {{"name", site(i, ends, at, of_child)},
                            {"pos", join_numbers(X_LA.position)},
                            {"group", "4"}});
      }
    }
  }
}

void MjcfLoops::add_loop_equalities(std::size_t i) {
  const LinkedModel& model = *robot_of(i);
  const std::vector<std::optional<Pose>>& start = frames_of(scene_, i, frames_);
  for (const Ends& ends : ends_of(model)) {
    const Loop& loop = ends.loop;
    const std::string parent = name(i, link_name(model, loop.parent));
    const std::string child = name(i, link_name(model, loop.child));
    if (loop.kind == LoopKind::fixed) {
      const Pose X_PC = loop.X_PJ * inverse(loop.X_CJ);
      xml_.empty("weld", {{"name", name(i, loop.name)},
                          {"body1", parent},
                          {"body2", child},
                          {"relpose",
                           join_numbers(X_PC.position) + " " + quaternion_text(X_PC.orientation)}});
    }
    for (std::size_t at = 0; loop.kind != LoopKind::fixed && at < ends.anchors.size(); ++at) {
      const std::string own = name(i, loop.name) + (at == 0 ? "" : "/axis");
      if (ends.needs_sites) {
        xml_.empty("connect", {{"name", own},
                               {"site1", site(i, ends, at, false)},
                               {"site2", site(i, ends, at, true)}});
        continue;
      }
      const Pose X_PA = loop.X_PJ * Pose{ends.anchors[at], {}};
      xml_.empty("connect", {{"name", own},
                             {"body1", parent},
                             {"body2", child},
                             {"anchor", join_numbers(X_PA.position)}});
    }
    const LoopGap gap = gap_of(loop, start);
    constexpr double kOpen = 1e-4;  // m and rad
    if (gap.distance > kOpen || gap.angle > kOpen) {
      scene_.losses.report(rules::sml8212_chosen_value, loop.span,
                           "the loop " + quoted(loop.name) + " is open at the start by " +
                               format_rounded(1000 * gap.distance, 3) + " mm and " +
                               format_rounded(gap.angle, 3) + " rad, and MuJoCo pulls it together");
    }
  }
}

}  // namespace smurf
