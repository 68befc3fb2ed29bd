// SPDX-License-Identifier: BSD-3-Clause
#include "archive/zip.hpp"
#include "base/path.hpp"
#include "base/rules.hpp"
#include "link/read_file.hpp"
#include "link/scene_link.hpp"
#include "smurf/old_scene.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

class OldSceneLoader {
 public:
  explicit OldSceneLoader(LoadContext& context) : context_(context), budget_(context.limits) {}

  OldSceneFile load(const std::string& path, Span reference) {
    const std::string extension(path::extension(path));
    const auto source =
        extension == ".scn"
            ? from_archive(path, reference)
            : read_source(path, reference, rules::sml5006_missing_entity_file, context_);
    OldSceneFile file;
    if (!source) return file;
    if (extension == ".yml") {
      file.yaml = parse_yaml(context_.sources, *source, context_.limits, context_.sink);
    } else {
      file.xml = parse_xml(context_.sources, *source, context_.limits, context_.sink);
    }
    return file;
  }

 private:
  /// MARS unpacks NAME.scn beside the scene and opens the NAME.scene in it (Load.cpp:79-104).
  std::optional<SourceId> from_archive(const std::string& path, Span reference) {
    const FileContent content = context_.files.read(path, context_.limits.file_bytes);
    if (content.status != ReadStatus::ok) {
      return report(path, reference, content.reason.empty() ? "cannot be read" : content.reason);
    }
    Archive archive = read_zip(content.text, budget_);
    if (!archive.reason.empty()) return report(path, reference, archive.reason);
    const std::string name = std::string(path::stem(path)) + ".scene";
    for (ArchivedFile& file : archive.files) {
      if (file.path == name) {
        return context_.sources.add(path + "/" + name, std::move(file.text));
      }
    }
    return report(path, reference, "contains no `" + name + "`");
  }

  std::nullopt_t report(const std::string& path, Span reference, const std::string& reason) {
    context_.sink.report(rules::sml5006_missing_entity_file, reference, "`" + path + "` " + reason);
    return std::nullopt;
  }

  LoadContext& context_;
  ArchiveBudget budget_;
};

}  // namespace

OldScenes load_old_scenes(const LinkedScene& scene, LoadContext& context) {
  OldScenes scenes;
  OldSceneLoader loader(context);
  for (const Instance& instance : scene.instances) {
    if (!is_old_scene(instance.type) || scenes.contains(instance.file)) continue;
    const Entity& entity = scene.entity(instance);
    // Missing files are already reported.
    if (!context.files.is_file(instance.file)) continue;
    scenes.emplace(instance.file, loader.load(instance.file, entity.file.span));
  }
  return scenes;
}

}  // namespace smurf
