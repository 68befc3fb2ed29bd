// SPDX-License-Identifier: BSD-3-Clause
// The triangles of COLLADA, placed by the nodes of the scene as RViz and Gazebo place them: the
// unit is applied, <up_axis> is not. RViz asks assimp to ignore the axis (assimp_loader.cpp:201),
// Gazebo reads <unit> only (ColladaLoader.cc:718), and MoveIt and urdf-loader undo the rotation of
// the root.
#include <algorithm>
#include <map>
#include <unordered_map>

#include "base/text/quoted.hpp"
#include "mesh/collada_colors.hpp"
#include "mesh/collada_geometry.hpp"
#include "mesh/formats.hpp"

namespace smurf {
namespace {

using xml::View;
using namespace collada;

/// Limits the depth of nodes that refer to other nodes.
constexpr std::size_t kMostLevels = 256;
/// If nodes refer to others twice, their number doubles with each level. A file without such
/// references has fewer elements.
constexpr std::size_t kMostSteps = 4'000'000;

class ColladaTriangles {
 public:
  ColladaTriangles(const File& file, NumberLists* known, TriangleCollector& triangles)
      : file_(file),
        root_(file.document()->view()),
        triangles_(triangles),
        colors_(root_),
        geometries_(triangles.wants_texture_points() ? TexturePoints::read : TexturePoints::ignored,
                    known) {
    if (colors_.has_textures()) triangles.note_textures();
  }

  /// The reason why there are no triangles.
  std::string read(const Affine& X, std::optional<MeshDefect>* defect) {
    index();
    const View scene = scene_of();
    // Other readers refuse such a file, this one shows its only scene.
    if (defect != nullptr && unknown_scene_) {
      *defect = file_.defect_at(unknown_scene_, "there is no scene with the id " +
                                                    quoted(id_in(value(unknown_scene_, "url"))));
    }
    if (!scene) return "has no scene that places its parts";
    for (const View child : scene) {
      if (child.name() == "node" && !node(child, X)) break;
    }
    if (!triangles_.reason().empty()) return triangles_.reason();
    if (!problem_) problem_ = geometries_.problem();
    if (problem_ && !problem_->is_defect) return problem_->what;
    if (!problem_) return {};
    const MeshDefect found = file_.defect_at(problem_->element, problem_->what);
    if (defect != nullptr && !*defect) *defect = found;
    return why_broken(found);
  }

 private:
  void index() {
    for (const View library : root_) {
      if (library.name() == "library_geometries") {
        for (const View child : library) geometry_of_id_.emplace(value(child, "id"), child);
      } else if (library.name() == "library_nodes") {
        for (const View child : library) index_nodes(child);
      } else if (library.name() == "library_visual_scenes") {
        for (const View scene : library) {
          scene_of_id_.emplace(value(scene, "id"), scene);
          for (const View child : scene) index_nodes(child);
        }
      }
    }
  }

  // The depth of the document is bounded by Limits::xml_depth.
  void index_nodes(View element) {
    if (element.name() != "node") return;
    node_of_id_.emplace(value(element, "id"), element);
    for (const View child : element) index_nodes(child);
  }

  /// The scene that the file displays, otherwise its only scene.
  View scene_of() {
    if (const View shown = root_.child("scene")) {
      if (const View instance = shown.child("instance_visual_scene")) {
        const auto found = scene_of_id_.find(id_in(value(instance, "url")));
        if (found != scene_of_id_.end()) return found->second;
        unknown_scene_ = instance;
      }
    }
    return scene_of_id_.size() == 1 ? scene_of_id_.begin()->second : View();
  }

  bool node(View element, Affine X) {
    if (std::find(path_.begin(), path_.end(), element.id()) != path_.end()) {
      return fail(element, "a node contains itself");
    }
    if (path_.size() == kMostLevels) return limit(element, "nests nodes too deeply to be read");
    const std::string_view unread = unread_;
    for (const View child : element) {
      if (child.name() == "lookat" || child.name() == "skew") unread_ = child.name();
      if (!transform(child, X)) {
        return fail(child, "the transform of a node is not a list of numbers");
      }
    }
    path_.push_back(element.id());
    bool is_read = true;
    for (const View child : element) is_read = is_read && part(child, X);
    path_.pop_back();
    unread_ = unread;
    return is_read;
  }

