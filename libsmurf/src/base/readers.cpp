// SPDX-License-Identifier: BSD-3-Clause
// The one table of readers, and how its facts are found.
#include "base/readers.hpp"

#include <algorithm>

namespace smurf {
namespace {

constexpr const Reader* kReaders[] = {
#define SMURF_READER(name) &readers::name,
#include "base/readers.def"
#undef SMURF_READER
};

/// A predicate in an XPath may hold any name, so it is skipped by its brackets and quotes.
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

const ReaderFact* find_fact(const Reader& reader, const Diagnostic& diagnostic) {
  const std::string path = fact_path(diagnostic);
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    for (const ReaderFact& fact : known->facts) {
      if (!diagnostic.rule->id.starts_with(fact.rule)) continue;
      if (path.find(fact.where) == std::string::npos) continue;
      return fact.effect == Effect::takes ? nullptr : &fact;
    }
  }
  return nullptr;
}

bool has_facts(const Reader& reader, const Rule& rule) {
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (std::any_of(known->facts.begin(), known->facts.end(),
                    [&](const ReaderFact& fact) { return rule.id.starts_with(fact.rule); })) {
      return true;
    }
  }
  return false;
}

bool has_facts(const Rule& rule) {
  return std::any_of(std::begin(kReaders), std::end(kReaders),
                     [&](const Reader* reader) { return has_facts(*reader, rule); });
}

std::vector<KnownFact> facts_about(const Rule& rule) {
  std::vector<KnownFact> known;
  for (const Reader* reader : kReaders) {
    for (const ReaderFact& fact : reader->facts) {
      if (rule.id.starts_with(fact.rule)) known.push_back({reader, &fact});
    }
  }
  return known;
}

std::string_view to_word(const TargetVerdict& verdict) {
  if (verdict.refusals > 0) return to_string(Effect::refuses);
  return to_string(verdict.losses > 0 ? Effect::loses : Effect::takes);
}

TargetVerdict judge_target(const Reader& reader, std::span<const Diagnostic> diagnostics) {
  TargetVerdict verdict;
  verdict.reader = &reader;
  for (const Diagnostic& diagnostic : diagnostics) {
    const ReaderFact* fact = find_fact(reader, diagnostic);
    if (fact == nullptr || fact->effect == Effect::ignores) continue;
    const bool is_refusal = fact->effect >= Effect::refuses;
    const bool is_first = is_refusal ? verdict.refusals == 0 : verdict.first == nullptr;
    ++(is_refusal ? verdict.refusals : verdict.losses);
    if (!is_first) continue;
    verdict.first = &diagnostic;
    verdict.fact = fact;
  }
  return verdict;
}

}  // namespace smurf
