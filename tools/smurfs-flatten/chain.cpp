// SPDX-License-Identifier: BSD-3-Clause
#include "smurfs-flatten/chain.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/numbers/numbers.hpp"
#include "base/text/did_you_mean.hpp"
#include "base/text/lists.hpp"
#include "common/cli/command.hpp"
#include "render/printable.hpp"

namespace smurf::tools {
namespace {

std::string join(const Vector3& vector) {
  std::string text;
  for (const double component : vector) {
    // Rounding errors of a sine would only distract people.
    const double shown = std::fabs(component) < 1e-12 ? 0 : component;
    text += (text.empty() ? "" : " ") + format_rounded(shown, 9);
  }
  return text;
}

std::string describe(const Pose& pose) {
  std::string text = "xyz " + join(pose.position);
  Vector3 degrees = to_rpy(pose.orientation);
  for (double& angle : degrees) angle *= 180 / std::numbers::pi;
  return text + "  rpy " + join(degrees) + " deg";
}

std::string place(const SourceMap& sources, Span span) {
  const Position at = sources.position(span.source, span.begin);
  return render::escape(sources.path(span.source)) + ":" + std::to_string(at.line) + ":" +
         std::to_string(at.column);
}

}  // namespace

std::optional<std::string> describe_chain(const LinkedScene& scene, const SourceMap& sources,
                                          InstanceIndex instance, const Dialect& dialect) {
  const std::vector<TransformStep> steps = explain(scene, instance, dialect);
  if (steps.size() > kMostSteps) return std::nullopt;
  std::size_t place_width = 0;
  std::size_t what_width = 0;
  for (const TransformStep& step : steps) {
    place_width = std::max(place_width, render::width_of(place(sources, step.span)));
    what_width = std::max(what_width, render::width_of(render::escape(step.what)));
  }
  const auto padded = [](const std::string& text, std::size_t width) {
    const std::size_t taken = render::width_of(text);
    return text + std::string(width > taken ? width - taken + 2 : 2, ' ');
  };
  std::string text;
  for (const TransformStep& step : steps) {
    text += padded(place(sources, step.span), place_width) +
            padded(render::escape(step.what), what_width) + describe(step.X_step) + "\n";
  }
  text += padded("in the world", place_width) + padded("", what_width) +
          describe(steps.back().X_W) + "\n";
  return text;
}

std::string other_instances(const std::string& name, std::span<const std::string_view> known) {
  constexpr std::size_t kMost = 8;
  const std::string instance = name.substr(0, name.find("::"));
  if (instance != name && std::find(known.begin(), known.end(), instance) != known.end()) {
    return "; name the instance alone, without a link: '" + instance + "'";
  }
  const std::string meant = did_you_mean(name, known);
  if (!meant.empty() || known.empty()) return meant;
  return "; its instances are " + shortlist(known, kMost);
}

}  // namespace smurf::tools
