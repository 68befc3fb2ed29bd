// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/queries.hpp"

namespace smurf::rules::sml1439_rpy_truncated_file {
namespace {

/// One finding per file, with one fix for all angles, because authors round all of them alike.
void check(const LinkedModel& model, Findings& findings) {
  if (!model.robot) return;
  std::vector<Edit> edits;
  for_each_turn(*model.robot, [&](const xml::Attribute& rpy) {
    const std::vector<WrittenNumber> angles = written_numbers(rpy);
    if (angles.size() != 3) return;
    for (const WrittenNumber& angle : angles) {
      const auto intended = intended_right_angle(angle);
      if (intended) edits.push_back({angle.span, format_number(*intended)});
    }
  });
  if (edits.empty()) return;
  Diagnostic& diagnostic = findings.report(
      edits.front().span, "this right angle is rounded; the exact value is " + edits.front().text);
  if (edits.size() > 1) {
    diagnostic.note(std::to_string(edits.size() - 1) + " more in this file");
  }
  diagnostic.help("write all digits");
  diagnostic.fixes.push_back({Applicability::unsafe, std::move(edits)});
}

}  // namespace

extern constinit const Rule sml1439_rpy_truncated{
    .id = "SML1439",
    .name = "rpy-truncated",
    .severity = Severity::info,
    .summary = "Right angles are rounded to few digits.",
    .why = "`1.57` is 0.0008 rad short of a right angle: 0.8 mm at the end of a metre, and frames "
           "that should be parallel are not.",
    .remedy =
        "Write the angle with all digits: 1.5707963267948966 for pi/2, 3.141592653589793 for pi.",
    .sources = "97 of 322 files of the Tola/Corke dataset.",
    .check_model = check};

}  // namespace smurf::rules::sml1439_rpy_truncated_file
