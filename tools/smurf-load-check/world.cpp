// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-load-check/world.hpp"

#include <ode/ode.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <deque>
#include <new>
#include <set>

#include "smurf-load-check/ode_joint.hpp"

namespace smurf::load_check {
namespace {

using Vector = Eigen::Vector3d;

constexpr double kEarthGravity = 9.81;
constexpr double kFriction = 0.8;  // this and the next two: calibrated on 307 robots
constexpr double kContactErp = 0.2;
constexpr double kContactCfm = 1e-4;
constexpr int kContactsPerPair = 8;
/// Shape number of the ground of add_ground().
constexpr std::size_t kGround = kWorld;

void (*fault_handler)(const std::string&) = nullptr;

std::string formatted(const char* format, va_list arguments) {
  char text[512];
  std::vsnprintf(text, sizeof text, format, arguments);
  return text;
}

void on_ode_fault(int, const char* format, va_list arguments) {
  fault_handler(formatted(format, arguments));
}

/// By format string, because the numbers in a message differ from step to step.
std::vector<std::pair<std::string, EngineMessage>> messages;

void keep_message(int, const char* format, va_list arguments) {
  for (auto& [known, message] : messages) {
    if (known == format) {
      ++message.count;
      return;
    }
  }
  messages.push_back({format, {formatted(format, arguments), 1}});
}

}  // namespace

struct World::Engine {
  const Plan& plan;
  WorldSetup setup;
  dWorldID world = dWorldCreate();
  dSpaceID space = dHashSpaceCreate(nullptr);
  dJointGroupID contacts = dJointGroupCreate(0);
  std::vector<dBodyID> bodies;
  std::vector<OdeJoint> joints;
  std::vector<Pose> X_BL;  ///< by link
  std::vector<dTriMeshDataID> meshes;
  std::vector<dHeightfieldDataID> heightfields;
  std::deque<std::vector<float>> heights_of;  ///< the heights, which ODE reads from here
  std::vector<dGeomID> geoms;
  std::set<std::pair<std::size_t, std::size_t>> jointed;  ///< bodies
  std::vector<Overlap>* found = nullptr;                  ///< if set, overlaps are only collected
  double time = 0;

  Engine(const Plan& plan_, const WorldSetup& setup_) : plan(plan_), setup(setup_) {
    dRandSetSeed(0);
    dWorldSetGravity(world, setup.gravity[0], setup.gravity[1], setup.gravity[2]);
    dWorldSetCFM(world, setup.cfm);
    dWorldSetERP(world, setup.erp);
    dWorldSetAutoDisableFlag(world, 0);
    for (const BodyPlan& body : plan.bodies) add_body(body);
    for (const JointPlan& joint : plan.joints) add_joint(joint);
    for (const LinkPlan& link : plan.links) X_BL.push_back(inverse(pose(link.body)) * link.X_WL);
    for (std::size_t i = 0; i < plan.shapes.size(); ++i) add_shape(i);
  }

  ~Engine() {
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    for (const dTriMeshDataID mesh : meshes) dGeomTriMeshDataDestroy(mesh);
    for (const dHeightfieldDataID heights : heightfields) dGeomHeightfieldDataDestroy(heights);
  }
  Engine(const Engine&) = delete;
  Engine& operator=(const Engine&) = delete;

  dBodyID id(std::size_t body) const { return body < bodies.size() ? bodies[body] : nullptr; }

  Pose pose(std::size_t body) const { return pose_of(id(body)); }

  void add_body(const BodyPlan& plan_) {
    const MassProperties& mass = plan_.mass;
    const dBodyID body = dBodyCreate(world);
    bodies.push_back(body);
    dMass ode_mass;
    dMassSetParameters(&ode_mass, mass.mass, 0, 0, 0, mass.inertia(0, 0), mass.inertia(1, 1),
                       mass.inertia(2, 2), mass.inertia(0, 1), mass.inertia(0, 2),
                       mass.inertia(1, 2));
    dBodySetMass(body, &ode_mass);
    dBodySetPosition(body, mass.center[0], mass.center[1], mass.center[2]);
  }

  void add_joint(const JointPlan& joint) {
    // A floating joint connects nothing in ODE.
    if (joint.kind != JointKind::floating) jointed.insert(std::minmax(joint.parent, joint.child));
    joints.emplace_back(world, joint, id(joint.parent), id(joint.child), setup.stop_margin);
  }

  void add_shape(std::size_t index) {
    const ShapePlan& shape = plan.shapes[index];
    const dGeomID geom = std::visit([&](const auto& s) { return make_geom(s); }, shape.shape);
    dGeomSetData(geom, reinterpret_cast<void*>(index));
    geoms.push_back(geom);
    place(geom, shape);
  }

