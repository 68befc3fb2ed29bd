// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/text/suggest.hpp"
#include "base/text/words.hpp"
#include "imports/imports.hpp"
#include "link/companions/kinds.hpp"
#include "link/companions/places.hpp"
#include "link/package_manifest.hpp"
#include "link/package_search.hpp"
#include "link/surroundings/frame_names.hpp"
#include "link/surroundings/installation.hpp"
#include "link/surroundings/launch_files.hpp"
#include "link/surroundings/robot_facts.hpp"
#include "link/surroundings/stated_ties.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytes = kMostBytesOfLaunch;  // of a build file, too
constexpr std::size_t kMostLaunchFiles = 60;
constexpr std::size_t kMostPackages = 12;

class Loader {
 public:
  Loader(const Accompanied& robot, LoadContext& context)
      : model_(robot.model), companions_(robot.companions), context_(context) {}

  Surroundings run() {
    found_.is_xacro = model_.language == Language::xacro;
    found_.is_expanded = model_.robot.has_value();
    for (const Companion& one : companions_.files) {
      companion_paths_.emplace(context_.sources.path(one.source));
    }
    const CompanionPlaces places = companion_places(std::string(path::parent(model_.urdf_path)),
                                                    context_.files, search_of(context_));
    if (places.packages.empty()) return {};
    // The package of the robot is the first.
    const NearPackage own = places.packages.front();
    packages_by_name_[own.name] = own.folder;
    for (const NearPackage& one : places.packages)
      packages_by_name_.try_emplace(one.name, one.folder);
    if (!add_package(own.name, own.folder)) return std::move(found_);
    // A robot that cannot be read has no names that anyone would look for.
    if (model_.robot) given_ = GivenFiles(model_, places.packages, context_);
    for (const NearPackage& one : places.packages) {
      if (found_.packages.size() >= kMostPackages) break;
      if (one.folder == own.folder) continue;
      if (!search_of(context_).manifest(one.folder).dependencies.contains(own.name)) continue;
      add_package(one.name, one.folder);
    }
    const std::string file_name(path::file_name(model_.urdf_path));
    const std::string stem = file_name.substr(0, file_name.find('.'));
    for (std::size_t i = 0; i < found_.packages.size(); ++i) {
      const SurroundingPackage package = found_.packages[i];
      add_launch_files(package, i == 0 ? "" : stem);
    }
    for (LaunchFile& one : found_.launch_files) {
      const std::string name(path::file_name(one.path));
      one.is_included = std::any_of(
          found_.launch_files.begin(), found_.launch_files.end(), [&](const LaunchFile& other) {
            return &other != &one &&
                   context_.sources.text(other.source).find(name) != std::string_view::npos;
          });
    }
    read_robot_facts(model_, context_, found_);
    add_frame_files();
    judge_installation();
    read_worlds();
    for (const SurroundingPackage& one : found_.packages) {
      found_.launches_gazebo = found_.launches_gazebo || one.dependencies.contains("ros_gz_sim") ||
                               one.dependencies.contains("gz_ros2_control");
      found_.launches_classic = found_.launches_classic || one.dependencies.contains("gazebo_ros");
    }
    return std::move(found_);
  }

 private:
  std::optional<SourceId> source_of(const std::string& path) {
    FileContent content = context_.files.read(path, kMostBytes);
    if (content.status != ReadStatus::ok) return std::nullopt;
    const SourceId source = context_.sources.add(path::normalize(path), std::move(content.text));
    found_.sources.insert(source);
    return source;
  }

