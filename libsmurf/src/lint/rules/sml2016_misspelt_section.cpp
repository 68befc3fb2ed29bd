// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <utility>

#include "ast/key_renames.hpp"
#include "ast/sections.hpp"
#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "lint/annotation_queries.hpp"
#include "smurf/user_schemas.hpp"

namespace smurf::rules::sml2016_misspelt_section_file {
namespace {

/// Whether an entry contains a key of the section other than its name.
bool looks_like(const SectionSpec& section, yaml::View value) {
  const std::vector<const KeySpec*> keys = section.keys();
  const auto has_key = [&](yaml::View entry) {
    return entry.is_mapping() && std::any_of(entry.begin(), entry.end(), [&](yaml::View member) {
             return member.key() != "name" &&
                    std::any_of(keys.begin(), keys.end(),
                                [&](const KeySpec* spec) { return spec->name == member.key(); });
           });
  };
  if (section.form == SectionForm::list_or_mapping && has_key(value)) return true;
  const bool is_list = value.is_sequence();
  return (is_list || section.form == SectionForm::named) &&
         std::any_of(value.begin(), value.end(), has_key);
}

/// A rename must not give a file the same section twice.
class Sections {
 public:
  KeyRenames& of(yaml::View section) {
    return renames_.try_emplace(section.span().source, section.document().view()).first->second;
  }

  void offer_rename(Diagnostic& diagnostic, yaml::View section, std::string_view name) {
    KeyRenames& renames = of(section);
    if (!renames.is_free(name)) {
      diagnostic.help("does it belong in " + quoted(name) +
                      "? A file can have only one section of that name");
      return;
    }
    diagnostic.help("did you mean " + quoted(name) + "?");
    renames.offer(diagnostic.fixes, section, name);
  }

 private:
  std::map<SourceId, KeyRenames> renames_;
};

void check(const LinkedModel& model, Findings& findings) {
  Sections sections;
  const std::vector<std::string_view> known = section_names();
  for (const TopLevelKey& key : top_level_keys(model)) {
    const auto near = nearest(key.value.key(), known);
    if (!near || key.value.is_scalar() || key.value.is_null()) continue;
    const SectionSpec& section = *find_section(*near);
    if (!looks_like(section, key.value)) continue;
    Diagnostic& diagnostic = findings.report(key.value.key_span(), "no reader knows a section " +
                                                                       quoted(key.value.key()));
    // Then the whole file has no effect.
    if (key.value.document().view().size() == 1) diagnostic.severity = Severity::error;
    sections.offer_rename(diagnostic, key.value, section.name);
  }
}

/// Data files of entities contain custom sections.
void check_data(const LinkedScene& scene, Findings& findings) {
  if (scene.schemas == nullptr) return;
  Sections sections;
  const std::vector<std::string_view> known = scene.schemas->sections();
  for (const DataFile& file : scene.data_files) {
    const yaml::View root = file.document.view();
    if (!root || !root.is_mapping()) continue;
    for (const yaml::View value : root) {
      const auto near = nearest(value.key(), known);
      if (!near || sections.of(value).has(*near) || value.is_scalar()) continue;
      Diagnostic& diagnostic = findings.report(
          value.key_span(), "there is no schema for a section " + quoted(value.key()));
      sections.offer_rename(diagnostic, value, *near);
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::loses, "looks sections up by their exact names",
     "MARS smurf.cpp:257-485"},
    {&readers::mars2, Effect::loses, "looks sections up by their exact names",
     "MARS smurf.cpp:257-485"},
    {&readers::phobos, Effect::loses, "looks sections up by their exact names",
     "MARS smurf.cpp:257-485"},
};

}  // namespace

extern constinit const Rule sml2016_misspelt_section{
    .id = "SML2016",
    .name = "misspelt-section",
    .severity = Severity::warning,
    .summary = "A section unknown to all readers resembles a known one, by name and content.",
    .remedy = "Correct the name, or give a custom section a name that differs more.",
    .check_model = check,
    .check_scene = check_data,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml2016_misspelt_section_file
