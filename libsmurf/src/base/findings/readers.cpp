// SPDX-License-Identifier: BSD-3-Clause
// The table of readers, and the search for facts.
#include "base/findings/readers.hpp"

#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/findings/uncertain.hpp"

namespace smurf {

namespace {

constexpr const Reader* kReaders[] = {
#define SMURF_READER(name) &readers::name,
#include "base/findings/readers.def"
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

constexpr Fact kNoExpansion{.effect = Effect::refuses,
                            .makes = "gets no robot, because xacro fails",
                            .evidence = "xacro 2.1.1, run"};

/// Faults of xacro, which runs before all readers.
bool is_about_expansion(const Rule& rule) { return rule.id.starts_with("SML33"); }

/// Whether a rule is about annotations, companions or scenes, which readers of the URDF do not
/// open.
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

/// Mappings whose keys are names that users give.
constexpr Where kMapsOfNames[] = {at("poses/joints")};

bool is_user_name(std::span<const PlaceName> above) {
  return std::any_of(std::begin(kMapsOfNames), std::end(kMapsOfNames), [&](const Where& map) {
    const auto end = std::find(map.place.begin(), map.place.end(), PlaceName{});
    const auto size = static_cast<std::size_t>(end - map.place.begin());
    return size <= above.size() &&
           std::equal(map.place.begin(), end, above.end() - static_cast<std::ptrdiff_t>(size));
  });
}

/// The version of a reader that is meant by a target.
Version version_in(const Reader& target, const Reader& of) {
  const auto parts = target.parts.empty() && !target.releases.empty()
                         ? target.releases.front()->parts
                         : target.parts;
  for (const auto& [reader, version] : parts) {
    if (reader == &of) return version;
  }
  return of.number;
}

/// What facts see of a finding.
struct Finding {
  const Reader& target;
  std::vector<PlaceName> path;
  const Circumstances& cases;

  bool fits(const Fact& fact) const {
    const Where& where = fact.where;
    for (const Circumstance* one : where.cases) {
      if (one != nullptr && !cases.contains(*one)) return false;
    }
    if (where.except != nullptr && cases.contains(*where.except)) return false;
    if (!contains(path, where)) return false;
    if (where.from == Version{} && where.until == Version{}) return true;
    const Version version = version_in(target, *fact.reader);
    return where.from <= version && (where.until == Version{} || version < where.until);
  }
};

const Fact* find_unread(const Reader& reader, const Rule& rule, const Finding& finding) {
  if (!is_about_content(rule)) return nullptr;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    for (const Fact& fact : known->unread) {
      if (finding.fits(fact)) return &fact;
    }
  }
  return nullptr;
}

/// Whether a reader opens SRDFs or parameter files of ROS.
bool reads_companions(const Reader& reader) {
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (known == &readers::moveit || known == &readers::ros2_control) return true;
  }
  return false;
}

const Fact* find_fact(const Reader& reader, const Rule& rule, const Finding& finding) {
  if (finding.cases.contains(cases::kInCompanion) && !reads_companions(reader)) {
    return &kNoCompanions;
  }
  if (const Fact* fact = find_unread(reader, rule, finding)) return fact;
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    if (known->drops != nullptr && finding.cases.contains(*known->drops)) continue;
    for (const Fact& fact : rule.facts) {
      if (fact.reader == known && finding.fits(fact)) return &fact;
    }
    for (const auto& [family, fact] : known->families) {
      if (rule.id.starts_with(family) && finding.fits(fact)) return &fact;
    }
  }
  if (is_about_companions(rule)) return &kNoCompanions;
  if (is_about_expansion(rule)) return rule.may_pass_elsewhere ? nullptr : &kNoExpansion;
  const bool is_read = reader.reads_annotations || !is_about_annotations(rule);
  return is_read ? nullptr : &kNoAnnotations;
}

void append(std::string_view part, std::string& text) {
  text.append(text.empty() ? "" : ", ").append(part);
}

std::string text_of(Version version) {
  std::string text = std::to_string(version.major) + "." + std::to_string(version.minor);
  return version.patch == 0 ? text : text + "." + std::to_string(version.patch);
}

/// Adds a verdict, apart from those of later releases.
void add_to(TargetVerdict& sum, const TargetVerdict& other) {
  sum.refusals += other.refusals;
  sum.unknown += other.unknown;
  sum.losses += other.losses;
  for (const Rule* unknown_rule : other.unknown_rules) sum.add_unknown(*unknown_rule, 0);
  if (other.fact == nullptr) return;
  if (sum.fact != nullptr && sum.fact->effect >= other.fact->effect) return;
  sum.fact = other.fact;
  sum.rule = other.rule;
  sum.span = other.span;
}

/// The verdicts of the later releases. Where nothing depends on the version, they are the same.
std::vector<TargetVerdict> newer_of(const TargetVerdict& verdict) {
  if (!verdict.newer.empty()) return verdict.newer;
  std::vector<TargetVerdict> newer;
  for (std::size_t i = 1; i < verdict.reader->releases.size(); ++i) {
    newer.push_back(verdict);
    newer.back().reader = verdict.reader->releases[i];
  }
  return newer;
}

