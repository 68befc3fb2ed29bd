// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <vector>

#include "base/findings/readers.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1122_prefixed_attribute_file {
namespace {

/// What Isaac's converter knows in elements whose attributes it keeps. It keeps those of all other
/// elements in them, too.
struct Kept {
  std::string_view element;
  std::vector<std::string_view> known;  ///< children whose attributes it does not keep
};
const Kept kKept[] = {
    {"robot", {}},
    {"material", {"color", "texture"}},
    {"link", {"inertial"}},
    {"visual", {"origin", "geometry", "material"}},
    {"collision", {"origin", "geometry", "verbose"}},
    {"joint",
     {"origin", "parent", "child", "axis", "calibration", "dynamics", "limit", "mimic",
      "safety_controller"}},
};

void check_attributes(xml::View element, Findings& findings) {
  for (const xml::Attribute& attribute : element.attributes()) {
    const std::string_view name = attribute.name();
    if (name.find(':') == name.npos || name.starts_with("xmlns:")) continue;
    findings
        .report(attribute.name_span(),
                "the attribute " + quoted(name) + " of " + quoted(element.name()) + " has a prefix")
        .when(kPrefixed)
        .help("delete it, or write it without a prefix");
  }
}

/// The depth of the document is bounded by Limits::xml_depth.
void check_element(xml::View element, const Kept* kept, Findings& findings) {
  check_attributes(element, findings);
  for (const xml::View child : element) {
    if (kept == nullptr) {
      check_element(child, nullptr, findings);
      continue;
    }
    const auto& known = kept->known;
    if (std::find(known.begin(), known.end(), child.name()) != known.end()) continue;
    const auto inner = std::find_if(std::begin(kKept), std::end(kKept),
                                    [&](const Kept& one) { return one.element == child.name(); });
    check_element(child, inner == std::end(kKept) ? nullptr : inner, findings);
  }
}

void check(const LinkedModel& model, Findings& findings) {
  if (model.robot) check_element(model.robot->document.view(), &kKept[0], findings);
}

constexpr Fact kFacts[] = {
    {&readers::isaac, Effect::refuses, "cannot keep an attribute of that name in USD", kRun},
};

}  // namespace

extern constinit const Rule sml1122_prefixed_attribute{
    .id = "SML1122",
    .name = "prefixed-attribute",
    .severity = Severity::error,
    .summary = "An attribute of another vocabulary has a prefix, which a target cannot keep.",
    .remedy = "Delete it, or write it without a prefix.",
    .check_model = check,
    .needs_target = true,
    .facts = kFacts};

}  // namespace smurf::rules::sml1122_prefixed_attribute_file
