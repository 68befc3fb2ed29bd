// SPDX-License-Identifier: BSD-3-Clause
#include "link/robot_srdf.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>

#include "ast/companions/srdf_reader.hpp"
#include "base/files/path.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "smurf/load.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf {
namespace {

/// An SRDF, apart from the sources of the scene: nothing in it is reported here.
struct ReadSrdf {
  SourceMap sources;
  std::optional<srdf::Description> description;

  ReadSrdf(const std::string& file, const FileReader& files, const Limits& limits) {
    DiagnosticSink sink;
    FileContent content = files.read(file, limits.srdf_bytes);
    if (content.status != ReadStatus::ok) return;
    const SourceId source = sources.add(file, std::move(content.text));
    auto document = parse_xml(sources, source, limits, sink);
    if (document) description = srdf::read(std::move(*document));
  }
};

/// The folders in which packages keep the SRDF of a URDF.
std::vector<std::string> srdf_folders(const LinkedModel& model) {
  const std::string folder(path::parent(model.urdf_path));
  std::vector<std::string> folders{folder};
  for (const char* there : {"srdf", "config", "../srdf", "../config"}) {
    folders.push_back(path::normalize(path::join(folder, there)));
  }
  return folders;
}

/// The SRDF of a robot: that of its file's name, or the only one of its name.
class SrdfFinder {
 public:
  SrdfFinder(const LinkedModel& model, const FileReader& files, const Limits& limits)
      : model_(model), files_(files), limits_(limits) {}

  /// `given`: the file that the user named.
  RobotSrdf find(const std::string& given) const {
    if (!given.empty()) {
      return read(given, false).value_or(RobotSrdf{.file = given, .pairs = {}, .states = {}});
    }
    const std::string own = stem(model_.urdf_path);
    std::vector<RobotSrdf> found;
    for (const std::string& folder : srdf_folders(model_)) {
      for (const std::string& name : files_.list(folder)) {
        if (!name.ends_with(".srdf")) continue;
        auto one = read(path::join(folder, name), true);
        if (!one) continue;
        if (stem(one->file) == own) return std::move(*one);
        found.push_back(std::move(*one));
      }
    }
    return found.size() == 1 ? std::move(found.front()) : RobotSrdf();
  }

 private:
  static std::string stem(const std::string& path) {
    const std::string name(path::file_name(path));
    return name.substr(0, name.find('.'));
  }

  std::optional<RobotSrdf> read(const std::string& path, bool needs_name) const {
    const ReadSrdf file(path, files_, limits_);
    if (!file.description) return std::nullopt;
    const srdf::Description& description = *file.description;
    const bool is_of_robot =
        description.name && model_.robot->name && *description.name == *model_.robot->name;
    if (needs_name && !is_of_robot) return std::nullopt;
    RobotSrdf result{.file = path, .pairs = {}, .states = {}};
    for (const srdf::LinkPair& pair : description.pairs) {
      if (pair.is_enabled || !pair.link1 || !pair.link2) continue;
      const auto a = model_.link_names.find(*pair.link1);
      const auto b = model_.link_names.find(*pair.link2);
      if (a && b && *a != *b) result.pairs.insert(std::minmax<std::size_t>(*a, *b));
    }
    std::map<std::string_view, std::size_t> known;
    for (const srdf::GroupState& state : description.states) {
      if (!state.name) continue;
      const auto [at, is_new] = known.try_emplace(*state.name, result.states.size());
      if (is_new) result.states.emplace_back(*state.name, JointPositions());
      add(state, result.states[at->second].second);
    }
    return result;
  }

  static void add(const srdf::GroupState& state, JointPositions& positions) {
    for (const srdf::StateJoint& joint : state.joints) {
      // A joint of several axes has several values, and no position here.
      const auto value = joint.value ? parse_number(*joint.value) : std::nullopt;
      if (joint.name && value && is_quantity(*value)) positions.emplace(*joint.name, *value);
    }
  }

  const LinkedModel& model_;
  const FileReader& files_;
  const Limits& limits_;
};

}  // namespace

RobotSrdf robot_srdf(const LinkedModel& model, const std::string& given, const FileReader& files,
                     const Limits& limits) {
  return SrdfFinder(model, files, limits).find(given);
}

}  // namespace smurf
