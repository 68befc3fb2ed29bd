// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/counted.hpp"
#include "link/gazebo_names.hpp"
#include "lint/queries.hpp"
#include "readers/rigid_bodies.hpp"
#include "readers/sdf_values.hpp"
#include "readers/sdformat_losses.hpp"

namespace smurf::rules::sml1455_setting_of_merged_link_file {
namespace {

/// What a setting does to a body; "" for one that does nothing, or that belongs to shapes.
std::string_view effect_of(xml::View setting) {
  const std::string_view name = setting.name();
  const std::string value = path::to_lower(sdf::given_value(setting));
  const bool is_off = value == "false" || value == "no" || value == "0";
  if (name == "turnGravityOff" && !is_off) return "switches off gravity";
  if (name == "gravity" && is_off) return "switches off gravity";
  if (name == "kinematic" && !is_off) return "switches off physics";
  if (name == "selfCollide" && is_set_for_gazebo(setting)) return "switches on self-collision";
  if (name == "self_collide" && !is_off) return "switches on self-collision";
  return {};
}

/// Settings of one effect for one body.
struct Setting {
  xml::View first;
  std::size_t link = 0, count = 0;
  bool is_of_body = false;  ///< the body itself has it, too
};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::vector<std::size_t> bodies;
  std::vector<double> masses;
  std::map<std::pair<std::size_t, std::string_view>, Setting> settings;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    const xml::Attribute* reference = gazebo.attribute("reference");
    if (gazebo.name() != "gazebo" || reference == nullptr) continue;
    const auto link = model.link_names.find(reference->value());
    if (!link) continue;
    for (const xml::View child : gazebo) {
      const std::string_view effect = effect_of(child);
      if (effect.empty()) continue;
      if (bodies.empty()) {
        bodies = bodies_of_sdformat(model);
        masses = merged_masses(model);
      }
      Setting& setting = settings[{bodies[*link], effect}];
      // With nothing else in the body, the setting is about all of it.
      if (bodies[*link] == *link || masses[*link] == masses[bodies[*link]]) {
        setting.is_of_body = true;
      } else if (setting.count++ == 0) {
        setting.first = child;
        setting.link = *link;
      }
    }
  }
  for (const auto& [key, setting] : settings) {
    if (setting.is_of_body || setting.count == 0) continue;
    const urdf::Link& body = model.robot->links[key.first];
    Diagnostic& diagnostic = findings.report(setting.first.name_span(),
                                             quoted(setting.first.name()) + " of " +
                                                 title(model.robot->links[setting.link]) + " " +
                                                 std::string(key.second) + " for " + title(body));
    diagnostic.note("Gazebo merges the link into " + title(body) +
                    " with everything that is fixed to it");
    if (setting.count > 1) {
      diagnostic.note(
          counted(setting.count - 1, "more link of this body has", "more links of this body have") +
          " the same setting");
    }
    diagnostic.help("delete the setting, or keep the link apart with `preserveFixedJoint`");
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::changes, "applies the setting to all links that are fixed together",
     kRun},
};

}  // namespace

extern constinit const Rule sml1455_setting_of_merged_link{
    .id = "SML1455",
    .name = "setting-of-merged-link",
    .severity = Severity::warning,
    .summary = "A Gazebo setting of a link applies to the whole body that the link is fixed to.",
    .why =
        "The conversion to SDF merges links that fixed joints connect. Without gravity for a sensor, the whole robot floats.",
    .remedy =
        "Delete the setting, or write `preserveFixedJoint` in a `gazebo` element that refers to the fixed joint.",
    .sources = "LMS1xx issue 66, husky issue 99.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1455_setting_of_merged_link_file
