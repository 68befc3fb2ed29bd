// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1104_version_unsupported_file {
namespace {

// Authors choose such a version for urdfdom.
constexpr Circumstance kVersion11{"1.1", &readers::urdfdom}, kVersion12{"1.2", &readers::urdfdom};

/// Whether the robot uses what version 1.0 does not have: then it needs its version.
bool needs_newer(const xml::Document& document) {
  for (const xml::Element& element : document.elements) {
    if (element.name() == "capsule") return true;
  }
  for (const xml::Attribute& attribute : document.attributes) {
    if (is_one_of(attribute.name(), {"quat_xyzw", "acceleration", "deceleration", "jerk"})) {
      return true;
    }
  }
  return false;
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot || !model.robot->version || *model.robot->version == "1.0") return;
  const std::string& version = *model.robot->version;
  const std::string since = version == "1.1"   ? " before 5.1"
                            : version == "1.2" ? " before 6.0"
                                               : "";
  Diagnostic& diagnostic =
      findings.report(model.robot->version.span,
                      "the version " + quoted(version) + " is refused by urdfdom" + since);
  if (version == "1.1") diagnostic.when(kVersion11);
  if (version == "1.2") diagnostic.when(kVersion12);
  if (!since.empty() && needs_newer(model.robot->document)) {
    diagnostic.note("the robot has elements or attributes that version 1.0 does not have");
    diagnostic.help("name the release that loads it, as in `--target ros:rolling`");
    return;
  }
  diagnostic.help("write `1.0`, or delete the attribute");
  diagnostic.fixes.push_back({Applicability::unsafe, {{model.robot->version.span, "1.0"}}});
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "does not look at the version", kRun},
    {&readers::drake, Effect::takes, "does not look at the version", kRun},
    {&readers::urdfdom, Effect::refuses, "refuses every version but 1.0",
     "urdfdom model.cpp:126-137, run", before({5, 1})},
    {&readers::urdfdom, Effect::takes, "knows version 1.1", "urdfdom 6.0.0, run", when(kVersion11)},
    {&readers::urdfdom, Effect::takes, "knows version 1.2", "urdfdom 6.0.0, run",
     when(kVersion12).since({6, 0})},
    {&readers::urdfdom, Effect::refuses, "refuses versions that it does not know",
     "urdfdom 6.0.0, run"},
    {&readers::phobos, Effect::ignores, "does not look at the version", kRun},
};

}  // namespace

extern constinit const Rule sml1104_version_unsupported{
    .id = "SML1104",
    .name = "version-unsupported",
    .severity = Severity::error,
    .summary = "The version of the robot element is not 1.0.",
    .why = "\"1\" is refused too.",
    .remedy =
        "Delete the attribute, or write 1.0, unless the robot needs a newer version and is only for "
        "readers that know it.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1104_version_unsupported_file
