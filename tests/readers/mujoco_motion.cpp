// SPDX-License-Identifier: BSD-3-Clause
// URDFs without shapes as MuJoCo lets them hang. It holds every root: one that falls has a floating
// joint above it, named `fall`.
#include <cstring>
#include <mujoco/mujoco.h>

#include "motion.hpp"

namespace {

using namespace smurf::tests;

/// Nothing but masses, joints and gravity.
void leave_mechanics_alone(mjModel& model, double step) {
  model.opt.timestep = step;
  model.opt.integrator = mjINT_RK4;
  model.opt.disableflags |= mjDSBL_CONTACT | mjDSBL_LIMIT | mjDSBL_FRICTIONLOSS | mjDSBL_PASSIVE;
  model.opt.enableflags |= mjENBL_ENERGY;
  model.opt.gravity[2] = -kGravity;
  std::memset(model.dof_armature, 0, sizeof(mjtNum) * static_cast<std::size_t>(model.nv));
}

void print_bodies(double time, const mjModel& model, const mjData& data) {
  for (int i = 1; i < model.nbody; ++i) {
    const mjtNum* p = data.xpos + 3 * i;
    const mjtNum* q = data.xquat + 4 * i;
    print_link(time, mj_id2name(&model, mjOBJ_BODY, i), {p[0], p[1], p[2]},
               {q[0], q[1], q[2], q[3]});
  }
}

double energy_of(const mjModel& model, mjData& data) {
  mj_forward(&model, &data);
  return data.energy[0] + data.energy[1];
}

bool move(const std::string& path, double step) {
  char error[1000] = "";
  mjModel* model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
  if (model == nullptr) return false;
  leave_mechanics_alone(*model, step);
  mjData* data = mj_makeData(model);
  const bool falls = mj_name2id(model, mjOBJ_JOINT, "fall") >= 0;
  const double start = energy_of(*model, *data);
  const double height = data->subtree_com[2];
  run(
      step, [&] { mj_step(model, data); },
      [&](double time) {
        const double energy = energy_of(*model, *data) - start;
        if (falls) {
          print_fall(time, energy, data->subtree_com[2] - height);
        } else {
          print_hang(time, energy);
          print_bodies(time, *model, *data);
        }
      });
  mj_deleteData(data);
  mj_deleteModel(model);
  return true;
}

void be_quiet(const char*) {}

}  // namespace

int main(int argc, char** argv) {
  mju_user_warning = be_quiet;
  return move_robots(argc, argv, move);
}
