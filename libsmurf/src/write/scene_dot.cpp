// SPDX-License-Identifier: BSD-3-Clause
// Shows which entities are fixed to each other, for Graphviz. Nested scenes are boxes around their
// entities.
#include "base/text/misread.hpp"
#include "base/text/utf8.hpp"
#include "smurf/write_scene.hpp"
#include "write/parts/scene_parts.hpp"

namespace smurf::scene_dot_file {
namespace {

/// A quoted string; a backslash would start an escape in a label. Characters that could be misread
/// become entities, which Graphviz supports in labels, so `&` becomes one as well.
std::string quoted(std::string_view text) {
  const std::string clean = utf8::replace_controls(text);
  std::string escaped = "\"";
  for (std::size_t at = 0; at < clean.size();) {
    const std::string_view rest = std::string_view(clean).substr(at);
    const utf8::CodePoint point = utf8::decode(rest);
    switch (point.value) {
    case '\n':
    case '\t': escaped += ' '; break;
    case '&': escaped += "&amp;"; break;
    case '"':
    case '\\': escaped += '\\'; [[fallthrough]];
    default:
      escaped += is_misread(clean, at, point.value) ? "&#" + std::to_string(point.value) + ";"
                                                    : std::string(rest.substr(0, point.size));
    }
    at += point.size;
  }
  return escaped + '"';
}

class DotWriter {
 public:
  explicit DotWriter(const SceneExport& scene) : scene_(scene), indent_("  ") {}

  std::string run() {
    out_ = "digraph " + quoted(scene_.flat.scene) +
           " {\n"
           "  rankdir=LR\n"
           "  node [shape=box, style=rounded, fontname=\"sans-serif\"]\n"
           "  edge [fontname=\"sans-serif\", fontsize=10]\n"
           "  graph [fontname=\"sans-serif\", style=rounded, color=gray]\n"
           "  \":world\" [label=\"world\", shape=doublecircle]\n";
    for (std::size_t i = 0; i < scene_.flat.instances.size(); ++i) {
      enter(scene_.scene.instances[i].use);
      add_node(scene_.flat.instances[i]);
    }
    enter(UseIndex{0});
    for (const FlatInstance& instance : scene_.flat.instances) add_edges(instance);
    return std::move(out_) + "}\n";
  }

 private:
  /// Closes and opens the boxes of scenes between one instance and the next.
  void enter(UseIndex use) {
    std::vector<UseIndex> chain;
    for (std::optional<UseIndex> at = use; at && scene_.scene.uses[to_size(*at)].outer;
         at = scene_.scene.uses[to_size(*at)].outer) {
      chain.insert(chain.begin(), *at);
    }
    std::size_t shared = 0;
    while (shared < chain.size() && shared < open_.size() && chain[shared] == open_[shared]) {
      ++shared;
    }
    for (; open_.size() > shared; open_.pop_back()) {
      indent_.resize(indent_.size() - 2);
      out_ += indent_ + "}\n";
    }
    for (; open_.size() < chain.size(); open_.push_back(chain[open_.size()])) {
      const SceneUse& opened = scene_.scene.uses[to_size(chain[open_.size()])];
      out_ += indent_ + "subgraph " + quoted("cluster " + opened.path) + " {\n";
      indent_ += "  ";
      out_ += indent_ + "label=" + quoted(opened.path) + "\n";
    }
  }

  void add_node(const FlatInstance& instance) {
    const std::string name = instance.name.empty() ? instance.path : instance.name;
    const std::string what =
        instance.model ? scene_.flat.models[*instance.model].id : instance.type;
    std::string label = quoted(name);
    label.back() = '\\';  // the closing quote is removed for a line break
    out_ +=
        indent_ + quoted(instance.path) + " [label=" + label + "n" + quoted(what).substr(1) + "]\n";
  }

  static std::string node(const FlatAttachment& attachment) {
    return attachment.kind == Attachment::Kind::link ? quoted(attachment.instance) : "\":world\"";
  }

  static std::string at_link(std::string_view what, const FlatAttachment& attachment) {
    std::string text(what);
    if (attachment.kind == Attachment::Kind::link) text += " " + attachment.link;
    return quoted(text);
  }

  /// Solid: fixed. Dashed: only placed relative to it.
  void add_edges(const FlatInstance& instance) {
    const bool is_fixed = is_fixed_to_world(instance);
    const bool is_free = !is_fixed && instance.anchor.kind != Attachment::Kind::link;
    const bool is_placed_elsewhere =
        instance.parent.kind == Attachment::Kind::link &&
        (is_fixed || instance.anchor.instance != instance.parent.instance ||
         instance.anchor.link != instance.parent.link);
    if (is_free || is_placed_elsewhere) {
      const std::string label = at_link(is_free ? "free" : "placed at", instance.parent);
      out_ += "  " + node(instance.parent) + " -> " + quoted(instance.path) + " [label=" + label +
              ", style=dashed]\n";
    }
    if (is_free) return;
    const FlatAttachment anchor = is_fixed ? FlatAttachment{} : instance.anchor;
    const std::string fixed = at_link(is_fixed ? "fixed" : "fixed to", anchor);
    out_ += "  " + node(anchor) + " -> " + quoted(instance.path) + " [label=" + fixed + "]\n";
  }

  const SceneExport& scene_;
  std::string indent_;
  std::vector<UseIndex> open_;
  std::string out_;
};

std::string write(const SceneExport& scene) { return DotWriter(scene).run(); }

}  // namespace

extern constinit const SceneFormat scene_dot{
    .name = "dot",
    .help = "the attachments between instances, as a Graphviz graph",
    .write = write};

}  // namespace smurf::scene_dot_file