  bool add_package(const std::string& name, const std::string& folder) {
    const auto source = source_of(path::join(folder, "package.xml"));
    if (!source) return false;
    DiagnosticSink ignored(context_.limits);
    const auto document = parse_xml(context_.sources, *source, context_.limits, ignored);
    SurroundingPackage package;
    package.name = name;
    package.folder = folder;
    package.manifest = *source;
    if (!document) {
      // Nothing else in the package can be judged. An empty package.xml only marks a folder.
      const bool is_meant = imports::root_name(context_.sources.text(*source)) == "package";
      if (!is_meant || ignored.diagnostics().empty()) return false;
      const Diagnostic& fault = ignored.diagnostics().front();
      package.faults.push_back(
          {InstallFault::Kind::no_xml, fault.span, fault.message, fault.help_text});
      found_.packages.push_back(std::move(package));
      return false;
    }
    const PackageManifest manifest = read_manifest(*document);
    package.name_span = manifest.name_span;
    package.depend_span = manifest.root_span;
    package.export_span = manifest.export_span.empty() ? manifest.root_span : manifest.export_span;
    package.config_files = context_.files.list(path::join(folder, "config"));
    package.dependencies = manifest.dependencies;
    package.is_ament = manifest.is_ament;
    package.has_hooks = manifest.has_model_path ||
                        !context_.files.list(path::join(folder, "hooks")).empty() ||
                        !context_.files.list(path::join(folder, "env-hooks")).empty();
    read_build_file(package);
    found_.packages.push_back(std::move(package));
    return true;
  }

  void read_build_file(SurroundingPackage& package) {
    for (const std::string_view name : {"CMakeLists.txt", "setup.py"}) {
      const std::string path = path::join(package.folder, std::string(name));
      const auto source = source_of(path);
      if (!source) continue;
      package.build_file = *source;
      const std::string_view text = context_.sources.text(*source);
      installations_[package.name] = name == "setup.py"
                                         ? read_setup_py(text, *source, package, context_.files)
                                         : read_cmake(text, *source, package, context_.files);
      return;
    }
  }

  void add_launch_files(const SurroundingPackage& package, const std::string& needed) {
    for (const FoundLaunch& one : launch_files_of(package.folder, {"", "launch"}, context_.files)) {
      if (found_.launch_files.size() >= kMostLaunchFiles) return;
      add_launch_file(one.path, one.form, package, needed);
    }
  }

  void add_launch_file(const std::string& path, LaunchFile::Form form,
                       const SurroundingPackage& package, const std::string& needed) {
    FileContent content = context_.files.read(path, kMostBytes);
    if (content.status != ReadStatus::ok) return;
    if (!needed.empty() && content.text.find(needed) == std::string::npos) return;
    const std::string normal = path::normalize(path);
    const SourceId source = context_.sources.add(normal, content.text);
    // A path is often given several times, and looked up once.
    std::map<std::pair<std::string, std::string>, LaunchPath> seen;
    const FindLaunchPath find = [&](LaunchPath& one) {
      if (!one.text.is_known || one.text.package.empty()) return;
      const auto [known, is_new] = seen.try_emplace({one.text.package, one.text.text}, one);
      if (is_new) look_up(known->second, package, content.text);
      LaunchText text = std::move(one.text);
      one = known->second;
      one.text = std::move(text);
    };
    const bool is_ros1 = form == LaunchFile::Form::xml && !package.is_ament;
    LaunchFile file = search_of(context_).companions->launches.read(
        normal, content.text, form, is_ros1, source, context_.limits, find);
    file.package = package.name;
    file.text = context_.sources.text(source);
    file.whose = given_.whose(normal);
    const std::string robot = context_.files.identity(model_.urdf_path);
    const auto mark = [&](LaunchDescription& one) {
      one.is_of_robot =
          one.file && !one.file->path.empty() && context_.files.identity(one.file->path) == robot;
      file.is_of_robot = file.is_of_robot || one.is_of_robot;
    };
    for (LaunchDescription& one : file.descriptions) mark(one);
    file.is_of_robot = file.is_of_robot || std::any_of(file.paths.begin(), file.paths.end(),
                                                       [&](const LaunchPath& one) {
                                                         return companion_paths_.contains(one.path);
                                                       });
    note_misspelt_packages(package, file);
    for (LaunchNode& node : file.nodes) {
      for (LaunchDescription& one : node.descriptions) mark(one);
    }
    found_.sources.insert(source);
    found_.launch_files.push_back(std::move(file));
  }

