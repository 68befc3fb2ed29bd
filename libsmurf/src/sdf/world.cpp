// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/world.hpp"

#include <algorithm>
#include <numbers>
#include <set>
#include <tuple>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/unique_names.hpp"
#include "imports/traced_yaml.hpp"
#include "sdf/shapes.hpp"
#include "sdf/world_losses.hpp"

namespace smurf::sdformat {
namespace {

constexpr Vector3 kGravityOfSdf{0, 0, -9.8};

/// The systems that each scene for Gazebo has, and that `--format sdf` writes.
constexpr std::string_view kUsualSystems[] = {
    "Physics", "UserCommands", "SceneBroadcaster", "Sensors", "Imu", "Contact", "ForceTorque"};

std::string list_of(const std::vector<double>& numbers) {
  std::string text;
  for (const double one : numbers) text += (text.empty() ? "[" : ", ") + format_number(one);
  return text + "]";
}

std::string mapping_of(std::string_view keys, const std::vector<double>& numbers) {
  std::string text;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    text +=
        (text.empty() ? "{" : ", ") + std::string(1, keys[i]) + ": " + format_number(numbers[i]);
  return text + "}";
}

class WorldWriter {
 public:
  WorldWriter(Model& model, Files& files, Reporter& reporter, World& result)
      : model_(model),
        files_(files),
        reporter_(reporter),
        result_(result),
        frames_(reporter),
        yaml_(result.scene) {}

  void run() {
    Scope& world = model_.scopes.front();
    const std::string path = reporter_.context().sources.path(result_.scene.root);
    file_ = path::file_name(path);
    const Place tag = tag_of(world.element, xacro::kNoFrame);
    find_anchors();
    for (const Vertex* vertex : world.order) names_.take(vertex->name);
    yaml_.part("entities:", tag);
    const bool is_empty =
        std::none_of(world.order.begin(), world.order.end(),
                     [](const Vertex* one) { return one->kind == Vertex::Kind::model; });
    yaml_.plain(is_empty ? " []\n" : "\n");
    for (Vertex* vertex : world.order) {
      if (vertex->kind == Vertex::Kind::model) entity(*vertex);
    }
    physics(world.element);
    lights(world);
    environment(world.element.child("scene"));
    losses(world.element);
    result_.scene.source = reporter_.context().sources.add(path, yaml_.take());
  }

 private:
  /// A model as a URDF, and where its root is.
  struct Part {
    std::string file;
    Pose X_root;
    bool is_fixed = false;
    std::vector<std::tuple<View, Pose>> grounds;  ///< heightmaps, in the frame of the model
  };

  void lost(Span place, std::string message, std::string help,
            std::string_view others = "lost elements") {
    reporter_.lose(place, std::move(message), others).help(std::move(help));
  }

  /// The model of a world that an element is in.
  static const Scope* model_around(const Vertex& vertex) {
    const Scope* at = vertex.scope;
    while (at->outer != nullptr && !at->outer->is_world) at = at->outer;
    return at;
  }

  /// From 1.10 on, a world has joints between its models.
  void find_anchors() {
    for (const Joint& joint : model_.joints) {
      if (!joint.vertex->scope->is_world || !joint.child.link) continue;
      const Vertex& child = *model_.links[*joint.child.link].vertex;
      const Scope* held = model_around(child);
      std::string anchor = "world";
      if (joint.parent.link) {
        const Link& parent = model_.links[*joint.parent.link];
        anchor = parent.name;  // MODEL::LINK, as a scene writes it
      }
      if (joint.type == Joint::Type::fixed && joint.is_in_tree && is_root(*joint.child.link) &&
          anchors_.emplace(held, std::pair(anchor, tag_of(joint.vertex->element, xacro::kNoFrame)))
              .second)
        continue;
      lost(joint.vertex->element.name_span(),
           "between two entities, a scene has fixed joints of a root only, so this joint is lost",
           "put both models and the joint into one model");
    }
  }

