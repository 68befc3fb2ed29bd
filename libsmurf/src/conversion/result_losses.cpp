// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/result_losses.hpp"

#include <algorithm>
#include <iterator>

#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/rules.hpp"
#include "base/text/words.hpp"
#include "smurf/check.hpp"
#include "smurf/verdict.hpp"

namespace smurf {
namespace {

/// Rules that a reader of files reports itself: the value is then absent, because it was not
/// understood.
bool is_unread(const Rule& rule) {
  if (&rule == &rules::sml1018_xml_version) return false;  // of the file, not of a value
  // All readers ignore the attribute, and the result keeps it as it is written.
  if (&rule == &rules::sml1107_unknown_attribute) return false;
  return !rule.has_check();
}

/// Whether the finding only concerns the look of shapes: the result has the first material of a
/// visual, as nearly all readers do, or none.
bool is_about_look(const Diagnostic& finding) {
  return finding.pointer.find("/material") != std::string::npos;
}

bool is_not_finite(const Rule& rule) {
  return &rule == &rules::sml1803_number_nan || &rule == &rules::sml1804_number_infinite;
}

/// Blanks before the declaration: strict readers of XML refuse the file, but nothing of it is
/// unknown.
bool is_read_anyway(const Rule& rule) { return &rule == &rules::sml1005_xml_junk_before_prolog; }

/// By the families of rules, whose ids begin alike.
std::string why_not_built(const Rule& rule) {
  if (&rule == &rules::sml1009_xacro_residue) return "it contains xacro that nobody has expanded";
  if (rule.id.starts_with("SML33")) return "its xacro cannot be expanded";
  if (rule.id.starts_with("SML10")) return "its XML cannot be read";
  if (&rule == &rules::sml1115_no_links) return "it has no link";
  return "its links and joints do not form a valid robot";
}

std::optional<std::string> loss_in_robot(const Diagnostic& finding) {
  if (is_about_missing_part(finding)) {
    return finding.rule == &rules::sml9302_mjcf_file_missing ? "masses of the robot are unknown"
                                                             : "a part of it is not there";
  }
  if (finding.rule->blocks_building) return why_not_built(*finding.rule);
  if (is_unread(*finding.rule) && !is_about_look(finding)) return "a value cannot be read";
  return std::nullopt;
}

bool takes_annotations(const UrdfExport& wanted) {
  const AppliedAnnotations& apply = wanted.apply;
  return apply.materials || apply.limits || apply.dynamics || apply.mimic || wanted.has_srdf ||
         wanted.adds_gazebo_sensors || wanted.actuation != Actuation::none;
}

/// Without a section, the whole file is not understood.
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

/// Nearly all programs load URDFs with urdfdom, so it checks the result.
std::optional<std::string> loss_in_text(const Diagnostic& finding, const UrdfExport& wanted) {
  // URDF readers continue there, but the result is copied from this text.
  const Rule* const not_xml[] = {
      &rules::sml0003_invalid_utf8,         &rules::sml0004_control_character,
      &rules::sml1001_xml_malformed,        &rules::sml1006_xml_several_roots,
      &rules::sml1015_xml_late_instruction, &rules::sml1016_xml_missing_quotes};
  if (std::find(std::begin(not_xml), std::end(not_xml), finding.rule) != std::end(not_xml)) {
    return "the result would not be XML";
  }
  // The urdfdom that checks the result may accept what other versions refuse.
  if (is_not_finite(*finding.rule)) {
    return "the result would contain a number that is not finite";
  }
  const Fact* fact = find_fact(readers::urdfdom, finding);
  if (fact != nullptr && fact->effect >= Effect::refuses) {
    return std::string(fact->reader->title) + " " + std::string(fact->makes);
  }
  if (fact == nullptr && finding.rule->blocks_building) return "it leaves no robot to compare with";
  if (computes(wanted) && is_unread(*finding.rule)) {
    return "the options need a value that cannot be read";
  }
  return std::nullopt;
}

/// Whether only MARS fails on a readable value: scenes are written for other programs.
bool is_for_mars_alone(const Rule& rule) {
  return rule.check_scene != nullptr && !rule.facts.empty() &&
         std::all_of(rule.facts.begin(), rule.facts.end(),
                     [](const Fact& fact) { return fact.reader == &readers::mars; });
}

/// Whether a finding is about lights or other settings of the world.
bool is_about_world_setting(const Diagnostic& finding, const LinkedScene& scene) {
  for (const SceneFile& file : scene.scenes) {
    if (file.source != finding.span.source || !file.document) continue;
    const yaml::View root = file.document->view();  // none in an empty file
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View key : root) {
      const Span span = key.span();
      const bool is_inside =
          key.key_span().begin <= finding.span.begin && finding.span.end <= span.end;
      if (is_inside) return is_one_of(key.key(), {"lights", "environment", "physics", "plugins"});
    }
  }
  return false;
}

}  // namespace

