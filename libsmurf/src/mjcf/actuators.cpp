// SPDX-License-Identifier: BSD-3-Clause
// What actuators are to their joints: their law, their efforts, and what they add to them.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "base/findings/rules.hpp"
#include "mjcf/robot.hpp"

namespace smurf::mjcf {

Settings settings_of_actuator(const Reference& one) {
  const ModelFile& file = *one.around.file;
  const Attribute* class_name = one.element.attribute("class");
  return Settings(one.element,
                  file.find_class(class_name != nullptr ? class_name->value() : "main"));
}

double gear_of(const Settings& s, Reporter& reporter) {
  std::array<double, 6> gears{1, 0, 0, 0, 0, 0};
  s.numbers("gear", gears, 1, reporter);
  return gears[0] != 0 && std::isfinite(gears[0]) ? gears[0] : 1;
}

void add_actuators(Model& model, Reporter& reporter) {
  std::map<std::string, Joint*, std::less<>> joints;
  for (Body& body : model.bodies) {
    for (Joint& joint : body.joints) joints.emplace(joint.name, &joint);
  }
  for (const Reference& one : model.sections) {
    if (one.section != "actuator") continue;
    const Attribute* name = one.element.attribute("joint");
    if (name == nullptr) name = one.element.attribute("jointinparent");
    const auto found =
        name == nullptr ? joints.end() : joints.find(full_name(name->value(), one.around));
    if (found == joints.end()) continue;
    const Settings s = settings_of_actuator(one);
    const double gear = gear_of(s, reporter);
    std::array<double, 3> damping{};
    s.numbers("damping", damping, 1, reporter);
    found->second->armature += gear * gear * s.number("armature", 0, reporter);
    found->second->damping += gear * gear * damping[0];
    if (damping[1] == 0 && damping[2] == 0) continue;
    reporter
        .report(rules::sml9304_lost_in_urdf, s.place({"damping"}).origin,
                "a URDF has a linear damping only, so the other coefficients are lost")
        .help("write one number if the difference does not matter");
  }
}

std::optional<std::array<double, 2>> effort_range_of(const Settings& s, Reporter& reporter) {
  std::array<double, 6> gear{1, 0, 0, 0, 0, 0};
  s.numbers("gear", gear, 1, reporter);
  std::array<double, 2> force{};
  s.numbers("forcerange", force, 2, reporter);
  std::array<double, 2> control{};
  s.numbers("ctrlrange", control, 2, reporter);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  std::array<double, 2> result{-kInfinity, kInfinity};
  const auto narrow = [&](std::array<double, 2> range, double factor) {
    for (double& one : range) one *= factor;
    if (factor < 0) std::swap(range[0], range[1]);
    result = {std::max(result[0], range[0]), std::min(result[1], range[1])};
  };
  if (s.text("forcelimited") != "false" && force[0] < force[1]) narrow(force, gear[0]);
  const std::optional<Servo> servo = servo_of(s, reporter);
  const bool is_motor = servo && servo->kind == "motor";
  if (is_motor && s.text("ctrllimited") != "false" && control[0] < control[1])
    narrow(control, gear[0] * servo->gain);
  return result[0] > -kInfinity ? std::optional(result) : std::nullopt;
}

std::optional<Servo> servo_of(const Settings& s, Reporter& reporter) {
  const std::string_view kind = s.element().name();
  if (kind == "motor") return Servo{kind};
  if (kind == "position" || kind == "intvelocity")
    return Servo{kind, 1, s.number("kp", 1, reporter), s.number("kv", 0, reporter),
                 s.number("dampratio", 0, reporter)};
  if (kind == "velocity") return Servo{kind, 1, 0, s.number("kv", 1, reporter)};
  const auto is_usual = [&](std::string_view name, std::string_view usual) {
    const std::string_view text = s.text(name);
    return text.empty() || text == usual;
  };
  const bool is_linear = is_usual("dyntype", "none") && is_usual("gaintype", "fixed");
  if (kind != "general" || !is_linear || s.find("kp") != nullptr || s.find("kv") != nullptr)
    return std::nullopt;
  std::array<double, 10> gain{1};
  std::array<double, 10> bias{};
  s.numbers("gainprm", gain, 1, reporter);
  s.numbers("biasprm", bias, 1, reporter);
  if (is_usual("biastype", "none")) return Servo{"motor", gain[0]};
  if (s.text("biastype") != "affine" || bias[0] != 0) return std::nullopt;
  // A damping above zero is a ratio.
  if (bias[1] == -gain[0])
    return Servo{"position", 1, gain[0], std::max(0.0, -bias[2]), std::max(0.0, bias[2])};
  if (bias[1] == 0 && bias[2] == -gain[0]) return Servo{"velocity", 1, 0, gain[0]};
  return std::nullopt;
}

}  // namespace smurf::mjcf