  void place(dGeomID geom, const ShapePlan& shape) const {
    if (std::holds_alternative<PlaneShape>(shape.shape)) {
      const Vector3 n = rotate(shape.X_WS.orientation, {0, 0, 1});
      dGeomPlaneSetParams(geom, n[0], n[1], n[2], to_eigen(n).dot(to_eigen(shape.X_WS.position)));
      return;
    }
    Pose X_WS = shape.X_WS;
    // ODE's heightfields have y up.
    if (std::holds_alternative<HeightfieldShape>(shape.shape)) {
      X_WS = X_WS * Pose{{}, from_axis_angle({1, 0, 0}, M_PI / 2)};
    }
    const Vector3& p = X_WS.position;
    const dQuaternion q = {X_WS.orientation.w, X_WS.orientation.x, X_WS.orientation.y,
                           X_WS.orientation.z};
    if (id(shape.body) != nullptr) {
      dGeomSetBody(geom, id(shape.body));
      dGeomSetOffsetWorldPosition(geom, p[0], p[1], p[2]);
      dGeomSetOffsetWorldQuaternion(geom, q);
    } else {
      dGeomSetPosition(geom, p[0], p[1], p[2]);
      dGeomSetQuaternion(geom, q);
    }
  }

  dGeomID make_geom(const BoxShape& box) const {
    return dCreateBox(space, box.size[0], box.size[1], box.size[2]);
  }
  dGeomID make_geom(const SphereShape& sphere) const { return dCreateSphere(space, sphere.radius); }
  dGeomID make_geom(const CylinderShape& cylinder) const {
    return dCreateCylinder(space, cylinder.radius, cylinder.length);
  }
  dGeomID make_geom(const CapsuleShape& capsule) const {
    return dCreateCapsule(space, capsule.radius, capsule.length);
  }
  dGeomID make_geom(const PlaneShape&) const { return dCreatePlane(space, 0, 0, 1, 0); }

  dGeomID make_geom(const TriangleShape& mesh) {
    meshes.push_back(dGeomTriMeshDataCreate());
    dGeomTriMeshDataBuildDouble(meshes.back(), mesh.points.data(), sizeof(mesh.points[0]),
                                static_cast<int>(mesh.points.size()), mesh.triangles.data(),
                                static_cast<int>(3 * mesh.triangles.size()),
                                sizeof(mesh.triangles[0]));
    return dCreateTriMesh(space, meshes.back(), nullptr, nullptr, nullptr);
  }

  dGeomID make_geom(const HeightfieldShape& field) {
    // Turned upright, ODE's rows run towards -y.
    std::vector<float>& heights = heights_of.emplace_back();
    heights.reserve(field.heights.size());
    for (std::size_t row = field.rows; row-- > 0;) {
      const auto begin = field.heights.begin() + static_cast<std::ptrdiff_t>(row * field.columns);
      heights.insert(heights.end(), begin, begin + static_cast<std::ptrdiff_t>(field.columns));
    }
    constexpr double kThickness = 1;  // m; what falls below comes back up
    heightfields.push_back(dGeomHeightfieldDataCreate());
    dGeomHeightfieldDataBuildSingle(heightfields.back(), heights.data(), 0, field.size_x,
                                    field.size_y, static_cast<int>(field.columns),
                                    static_cast<int>(field.rows), 1, 0, kThickness, 0);
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    dGeomHeightfieldDataSetBounds(heightfields.back(), *low, *high);
    return dCreateHeightfield(space, heightfields.back(), 1);
  }

  bool may_touch(std::size_t a, std::size_t b) const {
    if (a == kGround || b == kGround) {
      return id(plan.shapes[std::min(a, b)].body) != nullptr;
    }
    const ShapePlan& first = plan.shapes[a];
    const ShapePlan& second = plan.shapes[b];
    if (id(first.body) == nullptr && id(second.body) == nullptr) return false;
    if (first.body == second.body || (first.bitmask & second.bitmask) == 0) return false;
    const bool has_environment = first.body == kEnvironment || second.body == kEnvironment;
    if ((first.is_stand_in || second.is_stand_in) && !has_environment) return false;
    return !jointed.contains(std::minmax(first.body, second.body));
  }

  static void on_near(void* self, dGeomID a, dGeomID b) {
    static_cast<Engine*>(self)->collide(a, b);
  }