std::optional<std::string> loss_in_urdf(const Diagnostic& finding, const LinkedModel& model,
                                        const UrdfExport& wanted) {
  if (finding.severity != Severity::error) return std::nullopt;
  if (!model.robot) {
    const bool is_other_file =
        finding.rule == &rules::sml2001_missing_file && !finding.cases.contains(cases::kTheUrdf);
    return is_other_file ? std::nullopt : std::optional<std::string>("its URDF cannot be read");
  }
  if (is_about_missing_part(finding)) return loss_in_robot(finding);
  const SourceId source = finding.span.source;
  if (source == model.robot->document.source) {
    return loss_in_text(finding, wanted);
  }
  if (model.has_main && source == model.files.front().source) {
    return "the .smurf decides which files the robot is made of";
  }
  // Such a motor does not move in MARS, but every value of it can be read.
  if (finding.rule == &rules::sml4103_dead_motor) return std::nullopt;
  if (!takes_section(wanted, section_of(finding))) return std::nullopt;
  return "the options need annotations that have errors";
}

std::optional<std::string> loss_in_model(const Diagnostic& finding) {
  if (finding.severity != Severity::error) return std::nullopt;
  return loss_in_robot(finding);
}

std::optional<std::string> loss_in_scene(const Diagnostic& finding, const LinkedScene& scene,
                                         const SourceMap& sources) {
  if (finding.severity != Severity::error || is_about_world_setting(finding, scene)) {
    return std::nullopt;
  }
  const Rule& rule = *finding.rule;
  if (is_for_mars_alone(rule)) return std::nullopt;
  // The formats report the shape as lost, or name the missing file.
  if (&rule == &rules::sml5034_old_scene_file_missing) return std::nullopt;
  switch (input_kind(sources.path(finding.span.source))) {
  case InputKind::resource: return std::nullopt;
  case InputKind::urdf: return is_read_anyway(rule) ? std::nullopt : loss_in_robot(finding);
  case InputKind::annotation:
    // Named poses are the only annotations that decide where a link is.
    if (rule.id.starts_with("SML0")) return "a file cannot be read";
    if (section_of(finding) == "poses") return "a named pose is not understood";
    return std::nullopt;
  case InputKind::model: return "a .smurf decides which files a robot is made of";
  case InputKind::scene:
  case InputKind::drawing:
  case InputKind::other: break;
  }
  return "some poses are unknown";
}

bool can_be_forced(const Diagnostic& finding) {
  if (!is_unread(*finding.rule) || finding.rule->blocks_building || is_not_finite(*finding.rule)) {
    return false;
  }
  if (finding.rule == &rules::sml0003_invalid_utf8) return false;  // names go into the result
  // Behind the end of the robot.
  if (finding.rule == &rules::sml0004_control_character && finding.pointer.empty()) return true;
  return finding.pointer.starts_with("/robot/") &&
         finding.pointer.find("/origin") == std::string::npos;
}

bool is_about_missing_part(const Diagnostic& finding) {
  return finding.rule == &rules::sml9302_mjcf_file_missing ||
         finding.rule == &rules::sml9312_sdf_file_missing;
}

bool is_about_picture(const Diagnostic& finding) { return finding.cases.contains(cases::kPicture); }

bool is_about_lost_package(const Diagnostic& finding) {
  return finding.cases.contains(cases::kLostPackage);
}

bool may_ask_urdfdom(std::span<const Diagnostic> findings) {
  return std::none_of(findings.begin(), findings.end(), [](const Diagnostic& finding) {
    const Fact* fact = find_fact(readers::urdfdom, finding);
    if (fact != nullptr) return fact->effect >= Effect::refuses;
    // Values that could be read are usable, even when a rule reports them.
    return finding.severity == Severity::error && is_unread(*finding.rule);
  });
}

std::string_view section_of(const Diagnostic& finding) {
  std::string_view pointer = finding.pointer;
  if (pointer.starts_with('/')) pointer.remove_prefix(1);
  return pointer.substr(0, pointer.find('/'));
}

}  // namespace smurf
