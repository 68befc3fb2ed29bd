// SPDX-License-Identifier: BSD-3-Clause
#include "check/missing_packages.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "link/package_manifest.hpp"
#include "smurf/companions.hpp"

namespace smurf {
namespace {

constexpr int kLevels = 8;  // from a file up to its package

/// The name in "there is no package `NAME`".
std::string name_in(const Diagnostic& one) {
  const std::size_t begin = one.message.find('`');
  const std::size_t end = one.message.rfind('`');
  return begin == end ? std::string() : one.message.substr(begin + 1, end - begin - 1);
}

bool is_declared(const std::string& file, const std::string& name, const FileReader& files) {
  std::string folder(path::parent(path::normalize(file)));
  for (int level = 0; level < kLevels; ++level, folder = path::join(folder, "..")) {
    const PackageManifest manifest = manifest_in(folder.empty() ? "." : folder, files);
    if (manifest.exists) return manifest.dependencies.contains(name);
  }
  return false;
}

}  // namespace

void join_missing_packages(std::vector<Judged>& found, const SourceMap& sources,
                           const FileReader& files) {
  struct Missing {
    Diagnostic* first = nullptr;
    std::size_t more = 0;
  };
  std::map<std::string, Missing> packages;
  for (Judged& judged : found) {
    for (Diagnostic& one : judged.diagnostics) {
      if (one.rule != &rules::sml3309_xacro_unknown_package) continue;
      const std::string name = name_in(one);
      Missing& missing = packages[name];
      if (missing.first != nullptr) {
        ++missing.more;
        continue;
      }
      missing.first = &one;
      if (name.empty() || !is_declared(sources.path(one.span.source), name, files)) continue;
      if (one.rule->blocks_building) one.untargeted = one.severity;
      one.severity = std::min(one.severity, Severity::warning);
      one.message = "the package " + quoted(name) + " is not here";
      std::string apt = name;
      std::replace(apt.begin(), apt.end(), '_', '-');
      one.help("install it: `rosdep install --from-paths .`, or `apt install ros-DISTRO-" + apt +
               "`; or name its folder with `--package " + name + "=DIR`");
    }
  }
  for (auto& [name, missing] : packages) {
    if (missing.more == 0) continue;
    missing.first->note(counted(missing.more, "more robot") +
                        (missing.more == 1 ? " needs" : " need") + " it as well");
  }
  for (Judged& judged : found) {
    std::vector<Diagnostic> kept;
    for (Diagnostic& one : judged.diagnostics) {
      const bool is_about_package = one.rule == &rules::sml3309_xacro_unknown_package;
      if (is_about_package && packages[name_in(one)].first != &one) continue;
      kept.push_back(std::move(one));
    }
    judged.diagnostics = std::move(kept);
  }
}

}  // namespace smurf
