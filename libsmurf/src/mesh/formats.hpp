// SPDX-License-Identifier: BSD-3-Clause
// The reader of each format. Each fills in the facts up to the first defect, in time and memory
// linear in the file. `surface` is empty before the call.
#pragma once

#include <string>
#include <string_view>

#include "mesh/surface.hpp"
#include "mesh/triangle_collector.hpp"
#include "smurf/mesh.hpp"

namespace smurf {

void read_binary_stl(std::string_view bytes, MeshFacts& facts, SurfaceSum& surface);
void read_ascii_stl(std::string_view text, MeshFacts& facts, SurfaceSum& surface);
void read_obj(std::string_view text, MeshFacts& facts, SurfaceSum& surface);
/// Also collects the triangles, with their texture coordinates and colours. `neighbours` reads the
/// material libraries; it may be null.
MeshFacts read_obj_triangles(std::string_view text, const MeshNeighbours& neighbours,
                             TriangleCollector& triangles);
void read_collada(std::string_view text, MeshFacts& facts, SurfaceSum& surface);
void read_bobj(std::string_view bytes, MeshFacts& facts, SurfaceSum& surface);
void read_gltf(std::string_view bytes, const MeshNeighbours& neighbours, MeshFacts& facts,
               SurfaceSum& surface);
/// Nodes of a small file can place triangles any number of times. This is more than an STL of the
/// largest size has.
inline constexpr std::size_t kMostPlaced = 3'000'000;

/// Reads triangles, in metres and the axes of URDF. Returns the reason if this failed: "is broken:
/// ...". The reason is empty if they were read, even if `triangles` has a reason.
std::string read_collada_triangles(std::string_view text, TriangleCollector& triangles);
std::string read_gltf_triangles(std::string_view bytes, const MeshNeighbours& neighbours,
                                TriangleCollector& triangles);
/// "is broken: the file ends inside a facet (line 3)".
std::string why_broken(const MeshDefect& defect);

/// Size of a binary STL: a header of 80 bytes, a count, 50 bytes per triangle.
inline constexpr std::size_t kStlHeaderBytes = 84;
inline constexpr std::size_t kStlTriangleBytes = 50;
/// The count in the header. Precondition: at least kStlHeaderBytes bytes.
std::uint32_t stl_triangle_count(std::string_view bytes);

}  // namespace smurf
