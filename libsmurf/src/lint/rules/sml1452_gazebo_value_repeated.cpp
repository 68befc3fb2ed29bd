// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <string_view>
#include <utility>

#include "base/findings/readers.hpp"
#include "base/ranges.hpp"
#include "base/text/words.hpp"
#include "lint/queries.hpp"
#include "readers/sdf_values.hpp"

namespace smurf::rules::sml1452_gazebo_value_repeated_file {
namespace {

/// Elements of which sdformat keeps the last one; each was run in both orders.
constexpr std::string_view kSingle[] = {"mu1",
                                        "mu2",
                                        "kp",
                                        "kd",
                                        "minDepth",
                                        "maxVel",
                                        "maxContacts",
                                        "laserRetro",
                                        "fdir1",
                                        "static",
                                        "selfCollide",
                                        "turnGravityOff",
                                        "material",
                                        "stopCfm",
                                        "stopErp",
                                        "springStiffness",
                                        "springReference"};

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::map<std::pair<std::string_view, std::string_view>, xml::View> last;  // by reference and name
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    const xml::Attribute* reference = gazebo.attribute("reference");
    const std::string_view about = reference != nullptr ? reference->value() : std::string_view();
    for (const xml::View element : gazebo) {
      if (!ranges::contains(kSingle, element.name())) continue;
      const auto [first, is_new] = last.try_emplace({about, element.name()}, element);
      if (is_new) continue;
      const xml::View before = std::exchange(first->second, element);
      if (trimmed(sdf::given_value(before)) == trimmed(sdf::given_value(element))) continue;
      findings.report(before.name_span(), quoted(element.name()) + " is set to another value below")
          .label(element.name_span(), "Gazebo uses this one");
    }
  }
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::changes, "uses the last one", kRun},
};

}  // namespace

extern constinit const Rule sml1452_gazebo_value_repeated{
    .id = "SML1452",
    .name = "gazebo-value-repeated",
    .severity = Severity::warning,
    .summary = "A value for Gazebo is set more than once for a link, a joint or the robot.",
    .why = "Whoever changes the first one sees no effect.",
    .remedy = "Delete all but one of them.",
    .check_model = check,
    .facts = kFacts,
    .about = About::format};

}  // namespace smurf::rules::sml1452_gazebo_value_repeated_file
