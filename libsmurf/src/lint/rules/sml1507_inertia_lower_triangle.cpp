// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "base/numbers/numbers.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1507_inertia_lower_triangle_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  constexpr std::pair<std::string_view, std::string_view> kMirrored[] = {
      {"iyx", "ixy"}, {"izx", "ixz"}, {"izy", "iyz"}};
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const xml::View inertia =
        xml::View(model.robot->document, link.inertial->element).child("inertia");
    if (!inertia) return;
    if (is_written(*link.inertial) && inertia.element().attribute_count == 6) return;
    Diagnostic* harmless = nullptr;  // one finding for those that only repeat another entry
    for (const auto& [lower, upper] : kMirrored) {
      const xml::Attribute* below = inertia.attribute(lower);
      const xml::Attribute* above = inertia.attribute(upper);
      if (below == nullptr || above == nullptr) continue;  // that the other is missing is reported
      const bool is_equal = parse_number(below->value()) == parse_number(above->value());
      if (is_equal && harmless != nullptr) {
        harmless->fixes.front().edits.push_back({below->span(), ""});
        harmless->help("delete it and the others below the diagonal, which repeat entries above");
        continue;
      }
      Diagnostic& diagnostic =
          findings.report(below->name_span(),
                          "readers ignore " + quoted(lower) + " in the inertia of " + title(link));
      if (!is_equal) {
        diagnostic.label(above->value_span(), "and read another value here");
        continue;
      }
      harmless = &diagnostic;
      diagnostic.severity = Severity::info;
      diagnostic.help("delete it; " + quoted(upper) + " has the same value");
      diagnostic.fixes.push_back({Applicability::safe, {{below->span(), ""}}});
    }
  });
}

}  // namespace

extern constinit const Rule sml1507_inertia_lower_triangle{
    .id = "SML1507",
    .name = "inertia-lower-triangle",
    .severity = Severity::warning,
    .summary = "An inertia contains an entry below the diagonal.",
    .why = "A tensor is symmetric and URDF has six entries: `iyx`, `izx` and `izy` are ignored by "
           "every reader.",
    .remedy = "Delete it; the value belongs to `ixy`, `ixz` or `iyz`.",
    .sources = "urdfdom, MuJoCo and Bullet, executed; 44 uses in 941 public files.",
    .check_model = check,
    .about = About::format};

}  // namespace smurf::rules::sml1507_inertia_lower_triangle_file
