// SPDX-License-Identifier: BSD-3-Clause
// The facts about glTF 2.0: the files that it names, the number of its triangles and their box.
#include <map>
#include <set>
#include <vector>

#include "mesh/formats.hpp"
#include "mesh/gltf_names.hpp"
#include "mesh/gltf_scene.hpp"

namespace smurf {
namespace {

using namespace gltf;

/// Reads each mesh once, even if many nodes place it.
class GltfFacts {
 public:
  GltfFacts(Data& data, MeshFacts& facts, SurfaceSum& surface)
      : data_(data), facts_(facts), surface_(surface) {}

  void read() {
    visit_meshes(data_, [&](const Json& mesh, std::uint64_t number, const Affine& X) {
      const auto [known, is_new] = meshes_.try_emplace(number);
      return (!is_new || read_mesh(mesh, known->second)) && place(known->second, X) &&
             add_surface(mesh, X);
    });
    if (!data_.reason().empty()) return;
    facts_.box = box_.finite_box();
    if (triangles_ <= kMostPlaced) surface_.write_to(facts_);
  }

 private:
  struct Mesh {
    BoxSum box;
    std::uint64_t triangles = 0;
  };

  bool read_mesh(const Json& json, Mesh& mesh) {
    return visit_primitives(data_, json, steps_, [&](const Primitive& primitive) {
      constexpr std::uint64_t kNone = ~std::uint64_t{0};
      const std::uint64_t points = primitive.points.number;
      if (points_.insert(points).second) facts_.vertices += primitive.points.count;
      const auto [known, is_new] =
          boxes_.try_emplace({points, primitive.indices ? primitive.indices->number : kNone});
      if (is_new && !add_corners(primitive, known->second)) return false;
      if (known->second.box()) mesh.box.add(*known->second.box());
      mesh.triangles += primitive.triangles();
      return true;
    });
  }

  bool add_corners(const Primitive& primitive, BoxSum& box) {
    // Accessors of one buffer may overlap any number of times.
    corners_ += primitive.count;
    if (corners_ > kCornersPerByte * data_.bytes()) return data_.fail_unread(kRepeats);
    // If most points are corners, each is read once.
    const bool is_dense = primitive.indices && primitive.points.count <= primitive.count;
    std::vector<bool> is_done(is_dense ? static_cast<std::size_t>(primitive.points.count) : 0);
    for (std::uint64_t i = 0; i < primitive.count; ++i) {
      const std::uint64_t place = place_of(primitive, i);
      if (place < is_done.size()) {
        if (is_done[static_cast<std::size_t>(place)]) continue;
        is_done[static_cast<std::size_t>(place)] = true;
      }
      const auto point = point_at(data_, primitive, place);
      if (!point) return false;
      box.add(*point);
    }
    return true;
  }

  bool place(const Mesh& mesh, const Affine& X) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 40U;
    facts_.triangles += mesh.triangles;
    if (facts_.triangles > kMost) return data_.fail_unread(kRepeats);
    if (mesh.box.box()) box_.add_corners(*mesh.box.box(), X);
    return true;
  }

  bool add_surface(const Json& mesh, const Affine& X) {
    return visit_primitives(data_, mesh, steps_, [&](const Primitive& primitive) {
      triangles_ += primitive.triangles();
      return triangles_ > kMostPlaced ||
             visit_triangles(data_, primitive, X, [&](const Corners& corners) {
               surface_.add(corners.points[0], corners.points[1], corners.points[2]);
               return true;
             });
    });
  }

  static constexpr std::uint64_t kCornersPerByte = 4;

  Data& data_;
  MeshFacts& facts_;
  SurfaceSum& surface_;
  std::map<std::uint64_t, Mesh> meshes_;
  std::map<std::pair<std::uint64_t, std::uint64_t>, BoxSum> boxes_;  ///< by accessors
  std::set<std::uint64_t> points_;                                   ///< accessors counted so far
  BoxSum box_;
  std::size_t steps_ = 0;
  std::uint64_t corners_ = 0;
  std::uint64_t triangles_ = 0;  ///< placed
};

/// The name of a buffer, for messages about a buffer that is too short.
const MeshDependency* find_buffer(const MeshFacts& facts, const Data& data) {
  for (const MeshDependency& named : facts.dependencies) {
    if (named.kind == MeshDependency::Kind::buffer && data.short_buffer() == named.filename) {
      return &named;
    }
  }
  return nullptr;
}

}  // namespace

void read_gltf(std::string_view bytes, const MeshNeighbours& neighbours, MeshFacts& facts,
               SurfaceSum& surface) {
  Data data(bytes, neighbours);
  facts.dependencies = names_in(data);
  if (data.reason().empty()) GltfFacts(data, facts, surface).read();
  if (data.reason().empty()) return;
  facts.triangles = 0;
  facts.vertices = 0;
  if (!data.is_broken()) {
    facts.unread = data.reason();
    return;
  }
  facts.defect = MeshDefect{data.reason().substr(kBroken.size()), 0, 0};
  if (const MeshDependency* buffer = find_buffer(facts, data)) {
    facts.defect->offset = buffer->offset;
    facts.defect->line = buffer->line;
  }
}

}  // namespace smurf
