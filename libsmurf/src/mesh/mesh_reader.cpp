// SPDX-License-Identifier: BSD-3-Clause
// Recognises the format of a mesh by its bytes, because file names can be wrong.
#include "mesh/mesh_reader.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/files/uri.hpp"
#include "mesh/formats.hpp"
#include "mesh/words.hpp"

namespace smurf {
namespace {

/// The length of a text that is enough to recognise it.
constexpr std::size_t kStart = 4096;

bool is_binary_stl(std::string_view bytes) {
  return bytes.size() >= kStlHeaderBytes &&
         bytes.size() ==
             kStlHeaderBytes + std::uint64_t{stl_triangle_count(bytes)} * kStlTriangleBytes;
}

bool is_text(std::string_view bytes) {
  return bytes.substr(0, kStart).find('\0') == std::string_view::npos;
}

bool is_obj(std::string_view text) {
  Words words(text);
  while (!words.is_at_end()) {
    const std::string_view word = words.next();
    // Readers skip what git left of a conflict, as they skip other lines that they do not know.
    if (word.starts_with('#') || word == "<<<<<<<") {
      words.rest_of_line();
      continue;
    }
    constexpr std::string_view kKeywords[] = {"v", "vt", "vn",     "f",     "o",
                                              "g", "s",  "mtllib", "usemtl"};
    return std::find(std::begin(kKeywords), std::end(kKeywords), word) != std::end(kKeywords);
  }
  return false;
}

}  // namespace

MeshFormat format_of_mesh(std::string_view bytes, std::string_view written_extension) {
  const std::string extension = path::to_lower(written_extension);
  using enum MeshFormat;
  if (bytes.starts_with("version https://git-lfs")) return lfs_pointer;
  if (bytes.starts_with("glTF")) return gltf;
  if (is_binary_stl(bytes)) return stl_binary;
  constexpr std::string_view kVertexRecord("\1\0\0\0", 4);
  if (bytes.starts_with(kVertexRecord) && extension != ".stl") return bobj;
  if (is_text(bytes)) {
    const std::string start = path::to_lower(Words(bytes.substr(0, kStart)).next());
    const std::string_view head = bytes.substr(0, kStart);
    if (start == "solid") return stl_ascii;
    if (head.find("<COLLADA") != std::string_view::npos) return collada;
    if (start.starts_with('{') && (extension == ".gltf" || extension == ".glb")) return gltf;
    if (is_obj(bytes)) return obj;
    return unknown;
  }
  // The size does not fit the count: the file is probably truncated.
  return extension == ".stl" ? stl_binary : unknown;
}

std::string_view to_string(MeshFormat format) {
  switch (format) {
  case MeshFormat::unknown: break;
  case MeshFormat::stl_binary: return "binary STL";
  case MeshFormat::stl_ascii: return "ASCII STL";
  case MeshFormat::obj: return "OBJ";
  case MeshFormat::collada: return "COLLADA";
  case MeshFormat::bobj: return "bobj";
  case MeshFormat::gltf: return "glTF";
  case MeshFormat::lfs_pointer: return "Git LFS pointer";
  }
  return "unknown format";
}

MeshFacts read_mesh(std::string_view bytes, std::string_view extension,
                    const TriangleVisitor& visit, const MeshNeighbours& neighbours) {
  MeshFacts facts;
  SurfaceSum surface(visit);
  facts.bytes = bytes.size();
  facts.format = format_of_mesh(bytes, extension);
  switch (facts.format) {
  case MeshFormat::stl_binary: read_binary_stl(bytes, facts, surface); break;
  case MeshFormat::stl_ascii: read_ascii_stl(bytes, facts, surface); break;
  case MeshFormat::obj: read_obj(bytes, facts, surface); break;
  case MeshFormat::collada: read_collada(bytes, facts, surface); break;
  case MeshFormat::bobj: read_bobj(bytes, facts, surface); break;
  case MeshFormat::gltf: read_gltf(bytes, neighbours, facts, surface); break;
  case MeshFormat::lfs_pointer:
  case MeshFormat::unknown: break;
  }
  return facts;
}

std::string MeshDependency::path() const {
  constexpr std::string_view kFile = "file://";
  std::string_view uri = filename;
  if (uri.starts_with(kFile)) uri.remove_prefix(kFile.size());
  return decoded_uri(uri);
}

}  // namespace smurf
