// SPDX-License-Identifier: BSD-3-Clause
#include "smurf2urdf/loss.hpp"

#include <algorithm>

#include "common/converter.hpp"
#include "smurf/readers.hpp"

namespace smurf::tools {
namespace {

/// What loads URDFs for nearly everybody, and is asked about the result.
const Reader& urdfdom() {
  const auto readers = all_readers();
  return **std::ranges::find(readers, "urdfdom", &Reader::name);
}

bool takes_annotations(const UrdfExport& wanted) {
  const AppliedAnnotations& apply = wanted.apply;
  return apply.materials || apply.limits || apply.dynamics || apply.mimic || wanted.has_srdf ||
         wanted.adds_gazebo_sensors || wanted.actuation != Actuation::none;
}

/// Without a section, it is the whole file that is not understood.
bool takes_section(const UrdfExport& wanted, std::string_view section) {
  const AppliedAnnotations& apply = wanted.apply;
  if (section.empty()) return takes_annotations(wanted);
  if (section == "materials") return apply.materials;
  if (section == "joint" || section == "joints") return apply.dynamics;
  if (section == "sensors") return wanted.adds_gazebo_sensors;
  if (section == "poses" || section == "collision") return wanted.has_srdf;
  if (section != "motors") return false;
  return apply.limits || apply.mimic || wanted.actuation != Actuation::none;
}

/// Steps that compute with values instead of copying their text.
bool computes(const UrdfExport& wanted) {
  return wanted.collapses_fixed || wanted.is_canonical || !wanted.version.empty();
}

std::optional<std::string> loss_in_text(const Diagnostic& finding, const UrdfExport& wanted) {
  const Fact* fact = find_fact(urdfdom(), finding);
  if (fact != nullptr && fact->effect >= Effect::refuses) {
    return std::string(fact->reader->title) + " " + std::string(fact->makes);
  }
  if (fact == nullptr && finding.rule->blocks_building) return "it leaves no robot to compare with";
  if (computes(wanted) && is_unread(*finding.rule)) {
    return "the options need a value that cannot be read";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> loss_in_urdf(const Diagnostic& finding, const LinkedModel& model,
                                        const UrdfExport& wanted) {
  if (finding.severity != Severity::error) return std::nullopt;
  if (!model.robot) return "its URDF cannot be read";
  const SourceId source = finding.span.source;
  if (source == model.robot->document.source) return loss_in_text(finding, wanted);
  if (model.has_main && source == model.files.front().source) {
    return "the .smurf decides which files the robot is made of";
  }
  if (!takes_section(wanted, section_of(finding))) return std::nullopt;
  return "the options ask for annotations that are not right";
}

bool may_ask_urdfdom(std::span<const Diagnostic> findings) {
  return std::none_of(findings.begin(), findings.end(), [](const Diagnostic& finding) {
    const Fact* fact = find_fact(urdfdom(), finding);
    if (fact != nullptr) return fact->effect >= Effect::refuses;
    // Values that were read are safe, whatever a rule thinks of them.
    return finding.severity == Severity::error && is_unread(*finding.rule);
  });
}

}  // namespace smurf::tools
