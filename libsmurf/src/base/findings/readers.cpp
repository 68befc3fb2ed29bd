// SPDX-License-Identifier: BSD-3-Clause
// The table of readers, and what it says about rules.
#include "base/findings/readers.hpp"

#include <algorithm>
#include <array>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"

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

void append(std::string_view part, std::string& text) {
  text.append(text.empty() ? "" : ", ").append(part);
}

std::string text_of(Version version) {
  std::string text = std::to_string(version.major) + "." + std::to_string(version.minor);
  return version.patch == 0 ? text : text + "." + std::to_string(version.patch);
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
  if (!diagnostic.names.empty()) return diagnostic.names;
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

bool has_facts(const Reader& reader, const Rule& rule) {
  for (const Reader* known = &reader; known != nullptr; known = known->like) {
    const bool is_in_row = std::any_of(rule.facts.begin(), rule.facts.end(),
                                       [&](const Fact& fact) { return fact.reader == known; });
    if (is_in_row || std::any_of(known->families.begin(), known->families.end(),
                                 [&](const FamilyFact& one) { return one.family.covers(rule); })) {
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
      if (!is_complete && family.covers(rule)) known.push_back(&fact);
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

std::vector<std::string> cures_of(const Rule& rule) {
  std::vector<std::string> cures;
  for (const Fact* fact : facts_about(rule)) {
    if (fact->cure.empty()) continue;
    cures.push_back(std::string(fact->reader->title) + ": " + std::string(fact->cure));
  }
  return cures;
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

}  // namespace smurf