  bool part(View element, const Affine& X) {
    if (++steps_ > kMostSteps) return limit(element, "repeats too many nodes to be read");
    const std::string_view name = element.name();
    if (name == "node") return node(element, X);
    if (name == "instance_controller") {
      return limit(element, "has skins (instance_controller), which are not read");
    }
    const bool is_node = name == "instance_node";
    if (!is_node && name != "instance_geometry") return true;
    const std::string_view url = value(element, "url");
    if (!url.starts_with('#')) {
      return limit(element, "names parts of other files, which are not read");
    }
    const auto& known = is_node ? node_of_id_ : geometry_of_id_;
    const auto found = known.find(id_in(url));
    if (found == known.end()) {
      return fail(element, "there is no element with the id " + quoted(id_in(url)));
    }
    return is_node ? node(found->second, X) : place(found->second, element, X);
  }

  bool place(View element, View instance, const Affine& X) {
    if (!unread_.empty()) {
      return limit(element, "is placed by <" + std::string(unread_) + ">, which is not read");
    }
    const auto [known, is_new] = geometries_read_.try_emplace(element.id());
    Geometry& geometry = known->second;
    if (is_new) geometry = geometries_.read(element);
    if (geometries_.problem()) return false;
    if (geometry.parts.empty()) return true;
    const auto [bound, is_unknown] = bindings_.try_emplace(instance.id());
    if (is_unknown) bound->second = bindings_of(instance);
    for (const Geometry::Part& part : geometry.parts) {
      const auto id = bound->second.find(part.material);
      // In exporters that bind nothing, the symbol is the material.
      triangles_.set_color(colors_.of(id == bound->second.end() ? part.material : id->second));
      for (std::size_t i = 0; i < part.corners.size(); i += 3) {
        const auto point = [&](std::size_t corner) {
          return X * geometry.points[part.corners[i + corner]];
        };
        const auto texture = [&](std::size_t corner) {
          const std::uint32_t place = part.corners[i + corner];
          return place < geometry.texture_points.size() ? geometry.texture_points[place]
                                                        : kNoTexturePoint;
        };
        if (!triangles_.add(point(0), point(1), point(2), {texture(0), texture(1), texture(2)})) {
          return false;
        }
      }
    }
    return true;
  }

  /// Always false.
  bool fail(View element, std::string what) {
    problem_ = Problem{element, std::move(what)};
    return false;
  }
  /// Always false.
  bool limit(View element, std::string what) {
    problem_ = Problem{element, std::move(what), false};
    return false;
  }

  const File& file_;
  View root_;
  TriangleCollector& triangles_;
  Colors colors_;
  std::map<std::string_view, View> geometry_of_id_, node_of_id_, scene_of_id_;
  View unknown_scene_;  ///< the instance of a scene that the file does not have
  GeometryReader geometries_;
  std::unordered_map<xml::ElementId, Geometry> geometries_read_;
  std::vector<xml::ElementId> path_;                       ///< from the scene to the node
  std::unordered_map<xml::ElementId, Bindings> bindings_;  ///< of instances
  std::string_view unread_;                                ///< a transform of a node in `path_`
  std::size_t steps_ = 0;
  std::optional<Problem> problem_;
};

}  // namespace

std::string collada::place_triangles(const File& file, const Affine& X, NumberLists* known,
                                     TriangleCollector& triangles,
                                     std::optional<MeshDefect>* defect) {
  return ColladaTriangles(file, known, triangles).read(X, defect);
}

std::string read_collada_triangles(std::string_view text, TriangleCollector& triangles) {
  const File file(text);
  if (file.has_too_many_elements()) return "has too many elements to be read";
  if (file.document() == nullptr) return why_broken(*file.defect());
  Affine X_unit;
  if (const View asset = file.document()->view().child("asset")) {
    const double unit = unit_of(asset).value_or(1);
    X_unit = scaling({unit, unit, unit});
  }
  return place_triangles(file, X_unit, nullptr, triangles);
}

}  // namespace smurf
