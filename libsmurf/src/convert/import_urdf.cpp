// SPDX-License-Identifier: BSD-3-Clause
// The URDF is kept, and annotations are added beside it. Entries of sections repeat parts
// of the URDF; text sections repeat the rest, so that readers of the annotations miss
// nothing.
#include <algorithm>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "base/findings/rules.hpp"
#include "base/text/edits.hpp"
#include "base/text/words.hpp"
#include "convert/import.hpp"
#include "convert/rebase.hpp"

namespace smurf {
namespace import {

std::string Context::line_of(Span span) const {
  return std::string(path::file_name(sources.path(span.source))) + ":" +
         std::to_string(sources.line_of(span.source, span.begin));
}

void Context::keep_as_text(Span span, const std::string& what, const std::string& why) {
  Diagnostic& diagnostic = sink.report(rules::sml8101_kept_as_text, span,
                                       what + " cannot become an entry of a section: " + why);
  diagnostic.note("its text is kept in the section of extensions");
}

std::string_view text_of(xml::View element) {
  return element ? trimmed(element.text()) : std::string_view();
}

std::string_view child_text(xml::View element, std::string_view child) {
  return element ? text_of(element.child(child)) : std::string_view();
}

std::vector<xml::View> extensions_of(const Context& context, std::string_view name) {
  std::vector<xml::View> found;
  for (const xml::ElementId id : context.robot().extensions) {
    const xml::View element(context.robot().document, id);
    if (element.name() == name) found.push_back(element);
  }
  return found;
}

}  // namespace import

namespace {

struct Folders {
  std::string main;  ///< of the .smurf, from the folder of the output
  std::string urdf;  ///< of the written URDF
};

Folders folders_of(SmurfLayout layout) {
  return layout == SmurfLayout::phobos ? Folders{"smurf", "urdf"} : Folders{".", "."};
}

/// Whether the robot was made from a file of another language: its text is in no file.
bool is_expanded(const LinkedModel& model) {
  return std::none_of(model.files.begin(), model.files.end(), [&](const ModelFile& one) {
    return one.source == model.robot->document.source;
  });
}

std::string_view name_of(const NewValue& entry) {
  for (const NewValue& one : entry.children) {
    if (one.key == "name") return one.text;
  }
  return {};
}

/// Some sensors of a robot are in its URDF, and others were made with it. Settings of one joint are
/// one entry.
void add_section(NewFile made, std::vector<NewFile>& files) {
  for (NewFile& file : files) {
    if (file.suffix != made.suffix) continue;
    std::vector<NewValue>& known = file.section.children;
    for (NewValue& entry : made.section.children) {
      const auto same = std::find_if(known.begin(), known.end(), [&](const NewValue& one) {
        return made.suffix == "joint" && name_of(one) == name_of(entry);
      });
      if (same == known.end()) {
        known.push_back(std::move(entry));
        continue;
      }
      for (NewValue& member : entry.children) {
        if (member.key != "name") same->children.push_back(std::move(member));
      }
    }
    return;
  }
  files.push_back(std::move(made));
}

/// An SRDF of the pairs of links that the file of another language keeps apart.
std::string excluded_pairs(const LinkedModel& model) {
  std::string text = "<?xml version=\"1.0\"?>\n<robot name=\"" +
                     escape_xml(model.robot->name.value_or("robot")) + "\">\n";
  std::set<std::pair<std::string, std::string>> known;
  for (const auto& [link, other] : model.excluded) {
    if (!model.link_names.contains(link) || !model.link_names.contains(other)) continue;
    if (!known.insert(std::minmax(link, other)).second) continue;
    text += "  <disable_collisions link1=\"" + escape_xml(link) + "\" link2=\"" +
            escape_xml(other) + "\" reason=\"User\"/>\n";
  }
  return text + "</robot>\n";
}

}  // namespace

std::string import::texture_path(const UrdfImport& options, std::string_view path) {
  const std::string folder =
      path::join(places::absolute_from(options.current_folder, options.output_folder),
                 folders_of(options.layout).main);
  const auto copy = options.copies.find(std::string(path));
  const bool is_copied = copy != options.copies.end();
  return path::relative(
      is_copied ? copy->second : places::absolute_from(options.current_folder, std::string(path)),
      folder);
}

NewModel import_urdf(const LinkedModel& model, const SourceMap& sources, const UrdfImport& options,
                     DiagnosticSink& sink) {
  import::Context context{model, sources, options, sink};
  NewModel result;
  for (const auto part : {import::motors, import::sensors, import::materials, import::joints,
                          import::poses, import::urdf_extensions, import::srdf_extensions}) {
    if (import::Part file = part(context)) result.files.push_back(std::move(*file));
  }
  if (is_expanded(model) && !model.has_main) {
    for (NewFile& file : import::made_sections(model)) add_section(std::move(file), result.files);
  }
  const Folders folders = folders_of(options.layout);
  const auto absolute = [&](std::string_view path) {
    return path::join(places::absolute_from(options.current_folder, options.output_folder), path);
  };
  result.modelname = model.robot->name.value_or(options.name);
  result.main_path = path::join(folders.main, options.name + ".smurf");
  result.source = path::file_name(model.urdf_path);
  if (options.layout == SmurfLayout::in_place && !is_expanded(model)) {
    const std::string urdf = places::absolute_from(options.current_folder, model.urdf_path);
    result.urdf_entry = path::relative(urdf, absolute(folders.main));
    return result;
  }
  result.urdf_path = path::join(folders.urdf, options.name + ".urdf");
  result.urdf_entry = path::relative(absolute(result.urdf_path), absolute(folders.main));
  if (!model.excluded.empty()) result.srdf = excluded_pairs(model);
  std::vector<Edit> edits =
      rebase_paths(model, absolute(folders.urdf), options.current_folder, options.copies);
  edits.insert(edits.end(), context.edits.begin(), context.edits.end());
  result.urdf = apply_edits(sources.text(model.robot->document.source), edits);
  return result;
}

}  // namespace smurf
