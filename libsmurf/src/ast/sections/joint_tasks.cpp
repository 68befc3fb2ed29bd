// SPDX-License-Identifier: BSD-3-Clause
// Sources: rock-cpp/smurf Robot.cpp:22-31, 128-151, 190-280, DynamicTransformation.hpp.
#include "ast/sections.hpp"

namespace smurf::sections::joint_tasks_file {
namespace {

using enum ValueType;

constexpr Key<JointTask> kKeys[] = {
    {{.name = "name",
      .type = text,
      .doc = "Joint whose position is provided.",
      .required = true,
      .names = {NameKind::joint}},
     &JointTask::name},
    {{.name = "provider",
      .type = text,
      .doc = "Task that provides the pose of the child link.",
      .required = true},
     &JointTask::provider},
    {{.name = "port", .type = text, .doc = "Port of that task.", .required = true},
     &JointTask::port},
    {{.name = "driver", .type = text, .doc = "Task that drives the joint.", .required = true},
     &JointTask::driver},
};

std::vector<const KeySpec*> keys(KeyFilter takes) { return specs_of<JointTask>(kKeys, {}, takes); }

void read(yaml::View entry, Span section, Annotations& out, DiagnosticSink& sink) {
  read_into<JointTask>(kKeys, {}, "joint task", entry, section, out.joint_tasks, sink);
}

}  // namespace

constinit const SectionSpec joint_tasks{.name = "joint_tasks",
                                        .entry = "joint task",
                                        .doc = "Tasks of Rock that provide and drive joints.",
                                        .read_by = "MARS with envire",
                                        .filtered_keys = keys,
                                        .read = read,
                                        .list = list_of<&Annotations::joint_tasks>()};

}  // namespace smurf::sections::joint_tasks_file
