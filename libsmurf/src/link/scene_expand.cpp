// SPDX-License-Identifier: BSD-3-Clause
// The include graph: every scene and model file is read once, every entity becomes one instance per
// use of its scene.
#include <algorithm>
#include <map>
#include <set>

#include "ast/key_renames.hpp"
#include "ast/known_words.hpp"
#include "ast/scene_reader.hpp"
#include "base/deadline.hpp"
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/ranges.hpp"
#include "base/text/how_to_expand.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "link/drawn_scene.hpp"
#include "link/file_index.hpp"
#include "link/imported_world.hpp"
#include "link/read_file.hpp"
#include "link/scene_link.hpp"
#include "sdf/sdf.hpp"
#include "smurf/archive_files.hpp"
#include "smurf/user_schemas.hpp"
#include "smurf/xacro.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

const Field<std::string>& file_of(const Entity& entity) {
  return entity.file && !entity.file->empty() ? entity.file : entity.uri;
}

class SceneExpander {
 public:
  SceneExpander(LoadContext& context, LinkedScene& scene, SceneNames& names)
      : context_(context), scene_(scene), names_(names) {}

  bool run(const std::string& path) {
    scene_.path = first_names_.of(path::normalize(path));
    const std::optional<SceneIndex> root =
        scene_file(scene_.path, {}, rules::sml0001_unreadable_file);
    if (!root) return false;
    add_use({*root, {}, std::nullopt, 0, {}});
    expand(UseIndex{0});
    return true;
  }

 private:
  UseIndex add_use(SceneUse use) {
    const UseIndex index{static_cast<std::uint32_t>(scene_.uses.size())};
    scene_.uses.push_back(std::move(use));
    names_.add_use();
    const SceneUse& added = scene_.uses.back();
    inherited_.push_back(
        added.outer ? inherited_[to_size(*added.outer)] + references_of(*scene_.entity(added)) : 0);
    bytes_ += added.path.size();
    return index;
  }

  static std::uint64_t references_of(const Entity& entity) {
    return (entity.parent ? entity.parent->size() : 0) +
           (entity.anchor ? entity.anchor->size() : 0);
  }

  const Entity& entity(UseIndex use, std::size_t index) const {
    return scene_.file(scene_.uses[to_size(use)]).scene.entities[index];
  }

  /// Reads a scene at its first use; later uses share it. A broken scene stays unknown.
  std::optional<SceneIndex> scene_file(const std::string& path, Span reference,
                                       const Rule& missing) {
    const auto known = scene_files_.find(path);
    if (known != scene_files_.end()) {
      if (!known->second) report_again(path, reference, missing);
      return known->second;
    }
    std::optional<SceneIndex>& index = scene_files_[path];
    SceneFile file;
    file.path = path;
    const auto source = read_source(path, reference, missing, context_);
    if (source) {
      file.source = *source;
      if (sdformat::is_sdf(context_.sources.text(*source))) {
        if (!read_imported_world(file, made_models_, context_)) lose_scene();
      } else if (!is_drawing(path)) {
        file.document = parse_yaml(context_.sources, *source, context_.limits, context_.sink);
      } else if (!read_drawn_scene(file, scene_.data_files, context_)) {
        lose_scene();
      }
      std::optional<Scene> scene;
      if (file.document && has_room_for_lights(*file.document)) {
        // One more than the limit, so that expand() can report it.
        scene = read_scene(*file.document, context_.sink,
                           static_cast<std::size_t>(context_.limits.instances + 1));
      }
      if (scene) file.scene = std::move(*scene);
      if (scene) find_written(file.scene, context_);
      if (!scene) lose_scene();
      if (scene) check_world_files(file, context_);
      index = SceneIndex{static_cast<std::uint32_t>(scene_.scenes.size())};
      scene_.scenes.push_back(std::move(file));
    } else {
      lose_scene();
    }
    return index;
  }

