// SPDX-License-Identifier: BSD-3-Clause
// Compares the findings of robots of xacro with those of their expansions, moved through the map:
// `xacro_findings` reads lines of a file and its arguments, separated by tabs, and prints what is
// different.
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <tuple>

#include "smurf/check.hpp"

using namespace smurf;

namespace {

/// The rule, the file and the bytes of a finding.
using Key = std::tuple<std::string, std::string, std::uint32_t, std::uint32_t>;

std::string shown(const Key& key) {
  const auto& [rule, path, begin, end] = key;
  return rule + " at " + path + " " + std::to_string(begin) + "-" + std::to_string(end);
}

CheckSettings settings_of(const std::string& arguments) {
  CheckSettings settings;
  settings.is_isolated = true;
  settings.opens_meshes = false;
  settings.heeds_comments = false;
  settings.heeds_baseline = false;
  std::istringstream words(arguments);
  for (std::string word; words >> word;) {
    const std::size_t mark = word.find(":=");
    settings.xacro.arguments[word.substr(0, mark)] = word.substr(mark + 2);
  }
  return settings;
}

bool is_of_xacro(const Diagnostic& one) {
  return one.rule->id.starts_with("SML33") || one.rule->id.starts_with("SML34");
}

/// Braces without `$`: of xacro, SML3408 reports them instead.
bool is_of_braces(const Diagnostic& one, Span span, const SourceMap& sources) {
  return one.rule->id == "SML3607" && sources.text(span).starts_with('{');
}

/// The packages in which the meshes are looked up: for a xacro file, also those that $(find) finds.
std::map<std::string, std::string> packages_of(const LinkedModel& model) {
  constexpr std::string_view kScheme = "package://";
  std::map<std::string, std::string> packages;
  for (const MeshReference& mesh : model.meshes) {
    const std::size_t slash = mesh.filename.find('/', kScheme.size());
    if (!mesh.filename.starts_with(kScheme) || slash == std::string::npos) continue;
    const std::string rest = mesh.filename.substr(slash);
    if (!mesh.path.ends_with(rest)) continue;
    packages.emplace(mesh.filename.substr(kScheme.size(), slash - kScheme.size()),
                     mesh.path.substr(0, mesh.path.size() - rest.size()));
  }
  return packages;
}

/// Prints the differences; -1 if the file makes no robot.
int compare(const std::string& path, const std::string& arguments) {
  const CheckSettings settings = settings_of(arguments);
  Session session;
  LoadedModel loaded = session.load_model(path, settings);
  if (!loaded.model.robot) return -1;
  const auto expansions = session.context_of(loaded).expansions;
  const auto& [source, expansion] = *expansions->begin();
  std::set<Key> direct;
  for (const Diagnostic& one : session.check(loaded).diagnostics) {
    if (is_of_xacro(one) || is_of_braces(one, one.span, *loaded.sources)) continue;
    direct.emplace(one.rule->id, loaded.sources->path(one.span.source), one.span.begin,
                   one.span.end);
  }
  std::string urdf = path.substr(0, path.rfind('.'));
  if (!urdf.ends_with(".urdf")) urdf += ".urdf";
  Session of_result;
  of_result.set_text(urdf, std::string(loaded.sources->text(source)));
  CheckSettings plain = settings;
  plain.xacro = {};
  plain.packages = packages_of(loaded.model);
  LoadedModel result = of_result.load_model(urdf, plain);
  const auto result_path = std::filesystem::path(urdf).lexically_normal();
  std::set<Key> moved;
  for (const Diagnostic& one : of_result.check(result).diagnostics) {
    Span span = one.span;
    std::string file = result.sources->path(span.source);
    if (std::filesystem::path(file).lexically_normal() == result_path) {
      span = expansion.origin_of({source, span.begin, span.end}).span;
      file = loaded.sources->path(span.source);
      if (is_of_braces(one, span, *loaded.sources)) continue;
    }
    moved.emplace(one.rule->id, file, span.begin, span.end);
  }
  int differences = 0;
  for (const Key& one : direct) {
    if (moved.contains(one)) continue;
    ++differences;
    std::printf("%s: only of the xacro: %s\n", path.c_str(), shown(one).c_str());
  }
  for (const Key& one : moved) {
    if (direct.contains(one)) continue;
    ++differences;
    std::printf("%s: only of the expansion: %s\n", path.c_str(), shown(one).c_str());
  }
  return differences;
}

}  // namespace

int main() {
  int files = 0, equal = 0, without = 0;
  for (std::string line; std::getline(std::cin, line);) {
    const std::size_t tab = std::min(line.find('\t'), line.size());
    const int differences =
        compare(line.substr(0, tab), tab < line.size() ? line.substr(tab + 1) : "");
    ++files;
    equal += differences == 0 ? 1 : 0;
    without += differences < 0 ? 1 : 0;
  }
  std::printf("%d of %d have the same findings, %d make no robot\n", equal, files, without);
  return equal + without == files ? 0 : 1;
}
