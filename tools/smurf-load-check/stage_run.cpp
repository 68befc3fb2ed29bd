// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/stage_run.hpp"

#include <algorithm>
#include <cmath>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "smurf-load-check/trace.hpp"

namespace smurf::load_check {
namespace {

/// ODE's solver can give up if a joint is exactly at a stop, as in closed grippers; with this
/// margin, it does not.
constexpr double kStopMargin = 1e-9;  // rad or m

std::string words_of(const std::vector<EngineMessage>& messages) {
  std::string text;
  for (const EngineMessage& message : messages) {
    text += (text.empty() ? "" : "; ") + message.text;
    if (message.count > 1) text += ", " + std::to_string(message.count) + " times";
  }
  return text;
}

}  // namespace

void StageRun::stage(Stage stage, const StageBody& body) {
  if (stage != Stage::build && !options_.stages.contains(stage)) return;
  StageResult result;
  result.stage = stage;
  if (has_failed_) {
    skip(result, "an earlier stage failed");
    result_.stages.push_back(std::move(result));
    return;
  }
  current_ = stage;
  on_stage_(stage, {result_.stages, result_.diagnostics, {}, {}});
  std::vector<EngineMessage> messages = attempt(body, 0, result);
  if (!messages.empty()) {
    messages = attempt(body, kStopMargin, result);
    if (!result.note.empty()) result.note += "; ";
    result.note += "started 1e-09 inside the stops, for ODE's solver";
  }
  if (!messages.empty()) give_no_verdict(messages, result);
  keep_findings(result);
  // Parts that BUILD refuses are replaced, so that the rest can be checked.
  has_failed_ = stage != Stage::build && result.verdict == Verdict::fail;
  result_.stages.push_back(std::move(result));
}

std::vector<EngineMessage> StageRun::attempt(const StageBody& body, double stop_margin,
                                             StageResult& result) {
  const std::size_t traced = result_.trace.size();
  const bool was_cut = result_.is_trace_cut;
  sink_.take();
  withdrawn_ = nullptr;
  stop_margin_ = stop_margin;
  take_engine_messages();
  StageResult attempted;
  attempted.stage = result.stage;
  body(attempted);
  std::vector<EngineMessage> messages = take_engine_messages();
  if (!messages.empty() && stop_margin == 0) {
    result_.trace.resize(traced);
    result_.is_trace_cut = was_cut;
  }
  result = std::move(attempted);
  return messages;
}

/// If the solver gave up, figures are meaningless, whether they are within their bounds or
/// not.
void StageRun::give_no_verdict(const std::vector<EngineMessage>& messages, StageResult& result) {
  sink_.take();
  withdrawn_ = nullptr;
  result.figures.clear();
  result.note = "ODE's solver gives up";
  const Named suspect = suspect_();
  Diagnostic& diagnostic =
      sink_.report(rules::sml6002_no_verdict, suspect.place,
                   "there is no verdict of stage " + std::string(to_string(current_)) +
                       ": ODE's solver gives up");
  diagnostic.note("ODE: " + words_of(messages));
  if (!suspect.name.empty()) {
    diagnostic.note(suspect.name + " starts at a stop, which is the likely cause");
  }
}

namespace {

/// A stage whose numbers are all within their bounds does not show why it warns.
void tell_reason(StageResult& result, const Rule& rule) {
  const bool is_shown = std::any_of(result.figures.begin(), result.figures.end(),
                                    [](const Figure& figure) { return !figure.is_within(); });
  if (is_shown || result.note.find(rule.id) != std::string::npos) return;
  result.note += (result.note.empty() ? "see " : ", see ") + std::string(rule.id);
}

}  // namespace

void StageRun::keep_findings(StageResult& result) {
  if (withdrawn_ != nullptr) {
    std::erase_if(result_.diagnostics,
                  [&](const Diagnostic& diagnostic) { return diagnostic.rule == withdrawn_; });
  }
  for (Diagnostic& diagnostic : sink_.take()) {
    Verdict verdict = diagnostic.severity == Severity::error ? Verdict::fail : Verdict::warn;
    if (diagnostic.severity == Severity::info) verdict = Verdict::pass;
    if (diagnostic.rule == &rules::sml6002_no_verdict) verdict = Verdict::none;
    result.verdict = std::max(result.verdict, verdict);
    if (verdict == Verdict::warn) tell_reason(result, *diagnostic.rule);
    result_.diagnostics.push_back(std::move(diagnostic));
  }
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

bool StageRun::step(World& world, const Plan& plan, double seconds,
                    const std::function<void()>& measure) {
  const double time = options_.time.value_or(seconds);
  trace(world, plan);
  // Counts steps, because rounding of the time could add a step.
  const auto steps = static_cast<std::size_t>(std::llround(time / world.step_size()));
  for (std::size_t i = 0; i < steps; ++i) {
    world.step();
    if (!world.is_finite()) {
      const Named lost = fastest(world, plan);
      sink_.report(rules::sml6001_engine_gives_up, lost.place, "ODE loses " + lost.name).caret =
          "its position is not a number after " + format_rounded(world.time()) + " s";
      return false;
    }
    measure();
    trace(world, plan);
  }
  return true;
}

/// The rows of a step are in the trace completely or not at all.
void StageRun::trace(const World& world, const Plan& plan) {
  if (!options_.trace || result_.is_trace_cut) return;
  if (traced_links_.empty()) {
    result_.trace.reserve(options_.most_trace_bytes);  // growing needs three times the memory
    for (const LinkPlan& link : plan.links) {
      const std::string& entity = plan.models[link.instance].name;
      traced_links_.push_back(
          field_of((entity.empty() ? "" : entity + "/") + plan.link(link).name.value_or("")));
    }
  }
  const std::size_t before = result_.trace.size();
  constexpr std::size_t kStageAndNumbers = 256;
  for (std::size_t i = 0; i < plan.links.size() && !result_.is_trace_cut; ++i) {
    const std::size_t row = options_.traced_as.size() + traced_links_[i].size() + kStageAndNumbers;
    result_.is_trace_cut = result_.trace.size() + row > options_.most_trace_bytes;
    if (result_.is_trace_cut) break;
    append_row(result_.trace, options_.traced_as, current_, world.time(), traced_links_[i],
               world.link_pose(plan.links[i]));
  }
  if (result_.is_trace_cut) result_.trace.resize(before);
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
