// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include "ast/key_renames.hpp"
#include "ast/sections.hpp"
#include "base/findings/readers.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml2015_section_of_other_readers_file {
namespace {

/// Whether MARS reads no motor at all, so that the robot does not move.
bool loses_all_motors(std::string_view meant, const std::vector<TopLevelKey>& all) {
  return meant == sections::motors.name &&
         std::none_of(all.begin(), all.end(),
                      [&](const TopLevelKey& one) { return one.value.key() == meant; });
}

void check(const LinkedModel& model, Findings& findings) {
  std::map<SourceId, KeyRenames> renames;
  const std::vector<TopLevelKey> all = top_level_keys(model);
  for (const TopLevelKey& key : all) {
    const std::string_view name = key.value.key();
    const SectionSpec* section = find_section(name);
    // MARS reads `material` as well.
    if (section == nullptr || section->name == name || name == "material") continue;
    if (key.value.size() == 0 || key.value.is_scalar()) continue;
    Diagnostic& diagnostic =
        findings.report(key.value.key_span(),
                        "MARS does not read " + quoted(name) + ", only " + quoted(section->name));
    if (loses_all_motors(section->name, all)) diagnostic.severity = Severity::error;
    KeyRenames& names =
        renames.try_emplace(key.value.span().source, key.value.document().view()).first->second;
    const std::string remedy = names.is_free(section->name) ? "rename it" : "move it there";
    diagnostic.help(remedy + "; Phobos reads both");
    names.offer(diagnostic.fixes, key.value, section->name);
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses,
     "ignores `joints`, `links`, `collisions`, `motor` and `sensor` without a message",
     "MARS smurf.cpp:257-485"},
    {&readers::mars2, Effect::loses,
     "ignores `joints`, `links`, `collisions`, `motor` and `sensor` without a message",
     "MARS smurf.cpp:257-485"},
    {&readers::envire, Effect::loses,
     "ignores `joints`, `links`, `collisions`, `motor` and `sensor` without a message",
     "MARS smurf.cpp:257-485"},
    {&readers::phobos, Effect::takes, "reads singular and plural names",
     "Phobos io/smurfrobot.py:201-205"},
};

}  // namespace

extern constinit const Rule sml2015_section_of_other_readers{
    .id = "SML2015",
    .name = "section-of-other-readers",
    .severity = Severity::warning,
    .summary = "A section has a name that MARS does not know, but Phobos does.",
    .remedy = "Rename the section.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml2015_section_of_other_readers_file
