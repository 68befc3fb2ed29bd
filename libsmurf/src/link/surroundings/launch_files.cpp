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

void read_launch(const SourceMap& sources, SourceId source, const Limits& limits,
                 const FindLaunchPath& find, LaunchFile& file) {
  file.source = source;
  if (is_python(sources.text(source))) file.form = LaunchFile::Form::python;
  DiagnosticSink faults(limits);
  if (file.form == LaunchFile::Form::python) {
    read_python_launch(sources.text(source), find, file);
  } else if (file.form == LaunchFile::Form::yaml) {
    const auto document = parse_yaml(sources, source, limits, faults);
    if (document) read_yaml_launch(*document, find, file);
    // PyYAML loads some of what is an error of a model, such as a repeated key.
    if (!document) file.fault = first_error(faults);
  } else {
    const auto document = parse_xml(sources, source, limits, faults);
    if (document) read_xml_launch(*document, find, file);
    file.fault = first_error(faults);
  }
}

}  // namespace smurf
