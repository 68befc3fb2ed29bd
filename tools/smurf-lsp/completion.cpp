// SPDX-License-Identifier: BSD-3-Clause
// Completion: keys, words, names, files, elements and attributes at the cursor.
#include <algorithm>
#include <map>

#include "base/files/path.hpp"
#include "base/text/edits.hpp"
#include "config/companion_help.hpp"
#include "config/key_help.hpp"
#include "link/extension_names.hpp"
#include "link/surroundings/wanted_names.hpp"
#include "render/printable.hpp"
#include "smurf-lsp/capabilities.hpp"
#include "smurf-lsp/xacro_completion.hpp"
#include "smurf-lsp/xml_context.hpp"
#include "smurf-lsp/yaml_context.hpp"
#include "smurf/check.hpp"
#include "smurf/companions.hpp"

namespace smurf::lsp {
namespace {

// CompletionItemKind of the protocol.
constexpr int kFunctionItem = 3, kPropertyItem = 10, kValue = 12, kSnippet = 15, kFile = 17,
              kReference = 18, kFolder = 19, kClassItem = 7;
constexpr int kIsSnippet = 2;  // InsertTextFormat
constexpr std::size_t kMostItems = 2000;

class Completer {
 public:
  Completer(Context& context, const Json& params)
      : context_(context), path_(path_in(params)), text_(context.workspace.document(path_)->text) {
    offset_ = offset_in(text_, at(params, {"position"}), context.client.encoding);
  }

  Json run() {
    const CompanionSpec* kind = find_companion_kind(path_, text_);
    if (kind == nullptr && is_surrounding_file(path_, text_)) {
      complete_surroundings();
    } else if (kind != nullptr && !kind->is_xml) {
      complete_companion({kind->title, text_});
      if (items_.empty()) complete_frame();
    } else if (const auto language = key_language(path_)) {
      complete_yaml(*language);
    } else {
      complete_xml();
    }
    const bool is_incomplete = items_.size() >= kMostItems;
    return {{"isIncomplete", is_incomplete}, {"items", std::move(items_)}};
  }

 private:
  Json position(std::size_t offset) const {
    const std::size_t before = offset == 0 ? text_.npos : text_.rfind('\n', offset - 1);
    const std::size_t begin = before == text_.npos ? 0 : before + 1;
    const auto line =
        std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(begin), '\n');
    const std::string_view rest = std::string_view(text_).substr(begin, offset - begin);
    return {{"line", line}, {"character", units_in(rest, context_.client.encoding)}};
  }

  void set_place(std::size_t begin, std::size_t end, char quote = '\0') {
    written_ = text_.substr(begin, end - begin);
    quote_ = quote;
    // Editors close a quote as soon as it is opened; the inserted text includes its quotes.
    if (quote != '\0' && end < text_.size() && text_[end] == quote) ++end;
    range_ = {{"start", position(begin)}, {"end", position(end)}};
  }

  Json& add(const std::string& label, int kind, const std::string& text,
            const std::string& detail = {}) {
    Json item = {{"label", label},
                 {"kind", kind},
                 {"filterText", label},
                 {"textEdit", {{"range", range_}, {"newText", text}}}};
    if (!detail.empty()) item["detail"] = detail;
    items_.push_back(std::move(item));
    return items_.back();
  }

  void add_snippet(Json& item, const std::string& text) const {
    if (!context_.client.takes_snippets) return;
    item["insertTextFormat"] = kIsSnippet;
    item["textEdit"]["newText"] = text;
  }

  static std::string detail_of(const KeyHelp& help) {
    std::string detail(help.value);
    if (!help.unit.empty()) detail += ", in " + std::string(help.unit);
    if (help.required) detail += " (required)";
    return detail;
  }

  // --- YAML

  void complete_yaml(KeyLanguage language) {
    const auto help_of = [&](std::span<const std::string> path) {
      return key_help(language, path);
    };
    const YamlContext context = yaml_context(text_, offset_);
    if (completes_value(context, help_of)) return;
    add_keys(keys_in(language, context.path), context);
    add_item(context, help_of);
  }