  /// Packages that are neither around the robot nor dependencies, with a name like one that is.
  void note_misspelt_packages(const SurroundingPackage& package, LaunchFile& file) {
    std::set<std::string_view> known;
    for (const auto& [name, place] : package.dependencies) known.insert(name);
    for (const auto& [name, folder] : packages_by_name_) known.insert(name);
    // Two names of this package: SML4401 says that they differ.
    for (const InstallFault& one : package.faults) {
      if (one.kind == InstallFault::Kind::project_name) known.insert(one.what);
    }
    const std::vector<std::string_view> names(known.begin(), known.end());
    std::set<std::string> seen;
    const auto look_at = [&](const std::string& name, Span span) {
      if (name.empty() || known.contains(name) || !seen.insert(name).second) return;
      const auto near = near_name(name, names);
      if (!near || search_of(context_).find(name, file.path, context_.package_folders)) return;
      file.misspelt_packages.push_back({span, name, std::string(*near)});
    };
    const auto look_at_path = [&](const LaunchPath& path) {
      look_at(path.text.package, path.text.package_span);
    };
    for (const LaunchDescription& one : file.descriptions) {
      if (one.file) look_at_path(*one.file);
    }
    for (const LaunchPath& one : file.paths) look_at_path(one);
    for (const LaunchNode& node : file.nodes) {
      if (node.package.is_known && node.package.package.empty())
        look_at(node.package.text, node.package.span);
    }
  }

  /// The worlds that launch files name by literals.
  void read_worlds() {
    for (const LaunchFile& launch : found_.launch_files) {
      for (const LaunchPath& one : launch.paths) {
        const bool is_world = one.path.ends_with(".sdf") || one.path.ends_with(".world");
        if (!is_world || !context_.files.is_file(one.path)) continue;
        FileContent content = context_.files.read(one.path, kMostBytes);
        if (content.status != ReadStatus::ok) continue;
        const SourceId source =
            context_.sources.add(path::normalize(one.path), std::move(content.text));
        DiagnosticSink ignored(context_.limits);
        const auto document = parse_xml(context_.sources, source, context_.limits, ignored);
        const xml::View root = document ? document->view() : xml::View();
        const xml::View world = root ? root.child("world") : xml::View();
        if (!world) continue;
        found_.sources.insert(source);
        LaunchWorld& found = found_.worlds.emplace_back();
        found.place = world.name_span();
        for (const xml::View child : world) {
          const xml::Attribute* file =
              child.name() == "plugin" ? child.attribute("filename") : nullptr;
          if (file != nullptr) found.plugins.insert(std::string(file->value()));
        }
      }
    }
  }

  void add_frame_files() {
    for (const LaunchFile& launch : found_.launch_files) {
      const std::string_view text = context_.sources.text(launch.source);
      for (const std::string_view word :
           {"frame_prefix", "tf_prefix", "PushRosNamespace", "push-ros-namespace",
            "push_ros_namespace", "SetRemap", "RewrittenYaml", "ReplaceString"}) {
        found_.has_frame_prefix =
            found_.has_frame_prefix || text.find(word) != std::string_view::npos;
      }
    }
    for (const SurroundingPackage& package : found_.packages) {
      for (const std::string_view name :
           {"", "config", "params", "param", "rviz", "cartographer", "configuration_files",
            "config/nav2", "config/navigation"}) {
        const std::string folder = path::join(package.folder, std::string(name));
        for (const std::string& file : context_.files.list(folder)) {
          add_frame_file(path::join(folder, file));
        }
      }
    }
    if (found_.frame_files.empty()) return;
    const std::string own(path::parent(model_.urdf_path));
    for (const std::string& name : context_.files.list(own)) {
      const std::string path = path::join(own, name);
      const bool is_other = name != path::file_name(model_.urdf_path) &&
                            (name.ends_with(".xacro") || name.ends_with(".urdf"));
      if (!is_other || found_.other_robots.size() > 40) continue;
      FileContent content = context_.files.read(path, kMostBytes);
      if (content.status == ReadStatus::ok) found_.other_robots.push_back(std::move(content.text));
    }
  }

