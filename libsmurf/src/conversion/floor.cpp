// SPDX-License-Identifier: BSD-3-Clause
#include "conversion/floor.hpp"

#include <cmath>
#include <string>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"

namespace smurf {
namespace {

/// "0.42 m", to a millimetre.
std::string length_text(double length) {
  return format_number(std::round(length * 1000) / 1000) + " m";
}

/// A model file that was given instead of a scene.
bool is_single_model(const LinkedScene& scene) {
  const SceneFile& file = scene.scenes.front();
  return scene.instances.size() == 1 && !file.document && !file.drawing;
}

}  // namespace

void stand_on_floor(FlatScene& flat, const SceneExport& written) {
  for (const BelowFloor& model : below_floor(written)) {
    FlatInstance& instance = flat.instances[model.instance];
    const Span place = place_of(*instance.entity);
    const std::string depth = length_text(model.depth);
    if (is_single_model(written.scene) && instance.anchor.kind == Attachment::Kind::none) {
      instance.X_WE->position[2] += model.depth;
      written.losses.report(rules::sml8212_chosen_value, place,
                            quoted(instance.path) + " is " + depth +
                                " above its own frame, so that it stands on the floor");
      continue;
    }
    written.losses
        .report(rules::sml8211_lost_part, place,
                quoted(instance.path) + " starts " + depth + " below the floor")
        .help(
            "simulators push it out, and may throw it; raise the entity by that much, or choose a "
            "joint pose that fits");
  }
}

}  // namespace smurf
