// SPDX-License-Identifier: BSD-3-Clause
// OpenUSD as text, a preview: an Xform an entity, in it an Xform a link, in it its shapes.
#include <cmath>
#include <set>

#include "base/numbers.hpp"
#include "write/json_text.hpp"
#include "write/placed_shapes.hpp"
#include "write/scene_losses.hpp"
#include "write/scene_parts.hpp"

namespace smurf {
namespace {

std::string tuple(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + format_number(value);
  return text + ")";
}

std::string tuple(const Vector3& vector) { return tuple({vector[0], vector[1], vector[2]}); }

std::string quoted(std::string_view text) {
  std::string out;
  append_json(out, text);
  return out;
}

class UsdaWriter {
 public:
  explicit UsdaWriter(const SceneExport& scene)
      : scene_(scene), losses_(scene, "USD"), names_(safe_names(scene.flat)) {}

  std::string run() {
    line("#usda 1.0");
    line("(");
    line("    defaultPrim = \"World\"");
    line("    metersPerUnit = 1");
    line("    upAxis = \"Z\"");
    line(")");
    line("");
    add_physics();
    open("Xform", "World");
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (scene_.flat.instances[i].X_WE) add_instance(i);
    }
    close();
    using enum SceneLosses::World;
    losses_.world({step_size, solver, environment, lights});
    losses_.annotations_and_properties();
    return std::move(out_);
  }

 private:
  void line(std::string_view text) {
    if (!text.empty()) out_.append(4 * depth_, ' ');
    out_ += text;
    out_ += '\n';
  }

  void open(std::string_view type, std::string_view name) {
    line("def " + std::string(type) + " \"" + std::string(name) + "\"");
    line("{");
    ++depth_;
  }

  void close() {
    --depth_;
    line("}");
  }

  void add_pose(const Pose& pose, const Vector3& scale = {1, 1, 1}) {
    const Quaternion& q = pose.orientation;
    line("double3 xformOp:translate = " + tuple(pose.position));
    line("quatd xformOp:orient = " + tuple({q.w, q.x, q.y, q.z}));
    const bool is_scaled = scale != Vector3{1, 1, 1};
    if (is_scaled) line("double3 xformOp:scale = " + tuple(scale));
    line("uniform token[] xformOpOrder = [\"xformOp:translate\", \"xformOp:orient\"" +
         std::string(is_scaled ? ", \"xformOp:scale\"]" : "]"));
  }

  void add_physics() {
    if (!scene_.flat.physics.gravity) return;
    const Vector3& g = *scene_.flat.physics.gravity;
    const double magnitude = std::hypot(g[0], g[1], g[2]);
    open("PhysicsScene", "Physics");
    if (magnitude > 0) {
      line("vector3f physics:gravityDirection = " +
           tuple({g[0] / magnitude, g[1] / magnitude, g[2] / magnitude}));
    }
    line("float physics:gravityMagnitude = " + format_number(magnitude));
    close();
  }

  void add_instance(std::size_t index) {
    const FlatInstance& instance = scene_.flat.instances[index];
    open("Xform", names_[index]);
    add_pose(*instance.X_WE);
    line("custom string smurf:path = " + quoted(instance.path));
    line("custom string smurf:type = " + quoted(instance.type));
    line("custom string smurf:anchor = " + quoted(anchor(instance)));
    std::set<std::string> taken;
    for (const ShownLink& link : shown_links(scene_, index, frames_)) {
      if (instance.model) {
        open("Xform", unique(link.name, taken));
        add_pose(link.X_EL);
        line("custom string smurf:link = " + quoted(link.name));
      }
      std::size_t number = 0;
      for (const LinkShape& shape : link.shapes) {
        add_shape(shape, "shape_" + std::to_string(++number));
      }
      if (instance.model) close();
    }
    close();
  }

  static std::string anchor(const FlatInstance& instance) {
    switch (instance.anchor.kind) {
    case Attachment::Kind::none: return "none";
    case Attachment::Kind::world: return "world";
    case Attachment::Kind::link: break;
    }
    return instance.anchor.instance + "::" + instance.anchor.link;
  }

  /// A prim's name, not yet used by its siblings.
  static std::string unique(std::string_view link, std::set<std::string>& taken) {
    const std::string base = safe_name(link);
    std::string name = base;
    for (int number = 2; !taken.insert(name).second; ++number) {
      name = base + "_" + std::to_string(number);
    }
    return name;
  }

  void add_shape(const LinkShape& shape, const std::string& name) {
    Vector3 scale{1, 1, 1};
    if (const auto* box = std::get_if<FlatBox>(&shape.geometry)) {
      open("Cube", name);
      line("double size = 1");
      scale = box->size;
    } else if (const auto* sphere = std::get_if<FlatSphere>(&shape.geometry)) {
      open("Sphere", name);
      line("double radius = " + format_number(sphere->radius));
    } else if (const auto* cylinder = std::get_if<FlatCylinder>(&shape.geometry)) {
      open_round("Cylinder", name, cylinder->radius, cylinder->length);
    } else if (const auto* capsule = std::get_if<FlatCapsule>(&shape.geometry)) {
      open_round("Capsule", name, capsule->radius, capsule->length);
    } else if (const auto* plane = std::get_if<FlatPlane>(&shape.geometry)) {
      open("Plane", name);
      line("uniform token axis = \"Z\"");
      line("double length = " + format_number(plane->width));  // USD's length is along y
      line("double width = " + format_number(plane->length));
    } else {
      report(shape);
      return;
    }
    add_pose(shape.X_LS, scale);
    if (shape.color) {
      const Rgba& c = *shape.color;
      line("color3f[] primvars:displayColor = [" + tuple({c[0], c[1], c[2]}) + "]");
      if (c[3] < 1) line("float[] primvars:displayOpacity = [" + format_number(c[3]) + "]");
    }
    close();
  }

  void open_round(std::string_view type, const std::string& name, double radius, double height) {
    open(type, name);
    line("uniform token axis = \"Z\"");
    line("double radius = " + format_number(radius));
    line("double height = " + format_number(height));
  }

  void report(const LinkShape& shape) {
    if (!reported_.insert({to_size(shape.span.source), shape.span.begin}).second) return;
    const bool is_mesh = std::holds_alternative<FlatMesh>(shape.geometry);
    losses_.shape(shape.span,
                  is_mesh ? "the mesh, which would have to be converted," : "the heightmap");
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  LinkFrames frames_;
  std::string out_;
  std::size_t depth_ = 0;
  std::set<std::pair<std::size_t, std::size_t>> reported_;  ///< shapes, by source and place
};

}  // namespace

extern constinit const SceneFormat scene_usda{
    .name = "usda",
    .help = "an OpenUSD preview with the shapes of the models",
    .write = [](const SceneExport& scene) { return UsdaWriter(scene).run(); }};

}  // namespace smurf
