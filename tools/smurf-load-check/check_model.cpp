// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "link/kinematics.hpp"
#include "lint/queries.hpp"
#include "smurf-load-check/bodies.hpp"
#include "smurf-load-check/check.hpp"
#include "smurf-load-check/collision_shapes.hpp"
#include "smurf-load-check/stage_run.hpp"
#include "smurf-load-check/stand_ins.hpp"
#include "smurf-load-check/start.hpp"

namespace smurf::load_check {
namespace {

// Long enough to show a defect, and short enough that undamped limbs of a sound robot do not hit
// their stops, which would add energy.
constexpr double kStillTime = 0.5;  // s
constexpr double kHangTime = 0.25;
constexpr double kDropTime = 0.5;
constexpr double kDropHeight = 1e-3;  // m, above the ground
constexpr double kStep = 1e-3;        // s
const char* const kNoMasses = "no link has a mass";

class ModelCheck {
 public:
  ModelCheck(const LinkedModel& model, const ShapeFiles& files, const CheckOptions& options,
             const OnStage& on_stage)
      : model_(model),
        files_(files),
        run_(options, on_stage, [this] { return suspect(); }),
        given_(joint_positions(model, options.pose).value_or(JointPositions{})) {}

  CheckResult run() {
    run_.stage(Stage::build, [&](StageResult& result) { build(result); });
    run_.stage(Stage::pose0, [&](StageResult& result) { look_at_start(result); });
    run_.stage(Stage::still, [&](StageResult& result) { keep_still(result); });
    run_.stage(Stage::hang, [&](StageResult& result) { hang(result); });
    run_.stage(Stage::drop, [&](StageResult& result) { drop(result); });
    return run_.finish();
  }

 private:
  Plan plan_on(Base::Kind base) const {
    PlacedModel placed;
    placed.model = &model_;
    placed.positions = start_positions(model_, given_);
    placed.base.kind = base;
    return make_plan({placed});
  }

  WorldSetup setup() const {
    WorldSetup setup;
    setup.step = run_.options().step.value_or(kStep);
    setup.stop_margin = run_.stop_margin();
    return setup;
  }

  Named suspect() const {
    const JointPlan* joint = joint_at_stop(fixed_);
    return joint != nullptr ? name_of(fixed_, *joint) : Named{"", place_of(model_)};
  }

  void build(StageResult& result) {
    fixed_ = plan_on(Base::Kind::world);
    Plan free = plan_on(Base::Kind::free);
    // A root without mass is a fixed base.
    is_free_ = free.bodies.front().mass.mass > 0;
    whole_ = is_free_ ? std::move(free) : fixed_;
    result.figures = check_bodies(whole_, run_.options().bounds, run_.sink());
    has_masses_ = std::any_of(model_.robot->links.begin(), model_.robot->links.end(),
                              [](const urdf::Link& link) { return link.inertial.has_value(); });
    add_stand_ins(fixed_);
    stand_ins_ = add_stand_ins(whole_);
    const ShapeCount count = add_shapes(whole_, files_, run_.sink());
    result.note = summary(count);
    if (count.missing_meshes > 0 && whole_.shapes.empty()) result.verdict = Verdict::warn;
  }

  std::string summary(const ShapeCount& count) const {
    std::string text = count_of(whole_.bodies.size(), "moving body", "moving bodies") + ", " +
                       count_of(whole_.joints.size(), "joint", "joints") + ", " +
                       count_of(whole_.shapes.size(), "shape", "shapes");
    if (count.stand_ins > 0) {
      text += "; " + count_of(count.stand_ins, "mesh", "meshes") + " as box";
    }
    if (count.missing_meshes > 0) {
      text += "; " + count_of(count.missing_meshes, "mesh", "meshes") + " missing";
      if (whole_.shapes.empty()) text += ", so nothing can collide";
    }
    if (stand_ins_ > 0) text += "; " + count_of(stand_ins_, "stand-in", "stand-ins");
    if (fixed_.unbounded_joints > 0) {
      text += "; " + count_of(fixed_.unbounded_joints, "joint limit", "joint limits") +
              " ignored (ODE has no stops beyond 180 degrees)";
    }
    return text + fixed_.text_on_damping();
  }