  /// A parameter file of ROS.
  void complete_companion(const CompanionLanguage& language) {
    const auto help_of = [&](std::span<const std::string> path) {
      return companion_key_help(language, path);
    };
    const YamlContext context = yaml_context(text_, offset_);
    if (completes_value(context, help_of) || add_item(context, help_of)) return;
    add_keys(companion_keys_in(language, context.path), context);
    add_names(companion_names_in(language, context.path), true);
  }

  /// A parameter of a companion that holds a link, as those of navigation do.
  void complete_frame() {
    const auto wanted = wanted_name(path_, text_, offset_, context_.workspace.limits());
    if (!wanted || wanted->kinds.empty()) return;
    context_.workspace.look_around(path_);
    set_place(wanted->begin, wanted->end);
    add_names_of(context_.workspace.views(path_), wanted->kinds, wanted->is_yaml);
  }

  /// A launch file, or a file of navigation or RViz: names of the robot and of its arguments.
  void complete_surroundings() {
    const auto wanted = wanted_name(path_, text_, offset_, context_.workspace.limits());
    if (!wanted) return;
    context_.workspace.look_around(path_);
    set_place(wanted->begin, wanted->end);
    const std::vector<FileView> views = context_.workspace.views_around(path_);
    if (!wanted->kinds.empty()) {
      add_names_of(views, wanted->kinds, wanted->is_yaml);
      return;
    }
    std::map<std::string, bool> arguments;  // with the mark of one that has no default
    for (const FileView& view : views) {
      if (view.launch == nullptr) continue;
      const auto& all = view.launch->descriptions;
      const bool is_its = std::any_of(all.begin(), all.end(), [&](const auto& one) {
        return one.is_of_robot && one.file && one.file->text.package == wanted->package &&
               one.file->text.text == wanted->file;
      });
      if (!is_its) continue;
      for (const XacroArgument& one : context_.workspace.surroundings_of(view).arguments) {
        if (!one.span.empty()) arguments.emplace(one.name, one.has_default);
      }
    }
    const bool is_set = std::string_view(text_).substr(wanted->end).starts_with(":=");
    for (const auto& [name, has_default] : arguments) {
      add(name, kPropertyItem, is_set ? name : name + ":=",
          has_default ? "argument of the xacro" : "argument of the xacro, without a default");
    }
  }

  /// Whether nothing but the value behind a key, which is completed, or a comment can stand here.
  template <class HelpOf>
  bool completes_value(const YamlContext& context, const HelpOf& help_of) {
    if (context.is_comment) return true;
    set_place(context.begin, context.end, context.quote);
    if (context.key.empty()) return false;
    KeyPath path = context.path;
    path.push_back(context.key);
    if (const auto help = help_of(path)) add_values(*help, true);
    return true;
  }

  /// An item of a list of names, files or words; false where no item stands.
  template <class HelpOf>
  bool add_item(const YamlContext& context, const HelpOf& help_of) {
    if (context.path.empty() || context.path.back() != kItem) return false;
    const auto list = std::span(context.path).first(context.path.size() - 1);
    if (const auto help = help_of(list)) add_values(*help, true);
    return true;
  }

  void add_keys(const std::vector<KeyHelp>& keys, const YamlContext& context) {
    const auto has = [&](const std::string& name) {
      return std::find(context.siblings.begin(), context.siblings.end(), name) !=
             context.siblings.end();
    };
    std::vector<const KeyHelp*> required;
    for (const KeyHelp& key : keys) {
      if (has(key.name)) continue;
      const bool is_block =
          !context.is_flow && (key.form == ValueForm::list || key.form == ValueForm::mapping);
      Json& item = add(key.name, kPropertyItem, end_quote(key.name) + (is_block ? ":" : ": "),
                       detail_of(key));
      if (!key.doc.empty()) item["documentation"] = markdown(key.doc);
      item["sortText"] = (key.required ? "0" : "1") + key.name;
      if (key.required) required.push_back(&key);
    }
    if (required.empty() || !context.siblings.empty() || context.is_flow || quote_ != '\0') return;
    std::string text;
    std::string snippet;
    for (std::size_t i = 0; i < required.size(); ++i) {
      const std::string line = i == 0 ? "" : "\n" + std::string(context.column, ' ');
      text += line + required[i]->name + ": ";
      snippet += line + required[i]->name + ": $" + std::to_string(i + 1);
    }
    const std::string label = "new " + required[0]->owner;
    add_snippet(add(label, kSnippet, text, "all required keys"), snippet);
  }

