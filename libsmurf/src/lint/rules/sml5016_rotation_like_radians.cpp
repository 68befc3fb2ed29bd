// SPDX-License-Identifier: BSD-3-Clause
#include "base/findings/readers.hpp"
#include "base/numbers/numbers.hpp"
#include "lint/angle_queries.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5016_rotation_like_radians_file {
namespace {

/// The numbers of a rotation as they are written.
std::vector<yaml::View> numbers_of(yaml::View rotation) {
  std::vector<yaml::View> numbers;
  if (!rotation.is_sequence()) return {rotation};
  for (const yaml::View number : rotation) numbers.push_back(number);
  return numbers;
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    const RotationForm form = entity.rotation.form;
    if (form != RotationForm::yaw && form != RotationForm::euler) return;
    if (file.drawing && entity.rotation.span.source == file.source) return;  // not written, drawn
    std::vector<Edit> edits;
    for (const yaml::View number : numbers_of(mapping_of(file, entity).find("rotation"))) {
      const double value = *number.number();
      if (value == 0) continue;
      const std::optional<double> degrees = degrees_of_radians(value);
      if (!degrees) return;
      edits.push_back({number.span(), format_number(*degrees)});
    }
    if (edits.empty()) return;
    Diagnostic& diagnostic = findings.report(
        edits.size() == 1 ? edits.front().span : entity.rotation.span,
        title(entity) + " is turned by so few degrees that radians seem to be meant");
    diagnostic.help("in degrees:");
    for (const Edit& edit : edits) {
      diagnostic.help_text += (&edit == &edits.front() ? " " : ", ") + edit.text;
    }
    diagnostic.fixes.push_back({Applicability::unsafe, std::move(edits)});
  });
}

constexpr Fact kFacts[] = {
    {&readers::mars, Effect::changes, "reads degrees", "MARS mathUtils.cpp:133-152"},
    {&readers::mars2, Effect::changes, "reads degrees", "MarsSceneLoader.cpp"},
    {&readers::phobos, Effect::takes, "reads and writes radians",
     "Phobos representation.py (Pose.rotation)"},
};

}  // namespace

extern constinit const Rule sml5016_rotation_like_radians{
    .id = "SML5016",
    .name = "rotation-like-radians",
    .severity = Severity::warning,
    .summary = "The angles of a rotation are fractions of pi, but scenes take degrees.",
    .why = "1.5708 is read as one and a half degrees. URDF uses radians, scenes use degrees.",
    .remedy = "Write degrees: 90 instead of 1.5708.",
    .check_scene = check,
    .facts = kFacts,
    .about = About::robot};

}  // namespace smurf::rules::sml5016_rotation_like_radians_file
