// SPDX-License-Identifier: BSD-3-Clause
#include "common/rename/xacro_names.hpp"

#include <algorithm>
#include <set>

namespace smurf::tools {
namespace {

/// The name of the macro that a tag calls, at its place.
TextRange called_range(const XacroTag& tag, std::string_view text) {
  const std::string_view name = called_macro(tag.name.of(text));
  if (!name.empty()) return {tag.name.end - name.size(), tag.name.end};
  if (tag.name.of(text) != "xacro:call") return {};
  const XacroAttribute* macro = tag.find(text, "macro");
  return macro != nullptr ? macro->value : TextRange{};
}

/// The tag in which a place is; null between tags.
const XacroTag* tag_at(const XacroFamily::File& file, std::size_t offset) {
  const XacroTag* found = nullptr;
  for (const XacroTag& tag : file.read.tags) {
    if (tag.tag.begin < offset && offset < tag.tag.end) found = &tag;
  }
  return found;
}

std::string_view name_of_macro(const XacroTag& macro, std::string_view text) {
  const XacroAttribute* name = macro.find(text, "name");
  return name != nullptr ? name->value.of(text) : std::string_view();
}

class Resolver {
 public:
  Resolver(const XacroFamily& family, std::size_t offset)
      : family_(family), own_(family.files.front()), text_(family.text(own_)), offset_(offset) {}

  std::optional<XacroMeaning> run() {
    for (const XacroName& one : own_.read.names) {
      if (!one.place.holds(offset_) || one.name.empty()) continue;
      const std::string_view macro =
          one.macro == XacroTag::kNone ? "" : name_of_macro(own_.read.tags[one.macro], text_);
      return meaning(one.kind, one.place, macro);
    }
    if (const XacroTag* tag = tag_at(own_, offset_)) {
      if (auto found = in_tag(*tag)) return found;
    }
    return in_expression();
  }

 private:
  std::optional<XacroMeaning> meaning(XacroNameKind kind, TextRange at,
                                      std::string_view macro = {}) const {
    const std::string_view name = at.of(text_);
    XacroMeaning found{kind, std::string(name), at, xacro_definitions(family_, kind, name, macro)};
    if (found.definitions.empty()) return std::nullopt;
    return found;
  }

  std::optional<XacroMeaning> in_tag(const XacroTag& tag) const {
    const TextRange called = called_range(tag, text_);
    if (called.holds(offset_) && called.end > called.begin) {
      return meaning(XacroNameKind::macro, called);
    }
    for (const XacroAttribute& one : tag.attributes) {
      if (one.name.holds(offset_) && called.end > called.begin) {
        return meaning(XacroNameKind::parameter, one.name, called.of(text_));
      }
      const bool is_block = tag.name.of(text_) == "xacro:insert_block" &&
                            one.name.of(text_) == "name" && one.value.holds(offset_);
      if (is_block) {
        const XacroTag* macro = xacro_macro_around(own_, text_, offset_);
        const std::string_view around = macro != nullptr ? name_of_macro(*macro, text_) : "";
        if (auto found = meaning(XacroNameKind::block, one.value, around)) return found;
        return meaning(XacroNameKind::property, one.value);
      }
    }
    return std::nullopt;
  }

  std::optional<XacroMeaning> in_expression() const {
    const XacroExpression around = xacro_expression_at(text_, offset_);
    if (around.kind == '\0' || around.word.begin == around.word.end) return std::nullopt;
    const std::string_view inner = around.inner.of(text_);
    if (around.kind == '(' && !inner.starts_with("eval")) {
      if (!inner.starts_with("arg") || around.word.begin == around.inner.begin) return std::nullopt;
      return meaning(XacroNameKind::argument, around.word);
    }
    const XacroTag* macro = xacro_macro_around(own_, text_, offset_);
    if (macro != nullptr) {
      auto found = meaning(XacroNameKind::parameter, around.word, name_of_macro(*macro, text_));
      if (found) return found;
    }
    if (auto found = meaning(XacroNameKind::property, around.word)) return found;
    // Scopes are dynamic: a macro sees the parameters of its callers.
    return meaning(XacroNameKind::parameter, around.word);
  }

  const XacroFamily& family_;
  const XacroFamily::File& own_;
  std::string_view text_;
  std::size_t offset_;
};

}  // namespace

std::vector<XacroMeaning::Definition> xacro_definitions(const XacroFamily& family,
                                                        XacroNameKind kind, std::string_view name,
                                                        std::string_view macro) {
  std::vector<XacroMeaning::Definition> found;
  for (const XacroFamily::File& file : family.files) {
    for (const XacroName& one : file.read.names) {
      if (one.kind != kind || one.name != name) continue;
      const bool is_of_other = !macro.empty() && one.macro != XacroTag::kNone &&
                               name_of_macro(file.read.tags[one.macro], family.text(file)) != macro;
      if (!is_of_other) found.push_back({&file, &one});
    }
  }
  return found;
}

const XacroTag* xacro_macro_around(const XacroFamily::File& file, std::string_view text,
                                   std::size_t offset) {
  const XacroTag* found = nullptr;
  for (const XacroTag& tag : file.read.tags) {
    const bool is_around = tag.tag.begin <= offset && offset < tag.end;
    if (is_around && tag.name.of(text) == "xacro:macro") found = &tag;
  }
  return found;
}

const XacroTag* MacrosAround::at(std::size_t offset) {
  const std::vector<XacroTag>& tags = file_.read.tags;
  for (; next_ < tags.size() && tags[next_].tag.begin <= offset; ++next_) {
    if (tags[next_].name.of(text_) == "xacro:macro") open_.push_back(&tags[next_]);
  }
  while (!open_.empty() && open_.back()->end <= offset) open_.pop_back();
  return open_.empty() ? nullptr : open_.back();
}

std::string_view macro_of(const XacroFamily& family, const XacroMeaning::Definition& definition) {
  const auto& [file, name] = definition;
  if (name->macro == XacroTag::kNone) return {};
  return name_of_macro(file->read.tags[name->macro], family.text(*file));
}

std::optional<XacroMeaning> xacro_meaning(const XacroFamily& family, std::size_t offset) {
  return Resolver(family, offset).run();
}

namespace {

class PlaceCollector {
 public:
  PlaceCollector(const XacroFamily& family, const XacroMeaning& meaning)
      : family_(family), meaning_(meaning) {}