  void collide(dGeomID a, dGeomID b) {
    const auto first = reinterpret_cast<std::size_t>(dGeomGetData(a));
    const auto second = reinterpret_cast<std::size_t>(dGeomGetData(b));
    if (!may_touch(first, second)) return;
    dContact points[kContactsPerPair];
    const int count = dCollide(a, b, kContactsPerPair, &points[0].geom, sizeof(dContact));
    if (found != nullptr) {
      double depth = 0;
      for (int i = 0; i < count; ++i) depth = std::max(depth, double{points[i].geom.depth});
      if (depth > 0) found->push_back({std::min(first, second), std::max(first, second), depth});
      return;
    }
    for (int i = 0; i < count; ++i) {
      points[i].surface.mode = dContactSoftERP | dContactSoftCFM | dContactApprox1;
      points[i].surface.mu = kFriction;
      points[i].surface.soft_erp = kContactErp;
      points[i].surface.soft_cfm = kContactCfm;
      dJointAttach(dJointCreateContact(world, contacts, &points[i]), dGeomGetBody(a),
                   dGeomGetBody(b));
    }
  }
};

World::World(const Plan& plan, const WorldSetup& setup)
    : engine_(std::make_unique<Engine>(plan, setup)) {}
World::~World() = default;

void World::step() {
  if (engine_->setup.contacts) dSpaceCollide(engine_->space, engine_.get(), Engine::on_near);
  for (const OdeJoint& joint : engine_->joints) joint.prepare(engine_->setup.step);
  // If ODE has no memory, nothing moves, which would look like a robot at rest.
  if (dWorldStep(engine_->world, engine_->setup.step) == 0) throw std::bad_alloc();
  dJointGroupEmpty(engine_->contacts);
  engine_->time += engine_->setup.step;
}

double World::time() const { return engine_->time; }
double World::step_size() const { return engine_->setup.step; }

double World::speed(std::size_t body) const {
  return Eigen::Map<const Vector>(dBodyGetLinearVel(engine_->bodies[body])).norm();
}

std::optional<double> World::lowest_point() const {
  std::optional<double> lowest;
  for (std::size_t i = 0; i < engine_->geoms.size(); ++i) {
    if (engine_->id(engine_->plan.shapes[i].body) == nullptr) continue;
    dReal box[6];
    dGeomGetAABB(engine_->geoms[i], box);
    lowest = std::min(lowest.value_or(box[4]), double{box[4]});
  }
  return lowest;
}

void World::add_ground(double z) {
  const dGeomID ground = dCreatePlane(engine_->space, 0, 0, 1, z);
  dGeomSetData(ground, reinterpret_cast<void*>(kGround));
}

std::vector<Overlap> World::overlaps() {
  std::vector<Overlap> found;
  engine_->found = &found;
  dSpaceCollide(engine_->space, engine_.get(), Engine::on_near);
  engine_->found = nullptr;
  std::sort(found.begin(), found.end(), [](const Overlap& a, const Overlap& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return found;
}

Pose World::body_pose(std::size_t body) const { return engine_->pose(body); }

Pose World::link_pose(const LinkPlan& link) const {
  const auto index = static_cast<std::size_t>(&link - engine_->plan.links.data());
  return engine_->pose(link.body) * engine_->X_BL[index];
}

JointError World::joint_error(std::size_t joint) const { return engine_->joints[joint].error(); }

double World::joint_position(std::size_t joint) const { return engine_->joints[joint].position(); }

double World::energy() const {
  const Vector& gravity = engine_->setup.gravity;
  double energy = 0;
  double mass = 0;
  for (std::size_t i = 0; i < engine_->bodies.size(); ++i) {
    const dBodyID body = engine_->bodies[i];
    const MassProperties& properties = engine_->plan.bodies[i].mass;
    const Eigen::Map<const Vector> v(dBodyGetLinearVel(body));
    const Eigen::Map<const Vector> w(dBodyGetAngularVel(body));
    const Pose X_BW = inverse(engine_->pose(i));
    const Vector w_B = to_eigen(rotate(X_BW.orientation, {w[0], w[1], w[2]}));
    const Eigen::Map<const Vector> p(dBodyGetPosition(body));
    energy += properties.mass * (v.squaredNorm() / 2 - gravity.dot(p)) +
              w_B.dot(properties.inertia * w_B) / 2;
    mass += properties.mass;
  }
  const double pull = gravity.norm() > 0 ? gravity.norm() : kEarthGravity;
  return mass > 0 ? energy / (mass * pull) : 0;
}

bool World::is_finite() const {
  for (std::size_t i = 0; i < engine_->bodies.size(); ++i) {
    const Vector3 p = engine_->pose(i).position;
    const dReal* v = dBodyGetLinearVel(engine_->bodies[i]);
    if (!std::isfinite(p[0] + p[1] + p[2] + v[0] + v[1] + v[2])) return false;
  }
  return true;
}

std::vector<EngineMessage> take_engine_messages() {
  std::vector<EngineMessage> taken;
  for (auto& [format, message] : messages) taken.push_back(std::move(message));
  messages.clear();
  return taken;
}

std::string unusable_engine() {
  return dCheckConfiguration("ODE_double_precision") == 1
             ? ""
             : "the installed ODE library does not calculate in double precision";
}

void start_engine(void (*on_fault)(const std::string& message)) {
  fault_handler = on_fault;
  dSetErrorHandler(on_ode_fault);
  dSetDebugHandler(on_ode_fault);
  dSetMessageHandler(keep_message);
  dInitODE2(0);
  dAllocateODEDataForThread(static_cast<unsigned>(dAllocateMaskAll));
}

}  // namespace smurf::load_check
