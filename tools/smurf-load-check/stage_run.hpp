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
  /// `suspect` is the likely cause of a complaint of the engine; its name may be empty.
  StageRun(const CheckOptions& options, const OnStage& on_stage, std::function<Named()> suspect)
      : options_(options), on_stage_(on_stage), suspect_(std::move(suspect)) {}

  /// Runs a stage unless it is not requested or an earlier simulation failed. The verdict follows
  /// from the reports of `body`. If the engine complains, `body` runs once more with a stop margin;
  /// if it still complains, there is no verdict.
  void stage(Stage stage, const StageBody& body);
  CheckResult finish();

  const CheckOptions& options() const { return options_; }
  DiagnosticSink& sink() { return sink_; }
  /// For WorldSetup.
  double stop_margin() const { return stop_margin_; }

  Figure figure(std::string_view bound) const;
  /// Keeps the larger value, and NaN; `whose` names the object with this value.
  template <class Whose>
  static void note_worst(Figure& figure, double value, const Whose& whose) {
    if (value <= figure.value || std::isnan(figure.value)) return;
    const Named named = whose();
    figure.value = value;
    figure.worst = named.name;
    figure.place = named.place;
  }
  static void skip(StageResult& result, std::string why);
  /// Removes the findings of earlier stages under a rule.
  void withdraw(const Rule& rule) { withdrawn_ = &rule; }

  /// Steps for `seconds` (or --time), calling `measure` after every step. If a number is no longer
  /// finite, reports this, stops and returns false.
  bool step(World& world, const Plan& plan, double seconds, const std::function<void()>& measure);

 private:
  std::vector<EngineMessage> attempt(const StageBody& body, double stop_margin,
                                     StageResult& result);
  void give_no_verdict(const std::vector<EngineMessage>& messages, StageResult& result);
  void keep_findings(StageResult& result);
  /// The requested data about the state after a step.
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

/// The fastest body; a body without a finite position counts as the fastest.
Named fastest(const World& world, const Plan& plan);
/// Distance plus angle, a radian counting as a metre.
double way_between(const Pose& X_WA, const Pose& X_WB);
/// "1 joint", "3 joints".
std::string count_of(std::size_t count, std::string_view one, std::string_view many);

}  // namespace smurf::load_check