  /// Reports too many lights, and returns false.
  bool has_room_for_lights(const yaml::Document& document) {
    const yaml::View root = document.view();
    const yaml::View lights = root && root.is_mapping() ? root.find("lights") : yaml::View();
    if (!lights || !lights.is_sequence()) return true;
    const std::uint64_t most =
        most_entries(context_.limits, context_.sources.text(document.source).size());
    if (lights.size() <= most) return true;
    context_.sink
        .report(rules::sml0002_file_too_large, lights.place(),
                "the scene has more than " + std::to_string(most) + " lights" +
                    (most < context_.limits.annotation_entries ? ", most of them empty" : ""))
        .help(raise_limit("annotation-entries"));
    return false;
  }

  void lose_scene() {
    scene_.is_complete = false;
    names_.mark_incomplete();
  }

  void report_again(const std::string& path, Span reference, const Rule& rule) {
    const bool exists = context_.files.is_file(path) || context_.files.is_denied(path);
    context_.sink.report(rule, reference,
                         (exists ? "cannot read `" : "there is no file `") + path + "`");
  }

  void expand(UseIndex use) {
    const std::size_t count = scene_.file(scene_.uses[to_size(use)]).scene.entities.size();
    if (scene_.instances.empty()) scene_.instances.reserve(count);
    for (std::size_t i = 0; i < count && !is_full_; ++i) {
      Deadline::look(8);
      if (scene_.instances.size() + scene_.uses.size() > context_.limits.instances) {
        stop(entity(use, i),
             "this entity exceeds the limit: a scene has at most " +
                 std::to_string(context_.limits.instances) + ", nested ones included",
             "instances");
      } else if (bytes_ > context_.limits.scene_bytes) {
        stop(entity(use, i),
             "the entities before this one have names and references of more than " +
                 std::to_string(context_.limits.scene_bytes) + " bytes, nested ones included",
             "scene-bytes");
      } else {
        add_entity(use, i);
      }
    }
  }

  void stop(const Entity& at, std::string message, std::string_view limit) {
    is_full_ = true;
    lose_scene();
    context_.sink.report(rules::sml5022_too_many_instances, place_of(at), std::move(message))
        .help(raise_limit(limit));
  }

  void add_entity(UseIndex use, std::size_t index) {
    const Entity& entity = this->entity(use, index);
    const std::string type = entity_type(entity);
    const Field<std::string>& file = file_of(entity);
    std::string path;
    if (file && !file->empty()) {
      const SceneUse& around = scene_.uses[to_size(use)];
      path = path::join(path::parent(scene_.file(around).path), *file);
    }
    bool is_usable = made_models_.contains(path) || check_kind(use, entity, type, path);
    if (is_usable && is_archive_type(type)) is_usable = enter_archive(path, file.span);
    if (kind_of(type) == EntityKind::scene) {
      include(use, index, is_usable ? first_names_.of(path) : std::string());
    } else {
      add_instance(use, index, type, path, is_usable);
    }
  }

  /// Replaces the path of an archive by that of its main file. Reports an archive without a main
  /// file, and returns false.
  bool enter_archive(std::string& path, Span reference) {
    if (!context_.files.is_file(path)) {
      read_source(path, reference, rules::sml5006_missing_entity_file, context_);
      return false;
    }
    const auto [known, is_new] = archives_.try_emplace(path);
    if (is_new) known->second = main_file_of_archive(path, context_.files);
    if (known->second.path.empty()) {
      context_.sink.report(rules::sml5006_missing_entity_file, reference,
                           "cannot read `" + path + "`: it " + known->second.reason);
      return false;
    }
    path = known->second.path;
    return true;
  }

  void add_instance(UseIndex use, std::size_t index, const std::string& type,
                    const std::string& path, bool is_usable) {
    const Entity& entity = this->entity(use, index);
    Instance instance;
    instance.name = entity.name.value_or({});
    instance.path = unique_path(use, entity, path, type);
    instance.use = use;
    instance.entity = index;
    instance.type = type;
    instance.file = is_old_scene(type) ? first_names_.of(path) : path;
    if (!is_usable) {
      scene_.is_complete = false;
    } else if (kind_of(type) == EntityKind::model) {
      instance.model = model_file(first_names_.of(path), file_of(entity).span);
    } else if (!path.empty() && path.find(":/") == std::string::npos) {
      check_data_file(path, file_of(entity).span, type);
    }
    bytes_ += instance.path.size() + instance.name.size() + type.size() + path.size() +
              references_of(entity) + inherited_[to_size(use)];
    const InstanceIndex number{static_cast<std::uint32_t>(scene_.instances.size())};
    if (entity.name) names_.add(use, *entity.name, number);
    scene_.instances.push_back(std::move(instance));
  }

