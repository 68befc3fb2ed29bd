// SPDX-License-Identifier: BSD-3-Clause
#include "base/files/path.hpp"
#include "base/findings/readers.hpp"
#include "base/text/suggest.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "readers/rigid_bodies.hpp"

namespace smurf::rules::sml1506_inertia_attribute_missing_file {
namespace {

constexpr Circumstance kOnlyProducts{"only products"};

/// The place of a misspelt `name`, which is reported there; empty when there is none.
Span find_misspelt(const xml::View element, std::string_view name) {
  const std::string_view known[] = {name};
  for (const xml::Attribute& at : element.attributes()) {
    const bool is_other_entry = at.name().size() == 3 && at.name().starts_with('i');
    if (!is_other_entry && (nearest(at.name(), known) || path::to_lower(at.name()) == name))
      return at.name_span();
  }
  return {};
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || is_written(*link.inertial)) return;
    const xml::View inertia =
        xml::View(model.robot->document, link.inertial->element).child("inertia");
    if (!inertia) return;
    std::string missing, zeros;
    bool is_diagonal_whole = true;
    for (const std::string_view name : urdf::kInertiaEntries) {
      if (inertia.attribute(name) != nullptr) continue;
      if (const Span slip = find_misspelt(inertia, name); !slip.empty()) {
        findings.add_consequence(slip);
        continue;
      }
      missing += (missing.empty() ? "" : " or ") + quoted(name);
      zeros += " " + std::string(name) + "=\"0\"";
      is_diagonal_whole = is_diagonal_whole && name[1] != name[2];
    }
    if (missing.empty()) return;
    Diagnostic& diagnostic = findings.report(inertia.name_span(), "the inertia of " + title(link) +
                                                                      " has no " + missing);
    diagnostic.note("urdfdom reads all six as 0 and drops the visuals and collisions of this link");
    if (!is_diagonal_whole) return;
    diagnostic.when(kOnlyProducts);
    diagnostic.help("write 0 where there is no product of inertia");
    const std::uint32_t end = inertia.attributes().back().span().end;
    diagnostic.fixes.push_back({Applicability::safe, {{{inertia.span().source, end, end}, zeros}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::pybullet, Effect::takes, "reads 0 for absent products", kRun, when(kOnlyProducts)},
    {&readers::pybullet, Effect::refuses, "refuses the whole robot", kRun},
    {&readers::drake, Effect::changes, "reads 0", kRun},
    {&readers::urdfdom, Effect::breaks,
     "reads all six as 0, reports an error and drops the visuals and collisions of the link",
     "urdfdom link.cpp:415-486, run"},
    kGazeboAddsZeros,
    {&readers::mujoco, Effect::refuses, "refuses the file", kRun},
    {&readers::phobos, Effect::changes, "reads 0", kRun},
};

}  // namespace

extern constinit const Rule sml1506_inertia_attribute_missing{
    .id = "SML1506",
    .name = "inertia-attribute-missing",
    .severity = Severity::error,
    .summary = "An inertia lacks some of its six entries.",
    .why = "yourdfpy puts 1.0 on the diagonal.",
    .remedy = "Write all six; products of inertia that vanish are 0.",
    .sources = "yourdfpy urdf.py:1875.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1506_inertia_attribute_missing_file
