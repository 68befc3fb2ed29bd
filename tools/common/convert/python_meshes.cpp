// SPDX-License-Identifier: BSD-3-Clause
#include "common/convert/python_meshes.hpp"

#include <algorithm>
#include <csignal>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/numbers/numbers.hpp"
#include "common/cli/process.hpp"

namespace smurf::tools {
namespace {

/// Reads numbers, writes numbers: see text_of() and Answer. Modules print to standard output, so
/// that gets another place. Modules in the current folder, which may be anybody's, are not run.
/// Options are numbers that stand before the mesh. Exit code 3: the module is not there.
constexpr std::string_view kReadMesh = R"(
import sys
sys.path = [folder for folder in sys.path if folder]
import os
out = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
words = sys.stdin.buffer.read().split()
seconds, points, triangles, count = (int(word) for word in words[:4])
options = [float(word) for word in words[4:4 + count]]
if seconds:
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
def rows(begin, count, kind):
    return [[kind(word) for word in words[i:i + 3]] for i in range(begin, begin + 3 * count, 3)]
points = rows(4 + count, points, float)
triangles = rows(4 + count + 3 * len(points), triangles, int)
def write(rows):
    print(len(rows), *(repr(number) for row in rows for number in row), file=out)
)";

constexpr std::string_view kDivide = R"(
try:
    import coacd
except ImportError:
    sys.exit(3)
mesh = coacd.Mesh()
mesh.vertices, mesh.indices = points, triangles
most, concavity, closed = options
parts = coacd.run_coacd(mesh, threshold=concavity, max_convex_hull=int(most), seed=0,
                        preprocess_mode="off" if closed else "auto")
print(len(parts), file=out)
for corners, _ in parts:
    write([[float(x) for x in corner] for corner in corners])
out.flush()
)";

/// The first step takes away what is hardly seen, the second one what is still too much.
constexpr std::string_view kLighten = R"(
try:
    import meshoptimizer
    import numpy
except ImportError:
    sys.exit(3)
enough, near, far = options
places = numpy.ascontiguousarray(points, dtype=numpy.float32)
def simplified(indices, most, error):
    result = numpy.zeros(len(indices), dtype=numpy.uint32)
    size = meshoptimizer.simplify(result, indices, places, target_index_count=3 * int(most), target_error=error)
    return result[:size].copy()
indices = numpy.ascontiguousarray(triangles, dtype=numpy.uint32).reshape(-1)
indices = simplified(indices, 0, near)
if len(indices) > 3 * enough:
    indices = simplified(indices, enough, far)
used = sorted(set(indices.tolist()))
numbers = {old: new for new, old in enumerate(used)}
write([points[old] for old in used])
indices = [numbers[old] for old in indices.tolist()]
write([indices[i:i + 3] for i in range(0, len(indices), 3)])
out.flush()
)";

std::string text_of(std::span<const Vector3> points, std::span<const std::uint32_t> indices,
                    std::span<const double> options, std::uint64_t seconds) {
  std::string text = std::to_string(seconds) + ' ' + std::to_string(points.size()) + ' ' +
                     std::to_string(indices.size() / 3) + ' ' + std::to_string(options.size());
  for (const double option : options) text += ' ' + format_number(option);
  for (const Vector3& point : points) {
    for (const double x : point) text += ' ' + format_number(x);
  }
  for (const std::uint32_t index : indices) text += ' ' + std::to_string(index);
  return text + '\n';
}

/// Numbers between spaces.
class Answer {
 public:
  explicit Answer(std::string_view text) : rest_(text) {}

  std::optional<double> number() {
    const std::size_t begin = rest_.find_first_not_of(" \n\r");
    if (begin == std::string_view::npos) return std::nullopt;
    rest_.remove_prefix(begin);
    const std::size_t end = std::min(rest_.find_first_of(" \n\r"), rest_.size());
    const auto number = parse_number(rest_.substr(0, end));
    rest_.remove_prefix(end);
    return number;
  }

  std::optional<std::size_t> count() {
    const auto found = number();
    constexpr double kMost = 1e8;
    if (!found || !(*found >= 0 && *found <= kMost)) return std::nullopt;
    return static_cast<std::size_t>(*found);
  }

