// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/plan.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>

#include "ast/format.hpp"
#include "base/files/canonical_paths.hpp"
#include "base/files/path.hpp"
#include "base/files/path_patterns.hpp"
#include "base/files/places.hpp"
#include "base/findings/limits.hpp"
#include "base/numbers/digest.hpp"
#include "base/recent_map.hpp"
#include "link/imported_world.hpp"
#include "mjcf/mjcf.hpp"
#include "plan/ignore_files.hpp"
#include "plan/imported_robots.hpp"
#include "plan/models_around.hpp"
#include "plan/paths.hpp"
#include "plan/xacro_files.hpp"
#include "sdf/sdf.hpp"
#include "smurf/companions.hpp"
#include "smurf/config.hpp"
#include "smurf/confine.hpp"
#include "smurf/found_inputs.hpp"
#include "smurf/xacro.hpp"

namespace smurf {
namespace {

using ShortDigest = std::array<std::uint8_t, 16>;

constexpr std::uint64_t kMostBytesOfCompanion = 1U << 20U;

/// The files that a configuration excludes, and its own sections.
struct Exclusions {
  struct Patterns {
    std::string folder;  ///< absolute
    PathPatterns patterns;
  };
  std::vector<Patterns> all;
  std::vector<std::string> sections;  ///< that have a schema
  bool is_forced = false;

  Exclusions(const std::string& config, const PlanSettings& settings, const FileReader& files)
      : is_forced(settings.excludes_named) {
    if (config.empty()) return;
    SourceMap sources;
    DiagnosticSink reported_when_checking;
    const Config read = read_config(config, sources, files, reported_when_checking);
    for (const ConfigPattern& one : read.exclude) {
      const std::string folder = identity(one.folder);
      if (all.empty() || all.back().folder != folder) all.push_back({folder, {}});
      all.back().patterns.add(one.text.value);
    }
    is_forced = is_forced || (read.force_exclude && read.force_exclude->value);
    for (const auto& [section, schema] : read.section_schemas) sections.push_back(section);
  }

  std::size_t size() const {
    std::size_t count = 0;
    for (const Patterns& one : all) count += one.patterns.size();
    return count;
  }

  template <class Judge>
  bool any(const std::string& path, const Judge& judge) const {
    return std::any_of(all.begin(), all.end(), [&](const Patterns& one) {
      const std::string inside = path_inside(path, one.folder, canonical_paths());
      return !inside.empty() && judge(one.patterns, inside);
    });
  }
};

/// Whether a text in YAML or JSON seems to have a key of that name.
bool has_key(std::string_view text, std::string_view name) {
  const auto is_inner = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
  };
  for (std::size_t at = text.find(name); at != std::string_view::npos;
       at = text.find(name, at + 1)) {
    if (at > 0 && is_inner(text[at - 1])) continue;
    std::string_view rest = text.substr(at + name.size());
    if (!rest.empty() && (rest.front() == '"' || rest.front() == '\'')) rest.remove_prefix(1);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    if (rest.starts_with(':')) return true;
  }
  return false;
}

class Planner {
 public:
  Planner(const PlanSettings& settings, const FileReader& files,
          const std::function<void(const std::string&)>& tell)
      : settings_(settings),
        files_(files),
        tell_(tell),
        current_folder_(identity(".")),
        ignore_files_(files, settings.limits.ignore_checks),
        models_(files) {}

  FoundPlan run() {
    const std::vector<std::string> here{"."};
    const std::vector<std::string>& paths = settings_.paths.empty() ? here : settings_.paths;
    if (const auto reason = why_no_config()) {
      fail("cannot read '" + settings_.config + "': " + *reason);
    }
    const std::string& first = paths.front();
    places::is_folder(first) ? config_of_folder(first) : config_of_entry(first);
    for (const std::string& path : paths) {
      if (path == settings_.given) {
        add_file(path);
      } else if (places::is_folder(path)) {
        add_folder(path);
      } else {
        add_named(path);
      }
    }
    if (ignore_files_.is_exhausted()) {
      fail("cannot determine which files are left out: there are more than " +
           std::to_string(settings_.limits.ignore_checks) +
           " comparisons of files with patterns; " + raise_limit("ignore-checks"));
    }
    if (models_.is_exhausted()) {
      fail("there are too many files around the named ones to look at all models; name the models");
    }
    return std::move(plan_);
  }