  void add_frame_file(const std::string& path) {
    constexpr std::size_t kMostFiles = 40;
    const FrameForm* form = find_frame_form(path);
    if (found_.frame_files.size() >= kMostFiles || form == nullptr) return;
    FileContent content = context_.files.read(path, kMostBytes);
    if (content.status != ReadStatus::ok) return;
    const bool is_one = form->is_one(content.text);
    const bool is_parameters = form->form == FrameFile::Form::parameters &&
                               content.text.find("ros__parameters") != std::string::npos;
    if (!is_one && !is_parameters) return;
    FrameFile file;
    file.form = form->form;
    file.path = path::normalize(path);
    file.whose = given_.whose(file.path);
    file.source = context_.sources.add(file.path, std::move(content.text));
    file.text = context_.sources.text(file.source);
    if (form->is_yaml) {
      DiagnosticSink found(context_.limits);
      file.document = parse_yaml(context_.sources, file.source, context_.limits, found);
      if (is_parameters && is_broken_yaml(file.text, file.document, found)) {
        // Companions are read, and reported, elsewhere.
        if (find_companion_kind(file.path, file.text) != nullptr) return;
        for (const Diagnostic& one : found.diagnostics()) {
          if (one.severity == Severity::error) report_broken_yaml(one, context_.sink);
        }
        found_.sources.insert(file.source);
        return;
      }
      if (!file.document) return;
    }
    if (!is_one) return;
    found_.sources.insert(file.source);
    found_.frame_files.push_back(std::move(file));
  }

  /// Sets whether a path exists: in the sources of its package, or as it is installed.
  void look_up(LaunchPath& one, const SurroundingPackage& around, std::string_view launch) {
    if (!one.text.is_known) return;
    std::string rest = one.text.text;
    while (rest.starts_with('/')) rest.erase(0, 1);
    const auto package = packages_by_name_.find(one.text.package);
    if (one.text.package.empty() || package == packages_by_name_.end() || rest.empty()) return;
    if (rest.find("..") != std::string::npos) return;
    one.path = path::normalize(path::join(package->second, rest));
    one.exists = context_.files.is_file(one.path) || !context_.files.list(one.path).empty() ||
                 context_.files.is_file(one.path + ".in") || is_installed(one.text.package, rest);
    // Files that programs write, and those that the launch file tests for.
    const std::string_view first = std::string_view(rest).substr(0, rest.find('/'));
    const bool is_written = is_one_of(first, {"maps", "map", "recordings", "install", "test", "lib",
                                              "tmp", "log", "bags", "data", "cache"});
    const bool is_tested = launch.find("exists(") != std::string_view::npos ||
                           launch.find("isfile(") != std::string_view::npos;
    const bool has_extension = !path::extension(rest).empty();
    one.is_judged = !is_written && !is_tested && has_extension && !around.name.empty() &&
                    is_readable(one.text.package);
    if (!one.exists && one.is_judged) one.similar = similar_to(package->second, rest);
  }

  /// Whether what the package installs is known; a package without build file is as it is.
  bool is_readable(const std::string& package) {
    const auto known = installations_.find(package);
    if (known != installations_.end()) return known->second.is_known;
    const auto folder = packages_by_name_.find(package);
    if (folder == packages_by_name_.end()) return false;
    SurroundingPackage other;
    other.name = package;
    other.folder = folder->second;
    Installation installation;
    for (const std::string_view name : {"CMakeLists.txt", "setup.py"}) {
      const FileContent content =
          context_.files.read(path::join(other.folder, std::string(name)), kMostBytes);
      if (content.status != ReadStatus::ok) continue;
      installation = name == "setup.py" ? read_setup_py(content.text, {}, other, context_.files)
                                        : read_cmake(content.text, {}, other, context_.files);
      break;
    }
    return installations_.emplace(package, std::move(installation)).first->second.is_known;
  }

  bool is_installed(const std::string& package, const std::string& rest) {
    is_readable(package);
    return !installed_source(package, rest).empty();
  }

  /// The file or folder of the sources that is at a path of the share folder; "" if none is.
  std::string installed_source(const std::string& package, const std::string& rest) {
    const auto known = installations_.find(package);
    if (known == installations_.end()) return {};
    for (const std::string& source : known->second.sources_of(rest)) {
      const std::string path = path::join(packages_by_name_[package], source);
      if (context_.files.is_file(path) || !context_.files.list(path).empty()) return path;
    }
    return {};
  }