  /// Rows of three numbers after their count.
  std::optional<std::vector<Vector3>> rows() {
    const auto size = count();
    if (!size) return std::nullopt;
    std::vector<Vector3> rows;
    for (std::size_t i = 0; i < *size; ++i) {
      Vector3& row = rows.emplace_back();
      for (double& x : row) {
        const auto found = number();
        if (!found) return std::nullopt;
        x = *found;
      }
    }
    return rows;
  }

 private:
  std::string_view rest_;
};

/// None if it is not what the script writes.
std::optional<std::vector<std::vector<Vector3>>> parts_in(std::string_view text) {
  Answer answer(text);
  const auto count = answer.count();
  if (!count) return std::nullopt;
  std::vector<std::vector<Vector3>> parts;
  for (std::size_t i = 0; i < *count; ++i) {
    auto part = answer.rows();
    if (!part) return std::nullopt;
    parts.push_back(std::move(*part));
  }
  return parts;
}

/// The same.
std::optional<LighterMesh> lighter_in(std::string_view text) {
  Answer answer(text);
  auto points = answer.rows();
  const auto triangles = answer.rows();
  if (!points || !triangles) return std::nullopt;
  LighterMesh mesh{std::move(*points), {}, "", false};
  for (const Vector3& triangle : *triangles) {
    for (const double corner : triangle) {
      if (!(corner >= 0 && corner < static_cast<double>(mesh.points.size()))) return std::nullopt;
      mesh.indices.push_back(static_cast<std::uint32_t>(corner));
    }
  }
  return mesh;
}

struct Program {
  std::string_view script;   ///< after kReadMesh
  std::string_view library;  ///< as people know it
  std::string_view module;   ///< of Python, and its package
  std::string_view shapes;   ///< the value of --collision
};
constexpr Program kCoacd{kDivide, "CoACD", "coacd", "parts"};
constexpr Program kMeshoptimizer{kLighten, "meshoptimizer", "meshoptimizer", "lighter"};

struct Output {
  std::string text;
  std::string problem;
  bool is_for_no_mesh = false;
};

Output run(const Program& program, const std::string& input, std::uint64_t seconds) {
  constexpr int kAbsent = 3;
  const std::string module(program.module);
  const std::string library(program.library);
  const std::string install = "; --collision " + std::string(program.shapes) +
                              " needs python3 with " + library + ": `python3 -m pip install " +
                              module + "`";
  const ProgramRun run =
      run_program("python3", {"-c", std::string(kReadMesh) + std::string(program.script)}, input);
  if (!run.problem.empty()) return {"", run.problem + install, true};
  if (run.exit_code == kAbsent && run.signal == 0)
    return {"", "the python3 on the PATH has no module `" + module + "`" + install, true};
#ifdef SIGXCPU
  if (run.signal == SIGXCPU || (run.signal == SIGKILL && seconds > 0))
    return {"",
            library + " takes more than " + std::to_string(seconds) +
                " s of processor time, which `--max-seconds` limits",
            false};
#endif
  if (run.signal != 0)
    return {"", library + " was ended by signal " + std::to_string(run.signal), false};
  if (run.exit_code != 0) return {"", library + " failed", false};
  return {run.output, "", false};
}

}  // namespace

ConvexParts divide_with_coacd(const DividedMesh& mesh, std::uint64_t seconds) {
  const double options[] = {static_cast<double>(mesh.most_parts), mesh.concavity,
                            mesh.is_closed ? 1.0 : 0.0};
  Output output = run(kCoacd, text_of(mesh.points, mesh.indices, options, seconds), seconds);
  if (!output.problem.empty()) return {{}, std::move(output.problem), output.is_for_no_mesh};
  auto parts = parts_in(output.text);
  if (!parts) return {{}, "CoACD failed", false};
  return {std::move(*parts), "", false};
}

LighterMesh lighten_with_meshoptimizer(const HeavyMesh& mesh, std::uint64_t seconds) {
  const double options[] = {static_cast<double>(mesh.triangles), mesh.near, mesh.far};
  Output output =
      run(kMeshoptimizer, text_of(mesh.points, mesh.indices, options, seconds), seconds);
  if (!output.problem.empty()) return {{}, {}, std::move(output.problem), output.is_for_no_mesh};
  auto lighter = lighter_in(output.text);
  if (!lighter) return {{}, {}, "meshoptimizer failed", false};
  return std::move(*lighter);
}

}  // namespace smurf::tools
