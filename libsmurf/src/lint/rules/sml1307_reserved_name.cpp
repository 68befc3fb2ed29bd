// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1307_reserved_name_file {
namespace {

void check_name(std::string_view kind, const Field<std::string>& name, Findings& findings) {
  if (!name) return;
  const bool is_world = *name == "world" && kind != "link";
  if (!is_world && name_fault(*name) != NameFault::reserved) return;
  findings.report(name.span, "sdformat (Gazebo) reserves the name " + quoted(*name)).caret =
      "not free for a " + std::string(kind);
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  check_name("robot", model.robot->name, findings);
  for_each_name(model, [&](std::string_view kind, const Field<std::string>& name) {
    check_name(kind, name, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::urdf, Effect::takes, "knows no reserved names", "urdfdom, run"},
    {&readers::gazebo, Effect::refuses,
     "refuses names that begin and end with two underscores, and `world` as the name of a robot or joint",
     "sdformat error 3, run"},
};

}  // namespace

extern constinit const Rule sml1307_reserved_name{.id = "SML1307",
                                                  .name = "reserved-name",
                                                  .severity = Severity::error,
                                                  .summary = "A name is reserved by sdformat.",
                                                  .remedy = "Choose another name.",
                                                  .check_model = check,
                                                  .facts = kFacts};

}  // namespace smurf::rules::sml1307_reserved_name_file
