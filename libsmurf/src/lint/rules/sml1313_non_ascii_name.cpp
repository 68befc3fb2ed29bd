// SPDX-License-Identifier: BSD-3-Clause
#include "lint/name_queries.hpp"

namespace smurf::rules::sml1313_non_ascii_name_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for_each_name(model, [&](std::string_view kind, const Field<std::string>& name) {
    if (name_fault(*name) != NameFault::non_ascii) return;
    findings.report(name.span,
                    "the name " + quoted(*name) + " of a " + std::string(kind) + " is not ASCII");
  });
}

}  // namespace

extern constinit const Rule sml1313_non_ascii_name{
    .id = "SML1313",
    .name = "non-ascii-name",
    .severity = Severity::warning,
    .summary = "A name contains a non-ASCII character.",
    .why = "ROS allows letters, digits and underscores in graph and frame names, USD "
           "replaces the character; tools that guess the encoding see another name.",
    .remedy = "Spell the name with ASCII letters.",
    .sources = "ROS 2 naming rules (design.ros2.org, topic and service names); Isaac importer "
               "PathUtils.cpp:356-369.",
    .check_model = check};

}  // namespace smurf::rules::sml1313_non_ascii_name_file
