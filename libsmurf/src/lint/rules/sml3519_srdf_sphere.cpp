// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstddef>
#include <string>

#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "base/text/words.hpp"
#include "lint/companions/srdf_queries.hpp"

namespace smurf::rules::sml3519_srdf_sphere_file {
namespace {

/// Reports a text that is not this many numbers. srdfdom reads a radius with nothing around it, and
/// ignores what follows the three numbers of a centre.
void check_numbers(xml::View sphere, std::string_view name, std::size_t wanted,
                   Findings& findings) {
  const xml::Attribute* attribute = sphere.attribute(name);
  if (attribute == nullptr) return;
  std::size_t count = 0;
  bool is_good = true;
  for (std::size_t at = 0; count < wanted; ++count) {
    const std::string_view word = next_word(attribute->value(), at);
    if (word.empty()) break;
    const auto value = parse_number(word);
    is_good = is_good && value && std::isfinite(*value);
  }
  const bool is_radius = wanted == 1;
  if (is_radius) is_good = is_good && trimmed(attribute->value()).find(' ') == std::string::npos;
  if (is_radius) is_good = is_good && !attribute->value().ends_with(' ');
  if (is_good && count == wanted) return;
  const bool has_value = !attribute->value_span().empty();
  findings
      .report(has_value ? attribute->value_span() : attribute->name_span(),
              quoted(name) + " of this sphere is " + quoted(attribute->value()))
      .help("write " + counted(wanted, "number") + " in m");
}

void check(const LinkedModel&, const Companions& companions, Findings& findings) {
  for_each_srdf(companions, [&](const srdf::Description& srdf) {
    for (const srdf::LinkEntry& link : srdf.links) {
      for (const xml::View sphere : xml::View(srdf.document, link.element)) {
        if (sphere.name() != "sphere") continue;
        check_numbers(sphere, "center", 3, findings);
        check_numbers(sphere, "radius", 1, findings);
      }
    }
  });
}

constexpr Fact kFacts[] = {
    {&readers::moveit, Effect::breaks, "reports an error and ignores the sphere",
     "srdfdom 2.0.7 model.cpp loadLinkSphereApproximations, run"},
};

}  // namespace

extern constinit const Rule sml3519_srdf_sphere{
    .id = "SML3519",
    .name = "srdf-sphere",
    .severity = Severity::error,
    .summary = "The centre or the radius of a sphere in an SRDF is not a number.",
    .why = "The sphere takes no part in the collision checks of the link.",
    .remedy = "Write three numbers as centre and one as radius, in m.",
    .check_companions = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml3519_srdf_sphere_file
