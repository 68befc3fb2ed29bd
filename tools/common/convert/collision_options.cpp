// SPDX-License-Identifier: BSD-3-Clause
#include "common/convert/collision_options.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/counted.hpp"
#include "common/convert/python_meshes.hpp"

namespace smurf::tools {
namespace {

constexpr std::pair<std::string_view, CollisionShapes> kShapes[] = {
    {"keep", CollisionShapes::keep},   {"hull", CollisionShapes::hull},
    {"boxes", CollisionShapes::boxes}, {"capsules", CollisionShapes::capsules},
    {"parts", CollisionShapes::parts}, {"lighter", CollisionShapes::lighter}};

/// "hull", or "finger_*=parts" for some links.
Setter append_choice(std::vector<CollisionChoice>& choices) {
  return [&choices](std::string_view value) -> std::optional<std::string> {
    const std::size_t equals = value.rfind('=');
    const bool has_links = equals != std::string_view::npos;
    const std::string_view shapes = has_links ? value.substr(equals + 1) : value;
    std::vector<std::string_view> names;
    for (const auto& [name, meaning] : kShapes) {
      names.push_back(name);
      if (name != shapes) continue;
      choices.push_back({has_links ? std::string(value.substr(0, equals)) : "", meaning});
      return std::nullopt;
    }
    return none_of(shapes, names);
  };
}

}  // namespace

Option collision_option(CollisionRequest& request) {
  return {
      .name = "collision",
      .metavar = "[LINKS=]SHAPES",
      .help =
          "Replace the collision meshes of all links, or of those whose name fits LINKS, a "
          "pattern with `*`; masses and inertias stay. hull: their convex hulls. parts: convex "
          "parts that fill about the same space, which takes up to a minute for each mesh and "
          "needs CoACD (`pip install coacd`). boxes, capsules: the smallest ones around them. "
          "lighter: about the same surfaces with fewer triangles; needs meshoptimizer (`pip "
          "install meshoptimizer`). keep: the meshes (default). May be repeated; the last one that fits counts.",
      .set = append_choice(request.choices)};
}

void complete(CollisionRequest& request, std::string_view tool, const ConverterOptions& options) {
  // Several processors work on one mesh, and fine parts take longer than all checks.
  constexpr std::uint64_t kLonger = 5;
  const std::uint64_t seconds = kLonger * options.max_seconds;
  request.divide = [seconds](const DividedMesh& mesh) { return divide_with_coacd(mesh, seconds); };
  request.lighten = [seconds](const HeavyMesh& mesh) {
    return lighten_with_meshoptimizer(mesh, seconds);
  };
  if (!options.quiet) {
    request.tell = [tool](const std::string& sentence) { complain(tool, sentence); };
  }
  if (options.output.empty() || options.output == "-") return;
  const std::string_view file = path::file_name(options.output);
  request.folder = std::string(file.substr(0, file.find('.', 1))) + "_collisions";
}

std::vector<std::string> remarks_on(std::span<const ReplacedCollision> replaced,
                                    std::size_t new_meshes, const std::string& folder) {
  std::vector<std::string> remarks;
  std::size_t meshes = 0;
  std::size_t shapes = 0;
  std::size_t before = 0;
  std::size_t after = 0;
  for (const ReplacedCollision& one : replaced) {
    if (!one.kept.empty()) continue;
    ++meshes;
    shapes += one.parts;
    before += one.vertices_before;
    after += one.vertices_after;
  }
  if (meshes == 0) return remarks;
  std::string remark = "collisions: " + counted(meshes, "mesh", "meshes") + " of " +
                       counted(before, "vertex", "vertices") + " became " +
                       counted(shapes, "shape");
  if (after > 0) remark += " with " + counted(after, "vertex", "vertices");
  if (new_meshes > 0) remark += ", in " + folder;
  remarks.push_back(std::move(remark));
  return remarks;
}

std::vector<OutputFile> output_files(const std::string& folder, std::span<const TextFile> files) {
  std::vector<OutputFile> outputs;
  for (const TextFile& file : files)
    outputs.push_back({.folder = folder, .path = file.path, .text = file.text});
  return outputs;
}

}  // namespace smurf::tools
