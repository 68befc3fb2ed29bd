// SPDX-License-Identifier: BSD-3-Clause
// OpenUSD as text: an Xform per entity, which contains an Xform per link, which contains its
// shapes; and UsdPhysics.
#include <algorithm>
#include <map>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/unique_names.hpp"
#include "write/pages/preview_meshes.hpp"
#include "write/parts/annotated_colors.hpp"
#include "write/parts/contacts.hpp"
#include "write/parts/placed_shapes.hpp"
#include "write/usd/usd_filters.hpp"
#include "write/usd/usd_lights.hpp"
#include "write/usd/usd_physics.hpp"

namespace smurf::scene_usda_file {
namespace {

/// "(0, 0, 0), ", and "0, " plus a third of the "3, " for the number of corners.
constexpr PreviewMeshes::Cost kCost{11, 4};

constexpr std::string_view kFilteredPairs = "PhysicsFilteredPairsAPI";

std::vector<std::string> schemas_of_body() { return {"PhysicsRigidBodyAPI", "PhysicsMassAPI"}; }

class UsdaWriter {
 public:
  explicit UsdaWriter(const SceneExport& scene)
      : scene_(scene),
        losses_(scene, SceneColumn::usda, "USD"),
        names_(safe_names(scene.flat)),
        text_(scene.most_bytes),
        physics_(scene, names_, losses_, text_),
        filters_(scene),
        files_(scene, kCost) {}

  std::string run() {
    text_.line("#usda 1.0");
    text_.line("(");
    text_.line("    defaultPrim = \"World\"");
    text_.line("    kilogramsPerUnit = 1");
    text_.line("    metersPerUnit = 1");
    text_.line("    upAxis = \"Z\"");
    text_.line(")");
    text_.line("");
    physics_.add_scene();
    text_.open("Xform", "World");
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      if (!scene_.flat.instances[i].X_WE) continue;
      if (robot_of(scene_.scene, i) != nullptr) {
        add_robot(i);
      } else {
        add_other(i);
      }
    }
    UniqueNames taken;
    for (const std::string& name : names_) taken.take(name);
    add_usd_lights(scene_, taken.add("lights"), text_);
    text_.close();
    add_meshes();
    losses_.table();
    return text_.take();
  }

 private:
  void open_entity(std::size_t index, const std::vector<std::string>& schemas) {
    const FlatInstance& instance = scene_.flat.instances[index];
    text_.open("Xform", names_[index], schemas);
    text_.pose(*instance.X_WE);
    text_.line("custom string smurf:path = " + UsdaText::quoted(instance.path));
    text_.line("custom string smurf:type = " + UsdaText::quoted(instance.type));
    text_.line("custom string smurf:anchor = " + UsdaText::quoted(anchor(instance)));
  }

  static std::string anchor(const FlatInstance& instance) {
    switch (instance.anchor.kind) {
    case Attachment::Kind::none: return "none";
    case Attachment::Kind::world: return "world";
    case Attachment::Kind::link: break;
    }
    return instance.anchor.instance + "::" + instance.anchor.link;
  }

  void add_robot(std::size_t index) {
    const UsdLayout& layout = physics_.layout_of(index);
    open_entity(index, physics_.schemas_of_robot(index));
    physics_.add_articulation(index);
    materials_ = "/World/" + names_[index] + "/" + layout.materials;
    const auto& X_EL = frames_of(scene_, index, frames_);
    for (std::size_t link = 0; link < layout.links.size() && !text_.is_full(); ++link) {
      if (!layout.is_body(link)) continue;
      const std::vector<std::string> apart = untouched_bodies(index, link);
      std::vector<std::string> schemas = schemas_of_body();
      if (!apart.empty()) schemas.emplace_back(kFilteredPairs);
      open_link(index, link, *X_EL[link], schemas);
      physics_.add_mass(index, link);
      add_filter(apart);
      add_shapes(index, link);
      for (const std::size_t frame : layout.frames[link]) {
        open_link(index, frame, layout.links[frame]->X_BL, {});
        add_shapes(index, frame);
        text_.close();
      }
      text_.close();
    }
    physics_.add_joints(index, frames_);
    add_materials(layout.materials);
    text_.close();
  }

  void open_link(std::size_t index, std::size_t link, const Pose& pose,
                 const std::vector<std::string>& schemas) {
    text_.open("Xform", path::file_name(physics_.layout_of(index).links[link]->path), schemas);
    text_.pose(pose);
    const urdf::Link& written = robot_of(scene_.scene, index)->robot->links[link];
    text_.line("custom string smurf:link = " + UsdaText::quoted(written.name.value_or({})));
  }