  // --- XML

  void complete_xml() {
    XmlContext context = xml_context(text_, offset_);
    if (const tools::XacroFamily* family = context_.workspace.xacro_family(path_)) {
      if (complete_xacro(*family, context)) return;
      // In the elements of xacro is what is around them.
      std::erase_if(context.open, [](std::string_view one) { return one.starts_with("xacro:"); });
    }
    set_place(context.begin, offset_);
    switch (context.kind) {
    case XmlContext::Kind::element: add_elements(context); return;
    case XmlContext::Kind::end_tag:
      if (!context.open.empty()) {
        const std::string name(context.open.back());
        add(name, kClassItem, name + ">");
      }
      return;
    case XmlContext::Kind::attribute: add_attributes(context); return;
    case XmlContext::Kind::value: add_attribute_values(context); return;
    default: return;
    }
  }

  /// Whether nothing else may be written there.
  bool complete_xacro(const tools::XacroFamily& family, const XmlContext& context) {
    XacroItems items = xacro_items(family, offset_, context);
    set_place(items.begin, offset_);
    for (const XacroItem& one : items.list) {
      if (render::escape(one.label) != one.label) continue;
      Json& item = add(one.label, kind_of(one.kind), one.text, one.detail);
      if (!one.snippet.empty()) add_snippet(item, one.snippet);
    }
    if (items.are_files) add_files(false);
    return items.are_all;
  }

  static int kind_of(XacroItem::Kind kind) {
    switch (kind) {
    case XacroItem::Kind::element: return kClassItem;
    case XacroItem::Kind::attribute: return kPropertyItem;
    case XacroItem::Kind::function: return kFunctionItem;
    case XacroItem::Kind::name: return kReference;
    }
    return kReference;
  }

  void add_attribute_values(const XmlContext& context) {
    unfinished_tag_ = context.tag;
    open_ = context.open;
    const std::string_view parent = open_.empty() ? std::string_view() : open_.back();
    if (is_of_companion(context)) {
      if (const auto help = companion_element_help(parent, context.element)) {
        for (const KeyHelp& key : help->attributes) {
          if (key.name == context.attribute) add_values(key, false);
        }
      }
      add_names(names_in_extension(parent, context.element, context.attribute), false);
      return;
    }
    const auto around = element_help(parent);
    const bool is_urdf = around && std::find(around->children.begin(), around->children.end(),
                                             context.element) != around->children.end();
    const auto help = is_urdf || open_.empty() ? element_help(context.element) : std::nullopt;
    if (!help) {
      add_names(names_in_extension(parent, context.element, context.attribute), false);
      return;
    }
    for (const KeyHelp& key : help->attributes) {
      if (key.name == context.attribute) add_values(key, false);
    }
  }

  /// Whether the element is one of SRDF or of ros2_control, not of URDF.
  bool is_of_companion(const XmlContext& context) const {
    return is_companion_path(path_) || std::find(context.open.begin(), context.open.end(),
                                                 "ros2_control") != context.open.end();
  }

  void add_elements_of_companion(const XmlContext& context) {
    const std::size_t depth = context.open.size();
    const std::string_view around = depth < 2 ? std::string_view() : context.open[depth - 2];
    if (depth == 0) {
      if (const auto root = companion_element_help("", root_element())) add_element(*root);
      return;
    }
    const auto parent = companion_element_help(around, context.open.back());
    if (!parent) return;
    for (const std::string_view child : parent->children) {
      const bool is_urdf = child == "ros2_control" && is_companion_path(path_);
      const auto help = companion_element_help(context.open.back(), child);
      if (help && !is_urdf) add_element(*help);
    }
  }

