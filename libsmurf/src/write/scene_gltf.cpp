// SPDX-License-Identifier: BSD-3-Clause
// A preview as glTF 2.0: one node per entity, in it one node per link, in it the shapes. The root
// node turns the z axis of SMURF to the y axis, which is up in glTF. All poses below it are those
// of SMURF.
#include <limits>
#include <map>
#include <variant>

#include "base/numbers/bits.hpp"
#include "base/numbers/numbers.hpp"
#include "write/losses/scene_losses.hpp"
#include "write/pages/preview_meshes.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/placed_shapes.hpp"
#include "write/parts/unit_meshes.hpp"
#include "write/text/base64.hpp"
#include "write/text/json_text.hpp"

namespace smurf::scene_gltf_file {
namespace {

/// Three numbers of four bytes, and an index of two, in base64.
constexpr PreviewMeshes::Cost kCost{16, 2};

class GltfWriter {
 public:
  explicit GltfWriter(const SceneExport& scene)
      : scene_(scene), losses_(scene, SceneColumn::gltf, "glTF"), files_(scene, kCost) {}

  std::string run() {
    std::vector<std::size_t> roots;
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (scene_.flat.instances[i].X_WE) roots.push_back(add_instance(i));
    }
    losses_.table();
    return text(roots);
  }

 private:
  /// Points that several meshes share: of a solid, or of a mesh file.
  using Points = std::variant<UnitShape, std::string>;
  /// Triangles of one colour.
  struct Part {
    std::size_t indices = 0;
    std::optional<Rgba> color;
  };
  struct Accessors {
    std::size_t points = 0, indices = 0;
    std::vector<Part> parts;  ///< the file has colours
    std::optional<std::size_t> normals;
    std::string why_none;
    bool has_textures = false;
  };

  static void append_pose(std::string& node, const Pose& pose) {
    if (pose.position != Vector3{0, 0, 0}) {
      append_key(node, "translation");
      append_json(node, pose.position);
    }
    const Quaternion& q = pose.orientation;
    if (q == Quaternion{}) return;
    append_key(node, "rotation");
    node += '[' + format_number(q.x) + ", " + format_number(q.y) + ", " + format_number(q.z) +
            ", " + format_number(q.w) + ']';
  }

  static void append_children(std::string& node, const std::vector<std::size_t>& children) {
    if (children.empty()) return;
    append_key(node, "children");
    node += '[';
    for (std::size_t i = 0; i < children.size(); ++i) {
      node += (i > 0 ? ", " : "") + std::to_string(children[i]);
    }
    node += ']';
  }

  std::size_t add_node(std::string node) {
    nodes_.push_back(std::move(node) + "}");
    return nodes_.size() - 1;
  }

  static std::string start_node(std::string_view name, const Pose& pose) {
    std::string node = "{";
    append_key(node, "name", true);
    append_json(node, name);
    append_pose(node, pose);
    return node;
  }

  std::size_t add_instance(std::size_t index) {
    const FlatInstance& instance = scene_.flat.instances[index];
    std::vector<std::size_t> children;
    for (const ShownLink& link : shown_links(scene_, index, frames_, colors_)) {
      std::vector<std::size_t> shapes;
      for (const LinkShape& shape : link.shapes) add_shape(shape, shapes);
      if (!instance.model) {
        children = std::move(shapes);
        break;
      }
      std::string node = start_node(link.name, link.X_EL);
      append_children(node, shapes);
      children.push_back(add_node(std::move(node)));
    }
    std::string node = start_node(instance.path, *instance.X_WE);
    append_children(node, children);
    append_extras(node, instance);
    return add_node(std::move(node));
  }

  /// Extra data without an equivalent in glTF, in little space.
  static void append_extras(std::string& node, const FlatInstance& instance) {
    append_key(node, "extras");
    node += '{';
    append_key(node, "type", true);
    append_json(node, instance.type);
    append_key(node, "anchor");
    switch (instance.anchor.kind) {
    case Attachment::Kind::none: append_json(node, "none"); break;
    case Attachment::Kind::world: append_json(node, "world"); break;
    case Attachment::Kind::link:
      append_json(node, instance.anchor.instance + "::" + instance.anchor.link);
    }
    node += '}';
  }