  /// Whether no joint of its own model holds a link.
  bool is_root(LinkIndex link) const {
    return std::none_of(model_.joints.begin(), model_.joints.end(), [&](const Joint& joint) {
      return joint.is_in_tree && joint.child.link == link && !joint.vertex->scope->is_world;
    });
  }

  const Part& part_of(const Scope& scope) {
    const Span place = scope.element.name_span();
    const auto [known, is_new] = parts_.try_emplace({place.source, place.begin, scope.is_static});
    Part& part = known->second;
    if (!is_new) return part;
    part.file = std::string(file_) + "#" + scope.name;
    Model model;
    build_part(files_, scope, model);
    resolve(model, reporter_);
    arrange(model, reporter_);
    weigh(model, files_, reporter_);
    const auto root = root_of(model);
    if (root) part.X_root = model.links[*root].X_W;
    part.is_fixed = scope.is_static || !root;
    Frames frames(reporter_);
    for (const Link& link : model.links) add_grounds(model, link, frames, part);
    xacro::Expansion robot;
    robot.root = result_.scene.root;
    robot.language = Language::sdf;
    robot.frames = std::move(model.frames);
    SourceMap& sources = reporter_.context().sources;
    std::string text = write_robot(model, files_, reporter_, robot);
    robot.source = sources.add(sources.path(robot.root), std::move(text));
    robot.is_complete = true;
    result_.models.emplace(part.file, std::move(robot));
    return part;
  }

  /// A heightmap that is seen and touched is one.
  static void add_grounds(const Model& model, const Link& link, Frames& frames, Part& part) {
    if (!becomes_ground(model, link)) return;
    for (const std::string_view kind : {"collision", "visual"}) {
      const std::size_t before = part.grounds.size();
      for (const View owner : link.vertex->element) {
        if (owner.name() != kind) continue;
        const Shape shape = read_shape(owner);
        if (shape.kind != Shape::Kind::heightmap) continue;
        part.grounds.emplace_back(shape.element, link.X_W * pose_of_shape(owner, link, frames));
      }
      if (part.grounds.size() != before) return;
    }
  }

  void pose(const Pose& X, const Place& place) {
    if (X.position != Vector3{})
      yaml_.line("  ", "position", list_of({X.position[0], X.position[1], X.position[2]}), place);
    const Quaternion& q = X.orientation;
    if (to_rpy(q) != Vector3{}) yaml_.line("  ", "rotation", list_of({q.w, q.x, q.y, q.z}), place);
  }

  void entity(Vertex& vertex) {
    const Scope& scope = *vertex.inner;
    const Part& part = part_of(scope);
    const Place tag = tag_of(vertex.element, xacro::kNoFrame);
    const Pose X_WM = frames_.in_world(vertex);
    const Place of_pose = vertex.pose ? place_of(vertex.pose, xacro::kNoFrame) : tag;
    yaml_.line("- ", "name", imports::yaml_text(vertex.name), tag);
    yaml_.line("  ", "type", "urdf", tag);
    yaml_.line("  ", "file", imports::yaml_text(part.file), tag);
    pose(X_WM * part.X_root, of_pose);
    const auto anchor = anchors_.find(&scope);
    if (part.is_fixed) {
      const View is_static = vertex.element.child("static") ? vertex.element : scope.element;
      yaml_.line("  ", "anchor", "world", place_in(is_static, "static", xacro::kNoFrame));
    } else if (anchor != anchors_.end()) {
      yaml_.line("  ", "anchor", imports::yaml_text(anchor->second.first), anchor->second.second);
    }
    for (const auto& [element, X_M] : part.grounds) ground(vertex, scope, element, X_WM * X_M);
  }