  void add_elements(const XmlContext& context) {
    if (is_of_companion(context)) return add_elements_of_companion(context);
    if (context.open.empty()) return add_element(root_element());
    if (context.open.size() == 1) {
      if (const auto help = companion_element_help("robot", "ros2_control")) add_element(*help);
    }
    const auto parent = element_help(context.open.back());
    if (!parent) return;
    for (const std::string_view child : parent->children) add_element(child);
  }

  void add_element(std::string_view name) {
    if (const auto help = element_help(name)) add_element(*help);
  }

  void add_element(const ElementHelp& help) {
    Json& item = add(std::string(help.name), kClassItem, std::string(help.name));
    item["documentation"] = markdown(help.doc);
    int stop = 0;
    add_snippet(item, element_text(help, stop, "\n"));
  }

  /// The text of an element after its "<", with all required parts. `line` begins a separate line.
  static std::string element_text(const ElementHelp& help, int& stop, const std::string& line) {
    std::string text(help.name);
    for (const KeyHelp& key : help.attributes) {
      if (key.is_usual) text += " " + key.name + "=\"$" + std::to_string(++stop) + "\"";
    }
    if (help.children.empty()) return text + "/>";
    text += ">";
    for (const std::string_view name : help.usual_children) {
      const auto child = element_help(name);
      if (child) text += line + "\t<" + element_text(*child, stop, line + "\t");
    }
    if (help.usual_children.empty()) text += line + "\t$" + std::to_string(++stop);
    return text + line + "</" + std::string(help.name) + ">";
  }

  void add_attributes(const XmlContext& context) {
    const std::string_view parent = context.open.empty() ? std::string_view() : context.open.back();
    const bool is_root = parent == "robot" && context.element == "ros2_control";
    const auto help = is_root || is_of_companion(context)
                          ? companion_element_help(parent, context.element)
                          : element_help(context.element);
    if (!help) return;
    for (const KeyHelp& key : help->attributes) {
      const auto& has = context.attributes;
      if (std::find(has.begin(), has.end(), key.name) != has.end()) continue;
      Json& item = add(key.name, kPropertyItem, key.name + "=\"\"", detail_of(key));
      if (!key.doc.empty()) item["documentation"] = markdown(key.doc);
      item["sortText"] = (key.required ? "0" : "1") + key.name;
      add_snippet(item, key.name + "=\"$1\"");
    }
  }

  // --- values of both

  void add_values(const KeyHelp& help, bool is_yaml) {
    for (const auto& words : {help.choices, help.known}) {
      for (const std::string_view word : words) {
        add(std::string(word), kValue, end_quote(std::string(word)), detail_of(help));
      }
    }
    if (!help.defines) add_names(help.names, is_yaml);
    if (help.is_path) add_files(is_yaml);
  }

  /// Adds the closing quote to the text of an item. A folder gets none, because the name of a file
  /// follows.
  std::string end_quote(std::string text) const {
    return quote_ == '\0' || text.ends_with('/') ? text : text + quote_;
  }

  std::string as_yaml(const std::string& name) const {
    if (quote_ == '\'') {
      std::string text;
      for (const char c : name) text += c == '\'' ? "''" : std::string(1, c);
      return end_quote(text);
    }
    constexpr std::string_view kLetters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
    const bool is_plain =
        !name.empty() &&
        name.find_first_not_of(std::string(kLetters) + "0123456789_-./") == std::string::npos &&
        (kLetters.find(name[0]) != kLetters.npos || name.starts_with("../"));
    if (quote_ == '\0' && is_plain) return name;
    std::string text;
    for (const char c : name) {
      text += c == '"' || c == '\\' ? "\\" + std::string(1, c) : std::string(1, c);
    }
    return quote_ == '\0' ? '"' + text + '"' : end_quote(text);
  }

