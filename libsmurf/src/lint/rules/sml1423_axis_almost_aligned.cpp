// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>

#include "base/findings/readers.hpp"
#include "base/numbers/exact_math.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1423_axis_almost_aligned_file {
namespace {

void check(const LinkedModel& model, Findings& findings) {
  const double noise = findings.tolerance();  // real tilts are larger
  for_each_joint(model, [&](const urdf::Joint& joint) {
    if (!joint.axis || !joint.has_one_axis()) return;
    const Vector3& axis = *joint.axis;
    const double length = hypotenuse(axis[0], axis[1], axis[2]);
    if (std::fabs(length - 1) > noise) return;  // a separate rule
    std::string aligned;
    bool is_exact = true, is_near = true;
    for (const double component : axis) {
      const double rounded = std::round(component);
      is_exact = is_exact && component == rounded;
      // 0.9999995 is a rounded 1; a tilt shows in the other components.
      is_near = is_near && std::fabs(component - rounded) < noise;
      aligned += (aligned.empty() ? "" : " ") + format_number(rounded);
    }
    if (is_exact || !is_near) return;
    Diagnostic& diagnostic =
        findings.report(joint.axis.span, "the axis of " + title(joint) + " is " + quoted(aligned) +
                                             " up to rounding errors");
    diagnostic.help("write " + quoted(aligned));
    diagnostic.fixes.push_back({Applicability::unsafe, {{joint.axis.span, aligned}}});
  });
}

constexpr Fact kFacts[] = {
    {&readers::pinocchio, Effect::takes, "uses a joint model for any axis, which is slower",
     "Pinocchio model.hxx:564-573, run"},
};

}  // namespace

extern constinit const Rule sml1423_axis_almost_aligned{
    .id = "SML1423",
    .name = "axis-almost-aligned",
    .severity = Severity::info,
    .summary = "The axis of a joint is a coordinate axis up to rounding errors.",
    .why = "CAD exporters leave such rounding errors. Every reader tilts the joint by them.",
    .remedy = "Write the coordinate axis, e.g. `0 0 1`.",
    .check_model = check,
    .tolerance = {.value = 1e-3,
                  .meaning =
                      "the largest component of an axis that is treated as a rounding error"},
    .facts = kFacts};

}  // namespace smurf::rules::sml1423_axis_almost_aligned_file
