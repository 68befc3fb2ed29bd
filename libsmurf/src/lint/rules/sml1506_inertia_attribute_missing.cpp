// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/suggest.hpp"
#include "lint/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules {
namespace {

/// True when an attribute is a misspelt `name`, which is then reported as such.
bool is_misspelt(const xml::View element, std::string_view name) {
  return std::any_of(element.attributes_begin(), element.attributes_end(),
                     [&](const xml::Attribute& attribute) {
                       if (attribute.name().size() == 3 && attribute.name().starts_with('i')) {
                         return false;  // another entry
                       }
                       const std::string_view known[] = {name};
                       return nearest(attribute.name(), known).has_value();
                     });
}

void check(const LinkedModel& model, Findings& findings) {
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial || is_written(*link.inertial)) return;
    const xml::View inertia =
        xml::View(model.robot->document, link.inertial->element).child("inertia");
    if (!inertia) return;
    std::string missing, zeros;
    bool is_diagonal_whole = true;
    for (const std::string_view name : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
      if (inertia.attribute(name) != nullptr || is_misspelt(inertia, name)) continue;
      missing += (missing.empty() ? "" : " and no ") + quoted(name);
      zeros += " " + std::string(name) + "=\"0\"";
      is_diagonal_whole = is_diagonal_whole && name[1] != name[2];
    }
    if (missing.empty()) return;
    Diagnostic& diagnostic = findings.report(inertia.name_span(), "the inertia of " + title(link) +
                                                                      " has no " + missing);
    diagnostic.notes.push_back(
        "urdfdom takes all six for 0 and drops the visuals and collisions of this link");
    if (!is_diagonal_whole) return;
    diagnostic.help = "write 0 where there is no product of inertia";
    const std::uint32_t end = (inertia.attributes_end() - 1)->span().end;
    diagnostic.fixes.push_back({Applicability::safe, {{{inertia.span().source, end, end}, zeros}}});
  });
}

}  // namespace

extern constinit const Rule sml1506_inertia_attribute_missing{
    .id = "SML1506",
    .name = "inertia-attribute-missing",
    .severity = Severity::error,
    .summary = "An inertia lacks some of its six entries.",
    .why = "urdfdom takes all six for 0 and drops the visuals and collisions of the link, while "
           "the file \"loads\"; yourdfpy puts 1.0 on the diagonal; Bullet takes the three others "
           "for 0 where a product is missing.",
    .remedy = "Write all six; products of inertia that vanish are 0.",
    .sources = "urdfdom 3.0.1 link.cpp:415-486 and Bullet, executed; yourdfpy urdf.py:1875.",
    .check_model = check};

}  // namespace smurf::rules
