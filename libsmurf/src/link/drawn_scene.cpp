// SPDX-License-Identifier: BSD-3-Clause
// MARS makes keys of every group (`file`, `orientation_z`, `origin_x`, `origin_y`, `origin_z`) and
// merges the YAML file of its title over them (SMURFLoader.cpp:127-302, 564-578). This file does
// the same with trees, so that a drawn scene is read, checked and flattened like a written one, and
// every value keeps its place. `position` and `rotation`, which MARS leaves to the plug-in, follow
// from those keys.
#include "link/drawn_scene.hpp"

#include <algorithm>
#include <map>
#include <unordered_map>

#include "ast/drawing_reader.hpp"
#include "base/files/path.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "link/file_index.hpp"
#include "link/read_file.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

/// A YAML tree to which nodes are added at the end.
class Tree {
 public:
  yaml::NodeId add(yaml::NodeId parent, yaml::Kind kind, Span span) {
    const yaml::NodeId id{static_cast<std::uint32_t>(document.nodes.size())};
    document.nodes.emplace_back(kind, span).parent = parent;
    if (parent != yaml::kNoNode) append(parent, id, 1);
    return id;
  }

  yaml::NodeId add_member(yaml::NodeId parent, std::string_view key, yaml::Kind kind, Span span) {
    const yaml::NodeId id = add(parent, kind, span);
    at(id).set_key(key, span);
    return id;
  }

  void set_text(yaml::NodeId id, std::string text) {
    at(id).set_text(document.decoded.emplace_back(std::move(text)));
  }

  void add_number(yaml::NodeId parent, std::string_view key, double value, Span span) {
    set_text(add_member(parent, key, yaml::Kind::scalar, span), format_number(value));
  }

  /// Copies the tree of a file into this one and returns its root, which is not yet a child.
  yaml::NodeId graft(const yaml::Document& other) {
    const auto first = static_cast<std::uint32_t>(document.nodes.size());
    const auto moved = [&](yaml::NodeId id) {
      return id == yaml::kNoNode ? id : yaml::NodeId{static_cast<std::uint32_t>(id) + first};
    };
    for (yaml::Node node : other.nodes) {
      node.parent = moved(node.parent);
      node.next_sibling = moved(node.next_sibling);
      if (node.is_alias()) {
        node.set_target(moved(node.target()));
      } else if (node.first_child() != yaml::kNoNode) {
        node.set_children(moved(node.first_child()), node.child_count());
      }
      document.nodes.push_back(node);
    }
    return moved(other.root);
  }

  /// Appends the members of `parent` to `mapping`; many mappings can share them.
  void share_members(yaml::NodeId parent, yaml::NodeId mapping) {
    if (at(mapping).first_child() != yaml::kNoNode) {
      append(parent, at(mapping).first_child(), at(mapping).child_count());
    }
  }

  yaml::Node& at(yaml::NodeId id) { return document.nodes[static_cast<std::size_t>(id)]; }

  yaml::Document document;

 private:
  void append(yaml::NodeId parent, yaml::NodeId child, std::uint32_t count) {
    yaml::Node& node = at(parent);
    at(child).set_position(node.child_count());
    const bool is_first = node.first_child() == yaml::kNoNode;
    if (!is_first) at(last_[static_cast<std::size_t>(parent)]).next_sibling = child;
    node.set_children(is_first ? child : node.first_child(), node.child_count() + count);
    last_[static_cast<std::size_t>(parent)] = child;
  }

  std::unordered_map<std::size_t, yaml::NodeId> last_;  ///< children, by parent
};

class DrawnSceneReader {
 public:
  DrawnSceneReader(SceneFile& file, std::vector<DataFile>& data_files, LoadContext& context)
      : file_(file), data_files_(data_files), context_(context) {}

  bool run() {
    file_.drawing = parse_xml(context_.sources, file_.source, context_.limits, context_.sink);
    if (!file_.drawing || !file_.drawing->view()) return false;
    const Span page = file_.drawing->view().name_span();
    tree_.document.source = file_.source;
    const yaml::NodeId root = tree_.add(yaml::kNoNode, yaml::Kind::mapping, page);
    tree_.document.root = root;
    entities_ = tree_.add_member(root, "entities", yaml::Kind::sequence, page);
    const std::size_t known = context_.sink.diagnostics().size();
    for (const DrawnEntity& entity : read_drawing(*file_.drawing, context_.sink)) {
      if (!is_full_) add(entity);
    }
    file_.document = std::move(tree_.document);
    const auto& found = context_.sink.diagnostics();
    return std::none_of(
        found.begin() + static_cast<std::ptrdiff_t>(known), found.end(),
        [](const Diagnostic& diagnostic) { return diagnostic.severity == Severity::error; });
  }

 private:
  /// The keys that the YAML file of a title adds to all its entities.
  struct Keys {
    yaml::NodeId mapping = yaml::kNoNode;  ///< in the tree
    bool has_file = false, has_position = false, has_rotation = false;
    /// `origin_x`, `origin_y`, `origin_z`, `orientation_z`, if the file overrides them.
    std::optional<double> overridden[4];
    bool is_overridden[4] = {};
  };
  static constexpr std::string_view kPoseKeys[] = {"origin_x", "origin_y", "origin_z",
                                                   "orientation_z"};

