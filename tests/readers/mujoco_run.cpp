// SPDX-License-Identifier: BSD-3-Clause
// Loads an MJCF with libmujoco, prints the contacts at the start, lets it run for some seconds with
// the commands of the keyframe, to each of which a number is added, and prints where bodies and
// joints are before and after. Further numbers x y: the height of what a vertical ray meets there.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "mujoco_world.hpp"

namespace {

const char* name_of(const mjModel& model, int type, int index) {
  const char* name = mj_id2name(&model, type, index);
  return name != nullptr ? name : "";
}

void print_heights(const mjModel& model, const mjData& data, int count, char** numbers) {
  for (int i = 0; i + 1 < count; i += 2) {
    const mjtNum from[3] = {std::atof(numbers[i]), std::atof(numbers[i + 1]), 100};
    const mjtNum down[3] = {0, 0, -1};
    int geom = -1;
    const mjtNum distance = mj_ray(&model, &data, from, down, nullptr, 1, -1, &geom);
    std::printf("height\t%s\t%s\t%.9g\n", numbers[i], numbers[i + 1],
                distance < 0 ? NAN : from[2] - distance);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 2;
  const smurf::tests::MujocoWorld world = smurf::tests::load_mujoco_at_start(argv[1]);
  mjModel* model = world.model.get();
  mjData* data = world.data.get();
  if (model == nullptr) return 1;
  print_heights(*model, *data, argc - 4, argv + 4);
  for (int i = 0; i < data->ncon; ++i) {
    const mjContact& contact = data->contact[i];
    std::printf("contact\t%s\t%s\t%.9g\n",
                name_of(*model, mjOBJ_BODY, model->geom_bodyid[contact.geom1]),
                name_of(*model, mjOBJ_BODY, model->geom_bodyid[contact.geom2]), -contact.dist);
  }
  const std::vector<mjtNum> bodies(data->xpos, data->xpos + 3 * model->nbody);
  const std::vector<mjtNum> joints(data->qpos, data->qpos + model->nq);
  for (int i = 0; i < model->nu; ++i) data->ctrl[i] += std::atof(argv[3]);
  const int steps = static_cast<int>(std::lround(std::atof(argv[2]) / model->opt.timestep));
  for (int step = 0; step < steps; ++step) mj_step(model, data);
  for (int i = 1; i < model->nbody; ++i) {
    const mjtNum* at = data->xpos + 3 * i;
    const mjtNum* before = bodies.data() + 3 * i;
    std::printf("body\t%s\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\t%.9g\n", name_of(*model, mjOBJ_BODY, i),
                before[0], before[1], before[2], at[0], at[1], at[2]);
  }
  for (int i = 0; i < model->njnt; ++i) {
    const auto at = static_cast<std::size_t>(model->jnt_qposadr[i]);
    if (model->jnt_type[i] == mjJNT_FREE) continue;
    std::printf("joint\t%s\t%.9g\t%.9g\n", name_of(*model, mjOBJ_JOINT, i), joints[at],
                data->qpos[at]);
  }
  for (int i = 0; i < model->nmesh; ++i) {
    std::printf("mesh\t%s\t%d\n", name_of(*model, mjOBJ_MESH, i), model->mesh_facenum[i]);
  }
  return 0;
}
