// SPDX-License-Identifier: BSD-3-Clause
// The files of a model: read once each, merged as smurf_parser does (SMURFParser.cpp:43-69), linked
// by name.
#include <algorithm>
#include <map>
#include <set>
#include <span>
#include <utility>

#include "ast/model_reader.hpp"
#include "ast/sections.hpp"
#include "ast/urdf_reader.hpp"
#include "base/files/path.hpp"
#include "base/findings/cases.hpp"
#include "base/findings/limits.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/numbers/quantity.hpp"
#include "base/text/quoted.hpp"
#include "base/text/suggest.hpp"
#include "base/text/utf8.hpp"
#include "link/file_index.hpp"
#include "link/imported_world.hpp"
#include "link/kinematics.hpp"
#include "link/mujoco_compiler.hpp"
#include "link/parsed_files.hpp"
#include "link/read_file.hpp"
#include "link/resources.hpp"
#include "link/xacro_model.hpp"
#include "mjcf/mjcf.hpp"
#include "sdf/sdf.hpp"
#include "smurf/load.hpp"
#include "smurf/xacro.hpp"
#include "syntax/xml_reader.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

/// MARS reads .yml only, which a rule reports; Phobos reads the others too.
bool is_annotation(std::string_view extension) {
  return extension == ".yml" || extension == ".yaml" || extension == ".json";
}

class ModelLoader {
 public:
  explicit ModelLoader(LoadContext& context) : context_(context) {}

  LinkedModel load(const std::string& path) {
    model_.path = path::normalize(path);
    const std::string extension = path::to_lower(path::extension(path));
    if (extension == ".smurf") {
      model_.has_main = true;
      main_file(path);
    } else if (is_annotation(extension)) {
      annotation_file(path, {}, rules::sml0001_unreadable_file);
      model_.is_complete = false;  // motors and sensors may be named in other files
    } else {
      urdf_file(path, {}, rules::sml0001_unreadable_file);
    }
    link();
    return std::move(model_);
  }

  LinkedModel load(const std::string& path, xacro::Expansion made) {
    model_.path = model_.urdf_path = path;
    model_.language = made.language;
    model_.files.push_back({ModelFile::Kind::urdf, made.root, std::nullopt});
    take_robot(keep(std::move(made)));
    link();
    return std::move(model_);
  }

 private:
  std::optional<yaml::Document> parse(SourceId source, const SourceMap& home) {
    auto document = parse_yaml(home, source, context_.limits, context_.sink);
    if (!document) model_.is_complete = false;
    return document;
  }

  /// Files that an earlier check has parsed.
  ParsedFiles::File* known_file(SourceId source) {
    return context_.parsed != nullptr ? context_.parsed->find(context_.sources, source) : nullptr;
  }
  const SourceMap& home_of(SourceId source) {
    return context_.parsed != nullptr ? context_.parsed->home_of(context_.sources, source)
                                      : context_.sources;
  }

  /// Reports too many entries, including those of this file, and returns false.
  bool has_room(const yaml::Document& document, SourceId source) {
    if (!document.view() || !document.view().is_mapping()) return true;
    annotation_bytes_ += context_.sources.text(source).size();
    const std::uint64_t most = most_entries(context_.limits, annotation_bytes_);
    for (const yaml::View section : document.view()) {
      if (!section.is_sequence()) continue;
      entries_ += section.size();
      if (entries_ <= most) continue;
      context_.sink
          .report(rules::sml0002_file_too_large, section.place(),
                  "with this list, the model has more than " + std::to_string(most) + " entries" +
                      (most < context_.limits.annotation_entries ? ", most of them empty" : ""))
          .help(raise_limit("annotation-entries"));
      model_.is_complete = false;
      return false;
    }
    return true;
  }

  /// Reports a robot with more parts than the limit, and returns false.
  bool has_room(const xml::Document& document) {
    const std::uint64_t most = context_.limits.urdf_parts;
    if (document.elements.size() <= most) return true;  // nearly always
    std::uint64_t parts = 0;
    for (const xml::Element& element : document.elements) {
      const bool is_part = element.parent == document.root || element.name() == "visual" ||
                           element.name() == "collision";
      if (!is_part || ++parts <= most) continue;
      context_.sink
          .report(rules::sml0002_file_too_large, element.name_span(),
                  "the robot has more than " + std::to_string(most) +
                      " links, joints, extensions, visuals and collisions")
          .help(raise_limit("urdf-parts"));
      return false;
    }
    return true;
  }

