// SPDX-License-Identifier: BSD-3-Clause
// Which of several robots load in which program.
#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "base/text/counted.hpp"
#include "base/text/lists.hpp"
#include "render/paint.hpp"
#include "render/printable.hpp"
#include "render/wrap.hpp"
#include "smurf/render.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostRows = 20;
constexpr std::size_t kPathColumns = 48;

std::size_t count_of(const RobotAnswers& robot, Answer answer) {
  return static_cast<std::size_t>(std::count(robot.answers.begin(), robot.answers.end(), answer));
}

std::string_view short_word(Answer answer) {
  switch (answer) {
  case Answer::takes: return "loads";
  case Answer::loses: return "losses";
  case Answer::unknown: return "not known";
  case Answer::refuses: break;
  }
  return "fails";
}

/// The word, in the width of its column.
std::string cell(Answer answer, std::size_t width, const render::Painter& paint) {
  const std::string_view word = short_word(answer);
  const std::string space(width - word.size(), ' ');
  if (answer == Answer::takes) return std::string(word) + space;
  const render::Ink ink = answer == Answer::refuses ? render::Ink::error : render::Ink::warning;
  return paint(ink, word) + space;
}

/// The robots that some target does not load without losses, the worst first.
std::vector<const RobotAnswers*> worst_first(std::span<const RobotAnswers> robots) {
  std::vector<const RobotAnswers*> rows;
  for (const RobotAnswers& robot : robots) {
    if (count_of(robot, Answer::takes) < robot.answers.size()) rows.push_back(&robot);
  }
  const auto badness = [](const RobotAnswers& robot) {
    return std::tuple(count_of(robot, Answer::refuses), count_of(robot, Answer::unknown),
                      count_of(robot, Answer::loses));
  };
  std::stable_sort(rows.begin(), rows.end(), [&](const RobotAnswers* a, const RobotAnswers* b) {
    return badness(*a) > badness(*b);
  });
  return rows;
}

/// "gazebo: 21 of 38 robots load, 5 of them with losses"
std::string sentence(std::span<const RobotAnswers> robots, std::size_t target,
                     std::string_view name) {
  const auto count = [&](Answer answer) {
    return static_cast<std::size_t>(
        std::count_if(robots.begin(), robots.end(),
                      [&](const RobotAnswers& robot) { return robot.answers[target] == answer; }));
  };
  const std::size_t with_losses = count(Answer::loses);
  const std::size_t loaded = count(Answer::takes) + with_losses;
  std::string text = std::string(name) + ": " + std::to_string(loaded) + " of " +
                     std::to_string(robots.size()) + " robots " + (loaded == 1 ? "loads" : "load");
  if (with_losses > 0) {
    text += with_losses == loaded ? ", with losses"
                                  : ", " + std::to_string(with_losses) + " of them with losses";
  }
  if (const std::size_t unknown = count(Answer::unknown); unknown > 0) {
    text += "; " + std::to_string(unknown) + " not known";
  }
  return text + "\n";
}

}  // namespace

namespace {

/// The path without its first folders, if it is wider: ".../arm/urdf/arm.urdf".
std::string end_of_path(const std::string& path, std::size_t columns) {
  constexpr std::string_view kLeftOut = "...";
  std::string_view rest = path;
  while (render::width_of(rest) + kLeftOut.size() > columns) {
    const std::size_t slash = rest.find('/', 1);
    if (slash == std::string_view::npos) break;
    rest.remove_prefix(slash);
  }
  const bool is_whole = rest.size() == path.size() || render::width_of(path) <= columns;
  return is_whole ? path : std::string(kLeftOut).append(rest);
}

}  // namespace

std::string render_fleet(std::span<const RobotAnswers> robots) {
  constexpr std::size_t kMostNamed = 3;
  if (robots.size() < 2) return {};
  std::string text;
  bool are_all_fine = false;
  const auto add = [&](std::string_view one, std::string_view many, auto&& belongs) {
    std::vector<std::string> names;
    for (const RobotAnswers& robot : robots) {
      if (belongs(robot)) names.push_back(render::escape(robot.path));
    }
    const std::size_t count = names.size();
    if (count == 0) return;
    std::sort(names.begin(), names.end());
    const bool are_all = count == robots.size();
    are_all_fine = are_all && text.empty() && many == "are fine";
    text += are_all ? "all " + std::to_string(count) + " robots "
            : text.empty()
                ? std::to_string(robots.size()) + " robots: " + std::to_string(count) + " "
                : ", " + std::to_string(count) + " ";
    text += std::string(count == 1 ? one : many) + " (" + enumerated_to(kMostNamed, names) + ")";
  };
  const auto worst_of = [](const RobotAnswers& robot) {
    return robot.worst.value_or(Severity::info);
  };
  const auto is_unknown = [&](const RobotAnswers& robot) {
    return robot.is_unknown && worst_of(robot) != Severity::error;
  };
  add("is fine", "are fine",
      [&](const auto& one) { return worst_of(one) == Severity::info && !is_unknown(one); });
  add("is not checked", "are not checked", is_unknown);
  add("has warnings", "have warnings",
      [&](const auto& one) { return worst_of(one) == Severity::warning && !is_unknown(one); });
  add("has errors", "have errors",
      [&](const auto& one) { return worst_of(one) == Severity::error; });
  return are_all_fine ? std::string() : render::wrap(text, 0, render::kColumns) + "\n";
}

std::string render_robots(std::span<const RobotAnswers> robots,
                          std::span<const TargetVerdict> targets, const TextStyle& style) {
  const std::vector<const RobotAnswers*> rows = worst_first(robots);
  if (robots.size() < 2 || rows.empty()) return {};
  const render::Painter paint(style.color);
  const std::size_t shown = std::min(rows.size(), kMostRows);
  std::vector<std::string> paths;
  std::size_t indent = 0;
  for (std::size_t i = 0; i < shown; ++i) {
    paths.push_back(end_of_path(render::escape(rows[i]->path), kPathColumns));
    indent = std::max(indent, render::width_of(paths.back()));
  }
  std::string out(indent, ' ');
  const auto end_row = [&] { out.erase(out.find_last_not_of(' ') + 1) += "\n"; };
  std::vector<std::size_t> widths;
  for (const TargetVerdict& target : targets) {
    const std::string_view name = target.reader->name;
    widths.push_back(std::max(name.size(), short_word(Answer::unknown).size()));
    out += "  " + paint(render::Ink::strong, name) + std::string(widths.back() - name.size(), ' ');
  }
  end_row();
  for (std::size_t i = 0; i < shown; ++i) {
    out += paths[i] + std::string(indent - render::width_of(paths[i]), ' ');
    for (std::size_t j = 0; j < widths.size(); ++j) {
      out += "  " + cell(rows[i]->answers[j], widths[j], paint);
    }
    end_row();
  }
  if (rows.size() > shown) {
    out += "... and " + std::to_string(rows.size() - shown) + " more that do not load everywhere\n";
  }
  out += "\n";
  for (std::size_t j = 0; j < targets.size(); ++j) {
    out += sentence(robots, j, targets[j].reader->name);
  }
  return out;
}

}  // namespace smurf
