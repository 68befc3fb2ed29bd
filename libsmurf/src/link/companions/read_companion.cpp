// SPDX-License-Identifier: BSD-3-Clause
#include "link/companions/read_companion.hpp"

#include <cstdint>
#include <set>
#include <string_view>
#include <utility>

#include "ast/companions/srdf_reader.hpp"
#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "link/companions/library.hpp"
#include "link/companions/setup_assistant.hpp"
#include "link/package_manifest.hpp"
#include "link/read_file.hpp"
#include "link/xacro_model.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

/// Whether the package around a folder is built with ament, as those of ROS 2 are.
bool is_in_ros2_package(std::string folder, const FileReader& files) {
  for (int level = 0; level < 4; ++level, folder = path::join(folder, "..")) {
    const PackageManifest manifest = manifest_in(folder, files);
    if (manifest.exists) return manifest.is_ament;
  }
  return false;
}

/// Where keys are repeated whose values are joined, so that nothing is lost.
std::set<std::uint32_t> merged_keys(const Companion& companion) {
  std::set<std::uint32_t> places;
  if (companion.kind != CompanionKind::controllers || !companion.document) return places;
  for (const yaml::Node& node : companion.document->nodes) {
    if (node.is_repeated && node.kind() == yaml::Kind::mapping) {
      places.insert(node.key_span().begin);
    }
  }
  return places;
}

}  // namespace

std::optional<Companion> CompanionReader::read(const std::string& path, const CompanionSpec& spec,
                                               const LinkedModel* robot) {
  const auto source = read_source(path, {}, rules::sml0001_unreadable_file, context_);
  if (!source) return std::nullopt;
  Companion companion;
  companion.kind = spec.kind;
  companion.source = *source;
  companion.folder = path::parent(path::normalize(path));
  // These exist in ROS 2 only.
  companion.is_ros2 = spec.kind == CompanionKind::controllers ||
                      spec.kind == CompanionKind::moveit_controllers ||
                      is_in_ros2(companion.folder);
  if (spec.is_xml) {
    const auto text = xacro::is_xacro_file(path) ? expanded(*source, robot) : source;
    if (!text) return std::nullopt;
    auto document = parse_xml(context_.sources, *text, context_.limits, context_.sink);
    if (!document) return std::nullopt;
    companion.srdf = srdf::read(std::move(*document));
    if (text != source && !companion.srdf->name) return std::nullopt;  // a part of others
  } else {
    read_parameters(path, companion);
    if (spec.kind == CompanionKind::setup_assistant && companion.document) {
      find_missing_files(companion, context_);
    }
  }
  return companion;
}

/// A text that cannot be parsed is an error; a key that is written twice loses its first value.
void CompanionReader::read_parameters(const std::string& path, Companion& companion) {
  DiagnosticSink found(context_.limits);
  companion.document = parse_yaml(context_.sources, companion.source, context_.limits, found);
  const std::string_view text = context_.sources.text(companion.source);
  companion.is_broken =
      recognise(path, text, companion.document, found).state == CompanionState::broken;
  if (companion.is_broken) companion.document.reset();
  const std::set<std::uint32_t> merged = merged_keys(companion);
  for (Diagnostic& one : found.take()) {
    const bool is_repeated = one.rule == &rules::sml0011_duplicate_key;
    if (is_repeated && merged.contains(one.span.begin)) continue;
    if (!is_repeated && (!companion.is_broken || one.severity != Severity::error)) continue;
    if (!is_repeated) {
      report_broken_yaml(one, context_.sink);
      continue;
    }
    Diagnostic& reported = report_of_yaml(one, context_.sink);
    reported.severity = Severity::warning;
    reported.note("ROS uses the last value, and ignores the others without a message");
  }
  if (companion.document) {
    keep_last_keys(*companion.document, companion.kind == CompanionKind::controllers);
    convert_degrees(*companion.document, text);
  }
}

std::optional<SourceId> CompanionReader::expanded(SourceId root, const LinkedModel* robot) {
  DiagnosticSink ignored(context_.limits);
  LoadContext quiet{context_.sources, context_.files,    ignored,
                    context_.limits,  context_.packages, context_.package_folders,
                    context_.meshes,  context_.schemas,  context_.read,
                    context_.parsed,  context_.xacro,    context_.expansions};
  quiet.limits.xacro_steps = steps_of_trial(context_.limits);
  // Launch files often pass the name of the robot.
  if (robot != nullptr) quiet.xacro.arguments.emplace("name", robot->robot->name.value_or(""));
  xacro::Expansion expansion = expand_xacro(root, robot != nullptr ? quiet : context_);
  if (!expansion.is_complete) return std::nullopt;
  const SourceId source = expansion.source;
  context_.expansions->emplace(source, std::move(expansion));
  return source;
}

bool CompanionReader::is_in_ros2(const std::string& folder) {
  const auto [known, is_new] = ros2_.try_emplace(folder);
  if (is_new) known->second = is_in_ros2_package(folder, context_.files);
  return known->second;
}

}  // namespace smurf
