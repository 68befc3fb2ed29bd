// SPDX-License-Identifier: BSD-3-Clause
// Loads an MJCF with libmujoco, sets its keyframe, prints the world pose of every body ("name x y z
// qw qx qy qz") and takes 100 steps. Fails if a position is then not a number.
#include <cmath>
#include <cstdio>

#include "mujoco_world.hpp"

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  const smurf::tests::MujocoWorld world = smurf::tests::load_mujoco_at_start(argv[1]);
  mjModel* model = world.model.get();
  mjData* data = world.data.get();
  if (model == nullptr) return 1;
  for (int i = 1; i < model->nbody; ++i) {
    const mjtNum* p = data->xpos + 3 * i;
    const mjtNum* q = data->xquat + 4 * i;
    std::printf("pose\t%s\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\t%.17g\n",
                mj_id2name(model, mjOBJ_BODY, i), p[0], p[1], p[2], q[0], q[1], q[2], q[3]);
  }
  std::printf("gravity\t%.17g\t%.17g\t%.17g\n", model->opt.gravity[0], model->opt.gravity[1],
              model->opt.gravity[2]);
  std::printf("step\t%.17g\n", model->opt.timestep);
  for (int step = 0; step < 100; ++step) mj_step(model, data);
  for (int i = 0; i < model->nq; ++i) {
    if (std::isfinite(data->qpos[i]) && data->warning[mjWARN_BADQPOS].number == 0 &&
        data->warning[mjWARN_BADQACC].number == 0) {
      continue;
    }
    std::fprintf(stderr, "the world is unstable\n");
    return 1;
  }
  return 0;
}
