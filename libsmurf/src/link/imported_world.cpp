// SPDX-License-Identifier: BSD-3-Clause
#include "link/imported_world.hpp"

#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "sdf/sdf.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {

bool has_name_of_world(std::string_view path) {
  return is_one_of(path::to_lower(path::extension(path)), {".sdf", ".world", ".xml"});
}

std::string_view name_in_world(std::string_view path) {
  const std::size_t mark = path.rfind('#');
  if (mark == std::string_view::npos || !has_name_of_world(path.substr(0, mark))) return {};
  return path.substr(mark + 1);
}

bool is_world_file(const std::string& path, const FileReader& files, const Limits& limits) {
  if (!has_name_of_world(path)) return false;
  const FileContent content = files.read(path, limits.file_bytes);
  return content.status == ReadStatus::ok && sdformat::is_world(content.text);
}

bool read_imported_world(SceneFile& file, MadeModels& models, LoadContext& context) {
  imports::Context inner{context.sources, context.files, context.sink, context.limits};
  sdformat::World world = sdformat::expand_world(file.source, inner);
  if (!world.scene.is_complete) return false;
  file.document = parse_yaml(context.sources, world.scene.source, context.limits, context.sink);
  context.expansions->emplace(world.scene.source, std::move(world.scene));
  for (auto& [name, robot] : world.models)
    models.emplace(path::join(path::parent(file.path), name), std::move(robot));
  return file.document.has_value();
}

void find_written(Scene& scene, const LoadContext& context) {
  for (Entity& one : scene.entities) {
    const auto made = context.expansions->find(one.span.source);
    if (made == context.expansions->end()) return;
    one.span = made->second.origin_of(place_of(one)).span;
  }
}

}  // namespace smurf
