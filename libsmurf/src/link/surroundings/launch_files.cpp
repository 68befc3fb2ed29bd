// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/launch_files.hpp"

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/diagnostic.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

std::optional<LaunchFault> first_error(const DiagnosticSink& found) {
  for (const Diagnostic& one : found.diagnostics()) {
    if (one.severity == Severity::error) return LaunchFault{one.span, one.message, one.help_text};
  }
  return std::nullopt;
}

/// `ros2 launch` reads what is no XML and no YAML as Python, whatever its name.
/// Source: launch any_launch_file_utilities.py, branches humble to rolling.
bool is_python(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && text[first] != '<' &&
         text.find("def generate_launch_description(") != std::string_view::npos;
}

/// Gives the places in a file to another source, and looks up its paths.
struct Moved {
  SourceId source;
  const FindLaunchPath& find;

  void move(Span& span) const { span.source = source; }
  void move(LaunchText& text) const {
    move(text.span);
    move(text.package_span);
  }
  void move(LaunchPath& path) const {
    move(path.text);
    find(path);
  }
  void move(LaunchDescription& one) const {
    move(one.span);
    move(one.program);
    if (one.file) move(*one.file);
    for (LaunchDescription::Argument& argument : one.arguments) {
      move(argument.value);
      move(argument.span);
    }
  }
  void move(LaunchNode& node) const {
    move(node.span);
    for (LaunchText* one : {&node.package, &node.executable, &node.name, &node.name_space})
      move(*one);
    for (LaunchText& one : node.arguments) move(one);
    for (auto& [name, value] : node.parameters) {
      move(name);
      move(value);
    }
    for (LaunchDescription& one : node.descriptions) move(one);
  }
  void move(LaunchFile& file) const {
    file.source = source;
    if (file.fault) move(file.fault->span);
    for (LaunchMistake& one : file.mistakes) move(one.span);
    for (LaunchNode& one : file.nodes) move(one);
    for (LaunchPath& one : file.paths) move(one);
    for (LaunchDescription& one : file.descriptions) move(one);
    for (LaunchText& one : file.moveit_configs) move(one);
  }
};

LaunchFile read_launch(const std::string& path, const std::string& text, LaunchFile::Form form,
                       bool is_ros1, const Limits& limits) {
  SourceMap sources;
  DiagnosticSink faults(limits);
  LaunchFile file;
  file.path = path;
  file.source = sources.add(path, text);
  file.is_ros1 = is_ros1;
  file.form = is_python(text) ? LaunchFile::Form::python : form;
  const FindLaunchPath nothing = [](LaunchPath&) {};
  if (file.form == LaunchFile::Form::python) {
    read_python_launch(sources.text(file.source), nothing, file);
  } else if (file.form == LaunchFile::Form::yaml) {
    const auto document = parse_yaml(sources, file.source, limits, faults);
    if (document) read_yaml_launch(*document, nothing, file);
    // PyYAML loads some of what is an error of a model, such as a repeated key.
    if (!document) file.fault = first_error(faults);
  } else {
    const auto document = parse_xml(sources, file.source, limits, faults);
    if (document) read_xml_launch(*document, nothing, file);
    file.fault = first_error(faults);
  }
  return file;
}

}  // namespace

std::optional<LaunchFile::Form> launch_form_of(std::string_view name) {
  std::string_view stem = name;
  stem.remove_suffix(path::extension(name).size());
  if (name.ends_with(".launch")) return LaunchFile::Form::xml;
  if (!stem.ends_with(".launch") && !stem.ends_with("_launch")) return std::nullopt;
  const std::string_view extension = name.substr(stem.size());
  if (extension == ".py") return LaunchFile::Form::python;
  if (extension == ".xml") return LaunchFile::Form::xml;
  if (is_one_of(extension, {".yaml", ".yml"})) return LaunchFile::Form::yaml;
  return std::nullopt;
}

std::vector<FoundLaunch> launch_files_of(const std::string& package,
                                         std::initializer_list<std::string_view> folders,
                                         const FileReader& files) {
  std::vector<std::string> places;
  for (const std::string_view name : folders) {
    places.push_back(name.empty() ? package : path::join(package, name));
    if (name != "launch") continue;
    const std::string launch = places.back();
    for (const std::string& inner : files.list(launch)) {
      const std::string place = path::join(launch, inner);
      if (!inner.starts_with('.') && !files.is_file(place)) places.push_back(place);
    }
  }
  std::vector<FoundLaunch> found;
  for (const std::string& folder : places) {
    for (const std::string& name : files.list(folder)) {
      if (const auto form = launch_form_of(name))
        found.push_back({path::join(folder, name), *form});
    }
  }
  return found;
}

LaunchFile LaunchLibrary::read(const std::string& path, const std::string& text,
                               LaunchFile::Form form, bool is_ros1, SourceId source,
                               const Limits& limits, const FindLaunchPath& find) {
  const LaunchFile* known = nullptr;
  const std::pair key(path, is_ros1);
  {
    const std::lock_guard lock(mutex_);
    const auto found = files_.find(key);
    if (found != files_.end()) known = found->second.get();
  }
  if (known == nullptr) {
    auto file = std::make_unique<const LaunchFile>(read_launch(path, text, form, is_ros1, limits));
    const std::lock_guard lock(mutex_);
    known = files_.emplace(key, std::move(file)).first->second.get();
  }
  LaunchFile file = *known;
  Moved{source, find}.move(file);
  return file;
}

}  // namespace smurf
