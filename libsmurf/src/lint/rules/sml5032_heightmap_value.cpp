// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "ast/key_renames.hpp"
#include "ast/keys.hpp"
#include "ast/scene_keys.hpp"
#include "base/files/path.hpp"
#include "base/text/suggest.hpp"
#include "link/scene_link.hpp"
#include "lint/queries.hpp"
#include "lint/scene_queries.hpp"

namespace smurf::rules::sml5032_heightmap_value_file {
namespace {

constexpr KeySpec kKeys[] = {
    {.name = "width", .type = ValueType::number, .positive = true},
    {.name = "length", .type = ValueType::number, .positive = true},
    {.name = "height", .type = ValueType::number, .positive = true},
};
constexpr std::string_view kImages[] = {".png",  ".jpg", ".jpeg", ".bmp", ".gif",
                                        ".tiff", ".tif", ".tga",  ".pgm", ".exr"};

void check_image(const Entity& entity, Findings& findings) {
  if (!entity.file) {
    if (entity.file.written || slip_of(entity, "file") != nullptr) return;
    findings.report(place_of(entity), title(entity) + " is a height map without an image")
        .help("name the image under `file`");
    return;
  }
  const std::string extension = path::to_lower(path::extension(*entity.file));
  if (std::find(std::begin(kImages), std::end(kImages), extension) != std::end(kImages)) return;
  findings.report(entity.file.span, quoted(*entity.file) + " is not an image to read heights from");
}

void check_keys(const Entity& entity, yaml::View mapping, Findings& findings) {
  std::vector<std::string_view> missing;
  DiagnosticSink found;
  for (const KeySpec& spec : kKeys) {
    const yaml::View value = mapping.find(spec.name);
    if (!value) missing.push_back(spec.name);
    if (value) read_value(spec, value, {}, found);
  }
  for (const Diagnostic& wrong : found.diagnostics()) {
    Diagnostic& diagnostic = findings.report(wrong.span, wrong.message);
    diagnostic.help(wrong.help_text);
    diagnostic.fixes = wrong.fixes;
  }
  for (const std::string_view key : missing) {
    const CustomSection* slip = slip_of(entity, key);
    if (slip != nullptr && nearest(slip->name.value, missing) == key) {
      Diagnostic& diagnostic = findings.report(
          slip->name.span, quoted(slip->name.value) + " is not a key of a height map");
      diagnostic.help("did you mean " + quoted(key) + "?");
      KeyRenames(mapping).offer(diagnostic.fixes, {mapping.document(), slip->node}, key);
    } else {
      findings.report(place_of(entity), title(entity) + " has no " + quoted(key))
          .label(place_to_add(mapping, key), "add it after this key");
    }
  }
}

void check(const LinkedScene& scene, Findings& findings) {
  for_each_entity(scene, [&](const SceneFile& file, const Entity& entity) {
    const std::string type = entity_type(entity);
    if (type != "heightmap" || has_schema(scene, type)) return;
    check_image(entity, findings);
    check_keys(entity, mapping_of(file, entity), findings);
  });
}

}  // namespace

extern constinit const Rule sml5032_heightmap_value{
    .id = "SML5032",
    .name = "heightmap-value",
    .severity = Severity::warning,
    .summary = "A height map lacks its image or its size, or their values are unusable.",
    .why = "A height map is an entity with an image under `file` and its extent in metres under "
           "`width`, `length` and `height`. A plug-in for height maps needs all of them.",
    .remedy = "Name an image under `file` and write the three sizes in metres.",
    .sources =
        "Phobos 0.7.6 io/scenes.py (writes them); MARS EntityFactoryManager.cpp:70-90 (has no such "
        "type by itself).",
    .check_scene = check};

}  // namespace smurf::rules::sml5032_heightmap_value_file
