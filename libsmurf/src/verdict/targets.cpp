// SPDX-License-Identifier: BSD-3-Clause
#include "verdict/targets.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "base/findings/uncertain.hpp"
#include "smurf/verdict.hpp"

namespace smurf {
namespace {

Severity severity_of(const Fact& fact) {
  if (fact.effect >= Effect::breaks && !is_uncertain(fact)) return Severity::error;
  return fact.effect >= Effect::changes ? Severity::warning : Severity::info;
}

Severity milder(Severity severity) {
  return severity == Severity::error ? Severity::warning : Severity::info;
}

/// An element that its author wrote for this reader, which loads it.
bool is_meant(const Fact& fact) {
  return fact.effect == Effect::takes &&
         std::any_of(fact.where.cases.begin(), fact.where.cases.end(),
                     [&](const Circumstance* one) {
                       return one != nullptr && one->written_for == fact.reader;
                     });
}

/// The effects of a finding on the targets.
struct Judgement {
  /// Facts except those that the file loads, each with its targets.
  std::vector<std::pair<const Fact*, std::string>> stumbles;
  bool is_known = true;  ///< of every target
  bool is_meant = true;  ///< written for every target
};

Judgement judge(const Diagnostic& diagnostic, std::span<const Reader* const> targets) {
  Judgement judgement;
  for (const Reader* reader : targets) {
    const Fact* fact = nullptr;  // the worst
    for_each_place(diagnostic, [&](const PlaceView& place) {
      const Fact* known = find_fact(*reader, diagnostic, place);
      judgement.is_known = judgement.is_known && known != nullptr;
      judgement.is_meant = judgement.is_meant && known != nullptr && is_meant(*known);
      if (known != nullptr && (fact == nullptr || known->effect > fact->effect)) fact = known;
    });
    if (fact == nullptr || fact->effect == Effect::takes) continue;
    auto& stumbles = judgement.stumbles;
    const auto known = std::find_if(stumbles.begin(), stumbles.end(), [&](const auto& stumble) {
      return stumble.first->makes == fact->makes;
    });
    if (known == stumbles.end()) {
      stumbles.emplace_back(fact, reader->name);
    } else {
      known->second.append(", ").append(reader->name);
    }
  }
  return judgement;
}

Severity severity_for(const Diagnostic& diagnostic, const Judgement& judgement) {
  if (diagnostic.cases.contains(kExcused)) return Severity::info;
  if (!has_facts(*diagnostic.rule) && judgement.stumbles.empty()) return diagnostic.severity;
  Severity severity = Severity::info;
  for (const auto& [fact, names] : judgement.stumbles) {
    severity = std::max(severity, severity_of(*fact));
  }
  const Rule& rule = *diagnostic.rule;
  // What nobody meant, no reader makes right. What nobody knows about a target stays as it is.
  const bool is_open = !judgement.is_known && !rule.needs_target;
  if (rule.about == About::robot || is_open) return std::max(severity, diagnostic.severity);
  const bool is_fine = rule.needs_target;  // unless one of the targets fails
  return judgement.stumbles.empty() && !is_fine ? milder(diagnostic.severity) : severity;
}

/// What to do for the targets that stumble: each cure with its targets, or without where one is
/// enough for all. Empty if the facts know none.
std::string cure_of(const Judgement& judgement) {
  const auto& stumbles = judgement.stumbles;
  if (stumbles.size() == 1) return std::string(stumbles.front().first->cure);
  std::string text;
  for (const auto& [fact, names] : stumbles) {
    if (fact->cure.empty()) continue;
    text.append(text.empty() ? "for " : "; for ").append(names).append(": ").append(fact->cure);
  }
  return text;
}

}  // namespace

void apply_targets(std::vector<Diagnostic>& diagnostics, std::span<const Reader* const> targets) {
  std::vector<Diagnostic> kept;
  kept.reserve(diagnostics.size());
  for (Diagnostic& diagnostic : diagnostics) {
    const Judgement judgement = judge(diagnostic, targets);
    if (judgement.is_meant) continue;
    if (!diagnostic.untargeted) diagnostic.untargeted = diagnostic.severity;
    diagnostic.severity = severity_for(diagnostic, judgement);
    for (const auto& [fact, names] : judgement.stumbles) {
      diagnostic.note(names + ": " + std::string(fact->makes));
    }
    const bool asks_for_help = diagnostic.severity > Severity::info && diagnostic.fixes.empty();
    if (asks_for_help && diagnostic.help_text.empty()) diagnostic.help_text = cure_of(judgement);
    // If a target only ignores a part, that is no reason to report findings that are harmless in
    // general.
    if (diagnostic.rule->needs_target && diagnostic.severity == Severity::info) continue;
    kept.push_back(std::move(diagnostic));
  }
  diagnostics = std::move(kept);
}

}  // namespace smurf
