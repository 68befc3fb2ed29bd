// SPDX-License-Identifier: BSD-3-Clause
// Lets a URDF hang in MuJoCo, which fixes every root: a falling robot has a floating joint `fall`
// above it, and the ground is a shape of the link above this joint.
#include <cstring>
#include <mujoco/mujoco.h>

#include "motion.hpp"

namespace {

using namespace smurf::tests;

/// Uses masses, joints and gravity only.
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

void fall(const mjModel& model, mjData& data, double step) {
  const double start = energy_of(model, data);
  const double height = data.subtree_com[2];
  run(
      step, [&] { mj_step(&model, &data); },
      [&](double time) {
        const double energy = energy_of(model, data) - start;
        print_fall(time, energy, data.subtree_com[2] - height);
      });
}

void hang(const mjModel& model, mjData& data, double step) {
  const double start = energy_of(model, data);
  run(
      step, [&] { mj_step(&model, &data); },
      [&](double time) {
        print_hang(time, energy_of(model, data) - start);
        print_bodies(time, model, data);
      });
}

void drop(mjModel& model, mjData& data, double step) {
  model.opt.disableflags &= ~mjDSBL_CONTACT;
  for (int i = 0; i < model.ngeom; ++i) {
    const bool is_ground = model.geom_bodyid[i] == 0;
    model.geom_contype[i] = is_ground ? 1 : 0;
    model.geom_conaffinity[i] = is_ground ? 0 : 1;
  }
  mj_resetData(&model, &data);
  run_drop(
      step, [&] { mj_step(&model, &data); }, [&] { return data.ncon > 0; },
      [&] { return energy_of(model, data); }, [&] { return data.subtree_com[2]; });
}

std::string move(const std::string& path, double step, std::optional<double> ground) {
  char error[1000] = "";
  mjModel* model = mj_loadXML(path.c_str(), nullptr, error, sizeof error);
  if (model == nullptr) return error;
  leave_mechanics_alone(*model, step);
  mjData* data = mj_makeData(model);
  if (mj_name2id(model, mjOBJ_JOINT, "fall") >= 0) {
    fall(*model, *data, step);
  } else {
    hang(*model, *data, step);
  }
  if (ground) drop(*model, *data, step);
  mj_deleteData(data);
  mj_deleteModel(model);
  return {};
}

void be_quiet(const char*) {}

}  // namespace

int main(int argc, char** argv) {
  mju_user_warning = be_quiet;
  return move_robot(argc, argv, move);
}
