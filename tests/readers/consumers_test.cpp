// SPDX-License-Identifier: BSD-3-Clause
// The table of readers against what real readers did with 146 URDFs of one defect each: what a
// reader refused or crashed on is an error for it as a target, and what all of them took is an
// error for none.
//
// usage: consumers_test SHARED-FOLDER; exits with 77 (skipped) without that folder.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "smurf/lint.hpp"
#include "smurf/load.hpp"

namespace fs = std::filesystem;
using namespace smurf;

namespace {

constexpr int kSkipped = 77;
constexpr double kLeastScore = 0.98;

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

struct Case {
  std::string file;
  std::map<std::string, std::string> verdicts;  ///< by the heading of the column
};

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> out;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, '\t');) out.push_back(cell);
  return out;
}

std::vector<Case> read_cases(const fs::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  const std::vector<std::string> heading = cells(line);
  std::vector<Case> cases;
  while (std::getline(file, line)) {
    const std::vector<std::string> row = cells(line);
    Case one{row.at(0), {}};
    for (std::size_t i = 1; i < row.size(); ++i) one.verdicts[heading.at(i)] = row[i];
    cases.push_back(std::move(one));
  }
  return cases;
}

/// The first word of each column that stands for a target.
constexpr std::pair<std::string_view, std::string_view> kColumns[] = {{"ros", "urdfdom"},
                                                                      {"gazebo", "sdformat"},
                                                                      {"dart", "dart"},
                                                                      {"pybullet", "bullet"},
                                                                      {"mujoco", "mujoco"}};

std::string verdict_of(const Case& one, std::string_view column) {
  for (const auto& [heading, verdict] : one.verdicts) {
    if (heading.starts_with(column)) return verdict;
  }
  return {};
}

bool has_error(const fs::path& path, const Reader& target) {
  const DiskFiles disk;
  MemoryFiles files(&disk);
  // One case names this absolute path, which existed where the readers were run.
  files.add("/opt/robots/meshes/cube.obj", read(path.parent_path() / "cube.obj"));
  SourceMap sources;
  DiagnosticSink sink;
  MeshLibrary meshes;
  LoadContext context{sources, files, sink, {}, {}};
  context.meshes = &meshes;
  const LinkedModel model = load_model(path.string(), context);
  RuleSelection selection;
  selection.targets = {&target};
  lint_model(model, selection, sink);
  std::vector<Diagnostic> diagnostics = sink.take();
  locate(model, diagnostics);
  diagnostics = finish(std::move(diagnostics), sources, selection);
  return std::any_of(diagnostics.begin(), diagnostics.end(),
                     [](const Diagnostic& d) { return d.severity == Severity::error; });
}

}  // namespace

int main(int argc, char** argv) {
  const fs::path folder = fs::path(argc > 1 ? argv[1] : ".") / "consumers";
  if (!fs::exists(folder / "verdicts.tsv")) {
    std::puts("skipped: there is no folder of shared test data beside the project");
    return kSkipped;
  }
  const std::vector<Case> cases = read_cases(folder / "verdicts.tsv");
  bool is_good = cases.size() >= 146;
  for (const auto& [name, column] : kColumns) {
    const Reader& target = *find_target(name);
    std::size_t agreed = 0;
    for (const Case& one : cases) {
      const std::string verdict = verdict_of(one, column);
      const bool all_take = std::all_of(one.verdicts.begin(), one.verdicts.end(),
                                        [](const auto& entry) { return entry.second == "ok"; });
      const bool is_refused = verdict == "refused" || verdict == "crash";
      const bool error = has_error(folder / "cases" / one.file, target);
      const bool agrees = is_refused ? error : !(all_take && error);
      if (agrees)
        ++agreed;
      else
        std::printf("  %s: %s, %s\n", one.file.c_str(), verdict.c_str(),
                    error ? "an error here" : "no error here");
    }
    const double score = static_cast<double>(agreed) / static_cast<double>(cases.size());
    std::printf("%s: %zu of %zu (%.1f %%)\n", std::string(name).c_str(), agreed, cases.size(),
                100 * score);
    is_good = is_good && score >= kLeastScore;
  }
  return is_good ? 0 : 1;
}