  void ground(const Vertex& vertex, const Scope& scope, View map, const Pose& X_WS) {
    const Place tag = tag_of(map, xacro::kNoFrame);
    const View uri = map.child("uri");
    const Vector3 size = vector_in(map, "size", {1, 1, 1});
    const Pose X = X_WS * Pose{vector_in(map, "pos", {}), {}};
    yaml_.line("- ", "name", imports::yaml_text(names_.add(vertex.name + "_heightmap")), tag);
    yaml_.line("  ", "type", "heightmap", tag);
    yaml_.line("  ", "file", imports::yaml_text(files_.resource(text_of(uri), *scope.file)),
               place_of(uri ? uri : map, xacro::kNoFrame), false);
    constexpr std::string_view kSizes[] = {"length", "width", "height"};
    for (std::size_t i = 0; i < 3; ++i)
      yaml_.line("  ", kSizes[i], format_number(size[i]), place_in(map, "size", xacro::kNoFrame));
    pose(X, place_in(map, "pos", xacro::kNoFrame));
    yaml_.line("  ", "anchor", "world", tag);
  }

  void physics(View world) {
    const View settings = world.child("physics");
    // Before 1.6, gravity belonged to the physics.
    const View owner =
        !world.child("gravity") && settings && settings.child("gravity") ? settings : world;
    const Vector3 gravity = vector_in(owner, "gravity", kGravityOfSdf);
    yaml_.part("physics:\n", place_in(owner, "gravity", xacro::kNoFrame));
    yaml_.line("  ", "gravity", mapping_of("xyz", {gravity[0], gravity[1], gravity[2]}),
               place_in(owner, "gravity", xacro::kNoFrame));
    if (!settings) return;
    const View ode = settings.child("ode");
    const View constraints = ode ? ode.child("constraints") : View();
    std::vector<std::tuple<std::string_view, double, Place>> rows;
    constexpr double kMilliseconds = 1000;
    if (settings.child("max_step_size"))
      rows.emplace_back("stepsize", kMilliseconds * number_in(settings, "max_step_size", 0.001),
                        place_in(settings, "max_step_size", xacro::kNoFrame));
    for (const std::string_view name : {"cfm", "erp"}) {
      if (constraints && constraints.child(name))
        rows.emplace_back(name, number_in(constraints, name, 0),
                          place_in(constraints, name, xacro::kNoFrame));
    }
    if (!rows.empty()) yaml_.part("  ode:\n", std::get<Place>(rows.front()));
    for (const auto& [name, value, place] : rows)
      yaml_.line("    ", name, format_number(value), place);
  }

  void lights(Scope& world) {
    bool is_first = true;
    for (const Light& one : model_.lights) {
      if (one.scope != &world) continue;
      if (std::exchange(is_first, false))
        yaml_.part("lights:\n", tag_of(one.include ? one.include : one.element, xacro::kNoFrame));
      light(one);
    }
  }

  void light(const Light& one) {
    const View e = one.element;
    const View named = one.include && one.include.child("name") ? one.include : e;
    const View posed = one.include && one.include.child("pose") ? one.include : e;
    const Place tag = tag_of(one.include ? one.include : e, xacro::kNoFrame);
    const std::string name(named.name() == "include" ? text_in(named, "name")
                                                     : attribute_of(named, "name"));
    Pose X;
    if (const View pose = posed.child("pose")) {
      const auto X_WF =
          frames_.express_late(*one.scope, attribute_of(pose, "relative_to"), pose.name_span());
      X = X_WF.value_or(Pose{}) * pose_in(pose).value_or(Pose{});
    }
    const Place of_pose = place_in(posed, "pose", xacro::kNoFrame);
    const std::string_view type = attribute_of(e, "type");
    yaml_.line("- ", "name", imports::yaml_text(name), tag);
    yaml_.line("  ", "type", type == "spot" ? "2" : "1", tag);
    yaml_.line("  ", "directional", type == "directional" ? "true" : "false", tag);
    const Vector3& at = X.position;
    yaml_.line("  ", "position", mapping_of("xyz", {at[0], at[1], at[2]}), of_pose);
    if (type != "point") {
      const Vector3 way = rotate(X.orientation, vector_in(e, "direction", {0, 0, -1}));
      yaml_.line("  ", "lookat",
                 mapping_of("xyz", {at[0] + way[0], at[1] + way[1], at[2] + way[2]}),
                 place_in(e, "direction", xacro::kNoFrame));
    }
    for (const std::string_view colour : {"diffuse", "specular"}) {
      const View written = e.child(colour);
      const auto rgba = written ? colour_in(text_of(written)) : std::nullopt;
      if (rgba)
        yaml_.line("  ", colour, mapping_of("rgba", {rgba->begin(), rgba->end()}),
                   place_of(written, xacro::kNoFrame));
    }
    if (const View fading = e.child("attenuation")) {
      for (const std::string_view kind : {"constant", "linear", "quadratic"}) {
        // libsdformat reads a negative one, and no light has it.
        if (fading.child(kind) && number_in(fading, kind, 0) >= 0)
          yaml_.line("  ", std::string(kind) + "Attenuation",
                     format_number(number_in(fading, kind, 0)),
                     place_in(fading, kind, xacro::kNoFrame));
      }
    }
    const View spot = e.child("spot");
    if (type != "spot" || !spot) return;
    yaml_.line("  ", "angle",
               format_number(number_in(spot, "outer_angle", 0) * 180 / std::numbers::pi),
               place_in(spot, "outer_angle", xacro::kNoFrame));
    yaml_.line("  ", "exponent", format_number(number_in(spot, "falloff", 0)),
               place_in(spot, "falloff", xacro::kNoFrame));
  }

