// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/colours.hpp"

#include <algorithm>
#include <iterator>

namespace smurf::sdformat {
namespace {

struct Row {
  std::string_view name;
  Vector3 colour;
};
// The diffuse colours of gazebo.material of Gazebo 11, which Gazebo Sim uses, too.
constexpr Row kRows[] = {{"Black", {0, 0, 0}},
                         {"Blue", {0, 0, 1}},
                         {"BlueLaser", {0, 0, 1}},
                         {"BlueTransparent", {0, 0, 1}},
                         {"DarkGrey", {0.175, 0.175, 0.175}},
                         {"DarkGray", {0.175, 0.175, 0.175}},
                         {"DarkYellow", {0.7, 0.7, 0}},
                         {"FlatBlack", {0.1, 0.1, 0.1}},
                         {"Gold", {0.8, 0.64869, 0.120759}},
                         {"Green", {0, 1, 0}},
                         {"Grey", {0.7, 0.7, 0.7}},
                         {"Gray", {0.7, 0.7, 0.7}},
                         {"Indigo", {0.33, 0, 0.5}},
                         {"LightGrey", {0.85, 0.85, 0.85}},
                         {"Orange", {1, 0.5088, 0.0468}},
                         {"Purple", {1, 0, 1}},
                         {"Red", {1, 0, 0}},
                         {"RedBright", {0.87, 0.26, 0.07}},
                         {"Turquoise", {0, 1, 1}},
                         {"White", {1, 1, 1}},
                         {"Yellow", {1, 1, 0}},
                         {"ZincYellow", {0.9725, 0.9529, 0.2078}}};

}  // namespace

std::optional<Vector3> colour_of(std::string_view name) {
  constexpr std::string_view kFamily = "Gazebo/";
  if (!name.starts_with(kFamily)) return std::nullopt;
  name.remove_prefix(kFamily.size());
  const auto* row = std::find_if(std::begin(kRows), std::end(kRows),
                                 [&](const Row& one) { return one.name == name; });
  return row != std::end(kRows) ? std::optional(row->colour) : std::nullopt;
}

}  // namespace smurf::sdformat
