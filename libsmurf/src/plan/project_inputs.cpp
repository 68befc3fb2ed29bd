// SPDX-License-Identifier: BSD-3-Clause
#include "plan/project_inputs.hpp"

#include <vector>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "smurf/confine.hpp"
#include "smurf/plan.hpp"

namespace smurf {
namespace {

/// The project around a file, spelled like the path of the file.
std::string project_beside(const std::string& path) {
  const std::string project = project_around(path);
  std::string folder(path::parent(path));
  for (std::string at = identity(folder.empty() ? "." : folder); at != project;
       at = path::parent(at)) {
    if (at.size() <= project.size()) return project;  // behind a link
    folder = path::join(folder, "..");
  }
  return folder.empty() ? "." : folder;
}

}  // namespace

FoundInputs inputs_around(const std::string& path, const Limits& limits,
                          const LeftOut& is_left_out) {
  if (project_around(path).empty()) return {};
  FoundInputs found = find_inputs(project_beside(path), limits, is_left_out);
  const std::string here = identity(".");
  for (std::vector<std::string>* files : {&found.files, &found.xacro, &found.yaml}) {
    for (std::string& file : *files) {
      if (!file.starts_with("../")) continue;
      // Out of the current folder, and back into it.
      const std::string inside = places::relative(identity(file), here);
      if (!inside.empty() && !inside.starts_with("../")) file = inside;
    }
  }
  return found;
}

}  // namespace smurf