 private:
  std::optional<std::string> why_no_config() const {
    if (settings_.config.empty()) return std::nullopt;
    return why_unreadable(settings_.config, files_);
  }

  std::string advice_on(const std::string& path) const {
    return settings_.advice ? settings_.advice(path) : std::string();
  }

  void fail(const std::string& message) {
    if (tell_) tell_(message);
    plan_.problems.push_back(message);
  }

  std::size_t config_of_entry(const std::string& path) {
    return config_of_folder(std::string(path::parent(path)));
  }

  std::size_t config_of_folder(const std::string& folder) {
    if (const std::size_t* const known = by_folder_.find(folder)) return *known;
    const std::size_t config = is_as_above(folder) ? config_of_folder(path::join(folder, ".."))
                                                   : config_found_from(folder);
    return by_folder_.add(folder, config);
  }

  /// Whether the folder is known to have the same configuration as its parent.
  bool is_as_above(const std::string& folder) const {
    if (settings_.is_isolated || !settings_.config.empty()) return false;
    const std::string normal = path::normalize(folder);
    const std::string_view name = path::file_name(normal);
    return !name.empty() && name != "." && name != ".." &&
           !files_.is_file(path::join(normal, kConfigName));
  }

  std::string config_around(const std::string& folder) const {
    if (settings_.is_isolated) return {};
    return settings_.config.empty() ? nearest_config(folder, files_) : settings_.config;
  }

  std::size_t config_found_from(const std::string& folder) {
    std::string config = config_around(folder.empty() ? "." : folder);
    if (!config.empty() && why_unreadable(config, files_)) config.clear();
    const std::string key = config.empty() ? config : identity(config);
    const auto [known, is_new_config] = configs_.try_emplace(key, plan_.configs.size());
    if (is_new_config) {
      exclusions_.emplace_back(config, settings_, files_);
      plan_.configs.push_back(std::move(config));
    }
    return known->second;
  }

  /// The configuration around a folder decides whether it is searched, not the one in it.
  bool is_left_out(const std::string& path, bool folder) {
    const Exclusions& exclusions = exclusions_[config_of_entry(path)];
    if (!ignore_files_.may_check(exclusions.size())) return true;
    const bool is_excluded =
        exclusions.any(path, [&](const PathPatterns& patterns, const std::string& inside) {
          return ignore_files_.judge(patterns, inside, folder) == PathVerdict::excluded;
        });
    if (is_excluded || !settings_.heeds_ignore_files) return is_excluded;
    return ignore_files_.leaves_out(absolute(path), folder);
  }

  /// Whether a file is skipped although the user named it.
  bool is_left_out_by_force(const std::string& path) {
    const Exclusions& exclusions = exclusions_[config_of_entry(path)];
    if (!exclusions.is_forced) return false;
    if (!ignore_files_.may_check(exclusions.size())) return true;
    const bool is_excluded =
        exclusions.any(path, [&](const PathPatterns& patterns, const std::string& inside) {
          return ignore_files_.excludes(patterns, inside);
        });
    if (is_excluded || !settings_.heeds_ignore_files) return is_excluded;
    return ignore_files_.leaves_out_with_folders(absolute(path));
  }

  std::string absolute(const std::string& path) const { return path::join(current_folder_, path); }

  void add(std::vector<PlannedFile>& to, std::string path) {
    // A digest is shorter than the path, and a set of many thousands remains small.
    ShortDigest id{};
    std::copy_n(digest_of(identity(path, files_)).begin(), id.size(), id.begin());
    if (!planned_.insert(id).second) return;
    const auto config = static_cast<std::uint32_t>(config_of_entry(path));
    to.push_back({std::move(path), config});
  }