  void add_shape(const LinkShape& shape, std::vector<std::size_t>& nodes) {
    const auto add = [&](const Points& points, const Pose& X_LS, const Vector3& scale) {
      std::string node = start_node("shape", X_LS);
      if (scale != Vector3{1, 1, 1}) {
        append_key(node, "scale");
        append_json(node, scale);
      }
      append_key(node, "mesh");
      node += std::to_string(mesh_of(points, shape.color));
      nodes.push_back(add_node(std::move(node)));
    };
    const std::vector<PlacedSolid> solids = solids_of(shape.geometry);
    for (const PlacedSolid& one : solids) add(one.solid, shape.X_LS * one.X_GS, one.scale);
    if (!solids.empty()) return;
    const auto* mesh = std::get_if<FlatMesh>(&shape.geometry);
    if (mesh == nullptr) return losses_.unseen_shape(shape.span, shape.geometry, {});
    const std::string& file = files_.first_name(mesh->file);
    const Accessors& accessors = accessors_of(file, shape.span);
    const std::string& reason = accessors.why_none;
    if (!reason.empty()) return losses_.unseen_shape(shape.span, shape.geometry, reason);
    if (accessors.has_textures && !shape.color) losses_.note("textures", shape.span, mesh->file);
    add(file, shape.X_LS, mesh->scale);
  }

  /// A mesh for every pair of points and colour. Without normals, a viewer shows flat triangles.
  std::size_t mesh_of(const Points& points, const std::optional<Rgba>& color) {
    const auto [known, is_new] = meshes_.try_emplace({points, color}, meshes_.size());
    if (!is_new) return known->second;
    const Accessors& accessors = accessors_of(points);
    std::string mesh;
    if (color || accessors.parts.empty()) {
      mesh = primitive(accessors, accessors.indices, color);
    } else {
      for (const Part& part : accessors.parts) {
        mesh += (mesh.empty() ? "" : ", ") + primitive(accessors, part.indices, part.color);
      }
    }
    mesh = "{\"primitives\": [" + mesh + "]}";
    mesh_texts_.push_back(std::move(mesh));
    return known->second;
  }

  std::string primitive(const Accessors& accessors, std::size_t indices,
                        const std::optional<Rgba>& color) {
    std::string text = "{\"attributes\": {\"POSITION\": " + std::to_string(accessors.points);
    if (accessors.normals) text += ", \"NORMAL\": " + std::to_string(*accessors.normals);
    text += "}, \"indices\": " + std::to_string(indices);
    return text + ", \"material\": " + std::to_string(material_of(color)) + "}";
  }

  std::size_t material_of(const std::optional<Rgba>& color) {
    const auto [known, is_new] = materials_.try_emplace(color, materials_.size());
    if (!is_new) return known->second;
    const Rgba rgba = linear_color(color.value_or(Rgba{0.85, 0.85, 0.85, 1}));
    std::string material = "{\"pbrMetallicRoughness\": {\"baseColorFactor\": [";
    for (std::size_t i = 0; i < rgba.size(); ++i) {
      material += (i > 0 ? ", " : "") + format_number(rgba[i]);
    }
    material += "], \"metallicFactor\": 0}";
    if (rgba[3] < 1) material += ", \"alphaMode\": \"BLEND\"";
    material_texts_.push_back(material + "}");
    return known->second;
  }

  /// `place` is the place of a shape that uses a file.
  const Accessors& accessors_of(const Points& points, Span place = {}) {
    const auto [known, is_new] = points_.try_emplace(points);
    if (!is_new) return known->second;
    if (const auto* solid = std::get_if<UnitShape>(&points)) {
      known->second = add_solid(*solid);
    } else {
      known->second = add_file(std::get<std::string>(points), place);
    }
    return known->second;
  }

  Accessors add_solid(UnitShape solid) {
    const TriangleMesh mesh = unit_mesh(solid);
    Accessors accessors;
    accessors.points = add_vectors(mesh.points, true);
    accessors.normals = add_vectors(mesh.normals, false);
    accessors.indices = add_indices<std::uint16_t>(mesh.indices);
    return accessors;
  }

  Accessors add_file(const std::string& file, Span place) {
    Accessors accessors;
    const MeshTriangles mesh = files_.read(file, place);
    accessors.why_none = mesh.reason;
    accessors.has_textures = mesh.has_textures;
    if (!mesh.reason.empty()) return accessors;
    accessors.points = add_vectors(mesh.points, true);
    // Some readers treat the greatest index of a type as a special value.
    const bool is_small = mesh.points.size() <= std::numeric_limits<std::uint16_t>::max();
    accessors.indices = is_small ? add_indices<std::uint16_t>(mesh.indices)
                                 : add_indices<std::uint32_t>(mesh.indices);
    if (!has_colors(mesh.parts)) return accessors;
    const std::size_t view = views_.size() - 1;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
      const std::size_t begin = mesh.parts[i].first_index;
      const std::size_t end =
          i + 1 < mesh.parts.size() ? mesh.parts[i + 1].first_index : mesh.indices.size();
      const std::size_t size = is_small ? 2 : 4;
      const std::size_t indices = add_accessor(view, begin * size, size, end - begin);
      accessors.parts.push_back({indices, mesh.parts[i].color});
    }
    return accessors;
  }

