// SPDX-License-Identifier: BSD-3-Clause
// The table of readers, and the search for facts.
#include "base/readers.hpp"

#include <algorithm>

#include "base/uncertain.hpp"

namespace smurf {

namespace {

constexpr const Reader* kReaders[] = {
#define SMURF_READER(name) &readers::name,
#include "base/readers.def"
#undef SMURF_READER
};

/// Skips a predicate of an XPath by its brackets and quotes, because it may contain any name.
std::string without_predicates(std::string_view pointer) {
  std::string path;
  char quote = '\0';
  int depth = 0;
  for (const char c : pointer) {
    if (depth > 0 && quote == '\0' && (c == '\'' || c == '"')) {
      quote = c;
    } else if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '[') {
      ++depth;
    } else if (c == ']' && depth > 0) {
      --depth;
    } else if (depth == 0) {
      path += c;
    }
  }
  return path;
}

bool is_index(std::string_view segment) {
  return !segment.empty() &&
         std::all_of(segment.begin(), segment.end(), [](char c) { return c >= '0' && c <= '9'; });
}

constexpr Fact kNoAnnotations{.makes = "reads no annotations",
                              .evidence = "it opens the URDF only"};

constexpr Fact kNoCompanions{.makes = "does not read it", .evidence = "it opens the URDF only"};

/// SRDFs, elements `ros2_control`, and parameter files of ROS.
bool is_about_companions(const Rule& rule) {
  for (const std::string_view family : {"SML35", "SML36", "SML37", "SML38"}) {
    if (rule.id.starts_with(family)) return true;
  }
  return false;
}

/// References from annotations, and their keys.
bool is_about_annotations(const Rule& rule) {
  return rule.id.starts_with("SML3") || rule.id.starts_with("SML4");
}

/// Readers are not affected by mistakes in a configuration, or by the losses of a
/// converter.
bool is_about_robots(const Rule& rule) {
  return rule.reported_by == Tool::lint && !rule.id.starts_with("SML9");
}

/// The rule whose facts apply: for "further findings are left out", the rule of the omitted
/// findings.
const Rule& subject_of(const Diagnostic& diagnostic) {
  return diagnostic.left_out == nullptr ? *diagnostic.rule : *diagnostic.left_out;
}

/// Malformed XML and invalid text are faults wherever they are.
bool is_about_content(const Rule& rule) {
  if (!rule.id.starts_with("SML1")) return false;
  return !rule.id.starts_with("SML10") || rule.id == "SML1009" || rule.id == "SML1012";
}

const Fact* find_unread(const Reader& reader, const Rule& rule, std::string_view path) {
  if (!is_about_content(rule) || path.find(kVisualsKept) != std::string_view::npos) return nullptr;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    for (const Fact& fact : known->unread) {
      if (path.find(fact.where) != std::string_view::npos) return &fact;
    }
  }
  return nullptr;
}

/// Only the facts of the reader that it is like apply there.
bool is_dropped_by(const Reader& reader, std::string_view path) {
  const std::size_t at = path.find(kDroppedBy);
  return at != std::string_view::npos &&
         path.substr(at + kDroppedBy.size()).starts_with(reader.name);
}

const Fact* find_fact(const Reader& reader, const Rule& rule, std::string_view path) {
  if (const Fact* fact = find_unread(reader, rule, path)) return fact;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (is_dropped_by(*known, path)) continue;
    for (const Fact& fact : rule.facts) {
      if (fact.reader == known && path.find(fact.where) != std::string_view::npos) return &fact;
    }
    for (const auto& [family, fact] : known->families) {
      if (!rule.id.starts_with(family)) continue;
      if (path.find(fact.where) != std::string_view::npos) return &fact;
    }
  }
  if (is_about_companions(rule)) return &kNoCompanions;
  const bool is_read = reader.reads_annotations || !is_about_annotations(rule);
  return is_read ? nullptr : &kNoAnnotations;
}

std::string_view without_slashes(std::string_view path) {
  while (path.starts_with('/')) path.remove_prefix(1);
  while (path.ends_with('/')) path.remove_suffix(1);
  return path;
}

}  // namespace

std::string_view to_string(Effect effect) {
  switch (effect) {
  case Effect::takes: return "takes";
  case Effect::ignores: return "ignores";
  case Effect::changes: return "changes";
  case Effect::loses: return "loses";
  case Effect::breaks: return "breaks";
  case Effect::refuses: return "refuses";
  case Effect::crashes: return "crashes";
  }
  return "";
}

std::span<const Reader* const> all_readers() { return kReaders; }

const Reader* find_target(std::string_view name) {
  for (const Reader* reader : kReaders) {
    if (reader->is_target && reader->name == name) return reader;
  }
  return nullptr;
}

std::vector<std::string_view> target_names() {
  std::vector<std::string_view> names;
  for (const Reader* reader : kReaders) {
    if (reader->is_target) names.push_back(reader->name);
  }
  return names;
}

std::string fact_path(const Diagnostic& diagnostic) {
  const std::string path = without_predicates(diagnostic.pointer);
  std::string out = "/";
  std::string_view rest = path;
  while (!rest.empty()) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view segment = rest.substr(0, slash);
    if (!segment.empty() && !is_index(segment)) out.append(segment).append("/");
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  if (!diagnostic.construct.empty()) out.append("#").append(diagnostic.construct);
  return out;
}

