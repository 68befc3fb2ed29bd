// SPDX-License-Identifier: BSD-3-Clause
#include "common/rename/xacro_rename.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "base/text/edits.hpp"
#include "base/text/quoted.hpp"
#include "smurf/config.hpp"

namespace smurf::tools {
namespace {

struct KindRow {
  XacroNameKind kind;
  std::string_view name;
};
constexpr std::array<KindRow, 5> kKinds = {{{XacroNameKind::macro, "macro"},
                                            {XacroNameKind::parameter, "parameter"},
                                            {XacroNameKind::block, "block"},
                                            {XacroNameKind::property, "property"},
                                            {XacroNameKind::argument, "argument"}}};

bool is_of_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// Why a name cannot be one of its kind; "" if it can.
std::string fault_of(XacroNameKind kind, std::string_view name) {
  const bool may_have_dashes = kind == XacroNameKind::macro || kind == XacroNameKind::argument;
  const bool is_word = std::all_of(name.begin(), name.end(), [&](char c) {
    return is_of_word(c) || (may_have_dashes && c == '-');
  });
  if (name.empty() || !is_word || (name[0] >= '0' && name[0] <= '9') || name[0] == '-') {
    return quoted(name) + " cannot be a name of this kind";
  }
  if (kind == XacroNameKind::macro && is_xacro_element(name)) {
    return "`xacro:" + std::string(name) + "` is an element of xacro";
  }
  return {};
}

/// Whether names of two kinds hide each other.
bool share_names(XacroNameKind a, XacroNameKind b) {
  const auto is_alone = [](XacroNameKind kind) {
    return kind == XacroNameKind::macro || kind == XacroNameKind::argument;
  };
  return a == b || (!is_alone(a) && !is_alone(b));
}

std::string place_in(const XacroFamily& family, const XacroFamily::File& file, TextRange range) {
  const std::string_view before = family.text(file).substr(0, range.begin);
  const auto line = 1 + std::count(before.begin(), before.end(), '\n');
  return "'" + family.sources.path(file.source) + "', line " + std::to_string(line);
}

/// The place that has the new name already; "" if there is none. Parameters of other macros may
/// have it.
std::string taken_at(const XacroFamily& family, const XacroRename& rename) {
  for (const XacroFamily::File& file : family.files) {
    for (const XacroName& one : file.read.names) {
      const bool is_of_other =
          !rename.macro.empty() && macro_of(family, {&file, &one}) != rename.macro;
      if (one.name != rename.to || !share_names(one.kind, rename.kind) || is_of_other) continue;
      return "the name of a " + std::string(to_string(one.kind)) + " in " +
             place_in(family, file, one.place);
    }
    if (rename.macro.empty()) continue;
    MacrosAround macros(file, family.text(file));
    for (const TextRange use : xacro_uses(family.text(file), rename.to, false)) {
      const XacroTag* macro = macros.at(use.begin);
      const XacroAttribute* name =
          macro != nullptr ? macro->find(family.text(file), "name") : nullptr;
      if (name == nullptr || name->value.of(family.text(file)) != rename.macro) continue;
      return "used in " + place_in(family, file, use);
    }
  }
  return {};
}

/// The places in the order of a file, each once.
std::map<const XacroFamily::File*, std::vector<TextRange>>
by_file(const std::vector<XacroPlace>& places) {
  std::map<const XacroFamily::File*, std::vector<TextRange>> files;
  for (const XacroPlace& one : places) files[one.file].push_back(one.range);
  for (auto& [file, ranges] : files) {
    std::sort(ranges.begin(), ranges.end(),
              [](const TextRange& a, const TextRange& b) { return a.begin < b.begin; });
    const auto last =
        std::unique(ranges.begin(), ranges.end(),
                    [](const TextRange& a, const TextRange& b) { return a.begin == b.begin; });
    ranges.erase(last, ranges.end());
  }
  return files;
}

class Renaming {
 public:
  Renaming(const XacroFiles& files, const std::string& path, const XacroRename& rename,
           const CheckSettings& settings, Session& session, const FileReader& changeable)
      : files_(files),
        path_(path),
        rename_(rename),
        settings_(settings),
        session_(session),
        changeable_(changeable) {}

