// SPDX-License-Identifier: BSD-3-Clause
// OpenUSD as text, a preview: an Xform an entity, in it an Xform a link, in it its shapes.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/exact_math.hpp"
#include "base/floating.hpp"
#include "base/misread.hpp"
#include "base/numbers.hpp"
#include "base/path.hpp"
#include "base/unique_names.hpp"
#include "base/utf8.hpp"
#include "write/placed_shapes.hpp"
#include "write/preview_meshes.hpp"
#include "write/scene_losses.hpp"
#include "write/scene_parts.hpp"

namespace smurf {
namespace {

std::string tuple(std::initializer_list<double> values) {
  std::string text = "(";
  for (const double value : values) text += (text.size() > 1 ? ", " : "") + format_number(value);
  return text + ")";
}

/// The shortest text that reads back as the same number of single precision.
std::string tuple(const std::array<float, 3>& point) {
  std::string text = "(";
  for (const float coordinate : point) {
    text += (text.size() > 1 ? ", " : "") + shortest(coordinate);
  }
  return text + ")";
}

std::string tuple(const Vector3& vector) { return tuple({vector[0], vector[1], vector[2]}); }

/// A byte as three octal digits: after an `x` USD would take any number of them.
void append_octal(std::string& out, char byte) {
  const auto value = static_cast<unsigned char>(byte);
  out += '\\';
  for (const unsigned shift : {6U, 3U, 0U}) out += static_cast<char>('0' + (value >> shift & 7U));
}

/// USD knows the escapes of C strings. Characters that are misread are written byte by byte.
std::string quoted(std::string_view text) {
  const std::string clean = utf8::replace_controls(text);
  std::string out = "\"";
  for (std::size_t at = 0; at < clean.size();) {
    const utf8::CodePoint point = utf8::decode(std::string_view(clean).substr(at));
    const std::string_view character = std::string_view(clean).substr(at, point.size);
    switch (point.value) {
    case '\n': out += "\\n"; break;
    case '\t': out += "\\t"; break;
    case '"':
    case '\\': out += '\\'; [[fallthrough]];
    default:
      if (is_misread(clean, at, point.value)) {
        for (const char byte : character) append_octal(out, byte);
      } else {
        out += character;
      }
    }
    at += point.size;
  }
  return out + "\"";
}

/// "(0, 0, 0), ", and "0, " with a third of the "3, " that counts the corners.
constexpr PreviewMeshes::Cost kCost{11, 4};

class UsdaWriter {
 public:
  explicit UsdaWriter(const SceneExport& scene)
      : scene_(scene),
        losses_(scene, SceneColumn::usda, "USD"),
        names_(safe_names(scene.flat)),
        files_(scene, kCost) {}

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
    add_meshes();
    losses_.table();
    return std::move(out_);
  }

 private:
  void line(std::string_view text) {
    if (!text.empty()) out_.append(4 * depth_, ' ');
    out_ += text;
    out_ += '\n';
  }

  void open(std::string_view type, std::string_view name, std::string_view metadata = {}) {
    line("def " + std::string(type) + " \"" + std::string(name) + "\"" +
         (metadata.empty() ? "" : " (" + std::string(metadata) + ")"));
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
    const double magnitude = hypotenuse(g[0], g[1], g[2]);
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
    UniqueNames taken;
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
  static std::string unique(std::string_view link, UniqueNames& taken) {
    return taken.add(safe_name(link));
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
    } else if (const Mesh* mesh = mesh_of(shape)) {
      open("Mesh", name, "references = </Meshes/" + mesh->name + ">");
      scale = std::get<FlatMesh>(shape.geometry).scale;
    } else {
      return;
    }
    add_pose(shape.X_LS, scale);
    if (shape.color) {
      const Rgba c = linear_color(*shape.color);
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

  /// A file that shapes refer to.
  struct Mesh {
    std::string name;
    std::string text;  ///< its attributes, a line each
    std::string why_none;
  };

  /// Null when the shape has no triangles; that was reported.
  const Mesh* mesh_of(const LinkShape& shape) {
    const auto* geometry = std::get_if<FlatMesh>(&shape.geometry);
    if (geometry == nullptr) {
      losses_.unseen_shape(shape.span, shape.geometry, {});
      return nullptr;
    }
    const std::string& file = files_.first_name(geometry->file);
    const auto [known, is_new] = mesh_of_file_.try_emplace(file, meshes_.size());
    if (is_new) meshes_.push_back(read_mesh(file, shape.span));
    const Mesh& mesh = meshes_[known->second];
    if (mesh.why_none.empty()) return &mesh;
    losses_.unseen_shape(shape.span, shape.geometry, mesh.why_none);
    return nullptr;
  }

  Mesh read_mesh(const std::string& file, Span place) {
    const MeshTriangles triangles = files_.read(file, place);
    if (!triangles.reason.empty()) return {{}, {}, triangles.reason};
    const auto append = [](std::string& list, const std::string& item) {
      list += (list.ends_with('[') ? "" : ", ") + item;
    };
    std::string points = "point3f[] points = [";
    std::array<float, 3> low = triangles.points.front();
    std::array<float, 3> high = low;
    for (const std::array<float, 3>& point : triangles.points) {
      append(points, tuple(point));
      for (std::size_t i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], point[i]);
        high[i] = std::max(high[i], point[i]);
      }
    }
    std::string counts = "int[] faceVertexCounts = [";
    std::string indices = "int[] faceVertexIndices = [";
    for (std::size_t i = 0; i < triangles.indices.size(); ++i) {
      if (i % 3 == 0) append(counts, "3");
      append(indices, std::to_string(triangles.indices[i]));
    }
    const std::string extent = "float3[] extent = [" + tuple(low) + ", " + tuple(high) + "]";
    return {unique(path::stem(file), mesh_names_),
            extent + "\n" + points + "]\n" + counts + "]\n" + indices + "]\n",
            {}};
  }

  /// What shapes refer to stands beside the world, so that it is not seen by itself.
  void add_meshes() {
    if (mesh_names_.empty()) return;
    line("class \"Meshes\"");
    line("{");
    ++depth_;
    for (const Mesh& mesh : meshes_) {
      if (!mesh.why_none.empty()) continue;
      open("Mesh", mesh.name);
      line("uniform token subdivisionScheme = \"none\"");
      for (std::size_t begin = 0; begin < mesh.text.size();) {
        const std::size_t end = mesh.text.find('\n', begin);
        line(std::string_view(mesh.text).substr(begin, end - begin));
        begin = end + 1;
      }
      close();
    }
    close();
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  LinkFrames frames_;
  std::string out_;
  std::size_t depth_ = 0;
  PreviewMeshes files_;
  std::vector<Mesh> meshes_;
  std::map<std::string, std::size_t> mesh_of_file_;
  UniqueNames mesh_names_;
};

}  // namespace

extern constinit const SceneFormat scene_usda{
    .name = "usda",
    .help = "an OpenUSD preview with the shapes of the models",
    .write = [](const SceneExport& scene) { return UsdaWriter(scene).run(); },
    .repeats_models = true};

}  // namespace smurf
