// SPDX-License-Identifier: BSD-3-Clause
#include <set>
#include <unordered_map>

#include "base/findings/readers.hpp"
#include "base/text/edits.hpp"
#include "lint/annotation_queries.hpp"

namespace smurf::rules::sml3220_shape_on_other_link_file {
namespace {

/// Names of the shapes of links, collected once per link.
template <class ShapesOf>
class ShapeNames {
 public:
  explicit ShapeNames(const ShapesOf& shapes_of) : shapes_of_(shapes_of) {}

  bool has(const urdf::Link& link, std::string_view name) {
    const auto [known, is_new] = names_.try_emplace(&link);
    if (is_new) {
      for (const auto& shape : shapes_of_(link)) {
        if (shape.name) known->second.insert(*shape.name);
      }
    }
    return known->second.contains(name);
  }

 private:
  const ShapesOf& shapes_of_;
  std::unordered_map<const urdf::Link*, std::set<std::string_view>> names_;
};

template <class Entries, class ShapesOf>
void check_entries(const LinkedModel& model, const Entries& entries, NameKind kind,
                   const ShapesOf& shapes_of, Findings& findings) {
  ShapeNames shapes(shapes_of);
  for (const auto& entry : entries) {
    if (!entry.name || !entry.link) continue;
    const auto owner = names(model, kind).find(*entry.name);
    const urdf::Link* link = model.find_link(*entry.link);
    if (!owner || link == nullptr) continue;
    const urdf::Link& other = model.robot->links[*owner];
    if (&other == link || !other.name || shapes.has(*link, *entry.name)) continue;
    const std::string shape(to_string(kind));
    Diagnostic& diagnostic = findings.report(
        entry.link.span, "the " + shape + " " + quoted(*entry.name) + " belongs to " +
                             title(other) + ", not to " + quoted(*entry.link));
    diagnostic.label(definition(model, kind, *entry.name), "the " + shape);
    if (fits_everywhere(*other.name)) {
      diagnostic.fixes.push_back(
          {Applicability::unsafe, {{within_quotes(model, entry.link.span), *other.name}}});
    }
    diagnostic.help("did you mean " + quoted(*other.name) + "?");
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  check_entries(
      model, model.annotations.collisions, NameKind::collision,
      [](const urdf::Link& link) -> const auto& { return link.collisions; }, findings);
  check_entries(
      model, model.annotations.visuals, NameKind::visual,
      [](const urdf::Link& link) -> const auto& { return link.visuals; }, findings);
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::takes, "matches by name alone", "MARS smurf.cpp:404-449"},
    {&readers::mars2, Effect::loses,
     "matches by name and link, and finds nothing: the bitmask and contact parameters have no effect",
     "envire_smurf_loader Model.cpp"},
    {&readers::envire, Effect::loses,
     "matches by name and link, and finds nothing: the bitmask and contact parameters have no effect",
     "rock-cpp/smurf Robot.cpp:53-83"},
};

}  // namespace

extern constinit const Rule sml3220_shape_on_other_link{
    .id = "SML3220",
    .name = "shape-on-other-link",
    .severity = Severity::error,
    .summary =
        "A collision or visual entry names a link that does not have this collision or visual.",
    .remedy = "Correct `link`.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3220_shape_on_other_link_file
