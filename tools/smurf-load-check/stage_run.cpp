// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/stage_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/numbers.hpp"
#include "base/rules.hpp"

namespace smurf::load_check {

void StageRun::stage(Stage stage, const std::function<void(StageResult&)>& body) {
  if (stage != Stage::build && !options_.stages.contains(stage)) return;
  StageResult result;
  result.stage = stage;
  if (has_failed_) {
    skip(result, "an earlier stage failed");
    result_.stages.push_back(std::move(result));
    return;
  }
  current_ = stage;
  on_stage_(stage);
  body(result);
  for (Diagnostic& diagnostic : sink_.take()) {
    const Verdict verdict = diagnostic.severity == Severity::error ? Verdict::fail : Verdict::warn;
    result.verdict = std::max(result.verdict, verdict);
    result_.diagnostics.push_back(std::move(diagnostic));
  }
  has_failed_ = result.verdict == Verdict::fail;
  result_.stages.push_back(std::move(result));
}

CheckResult StageRun::finish() { return std::move(result_); }

Figure StageRun::figure(std::string_view bound) const {
  Figure figure;
  figure.bound = bound;
  figure.limit = options_.bounds[bound];
  return figure;
}

void StageRun::skip(StageResult& result, std::string why) {
  result.verdict = Verdict::skipped;
  result.note = std::move(why);
}

void StageRun::withdraw(const Rule& rule) {
  std::erase_if(result_.diagnostics,
                [&](const Diagnostic& diagnostic) { return diagnostic.rule == &rule; });
}

bool StageRun::step(World& world, const Plan& plan, double seconds,
                    const std::function<void()>& measure) {
  const double time = options_.time.value_or(seconds);
  const double start_energy = world.energy();
  if (options_.samples) sample(world, plan, start_energy);
  // Counted, so that rounding of the time adds no step.
  const auto steps = static_cast<std::size_t>(std::llround(time / world.step_size()));
  for (std::size_t i = 0; i < steps; ++i) {
    world.step();
    if (!world.is_finite()) {
      const Named lost = fastest(world, plan);
      sink_.report(rules::sml6001_engine_gives_up, lost.place, "ODE loses " + lost.name).caret =
          "its place is no number after " + format_rounded(world.time()) + " s";
      return false;
    }
    measure();
    if (options_.samples) sample(world, plan, start_energy);
  }
  return true;
}

void StageRun::sample(const World& world, const Plan& plan, double start_energy) {
  Sample sample;
  sample.stage = current_;
  sample.time = world.time();
  sample.energy = world.energy() - start_energy;
  for (std::size_t i = 0; i < plan.joints.size(); ++i) {
    sample.gap = std::fmax(sample.gap, world.joint_error(i).gap);
  }
  if (options_.poses) {
    for (const LinkPlan& link : plan.links) sample.X_WL.push_back(world.link_pose(link));
    if (result_.links.empty()) {
      for (const LinkPlan& link : plan.links) {
        const std::string& entity = plan.models[link.instance].name;
        result_.links.push_back((entity.empty() ? "" : entity + "/") +
                                plan.link(link).name.value_or(""));
      }
    }
  }
  result_.samples.push_back(std::move(sample));
}

Named fastest(const World& world, const Plan& plan) {
  std::size_t found = 0;
  double speed = -1;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    const double own = world.speed(i);
    if (!(own <= speed)) {
      found = i;
      speed = own;
    }
    if (std::isnan(own)) break;
  }
  return plan.bodies.empty() ? Named{} : name_of_body(plan, found);
}

double way_between(const Pose& X_WA, const Pose& X_WB) {
  return (to_eigen(X_WA.position) - to_eigen(X_WB.position)).norm() +
         angle_between(X_WA.orientation, X_WB.orientation);
}

std::string count_of(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

}  // namespace smurf::load_check