  /// Names in the checked files: quoted where needed, and left out if a menu could not show them.
  void add_name(const std::string& name, int kind, const std::string& detail, bool is_yaml) {
    if (render::escape(name) != name) return;
    add(name, kind, is_yaml ? as_yaml(name) : escape_xml(name), detail);
  }

  static bool is_readable(const std::vector<FileView>& views) {
    return !views.empty() && std::none_of(views.begin(), views.end(), [](const FileView& one) {
      return one.yaml == nullptr && one.xml == nullptr;
    });
  }

  /// The views of the file. If it cannot be read, the word at the cursor is removed from the text,
  /// and unclosed elements around it are closed, because people often write from top to bottom.
  std::vector<FileView> readable_views() {
    std::vector<FileView> views = context_.workspace.views(path_);
    if (is_readable(views)) return views;
    if (unfinished_tag_ == text_.npos) {
      std::string rest = text_;
      const std::size_t before = offset_ == 0 ? text_.npos : text_.rfind('\n', offset_ - 1);
      const std::size_t begin = before == text_.npos ? 0 : before + 1;
      rest.erase(begin, std::min(text_.find('\n', offset_), text_.size()) - begin);
      return context_.workspace.views_with(path_, std::move(rest));
    }
    constexpr std::size_t kMostUnclosed = 3;  // each try reads the model
    for (std::size_t count = 0; count <= std::min(open_.size(), kMostUnclosed); ++count) {
      const auto unclosed = std::span(open_).last(count);
      views = context_.workspace.views_with(path_,
                                            without_tag(text_, unfinished_tag_, offset_, unclosed));
      if (is_readable(views)) break;
    }
    return views;
  }

  void add_names(NameKinds kinds, bool is_yaml) {
    if (!kinds.empty()) add_names_of(readable_views(), kinds, is_yaml);
  }

  void add_names_of(const std::vector<FileView>& views, NameKinds kinds, bool is_yaml) {
    std::map<std::string, NameKind> names;
    for (const FileView& view : views) {
      for (const Reference& one : context_.workspace.names().names()[view.part]) {
        const bool is_known = one.is_definition || one.kind == NameKind::material;
        if (!is_known || !kinds.contains(one.kind) || names.size() >= kMostItems) continue;
        names.try_emplace(std::string(one.name), one.kind);
      }
    }
    for (const auto& [name, kind] : names) {
      add_name(name, kReference, std::string(to_string(kind)), is_yaml);
    }
  }

  /// Files and folders, relative to the folder of the document.
  void add_files(bool is_yaml) {
    const std::size_t slash = written_.rfind('/');
    const std::string before = slash == std::string::npos ? "" : written_.substr(0, slash + 1);
    const std::string folder = path::join(path::parent(path_), before.empty() ? "." : before);
    for (const std::string& name : context_.workspace.files().list(folder)) {
      if (name.starts_with('.') || items_.size() >= kMostItems) continue;
      const std::string inner = path::join(folder, name);
      const bool is_file = context_.workspace.files().is_file(inner);
      if (is_file && input_kind(inner) == InputKind::other) continue;
      if (inner == path_) continue;
      add_name(before + name + (is_file ? "" : "/"), is_file ? kFile : kFolder, {}, is_yaml);
    }
    if (before.empty() || before.ends_with("../")) add(before + "../", kFolder, before + "../");
  }

  Context& context_;
  std::string path_;
  const std::string text_;
  std::size_t offset_ = 0;
  std::size_t unfinished_tag_ = std::string::npos;
  std::vector<std::string_view> open_;  ///< the elements around that tag
  char quote_ = '\0';                   ///< of YAML, open before the word
  Json range_;
  std::string written_;
  Json items_ = Json::array();
};

}  // namespace

Json completion(Context& context, const Json& params) {
  if (context.workspace.document(path_in(params)) == nullptr) return Json::array();
  return Completer(context, params).run();
}

}  // namespace smurf::lsp
