// SPDX-License-Identifier: BSD-3-Clause
// A model of MuJoCo with its state.
#pragma once

#include <cstdio>
#include <memory>
#include <mujoco/mujoco.h>

namespace smurf::tests {

struct FreeMujoco {
  void operator()(mjModel* model) const { mj_deleteModel(model); }
  void operator()(mjData* data) const { mj_deleteData(data); }
};

struct MujocoWorld {
  std::unique_ptr<mjModel, FreeMujoco> model;
  std::unique_ptr<mjData, FreeMujoco> data;
};

/// Loads an MJCF. When MuJoCo fails to load it, prints why and returns null pointers.
inline MujocoWorld load_mujoco(const char* path) {
  char error[1000] = "";
  MujocoWorld world{
      std::unique_ptr<mjModel, FreeMujoco>(mj_loadXML(path, nullptr, error, sizeof error)),
      nullptr};
  if (world.model == nullptr) {
    std::fprintf(stderr, "%s\n", error);
    return world;
  }
  world.data.reset(mj_makeData(world.model.get()));
  return world;
}

/// Also sets the positions of the first keyframe, if there is one.
inline MujocoWorld load_mujoco_at_start(const char* path) {
  MujocoWorld world = load_mujoco(path);
  if (world.model == nullptr) return world;
  if (world.model->nkey > 0) mj_resetDataKeyframe(world.model.get(), world.data.get(), 0);
  mj_forward(world.model.get(), world.data.get());
  return world;
}

}  // namespace smurf::tests
