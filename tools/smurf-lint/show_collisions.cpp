// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/show_collisions.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <string>

#include "base/deadline.hpp"
#include "base/text/counted.hpp"
#include "base/text/edits.hpp"
#include "common/files/output.hpp"
#include "link/collision_matrix.hpp"
#include "smurf-lint/one_model.hpp"

namespace smurf::tools {
namespace {

constexpr int kUsualSamples = 10'000;
constexpr std::array kReasons{PairReason::adjacent, PairReason::at_start, PairReason::always,
                              PairReason::never};

std::size_t count_of(const CollisionMatrix& matrix, PairReason reason) {
  std::size_t count = 0;
  for (const LinkPair& pair : matrix.pairs) count += pair.reason == reason ? 1 : 0;
  return count;
}

/// "37 of 66 pairs of links need no check: 11 Adjacent, 2 Default, 0 Always, 24 Never (10000 joint
/// positions)".
std::string summary_of(const CollisionMatrix& matrix) {
  std::string text = std::to_string(matrix.pairs.size()) + " of " + counted(matrix.all, "pair") +
                     " of links need no check: ";
  for (const PairReason reason : kReasons) {
    text += (reason == kReasons.front() ? "" : ", ") + std::to_string(count_of(matrix, reason)) +
            " " + std::string(name_of(reason));
  }
  return text + " (" + counted(matrix.samples, "joint position") + ")";
}

std::string srdf_of(const LinkedModel& model, const CollisionMatrix& matrix) {
  const auto name = [&](std::size_t link) {
    return escape_xml(model.robot->links[link].name.value_or({}));
  };
  std::string text = "<?xml version=\"1.0\"?>\n<!-- " + summary_of(matrix) +
                     "; shapes are their convex hulls -->\n<robot name=\"" +
                     escape_xml(model.robot->name.value_or("robot")) + "\">\n";
  for (const LinkPair& pair : matrix.pairs) {
    text += "  <disable_collisions link1=\"" + name(pair.link) + "\" link2=\"" + name(pair.other) +
            "\" reason=\"" + std::string(name_of(pair.reason)) + "\"/>\n";
  }
  return text + "</robot>\n";
}

}  // namespace

Option collision_matrix_option(LintOptions& options) {
  return {.group = "Input",
          .name = "collision-matrix",
          .metavar = "PATH",
          .help =
              "Write an SRDF with the pairs of links of a robot whose collisions a motion planner "
              "need not check, as MoveIt's setup assistant does, and check nothing else: "
              "neighbours, and links that touch at the start, always or never in the range of the "
              "joints. Shapes count as their convex hulls.",
          .set = set_text(options.collision_matrix)};
}

Option samples_option(LintOptions& options) {
  return {.group = "Input",
          .name = "samples",
          .metavar = "N",
          .help = "With --collision-matrix: try this many joint positions; default: 10000.",
          .set = set_number(options.samples, 1)};
}

ExitCode show_collisions(const LintOptions& options) {
  const std::string& path = options.collision_matrix;
  return show_model(options, path, [&](const LinkedModel& model) -> std::optional<std::string> {
    const int samples = options.samples.value_or(kUsualSamples);
    CollisionMatrix matrix;
    try {
      const Deadline deadline(options.max_seconds);
      matrix = collision_matrix(model, static_cast<std::size_t>(samples));
    } catch (const OutOfTime&) {
      complain(kSmurfLint, "the collision matrix of '" + path + "' takes more than " +
                               std::to_string(options.max_seconds) +
                               " seconds; --samples tries fewer joint positions, and "
                               "--max-seconds allows more time");
      return std::nullopt;
    }
    if (!matrix.is_complete) {
      complain(kSmurfLint, "'" + path + "' has too many shapes for a collision matrix");
      return std::nullopt;
    }
    if (matrix.unknown > 0) {
      complain(kSmurfLint, counted(matrix.unknown, "link") +
                               " with shapes that cannot be read: their pairs are left out");
    }
    if (matrix.floating > 0) {
      complain(kSmurfLint, counted(matrix.floating, "pair") +
                               " on both sides of a floating or planar joint are left out");
    }
    if (!options.output.empty() && options.output != "-" && !options.quiet) {
      complain(kSmurfLint, "wrote " + options.output + ": " + summary_of(matrix));
    }
    return srdf_of(model, matrix);
  });
}

}  // namespace smurf::tools