  void main_file(const std::string& path) {
    const auto source = read_source(path, {}, rules::sml0001_unreadable_file, context_);
    if (!source) {
      model_.is_complete = false;
      return;
    }
    model_.files.push_back({ModelFile::Kind::main, *source, std::nullopt});
    auto document = parse(*source, context_.sources);
    if (!document || !has_room(*document, *source)) return;
    auto main = read_model(*document, context_.sink);
    model_.files.back().document = std::move(document);
    if (!main) {
      model_.is_complete = false;
      return;
    }
    model_.main = std::move(*main);
    append_sections(model_.annotations, model_.main.inline_annotations);
    listed_files(path);
    find_unlisted(path);
  }

  /// Whether `files` also lists this file; then another entry does not mean it.
  bool is_listed(const std::string& path) {
    if (listed_.empty()) {
      const std::string_view folder =
          path::parent(context_.sources.path(model_.files.front().source));
      for (const Spanned<std::string>& entry : *model_.main.files) {
        listed_.insert(path::join(folder, entry.value));
      }
    }
    return listed_.contains(path);
  }

  std::optional<SourceId> read_listed(const std::string& path, Span reference,
                                      const Rule& missing) {
    return read_source(path, reference, missing, context_, [this](const std::string& other) {
      return model_.has_main && is_listed(other);
    });
  }

  /// The content of an annotation file does not depend on its folder, but the meshes of a URDF
  /// do.
  std::string listed_key(const std::string& path) const {
    const bool is_urdf = path::to_lower(path::extension(path)) == ".urdf";
    return is_urdf ? key_of_file(path, context_.files) : context_.files.identity(path);
  }

  void listed_files(const std::string& main_path) {
    const std::string_view folder = path::parent(main_path);
    const NameList none;
    std::map<std::string, Span> read;
    for (const Spanned<std::string>& entry : model_.main.files ? *model_.main.files : none) {
      const std::string path = path::join(folder, entry.value);
      const auto [first, is_new] = read.emplace(listed_key(path), entry.span);
      if (!is_new) {
        Diagnostic& diagnostic =
            context_.sink.report(rules::sml2009_file_listed_twice, entry.span,
                                 "MARS reads " + quoted(entry.value) + " twice");
        diagnostic.label(first->second, "listed here before");
        // Phobos skips the entry after its URDF.
        const bool is_behind = read.size() == 1 && &entry == &(*model_.main.files)[1];
        if (!is_behind && path::to_lower(path::extension(path)) == ".urdf") {
          diagnostic.when(cases::kTheUrdf);
        }
        continue;
      }
      if (entry.value.starts_with('/')) {
        context_.sink.report(rules::sml2004_absolute_path, entry.span,
                             "MARS reads this path as relative to the .smurf's folder");
        // One diagnostic per cause.
        if (!context_.files.is_file(path) && !context_.files.is_denied(path)) {
          model_.is_complete = false;
          continue;
        }
      }
      const std::string extension = path::to_lower(path::extension(entry.value));
      if (extension == ".urdf") {
        urdf_file(path, entry.span, rules::sml2001_missing_file);
      } else if (is_annotation(extension)) {
        annotation_file(path, entry.span, rules::sml2001_missing_file);
      } else if (extension.size() <= 1 || extension.starts_with(".smurf")) {
        model_.is_complete = false;  // rules on unknown names need the names in this file
      }
    }
    // The list does not contain entries that are not texts; they are reported.
    const yaml::View written = model_.files.front().document->view().find("files");
    if (written && written.is_sequence() && model_.main.files &&
        written.size() != model_.main.files->size()) {
      model_.is_complete = false;
    }
  }

  std::span<const std::string> names_starting_with(const std::string& prefix,
                                                   const std::string& folder) {
    const auto [list, is_new] = context_.read->lists.try_emplace(folder);
    std::vector<std::string>& names = list->second;
    if (is_new) names = context_.files.list(folder);
    const auto begin = std::lower_bound(names.begin(), names.end(), prefix);
    const auto end = std::find_if(
        begin, names.end(), [&](const std::string& name) { return !name.starts_with(prefix); });
    return {names.data() + (begin - names.begin()), static_cast<std::size_t>(end - begin)};
  }

