// SPDX-License-Identifier: BSD-3-Clause
// URDFs without shapes as the load check lets them hang and fall.
#include "readers/motion.hpp"

#include <cstdio>
#include <cstdlib>

#include "smurf-load-check/plan.hpp"
#include "smurf-load-check/world.hpp"
#include "smurf/load.hpp"

namespace {

using namespace smurf;
using namespace smurf::load_check;

double weight_of(const Plan& plan) {
  double mass = 0;
  for (const BodyPlan& body : plan.bodies) mass += body.mass.mass;
  return mass * tests::kGravity;
}

double height_of(const Plan& plan, const World& world) {
  double sum = 0;
  double mass = 0;
  for (std::size_t i = 0; i < plan.bodies.size(); ++i) {
    sum += plan.bodies[i].mass.mass * world.body_pose(i).position[2];
    mass += plan.bodies[i].mass.mass;
  }
  return sum / mass;
}

template <class Print>
void simulate(const LinkedModel& model, Base::Kind base, double step, Print print) {
  PlacedModel placed;
  placed.model = &model;
  placed.base.kind = base;
  const Plan plan = make_plan({placed});
  WorldSetup setup;
  setup.step = step;
  World world(plan, setup);
  const double start = world.energy();
  const double height = height_of(plan, world);
  tests::run(
      step, [&] { world.step(); },
      [&](double time) {
        print(time, (world.energy() - start) * weight_of(plan), height_of(plan, world) - height,
              plan, world);
      });
}

void print_links(double time, const Plan& plan, const World& world) {
  for (const LinkPlan& link : plan.links) {
    const Pose X_WL = world.link_pose(link);
    const Vector3& p = X_WL.position;
    const Quaternion& q = X_WL.orientation;
    tests::print_link(time, plan.link(link).name.value_or(""), {p[0], p[1], p[2]},
                      {q.w, q.x, q.y, q.z});
  }
}

bool move(const std::string& path, double step) {
  SourceMap sources;
  DiskFiles files;
  DiagnosticSink sink;
  LoadContext context{sources, files, sink, {}, {}};
  const LinkedModel model = load_model(path, context);
  if (!model.robot || model.tree.roots.size() != 1 || sink.has_errors()) return false;
  simulate(model, Base::Kind::world, step,
           [](double time, double energy, double, const Plan& plan, const World& world) {
             tests::print_hang(time, energy);
             print_links(time, plan, world);
           });
  simulate(model, Base::Kind::free, step,
           [](double time, double energy, double height, const Plan&, const World&) {
             tests::print_fall(time, energy, height);
           });
  return true;
}

void give_up(const std::string& message) {
  std::printf("refused\t%s\n", message.c_str());
  std::exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  start_engine(give_up);
  return tests::move_robots(argc, argv, move);
}
