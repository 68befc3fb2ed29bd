// SPDX-License-Identifier: BSD-3-Clause
#include <set>

#include "archive/zip.hpp"
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/rules.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "link/read_file.hpp"
#include "link/scene_link.hpp"
#include "smurf/old_scene.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

/// The text of a key of a node; both forms of old scenes have the same keys.
Spanned<std::string> text_of(yaml::View node, std::string_view key) {
  const yaml::View value = node.find(key);
  if (!value || !value.is_scalar()) return {};
  return {std::string(trimmed(value.text())), value.span()};
}

Spanned<std::string> text_of(xml::View node, std::string_view key) {
  const xml::View value = node.child(key);
  if (!value) return {};
  return {std::string(trimmed(value.text())), value.text_span()};
}

/// Reports files that nodes name and that do not exist, each once.
class NamedFiles {
 public:
  NamedFiles(const std::string& path, LoadContext& context)
      : folder_(path::parent(path)), context_(context) {}

  template <class View>
  void check(View node) {
    const Spanned<std::string> heights = text_of(node, "t_srcname");
    if (!heights.value.empty()) return check_file(heights, "heightmap", &cases::kHeights);
    const Spanned<std::string> mesh = text_of(node, "filename");
    if (mesh.value == "PRIMITIVE") return;
    check_file(mesh, "mesh", text_of(node, "physicmode").value == "mesh" ? nullptr : &cases::kSeen);
  }

 private:
  void check_file(const Spanned<std::string>& file, std::string_view what,
                  const Circumstance* one) {
    if (file.value.empty()) return;
    const std::string path = path::join(folder_, file.value);
    if (!seen_.insert(path).second || context_.files.is_file(path)) return;
    Diagnostic& diagnostic =
        context_.sink.report(rules::sml5034_old_scene_file_missing, file.span,
                             std::string(what) + " file not found: " + quoted(file.value));
    if (one != nullptr) diagnostic.when(*one);
    if (path != file.value) diagnostic.caret = "resolved to " + quoted(path);
  }

  std::string folder_;
  LoadContext& context_;
  std::set<std::string> seen_;
};

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
    if (extension != ".scn") check_files(path, file);  // an archive contains them
    return file;
  }

 private:
  void check_files(const std::string& path, const OldSceneFile& file) {
    NamedFiles files(path, context_);
    if (file.yaml) {
      if (const yaml::View nodes = file.yaml->view().find("nodelist")) {
        for (const yaml::View node : nodes) files.check(node);
      }
    }
    if (file.xml) {
      if (const xml::View nodes = file.xml->view().child("nodelist")) {
        for (const xml::View node : nodes) files.check(node);
      }
    }
  }

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