  /// "arm_motors.yml" beside "arm.smurf": a name that Phobos gives to a section's file.
  void find_unlisted(const std::string& main_path) {
    if (!model_.main.files) return;
    const std::string folder(path::parent(main_path));
    const std::string prefix = std::string(path::stem(main_path)) + "_";
    for (const std::string& name : names_starting_with(prefix, folder)) {
      if (path::extension(name) != ".yml") continue;
      if (!utf8::is_printable(name)) continue;  // a file name that cannot be written in a list
      const std::string_view section = path::stem(name).substr(prefix.size());
      if (find_section(section) == nullptr) continue;
      if (!is_listed(path::join(folder, name))) model_.unlisted_files.push_back(name);
    }
  }

  void annotation_file(const std::string& path, Span reference, const Rule& missing) {
    const auto source = read_listed(path, reference, missing);
    if (!source) {
      model_.is_complete = false;
      return;
    }
    model_.files.push_back({ModelFile::Kind::annotation, *source, std::nullopt});
    ParsedFiles::File* known = known_file(*source);
    auto document = known ? std::exchange(known->document, {}) : parse(*source, home_of(*source));
    if (!document || !has_room(*document, *source)) return;
    if (!model_.has_main && holds_templates(*document)) return;
    auto annotations = known ? std::optional(std::exchange(known->annotations, {}))
                             : read_annotations(*document, context_.sink);
    model_.files.back().document = std::move(document);
    if (annotations) {
      append_sections(model_.annotations, *annotations);
    } else {
      model_.is_complete = false;
    }
  }

  std::optional<urdf::Robot> parse_robot(SourceId source) {
    auto document = parse_xml(home_of(source), source, context_.limits, context_.sink);
    if (!document || !has_room(*document)) return std::nullopt;
    return read_urdf(std::move(*document), context_.sink);
  }

  /// The language of the file of the robot: by its name, or by its root element; a .urdf of another
  /// language is a mistake.
  Language language_of(std::optional<SourceId> source) const {
    if (xacro::is_xacro_file(model_.urdf_path)) return Language::xacro;
    if (!source || path::to_lower(path::extension(model_.urdf_path)) == ".urdf")
      return Language::urdf;
    const std::string_view text = context_.sources.text(*source);
    return mjcf::is_mjcf(text)      ? Language::mjcf
           : sdformat::is_sdf(text) ? Language::sdf
                                    : Language::urdf;
  }

  std::optional<SourceId> keep(xacro::Expansion expansion) {
    if (!expansion.is_complete) return std::nullopt;
    const SourceId source = expansion.source;
    context_.expansions->emplace(source, std::move(expansion));
    return source;
  }

  /// The annotations that a file of another language has.
  void made_annotations(SourceId source) {
    auto document = parse(source, context_.sources);
    if (!document) return;
    model_.files.push_back({ModelFile::Kind::annotation, source, std::nullopt});
    if (auto read = read_annotations(*document, context_.sink)) {
      append_sections(model_.annotations, *read);
    }
    model_.files.back().document = std::move(document);
  }

  /// The text of the robot, which may have to be made; findings about that have been reported.
  std::optional<SourceId> text_of(SourceId file) {
    if (model_.language == Language::urdf) return file;
    if (model_.language == Language::xacro) return keep(expand_xacro(file, context_));
    imports::Context context{context_.sources, context_.files, context_.sink, context_.limits};
    imports::Imported made = model_.language == Language::sdf ? sdformat::expand(file, context)
                                                              : mjcf::expand(file, context);
    model_.excluded = std::move(made.excluded);
    if (const auto annotations = keep(std::move(made.annotations))) made_annotations(*annotations);
    return keep(std::move(made.robot));
  }

  /// If there are several URDFs, the last one is used, as in MARS; a rule reports them.
  void urdf_file(const std::string& path, Span reference, const Rule& missing) {
    const auto source = read_listed(path, reference, missing);
    model_.urdf_path = path::normalize(path);
    model_.language = language_of(source);
    model_.robot.reset();
    if (source) {
      model_.files.push_back({ModelFile::Kind::urdf, *source, std::nullopt});
      take_robot(text_of(*source));
    } else {
      model_.is_complete = false;
    }
  }

