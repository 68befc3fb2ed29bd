// SPDX-License-Identifier: BSD-3-Clause
#include "link/disabled_pairs.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "ast/companions/srdf_reader.hpp"
#include "base/files/path.hpp"
#include "smurf/load.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf {
namespace {

using Pairs = std::set<std::pair<std::size_t, std::size_t>>;

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

/// The disabled pairs of the SRDF of a robot: that of its file's name, or the only one of its name.
class PairReader {
 public:
  PairReader(const LinkedModel& model, const FileReader& files, const Limits& limits)
      : model_(model), files_(files), limits_(limits) {}

  /// `given`: the file that the user named.
  Pairs find(const std::string& given, std::string& file) {
    if (!given.empty()) {
      file = given;
      return pairs_in(given, false).value_or(Pairs());
    }
    const std::string own = stem(model_.urdf_path);
    std::vector<std::pair<std::string, Pairs>> found;
    for (const std::string& folder : srdf_folders(model_)) {
      for (const std::string& name : files_.list(folder)) {
        if (!name.ends_with(".srdf")) continue;
        const std::string path = path::join(folder, name);
        auto pairs = pairs_in(path, true);
        if (!pairs) continue;
        if (stem(path) == own) {
          file = path;
          return *pairs;
        }
        found.emplace_back(path, std::move(*pairs));
      }
    }
    if (found.size() != 1) return {};
    file = found.front().first;
    return std::move(found.front().second);
  }

 private:
  static std::string stem(const std::string& path) {
    const std::string name(path::file_name(path));
    return name.substr(0, name.find('.'));
  }

  std::optional<Pairs> pairs_in(const std::string& path, bool needs_name) const {
    const ReadSrdf read(path, files_, limits_);
    if (!read.description) return std::nullopt;
    const bool is_of_robot = read.description->name && model_.robot->name &&
                             *read.description->name == *model_.robot->name;
    if (needs_name && !is_of_robot) return std::nullopt;
    Pairs pairs;
    for (const srdf::LinkPair& pair : read.description->pairs) {
      if (pair.is_enabled || !pair.link1 || !pair.link2) continue;
      const auto a = model_.link_names.find(*pair.link1);
      const auto b = model_.link_names.find(*pair.link2);
      if (a && b && *a != *b) pairs.insert(std::minmax<std::size_t>(*a, *b));
    }
    return pairs;
  }

  const LinkedModel& model_;
  const FileReader& files_;
  const Limits& limits_;
};

}  // namespace

DisabledPairs disabled_pairs(const LinkedModel& model, const std::string& given,
                             const FileReader& files, const Limits& limits) {
  DisabledPairs found;
  found.pairs = PairReader(model, files, limits).find(given, found.file);
  return found;
}

}  // namespace smurf
