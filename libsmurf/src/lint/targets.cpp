// SPDX-License-Identifier: BSD-3-Clause
#include "lint/targets.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "smurf/lint.hpp"

namespace smurf {
namespace {

/// No body has a negative mass or such an inertia, and no joint joins a link to itself: what a
/// reader makes of it is its own affair.
constexpr std::string_view kImpossible[] = {"SML1207", "SML1509", "SML1512", "SML1513"};

bool is_impossible(const Rule& rule) {
  return std::find(std::begin(kImpossible), std::end(kImpossible), rule.id) !=
         std::end(kImpossible);
}

Severity severity_of(Effect effect) {
  if (effect >= Effect::breaks) return Severity::error;
  return effect >= Effect::changes ? Severity::warning : Severity::info;
}

Severity milder(Severity severity) {
  return severity == Severity::error ? Severity::warning : Severity::info;
}

/// The facts about a finding, each with the targets it holds for.
using Stumbles = std::vector<std::pair<const ReaderFact*, std::string>>;

Stumbles find_stumbles(const Diagnostic& diagnostic, std::span<const Reader* const> targets) {
  Stumbles stumbles;
  for (const Reader* reader : targets) {
    const ReaderFact* fact = find_fact(*reader, diagnostic);
    if (fact == nullptr) continue;
    const auto known = std::find_if(stumbles.begin(), stumbles.end(), [&](const auto& stumble) {
      return stumble.first->makes == fact->makes;
    });
    if (known == stumbles.end()) {
      stumbles.emplace_back(fact, reader->name);
    } else {
      known->second.append(", ").append(reader->name);
    }
  }
  return stumbles;
}

Severity severity_for(const Diagnostic& diagnostic, const Stumbles& stumbles) {
  if (!has_facts(*diagnostic.rule)) return diagnostic.severity;
  Severity severity = Severity::info;
  for (const auto& [fact, names] : stumbles) {
    severity = std::max(severity, severity_of(fact->effect));
  }
  if (is_impossible(*diagnostic.rule)) return std::max(severity, diagnostic.severity);
  const bool is_fine = diagnostic.rule->needs_target;  // unless one of the targets stumbles
  return stumbles.empty() && !is_fine ? milder(diagnostic.severity) : severity;
}

}  // namespace

void apply_targets(std::vector<Diagnostic>& diagnostics, std::span<const Reader* const> targets) {
  for (Diagnostic& diagnostic : diagnostics) {
    const Stumbles stumbles = find_stumbles(diagnostic, targets);
    diagnostic.severity = severity_for(diagnostic, stumbles);
    for (const auto& [fact, names] : stumbles) {
      diagnostic.notes.push_back(names + ": " + std::string(fact->makes));
    }
  }
  // What a target has no use for is no reason to report what is fine in general.
  std::erase_if(diagnostics, [](const Diagnostic& diagnostic) {
    return diagnostic.rule->needs_target && diagnostic.severity == Severity::info;
  });
}

}  // namespace smurf