  void environment(View scene) {
    if (!scene) return;
    const auto colour = [&](View owner, std::string_view name) {
      const View written = owner.child(name);
      return written ? colour_in(text_of(written)) : std::nullopt;
    };
    const auto background = colour(scene, "background");
    const View fog = scene.child("fog");
    if (background || fog) yaml_.part("environment:\n", tag_of(scene, xacro::kNoFrame));
    if (background)
      yaml_.line("  ", "background", mapping_of("rgba", {background->begin(), background->end()}),
                 place_in(scene, "background", xacro::kNoFrame));
    if (fog) yaml_.part("  fog:\n", tag_of(fog, xacro::kNoFrame));
    for (const std::string_view name : {"density", "start", "end"}) {
      if (fog)
        yaml_.line("    ", name, format_number(number_in(fog, name, name == "end" ? 100 : 1)),
                   place_in(fog, name, xacro::kNoFrame));
    }
    if (const auto rgba = fog ? colour(fog, "color") : std::nullopt)
      yaml_.line("    ", "color", mapping_of("rgba", {rgba->begin(), rgba->end()}),
                 place_in(fog, "color", xacro::kNoFrame));
  }

  void losses(View world) {
    for (const LostSetting& one : lost_settings(world)) {
      const std::string_view others = one.is_of_look ? "lost settings" : "lost elements";
      Diagnostic& found = reporter_.lose(
          one.place, "a scene of SMURF has no " + one.what + ", so this one is lost", others);
      found.help("keep the SDF for it");
      if (one.is_of_look) found.severity = Severity::info;
    }
    for (const View one : world) {
      const std::string_view name = attribute_of(one, "name");
      const bool is_usual =
          std::any_of(std::begin(kUsualSystems), std::end(kUsualSystems),
                      [&](std::string_view usual) { return name.ends_with(usual); });
      if (one.name() != "plugin" || is_usual) continue;
      lost(one.name_span(),
           "a scene of SMURF has no plugins of Gazebo, so " + quoted(name) +
               " and others of this world are lost",
           "keep the SDF for them", "lost plugins");
      break;
    }
    bool is_second = false;
    for (const View one : model_.scopes.front().file->root) {
      if (one.name() != "world" || !std::exchange(is_second, true)) continue;
      lost(one.name_span(), "a scene is one world, so this second one is lost",
           "put it into a file of its own");
    }
  }

  Model& model_;
  Files& files_;
  Reporter& reporter_;
  World& result_;
  Frames frames_;
  imports::TracedYaml yaml_;
  std::string file_;
  UniqueNames names_;
  /// By the scope of the model that is held.
  std::map<const Scope*, std::pair<std::string, Place>> anchors_;
  std::map<std::tuple<SourceId, std::uint32_t, bool>, Part> parts_;
};

}  // namespace

void write_world(Model& model, Files& files, Reporter& reporter, World& result) {
  WorldWriter(model, files, reporter, result).run();
}

}  // namespace smurf::sdformat
