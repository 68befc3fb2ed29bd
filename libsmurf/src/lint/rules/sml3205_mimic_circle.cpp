// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <string>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3205_mimic_circle_file {
namespace {

void report(const std::vector<Motor>& motors, const std::vector<std::size_t>& circle,
            Findings& findings) {
  const Motor& first = motors[circle.front()];
  std::string chain = quoted(*first.name);
  for (std::size_t i = 1; i < circle.size(); ++i) {
    chain += " follows " + quoted(*motors[circle[i]].name);
  }
  chain += " follows " + quoted(*first.name);
  Diagnostic& diagnostic = findings.report(
      first.mimic_motor.span, circle.size() == 1 ? subject("motor", first) + " mimics itself"
                                                 : "motors mimic each other in a cycle");
  if (circle.size() > 1) diagnostic.note(chain);
  for (std::size_t i = 1; i < circle.size(); ++i) {
    diagnostic.label(motors[circle[i]].mimic_motor.span, "part of the cycle");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<Motor>& motors = model.annotations.motors;
  std::vector<std::size_t> visit(motors.size(), 0);  // by which walk a motor was reached
  for (std::size_t start = 0; start < motors.size(); ++start) {
    std::vector<std::size_t> walk;
    std::size_t at = start;
    while (visit[at] == 0) {
      visit[at] = start + 1;
      walk.push_back(at);
      const Motor& motor = motors[at];
      const auto leader = motor.name && motor.mimic_motor
                              ? model.motor_names.find(*motor.mimic_motor)
                              : std::nullopt;
      if (!leader) break;
      at = *leader;
      if (visit[at] != start + 1) continue;
      walk.erase(walk.begin(), std::find(walk.begin(), walk.end(), at));
      report(motors, walk, findings);
      break;
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes,
     "passes the command of a motor to the motors that mimic it, in every step: in a cycle, the "
     "commands never settle",
     "MARS SimMotor.cpp:352-360 and 455-460, MotorManager.cpp:537-544"},
};

}  // namespace

extern constinit const Rule sml3205_mimic_circle{
    .id = "SML3205",
    .name = "mimic-circle",
    .severity = Severity::error,
    .summary = "Motors mimic each other in a cycle, or one mimics itself.",
    .remedy = "Let one motor of the cycle lead.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3205_mimic_circle_file