  void look_at_start(StageResult& result) {
    World world(whole_, setup());
    Figure figure = run_.figure("overlap");
    for (const Overlap& overlap : world.overlaps()) {
      const ShapePlan& first = whole_.shapes[overlap.first];
      const ShapePlan& second = whole_.shapes[overlap.second];
      if (overlap.depth > figure.value) {
        figure.value = overlap.depth;
        figure.worst = first.name + " and " + second.name;
        figure.place = first.place;
        deepest_ = overlap;
      }
      if (overlap.depth <= figure.limit) continue;
      Diagnostic& diagnostic =
          run_.sink().report(rules::sml6201_initial_overlap, first.place,
                             first.name + " is " + format_rounded(overlap.depth * 1000, 3) +
                                 " mm inside " + second.name + " at the start");
      diagnostic.label(second.place, "overlaps with this one");
    }
    result.figures.push_back(figure);
  }

  void keep_still(StageResult& result) {
    report_limits();
    if (!has_masses_) return StageRun::skip(result, kNoMasses);
    WorldSetup weightless = setup();
    weightless.gravity.setZero();
    World world(fixed_, weightless);
    std::vector<Pose> start;
    for (const LinkPlan& link : fixed_.links) start.push_back(world.link_pose(link));
    Figure figure = run_.figure("motion");
    const bool is_finite = run_.step(world, fixed_, kStillTime, [&] {
      for (std::size_t i = 0; i < fixed_.links.size(); ++i) {
        const double way = way_between(start[i], world.link_pose(fixed_.links[i]));
        run_.note_worst(figure, way, [&] { return name_of(fixed_, fixed_.links[i]); });
      }
    });
    result.figures.push_back(figure);
    // Findings about limits explain why joints jump to their stops.
    const bool is_explained = std::any_of(fixed_.joints.begin(), fixed_.joints.end(), is_outside);
    if (!is_finite || figure.is_within() || is_explained) return;
    run_.sink()
        .report(rules::sml6302_moves_at_rest, figure.place,
                figure.worst + " moves although no force acts on it")
        .caret = "by " + format_rounded(figure.value, 3) + " m";
  }

  static bool is_outside(const JointPlan& joint) { return outside_limits(joint) > 0; }

  /// Reports joints that cannot be at zero, or that start outside their limits.
  void report_limits() {
    for (const JointPlan& joint : fixed_.joints) {
      if (!joint.limits) continue;
      const auto [lower, upper] = *joint.limits;
      const double zero = position_of(model_, fixed_.joint(joint), given_);
      if (!is_outside(joint) && lower <= zero && zero <= upper) continue;
      const double excluded = is_outside(joint) ? joint.start : zero;
      const bool is_below = excluded < lower;
      const urdf::Limit& limit = *fixed_.joint(joint).limit;
      const Field<double>& bound = is_below ? limit.lower : limit.upper;
      const Named named = name_of(fixed_, joint);
      Diagnostic& diagnostic =
          run_.sink().report(rules::sml6301_zero_outside_limits,
                             bound.written ? bound.span : limit.span, limits_message(joint, named));
      diagnostic.caret = std::string("all positions are ") + (is_below ? "above " : "below ") +
                         format_rounded(excluded, 3);
      if (!is_outside(joint)) {
        diagnostic.note("the check starts it at the nearest allowed position, " +
                        format_rounded(joint.start, 3));
      }
    }
  }

  std::string limits_message(const JointPlan& joint, const Named& named) const {
    if (given_.contains(fixed_.joint(joint).name.value_or(""))) {
      return "pose " + smurf::quoted(run_.options().pose) + " has " + named.name +
             " outside its limits";
    }
    if (fixed_.joint(joint).mimic) {
      return named.name + " is outside its limits because of the joint that it mimics";
    }
    return "the zero position of " + named.name + " is outside its limits";
  }

