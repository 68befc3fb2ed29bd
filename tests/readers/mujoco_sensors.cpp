// SPDX-License-Identifier: BSD-3-Clause
// Loads an MJCF with libmujoco, sets its keyframe, takes the steps that a second argument asks for,
// and prints the world pose of every camera with
// its vertical opening ("camera name x y z, then the rotation, row by row, and the degrees"), the
// same of every site, every sensor with its type and its values, and of every geom with a texture
// the size of that and its own colour.
#include <cstdio>
#include <cstdlib>

#include "mujoco_world.hpp"

namespace {

void print(const char* kind, const char* name, const mjtNum* position, const mjtNum* rotation) {
  std::printf("%s\t%s", kind, name);
  for (int i = 0; i < 3; ++i) std::printf("\t%.17g", position[i]);
  for (int i = 0; i < 9; ++i) std::printf("\t%.17g", rotation[i]);
}

void print_frames(const mjModel& model, const mjData& data) {
  for (int i = 0; i < model.ncam; ++i) {
    print("camera", mj_id2name(&model, mjOBJ_CAMERA, i), data.cam_xpos + 3 * i,
          data.cam_xmat + 9 * i);
    std::printf("\t%.17g\n", model.cam_fovy[i]);
  }
  for (int i = 0; i < model.nsite; ++i) {
    print("site", mj_id2name(&model, mjOBJ_SITE, i), data.site_xpos + 3 * i,
          data.site_xmat + 9 * i);
    std::printf("\n");
  }
}

void print_sensors(const mjModel& model, const mjData& data) {
  for (int i = 0; i < model.nsensor; ++i) {
    std::printf("sensor\t%s\t%d", mj_id2name(&model, mjOBJ_SENSOR, i), model.sensor_type[i]);
    for (int k = 0; k < model.sensor_dim[i]; ++k) {
      std::printf("\t%.17g", data.sensordata[model.sensor_adr[i] + k]);
    }
    std::printf("\n");
  }
}

void print_textures(const mjModel& model) {
  for (int i = 0; i < model.ngeom; ++i) {
    const int material = model.geom_matid[i];
    if (material < 0 || model.mat_texid[material] < 0) continue;
    const int texture = model.mat_texid[material];
    std::printf("texture\t%s\t%d\t%d\t%g\t%g\t%g\n", mj_id2name(&model, mjOBJ_GEOM, i),
                model.tex_width[texture], model.tex_height[texture], model.geom_rgba[4 * i],
                model.geom_rgba[4 * i + 1], model.geom_rgba[4 * i + 2]);
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 3) return 2;
  const smurf::tests::MujocoWorld world = smurf::tests::load_mujoco_at_start(argv[1]);
  mjModel* model = world.model.get();
  mjData* data = world.data.get();
  if (model == nullptr) return 1;
  const int steps = argc == 3 ? std::atoi(argv[2]) : 0;
  for (int i = 0; i < steps; ++i) mj_step(model, data);
  print_frames(*model, *data);
  print_sensors(*model, *data);
  print_textures(*model);
  return 0;
}
