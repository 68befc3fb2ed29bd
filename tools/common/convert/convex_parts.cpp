// SPDX-License-Identifier: BSD-3-Clause
#include "common/convert/convex_parts.hpp"

#include <csignal>
#include <optional>
#include <string>
#include <string_view>

#include "base/numbers/numbers.hpp"
#include "common/cli/process.hpp"

namespace smurf::tools {
namespace {

/// Reads numbers, writes numbers: see text_of() and Answer. CoACD prints to standard output, so
/// that gets another place. Modules in the current folder, which may be anybody's, are not run.
/// Exit code 3: there is no CoACD.
constexpr const char* kScript = R"(
import sys
sys.path = [folder for folder in sys.path if folder]
import os
out = os.fdopen(os.dup(1), "w")
os.dup2(2, 1)
words = sys.stdin.buffer.read().split()
seconds, most, points, triangles, closed = (int(word) for word in words[:5])
if seconds:
    import resource
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds))
try:
    import coacd
except ImportError:
    sys.exit(3)
def rows(begin, count, kind):
    return [[kind(word) for word in words[i:i + 3]] for i in range(begin, begin + 3 * count, 3)]
mesh = coacd.Mesh()
mesh.vertices = rows(6, points, float)
mesh.indices = rows(6 + 3 * points, triangles, int)
parts = coacd.run_coacd(mesh, threshold=float(words[5]), max_convex_hull=most, seed=0,
                        preprocess_mode="off" if closed else "auto")
print(len(parts), file=out)
for corners, _ in parts:
    print(len(corners), *(repr(float(x)) for corner in corners for x in corner), file=out)
out.flush()
)";

std::string text_of(const DividedMesh& mesh, std::uint64_t seconds) {
  std::string text = std::to_string(seconds) + ' ' + std::to_string(mesh.most_parts) + ' ' +
                     std::to_string(mesh.points.size()) + ' ' +
                     std::to_string(mesh.indices.size() / 3) + (mesh.is_closed ? " 1 " : " 0 ") +
                     format_number(mesh.concavity) + '\n';
  for (const Vector3& point : mesh.points) {
    for (const double x : point) text += format_number(x) + ' ';
  }
  for (const std::uint32_t index : mesh.indices) text += std::to_string(index) + ' ';
  return text;
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
    constexpr double kMost = 1e7;
    if (!found || !(*found >= 0 && *found <= kMost)) return std::nullopt;
    return static_cast<std::size_t>(*found);
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
    const auto corners = answer.count();
    if (!corners) return std::nullopt;
    std::vector<Vector3>& part = parts.emplace_back();
    for (std::size_t k = 0; k < *corners; ++k) {
      Vector3& corner = part.emplace_back();
      for (double& x : corner) {
        const auto number = answer.number();
        if (!number) return std::nullopt;
        x = *number;
      }
    }
  }
  return parts;
}

}  // namespace

ConvexParts divide_with_coacd(const DividedMesh& mesh, std::uint64_t seconds) {
  constexpr int kAbsent = 3;
  constexpr std::string_view kInstall =
      "; --collision parts needs python3 with CoACD: `python3 -m pip install coacd`";
  const ProgramRun run = run_program("python3", {"-c", kScript}, text_of(mesh, seconds));
  if (!run.problem.empty()) return {{}, run.problem + std::string(kInstall), true};
  if (run.exit_code == kAbsent && run.signal == 0)
    return {{}, "the python3 on the PATH has no module `coacd`" + std::string(kInstall), true};
#ifdef SIGXCPU
  if (run.signal == SIGXCPU || (run.signal == SIGKILL && seconds > 0))
    return {{},
            "CoACD takes more than " + std::to_string(seconds) +
                " s of processor time, which `--max-seconds` limits",
            false};
#endif
  if (run.signal != 0)
    return {{}, "CoACD was ended by signal " + std::to_string(run.signal), false};
  std::optional<std::vector<std::vector<Vector3>>> parts = parts_in(run.output);
  if (run.exit_code != 0 || !parts) return {{}, "CoACD failed", false};
  return {std::move(*parts), "", false};
}

}  // namespace smurf::tools