  void take_robot(std::optional<SourceId> text) {
    ParsedFiles::File* known = text ? known_file(*text) : nullptr;
    if (text) model_.robot = known ? std::exchange(known->robot, {}) : parse_robot(*text);
    if (!model_.robot) model_.is_complete = false;
  }

  template <class Items>
  static void name_all(const Items& items, NameTable& table) {
    table.reserve(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (items[i].name) table.add(*items[i].name, static_cast<std::uint32_t>(i));
    }
  }

  /// Motors and sensors in a misspelt section exist, but are not found.
  void find_slips(const std::vector<CustomSection>& sections) {
    constexpr std::string_view kNaming[] = {"motors", "sensors"};
    for (const CustomSection& section : sections) {
      if (nearest(section.name.value, kNaming)) model_.is_complete = false;
    }
  }

  /// Names the materials of visuals. A definition in a visual is for all visuals that come later;
  /// a material without definition is still a name.
  void name_materials_of_visuals(bool are_defined) {
    const std::vector<urdf::Link>& links = model_.robot->links;
    for (std::uint32_t i = 0; i < links.size(); ++i) {
      for (std::uint32_t j = 0; j < links[i].visuals.size(); ++j) {
        const auto& material = links[i].visuals[j].material;
        if (!material || !material->name) continue;
        if (are_defined && !material->rgba && !material->texture) continue;
        const std::size_t index = model_.robot->materials.size() + model_.visual_materials.size();
        const bool is_known =
            model_.material_names.add(*material->name, static_cast<std::uint32_t>(index))
                .has_value();
        if (!is_known) model_.visual_materials.push_back({i, j});
      }
    }
  }

  void link() {
    find_slips(model_.annotations.custom);
    find_slips(model_.main.extra);
    name_all(model_.annotations.motors, model_.motor_names);
    name_all(model_.annotations.sensors, model_.sensor_names);
    resolve_resources(model_, context_);
    check_meshes_of_mujoco(model_, context_);
    if (!model_.robot) return;
    const urdf::Robot& robot = *model_.robot;
    name_all(robot.links, model_.link_names);
    name_all(robot.joints, model_.joint_names);
    name_all(robot.materials, model_.material_names);
    model_.visual_names.reserve(robot.links.size());  // initial size for a typical robot
    model_.collision_names.reserve(robot.links.size());
    for (std::size_t i = 0; i < robot.links.size(); ++i) {
      const auto index = static_cast<std::uint32_t>(i);
      for (const urdf::Visual& visual : robot.links[i].visuals) {
        if (visual.name) model_.visual_names.add(*visual.name, index);
      }
      for (const urdf::Collision& collision : robot.links[i].collisions) {
        if (collision.name) model_.collision_names.add(*collision.name, index);
      }
    }
    name_materials_of_visuals(true);
    name_materials_of_visuals(false);
    model_.tree = build_tree(model_);
    check_followers();
  }

  void check_followers() {
    for (const urdf::Joint& joint : model_.robot->joints) {
      if (!joint.mimic || is_followable(model_, joint)) continue;
      const Field<double>& multiplier = joint.mimic->multiplier;
      context_.sink.report(
          rules::sml1810_overflow_underflow,
          multiplier.written ? multiplier.span : joint.mimic->joint.span,
          "the product of the multipliers of the joints that this one follows exceeds " +
              format_rounded(kLargestQuantity));
    }
  }

  LoadContext& context_;
  LinkedModel model_;
  std::set<std::string> listed_;  ///< paths in `files`, when one of them does not exist
  std::uint64_t entries_ = 0;     ///< in the `files` lists of all annotation files
  std::uint64_t annotation_bytes_ = 0;
};

}  // namespace

LinkedModel load_model(const std::string& path, LoadContext& context) {
  LinkedModel model = ModelLoader(context).load(path);
  model.schemas = context.schemas;
  return model;
}

LinkedModel load_made_model(const std::string& path, xacro::Expansion made, LoadContext& context) {
  LinkedModel model = ModelLoader(context).load(path, std::move(made));
  model.schemas = context.schemas;
  return model;
}

std::optional<xml::Document> load_xml(const std::string& path, LoadContext& context) {
  const auto source = read_source(path, {}, rules::sml0001_unreadable_file, context);
  if (!source) return std::nullopt;
  return parse_xml(context.sources, *source, context.limits, context.sink);
}

}  // namespace smurf
