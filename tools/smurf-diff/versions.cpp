// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-diff/versions.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace smurf::tools {
namespace {

/// Such files are missing, too large or no texts: what they describe cannot be compared.
constexpr std::array<std::string_view, 4> kUnreadFiles = {"SML0001", "SML0002", "SML0003",
                                                          "SML2001"};

/// At most this many reasons why a file cannot be read; smurf-lint reports all of them.
constexpr std::size_t kMostTrouble = 20;

bool is_about_unread_file(const Diagnostic& finding) {
  const bool is_about_findings = finding.left_out != nullptr;  // too many of them
  return !is_about_findings &&
         std::ranges::find(kUnreadFiles, finding.rule->id) != kUnreadFiles.end();
}

/// One of its files could not be read.
bool is_broken(const LinkedModel& model) {
  if (!model.urdf_path.empty() && !model.robot) return true;
  if (model.files.empty()) return true;
  return std::ranges::any_of(model.files, [](const ModelFile& file) {
    return file.kind != ModelFile::Kind::urdf && !file.document;
  });
}
bool is_broken(const LinkedScene& scene) {
  return !scene.is_complete || std::ranges::any_of(scene.models, [](const LinkedModel& model) {
    return is_broken(model);
  });
}

/// A file that both versions share has the same findings in both.
void append_new(const Diagnostic& finding, const SourceMap& sources,
                std::vector<Diagnostic>& findings) {
  const bool is_known = std::ranges::any_of(findings, [&](const Diagnostic& one) {
    return one.rule == finding.rule && one.message == finding.message &&
           one.span.begin == finding.span.begin &&
           sources.path(one.span.source) == sources.path(finding.span.source);
  });
  if (!is_known) findings.push_back(finding);
}

/// The errors of reading, if a file could not be read at all.
template <class Loaded, class Linked>
void find_trouble(Session& session, Loaded& loaded, const Linked& linked, bool for_git,
                  Compared& result) {
  std::vector<Diagnostic> found = session.settle(loaded, loaded.found.take());
  if (!is_broken(linked) && for_git) {
    for (const Diagnostic& one : found) {
      if (result.remarks.size() == kMostTrouble) return;
      if (is_about_unread_file(one)) append_new(one, *loaded.sources, result.remarks);
    }
    return;
  }
  if (!is_broken(linked) && std::ranges::none_of(found, is_about_unread_file)) return;
  for (const Diagnostic& one : found) {
    if (result.trouble.size() == kMostTrouble) return;
    if (one.severity == Severity::error) append_new(one, *loaded.sources, result.trouble);
  }
}

bool is_scene(std::string_view path) {
  const InputKind kind = input_kind(path);
  return kind == InputKind::scene || kind == InputKind::drawing;
}

template <class Load>
auto load(Session& session, const InputVersion& version, const Load& load) {
  const ReplacedText replaced(session, version);
  return load(version.path, version.xacro);
}

/// The bytes of a xacro file that made a part of its expansion.
void place_in_xacro(const xacro::Expansions& expansions, std::optional<Span>& place) {
  if (!place) return;
  const auto found = expansions.find(place->source);
  if (found != expansions.end()) place = found->second.origin_of(*place).span;
}

template <class Load, class Linked>
Compared compare_loaded(Session& session, const InputVersion& before, const InputVersion& after,
                        const DiffOptions& how, bool for_git, const Load& load_one, Linked linked) {
  Compared result;
  auto old_version = load(session, before, load_one);
  auto new_version = load(session, after, load_one);
  find_trouble(session, old_version, old_version.*linked, for_git, result);
  find_trouble(session, new_version, new_version.*linked, for_git, result);
  if (!result.trouble.empty()) return result;
  result.differences =
      diff(old_version.*linked, new_version.*linked, session.loaded_sources(), how);
  const auto expansions = session.context_of(new_version).expansions;
  for (Difference& one : result.differences) {
    place_in_xacro(*expansions, one.old_place);
    place_in_xacro(*expansions, one.new_place);
  }
  if (result.differences.size() > how.limits.differences) {
    result.problem = "'" + before.shown + "' and '" + after.shown + "' have more than " +
                     std::to_string(how.limits.differences) +
                     " differences; raise the limit with `--limit differences=N`";
    result.differences.clear();
  }
  return result;
}

}  // namespace

Compared compare_versions(Session& session, const InputVersion& before, const InputVersion& after,
                          const Options& options) {
  Compared result;
  if (is_scene(before.path) != is_scene(after.path)) {
    const InputVersion& scene = is_scene(before.path) ? before : after;
    const InputVersion& model = is_scene(before.path) ? after : before;
    result.problem = "'" + scene.shown + "' is a scene and '" + model.shown +
                     "' a model; a scene can only be compared with a scene";
    return result;
  }
  CheckSettings settings;
  settings.packages = options.packages;
  settings.max_seconds = options.max_seconds;
  settings.opens_meshes = false;  // only their bytes can be compared
  const DiffOptions how{options.tolerance, &session.files(), options.limits};
  if (is_scene(before.path)) {
    return compare_loaded(
        session, before, after, how, options.for_git,
        [&](const std::string& path, const XacroSettings&) {
          return session.load_scene(path, settings);
        },
        &LoadedScene::scene);
  }
  return compare_loaded(
      session, before, after, how, options.for_git,
      [&](const std::string& path, const XacroSettings& xacro) {
        settings.xacro = {xacro.arguments, options.environment};
        return session.load_model(path, settings);
      },
      &LoadedModel::model);
}

}  // namespace smurf::tools
