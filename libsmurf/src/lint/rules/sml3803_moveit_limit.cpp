// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf::rules::sml3803_moveit_limit_file {
namespace {

constexpr Circumstance kContinuous{"continuous"};
constexpr Circumstance kMissing{"missing"};

constexpr double kSlack = 1e-6;

std::optional<double> number_of(yaml::View joint, std::string_view key) {
  const yaml::View value = joint.find(key);
  return value && value.is_scalar() ? value.number() : std::nullopt;
}

/// Authors round velocities: 9.6 for 9.599 rad/s.
constexpr double kRounded = 1e-3;

/// `has_velocity_limits: true` without `max_velocity`.
void check_missing(yaml::View joint, std::string_view what, Findings& findings) {
  const std::string has = "has_" + std::string(what) + "_limits";
  const std::string max = "max_" + std::string(what);
  const yaml::View flag = joint.find(has);
  if (!flag || !flag.is_scalar() || flag.boolean() != true || joint.find(max)) return;
  findings
      .report(flag.key_span(),
              "joint " + quoted(joint.key()) + " has " + quoted(has) + ", but no " + quoted(max))
      .help("write " + quoted(max))
      .when(kMissing);
}

/// The joints of a file with limits of one kind that are wider than those of the URDF: the first is
/// a finding, the others are counted.
class Wider {
 public:
  bool is_first() { return ++count_ == 1; }
  void set(Diagnostic& first) { first_ = &first; }
  void finish() {
    if (count_ < 2) return;
    first_->note("this also applies to " + counted(count_ - 1, "more joint") + " of this file");
  }

 private:
  Diagnostic* first_ = nullptr;
  std::size_t count_ = 0;
};

void check_velocity(yaml::View joint, const urdf::Joint& one, Wider& wider, Findings& findings) {
  const auto velocity = number_of(joint, "max_velocity");
  if (!velocity || !one.limit || !one.limit->velocity || *one.limit->velocity <= 0) return;
  if (*velocity <= *one.limit->velocity * (1 + kRounded) || !wider.is_first()) return;
  Diagnostic& found = findings.report(joint.find("max_velocity").span(),
                                      "joint " + quoted(joint.key()) + " may move with " +
                                          format_rounded(*velocity) + ", faster than the " +
                                          format_rounded(*one.limit->velocity) + " of the URDF");
  wider.set(found);
  found.label(one.limit->velocity.span, "the limit in the URDF")
      .help("write at most the velocity of the URDF");
}

void check_positions(yaml::View joint, const urdf::Joint& one, Wider& wider, Findings& findings) {
  const yaml::View max = joint.find("max_position"), min = joint.find("min_position");
  if (!max && !min) return;
  const bool has_no_range = one.type == urdf::JointType::continuous ||
                            one.type == urdf::JointType::floating ||
                            one.type == urdf::JointType::planar;
  if (has_no_range) {
    findings
        .report((max ? max : min).key_span(), "joint " + quoted(joint.key()) +
                                                  " has a position limit, but is " +
                                                  one.type_name.value_or("continuous"))
        .help("delete the limit")
        .when(kContinuous);
    return;
  }
  if (!one.limit || !one.limit->lower || !one.limit->upper) return;
  const auto high = number_of(joint, "max_position"), low = number_of(joint, "min_position");
  const bool is_high = high && *high > *one.limit->upper + kSlack;
  const bool is_low = low && *low < *one.limit->lower - kSlack;
  if ((!is_high && !is_low) || !wider.is_first()) return;
  Diagnostic& found = findings.report(
      (is_high ? max : min).span(),
      "joint " + quoted(joint.key()) + " may move beyond the limits of the URDF, " +
          format_rounded(*one.limit->lower) + " to " + format_rounded(*one.limit->upper));
  wider.set(found);
  found.label(one.name.span, "the joint is defined here").help("write a position within them");
}

void check(const LinkedModel& model, const Companions& companions, Findings& findings) {
  std::map<const Companion*, std::pair<Wider, Wider>> files;
  for_each_joint_limit(companions, [&](const Companion& file, yaml::View joint) {
    for (const std::string_view what : {"velocity", "acceleration", "jerk"}) {
      check_missing(joint, what, findings);
    }
    const urdf::Joint* one = model.find_joint(joint.key());
    if (one == nullptr) return;
    auto& [faster, further] = files[&file];
    check_velocity(joint, *one, faster, findings);
    check_positions(joint, *one, further, findings);
  });
  for (auto& [file, wider] : files) {
    wider.first.finish();
    wider.second.finish();
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and has no such limit",
     "moveit2 robot_model_loader.cpp", when(kMissing)},
    {&readers::moveit, Effect::breaks, "reports an error and ignores the limit",
     "moveit2 robot_model_loader.cpp", when(kContinuous)},
    {&readers::moveit, Effect::changes, "plans with the limit of joint_limits.yaml",
     "moveit2 robot_model_loader.cpp"},
};

}  // namespace

extern constinit const Rule sml3803_moveit_limit{
    .id = "SML3803",
    .name = "moveit-limit",
    .severity = Severity::warning,
    .summary = "A limit in joint_limits.yaml is missing, or is wider than that of the URDF.",
    .remedy = "Write limits within those of the URDF.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3803_moveit_limit_file
