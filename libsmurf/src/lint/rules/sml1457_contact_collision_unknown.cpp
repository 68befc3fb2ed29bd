// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "link/gazebo_names.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1457_contact_collision_unknown_file {
namespace {

/// Whether a name is that of a merged collision: "palm_fixed_joint_lump__pad_collision_1".
bool is_lump_of(std::string_view name, std::string_view part) {
  const std::size_t at = name.find("__" + std::string(part));
  if (at == std::string_view::npos) return false;
  name.remove_prefix(at + 2 + part.size());
  return name.find_first_not_of("_0123456789") == std::string_view::npos;
}

/// What Gazebo calls the collision that is meant: the one of this name in the URDF, or a similar
/// name, or the only one.
std::optional<std::string_view> meant_name(const LinkedModel& model, const GazeboNames& names,
                                           const ContactName& contact, Findings& findings) {
  std::vector<std::string_view> known;
  for (std::size_t link = 0; link < names.bodies.size(); ++link) {
    if (names.bodies[link] != names.bodies[contact.link]) continue;
    for (std::size_t i = 0; i < names.collisions[link].size(); ++i) {
      const std::string& name = names.collisions[link][i];
      if (name.empty()) continue;
      const urdf::Collision& collision = model.robot->links[link].collisions[i];
      const bool is_meant =
          collision.name.value_or("") == contact.text || is_lump_of(name, contact.text);
      if (is_meant) return name;
      known.push_back(name);
    }
  }
  if (known.size() == 1) return known.front();
  return findings.suggest(contact.text, known);
}

void check(const LinkedModel& model, Findings& findings) {
  const std::vector<ContactName> contacts = contact_names(model);
  if (contacts.empty()) return;
  const GazeboNames names = gazebo_names(model);
  for (const ContactName& contact : contacts) {
    const bool is_path = contact.text.find("::") != std::string::npos;
    if (contact.text.empty() || is_path || find_collision(names, contact.link, contact.text)) {
      continue;
    }
    const Span place = contact.element.text_span();
    Diagnostic& diagnostic = findings.report(
        place, "Gazebo has no collision " + quoted(contact.text) + " where this sensor is");
    const auto meant = meant_name(model, names, contact, findings);
    if (!meant) {
      diagnostic.help("name a collision of " + title(model.robot->links[contact.link]) +
                      " as Gazebo does: the name in the URDF with `_collision` behind it");
      continue;
    }
    diagnostic.help("write " + quoted(*meant) + ", the name that Gazebo gives it");
    diagnostic.fixes.push_back({Applicability::unsafe, {{place, escape_xml(*meant)}}});
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::changes, "has a sensor that never reports a contact", kRun},
};

}  // namespace

extern constinit const Rule sml1457_contact_collision_unknown{
    .id = "SML1457",
    .name = "contact-collision-unknown",
    .severity = Severity::warning,
    .summary = "A contact sensor names a collision that Gazebo does not have.",
    .why =
        "The conversion to SDF puts `_collision` behind the name of a collision, or of its link if it has none, a number behind that from the second on, and the name of the body before that of a link that it has merged.",
    .remedy = "Write the name that Gazebo gives the collision.",
    .sources = "sdformat issue 64.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1457_contact_collision_unknown_file
