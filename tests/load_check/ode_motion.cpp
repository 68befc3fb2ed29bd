// SPDX-License-Identifier: BSD-3-Clause
// Lets a URDF hang, fall and drop as the load check does. Its shapes do not collide with each
// other.
#include "readers/motion.hpp"

#include <cstdio>
#include <cstdlib>

#include "smurf-load-check/body_plan.hpp"
#include "smurf-load-check/collision_shapes.hpp"
#include "smurf-load-check/world.hpp"
#include "smurf/load.hpp"

namespace {

using namespace smurf;
using namespace smurf::load_check;

constexpr double kDropHeight = 1e-3;  // m; that of the load check

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

Plan plan_on(const LinkedModel& model, Base::Kind base) {
  PlacedModel placed;
  placed.model = &model;
  placed.base.kind = base;
  return make_plan({placed});
}

template <class Print>
void simulate(const LinkedModel& model, Base::Kind base, double step, Print print) {
  const Plan plan = plan_on(model, base);
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

void drop(const LinkedModel& model, double step, const ShapeFiles& files, DiagnosticSink& sink) {
  Plan plan = plan_on(model, Base::Kind::free);
  add_shapes(plan, files, sink);
  for (ShapePlan& shape : plan.shapes) shape.is_stand_in = true;  // touches the ground only
  WorldSetup setup;
  setup.step = step;
  setup.contacts = true;
  World world(plan, setup);
  const std::optional<double> lowest = world.lowest_point();
  if (!lowest) return;
  const double ground = *lowest - kDropHeight;
  world.add_ground(ground);
  std::printf("ground\t%.17g\n", ground);
  tests::run_drop(
      step, [&] { world.step(); }, [&] { return !world.overlaps().empty(); },
      [&] { return world.energy() * weight_of(plan); }, [&] { return height_of(plan, world); });
}

std::string move(const std::string& path, double step, std::optional<double>) {
  SourceMap sources;
  DiskFiles files;
  DiagnosticSink sink;
  LoadContext context{sources, files, sink, {}, {}};
  const LinkedModel model = load_model(path, context);
  for (const Diagnostic& diagnostic : sink.take()) {
    if (diagnostic.severity == Severity::error) return diagnostic.message;
  }
  if (!model.robot || model.tree.roots.size() != 1) return "is no robot of one tree";
  simulate(model, Base::Kind::world, step,
           [](double time, double energy, double, const Plan& plan, const World& world) {
             tests::print_hang(time, energy);
             print_links(time, plan, world);
           });
  simulate(model, Base::Kind::free, step,
           [](double time, double energy, double height, const Plan&, const World&) {
             tests::print_fall(time, energy, height);
           });
  drop(model, step, {files}, sink);
  return {};
}

void give_up(const std::string& message) {
  std::printf("refused\t%s\n", message.c_str());
  std::exit(0);
}

}  // namespace

int main(int argc, char** argv) {
  start_engine(give_up);
  return tests::move_robot(argc, argv, move);
}