  std::optional<ModelIndex> model_file(const std::string& path, Span reference) {
    const auto known = models_.find(path);
    if (known != models_.end()) {
      if (!known->second) report_again(path, reference, rules::sml5006_missing_entity_file);
      return known->second;
    }
    std::optional<ModelIndex>& index = models_[path];
    if (const auto made = made_models_.find(path); made != made_models_.end()) {
      index = ModelIndex{static_cast<std::uint32_t>(scene_.models.size())};
      scene_.models.push_back(load_made_model(path, std::move(made->second), context_));
      return index;
    }
    if (!context_.files.is_file(path)) {
      scene_.is_complete = false;
      read_source(path, reference, rules::sml5006_missing_entity_file, context_);
      return index;
    }
    index = ModelIndex{static_cast<std::uint32_t>(scene_.models.size())};
    scene_.models.push_back(load_model(path, context_));
    return index;
  }

  /// The files of entity types with user schemas may contain sections with schemas.
  void read_data_file(const std::string& path, Span reference, const std::string& type) {
    if (context_.schemas == nullptr || !context_.schemas->has_entity_type(type)) return;
    const std::string extension = path::to_lower(path::extension(path));
    if (extension != ".yml" && extension != ".yaml" && extension != ".json") return;
    const auto source = read_source(path, reference, rules::sml5006_missing_entity_file, context_);
    if (!source) return;
    auto document = parse_yaml(context_.sources, *source, context_.limits, context_.sink);
    if (document) scene_.data_files.push_back({*source, std::move(*document)});
  }

  /// Files of other types are not read. A plug-in may look for its file in other folders.
  void check_data_file(const std::string& path, Span reference, const std::string& type) {
    const auto [known, is_new] = data_files_.emplace(first_names_.of(path), true);
    if (is_new) known->second = context_.files.is_file(path);
    if (known->second) {
      if (is_new) read_data_file(path, reference, type);
      return;
    }
    const bool is_denied = context_.files.is_denied(path);
    Diagnostic& diagnostic = context_.sink.report(
        rules::sml5006_missing_entity_file, reference,
        is_denied ? "cannot read `" + path + "`: " + context_.files.read(path, 0).reason
                  : "there is no file `" + path + "`");
    if (!is_old_scene(type)) diagnostic.severity = Severity::warning;
    if (!is_new || is_denied) return;
    const Rule& rule = *diagnostic.rule;
    if (const auto similar = similar_file(path, rule, context_)) {
      diagnostic.help("did you mean `" + *similar + "`?");
    }
  }

  void include(UseIndex outer, std::size_t index, const std::string& path) {
    const Entity& entity = this->entity(outer, index);
    const std::string use_path = unique_path(outer, entity, path, "scene");
    std::optional<SceneIndex> file;
    if (!path.empty() && !is_cyclic(outer, entity, path) && !is_too_deep(outer, entity)) {
      file = scene_file(path, file_of(entity).span, rules::sml5006_missing_entity_file);
    }
    if (!file) {
      lose_scene();
      // The name stays known, so references to it are not also reported.
      file = empty_scene();
    }
    const UseIndex use = add_use({*file, use_path, outer, index, {}});
    if (this->entity(outer, index).name) {
      names_.add(outer, *this->entity(outer, index).name, use);
    }
    expand(use);
  }

  SceneIndex empty_scene() {
    if (!empty_scene_) {
      empty_scene_ = SceneIndex{static_cast<std::uint32_t>(scene_.scenes.size())};
      scene_.scenes.emplace_back();
    }
    return *empty_scene_;
  }