bool has_range(const Fact& fact) {
  return fact.where.from != Version{} || fact.where.until != Version{};
}

bool depends_on_version(const Reader& reader, const Diagnostic& diagnostic) {
  if (reader.releases.size() < 2) return false;
  const auto is_dated = [](const Rule* rule) {
    return std::any_of(rule->facts.begin(), rule->facts.end(), has_range);
  };
  return is_dated(&subject_of(diagnostic)) ||
         std::any_of(diagnostic.consequences.begin(), diagnostic.consequences.end(), is_dated);
}

TargetVerdict judge_release(const Reader& reader, std::span<const Diagnostic> diagnostics) {
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
    if (!reader->is_target) continue;
    if (reader->name == name) return reader;
    for (const auto releases : {reader->earlier, reader->releases}) {
      const auto known = std::find_if(releases.begin(), releases.end(),
                                      [&](const Reader* one) { return one->name == name; });
      if (known != releases.end()) return *known;
    }
  }
  return nullptr;
}

std::vector<std::string_view> target_names() {
  std::vector<std::string_view> names;
  for (const Reader* reader : kReaders) {
    if (reader->is_target) names.push_back(reader->name);
    for (const Reader* release : reader->earlier) names.push_back(release->name);
    for (const Reader* release : reader->releases) names.push_back(release->name);
  }
  return names;
}

std::vector<PlaceName> place_of(const Diagnostic& diagnostic) {
  std::string path = without_predicates(diagnostic.pointer);
  // An element whose name is in another case is at the place of the one that is meant.
  if (diagnostic.rule == &rules::sml1114_tag_case) path = path::to_lower(path);
  std::vector<PlaceName> place;
  std::string_view rest = path;
  while (!rest.empty()) {
    const std::size_t slash = std::min(rest.find('/'), rest.size());
    const std::string_view segment = rest.substr(0, slash);
    if (!segment.empty() && !is_index(segment)) {
      place.push_back(is_user_name(place) ? PlaceName{} : place_name(segment));
    }
    rest.remove_prefix(std::min(slash + 1, rest.size()));
  }
  return place;
}

bool contains(std::span<const PlaceName> path, const Where& where) {
  constexpr PlaceName kAny = place_name(kAnyAttribute);
  const auto end = std::find(where.place.begin(), where.place.end(), PlaceName{});
  return std::search(path.begin(), path.end(), where.place.begin(), end,
                     [](PlaceName found, PlaceName wanted) {
                       return found == wanted ||
                              (wanted == kAny && to_string(found).starts_with('@'));
                     }) != path.end() ||
         end == where.place.begin();
}

const Fact* find_fact(const Reader& reader, const Diagnostic& diagnostic) {
  const Finding finding{reader, place_of(diagnostic), diagnostic.cases};
  const Fact* worst = find_fact(reader, subject_of(diagnostic), finding);
  for (const Rule* rule : diagnostic.consequences) {
    const Fact* fact = find_fact(reader, *rule, finding);
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
      is_complete = is_complete || fact.where == Where{};
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

std::string describe(const Where& where) {
  std::string text;
  for (const PlaceName name : where.place) {
    if (name == PlaceName{}) break;
    const std::string_view row = to_string(name);
    text.append(text.empty() ? "" : "/").append(row);
    if (row == kAnyAttribute || row == kOfXacro) text += '*';
  }
  for (const Circumstance* one : where.cases) {
    if (one != nullptr) append(one->name, text);
  }
  if (where.except != nullptr) append("unless " + std::string(where.except->name), text);
  if (where.from != Version{}) append("since " + text_of(where.from), text);
  if (where.until != Version{}) append("before " + text_of(where.until), text);
  return text;
}

std::string describe(const Fact& fact) {
  std::string text(fact.reader->title);
  const std::string where = describe(fact.where);
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

const TargetVerdict* find_other_release(const TargetVerdict& verdict) {
  const auto other =
      std::find_if(verdict.newer.begin(), verdict.newer.end(),
                   [&](const TargetVerdict& one) { return one.answer() != verdict.answer(); });
  return other == verdict.newer.end() ? nullptr : &*other;
}

void TargetVerdict::add(const TargetVerdict& other) {
  if (!newer.empty() || !other.newer.empty()) {
    std::vector<TargetVerdict> sums = newer_of(*this);
    const std::vector<TargetVerdict> others = newer_of(other);
    for (std::size_t i = 0; i < sums.size(); ++i) add_to(sums[i], others[i]);
    newer = std::move(sums);
  }
  add_to(*this, other);
}

TargetVerdict judge_target(const Reader& reader, std::span<const Diagnostic> diagnostics) {
  TargetVerdict verdict = judge_release(reader, diagnostics);
  const bool is_dated =
      std::any_of(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& diagnostic) {
        return depends_on_version(reader, diagnostic);
      });
  for (std::size_t i = 1; is_dated && i < reader.releases.size(); ++i) {
    verdict.newer.push_back(judge_release(*reader.releases[i], diagnostics));
  }
  return verdict;
}

}  // namespace smurf
