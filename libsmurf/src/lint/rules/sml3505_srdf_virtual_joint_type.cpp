// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "base/text/suggest.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3505_srdf_virtual_joint_type_file {
namespace {

constexpr std::array<std::string_view, 3> kTypes = {"fixed", "floating", "planar"};

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::VirtualJoint& joint : srdf.virtual_joints) {
      if (!joint.type) continue;
      const std::string type = path::to_lower(*joint.type);
      if (std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end()) continue;
      Diagnostic& found = findings.report(place_of(srdf, joint.type, joint.element),
                                          title_of("virtual joint", joint.name) + " has the type " +
                                              quoted(*joint.type));
      found.help("write fixed, floating or planar");
      if (const auto near = only_nearest(type, kTypes); near && !joint.type->empty()) {
        found.help("did you mean " + quoted(*near) + "?");
        found.fixes.push_back({Applicability::unsafe, {{joint.type.span, std::string(*near)}}});
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and makes the joint fixed",
     "srdfdom model.cpp loadVirtualJoints"},
};

}  // namespace

extern constinit const Rule sml3505_srdf_virtual_joint_type{
    .id = "SML3505",
    .name = "srdf-virtual-joint-type",
    .severity = Severity::error,
    .summary = "The type of a virtual joint is not fixed, floating or planar.",
    .remedy = "Write one of these types.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3505_srdf_virtual_joint_type_file