  bool is_cyclic(UseIndex outer, const Entity& entity, const std::string& path) {
    const auto known = scene_files_.find(path);
    if (known == scene_files_.end() || !known->second) return false;
    std::vector<SceneIndex> chain;  // starting at the innermost scene
    for (std::optional<UseIndex> at = outer; at; at = scene_.uses[to_size(*at)].outer) {
      chain.push_back(scene_.uses[to_size(*at)].scene);
      if (chain.back() != *known->second) continue;
      Diagnostic& diagnostic =
          context_.sink.report(rules::sml5020_cyclic_include, file_of(entity).span,
                               *at == outer ? "this scene includes itself"
                                            : "this include leads back to " + quoted(path));
      diagnostic.note(describe(chain));
      return true;
    }
    return false;
  }

  /// "`a` includes `b` includes `a`"; of a long chain, only its ends.
  std::string describe(const std::vector<SceneIndex>& chain) const {
    constexpr std::size_t kMostAtEnd = 4;
    const auto name = [&](SceneIndex scene) { return quoted(scene_.scenes[to_size(scene)].path); };
    std::string text;
    for (std::size_t i = chain.size(); i-- > 0;) {
      const bool is_shown = i < kMostAtEnd || chain.size() - i <= kMostAtEnd;
      if (is_shown) text += name(chain[i]) + " includes ";
      if (i == kMostAtEnd && !is_shown) text += "... includes ";
    }
    return text + name(chain.back());
  }

  bool is_too_deep(UseIndex outer, const Entity& entity) {
    std::uint32_t depth = 0;
    for (std::optional<UseIndex> at = outer; at; at = scene_.uses[to_size(*at)].outer) ++depth;
    if (depth <= context_.limits.include_depth) return false;
    context_.sink
        .report(rules::sml5021_nested_too_deep, file_of(entity).span,
                "scenes are nested more than " + std::to_string(context_.limits.include_depth) +
                    " deep")
        .help(raise_limit("include-depth"));
    return true;
  }

  /// Checks the file that every kind of entity needs. Reports at most one finding.
  bool check_kind(UseIndex use, const Entity& entity, const std::string& type,
                  const std::string& path) {
    const EntityKind kind = kind_of(type);
    if (entity.file.written && !entity.file && !entity.uri) return false;  // reported by the reader
    if (entity.type.written && !entity.type) return false;
    if (type.empty() || (path.empty() && (kind != EntityKind::other || is_old_scene(type)))) {
      Diagnostic& diagnostic =
          context_.sink.report(rules::sml5005_entity_without_file, place_of(entity),
                               path.empty() ? "this entity has no `file`"
                                            : "this entity has no `type`, and `" + path +
                                                  "` has no extension that determines it");
      if (type == "smurfs") diagnostic.when(cases::kOfScene);
      diagnostic.help("name the .smurf, .urdf or .smurfs of the entity");
      if (xacro::is_xacro_file(path)) explain_xacro(path, diagnostic);
      if (path.empty()) suggest_file(use, entity, diagnostic);
      return false;
    }
    const std::string extension = path::to_lower(path::extension(path));
    if (is_archive_type(type)) {
      return check_extension(entity, type, path, {"." + path::to_lower(type)});
    }
    const bool is_scene_file = extension == ".smurfs" || extension == ".smurfa";
    if (kind == EntityKind::scene && !is_scene_file) {
      context_.sink.report(rules::sml5008_scene_extension, file_of(entity).span,
                           "an entity of type `" + type +
                               "` needs a .smurfs or .smurfa, so nothing is read from `" +
                               std::string(path::file_name(path)) + "`");
      return false;
    }
    if (path::to_lower(type) == "xacro") return check_extension(entity, type, path, {".urdf"});
    const ModelType* model = model_type(type);
    return model == nullptr ||
           check_extension(entity, type, path,
                           {model->extensions.begin(), model->extensions.end()});
  }