const Fact* find_fact(const Reader& reader, const Diagnostic& diagnostic) {
  const std::string path = fact_path(diagnostic);
  const Fact* worst = find_fact(reader, subject_of(diagnostic), path);
  for (const Rule* rule : diagnostic.consequences) {
    const Fact* fact = find_fact(reader, *rule, path);
    if (fact != nullptr && (worst == nullptr || fact->effect > worst->effect)) worst = fact;
  }
  return worst;
}

bool has_facts(const Reader& reader, const Rule& rule) {
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    const bool is_in_row = std::any_of(rule.facts.begin(), rule.facts.end(),
                                       [&](const Fact& fact) { return fact.reader == known; });
    if (is_in_row ||
        std::any_of(known->families.begin(), known->families.end(),
                    [&](const FamilyFact& one) { return rule.id.starts_with(one.family); })) {
      return true;
    }
  }
  return false;
}

bool has_facts(const Rule& rule) {
  return !rule.facts.empty() ||
         std::any_of(std::begin(kReaders), std::end(kReaders),
                     [&](const Reader* reader) { return has_facts(*reader, rule); });
}

std::vector<const Fact*> facts_about(const Rule& rule) {
  std::vector<const Fact*> known;
  for (const Reader* reader : kReaders) {
    bool is_complete = false;  // a fact about all places overrides those of the family
    for (const Fact& fact : rule.facts) {
      if (fact.reader != reader) continue;
      known.push_back(&fact);
      is_complete = is_complete || fact.where.empty();
    }
    for (const auto& [family, fact] : reader->families) {
      if (!is_complete && rule.id.starts_with(family)) known.push_back(&fact);
    }
  }
  return known;
}

std::string evidence_of(const Fact& fact) {
  if (fact.evidence != kRun) return std::string(fact.evidence);
  return std::string(fact.reader->version) + ", run";
}

std::string describe(const Fact& fact) {
  std::string text(fact.reader->title);
  std::string where;  // "/mass/@value/#hex#carried" becomes "mass/@value, hex, carried"
  for (std::string_view rest = fact.where; !rest.empty();) {
    const std::size_t end = std::min(rest.find('#'), rest.size());
    const std::string_view part = without_slashes(rest.substr(0, end));
    if (!part.empty()) where.append(where.empty() ? "" : ", ").append(part);
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  if (!where.empty()) text.append(" (").append(where).append(")");
  return text + ": " + std::string(fact.makes);
}

std::string sources_of(const Rule& rule) {
  std::vector<std::string> sources;
  for (const Fact* fact : facts_about(rule)) sources.push_back(evidence_of(*fact));
  if (!rule.sources.empty()) sources.emplace_back(rule.sources);
  std::string text;
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const auto end = sources.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::find(sources.begin(), end, sources[i]) != end) continue;
    text += (text.empty() ? "" : "; ") + sources[i];
  }
  return text.empty() || text.ends_with('.') ? text : text + ".";
}

std::string_view to_string(Answer answer) {
  switch (answer) {
  case Answer::takes: return "takes";
  case Answer::loses: return "loses";
  case Answer::unknown: return "unknown";
  case Answer::refuses: return "refuses";
  }
  return "";
}

Answer TargetVerdict::answer() const {
  if (refusals > 0) return Answer::refuses;
  if (unknown > 0) return Answer::unknown;
  return losses > 0 ? Answer::loses : Answer::takes;
}

std::size_t TargetVerdict::count(Answer answer) const {
  switch (answer) {
  case Answer::takes: return 0;
  case Answer::loses: return losses;
  case Answer::unknown: return unknown;
  case Answer::refuses: return refusals;
  }
  return 0;
}

void TargetVerdict::add_unknown(const Rule& of, std::size_t faults) {
  unknown += faults;
  const auto known = std::find(unknown_rules.begin(), unknown_rules.end(), &of);
  if (known == unknown_rules.end()) unknown_rules.push_back(&of);
}

void TargetVerdict::add(const TargetVerdict& other) {
  refusals += other.refusals;
  unknown += other.unknown;
  losses += other.losses;
  for (const Rule* unknown_rule : other.unknown_rules) add_unknown(*unknown_rule, 0);
  if (other.fact == nullptr || (fact != nullptr && fact->effect >= other.fact->effect)) return;
  fact = other.fact;
  rule = other.rule;
  span = other.span;
}

TargetVerdict judge_target(const Reader& reader, std::span<const Diagnostic> diagnostics) {
  TargetVerdict verdict;
  verdict.reader = &reader;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!is_about_robots(*diagnostic.rule)) continue;
    const Fact* fact = find_fact(reader, diagnostic);
    if (fact == nullptr) {
      const Severity severity = diagnostic.untargeted.value_or(diagnostic.severity);
      if (severity != Severity::error || diagnostic.rule->needs_target) continue;
      verdict.add_unknown(*diagnostic.rule, 1);
      continue;
    }
    if (fact->effect <= Effect::ignores) continue;
    if (is_uncertain(*fact)) {
      verdict.add_unknown(*diagnostic.rule, 1);
      continue;
    }
    ++(fact->effect >= Effect::refuses ? verdict.refusals : verdict.losses);
    if (verdict.fact != nullptr && verdict.fact->effect >= fact->effect) continue;
    verdict.fact = fact;
    verdict.rule = diagnostic.rule;
    verdict.span = diagnostic.span;
  }
  return verdict;
}

}  // namespace smurf