  RenamedXacro run() {
    const std::string what = std::string(to_string(rename_.kind)) + " " + quoted(rename_.from);
    find_places();
    if (places_.empty()) {
      return refuse("there is no " + what +
                    (rename_.macro.empty() ? "" : " in the macro " + quoted(rename_.macro)));
    }
    result_.is_known = true;
    if (std::string fault = fault_of(rename_.kind, rename_.to); !fault.empty()) {
      return refuse(std::move(fault));
    }
    if (const std::string taken = taken_at(result_.family, rename_); !taken.empty()) {
      return refuse(quoted(rename_.to) + " is " + taken);
    }
    const std::map<std::string, std::string> before = expand(settings_);
    if (before.empty()) {
      return refuse("no robot with the " + what +
                    " can be expanded, so the change cannot be checked; give its arguments");
    }
    for (const auto& [file, ranges] : by_file(places_)) {
      const std::string& path = result_.family.sources.path(file->source);
      if (changeable_.is_denied(path)) {
        return refuse("'" + path + "' is in no project of the named files; name it, too");
      }
      change(*file, ranges);
    }
    if (rename_.kind == XacroNameKind::argument) change_configurations();
    return judge(before);
  }

 private:
  RenamedXacro refuse(std::string problem) {
    result_.edits.clear();
    result_.problems.push_back(std::move(problem));
    return std::move(result_);
  }

  /// Robots that read a changed file use the name as well, so their files are added.
  void find_places() {
    std::vector<std::string> paths = files_.family_of(path_);
    for (std::size_t before = 0; before != paths.size();) {
      before = paths.size();
      result_.family = {};
      for (const std::string& path : paths) {
        result_.family.add(path, session_.files().read(path, session_.limits().file_bytes).text);
      }
      const XacroMeaning meaning{
          rename_.kind,
          rename_.from,
          {},
          xacro_definitions(result_.family, rename_.kind, rename_.from, rename_.macro)};
      places_ = meaning.definitions.empty() ? std::vector<XacroPlace>{}
                                            : xacro_places(result_.family, meaning);
      if (rename_.kind == XacroNameKind::macro) {
        const std::vector<XacroPlace> ends = xacro_end_tags(result_.family, rename_.from);
        places_.insert(places_.end(), ends.begin(), ends.end());
      }
      roots_.clear();
      for (const XacroPlace& place : places_) {
        const std::string& path = result_.family.sources.path(place.file->source);
        std::vector<std::string> roots = files_.roots_of(path);
        if (roots.empty()) roots.push_back(path);
        roots_.insert(roots.begin(), roots.end());
      }
      for (const std::string& root : roots_) {
        if (std::find(paths.begin(), paths.end(), root) != paths.end()) continue;
        for (const std::string& path : files_.family_of(root)) {
          if (std::find(paths.begin(), paths.end(), path) == paths.end()) paths.push_back(path);
        }
      }
    }
  }

  /// The settings with the arguments that the configuration has for a robot.
  CheckSettings with_configured(const std::string& root, CheckSettings settings) const {
    const std::string path = nearest_config(root, session_.files());
    if (path.empty()) return settings;
    SourceMap sources;
    DiagnosticSink ignored(session_.limits());
    const Config config = read_config(path, sources, session_.files(), ignored);
    for (const ConfigXacro& robot : config.xacro) {
      if (session_.files().identity(robot.file.value) != session_.files().identity(root)) continue;
      settings.xacro.arguments = combinations_of(robot, settings.xacro.arguments, 1).front();
      break;
    }
    return settings;
  }

  /// The results of the robots that can be expanded.
  std::map<std::string, std::string> expand(const CheckSettings& settings) {
    std::map<std::string, std::string> results;
    for (const std::string& root : roots_) {
      const LoadedExpansion loaded = session_.load_xacro(root, with_configured(root, settings));
      if (!loaded.expansion.is_complete) continue;
      results[root] = loaded.sources->text(loaded.expansion.source);
    }
    return results;
  }

