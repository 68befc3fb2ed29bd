// SPDX-License-Identifier: BSD-3-Clause
// All safe fixes of all files below some folders, applied in memory until nothing is
// left to fix: the process ends, comments stay, and models and scenes keep their
// meaning.  usage: safe_fixes FOLDER...; folders that are absent are skipped, 77 when
// all are.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "smurf/convert.hpp"
#include "smurf/fix.hpp"
#include "smurf/lint.hpp"
#include "smurf/load.hpp"

namespace fs = std::filesystem;
using namespace smurf;

namespace {

/// A file with all files that it loads, and its findings.
struct Loaded {
  SourceMap sources;
  MeshLibrary meshes;
  LinkedScene scene;  ///< files of a model: only that model
  std::vector<Diagnostic> diagnostics;

  Loaded(const std::string& path, const FileReader& files) {
    DiagnosticSink sink;
    LoadContext context{sources, files, sink, {}, {}, {}, &meshes};
    const bool is_scene = path.ends_with(".smurfs") || path.ends_with(".smurfa");
    if (is_scene) {
      scene = load_scene(path, context);
      lint_scene(scene, {}, sink);
    } else {
      scene.models.push_back(load_model(path, context));
    }
    for (const LinkedModel& model : scene.models) lint_model(model, {}, sink);
    diagnostics = sink.take();
    if (is_scene) {
      locate(scene, diagnostics);
    } else {
      locate(scene.models.front(), diagnostics);
    }
    diagnostics = apply_selection(std::move(diagnostics), sources, {});
  }
};

bool is_safe(const Diagnostic& diagnostic) {
  return !diagnostic.fixes.empty() && diagnostic.fixes.front().applicability == Applicability::safe;
}

/// Approximately the comments of a YAML or XML text, to detect a lost comment.
std::multiset<std::string> comments_of(const std::string& path, const std::string& text) {
  const bool is_xml = path.ends_with(".urdf");
  const std::string_view open = is_xml ? "<!--" : "#";
  const std::string_view close = is_xml ? "-->" : "\n";
  std::multiset<std::string> comments;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    const std::size_t end = std::min(text.find(close, at), text.size());
    comments.insert(text.substr(at, end - at));
    at = end;
  }
  return comments;
}

bool is_near(const Pose& a, const Pose& b) {
  constexpr double kTolerance = 1e-12;
  for (std::size_t i = 0; i < 3; ++i) {
    if (std::fabs(a.position[i] - b.position[i]) > kTolerance) return false;
  }
  return angle_between(a.orientation, b.orientation) <= 1e-9;
}

/// Compares joints at the same place of two files.
bool have_other_limits(const urdf::Joint& a, const urdf::Joint& b) {
  if (a.type != b.type) return true;
  if (!a.is_movable()) return false;
  const urdf::Limit x = a.limit.value_or(urdf::Limit{});
  const urdf::Limit y = b.limit.value_or(urdf::Limit{});
  return a.limit.has_value() != b.limit.has_value() || x.lower.value() != y.lower.value() ||
         x.upper.value() != y.upper.value() || x.effort.value() != y.effort.value() ||
         x.velocity.value() != y.velocity.value();
}

/// Changes that the fixes must not make; empty if there are none.
std::string difference(const LinkedScene& before, const LinkedScene& after) {
  if (before.models.size() != after.models.size()) return "there are other models";
  for (std::size_t i = 0; i < before.models.size(); ++i) {
    if (!before.models[i].robot || !after.models[i].robot) continue;
    const ProofScope scope{.may_change_limits = true};  // those of fixed joints have no effect
    const Proof proof = compare_models(before.models[i], after.models[i], scope);
    if (!proof.holds()) return proof.difference;
    const auto& joints = before.models[i].robot->joints;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      if (have_other_limits(joints[j], after.models[i].robot->joints[j])) {
        return "type or limits of the joint `" + joints[j].name.value_or("?") + "` differ";
      }
    }
  }
  if (before.instances.size() != after.instances.size()) return "there are other instances";
  for (std::size_t i = 0; i < before.instances.size(); ++i) {
    const Instance& one = before.instances[i];
    const Instance& other = after.instances[i];
    if (one.path != other.path) return "instance " + one.path + " is called " + other.path;
    if (one.X_WE && (!other.X_WE || !is_near(*one.X_WE, *other.X_WE))) {
      return "instance " + one.path + " has moved";
    }
  }
  return {};
}

struct Count {
  std::size_t files = 0;
  std::size_t fixed_files = 0;
  std::size_t fixes = 0;
  std::size_t compared = 0;
};

/// Faults of the safe fixes of one file; empty if there are none.
std::string check(const std::string& path, Count& count) {
  const DiskFiles disk;
  MemoryFiles files(&disk);
  Loaded before(path, files);
  ++count.files;
  const std::size_t fixes_before = count.fixes;
  // A file that a reader refuses has no meaning to preserve, so the fix of an error may change
  // anything.
  bool is_mending = false;
  Loaded now(path, files);
  for (int round = 0;; ++round) {
    const AppliedFixes applied = apply_fixes(now.diagnostics, now.sources, Applicability::safe);
    if (applied.texts.empty()) break;
    if (round == 10) return "fixes undo each other";
    count.fixes += applied.count;
    for (const Diagnostic& one : now.diagnostics) {
      is_mending = is_mending || (is_safe(one) && one.severity == Severity::error);
    }
    for (const FixedText& fixed : applied.texts) {
      const std::string old = files.read(fixed.path, Limits{}.file_bytes).text;
      if (comments_of(fixed.path, old) != comments_of(fixed.path, fixed.text)) {
        return "the comments of " + fixed.path + " are others";
      }
      files.add(fixed.path, fixed.text);
    }
    now = Loaded(path, files);
    if (round == 0) ++count.fixed_files;
  }
  if (is_mending || count.fixes == fixes_before) return {};
  ++count.compared;
  return difference(before.scene, now.scene);
}

}  // namespace

int main(int argc, char** argv) {
  Count count;
  std::size_t failures = 0;
  bool is_any = false;
  for (int i = 1; i < argc; ++i) {
    if (!fs::is_directory(argv[i])) continue;
    is_any = true;
    std::set<std::string> paths;
    for (const auto& entry : fs::recursive_directory_iterator(argv[i])) {
      const std::string extension = entry.path().extension().string();
      const bool is_input = extension == ".smurf" || extension == ".smurfs" ||
                            extension == ".smurfa" || extension == ".urdf" || extension == ".yml";
      if (entry.is_regular_file() && is_input) paths.insert(entry.path().string());
    }
    for (const std::string& path : paths) {
      const std::string wrong = check(path, count);
      if (wrong.empty()) continue;
      ++failures;
      std::printf("%s: %s\n", path.c_str(), wrong.c_str());
    }
  }
  if (!is_any) {
    std::puts("skipped: the folders are not there");
    return 77;
  }
  std::printf("%zu files, %zu of them fixed, %zu fixes; %zu compared, %zu failures\n", count.files,
              count.fixed_files, count.fixes, count.compared, failures);
  return failures == 0 && count.fixes > 0 ? 0 : 1;
}
