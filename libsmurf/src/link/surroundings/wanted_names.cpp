// SPDX-License-Identifier: BSD-3-Clause
#include "link/surroundings/wanted_names.hpp"

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "link/surroundings/frame_names.hpp"
#include "link/surroundings/launch_files.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

constexpr std::string_view kMark = "smurf_wanted_name";

bool is_in_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
}

void read_frame_file(const std::string& path, const std::string& text, const FrameForm& form,
                     const Limits& limits, const TakeFrame& take) {
  SourceMap sources;
  FrameFile file;
  file.form = form.form;
  file.source = sources.add(path, text);
  file.text = sources.text(file.source);
  if (form.is_yaml) {
    DiagnosticSink ignored(limits);
    file.document = parse_yaml(sources, file.source, limits, ignored);
  }
  for_each_frame(file, take);
}

LaunchFile read_launch_file(const std::string& path, const std::string& text, LaunchFile::Form form,
                            const Limits& limits, SourceMap& sources) {
  LaunchLibrary library;
  const SourceId source = sources.add(path, text);
  LaunchFile file = library.read(path, text, form, false, source, limits, [](LaunchPath&) {});
  file.text = sources.text(source);
  return file;
}

/// Notes what kinds of names the marked word is.
TakeFrame find_mark(WantedName& wanted) {
  return [&wanted](const FrameName& one) {
    if (one.name.find(kMark) != std::string_view::npos) wanted.kinds = one.kinds;
  };
}

/// Whether an argument of a xacro is wanted.
bool read_launch(const std::string& path, const std::string& text, LaunchFile::Form form,
                 const Limits& limits, WantedName& wanted) {
  SourceMap sources;
  const LaunchFile file = read_launch_file(path, text, form, limits, sources);
  for_each_frame(file, find_mark(wanted));
  for (const LaunchDescription& description : file.descriptions) {
    if (!description.file) continue;
    for (const LaunchDescription::Argument& one : description.arguments) {
      if (one.name != kMark) continue;
      wanted.package = description.file->text.package;
      wanted.file = description.file->text.text;
      return true;
    }
  }
  return false;
}

/// The place of a text within a longer one, or that one.
Span narrowed(Span whole, std::string_view text, std::string_view part) {
  if (whole.empty() || whole.end > text.size() || part.empty()) return whole;
  const std::size_t at = text.substr(whole.begin, whole.end - whole.begin).find(part);
  if (at == std::string_view::npos) return whole;
  const auto begin = whole.begin + static_cast<std::uint32_t>(at);
  return {whole.source, begin, begin + static_cast<std::uint32_t>(part.size())};
}

}  // namespace

bool is_surrounding_file(std::string_view path, std::string_view text) {
  if (launch_form_of(path::file_name(path))) return true;
  const FrameForm* form = find_frame_form(path);
  return form != nullptr && form->is_one(text);
}

std::vector<std::string> frames_in(const std::string& path, std::string_view text,
                                   const Limits& limits) {
  std::set<std::string> names;
  const TakeFrame take = [&](const FrameName& one) {
    const std::string_view name = one.name.substr(one.name.starts_with('/') ? 1 : 0);
    if (!name.empty()) names.emplace(name);
  };
  if (const auto launch = launch_form_of(path::file_name(path))) {
    SourceMap sources;
    for_each_frame(read_launch_file(path, std::string(text), *launch, limits, sources), take);
  } else if (const FrameForm* form = find_frame_form(path)) {
    read_frame_file(path, std::string(text), *form, limits, take);
  }
  return {names.begin(), names.end()};
}

std::optional<WantedName> wanted_name(const std::string& path, std::string_view text,
                                      std::size_t offset, const Limits& limits) {
  WantedName wanted{.begin = offset, .end = offset};
  while (wanted.begin > 0 && is_in_word(text[wanted.begin - 1])) --wanted.begin;
  while (wanted.end < text.size() && is_in_word(text[wanted.end])) ++wanted.end;
  const std::string_view rest = text.substr(wanted.end);
  const auto with = [&](std::string_view word) {
    return std::string(text.substr(0, wanted.begin)).append(word).append(rest);
  };
  const std::string marked = with(kMark);
  const auto launch = launch_form_of(path::file_name(path));
  if (launch) {
    const bool is_set = rest.starts_with(":=");
    if (read_launch(path, marked, *launch, limits, wanted) && is_set) return wanted;
    if (!wanted.kinds.empty()) return wanted;
    if (is_set) return std::nullopt;
    const std::string argument = with(std::string(kMark) + ":=");
    if (read_launch(path, argument, *launch, limits, wanted)) return wanted;
    return std::nullopt;
  }
  const FrameForm* form = find_frame_form(path);
  if (form == nullptr) return std::nullopt;
  wanted.is_yaml = form->is_yaml;
  read_frame_file(path, marked, *form, limits, find_mark(wanted));
  return wanted.kinds.empty() ? std::nullopt : std::optional(std::move(wanted));
}

std::vector<LaunchLink> launch_links(const LaunchFile& launch, const Surroundings& around) {
  std::vector<LaunchLink> links;
  const auto add = [&](const LaunchPath& one) {
    if (one.exists && !one.path.empty())
      links.push_back({narrowed(one.text.span, launch.text, one.text.text), one.path});
    const auto package =
        std::find_if(around.packages.begin(), around.packages.end(),
                     [&](const auto& known) { return known.name == one.text.package; });
    if (package == around.packages.end() || one.text.package_span.empty()) return;
    links.push_back({narrowed(one.text.package_span, launch.text, one.text.package),
                     path::join(package->folder, "package.xml")});
  };
  for (const LaunchPath& one : launch.paths) add(one);
  for (const LaunchDescription& one : launch.descriptions) {
    if (one.file) add(*one.file);
  }
  return links;
}

std::vector<LaunchArgument> launch_arguments(const LaunchFile& launch) {
  std::vector<LaunchArgument> all;
  for (const LaunchDescription& description : launch.descriptions) {
    if (!description.is_of_robot) continue;
    for (const LaunchDescription::Argument& one : description.arguments) {
      Span span = narrowed(one.span, launch.text, one.name + ":=");
      if (span != one.span) {
        span.end -= 2;
      } else {
        span = narrowed(one.span, launch.text, one.name);
      }
      all.push_back({span, one.name});
    }
  }
  return all;
}

}  // namespace smurf
