// SPDX-License-Identifier: BSD-3-Clause
// Sources: moveit2 planning_pipeline.cpp, default_request_adapters_plugin_description.xml and
// default_response_adapters_plugin_description.xml, branches humble and jazzy.
#include "lint/companions/pipelines.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "lint/companions/controllers.hpp"
#include "lint/companions/moveit_files.hpp"

namespace smurf {
namespace {

constexpr std::string_view kOldAdapters[] = {
    "default_planner_request_adapters/AddTimeOptimalParameterization",
    "default_planner_request_adapters/AddRuckigTrajectorySmoothing",
    "default_planner_request_adapters/AddTimeParameterization",
    "default_planner_request_adapters/ResolveConstraintFrames",
    "default_planner_request_adapters/FixWorkspaceBounds",
    "default_planner_request_adapters/FixStartStateBounds",
    "default_planner_request_adapters/FixStartStateCollision",
    "default_planner_request_adapters/FixStartStatePathConstraints",
    "default_planner_request_adapters/Empty",
    "chomp/OptimizerAdapter",
};
constexpr std::string_view kNewAdapters[] = {
    "default_planning_request_adapters/ResolveConstraintFrames",
    "default_planning_request_adapters/ValidateWorkspaceBounds",
    "default_planning_request_adapters/CheckStartStateBounds",
    "default_planning_request_adapters/CheckStartStateCollision",
    "default_planning_request_adapters/CheckForStackedConstraints",
    "default_planning_response_adapters/AddTimeOptimalParameterization",
    "default_planning_response_adapters/AddRuckigTrajectorySmoothing",
    "default_planning_response_adapters/ValidateSolution",
    "default_planning_response_adapters/DisplayMotionPath",
};
/// What to write for an adapter of the other release.
constexpr struct {
  std::string_view old_name, new_name;
} kSuccessors[] = {
    {"AddTimeOptimalParameterization",
     "default_planning_response_adapters/AddTimeOptimalParameterization"},
    {"AddRuckigTrajectorySmoothing",
     "default_planning_response_adapters/AddRuckigTrajectorySmoothing"},
    {"ResolveConstraintFrames", "default_planning_request_adapters/ResolveConstraintFrames"},
    {"FixWorkspaceBounds", "default_planning_request_adapters/ValidateWorkspaceBounds"},
    {"FixStartStateBounds", "default_planning_request_adapters/CheckStartStateBounds"},
    {"FixStartStateCollision", "default_planning_request_adapters/CheckStartStateCollision"},
};

template <class Names>
bool contains(const Names& names, std::string_view name) {
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}

class Pipeline {
 public:
  explicit Pipeline(yaml::View mapping) : mapping_(mapping) {}

  MoveitPipeline run() {
    const yaml::View one = mapping_.find("planning_plugin"),
                     many = mapping_.find("planning_plugins");
    // A mapping with both keys serves both.
    if (one && many) return {};
    if (one && one.is_scalar())
      found_.humble.push_back(
          {one.key_span(), "`planning_plugin`", "write `planning_plugins`, a list"});
    if (many && many.is_sequence())
      found_.later.push_back(
          {many.key_span(), "`planning_plugins`", "write `planning_plugin`, one text"});
    for (const std::string_view key : {"request_adapters", "response_adapters"}) {
      const yaml::View list = mapping_.find(key);
      if (list) adapters(key, list);
    }
    if (mapping_.find("response_adapters")) {
      const yaml::View list = mapping_.find("response_adapters");
      found_.later.push_back(
          {list.key_span(), "`response_adapters`", "move it into `request_adapters`"});
    }
    if (!one && many) times();
    return std::move(found_);
  }

 private:
  void adapters(std::string_view key, yaml::View value) {
    if (value.is_scalar() && key == "request_adapters" && !is_placeholder(value.text())) {
      found_.humble.push_back({value.place(), "a text in `request_adapters`", "write a list"});
      for (std::size_t at = 0;;) {
        const std::string_view word = next_word(value.text(), at);
        if (word.empty()) break;
        adapter(word, value);
      }
    } else if (value.is_sequence()) {
      if (key == "request_adapters")
        found_.later.push_back({value.key_span(), "a list in `request_adapters`",
                                "write one text, with blanks between the adapters"});
      for (const yaml::View item : value) {
        if (item.is_scalar()) adapter(trimmed(item.text()), item);
      }
    }
  }

  void adapter(std::string_view name, yaml::View value) {
    const Span place = value.span();
    if (contains(kOldAdapters, name)) {
      const std::string_view last = name.substr(name.find('/') + 1);
      std::string help = "write the adapters of Jazzy, `default_planning_request_adapters/...`";
      for (const auto& one : kSuccessors) {
        if (one.old_name == last) help = "write " + quoted(one.new_name);
      }
      found_.humble.push_back({place, quoted(name), help});
    } else if (contains(kNewAdapters, name)) {
      found_.later.push_back(
          {place, quoted(name),
           "write the adapters of Humble, `default_planner_request_adapters/...`"});
    } else {
      std::vector<std::string_view> all(std::begin(kNewAdapters), std::end(kNewAdapters));
      all.insert(all.end(), std::begin(kOldAdapters), std::end(kOldAdapters));
      const auto near = nearest(name, all);
      constexpr int kMostEdits = 3;
      if (!near || edit_distance(name, *near, kMostEdits) > kMostEdits) return;
      found_.misspelt.push_back({value, name, *near});
    }
  }

  /// Since Jazzy, a path has times only with a response adapter.
  void times() {
    const yaml::View list = mapping_.find("response_adapters");
    if (!list || !list.is_sequence() || !found_.humble.empty()) return;
    for (const yaml::View item : list) {
      const std::string_view name = item.is_scalar() ? item.text() : std::string_view();
      if (name.find("AddTime") != std::string_view::npos ||
          name.find("Ruckig") != std::string_view::npos ||
          name.find("default_planning_response_adapters/") == std::string_view::npos) {
        return;  // or one of another package
      }
    }
    found_.without_times = list.key_span();
  }

  yaml::View mapping_;
  MoveitPipeline found_;
};

// The recursion is as deep as the file, whose depth is limited.
void read_pipelines(yaml::View mapping, std::vector<MoveitPipeline>& all) {
  all.push_back(Pipeline(mapping).run());
  for (const yaml::View member : mapping) {
    if (member.is_mapping() && member.key() != "planner_configs") read_pipelines(member, all);
  }
}

}  // namespace

std::vector<MoveitPipeline> moveit_pipelines(const Companions& companions) {
  std::vector<MoveitPipeline> all;
  for_each_file(companions, CompanionKind::ompl_planning,
                [&](const Companion& file, yaml::View root) {
                  if (file.is_ros2) read_pipelines(root, all);
                });
  return all;
}

}  // namespace smurf