  /// Collisions are visible if there are no visuals.
  void add_shapes(std::size_t index, std::size_t link) {
    const LinkedModel& model = *robot_of(scene_.scene, index);
    const urdf::Link& written = model.robot->links[link];
    const FlatModel& flat = scene_.flat.models[*scene_.flat.instances[index].model];
    std::size_t number = 0;
    const auto add = [&](const auto& part, Solid solid, const std::optional<Rgba>& color) {
      auto geometry = to_flat(part.geometry, flat);
      if (!geometry) return;
      solid.prim += std::to_string(++number);
      solid.name = part.name.value_or({});
      add_shape({urdf::to_pose(part.origin), std::move(*geometry), color, part.span}, solid);
    };
    for (const urdf::Visual& visual : written.visuals) {
      add(visual, {}, colors_.of(visual, model, flat));
    }
    const bool is_shown = written.visuals.empty();
    const std::vector<std::string> apart = untouched_shapes(index, link);
    number = 0;
    for (const urdf::Collision& collision : written.collisions) {
      Solid solid{.prim = is_shown ? "shape_" : "collision_", .collides = true};
      solid.is_shown = is_shown;
      solid.apart = apart;
      solid.friction = contacts_of(model).of(collision, written).friction1;
      add(collision, std::move(solid), std::nullopt);
    }
  }

  std::string path(std::size_t index, std::size_t link) {
    return "/World/" + names_[index] + "/" + physics_.layout_of(index).links[link]->path;
  }

  const UsdFilter& filter_of(std::size_t index, std::size_t link) {
    return filters_.of(*robot_of(scene_.scene, index), physics_.layout_of(index), link);
  }

  std::vector<std::string> untouched_bodies(std::size_t index, std::size_t link) {
    std::vector<std::string> paths;
    for (const std::size_t other : filter_of(index, link).bodies) {
      paths.push_back(path(index, other));
    }
    return paths;
  }

  /// The collisions that those of a link do not touch.
  std::vector<std::string> untouched_shapes(std::size_t index, std::size_t link) {
    std::vector<std::string> paths;
    const LinkedModel& model = *robot_of(scene_.scene, index);
    const FlatModel& flat = scene_.flat.models[*scene_.flat.instances[index].model];
    for (const std::size_t other : filter_of(index, link).links) {
      const urdf::Link& written = model.robot->links[other];
      const std::string prim = written.visuals.empty() ? "shape_" : "collision_";
      std::size_t number = 0;
      for (const urdf::Collision& collision : written.collisions) {
        const auto geometry = to_flat(collision.geometry, flat);
        if (!geometry) continue;
        ++number;
        const auto* file = std::get_if<FlatMesh>(&*geometry);
        if (file != nullptr && !mesh_in(file->file, collision.span).why_none.empty()) continue;
        paths.push_back(path(index, other) + "/" + prim + std::to_string(number));
      }
    }
    return paths;
  }

  void add_filter(const std::vector<std::string>& paths) {
    if (paths.empty()) return;
    std::string list;
    for (const std::string& one : paths) list += (list.empty() ? "<" : ", <") + one + ">";
    text_.line("rel physics:filteredPairs = [" + list + "]");
  }

  const CollisionContacts& contacts_of(const LinkedModel& model) {
    return contacts_.try_emplace(&model, model).first->second;
  }

  /// Writes an entity without a model: a body, or a fixed object.
  void add_other(std::size_t index) {
    const FlatInstance& instance = scene_.flat.instances[index];
    const bool moves = physics_.is_body(index);
    open_entity(index, moves ? schemas_of_body() : std::vector<std::string>());
    materials_ = "/World/" + names_[index] + "/materials";
    if (moves) physics_.add_mass(index);
    const Span place = place_of(*scene_.flat.instances[index].entity);
    std::size_t number = 0;
    for (const FlatShape& shape : instance.shapes) {
      Solid solid{.prim = "shape_" + std::to_string(++number), .collides = true};
      solid.moves = moves;
      solid.name = shape.name;
      solid.friction = smurf::contacts_of(instance.properties).friction1;
      add_shape({shape.X_ES, shape.geometry, shape.color, place}, solid);
    }
    physics_.add_joints(index, frames_);
    add_materials("materials");
    text_.close();
  }

  /// Writes the materials that shapes of the entity are bound to.
  void add_materials(const std::string& scope) {
    if (frictions_.empty()) return;
    text_.open("Scope", scope);
    for (const auto& [friction, name] : frictions_) {
      text_.open("Material", name, {"PhysicsMaterialAPI"});
      text_.line("float physics:staticFriction = " + format_number(friction));
      text_.line("float physics:dynamicFriction = " + format_number(friction));
      text_.close();
    }
    text_.close();
    frictions_.clear();
  }