  void add(const DrawnEntity& drawn) {
    const auto [known, is_new] = keys_.try_emplace(drawn.file.value);
    if (is_new) known->second = keys_in(drawn.file);
    if (!known->second || !has_room(*known->second, drawn)) return;
    const Keys& keys = *known->second;
    const yaml::NodeId entity = tree_.add(entities_, yaml::Kind::mapping, drawn.group);
    if (!keys.has_file) {
      tree_.set_text(tree_.add_member(entity, "file", yaml::Kind::scalar, drawn.file.span),
                     drawn.file.value);
    }
    double pose[] = {drawn.x, drawn.y, drawn.z, drawn.yaw};
    const Span places[] = {drawn.place, drawn.place, drawn.height, drawn.place};
    for (std::size_t i = 0; i < 4; ++i) {
      if (!keys.is_overridden[i]) tree_.add_number(entity, kPoseKeys[i], pose[i], places[i]);
      pose[i] = keys.overridden[i].value_or(pose[i]);
    }
    if (!keys.has_position) {
      const yaml::NodeId position =
          tree_.add_member(entity, "position", yaml::Kind::sequence, drawn.place);
      for (std::size_t i = 0; i < 3; ++i) {
        tree_.set_text(tree_.add(position, yaml::Kind::scalar, places[i]), format_number(pose[i]));
      }
    }
    if (!keys.has_rotation) tree_.add_number(entity, "rotation", pose[3], drawn.place);
    if (keys.mapping != yaml::kNoNode) tree_.share_members(entity, keys.mapping);
  }

  /// Each entity is read with all keys of its file, so many entities may repeat many keys.
  bool has_room(const Keys& keys, const DrawnEntity& drawn) {
    if (keys.mapping == yaml::kNoNode) return true;
    shared_ += tree_.at(keys.mapping).child_count();
    if (shared_ <= context_.limits.yaml_nodes) return true;
    is_full_ = true;
    context_.sink
        .report(rules::sml0002_file_too_large, drawn.file.span,
                "with the keys of this file, the entities of the drawing have more than " +
                    std::to_string(context_.limits.yaml_nodes) + " values")
        .help(raise_limit("yaml-nodes"));
    return false;
  }

  /// None if the file is missing or broken, which is reported at its first title.
  std::optional<Keys> keys_in(const Spanned<std::string>& title) {
    const std::string path = path::join(path::parent(file_.path), title.value);
    const std::string extension = path::to_lower(path::extension(path));
    // MARS would read these files as YAML with keys of an entity, but they are entities.
    for (const std::string_view own : {".smurf", ".urdf", ".smurfs", ".smurfa"}) {
      if (extension == own) return Keys{};
    }
    const auto [known, is_new] = keys_by_file_.try_emplace(key_of_file(path, context_.files));
    if (is_new) known->second = read_keys(title, path);
    return known->second;
  }

  std::optional<Keys> read_keys(const Spanned<std::string>& title, const std::string& path) {
    const auto source = read_source(path, title.span, rules::sml5006_missing_entity_file, context_);
    if (!source) return std::nullopt;
    auto document = parse_yaml(context_.sources, *source, context_.limits, context_.sink);
    if (!document) return std::nullopt;
    data_files_.push_back({*source, std::move(*document)});
    const yaml::View root = data_files_.back().document.view();
    if (root && !root.is_mapping()) {
      context_.sink.report(rules::sml2011_root_not_mapping, root.span(),
                           "the keys of a drawn entity must be a mapping");
      return std::nullopt;
    }
    return keys_of(root, title, path);
  }

  std::optional<Keys> keys_of(yaml::View root, const Spanned<std::string>& title,
                              const std::string& path) {
    const auto has = [&](std::string_view key) { return root && root.find(key); };
    if (!has("type") && !has("file")) {
      context_.sink.report(rules::sml5005_entity_without_file, title.span,
                           "`" + path + "` gives this entity neither a `type` nor a `file`");
      return std::nullopt;
    }
    Keys keys;
    keys.has_file = has("file");
    keys.has_position = has("position");
    keys.has_rotation = has("rotation");
    for (std::size_t i = 0; i < 4; ++i) {
      const yaml::View value = root.find(kPoseKeys[i]);
      keys.is_overridden[i] = static_cast<bool>(value);
      if (value) keys.overridden[i] = value.number();
    }
    keys.mapping = tree_.graft(data_files_.back().document);
    tree_.at(keys.mapping).parent = entities_;
    if (keys.has_file) rebase_file(keys.mapping, path);
    return keys;
  }

  /// Paths in the YAML file are relative to its folder, those in the scene to the folder of the
  /// drawing.
  void rebase_file(yaml::NodeId mapping, const std::string& path) {
    for (yaml::NodeId id = tree_.at(mapping).first_child(); id != yaml::kNoNode;
         id = tree_.at(id).next_sibling) {
      yaml::Node& node = tree_.at(id);
      if (node.key() != "file" || node.kind() != yaml::Kind::scalar || node.text().empty())
        continue;
      const std::string target = path::join(path::parent(path), node.text());
      tree_.set_text(id, path::relative(target, path::parent(file_.path)));
    }
  }

  SceneFile& file_;
  std::vector<DataFile>& data_files_;
  LoadContext& context_;
  Tree tree_;
  yaml::NodeId entities_ = yaml::kNoNode;
  std::map<std::string, std::optional<Keys>> keys_;  ///< by title
  std::map<std::string, std::optional<Keys>> keys_by_file_;
  std::uint64_t shared_ = 0;  ///< keys added by files, counted for each entity
  bool is_full_ = false;
};

}  // namespace

bool is_drawing(std::string_view path) { return path::extension(path) == ".svg"; }

bool read_drawn_scene(SceneFile& file, std::vector<DataFile>& data_files, LoadContext& context) {
  return DrawnSceneReader(file, data_files, context).run();
}

}  // namespace smurf