  std::string similar_to(const std::string& folder, const std::string& rest) const {
    const std::string around = path::join(folder, std::string(path::parent(rest)));
    std::vector<std::string> names = context_.files.list(around);
    const std::vector<std::string_view> known(names.begin(), names.end());
    const std::string_view last = path::file_name(rest);
    // `robot.urdf.xacro` for `robot.urdf`.
    const std::string longer = std::string(last) + ".";
    for (const std::string& name : names) {
      if (name.starts_with(longer)) return name;
    }
    if (const auto near = nearest(last, known)) return std::string(*near);
    const std::string_view stem = last.substr(0, last.find('.'));
    for (const std::string& name : names) {
      if (std::string_view(name).substr(0, name.find('.')) == stem) return name;
    }
    return {};
  }

  /// Folders that the robot or a launch file names, and that are not installed.
  void judge_installation() {
    std::set<std::string> told;
    const auto judge = [&](const std::string& package_name, const std::string& rest,
                           const std::string& by) {
      for (SurroundingPackage& package : found_.packages) {
        if (package.name != package_name || !package.build_file) continue;
        const Installation& known = installations_[package.name];
        const std::size_t slash = rest.find('/');
        if (!known.is_known || !known.installs_folders || slash == std::string::npos) return;
        const std::string folder = rest.substr(0, slash);
        const bool is_here = context_.files.is_file(path::join(package.folder, rest));
        if (!is_here || !installed_source(package_name, rest).empty() ||
            !told.insert(package_name + "/" + folder).second)
          return;
        package.faults.push_back({InstallFault::Kind::not_installed, known.place, folder, by});
      }
    };
    constexpr std::string_view kScheme = "package://";
    for (const MeshReference& mesh : model_.meshes) {
      if (!mesh.filename.starts_with(kScheme) || mesh.filename.ends_with('/')) continue;
      const std::string rest = mesh.filename.substr(kScheme.size());
      const std::size_t slash = rest.find('/');
      if (slash == std::string::npos) continue;
      const std::string package = rest.substr(0, slash), file = rest.substr(slash + 1);
      judge(package, file, "the robot");
      const std::string installed = mesh.exists ? std::string() : installed_source(package, file);
      if (installed.empty()) continue;
      const auto index = static_cast<std::size_t>(&mesh - model_.meshes.data());
      found_.installed_meshes.emplace(index, installed);
    }
    for (const LaunchFile& launch : found_.launch_files) {
      for (const LaunchPath& one : launch.paths) judge_path(one, judge);
      for (const LaunchDescription& one : launch.descriptions) {
        if (one.file) judge_path(*one.file, judge);
      }
    }
    if (found_.launch_files.empty()) return;
    const LaunchFile& first = found_.launch_files.front();
    const std::string folder = found_.packages.front().folder;
    if (first.package == found_.packages.front().name) {
      judge(first.package, path::relative(first.path, folder), "`ros2 launch`");
    }
  }

  template <class Judge>
  void judge_path(const LaunchPath& one, const Judge& judge) const {
    if (!one.text.is_known || one.text.package.empty()) return;
    std::string rest = one.text.text;
    while (rest.starts_with('/')) rest.erase(0, 1);
    judge(one.text.package, rest, "a launch file");
  }

  const LinkedModel& model_;
  const Companions& companions_;
  LoadContext& context_;
  Surroundings found_;
  std::map<std::string, std::string> packages_by_name_;
  std::map<std::string, Installation> installations_;
  std::set<std::string, std::less<>> companion_paths_;
  GivenFiles given_;
};

}  // namespace

void add_surroundings(Accompanied& robot, LoadContext& context) {
  LinkedModel& model = robot.model;
  const bool is_part = model.robot && model.robot->links.empty();
  if (robot.companions.checks_first_only || model.urdf_path.empty() || is_part) return;
  Surroundings found = Loader(robot, context).run();
  for (const auto& [mesh, path] : found.installed_meshes) {
    model.meshes[mesh].exists = true;
    model.meshes[mesh].path = path;
  }
  robot.companions.surroundings = std::move(found);
}

}  // namespace smurf
