// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "ast/urdf_numbers.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/words.hpp"
#include "link/inertia.hpp"
#include "lint/queries.hpp"
#include "readers/circumstances.hpp"

namespace smurf::rules::sml1515_inertia_below_mujoco_file {
namespace {

constexpr double kSmallest = 1e-14;  // kg m^2, mjEPS

/// The places of the hexadecimal entries, which MuJoCo alone reads, and the tensor it makes of
/// them.
struct HexadecimalInertia {
  urdf::Inertial inertial;
  std::vector<Span> places;

  HexadecimalInertia(const LinkedModel& model, const urdf::Inertial& written) {
    const xml::View inertia = xml::View(model.robot->document, written.element).child("inertia");
    if (!inertia) return;
    for (const auto& [spec, member] : urdf::kInertia) {
      const auto entry = std::get<Field<double> urdf::Inertial::*>(member);
      inertial.*entry = written.*entry;
      const xml::Attribute* attribute = inertia.attribute(spec.name);
      if (attribute == nullptr || written.*entry) continue;
      if (const auto value = parse_hexadecimal(trimmed(attribute->value())))
        add(*attribute, *value, inertial.*entry);
    }
  }

 private:
  void add(const xml::Attribute& attribute, double value, Field<double>& entry) {
    entry.set(value);
    Span place = attribute.value_span();
    const std::size_t blanks = attribute.value().find_first_not_of(kBlanks);
    place.begin += static_cast<std::uint32_t>(blanks);
    place.end = place.begin + static_cast<std::uint32_t>(trimmed(attribute.value()).size());
    places.push_back(place);
  }
};

/// MuJoCo refuses them because they are hexadecimal.
void check_hexadecimal(const LinkedModel& model, const urdf::Inertial& written,
                       Findings& findings) {
  const HexadecimalInertia read(model, written);
  if (read.places.empty()) return;
  const auto moments = principal_moments(read.inertial);
  const bool is_taken =
      moments && (*moments)[0] >= kSmallest && (*moments)[0] + (*moments)[1] >= (*moments)[2];
  if (!is_taken) findings.add_consequence(read.places.front());
}

void check(const LinkedModel& model, Findings& findings) {
  constexpr double kMassReported = 1e-6;  // kg; such a mass is reported instead
  for_each_link(model, [&](const urdf::Link& link) {
    if (!link.inertial) return;
    const auto moments = principal_moments(*link.inertial);
    if (!moments) return check_hexadecimal(model, *link.inertial, findings);
    if (link.inertial->mass.value_or(0) <= kMassReported) return;
    if (!is_positive_definite(*moments) || (*moments)[0] >= kSmallest) return;
    if (triangle_excess(*moments) > kImpossibleExcess) return;  // SML1513
    findings
        .report(inertia_place(model, *link.inertial),
                "the smallest moment of inertia of " + title(link) + " is " +
                    format_rounded((*moments)[0], 3) + " kg m2")
        .note("MuJoCo refuses less than 1e-14");
  });
}

constexpr Fact kFacts[] = {
    {&readers::mujoco, Effect::refuses,
     "reads a hexadecimal number, and refuses the inertia that it makes", kRun, when(cases::kHex)},
    {&readers::mujoco, Effect::takes, "looks at the whole body that moves", "3.1.2, run",
     before({3, 1, 3}).unless(kAlone)},
    {&readers::mujoco, Effect::refuses, "refuses a principal moment below 1e-14 kg m2",
     "MuJoCo user_util.cc:862, run"},
};

}  // namespace

extern constinit const Rule sml1515_inertia_below_mujoco{
    .id = "SML1515",
    .name = "inertia-below-mujoco",
    .severity = Severity::warning,
    .summary = "A moment of inertia is smaller than MuJoCo accepts.",
    .why = "Hexadecimal entries are judged by their value.",
    .remedy = "Write the real inertia, or remove the inertial of a link that is only a frame.",
    .sources = "176 inertials of the Tola/Corke dataset.",
    .check_model = check,
    .facts = kFacts};

}  // namespace smurf::rules::sml1515_inertia_below_mujoco_file
