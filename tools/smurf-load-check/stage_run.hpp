// SPDX-License-Identifier: BSD-3-Clause
// Code that all stages share: their order, their verdicts, stepping and sampling.
#pragma once

#include <cmath>
#include <functional>

#include "smurf-load-check/bodies.hpp"
#include "smurf-load-check/check.hpp"
#include "smurf-load-check/world.hpp"

namespace smurf::load_check {

using StageBody = std::function<void(StageResult&)>;

class StageRun {
 public:
  /// `suspect` is what a complaint of the engine is put down to; its name may be empty.
  StageRun(const CheckOptions& options, const OnStage& on_stage, std::function<Named()> suspect)
      : options_(options), on_stage_(on_stage), suspect_(std::move(suspect)) {}

  /// Runs a stage unless it is not asked for or an earlier simulation failed. The verdict comes
  /// from what `body` reports. When the engine complains, `body` runs once more with a stop margin;
  /// when it still does, there is no verdict.
  void stage(Stage stage, const StageBody& body);
  CheckResult finish();

  const CheckOptions& options() const { return options_; }
  DiagnosticSink& sink() { return sink_; }
  /// For WorldSetup.
  double stop_margin() const { return stop_margin_; }

  Figure figure(std::string_view bound) const;
  /// Keeps the larger value, and NaN; `whose` names what has it.
  template <class Whose>
  static void note_worst(Figure& figure, double value, const Whose& whose) {
    if (value <= figure.value || std::isnan(figure.value)) return;
    const Named named = whose();
    figure.value = value;
    figure.worst = named.name;
    figure.place = named.place;
  }
  static void skip(StageResult& result, std::string why);
  /// Takes back what earlier stages reported under a rule.
  void withdraw(const Rule& rule) { withdrawn_ = &rule; }

  /// Steps for `seconds` (or --time), calling `measure` after every step. Ends early, reports and
  /// returns false when a number is no longer finite.
  bool step(World& world, const Plan& plan, double seconds, const std::function<void()>& measure);

 private:
  std::vector<EngineMessage> attempt(const StageBody& body, double stop_margin,
                                     StageResult& result);
  void give_no_verdict(const std::vector<EngineMessage>& messages, StageResult& result);
  void keep_findings(StageResult& result);
  /// What was asked for of the state after a step.
  void record(const World& world, const Plan& plan, double start_energy);
  void sample(const World& world, const Plan& plan, double start_energy);
  void trace(const World& world, const Plan& plan);

  const CheckOptions& options_;
  const OnStage& on_stage_;
  std::function<Named()> suspect_;
  double stop_margin_ = 0;
  const Rule* withdrawn_ = nullptr;
  DiagnosticSink sink_;
  CheckResult result_;
  std::vector<std::string> traced_links_;  ///< "link", in scenes "entity/link"
  Stage current_ = Stage::build;
  bool has_failed_ = false;
};

/// The body with the highest speed; a body that is nowhere is the fastest.
Named fastest(const World& world, const Plan& plan);
/// Distance plus angle, a radian counting as a metre.
double way_between(const Pose& X_WA, const Pose& X_WB);
/// "1 joint", "3 joints".
std::string count_of(std::size_t count, std::string_view one, std::string_view many);

}  // namespace smurf::load_check
