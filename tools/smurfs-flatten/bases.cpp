// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/bases.hpp"

#include <cstdio>

#include "base/quoted.hpp"
#include "base/rules.hpp"

namespace smurf::tools {
namespace {

/// "0.420 m".
std::string length_text(double length) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f m", length);
  return text;
}

/// A model file that was given instead of a scene.
bool is_single_model(const LinkedScene& scene) {
  const SceneFile& file = scene.scenes.front();
  return scene.instances.size() == 1 && !file.document && !file.drawing;
}

}  // namespace

Bases::~Bases() {
  for (const std::size_t i : anchored_) {
    scene_.instances[i].placement.anchor.kind = Attachment::Kind::none;
  }
  if (lift_ > 0) scene_.instances.front().X_WE->position[2] -= lift_;
}

void Bases::stand_on_floor(FlatScene& flat, const SceneExport& written) {
  for (const BelowFloor& model : below_floor(written)) {
    FlatInstance& instance = flat.instances[model.instance];
    const Span place = place_of(scene_.entity(scene_.instances[model.instance]));
    const std::string depth = length_text(model.depth);
    if (is_single_model(scene_) && instance.anchor.kind == Attachment::Kind::none) {
      lift_ = model.depth;
      instance.X_WE->position[2] += lift_;
      scene_.instances.front().X_WE->position[2] += lift_;
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

}  // namespace smurf::tools
