// SPDX-License-Identifier: BSD-3-Clause
// Questions that several rules ask about an SRDF and its robot.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "smurf/companions.hpp"

namespace smurf {

/// Calls `visit` for every SRDF of the model.
void for_each_srdf(const Companions& companions,
                   const std::function<void(const srdf::Description&)>& visit);

/// The name in the start tag of an element.
Span tag_of(const srdf::Description& srdf, xml::ElementId element);
/// The place of a text, or of its element if it is not written.
Span place_of(const srdf::Description& srdf, const srdf::Text& text, xml::ElementId element);
/// "group `arm`", or "this group".
std::string title_of(std::string_view kind, const srdf::Text& name);

/// The joints of a group, as MoveIt collects them.
struct GroupJoints {
  std::vector<bool> of_robot;  ///< by JointIndex
  std::vector<const srdf::VirtualJoint*> virtual_joints;
  /// False if a member is unknown, a chain is broken, or there are too many groups in the group;
  /// then joints may be missing.
  bool is_complete = true;

  bool contains(const LinkedModel& model, std::string_view joint) const;
};
/// Precondition: the model has a robot.
GroupJoints joints_of(const LinkedModel& model, const srdf::Description& srdf,
                      const srdf::Group& group);

/// Calls `visit` for every group state whose group exists, with the joints of the group.
void for_each_state(const LinkedModel& model, const Companions& companions,
                    const std::function<void(const srdf::Description&, const srdf::GroupState&,
                                             const GroupJoints&)>& visit);

/// The joints from `tip` up to `base`, or from both up to the link above both; empty if neither
/// is above the other and no link is above both. Precondition: the model has both links.
struct Chain {
  bool is_joined = false;
  bool is_below = false;  ///< the tip is the base, or below it
  std::vector<JointIndex> joints;
};
Chain chain_between(const LinkedModel& model, std::string_view base, std::string_view tip);

/// The number of variables of a joint of the robot or of a virtual joint.
std::size_t variables_of(const urdf::Joint& joint);
std::size_t variables_of(const srdf::VirtualJoint& joint);

}  // namespace smurf