  bool check_extension(const Entity& entity, const std::string& type, const std::string& path,
                       const std::vector<std::string>& expected) {
    const std::string extension = path::to_lower(path::extension(path));
    if (ranges::contains(expected, extension)) return true;
    std::string wanted;
    for (const std::string& one : expected) wanted += (wanted.empty() ? "" : " or ") + one;
    Diagnostic& diagnostic =
        context_.sink.report(rules::sml5009_entity_type_mismatch, file_of(entity).span,
                             "an entity of type `" + type + "` needs a " + wanted + ", which `" +
                                 std::string(path::file_name(path)) + "` is not");
    if (const std::string_view type_there = type_of_extension(extension); !type_there.empty()) {
      diagnostic.when(cases::kOfAnotherKind);
      diagnostic.help("write `type: " + std::string(type_there) + "`");
    }
    if (xacro::is_xacro_file(path)) explain_xacro(path, diagnostic);
    return false;
  }

  static void explain_xacro(const std::string& path, Diagnostic& diagnostic) {
    diagnostic.note("no reader of scenes expands xacro");
    diagnostic.help(how_to_expand(path) + ", and name that");
  }

  /// Then, the place is a misspelt key (`fiel`).
  void suggest_file(UseIndex use, const Entity& entity, Diagnostic& diagnostic) const {
    constexpr std::string_view kFile[] = {"file"};
    constexpr std::string_view kOtherWords[] = {"path",     "model", "uri",
                                                "filename", "urdf",  "smurf"};
    for (const CustomSection& key : entity.extra) {
      if (!nearest(key.name.value, kFile) && !ranges::contains(kOtherWords, key.name.value)) {
        continue;
      }
      diagnostic.span = key.name.span;
      diagnostic.help("did you mean `file` instead of `" + key.name.value + "`?");
      const yaml::Document& document = *scene_.file(scene_.uses[to_size(use)]).document;
      KeyRenames(yaml::View(document, entity.node))
          .offer(diagnostic.fixes, {document, key.node}, "file");
      return;
    }
  }

  /// "outer/name"; repeated and missing names get a number.
  std::string unique_path(UseIndex use, const Entity& entity, const std::string& file,
                          std::string_view type) {
    const std::string& around = scene_.uses[to_size(use)].path;
    const bool is_named = entity.name && !entity.name->empty();
    const std::string_view name = is_named ? *entity.name : file.empty() ? type : path::stem(file);
    std::string path;
    path.reserve(around.size() + 1 + name.size());  // paths may have 100 MB in total
    path += around;
    if (!path.empty()) path += '/';
    path += name;
    if (is_named && paths_.insert(path).second) return path;
    std::uint32_t& number = numbers_[path];
    std::string numbered;
    do {
      ++number;
      const std::uint32_t shown = is_named ? number + 1 : number;
      numbered = path + "#" + std::to_string(shown);
    } while (!paths_.insert(numbered).second);
    return numbered;
  }

  LoadContext& context_;
  LinkedScene& scene_;
  SceneNames& names_;
  std::map<std::string, std::optional<SceneIndex>> scene_files_;
  std::map<std::string, std::optional<ModelIndex>> models_;
  MadeModels made_models_;
  std::map<std::string, bool> data_files_;
  FirstNames first_names_{context_.files};
  std::map<std::string, ArchivedMain> archives_;
  std::set<std::string> paths_;
  std::map<std::string, std::uint32_t> numbers_;
  std::optional<SceneIndex> empty_scene_;
  /// Bytes of the texts of instances. A long one may be repeated in all entities of a nested scene.
  std::uint64_t bytes_ = 0;
  std::vector<std::uint64_t> inherited_;  ///< by use: of the references of the includes around it
  bool is_full_ = false;
};

}  // namespace

std::string entity_type(const Entity& entity) {
  if (entity.type && !entity.type->empty()) return *entity.type;
  const Field<std::string>& file = file_of(entity);
  const std::string_view extension = file ? path::extension(*file) : std::string_view{};
  return extension.empty() ? std::string() : std::string(extension.substr(1));
}

bool expand_scene(const std::string& path, LoadContext& context, LinkedScene& scene,
                  SceneNames& names) {
  return SceneExpander(context, scene, names).run(path);
}

}  // namespace smurf