  /// Whether a link leads out of the project in which it lies. The link itself would stand for the
  /// project of what it leads to: whoever made the folder may have chosen that.
  bool leads_outside(const std::string& link) const {
    if (!files_.is_denied(link)) return false;
    const std::string folder(path::parent(link));
    const std::array around{folder.empty() ? std::string(".") : folder};
    ConfinedFiles project;
    confine_to_projects(project, around);
    return project.is_denied(link);
  }

  void add_folder(const std::string& folder) {
    FoundInputs found =
        find_inputs(folder, settings_.limits, [&](const std::string& path, bool is_one) {
          return is_left_out(path, is_one);
        });
    for (const std::string& link : found.model_links) {
      if (leads_outside(link)) {
        ++found.links_outside;
      } else {
        found.files.push_back(link);
      }
    }
    std::sort(found.files.begin(), found.files.end());
    for (const std::string& problem : found.unreadable) fail("cannot read " + problem);
    const std::vector<std::string> roots =
        XacroFiles(found.xacro, files_, settings_.limits).roots();
    const std::vector<std::string> imported = imported_robots(found.xml, files_, settings_.limits);
    const bool is_found =
        !found.files.empty() || !roots.empty() || !imported.empty() || has_companion(found.yaml);
    if (!is_found && found.unreadable.empty() && !ignore_files_.is_exhausted()) {
      fail(why_nothing(found, folder));
    }
    if (is_found) plan_.links += found.links_outside;
    for (std::string& file : found.yaml) add(plan_.companions, std::move(file));
    for (std::string& file : found.files) {
      switch (input_kind(file)) {
      case InputKind::scene: add(plan_.scenes, std::move(file)); break;
      case InputKind::urdf:
      case InputKind::other: add(plan_.others, std::move(file)); break;  // others are companions
      default: add(plan_.models, std::move(file)); break;
      }
    }
    for (const std::string& file : imported)
      add(is_world_file(file, files_, settings_.limits) ? plan_.scenes : plan_.others, file);
    for (const std::string& root : roots) add_part_of_robot(root);
  }

  /// A xacro file that no user named.
  void add_part_of_robot(const std::string& path) {
    if (is_companion_path(path)) return add(plan_.companions, path);  // read with its robot
    const std::size_t before = plan_.others.size();
    add(plan_.others, path);
    if (plan_.others.size() > before) plan_.others.back().may_be_part = true;
  }

  /// A file that others include is judged in their robots.
  void add_xacro(const std::string& path) {
    const std::string project = project_around(path);
    const auto [known, is_new] = xacro_files_.try_emplace(project);
    if (is_new) {
      const auto is_left_out = [&](const std::string& one, bool folder) {
        return this->is_left_out(one, folder);
      };
      known->second.emplace(xacro_files_around(path, files_, settings_.limits, is_left_out));
    }
    const std::vector<std::string> roots = known->second->roots_of(path);
    for (const std::string& root : roots) {
      is_companion_path(root) ? add(plan_.others, root) : add_part_of_robot(root);
    }
    if (roots.empty()) add(plan_.others, path);
  }

  void add_named(const std::string& path) {
    if (const auto reason = why_unreadable(path, files_)) {
      fail("cannot read '" + path + "': " + *reason + advice_on(path));
    } else if (path::file_name(path) == kConfigName) {
      config_of_entry(path);  // every run checks the configurations that it reads
    } else if (!is_left_out_by_force(path)) {
      add_file(path);
      mark_named(path);
    }
  }

  /// A .xml of another language.
  bool is_other_xml(const std::string& path) const {
    if (path::to_lower(path::extension(path)) != ".xml") return false;
    const FileContent content = files_.read(path, settings_.limits.file_bytes);
    return content.status == ReadStatus::ok && !mjcf::is_mjcf(content.text) &&
           !sdformat::is_sdf(content.text);
  }

  void mark_named(const std::string& path) {
    for (auto* files : {&plan_.scenes, &plan_.models, &plan_.others, &plan_.companions}) {
      if (!files->empty() && files->back().path == path) files->back().is_named = true;
    }
  }

  /// Whether one of these files is a companion of a robot, which may be elsewhere.
  bool has_companion(const std::vector<std::string>& paths) const {
    return std::any_of(paths.begin(), paths.end(),
                       [&](const std::string& path) { return is_companion(path); });
  }