  /// How a shape is written.
  struct Solid {
    std::string prim = "shape_";
    std::string name = {};  ///< name in the model
    bool collides = false;
    bool is_shown = true;
    bool moves = true;
    std::optional<double> friction = {};
    std::vector<std::string> apart = {};  ///< paths of collisions that it does not touch
  };

  void add_shape(const LinkShape& shape, const Solid& solid) {
    if (text_.is_full()) return;
    Vector3 scale{1, 1, 1};
    std::vector<std::string> schemas;
    if (solid.collides) schemas.emplace_back("PhysicsCollisionAPI");
    if (solid.friction) schemas.emplace_back("MaterialBindingAPI");
    if (!solid.apart.empty()) schemas.emplace_back(kFilteredPairs);
    if (const auto* box = std::get_if<FlatBox>(&shape.geometry)) {
      text_.open("Cube", solid.prim, schemas);
      text_.line("double size = 1");
      scale = box->size;
    } else if (const auto* sphere = std::get_if<FlatSphere>(&shape.geometry)) {
      text_.open("Sphere", solid.prim, schemas);
      text_.line("double radius = " + format_number(sphere->radius));
    } else if (const auto* cylinder = std::get_if<FlatCylinder>(&shape.geometry)) {
      open_round("Cylinder", solid.prim, schemas, cylinder->radius, cylinder->length);
    } else if (const auto* capsule = std::get_if<FlatCapsule>(&shape.geometry)) {
      open_round("Capsule", solid.prim, schemas, capsule->radius, capsule->length);
    } else if (const auto* plane = std::get_if<FlatPlane>(&shape.geometry)) {
      text_.open("Plane", solid.prim, schemas);
      text_.line("uniform token axis = \"Z\"");
      text_.line("double length = " + format_number(plane->width));  // USD's length is along y
      text_.line("double width = " + format_number(plane->length));
    } else if (const Mesh* mesh = mesh_of(shape)) {
      if (solid.collides) schemas.emplace_back("PhysicsMeshCollisionAPI");
      const bool has_own_colors = !shape.color && !mesh->colored_name.empty();
      if (mesh->has_textures && !shape.color && solid.is_shown) {
        losses_.note("textures", shape.span, std::get<FlatMesh>(shape.geometry).file);
      }
      text_.open("Mesh", solid.prim, schemas,
                 "/Meshes/" + (has_own_colors ? mesh->colored_name : mesh->name));
      if (solid.collides) add_approximation(solid);
      scale = std::get<FlatMesh>(shape.geometry).scale;
    } else {
      return;
    }
    text_.pose(shape.X_LS, scale);
    if (!solid.name.empty()) {
      text_.line("custom string smurf:name = " + UsdaText::quoted(solid.name));
    }
    if (!solid.is_shown) text_.line("uniform token purpose = \"guide\"");
    if (solid.friction) bind_friction(*solid.friction);
    add_filter(solid.apart);
    if (shape.color) add_color(*shape.color);
    text_.close();
  }

  /// PhysX does not simulate moving triangle meshes.
  void add_approximation(const Solid& solid) {
    text_.line("uniform token physics:approximation = \"" +
               std::string(solid.moves ? "convexHull" : "none") + "\"");
  }

  void bind_friction(double friction) {
    std::string& name = frictions_[friction];
    if (name.empty()) name = "friction_" + std::to_string(frictions_.size());
    text_.line("rel material:binding:physics = <" + materials_ + "/" + name + ">");
  }

  void add_color(const Rgba& color) {
    const Rgba c = linear_color(color);
    text_.line("color3f[] primvars:displayColor = [" + UsdaText::tuple({c[0], c[1], c[2]}) + "]");
    if (c[3] < 1) {
      text_.line("float[] primvars:displayOpacity = [" + format_number(c[3]) + "]");
    }
  }

  void open_round(std::string_view type, const std::string& name,
                  const std::vector<std::string>& schemas, double radius, double height) {
    text_.open(type, name, schemas);
    text_.line("uniform token axis = \"Z\"");
    text_.line("double radius = " + format_number(radius));
    text_.line("double height = " + format_number(height));
  }

  /// A file that shapes refer to.
  struct Mesh {
    std::string name;
    std::string text;  ///< its attributes, one per line
    std::string why_none;
    std::string colored_name = {};  ///< the file's shape with the colours of the file, if any
    std::string colors = {};        ///< attributes, one per line
    bool has_textures = false;
  };

