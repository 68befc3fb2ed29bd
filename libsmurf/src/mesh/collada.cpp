// SPDX-License-Identifier: BSD-3-Clause
// COLLADA: units, axes, counts, and the box of the positions through the nodes of the scene.
// Nothing is rendered, so materials, normals and animations stay unread.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "base/numbers.hpp"
#include "mesh/formats.hpp"
#include "mesh/surface.hpp"
#include "mesh/words.hpp"
#include "smurf/source.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf {
namespace {

using xml::View;

std::string_view value(View element, std::string_view attribute) {
  const xml::Attribute* found = element.attribute(attribute);
  return found == nullptr ? std::string_view() : found->value();
}

std::string_view trimmed_text(View element) { return Words(element.text()).rest_of_line(); }

std::vector<double> numbers(std::string_view text) {
  std::vector<double> all;
  Words words(text);
  while (!words.is_at_end()) all.push_back(parse_number(words.next()).value_or(std::nan("")));
  return all;
}

bool is_finite(const std::vector<double>& all) {
  return std::all_of(all.begin(), all.end(), [](double x) { return std::isfinite(x); });
}

class ColladaReader {
 public:
  ColladaReader(const SourceMap& sources, const xml::Document& document, MeshFacts& facts)
      : sources_(sources), document_(document), facts_(facts) {}

  void read() {
    for (const View child : document_.view()) {
      const std::string_view name = child.name();
      if (name == "asset") asset(child);
      if (name == "library_geometries") geometries(child);
      if (name == "library_images") images(child);
      if (name == "library_lights") extra(child, "lights");
      if (name == "library_cameras") extra(child, "cameras");
      if (name == "library_animations") extra(child, "animations");
    }
    for (const View child : document_.view()) {
      if (child.name() == "library_visual_scenes") scenes(child);
    }
    if (is_placed_) facts_.box = box_.box();
  }

 private:
  void asset(View asset) {
    if (const View unit = asset.child("unit")) {
      const auto meters = parse_number(value(unit, "meter"));
      if (meters && *meters > 0) facts_.unit_meters = *meters;
    }
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
      const std::uint32_t line =
          sources_.line_of(document_.source, named.element().name_span().begin);
      facts_.dependencies.push_back({std::string(file), true, line});
    }
  }

  void geometries(View library) {
    for (const View geometry : library) {
      const View mesh = geometry.child("mesh");
      if (!mesh) continue;
      for (const View child : mesh) facts_.triangles += triangles(child);
      const View points = positions(mesh);
      if (!points) continue;
      BoxSum box;
      add_points(points, box);
      if (box.box()) geometry_boxes_.emplace(value(geometry, "id"), *box.box());
    }
  }

  /// The source of the positions of a mesh, of which there is one.
  static View positions(View mesh) {
    const View vertices = mesh.child("vertices");
    if (!vertices) return {};
    for (const View input : vertices) {
      const std::string_view reference = value(input, "source");
      if (value(input, "semantic") != "POSITION" || !reference.starts_with('#')) continue;
      for (const View source : mesh) {
        if (value(source, "id") == reference.substr(1)) return source;
      }
      return {};
    }
    return {};
  }

  void add_points(View source, BoxSum& box) {
    const View array = source.child("float_array");
    if (!array) return;
    std::size_t stride = 3;
    if (const View technique = source.child("technique_common")) {
      if (const View accessor = technique.child("accessor")) {
        const auto written = parse_integer(value(accessor, "stride"));
        constexpr std::int64_t kMost = 1 << 30;  // one that does not fit would become 0
        if (written && *written >= 3) stride = static_cast<std::size_t>(std::min(*written, kMost));
      }
    }
    const std::vector<double> all = numbers(array.text());
    if (!is_finite(all)) {
      fail(array, "the coordinates of the vertices are not all numbers");
      return;
    }
    for (std::size_t i = 0; i + 3 <= all.size(); i += stride) {
      box.add(Vector3{all[i], all[i + 1], all[i + 2]});
      ++facts_.vertices;
    }
  }

