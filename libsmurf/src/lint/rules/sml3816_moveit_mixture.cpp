// SPDX-License-Identifier: BSD-3-Clause
#include <string>

#include "base/findings/readers.hpp"
#include "base/text/quoted.hpp"
#include "lint/companions/pipelines.hpp"

namespace smurf::rules::sml3816_moveit_mixture_file {
namespace {

constexpr Circumstance kAdapter{"adapter"};

/// The fewer signs are the ones to change.
void check_mixture(const MoveitPipeline& pipeline, Findings& findings) {
  const bool is_later = pipeline.later.size() >= pipeline.humble.size();
  const ReleaseSign& odd = is_later ? pipeline.humble.front() : pipeline.later.front();
  const ReleaseSign& other = is_later ? pipeline.later.front() : pipeline.humble.front();
  const std::string mine = is_later ? "Humble" : "Jazzy and later";
  const std::string rest = is_later ? "Jazzy and later" : "Humble";
  findings.report(odd.place, odd.what + " is for " + mine + ", but the rest is for " + rest)
      .label(other.place, other.what + " is for " + rest)
      .help(odd.help);
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for (const MoveitPipeline& pipeline : moveit_pipelines(companions)) {
    if (!pipeline.humble.empty() && !pipeline.later.empty()) check_mixture(pipeline, findings);
    for (const MisspeltAdapter& one : pipeline.misspelt) {
      Diagnostic& found =
          findings.report(one.value.span(), "MoveIt has no adapter " + quoted(one.name));
      found.when(kAdapter).help("did you mean " + quoted(one.meant) + "?");
      if (one.name != one.value.text()) continue;  // one of several in a text
      found.fixes.push_back({Applicability::unsafe, {{one.value.span(), std::string(one.meant)}}});
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "finds no such adapter, and does not plan",
     "moveit2 default_request_adapters_plugin_description.xml, branches humble and jazzy",
     when(kAdapter)},
    {&readers::moveit, Effect::breaks,
     "does not find the planner or the adapters, and does not plan",
     "moveit2 planning_pipeline.cpp, branches humble and jazzy"},
};

}  // namespace

extern constinit const Rule sml3816_moveit_mixture{
    .id = "SML3816",
    .name = "moveit-mixture",
    .severity = Severity::warning,
    .summary = "Half of a planning pipeline is for MoveIt of Humble, half for later releases.",
    .why = "Humble reads `planning_plugin` and a text of adapters; Jazzy and later read lists.",
    .remedy = "Write the whole pipeline for one release.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3816_moveit_mixture_file