  bool is_companion(const std::string& path) const {
    const FileContent content = files_.read(path, kMostBytesOfCompanion);
    return content.status == ReadStatus::ok && find_companion_kind(path, content.text) != nullptr;
  }

  void add_file(const std::string& path) {
    if (is_other_xml(path)) return add_other(path);
    if (is_scene_file(path, files_, settings_.limits)) return add(plan_.scenes, path);
    switch (input_kind(path)) {
    case InputKind::model: add(plan_.models, path); return;
    case InputKind::urdf:
    case InputKind::annotation: add_part(path); return;
    case InputKind::resource: add_resource(path); return;
    case InputKind::scene:
    case InputKind::drawing:
    case InputKind::other: break;
    }
    add_other(path);
  }

  void add_other(const std::string& path) {
    if (is_companion_path(path)) return add(plan_.others, path);
    fail(
        "cannot check '" + path +
        "': it is not a .smurf, .smurfs, .smurfa, .svg, .urdf, .xacro, .mjcf, .sdf, .world, .srdf or .yml file; to check a URDF of "
        "another name: smurf-lint --stdin-filename NAME.urdf - < FILE");
  }

  /// Whether a YAML or JSON file is about a robot; many are not. Only searches the text for names
  /// of sections, because the file is parsed later.
  bool has_section(const std::string& path) {
    const FileContent content = files_.read(path, settings_.limits.file_bytes);
    if (content.status != ReadStatus::ok) return true;  // reported when it is loaded
    const std::string& text = content.text;
    const bool is_empty = text.find_first_not_of("{}[] \t\r\n") == std::string::npos;
    if (is_empty && text.find_first_of("{[") != std::string::npos) return false;
    if (text.find(':') == std::string::npos) return true;  // no mapping, such as a draft
    const auto is_named = [&](std::string_view name) { return has_key(content.text, name); };
    const std::vector<std::string>& own = exclusions_[config_of_entry(path)].sections;
    if (std::any_of(own.begin(), own.end(), is_named)) return true;
    const std::vector<FormatPart> parts = describe_format();
    return std::any_of(parts.begin(), parts.end(), [&](const FormatPart& part) {
      return is_named(part.name) || std::any_of(part.aliases.begin(), part.aliases.end(), is_named);
    });
  }

  void add_part(const std::string& path) {
    if (settings_.stands_for_users && xacro::is_xacro_file(path)) return add_xacro(path);
    const std::vector<std::string> models = models_.listing(path);
    for (const std::string& model : models) add(plan_.models, model);
    if (models.empty() && input_kind(path) == InputKind::annotation && is_companion(path)) {
      return add(plan_.companions, path);
    }
    const bool is_passed_over =
        settings_.stands_for_users && input_kind(path) == InputKind::annotation;
    if (!models.empty() || is_passed_over) return;
    if (input_kind(path) == InputKind::annotation && !has_section(path)) {
      return fail("cannot check '" + path +
                  "': it has no section of SMURF, such as `motors`, and no model lists it");
    }
    add(plan_.others, path);
  }

  void add_resource(const std::string& path) {
    const std::vector<std::string> models = models_.using_resource(path);
    for (const std::string& model : models) add(plan_.models, model);
    if (models.empty() && !settings_.stands_for_users) fail("no model near '" + path + "' uses it");
  }

  const PlanSettings& settings_;
  const FileReader& files_;
  const std::function<void(const std::string&)>& tell_;
  const std::string current_folder_;
  FoundPlan plan_;
  std::set<ShortDigest> planned_;  ///< of identities
  RecentMap<std::size_t> by_folder_;
  std::map<std::string, std::size_t> configs_;
  std::deque<Exclusions> exclusions_;  ///< of each configuration
  IgnoreFiles ignore_files_;
  ModelsAround models_;
  std::map<std::string, std::optional<XacroFiles>> xacro_files_;  ///< by project
};

}  // namespace

FoundPlan make_plan(const PlanSettings& settings, const FileReader& files,
                    const std::function<void(const std::string&)>& tell) {
  return Planner(settings, files, tell).run();
}

}  // namespace smurf