  static std::uint64_t triangles(View primitives) {
    const auto count = parse_integer(value(primitives, "count"));
    const std::uint64_t polygons = count && *count > 0 ? static_cast<std::uint64_t>(*count) : 0;
    if (primitives.name() == "triangles" || primitives.name() == "polygons") return polygons;
    if (primitives.name() != "polylist") return 0;
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
        if (child.name() == "node") node(child, Eigen::Affine3d::Identity());
      }
    }
  }

  // The depth of the document is bounded by Limits::xml_depth.
  void node(View node, Eigen::Affine3d X_SN) {
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

  /// Applies what is a transform; false when it has the wrong numbers.
  static bool transform(View element, Eigen::Affine3d& X_SN) {
    const std::string_view name = element.name();
    const std::size_t count = name == "matrix"                         ? 16
                              : name == "rotate"                       ? 4
                              : name == "translate" || name == "scale" ? 3
                                                                       : 0;
    if (count == 0) return true;
    const std::vector<double> all = numbers(element.text());
    if (all.size() != count || !is_finite(all)) return false;
    if (name == "matrix") {
      const Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>> matrix(all.data());
      X_SN = X_SN * Eigen::Affine3d(Eigen::Matrix4d(matrix));
      return true;
    }
    const Eigen::Vector3d vector(all[0], all[1], all[2]);
    if (name == "translate") X_SN.translate(vector);
    if (name == "scale") X_SN.scale(vector);
    if (name == "rotate" && vector.norm() > 0) {
      constexpr double kRadians = std::numbers::pi / 180;
      X_SN.rotate(Eigen::AngleAxisd(all[3] * kRadians, vector.normalized()));
    }
    return true;
  }

  void place(std::string_view url, const Eigen::Affine3d& X_SN) {
    if (!url.starts_with('#')) return;
    const auto found = geometry_boxes_.find(url.substr(1));
    if (found == geometry_boxes_.end()) return;
    const Box& box = found->second;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d point((corner & 1U) != 0 ? box.high[0] : box.low[0],
                                  (corner & 2U) != 0 ? box.high[1] : box.low[1],
                                  (corner & 4U) != 0 ? box.high[2] : box.low[2]);
      const Eigen::Vector3d placed = X_SN * point;
      box_.add(Vector3{placed.x(), placed.y(), placed.z()});
    }
  }

  void fail(View at, std::string what) {
    if (facts_.defect) return;
    const std::uint32_t offset = at.element().name_span().begin;
    facts_.defect = {std::move(what), offset, sources_.line_of(document_.source, offset)};
  }

  const SourceMap& sources_;
  const xml::Document& document_;
  MeshFacts& facts_;
  std::unordered_map<std::string_view, Box> geometry_boxes_;  ///< by id, in their own frame
  BoxSum box_;
  bool is_placed_ = true;
};

}  // namespace

void read_collada(std::string_view text, MeshFacts& facts) {
  // The tree takes some hundred bytes an element; real files have few, as numbers lie in lists.
  constexpr auto kMostElements = 1000000;
  if (std::count(text.begin(), text.end(), '<') > kMostElements) return;
  SourceMap sources;
  const SourceId source = sources.add("", std::string(text));
  DiagnosticSink sink;
  const auto document = parse_xml(sources, source, Limits{}, sink);
  if (document) {
    ColladaReader(sources, *document, facts).read();
    return;
  }
  facts.defect = {"it is no XML", 0, 1};
  for (const Diagnostic& diagnostic : sink.diagnostics()) {
    if (diagnostic.severity != Severity::error) continue;
    facts.defect = {diagnostic.message, diagnostic.span.begin,
                    sources.position(source, diagnostic.span.begin).line};
    return;
  }
}

}  // namespace smurf
