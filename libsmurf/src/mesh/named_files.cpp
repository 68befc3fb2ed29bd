// SPDX-License-Identifier: BSD-3-Clause
// Renames the files that a mesh names.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/numbers/little_endian.hpp"
#include "mesh/gltf_data.hpp"
#include "mesh/gltf_names.hpp"
#include "mesh/mesh_reader.hpp"

namespace smurf {
namespace {

constexpr std::size_t kLength = 8;  ///< bytes of the header of a binary glTF
constexpr std::size_t kFirstChunk = 12;
constexpr std::size_t kInChunk = 20;

std::size_t size_at(std::string_view bytes, std::size_t place) { return read_uint32(bytes, place); }

void write_size(std::string& bytes, std::size_t place, std::size_t size) {
  for (std::size_t i = 0; i < 4; ++i) bytes[place + i] = static_cast<char>(size >> (8 * i) & 0xffU);
}

std::string replaced(std::string_view bytes, const std::vector<MeshDependency>& named,
                     const FileNames& names) {
  std::string text;
  std::size_t done = 0;
  for (const MeshDependency& one : named) {
    const auto name = names.find(one.filename);
    if (name == names.end() || one.length == 0 || one.offset < done) continue;
    text += bytes.substr(done, one.offset - done);
    text += name->second;
    done = one.offset + one.length;
  }
  return text += bytes.substr(done);
}

}  // namespace

std::vector<MeshDependency> files_named_in(std::string_view bytes, std::string_view extension) {
  if (path::to_lower(extension) == ".mtl") return read_material_library(bytes);
  if (format_of_mesh(bytes, extension) != MeshFormat::gltf) {
    return read_mesh(bytes, extension).dependencies;
  }
  return gltf::names_in(gltf::Data(bytes, MeshNeighbours{}));
}

std::string with_other_names(std::string_view bytes, std::string_view extension,
                             const FileNames& names) {
  std::vector<MeshDependency> named = files_named_in(bytes, extension);
  std::sort(named.begin(), named.end(),
            [](const auto& a, const auto& b) { return a.offset < b.offset; });
  std::string text = replaced(bytes, named, names);
  if (!bytes.starts_with("glTF") || text.size() < kInChunk || text == bytes) return text;
  // The JSON is the first chunk, and each chunk ends at a multiple of four bytes.
  const std::size_t end = kInChunk + size_at(bytes, kFirstChunk) + text.size() - bytes.size();
  const std::size_t padding = (4 - end % 4) % 4;
  text.insert(end, padding, ' ');
  write_size(text, kFirstChunk, end + padding - kInChunk);
  write_size(text, kLength, text.size());
  return text;
}

}  // namespace smurf