  std::vector<XacroPlace> run() {
    for (const auto& [file, name] : meaning_.definitions) add(*file, name->place);
    for (const XacroFamily::File& file : family_.files) {
      switch (meaning_.kind) {
      case XacroNameKind::macro: calls(file); break;
      case XacroNameKind::argument: uses(file, true); break;
      case XacroNameKind::property: uses(file, false); break;
      case XacroNameKind::parameter:
      case XacroNameKind::block: of_parameter(file); break;
      }
    }
    return std::move(places_);
  }

 private:
  void add(const XacroFamily::File& file, TextRange range) { places_.push_back({&file, range}); }

  void calls(const XacroFamily::File& file) {
    const std::string_view text = family_.text(file);
    for (const XacroTag& tag : file.read.tags) {
      const TextRange called = called_range(tag, text);
      if (called.of(text) == meaning_.name) add(file, called);
    }
  }

  void uses(const XacroFamily::File& file, bool is_argument) {
    const std::string_view text = family_.text(file);
    std::set<std::size_t> hiding;  // macros that have a parameter of the name
    for (const XacroName& one : file.read.names) {
      if (one.macro != XacroTag::kNone && one.name == meaning_.name) hiding.insert(one.macro);
    }
    MacrosAround macros(file, text);
    for (const TextRange use : xacro_uses(text, meaning_.name, is_argument)) {
      const XacroTag* macro = is_argument || hiding.empty() ? nullptr : macros.at(use.begin);
      const bool is_hidden =
          macro != nullptr &&
          hiding.contains(static_cast<std::size_t>(macro - file.read.tags.data()));
      if (!is_hidden) add(file, use);
    }
  }

  /// A call that gives the parameter.
  void call(const XacroFamily::File& file, const XacroTag& tag) {
    const XacroAttribute* given = tag.find(family_.text(file), meaning_.name);
    if (given != nullptr) add(file, given->name);
  }

  void insertion(const XacroFamily::File& file, const XacroTag& tag) {
    const std::string_view text = family_.text(file);
    if (tag.name.of(text) != "xacro:insert_block") return;
    const XacroAttribute* block = tag.find(text, "name");
    if (block != nullptr && block->value.of(text) == meaning_.name) add(file, block->value);
  }

  /// A macro may be defined thousands of times: its calls are looked for once.
  void of_parameter(const XacroFamily::File& file) {
    const std::string_view text = family_.text(file);
    const auto all = xacro_uses(text, meaning_.name, false);
    std::set<std::string_view> known;
    for (const auto& [defining, name] : meaning_.definitions) {
      if (name->macro == XacroTag::kNone) continue;
      const XacroTag& macro = defining->read.tags[name->macro];
      const std::string_view called = name_of_macro(macro, family_.text(*defining));
      const bool is_new = known.insert(called).second;
      const bool is_own = defining == &file;
      const std::size_t first = is_new ? 0 : is_own ? name->macro : file.read.tags.size();
      for (std::size_t i = first; i < file.read.tags.size(); ++i) {
        const XacroTag& tag = file.read.tags[i];
        const bool is_inside =
            is_own && macro.tag.begin < tag.tag.begin && tag.tag.begin < macro.end;
        if (!is_new && tag.tag.begin >= macro.end) break;
        if (is_inside) insertion(file, tag);
        if (is_new && called_range(tag, text).of(text) == called) call(file, tag);
      }
      if (!is_own) continue;
      auto use = std::lower_bound(all.begin(), all.end(), macro.tag.end,
                                  [](const TextRange& a, std::size_t b) { return a.begin < b; });
      for (; use != all.end() && use->begin < macro.end; ++use) add(file, *use);
    }
  }

  const XacroFamily& family_;
  const XacroMeaning& meaning_;
  std::vector<XacroPlace> places_;
};

}  // namespace

std::vector<XacroPlace> xacro_end_tags(const XacroFamily& family, std::string_view macro) {
  std::vector<XacroPlace> places;
  for (const XacroFamily::File& file : family.files) {
    const std::string_view text = family.text(file);
    for (const XacroTag& tag : file.read.tags) {
      const TextRange called = called_range(tag, text);
      if (called.of(text) != macro || called.end != tag.name.end || tag.end <= tag.tag.end)
        continue;
      const std::string close = "</" + std::string(tag.name.of(text));
      const std::size_t end = text.rfind(close, tag.end);
      if (end == std::string_view::npos || end < tag.tag.end) continue;
      const std::size_t name_end = end + close.size();
      places.push_back({&file, {name_end - macro.size(), name_end}});
    }
  }
  return places;
}

std::vector<XacroPlace> xacro_places(const XacroFamily& family, const XacroMeaning& meaning) {
  return PlaceCollector(family, meaning).run();
}

}  // namespace smurf::tools
