// SPDX-License-Identifier: BSD-3-Clause
// URDFs as MuJoCo reads them. It requires every mesh, beside the URDF and regardless of its path,
// so each mesh is replaced by a small tetrahedron: frames do not depend on shapes.
#include <cstring>
#include <fstream>
#include <memory>
#include <mujoco/mujoco.h>
#include <regex>
#include <sstream>

#include "robot_poses.hpp"

namespace {

/// A binary STL.
std::string tetrahedron() {
  constexpr float kCorners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  std::string text(80, ' ');
  const auto append = [&](const auto& value) {
    text.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(std::uint32_t{4});
  for (const auto& face : kFaces) {
    text.append(12, '\0');  // the normal
    for (const int corner : face) append(kCorners[corner]);
    text.append(2, '\0');
  }
  return text;
}

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                             "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

void add_meshes(const std::string& urdf, mjVFS& files) {
  const std::regex names(R"re(filename\s*=\s*["']([^"']*[/\\])?([^"'/\\]+)["'])re");
  for (std::sregex_iterator match(urdf.begin(), urdf.end(), names), end; match != end; ++match) {
    const std::string name = (*match)[2];
    const bool is_obj = name.ends_with(".obj") || name.ends_with(".OBJ");
    const std::string mesh = is_obj ? kObj : tetrahedron();
    if (mj_makeEmptyFileVFS(&files, name.c_str(), static_cast<int>(mesh.size())) != 0) continue;
    std::memcpy(files.filedata[mj_findFileVFS(&files, name.c_str())], mesh.data(), mesh.size());
  }
}

void print_bodies(const char* what, const mjModel& model, const mjData& data) {
  for (int i = 1; i < model.nbody; ++i) {
    const mjtNum* p = data.xpos + 3 * i;
    const mjtNum* q = data.xquat + 4 * i;
    smurf::tests::print_pose(what, mj_id2name(&model, mjOBJ_BODY, i), {p[0], p[1], p[2]},
                             {q[0], q[1], q[2], q[3]});
  }
}

bool print_robot(const std::string& path) {
  std::ostringstream urdf;
  urdf << std::ifstream(path).rdbuf();
  const auto files = std::make_unique<mjVFS>();
  mj_defaultVFS(files.get());
  add_meshes(urdf.str(), *files);
  char error[1000] = "";
  mjModel* model = mj_loadXML(path.c_str(), files.get(), error, sizeof error);
  mj_deleteVFS(files.get());
  if (model == nullptr) return false;
  mjData* data = mj_makeData(model);
  std::memset(data->qpos, 0, sizeof(mjtNum) * static_cast<std::size_t>(model->nq));
  for (int i = 0; i < model->njnt; ++i) {
    if (model->jnt_type[i] == mjJNT_FREE) data->qpos[model->jnt_qposadr[i] + 3] = 1;
  }
  mj_kinematics(model, data);
  print_bodies("pose", *model, *data);
  for (int i = 0; i < model->njnt; ++i) {
    if (model->jnt_type[i] != mjJNT_HINGE && model->jnt_type[i] != mjJNT_SLIDE) continue;
    const char* name = mj_id2name(model, mjOBJ_JOINT, i);
    data->qpos[model->jnt_qposadr[i]] = smurf::tests::position_of_joint(name ? name : "");
  }
  mj_kinematics(model, data);
  print_bodies("moved", *model, *data);
  mj_deleteData(data);
  mj_deleteModel(model);
  return true;
}

void be_quiet(const char*) {}

}  // namespace

int main(int argc, char** argv) {
  mju_user_warning = be_quiet;
  return smurf::tests::print_robots(argc, argv, print_robot);
}