  /// Null if the shape has no triangles; that is already reported.
  const Mesh* mesh_of(const LinkShape& shape) {
    const auto* geometry = std::get_if<FlatMesh>(&shape.geometry);
    if (geometry == nullptr) {
      losses_.unseen_shape(shape.span, shape.geometry, {});
      return nullptr;
    }
    const Mesh& mesh = mesh_in(geometry->file, shape.span);
    if (mesh.why_none.empty()) return &mesh;
    losses_.unseen_shape(shape.span, shape.geometry, mesh.why_none);
    return nullptr;
  }

  const Mesh& mesh_in(const std::string& name, Span place) {
    const std::string& file = files_.first_name(name);
    const auto [known, is_new] = mesh_of_file_.try_emplace(file, meshes_.size());
    if (is_new) meshes_.push_back(read_mesh(file, place));
    return meshes_[known->second];
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
      append(points, UsdaText::tuple(point));
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
    const std::string extent =
        "float3[] extent = [" + UsdaText::tuple(low) + ", " + UsdaText::tuple(high) + "]";
    Mesh mesh{mesh_names_.add(safe_name(path::stem(file))),
              extent + "\n" + points + "]\n" + counts + "]\n" + indices + "]\n",
              {}};
    mesh.has_textures = triangles.has_textures;
    if (has_colors(triangles.parts)) {
      mesh.colored_name = mesh_names_.add(mesh.name + "_colored");
      mesh.colors = colors_of(triangles);
    }
    return mesh;
  }

  /// A list of the colours and, if there are several, the index of each triangle's colour.
  static std::string colors_of(const MeshTriangles& mesh) {
    std::string colors;
    std::string opacities;
    std::string places;
    bool is_opaque = true;
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
      const std::optional<Rgba>& color = mesh.parts[i].color;
      const Rgba c = color ? linear_color(*color) : Rgba{0.5, 0.5, 0.5, 1};
      is_opaque = is_opaque && c[3] == 1;
      const std::string comma = i > 0 ? ", " : "";
      colors += comma + UsdaText::tuple({c[0], c[1], c[2]});
      opacities += comma + format_number(c[3]);
      const std::size_t end =
          i + 1 < mesh.parts.size() ? mesh.parts[i + 1].first_index : mesh.indices.size();
      for (std::size_t k = mesh.parts[i].first_index; k < end; k += 3) {
        places += (places.empty() ? "" : ", ") + std::to_string(i);
      }
    }
    const auto primvar = [&](const std::string& type, const std::string& name,
                             const std::string& values) {
      const std::string line = type + "[] primvars:" + name + " = [" + values + "]";
      if (mesh.parts.size() == 1) return line + "\n";
      return line + " (interpolation = \"uniform\")\nint[] primvars:" + name + ":indices = [" +
             places + "]\n";
    };
    return primvar("color3f", "displayColor", colors) +
           (is_opaque ? "" : primvar("float", "displayOpacity", opacities));
  }

  /// Prototypes are placed beside the world, so that they are visible only through references.
  void add_meshes() {
    if (mesh_names_.empty()) return;
    text_.open_class("Meshes");
    for (const Mesh& mesh : meshes_) {
      if (!mesh.why_none.empty()) continue;
      text_.open("Mesh", mesh.name);
      text_.line("uniform token subdivisionScheme = \"none\"");
      add_lines(mesh.text);
      text_.close();
      if (mesh.colored_name.empty()) continue;
      text_.open("Mesh", mesh.colored_name, {}, "/Meshes/" + mesh.name);
      add_lines(mesh.colors);
      text_.close();
    }
    text_.close();
  }

  void add_lines(std::string_view text) {
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin);
      text_.line(text.substr(begin, end - begin));
      begin = end + 1;
    }
  }

  const SceneExport& scene_;
  SceneLosses losses_;
  std::vector<std::string> names_;
  LinkFrames frames_;
  UsdaText text_;
  UsdPhysics physics_;
  UsdFilters filters_;
  std::map<const LinkedModel*, CollisionContacts> contacts_;
  AnnotatedColors colors_;
  std::string materials_;                    ///< path of the scope of the entity
  std::map<double, std::string> frictions_;  ///< names in that scope, by value
  PreviewMeshes files_;
  std::vector<Mesh> meshes_;
  std::map<std::string, std::size_t> mesh_of_file_;
  UniqueNames mesh_names_;
};

}  // namespace

extern constinit const SceneFormat scene_usda{
    .name = "usda",
    .help = "an OpenUSD stage with UsdPhysics, for Isaac Sim",
    .write = [](const SceneExport& scene) { return UsdaWriter(scene).run(); },
    .repeats_models = true,
    .has_motors = true,
    .has_contacts = true,
    .has_link_pairs = true,
    .has_neighbours = true,
    .usual_contacts = SelfCollision::none,
    .has_collisions = true,
    .has_meshes_inside = true,
    .fixes_world_roots = true};

}  // namespace smurf::scene_usda_file
