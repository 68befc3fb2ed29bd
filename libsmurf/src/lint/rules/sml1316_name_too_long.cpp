// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1316_name_too_long_file {
namespace {

/// Bullet copies names into such a buffer. Its process ended from 1,041 bytes on.
constexpr std::size_t kBuffer = 1024;
/// Isaac's converter names its file after the robot, with an extension: 255 bytes at most.
constexpr std::size_t kFileName = 248;

constexpr Circumstance kBeyondBuffer{"beyond the buffer"};

void check_name(const Field<std::string>& name, std::string_view what, std::size_t most,
                Findings& findings) {
  if (!name || name->size() <= most) return;
  Diagnostic& diagnostic =
      findings.report(name.span, "the name of a " + std::string(what) + " has " +
                                     std::to_string(name->size()) + " bytes");
  if (name->size() >= kBuffer) diagnostic.when(kBeyondBuffer);
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  check_name(model.robot->name, "robot", kFileName, findings);
  for_each_link(
      model, [&](const urdf::Link& link) { check_name(link.name, "link", kBuffer - 1, findings); });
  for_each_joint(model, [&](const urdf::Joint& joint) {
    check_name(joint.name, "joint", kBuffer - 1, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::crashes,
     "writes past a buffer of 1024 bytes, and ends the process", kRun, when(kBeyondBuffer)},
    {&readers::isaac, Effect::refuses, "cannot write a file of that name", kRun, at("robot/@name")},
};

}  // namespace

extern constinit const Rule sml1316_name_too_long{.id = "SML1316",
                                                  .name = "name-too-long",
                                                  .severity = Severity::error,
                                                  .summary =
                                                      "A name is longer than a reader can keep.",
                                                  .remedy = "Choose a shorter name.",
                                                  .check_model = check,
                                                  .needs_target = true,
                                                  .facts = kFacts};

}  // namespace smurf::rules::sml1316_name_too_long_file
