// SPDX-License-Identifier: BSD-3-Clause
#include <optional>
#include <string>
#include <utility>

#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/findings/uncertain.hpp"
#include "base/ranges.hpp"
#include "lint/queries.hpp"
#include "lint/sdf_scope.hpp"
#include "readers/sdf_values.hpp"

namespace smurf::rules::sml1447_gazebo_value_file {
namespace {

constexpr Circumstance kNumber{"number"};
constexpr Circumstance kSlip{"slip"};

constexpr std::string_view kWhole = "maxContacts";
/// Elements that sdformat reads with std::stod (kWhole: std::stoi), which throws.
constexpr std::string_view kNumbers[] = {"mu1",
                                         "mu2",
                                         "kp",
                                         "kd",
                                         "minDepth",
                                         "maxVel",
                                         "dampingFactor",
                                         "stopCfm",
                                         "stopErp",
                                         "springStiffness",
                                         "springReference",
                                         "fudgeFactor",
                                         "laserRetro",
                                         kWhole};
Diagnostic& report(const xml::View element, std::string_view wanted, Findings& findings) {
  const xml::Attribute* value = element.attribute("value");
  const Span place = value != nullptr ? value->span() : element.text_span();
  const bool is_empty = place.empty();
  return sdf::report_unreadable(is_empty ? element.name_span() : place, element.name(), is_empty,
                                wanted, [&](Span at, std::string message) -> Diagnostic& {
                                  return findings.report(at, std::move(message));
                                });
}

/// A value that sdformat translates, wherever the element belongs.
void check_value(const xml::View element, const urdf::Link* link, Findings& findings) {
  const std::string_view name = element.name();
  const std::string_view text = sdf::given_value(element);
  const bool has_collisions = link != nullptr && !link->collisions.empty();
  if (ranges::contains(kNumbers, name)) {
    const auto number = sdf::leading_number(text);
    const bool is_read =
        name == kWhole ? sdf::leading_integer(text, 10).has_value() : number.has_value();
    if (!is_read) {
      report(element, name == kWhole ? "an integer" : "a number", findings).when(kNumber);
      return;
    }
    const bool is_friction = name.starts_with("mu");
    if (is_friction && has_collisions && *number < 0) {
      report(element, "a number of at least 0", findings);
    }
  } else if (name == "fdir1" && has_collisions && !sdf::trimmed_text(text).empty()) {
    if (!sdf::read_vector(text)) report(element, "three numbers", findings);
  }
}

/// Whether sdformat has such an element in a link or joint.
bool is_of_sdf(std::string_view name) {
  return sdf::find_part(sdf::find("link")->children, name) ||
         sdf::find_part(sdf::find("joint")->children, name);
}

/// Elements of old versions of Gazebo, which are no slips of others.
bool is_of_old_gazebo(std::string_view name) { return name == "stopKp" || name == "stopKd"; }

/// sdformat copies an element that it does not know, and then warns of it.
void check_name(const xml::View element, Findings& findings) {
  const std::string_view name = element.name();
  if (sdf::is_translated(name) || is_of_sdf(name) || is_of_old_gazebo(name)) return;
  const auto meant = sdf::meant_translated(name);
  if (!meant) return;
  Diagnostic& diagnostic =
      findings.report(element.name_span(), "Gazebo knows no element " + quoted(name));
  diagnostic.when(kSlip);
  diagnostic.help("did you mean " + quoted(*meant) + "?");
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  bool has_extensions = false;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View gazebo(model.robot->document, id);
    if (gazebo.name() != "gazebo") continue;
    has_extensions = true;
    const xml::Attribute* reference = gazebo.attribute("reference");
    const auto link =
        reference == nullptr ? std::nullopt : model.link_names.find(reference->value());
    for (const xml::View element : gazebo) {
      if (reference != nullptr) check_name(element, findings);
      check_value(element, link ? &model.robot->links[*link] : nullptr, findings);
    }
  }
  if (!has_extensions) return;
  sdf::check_extensions(model, [&](Span place, std::string message) -> Diagnostic& {
    return findings.report(place, std::move(message));
  });
}

constexpr Fact kFacts[] = {
    {&readers::gazebo, Effect::crashes, "ends the process with an exception", kRun, when(kNumber)},
    {&readers::gazebo, Effect::crashes, "ends the process with an exception", kRun,
     when(sdf::kEmptyInclude)},
    {&readers::gazebo, Effect::loses, "warns, and leaves out what the element means", kRun,
     when(kSlip)},
    {&readers::gazebo, Effect::refuses,
     "refuses the file unless it finds such a model in its own paths", kRun, when(kUncertain)},
    {&readers::gazebo, Effect::changes, "joins the link with another, and writes a pose of its own",
     kRun, when(sdf::kMovedPose)},
    {&readers::gazebo, Effect::refuses, "refuses the file", kRun},
};

}  // namespace

extern constinit const Rule sml1447_gazebo_value{
    .id = "SML1447",
    .name = "gazebo-value",
    .severity = Severity::warning,
    .summary =
        "An element for Gazebo is misspelt, lacks a part, or contains one that Gazebo cannot "
        "read.",
    .why =
        "An empty `mu1`, or a word in `dampingFactor`, ends the simulator. Other elements are read as SDF, which does not tolerate wrong types, values or names.",
    .remedy =
        "Write the element as the specification of SDF says; give a second part of a kind another name.",
    .check_model = check,
    .facts = kFacts,
    .taken_over = TakenOver::from_sdf};

}  // namespace smurf::rules::sml1447_gazebo_value_file
