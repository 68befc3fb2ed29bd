// SPDX-License-Identifier: BSD-3-Clause
// Loads an MJCF with libmujoco, runs 1000 steps, and prints the group of every geom and, for every
// actuator, the distance of its joint from the start after 0.3 s: with the command of the keyframe,
// and with one between that and the largest. Ends with 1 if the world is not loaded or becomes
// unstable.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "mujoco_world.hpp"

namespace {

/// How far the joint of an actuator moves in 0.3 s.
double travel(const mjModel* model, mjData* data, int actuator, double command) {
  mj_resetDataKeyframe(model, data, 0);
  data->ctrl[actuator] = command;
  const int at = model->jnt_qposadr[model->actuator_trnid[2 * actuator]];
  const mjtNum start = data->qpos[at];
  const int steps = static_cast<int>(std::lround(0.3 / model->opt.timestep));
  for (int step = 0; step < steps; ++step) mj_step(model, data);
  return data->qpos[at] - start;
}

bool is_stable(const mjData& data) {
  return data.warning[mjWARN_BADQPOS].number == 0 && data.warning[mjWARN_BADQVEL].number == 0 &&
         data.warning[mjWARN_BADQACC].number == 0;
}

/// With the commands of the keyframe. If positions are not finite, MuJoCo restarts and counts a
/// warning.
void stand(const mjModel* model, mjData* data) {
  if (model->nkey > 0) mj_resetDataKeyframe(model, data, 0);
  for (int step = 0; step < 1000; ++step) mj_step(model, data);
  mjtNum fastest = 0;
  for (int i = 0; i < model->nv; ++i) fastest = std::max(fastest, std::abs(data->qvel[i]));
  std::printf("stand\t%.9g\t%d\n", fastest, is_stable(*data) ? 1 : 0);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const smurf::tests::MujocoWorld world = smurf::tests::load_mujoco(argv[1]);
  mjModel* model = world.model.get();
  mjData* data = world.data.get();
  if (model == nullptr || model->nkey == 0) return 1;
  for (int i = 0; i < model->ngeom; ++i) {
    const char* name = mj_id2name(model, mjOBJ_GEOM, i);
    std::printf("geom\t%s\t%d\t%d\t%g\n", name != nullptr ? name : "", model->geom_group[i],
                model->geom_contype[i], model->geom_friction[3 * i]);
  }
  stand(model, data);
  bool has_stood = is_stable(*data);
  for (int i = 0; i < model->nu; ++i) {
    const mjtNum start = model->key_ctrl[i];
    const mjtNum most =
        model->actuator_ctrllimited[i] != 0 ? model->actuator_ctrlrange[2 * i + 1] : start + 1;
    const double still = travel(model, data, i, start);
    const double moved = travel(model, data, i, (start + most) / 2);
    std::printf("actuator\t%s\t%.9g\t%.9g\t%.9g\n", mj_id2name(model, mjOBJ_ACTUATOR, i), still,
                moved, model->actuator_forcerange[2 * i + 1]);
  }
  has_stood = has_stood && is_stable(*data);
  if (!has_stood) std::fprintf(stderr, "the world is unstable\n");
  return has_stood ? 0 : 1;
}
