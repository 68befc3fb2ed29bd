// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>
#include <map>
#include <set>

#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "smurf-load-check/bodies.hpp"
#include "smurf-load-check/check.hpp"
#include "smurf-load-check/collision_shapes.hpp"
#include "smurf-load-check/environment.hpp"
#include "smurf-load-check/stage_run.hpp"
#include "smurf-load-check/stand_ins.hpp"
#include "smurf-load-check/start.hpp"
#include "smurf/flatten.hpp"

namespace smurf::load_check {
namespace {

constexpr double kAnchorTime = 0.5;  // s
constexpr double kMarsStep = 0.01;   // s, if the scene sets none

/// An anchored model and its anchor, as links of the plan.
struct Anchor {
  std::size_t instance = 0;  ///< of the scene
  std::size_t root = 0;
  std::optional<std::size_t> target;  ///< none: the world
};

class SceneCheck {
 public:
  SceneCheck(const LinkedScene& scene, const SourceMap& sources, const ShapeFiles& files,
             const CheckOptions& options, const OnStage& on_stage)
      : scene_(scene),
        flat_(flatten(scene, sources, {})),
        files_(files),
        run_(options, on_stage, [this] { return suspect(); }) {}

  CheckResult run() {
    run_.stage(Stage::build, [&](StageResult& result) { build(result); });
    run_.stage(Stage::pose0, [&](StageResult& result) { look_at_start(result); });
    run_.stage(Stage::anchor, [&](StageResult& result) { watch_anchors(result); });
    return run_.finish();
  }

 private:
  WorldSetup setup() const {
    WorldSetup setup;
    const FlatPhysics& physics = flat_.physics;
    if (physics.gravity) setup.gravity = to_eigen(*physics.gravity);
    setup.step = run_.options().step.value_or(physics.step_size.value_or(kMarsStep));
    setup.cfm = physics.cfm.value_or(setup.cfm);
    setup.erp = physics.erp.value_or(setup.erp);
    setup.contacts = true;
    setup.stop_margin = run_.stop_margin();
    return setup;
  }

  Named suspect() const {
    const JointPlan* joint = joint_at_stop(plan_);
    return joint != nullptr ? name_of(plan_, *joint)
                            : Named{"", {scene_.scenes.front().source, 0, 0}};
  }

  void build(StageResult& result) {
    plan_ = make_plan(placed_models());
    for (std::size_t i = 0; i < plan_.links.size(); ++i) {
      const LinkPlan& link = plan_.links[i];
      link_index_[{link.instance, link.link}] = i;
    }
    // Faults of a model are reported by the separate check of the model.
    DiagnosticSink of_models;
    result.figures = check_bodies(plan_, run_.options().bounds, of_models);
    add_shapes(plan_, files_, of_models);
    if (of_models.has_errors()) result.verdict = Verdict::fail;
    report_falling_bases();
    const std::size_t stand_ins = add_stand_ins(plan_);
    const std::size_t left_out = add_environment(scene_, flat_, plan_, files_, run_.sink());
    result.note = count_of(plan_.models.size(), "model", "models") + ", " +
                  count_of(plan_.bodies.size(), "moving body", "moving bodies") + ", " +
                  count_of(plan_.shapes.size(), "shape", "shapes");
    if (left_out > 0) result.note += "; " + count_of(left_out, "entity", "entities") + " left out";
    if (stand_ins > 0) {
      result.note +=
          "; " + count_of(stand_ins, "stand-in", "stand-ins") + ", see the checks of the models";
    }
    result.note += plan_.text_on_damping();
  }

  /// The check of a model alone holds a root without mass in place, as a fixed base. In the scene
  /// it moves unless it is anchored, and only the scene can report that it has no mass.
  void report_falling_bases() {
    std::set<const LinkedModel*> reported;
    for (std::size_t i = 0; i < plan_.models.size(); ++i) {
      const PlacedModel& placed = plan_.models[i];
      if (placed.base.kind != Base::Kind::free || is_drawing(i)) continue;
      if (!reported.insert(placed.model).second) continue;
      const std::size_t root = link_index_.at({i, placed.model->tree.roots.front()});
      DiagnosticSink of_root;
      check_mass(plan_, plan_.links[root].body, of_root);
      for (Diagnostic& one : of_root.take()) {
        one.label(place_of(scene_.entity(scene_.instances[instance_of_[i]])),
                  "this entity is free to move");
        one.help("give the link a mass, or anchor the entity, such as by `anchor: world`");
        run_.sink().report(*one.rule, one.span, {}) = std::move(one);
      }
    }
  }

  /// Whether the model has several bodies and no masses, which its own check reports.
  bool is_drawing(std::size_t instance) const {
    std::set<std::size_t> bodies;
    for (const LinkPlan& link : plan_.links) {
      if (link.instance != instance) continue;
      if (plan_.link(link).inertial) return false;
      bodies.insert(link.body);
    }
    return bodies.size() > 1;
  }

  std::vector<PlacedModel> placed_models() {
    std::vector<PlacedModel> placed;
    std::map<std::size_t, std::size_t> number_of;  // by instance of the scene
    for (std::size_t i = 0; i < scene_.instances.size(); ++i) {
      const Instance& instance = scene_.instances[i];
      const LinkedModel* model = scene_.model(instance);
      if (model == nullptr || !model->robot || !instance.X_WE) continue;
      number_of[i] = placed.size();
      instance_of_.push_back(i);
      placed.push_back(
          {model, instance.path, *instance.X_WE, scene_.joint_positions(instance), {}});
    }
    for (std::size_t i = 0; i < placed.size(); ++i) {
      const Attachment& anchor = scene_.instances[instance_of_[i]].placement.anchor;
      placed[i].base = base_of(anchor, number_of);
    }
    return placed;
  }