  void hang(StageResult& result) {
    if (!has_masses_) return StageRun::skip(result, kNoMasses);
    World world(fixed_, setup());
    Figure gap = run_.figure("gap");
    Figure twist = run_.figure("twist");
    Figure energy = run_.figure("hang-energy");
    const double start = world.energy();
    const bool is_finite = run_.step(world, fixed_, kHangTime, [&] {
      for (std::size_t i = 0; i < fixed_.joints.size(); ++i) {
        const JointError error = world.joint_error(i);
        const auto joint = [&] { return name_of(fixed_, fixed_.joints[i]); };
        run_.note_worst(gap, error.gap, joint);
        run_.note_worst(twist, error.angle, joint);
      }
      run_.note_worst(energy, world.energy() - start, [&] { return fastest(world, fixed_); });
    });
    result.figures = {gap, twist, energy};
    if (!is_finite) return;
    if (!gap.is_within()) {
      report(rules::sml6401_joint_comes_apart, gap, " comes apart when the robot hangs");
    } else if (!twist.is_within()) {
      report(rules::sml6401_joint_comes_apart, twist, " bends when the robot hangs");
    } else if (!energy.is_within()) {
      report(rules::sml6402_energy_grows, energy,
             " gains energy without a cause when the robot hangs");
    }
  }

  void report(const Rule& rule, const Figure& figure, const std::string& what) {
    Diagnostic& diagnostic = run_.sink().report(rule, figure.place, figure.worst + what);
    diagnostic.caret = format_rounded(figure.value, 3) + " " +
                       std::string(bound_info(figure.bound).unit) + ", at most " +
                       format_rounded(figure.limit, 3);
    add_causes(diagnostic);
  }

  /// Known causes for flinging a robot away, independently of its fastest part.
  void add_causes(Diagnostic& diagnostic) const {
    for (const JointPlan& joint : fixed_.joints) {
      if (!is_outside(joint)) continue;
      const std::string unit = joint.kind == JointKind::slider ? " m" : " rad";
      diagnostic.note(name_of(fixed_, joint).name + " starts " +
                      format_rounded(outside_limits(joint), 3) + unit +
                      " outside its limits, which is the likely cause");
    }
    if (stand_ins_ > 0) {
      diagnostic.note(count_of(stand_ins_, "body or joint is", "bodies and joints are") +
                      " not as written, because ODE refuses them: see BUILD");
    }
  }

  void drop(StageResult& result) {
    if (!has_masses_) return StageRun::skip(result, kNoMasses);
    if (!is_free_) return StageRun::skip(result, "the root has no mass: it is a fixed base");
    WorldSetup with_contacts = setup();
    with_contacts.contacts = true;
    World world(whole_, with_contacts);
    const std::optional<double> lowest = world.lowest_point();
    if (!lowest) return StageRun::skip(result, "there is no shape that could touch the ground");
    world.add_ground(*lowest - kDropHeight);
    Figure energy = run_.figure("drop-energy");
    const double start = world.energy();
    const bool is_finite = run_.step(world, whole_, kDropTime, [&] {
      run_.note_worst(energy, world.energy() - start, [&] { return fastest(world, whole_); });
    });
    if (is_finite && !energy.is_within()) report_explosion(energy);
    result.figures = {energy};
  }

  /// Shapes that overlap at the start are the cause, so there is one finding.
  void report_explosion(Figure& energy) {
    if (deepest_ && deepest_->depth > run_.options().bounds["overlap"]) {
      run_.withdraw(rules::sml6201_initial_overlap);
      const ShapePlan& first = whole_.shapes[deepest_->first];
      const ShapePlan& second = whole_.shapes[deepest_->second];
      Diagnostic& diagnostic =
          run_.sink().report(rules::sml6501_contact_explodes, first.place,
                             first.name + " and " + second.name + " push the robot apart");
      diagnostic.caret = format_rounded(deepest_->depth * 1000, 3) + " mm inside at the start";
      diagnostic.label(second.place, "overlaps with this one");
      diagnostic.note("dropped, the robot gains the energy of a fall from " +
                      format_rounded(energy.value, 3) + " m");
      add_causes(diagnostic);
      return;
    }
    report(rules::sml6501_contact_explodes, energy, " is flung away when the robot is dropped");
  }

  const LinkedModel& model_;
  const ShapeFiles& files_;
  StageRun run_;
  JointPositions given_;  ///< of the named pose
  Plan fixed_;            ///< the model with a fixed root and without shapes
  Plan whole_;            ///< with shapes; the root is free if possible
  bool is_free_ = false;
  bool has_masses_ = true;
  std::size_t stand_ins_ = 0;
  std::optional<Overlap> deepest_;
};

}  // namespace

CheckResult check_model(const LinkedModel& model, const ShapeFiles& files,
                        const CheckOptions& options, const OnStage& on_stage) {
  return ModelCheck(model, files, options, on_stage).run();
}

}  // namespace smurf::load_check
