// SPDX-License-Identifier: BSD-3-Clause
#include "link/xacro_model.hpp"

#include <algorithm>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/findings/rules.hpp"
#include "link/package_search.hpp"
#include "link/read_file.hpp"
#include "xacro/counted.hpp"

namespace smurf {

xacro::Expansion load_xacro(const std::string& path, LoadContext& context) {
  const auto root = read_source(path, {}, rules::sml0001_unreadable_file, context);
  return root ? expand_xacro(*root, context) : xacro::Expansion{};
}

xacro::Expansion expand_xacro(SourceId root, LoadContext& context) {
  xacro::Settings settings;
  settings.arguments = context.xacro.arguments;
  settings.environment = context.xacro.environment;
  settings.needs_origins = context.xacro.needs_origins;
  settings.find_package = [&](const std::string& name, const std::string& near) {
    return find_package(name, near, context);
  };
  settings.absolute = [here = std::string()](const std::string& relative) mutable {
    if (path::is_absolute(relative)) return path::normalize(places::absolute(relative));
    if (here.empty()) here = places::absolute(".");
    return path::join(here, relative);
  };
  xacro::Context inner{context.sources, context.files, context.sink, context.limits};
  std::uint64_t steps = 0;
  xacro::Expansion expansion = xacro::expand(root, settings, inner, steps);
  // The robots of a scene share the steps; each has at least those of an honest one.
  std::uint64_t& left = context.limits.xacro_steps;
  if (left > kStepsOfRobot) left = std::max(left - std::min(left, steps), kStepsOfRobot);
  return expansion;
}

}  // namespace smurf