  Base base_of(const Attachment& anchor, const std::map<std::size_t, std::size_t>& number_of) {
    if (anchor.kind == Attachment::Kind::world) return {.kind = Base::Kind::world};
    if (anchor.kind == Attachment::Kind::none) return {};
    const auto target = number_of.find(to_size(anchor.instance));
    const Instance& instance = scene_.instance(anchor.instance);
    if (target == number_of.end()) return {};
    const auto link = scene_.model(instance)->link_names.find(anchor.link);
    if (!link) return {};
    return {Base::Kind::link, target->second, LinkIndex{*link}};
  }

  void look_at_start(StageResult& result) {
    World world(plan_, setup());
    Figure figure = run_.figure("overlap");
    std::map<std::pair<std::string, std::string>, std::vector<Overlap>> by_pair;
    for (const Overlap& overlap : world.overlaps()) {
      const ShapePlan& first = plan_.shapes[overlap.first];
      const ShapePlan& second = plan_.shapes[overlap.second];
      const bool is_own = first.body != kEnvironment && second.body != kEnvironment &&
                          first.instance == second.instance;
      if (is_own) continue;  // reported by the model's own check
      const Named a = entity_of(first);
      const Named b = entity_of(second);
      run_.note_worst(figure, overlap.depth, [&] {
        return Named{a.name + " and " + b.name, a.place};
      });
      if (overlap.depth > figure.limit) by_pair[{a.name, b.name}].push_back(overlap);
    }
    for (const auto& [names, overlaps] : by_pair) report_overlaps(overlaps);
    result.figures.push_back(figure);
  }

  /// One finding for two entities, because many of their shapes may overlap.
  void report_overlaps(std::span<const Overlap> overlaps) {
    const Overlap& deepest =
        *std::max_element(overlaps.begin(), overlaps.end(),
                          [](const Overlap& a, const Overlap& b) { return a.depth < b.depth; });
    const ShapePlan& first = plan_.shapes[deepest.first];
    const ShapePlan& second = plan_.shapes[deepest.second];
    const Named a = entity_of(first);
    const Named b = entity_of(second);
    Diagnostic& diagnostic =
        run_.sink().report(rules::sml6201_initial_overlap, a.place,
                           a.name + " is " + format_rounded(deepest.depth * 1000, 3) +
                               " mm inside " + b.name + " at the start");
    diagnostic.label(b.place, "overlaps with this one");
    if (first.body != kEnvironment) diagnostic.label(first.place, "with this shape");
    if (second.body != kEnvironment) diagnostic.label(second.place, "and this one");
    if (overlaps.size() == 1) return;
    diagnostic.note(count_of(overlaps.size() - 1, "more pair of their shapes overlaps",
                             "more pairs of their shapes overlap"));
  }

  Named entity_of(const ShapePlan& shape) const {
    if (shape.body == kEnvironment) return {shape.name, shape.place};
    return named_instance(instance_of_[shape.instance]);
  }

  Named named_instance(std::size_t index) const {
    const Instance& instance = scene_.instances[index];
    return {"entity `" + instance.path + "`", place_of(scene_.entity(instance))};
  }

  std::vector<Anchor> anchors() const {
    std::vector<Anchor> all;
    for (std::size_t i = 0; i < plan_.models.size(); ++i) {
      const PlacedModel& placed = plan_.models[i];
      if (placed.base.kind == Base::Kind::free) continue;
      Anchor anchor;
      anchor.instance = instance_of_[i];
      anchor.root = link_index_.at({i, placed.model->tree.roots.front()});
      if (placed.base.kind == Base::Kind::link) {
        anchor.target = link_index_.at({placed.base.instance, placed.base.link});
      }
      all.push_back(anchor);
    }
    return all;
  }

  void watch_anchors(StageResult& result) {
    const std::vector<Anchor> watched = anchors();
    if (watched.empty()) return StageRun::skip(result, "no entity is anchored");
    World world(plan_, setup());
    const auto pose_of = [&](const Anchor& anchor) -> Pose {
      const Pose X_WR = world.link_pose(plan_.links[anchor.root]);
      if (!anchor.target) return X_WR;
      return inverse(world.link_pose(plan_.links[*anchor.target])) * X_WR;
    };
    std::vector<Pose> start;
    for (const Anchor& anchor : watched) start.push_back(pose_of(anchor));
    Figure figure = run_.figure("anchor");
    const bool is_finite = run_.step(world, plan_, kAnchorTime, [&] {
      for (std::size_t i = 0; i < watched.size(); ++i) {
        run_.note_worst(figure, way_between(start[i], pose_of(watched[i])),
                        [&] { return named_instance(watched[i].instance); });
      }
    });
    if (is_finite && !figure.is_within()) {
      run_.sink()
          .report(rules::sml6601_anchor_moves, figure.place,
                  figure.worst + " moves relative to its anchor")
          .caret = "by " + format_rounded(figure.value, 3) + " m";
    }
    result.note = count_of(watched.size(), "anchor", "anchors");
    result.figures.push_back(figure);
  }

  const LinkedScene& scene_;
  FlatScene flat_;
  const ShapeFiles& files_;
  StageRun run_;
  Plan plan_;
  std::vector<std::size_t> instance_of_;  ///< instances of the scene by model of the plan
  std::map<std::pair<std::size_t, LinkIndex>, std::size_t> link_index_;
};

}  // namespace

CheckResult check_scene(const LinkedScene& scene, const SourceMap& sources, const ShapeFiles& files,
                        const CheckOptions& options, const OnStage& on_stage) {
  return SceneCheck(scene, sources, files, options, on_stage).run();
}

}  // namespace smurf::load_check
