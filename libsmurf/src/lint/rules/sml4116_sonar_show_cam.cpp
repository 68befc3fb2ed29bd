// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml4116_sonar_show_cam_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  for (const Sensor& sensor : model.annotations.sensors) {
    if (!sensor.type || *sensor.type != "ScanningSonar") continue;
    const yaml::View mapping = mapping_of(model, sensor);
    const yaml::View show = mapping ? mapping.find("show_cam") : yaml::View();
    if (!show || !(show.boolean() == true || show.number() == 1)) continue;
    Diagnostic& diagnostic = findings.report(
        show.span(), "`show_cam` of a ScanningSonar is undefined behaviour in MARS");
    diagnostic.fixes.push_back({Applicability::unsafe, {{show.span(), "false"}}});
    diagnostic.help("write `false`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::crashes, "dereferences an iterator that it never set",
     "MARS ScanningSonar.cpp:317-320"},
};

}  // namespace

extern constinit const Rule sml4116_sonar_show_cam{
    .id = "SML4116",
    .name = "sonar-show-cam",
    .severity = Severity::error,
    .summary = "A ScanningSonar has `show_cam: true`.",
    .remedy = "Write `show_cam: false`, or leave the key out.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml4116_sonar_show_cam_file
