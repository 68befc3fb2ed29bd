// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1303_link_joint_same_name_file {
namespace {

constexpr Circumstance kMerged{"merged"};

/// The links and joints that remain after sdformat has merged and dropped links.
class KeptNames {
 public:
  explicit KeptNames(const LinkedModel& model) : model_(model), links_(links_of_sdformat(model)) {}

  bool has_link(std::size_t link) const { return links_[link] && to_size(*links_[link]) == link; }

  bool has_joint(std::size_t joint) const {
    const auto child = model_.tree.joint_child[joint];
    return !child || has_link(to_size(*child));
  }

 private:
  const LinkedModel& model_;
  std::vector<std::optional<LinkIndex>> links_;
};

/// One finding per file, because authors name all parts by one scheme.
void check(const LinkedModel& model, Findings& findings) {
  std::optional<KeptNames> kept;  // computed when it is needed
  std::size_t index = 0;
  for_each_joint(model, [&](const urdf::Joint& joint) {
    const std::size_t at = index++;
    if (!joint.name || joint.name->empty()) return;
    const auto link = model.link_names.find(*joint.name);
    if (!link) return;
    if (!kept) kept.emplace(model);
    Diagnostic& finding = findings.report_habit(
        joint.name.span, "a link and a joint are both called " + quoted(*joint.name), "such names");
    finding.label(model.robot->links[*link].name.span, "the link");
    if (kept->has_joint(at) && kept->has_link(*link)) {
      finding.note("Gazebo has one name space for both, and refuses the model");
    } else {
      finding.when(kMerged).severity = Severity::info;  // no reader minds
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::takes,
     "merges or drops the link, so that one of the names disappears", kRun, when(kMerged)},
    {&readers::gazebo, Effect::refuses, "reports errors E2 and E24; the model cannot be used",
     kRun},
};

}  // namespace

extern constinit const Rule sml1303_link_joint_same_name{
    .id = "SML1303",
    .name = "link-joint-same-name",
    .severity = Severity::warning,
    .summary = "A link and a joint have the same name.",
    .why = "URDF allows it, SDF does not.",
    .remedy = "Give the joint another name, e.g. with the ending `_joint`.",
    .sources = "9 of 322 files of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1303_link_joint_same_name_file
