// SPDX-License-Identifier: BSD-3-Clause
// COLLADA: units, axes, counts, and the box of the positions through the nodes of the scene.
// Ignores materials, normals and animations.
#include <algorithm>
#include <cmath>
#include <map>

#include "base/numbers/numbers.hpp"
#include "mesh/collada_file.hpp"
#include "mesh/formats.hpp"
#include "mesh/surface.hpp"
#include "mesh/words.hpp"

namespace smurf {
namespace {

using xml::View;
using namespace collada;

class ColladaReader {
 public:
  ColladaReader(const File& file, MeshFacts& facts, SurfaceSum& surface)
      : file_(file), facts_(facts), surface_(surface) {}

  void read() {
    for (const View child : file_.document()->view()) {
      const std::string_view name = child.name();
      if (name == "asset") asset(child);
      if (name == "library_geometries") geometries(child);
      if (name == "library_images") images(child);
      if (name == "library_lights") extra(child, "lights");
      if (name == "library_cameras") extra(child, "cameras");
      if (name == "library_animations") extra(child, "animations");
    }
    for (const View child : file_.document()->view()) {
      if (child.name() == "library_visual_scenes") scenes(child);
    }
    if (is_placed_) facts_.box = box_.finite_box();
    if (!facts_.defect) add_surface();
  }

 private:
  void asset(View asset) {
    facts_.unit_meters = unit_of(asset);
    if (const View up = asset.child("up_axis")) {
      const std::string_view text = trimmed_text(up);
      if (text == "X_UP" || text == "Y_UP" || text == "Z_UP") facts_.up_axis = text.front();
    }
  }

  void extra(View library, std::string_view what) {
    if (library.begin() != library.end()) facts_.extras.emplace_back(what);
  }

  void images(View library) {
    for (const View image : library) {
      const View init = image.child("init_from");
      if (!init) continue;
      // COLLADA 1.5 has a <ref> inside.
      const View named = init.child("ref") ? init.child("ref") : init;
      const std::string_view file = trimmed_text(named);
      if (file.empty()) continue;
      facts_.dependencies.push_back(file_.dependency_at(named));
    }
  }

  void geometries(View library) {
    for (const View geometry : library) {
      const View mesh = geometry.child("mesh");
      if (!mesh) continue;
      for (const View child : mesh) facts_.triangles += triangles(child);
      const View points = positions_of(mesh);
      if (!points) continue;
      BoxSum box;
      add_points(points, box);
      if (box.box()) geometry_boxes_.emplace(value(geometry, "id"), *box.box());
    }
  }

  void add_points(View source, BoxSum& box) {
    const View array = source.child("float_array");
    if (!array) return;
    const std::vector<double>& all = numbers_[array.id()] = numbers(array.text());
    if (!is_finite(all)) {
      fail(array, "some coordinates of the vertices are not numbers");
      return;
    }
    const Layout layout = layout_of(source);
    const std::size_t count = layout.points(all.size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t at = layout.offset + i * layout.stride;
      box.add(
          Vector3{all[at + layout.axes[0]], all[at + layout.axes[1]], all[at + layout.axes[2]]});
    }
    facts_.vertices += count;
  }

  static std::uint64_t triangles(View primitives) {
    const auto count = parse_integer(value(primitives, "count"));
    const std::uint64_t polygons = count && *count > 0 ? static_cast<std::uint64_t>(*count) : 0;
    const std::string_view name = primitives.name();
    // A polygon, strip or fan is at least one triangle.
    if (name == "triangles" || name == "polygons" || name == "tristrips" || name == "trifans") {
      return polygons;
    }
    if (name != "polylist") return 0;
    const View corners = primitives.child("vcount");
    if (!corners) return polygons;
    std::uint64_t sum = 0;
    Words words(corners.text());
    while (!words.is_at_end()) {
      const auto corner_count = parse_integer(words.next());
      if (corner_count && *corner_count > 2) sum += static_cast<std::uint64_t>(*corner_count) - 2;
    }
    return sum;
  }

  void scenes(View library) {
    for (const View scene : library) {
      for (const View child : scene) {
        if (child.name() == "node") node(child, Affine{});
      }
    }
  }

  // The depth of the document is bounded by Limits::xml_depth.
  void node(View node, Affine X_SN) {
    for (const View child : node) {
      const std::string_view name = child.name();
      if (name == "node") {
        this->node(child, X_SN);
      } else if (name == "instance_geometry") {
        place(value(child, "url"), X_SN);
      } else if (name == "instance_node" || name == "instance_controller") {
        is_placed_ = false;  // parts that are placed from elsewhere
      } else if (!transform(child, X_SN)) {
        fail(child, "the transform of a node is not a list of numbers");
        is_placed_ = false;
      }
    }
  }

  void place(std::string_view url, const Affine& X_SN) {
    const auto found = geometry_boxes_.find(id_in(url));
    if (found != geometry_boxes_.end()) box_.add_corners(found->second, X_SN);
  }

  void add_surface() {
    TriangleCollector triangles(kMostPlaced, [this](const Vector3& a, const Vector3& b,
                                                    const Vector3& c) { surface_.add(a, b, c); });
    std::optional<MeshDefect> defect;
    const bool is_read = place_triangles(file_, Affine{}, &numbers_, triangles, &defect).empty();
    if (defect) facts_.defect = std::move(defect);
    if (is_read && !facts_.defect) surface_.write_to(facts_);
  }

  void fail(View at, std::string what) {
    if (!facts_.defect) facts_.defect = file_.defect_at(at, std::move(what));
  }

  const File& file_;
  MeshFacts& facts_;
  SurfaceSum& surface_;
  NumberLists numbers_;
  std::map<std::string_view, Box> geometry_boxes_;  ///< by id, in their own frame
  BoxSum box_;
  bool is_placed_ = true;
};

}  // namespace

void read_collada(std::string_view text, MeshFacts& facts, SurfaceSum& surface) {
  const File file(text);
  if (file.document() != nullptr) {
    ColladaReader(file, facts, surface).read();
  } else if (file.defect()) {
    facts.defect = file.defect();
  }
}

}  // namespace smurf
