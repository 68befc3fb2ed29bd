// SPDX-License-Identifier: BSD-3-Clause
#include "ast/companions/srdf_reader.hpp"
#include "base/text/words.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3503_srdf_attribute_missing_file {
namespace {

/// Whether another rule is about the values of an attribute.
bool has_own_rule(std::string_view attribute) {
  return is_one_of(attribute, {"value", "type", "center", "radius"});
}

void check_element(xml::View parent, xml::View element, Findings& findings) {
  const std::string_view above = parent ? parent.name() : std::string_view();
  const srdf::ElementSpec* spec = srdf::find_element_spec(above, element.name());
  if (spec == nullptr) return;
  std::string missing;
  for (const std::string_view name : spec->required) {
    if (element.attribute(name) != nullptr) continue;
    missing += (missing.empty() ? " has no " : " and no ") + quoted(name);
  }
  if (!missing.empty()) {
    findings.report(element.name_span(), quoted(element.name()) + missing)
        .help("write the attribute, or delete the element");
  }
  for (const std::string_view name : spec->required) {
    const xml::Attribute* attribute = element.attribute(name);
    if (attribute == nullptr || !trimmed(attribute->value()).empty() || has_own_rule(name))
      continue;
    findings
        .report(attribute->name_span(),
                quoted(name) + " of " + quoted(element.name()) + " is empty")
        .help("write a value, or delete the element");
  }
  for (const xml::View child : element) check_element(element, child, findings);
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    const xml::View root = srdf.document.view();
    if (root) check_element({}, root, findings);
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and ignores the element",
     "srdfdom model.cpp"},
};

}  // namespace

extern constinit const Rule sml3503_srdf_attribute_missing{
    .id = "SML3503",
    .name = "srdf-attribute-missing",
    .severity = Severity::error,
    .summary = "An element of an SRDF lacks an attribute that it needs, or it is empty.",
    .remedy = "Write the attribute.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3503_srdf_attribute_missing_file