  template <class Written, class Index>
  std::size_t add_indices(const std::vector<Index>& indices) {
    const std::size_t start = buffer_.size();
    for (const Index index : indices) append_bytes(buffer_, static_cast<Written>(index));
    add_view(start, "34963");  // ELEMENT_ARRAY_BUFFER
    return add_accessor(views_.size() - 1, 0, sizeof(Written), indices.size());
  }

  /// Indices of `size` bytes each in a view.
  std::size_t add_accessor(std::size_t view, std::size_t offset, std::size_t size,
                           std::size_t count) {
    accessors_.push_back("{\"bufferView\": " + std::to_string(view) +
                         (offset > 0 ? ", \"byteOffset\": " + std::to_string(offset) : "") +
                         ", \"componentType\": " + (size == 2 ? "5123" : "5125") +
                         ", \"type\": \"SCALAR\", \"count\": " + std::to_string(count) + "}");
    return accessors_.size() - 1;
  }

  void add_view(std::size_t start, std::string_view target) {
    views_.push_back("{\"buffer\": 0, \"byteOffset\": " + std::to_string(start) +
                     ", \"byteLength\": " + std::to_string(buffer_.size() - start) +
                     ", \"target\": " + std::string(target) + "}");
    buffer_.resize((buffer_.size() + 3) / 4 * 4);  // accessors are aligned
  }

  std::size_t add_vectors(const std::vector<std::array<float, 3>>& vectors, bool with_bounds) {
    const std::size_t start = buffer_.size();
    std::array<float, 3> least = vectors.front();
    std::array<float, 3> most = vectors.front();
    for (const std::array<float, 3>& vector : vectors) {
      for (std::size_t i = 0; i < 3; ++i) {
        append_bytes(buffer_, bit_cast<std::uint32_t>(vector[i]));
        least[i] = std::min(least[i], vector[i]);
        most[i] = std::max(most[i], vector[i]);
      }
    }
    add_view(start, "34962");  // ARRAY_BUFFER
    std::string accessor = "{\"bufferView\": " + std::to_string(views_.size() - 1) +
                           ", \"componentType\": 5126, \"type\": \"VEC3\", \"count\": " +
                           std::to_string(vectors.size());
    if (with_bounds) {
      append_key(accessor, "min");
      append_json(accessor, Vector3{least[0], least[1], least[2]});
      append_key(accessor, "max");
      append_json(accessor, Vector3{most[0], most[1], most[2]});
    }
    accessors_.push_back(accessor + "}");
    return accessors_.size() - 1;
  }

  static void append_list(std::string& out, std::string_view name,
                          const std::vector<std::string>& items) {
    if (items.empty()) return;
    out += ",\n  \"" + std::string(name) + "\": [";
    for (std::size_t i = 0; i < items.size(); ++i) {
      out += (i > 0 ? ",\n    " : "\n    ") + items[i];
    }
    out += "\n  ]";
  }

  std::string text(const std::vector<std::size_t>& roots) {
    std::string world = R"({"name": "world")";
    append_pose(world, {{}, from_rpy_degrees({-90, 0, 0})});
    append_children(world, roots);
    const std::size_t root = add_node(std::move(world));
    std::string out =
        "{\n  \"asset\": {\"version\": \"2.0\", \"generator\": \"smurfs-flatten\"},\n";
    out += "  \"scene\": 0,\n  \"scenes\": [{\"nodes\": [" + std::to_string(root) + "]}]";
    append_list(out, "nodes", nodes_);
    append_list(out, "meshes", mesh_texts_);
    append_list(out, "materials", material_texts_);
    append_list(out, "accessors", accessors_);
    append_list(out, "bufferViews", views_);
    if (!buffer_.empty()) {
      out += ",\n  \"buffers\": [{\"byteLength\": " + std::to_string(buffer_.size()) +
             ", \"uri\": \"data:application/octet-stream;base64," + base64(buffer_) + "\"}]";
    }
    return out + "\n}\n";
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  PreviewMeshes files_;
  LinkFrames frames_;
  AnnotatedColors colors_;
  std::vector<std::string> nodes_, mesh_texts_, material_texts_, accessors_, views_;
  std::string buffer_;
  std::map<std::pair<Points, std::optional<Rgba>>, std::size_t> meshes_;
  std::map<std::optional<Rgba>, std::size_t> materials_;
  std::map<Points, Accessors> points_;
};

}  // namespace

extern constinit const SceneFormat scene_gltf{
    .name = "gltf",
    .help = "a glTF 2.0 preview with the shapes of the models",
    .write = [](const SceneExport& scene) { return GltfWriter(scene).run(); },
    .repeats_models = true};

}  // namespace smurf::scene_gltf_file