  void change(const XacroFamily::File& file, const std::vector<TextRange>& ranges) {
    const std::string& path = result_.family.sources.path(file.source);
    std::string text;
    std::size_t at = 0;
    for (const TextRange& range : ranges) {
      text.append(result_.family.text(file).substr(at, range.begin - at)).append(rename_.to);
      at = range.end;
      const Span span{file.source, static_cast<std::uint32_t>(range.begin),
                      static_cast<std::uint32_t>(range.end)};
      result_.edits.push_back({span, rename_.to});
    }
    text += result_.family.text(file).substr(at);
    session_.set_text(path, text);
    result_.texts.push_back({path, std::move(text)});
  }

  /// Renames the argument in the settings `xacro` of the changed robots.
  void change_configurations() {
    std::set<std::string> paths;
    for (const std::string& root : roots_) {
      std::string path = nearest_config(root, session_.files());
      if (!path.empty() && !changeable_.is_denied(path)) paths.insert(std::move(path));
    }
    for (const std::string& path : paths) change_configuration(path);
  }

  void change_configuration(const std::string& path) {
    SourceMap& sources = result_.family.sources;
    const FileReader& files = session_.files();
    DiagnosticSink ignored(session_.limits());
    const Config config = read_config(path, sources, files, ignored);
    std::set<std::string> roots;
    for (const std::string& root : roots_) roots.insert(files.identity(root));
    std::vector<Edit> edits;
    for (const ConfigXacro& robot : config.xacro) {
      if (!roots.contains(files.identity(robot.file.value))) continue;
      for (const auto& [name, values] : robot.arguments) {
        // What it extends is another file, which other projects may use.
        if (name.value != rename_.from || sources.path(name.span.source) != path) continue;
        edits.push_back({name.span, yaml_like(sources.text(name.span), rename_.to)});
      }
    }
    if (edits.empty()) return;
    std::string text = apply_edits(sources.text(edits.front().span.source), edits);
    result_.edits.insert(result_.edits.end(), edits.begin(), edits.end());
    session_.set_text(path, text);
    result_.texts.push_back({path, std::move(text)});
  }

  RenamedXacro judge(const std::map<std::string, std::string>& before) {
    CheckSettings settings = settings_;
    if (rename_.kind == XacroNameKind::argument) {
      const auto given = settings.xacro.arguments.extract(rename_.from);
      if (!given.empty()) settings.xacro.arguments[rename_.to] = given.mapped();
    }
    const std::map<std::string, std::string> after = expand(settings);
    for (const auto& [root, text] : before) {
      const auto now = after.find(root);
      if (now != after.end() && now->second == text) continue;
      return refuse("with " + quoted(rename_.to) + ", the robot of '" + root +
                    (now == after.end() ? "' cannot be expanded" : "' is another one") +
                    ": a text that is computed, or another definition, uses " +
                    quoted(rename_.from));
    }
    return std::move(result_);
  }

  const XacroFiles& files_;
  const std::string& path_;
  const XacroRename& rename_;
  const CheckSettings& settings_;
  Session& session_;
  const FileReader& changeable_;
  RenamedXacro result_;
  std::vector<XacroPlace> places_;
  std::set<std::string> roots_;
};

}  // namespace

std::optional<XacroNameKind> find_xacro_name_kind(std::string_view kind) {
  for (const KindRow& row : kKinds) {
    if (row.name == kind) return row.kind;
  }
  return std::nullopt;
}

std::string_view to_string(XacroNameKind kind) {
  return std::find_if(kKinds.begin(), kKinds.end(),
                      [&](const KindRow& row) { return row.kind == kind; })
      ->name;
}

RenamedXacro rename_in_xacro(const XacroFiles& files, const std::string& path,
                             const XacroRename& rename, const CheckSettings& settings,
                             Session& session, const FileReader& changeable) {
  return Renaming(files, path, rename, settings, session, changeable).run();
}

}  // namespace smurf::tools
