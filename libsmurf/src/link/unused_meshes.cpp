// SPDX-License-Identifier: BSD-3-Clause
#include "link/unused_meshes.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

constexpr int kLevelsToPackage = 3;                    // from the robot to its package.xml
constexpr int kDeepestText = 4;                        // below the package
constexpr std::size_t kMostTextsOfPackage = 100;       // of a package
constexpr std::size_t kMostEntriesOfPackage = 2000;    // of a package, in its folders
constexpr std::uint64_t kMostOfText = 1024ULL << 10U;  // of a text
constexpr std::size_t kMostCandidates = 200;
constexpr std::uint64_t kMostOfTexts = 8 * kMostOfText;  // each is searched for each candidate

bool is_mesh_name(std::string_view name) {
  return is_one_of(path::to_lower(path::extension(name)),
                   {".stl", ".obj", ".dae", ".glb", ".gltf", ".ply"});
}

bool is_text_name(std::string_view name) {
  return is_one_of(path::to_lower(path::extension(name)),
                   {".urdf", ".xacro", ".sdf", ".xml", ".world", ".gazebo", ".trans", ".smurf",
                    ".smurfs", ".yaml", ".yml", ".json", ".py", ".launch", ".proto", ".wbt",
                    ".usda", ".txt", ".md"});
}

/// Whether a text has links, and so may be another robot with the same meshes.
bool is_description(std::string_view text) { return text.find("<link") != std::string_view::npos; }

/// The name without extension, in which files of one part in several formats agree.
std::string stem_of(std::string_view path) { return path::to_lower(path::stem(path)); }

/// Whether the text has an attribute of a mesh whose file name is computed: `meshes/${name}.stl`.
bool computes_names(std::string_view text) {
  for (std::size_t at = text.find("filename"); at != std::string_view::npos;
       at = text.find("filename", at + 1)) {
    const std::size_t begin = text.find_first_of("\"'<>", at);
    if (begin == std::string_view::npos || text[begin] == '<' || text[begin] == '>') continue;
    const std::size_t end = text.find(text[begin], begin + 1);
    const std::string_view value = text.substr(begin + 1, end - begin - 1);
    const bool is_computed = path::file_name(value).find_first_of("${}") != std::string_view::npos;
    if (is_computed && (value.ends_with("}") || is_mesh_name(value))) return true;
  }
  return false;
}

class UnusedMeshes {
 public:
  UnusedMeshes(const LinkedModel& model, const LoadContext& context)
      : model_(model), context_(context) {}

  std::vector<std::string> run() {
    find_candidates();
    if (candidates_.empty() || candidates_.size() > kMostCandidates) return {};
    // What was read for the robot is looked at first: it is in memory.
    for (std::size_t i = 0; i < context_.sources.size(); ++i) {
      const SourceId source{static_cast<std::uint32_t>(i)};
      read_.insert(context_.files.identity(context_.sources.path(source)));
      if (!look_at(context_.sources.text(source))) return {};
    }
    if (!look_below(root_, 0)) return {};
    return std::move(candidates_);
  }

 private:
  void find_candidates() {
    std::set<std::string> folders, stems;
    for (const MeshReference& mesh : model_.meshes) {
      if (mesh.is_texture) continue;
      if (!mesh.exists || mesh.path.empty()) return;
      const std::string path = path::normalize(mesh.path);
      folders.emplace(path::parent(path));
      stems.insert(stem_of(path));
    }
    if (folders.empty()) return;
    root_ = root();
    for (const std::string& folder : folders) {
      if (!is_below(folder)) continue;
      for (const std::string& name : context_.files.list(folder)) {
        if (!is_mesh_name(name) || stems.contains(stem_of(name))) continue;
        candidates_.push_back(path::join(folder, name));
      }
    }
  }

  /// The folder of the package of the robot; without one, that which has its meshes and its URDF.
  std::string root() const {
    const std::string own = path::normalize(path::parent(model_.urdf_path));
    std::string folder = own;
    for (int i = 0; i <= kLevelsToPackage; ++i) {
      if (context_.files.is_file(path::join(folder, "package.xml"))) return folder;
      folder = path::normalize(path::join(folder, ".."));
    }
    const bool is_subfolder =
        is_one_of(path::file_name(own), {"urdf", "robot", "robots", "xacro", "model", "models"});
    return is_subfolder ? path::normalize(path::join(own, "..")) : own;
  }

  /// Whether a folder lies in the folder of the package. One of the two paths may be relative and
  /// the other absolute.
  bool is_below(const std::string& folder) const {
    const std::string top = context_.files.identity(root_);
    std::string above = path::normalize(folder);
    for (int i = 0; i <= kDeepestText; ++i) {
      if (context_.files.identity(above) == top) return true;
      above = path::normalize(path::join(above, ".."));
    }
    return false;
  }

  /// Removes the candidates that a text names. False if it is not known which it names.
  bool look_at(std::string_view text) {
    bytes_ += text.size();
    if (bytes_ > kMostOfTexts || computes_names(text)) return false;
    std::erase_if(candidates_, [&](const std::string& one) {
      return text.find(path::stem(one)) != std::string_view::npos;
    });
    return !candidates_.empty();
  }

  bool look_below(const std::string& folder, int depth) {
    for (const std::string& name : context_.files.list(folder)) {
      if (++entries_ > kMostEntriesOfPackage) return false;
      if (name.starts_with('.')) continue;
      std::string path = path::normalize(path::join(folder, name));
      if (is_text_name(name)) {
        if (read_.contains(context_.files.identity(path))) continue;
        if (++texts_ > kMostTextsOfPackage) return false;
        const FileContent content = context_.files.read(path, kMostOfText);
        if (content.status == ReadStatus::too_large) return false;
        if (is_description(content.text) || !look_at(content.text)) return false;
      } else if (!is_mesh_name(name) && !context_.files.is_file(path)) {
        if (depth == kDeepestText || !look_below(path, depth + 1)) return false;
      }
    }
    return true;
  }

  const LinkedModel& model_;
  const LoadContext& context_;
  std::string root_;
  std::vector<std::string> candidates_;
  std::set<std::string> read_;
  std::size_t texts_ = 0, entries_ = 0;
  std::uint64_t bytes_ = 0;
};

}  // namespace

void find_unused_meshes(LinkedModel& model, const LoadContext& context) {
  if (!model.robot || !model.is_complete || model.urdf_path.empty()) return;
  model.unused_meshes = UnusedMeshes(model, context).run();
}

}  // namespace smurf
