// SPDX-License-Identifier: BSD-3-Clause
#include "sdf/files.hpp"

#include <algorithm>
#include <utility>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "imports/imports.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf::sdformat {

namespace {

constexpr int kNewest = 12;

/// libsdformat reads prefixes that nothing declares, so they are no mistake here.
std::optional<xml::Document> parse_sdf(SourceId source, Context& context) {
  DiagnosticSink found(context.limits);
  auto document = parse_xml(context.sources, source, context.limits, found);
  for (Diagnostic& one : found.take()) {
    if (one.rule == &rules::sml1002_xml_undeclared_prefix) continue;
    // TinyXML-2, which libsdformat has, reads them; `xmllint` and others do not.
    if (one.rule == &rules::sml1004_xml_comment_dashes) one.severity = Severity::warning;
    context.sink.report(*one.rule, one.span, {}) = std::move(one);
  }
  return document;
}

/// Source: libsdformat 12 and 14, parser.cc readFileInternal and parser_urdf.cc IsURDF; 12 was run.
bool is_urdf(std::string_view text) { return imports::root_name(text) == "robot"; }

}  // namespace

Files::Files(SourceId root, Reporter& reporter)
    : reporter_(reporter),
      source_(root),
      folder_(path::parent(reporter.context().sources.path(root))) {}

const SdfFile* Files::main() {
  return parse(source_, path::normalize(reporter_.context().sources.path(source_)));
}

const SdfFile* Files::open(const std::string& path, Span place) {
  const auto known = files_.find(path);
  if (known != files_.end()) return &known->second;
  if (broken_.contains(path)) return nullptr;
  Context& context = reporter_.context();
  if (files_.size() >= context.limits.xacro_files) {
    reporter_.exceed(place,
                     "the model includes more than " + std::to_string(context.limits.xacro_files) +
                         " files",
                     "xacro-files");
    return nullptr;
  }
  FileContent content = context.files.read(path, context.limits.file_bytes);
  const SdfFile* file = nullptr;
  if (content.status == ReadStatus::ok && is_urdf(content.text)) {
    // libsdformat converts it; it is checked as the URDF that it is.
    reporter_
        .report(rules::sml9304_lost_in_urdf, place,
                "the model is the URDF " + quoted(path) + ", which is not read here, so it is lost")
        .help("convert the URDF by itself");
    broken_.emplace(path, true);
    return nullptr;
  }
  if (content.status != ReadStatus::ok) {
    reporter_.miss(place, "cannot read " + quoted(path) + ": " + content.reason,
                   "correct the address");
  } else {
    file = parse(context.sources.add(path, std::move(content.text)), path);
  }
  if (file == nullptr) broken_.emplace(path, true);
  return file;
}

const SdfFile* Files::parse(SourceId source, const std::string& path) {
  Context& context = reporter_.context();
  auto document = parse_sdf(source, context);
  if (!document) return nullptr;
  documents_.push_back(*std::move(document));
  SdfFile file{documents_.back().view(), path, std::string(path::parent(path))};
  if (!file.root || !read_version(file)) return nullptr;
  check(file.root, grammar(), file.version);
  return &files_.emplace(path, std::move(file)).first->second;
}

bool Files::read_version(SdfFile& file) {
  const View root = file.root;
  if (root.name() != "sdf" && root.name() != "gazebo") {
    reporter_.refuse(root.name_span(), quoted(root.name()) + " is not the root of an SDF file",
                     "write `<sdf version=\"1.9\">` around it");
    return false;
  }
  const Attribute* version = root.attribute("version");
  if (version == nullptr) {
    reporter_.refuse(root.name_span(), "`sdf` needs a `version`",
                     "write the version whose elements the file has, such as `version=\"1.9\"`");
    return false;
  }
  const std::string_view text = version->value();
  if (!text.empty() && !leading_number(text)) {
    reporter_.refuse(version->value_span(), quoted(text) + " is not a version of SDF",
                     "write a version from 1.4 to 1.12");
    return false;
  }
  const auto minor =
      text.starts_with("1.") ? parse_integer(text.substr(2, text.find('.', 2) - 2)) : std::nullopt;
  if (minor && *minor >= 0 && *minor <= kNewest) {
    file.version = static_cast<int>(*minor);
  } else {
    reporter_
        .report(rules::sml9314_ignored_by_sdformat, version->value_span(),
                "there is no SDF " + std::string(text) + ", so the file is read as 1.12")
        .help("write a version from 1.4 to 1.12");
  }
  return true;
}

void Files::check_value(View element, const Grammar& known) {
  const std::string_view text = text_of(element);
  // An empty element is as good as none, unless there must be one.
  if (text.empty() && known.count != '!' && known.count != '+') return;
  const Span place = text.empty() ? element.name_span() : element.text_span();
  const auto wrong = [&](const std::string& what, std::string help) {
    reporter_.refuse(place,
                     text.empty()
                         ? quoted(element.name()) + " is empty, not " + what
                         : quoted(text) + " in " + quoted(element.name()) + " is not " + what,
                     std::move(help));
  };
  const auto numbers = [&](std::size_t count) {
    if (leading_numbers(text, count).size() < count)
      wrong(std::to_string(count) + " numbers",
            "write " + std::to_string(count) + " numbers, with blanks between them");
  };
  switch (known.kind) {
  case ValueKind::boolean:
    if (!truth_in(text)) wrong("a truth value", "write `true` or `false`");
    break;
  case ValueKind::integer:
  case ValueKind::number:
    if (!leading_number(text)) {
      wrong("a number", "write a number such as `0.5`");
    } else if (text.find(',') != std::string_view::npos) {
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, place,
                  "libsdformat reads " + quoted(text) + " as " +
                      format_rounded(*leading_number(text)))
          .help("write a point instead of the comma");
    }
    break;
  case ValueKind::numbers2: numbers(2); break;
  case ValueKind::numbers3: numbers(3); break;
  case ValueKind::color:
    if (!colour_in(text)) wrong("a colour", "write red, green, blue and alpha, such as `1 0 0 1`");
    break;
  case ValueKind::text:
    if (text.empty()) wrong("a text", "write one");
    break;
  case ValueKind::pose:
    if (!pose_in(element)) {
      const bool is_quaternion = attribute_of(element, "rotation_format") == "quat_xyzw";
      wrong("a pose", is_quaternion ? "write x y z and the quaternion x y z w, without `degrees`"
                                    : "write six numbers: x y z roll pitch yaw");
    } else if (text.find(',') != std::string_view::npos) {
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, place,
                  "libsdformat reads the numbers of a pose up to a comma")
          .help("write points instead of commas");
    }
    break;
  default: break;
  }
}

void Files::check_attributes(View element, const Grammar& known, int version) {
  for (const AttributeRow& row : known.attributes) {
    const Attribute* one = element.attribute(row.name);
    if (one == nullptr || one->value().empty()) {
      if (!row.is_required) continue;
      const Span place = one != nullptr ? one->span() : element.name_span();
      reporter_.refuse(place, quoted(element.name()) + " needs " + quoted(row.name), "write it");
    } else if (row.kind == ValueKind::boolean && !truth_in(one->value())) {
      reporter_.refuse(one->value_span(),
                       quoted(one->value()) + " in " + quoted(row.name) + " is not a truth value",
                       "write `true` or `false`");
    } else if (row.name == "name" && version >= 8 && known.name != "plugin" &&
               one->value().find("::") != std::string_view::npos) {
      reporter_.refuse(one->value_span(), "since SDF 1.8, a name has no `::`",
                       "nest the element in a model, or write `_`");
    }
  }
  for (const Attribute& one : element.attributes()) {
    if (known.attribute(one.name()) != nullptr || one.name().find(':') != std::string_view::npos ||
        one.name().starts_with("xmlns"))
      continue;
    if (one.name() == "frame" && known.name == "pose") {
      if (version <= 6 || one.value().empty()) continue;
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, one.span(),
                  "since SDF 1.7, `frame` of a pose is `relative_to`, and `frame` has no effect")
          .help("write `relative_to`");
      continue;
    }
    if (element.name() == "include" || element.name() == "model" || element.name() == "sdf")
      continue;  // `merge`, and attributes that only other tools read
    std::vector<std::string_view> names;
    for (const AttributeRow& row : known.attributes) names.push_back(row.name);
    const auto near = reporter_.context().sink.suggest(one.name(), names);
    if (!near) continue;  // attributes of other tools are allowed everywhere
    reporter_
        .report(rules::sml9314_ignored_by_sdformat, one.name_span(),
                "libsdformat ignores " + quoted(one.name()) + " of " + quoted(element.name()))
        .help("did you mean " + quoted(*near) + "?");
  }
}

void Files::check(View element, const Grammar& known, int version) {
  check_attributes(element, known, version);
  if (known.kind == ValueKind::any) return;
  check_value(element, known);
  if (known.name == "joint" && known.kind == ValueKind::none && known.attribute("type")) {
    for (const std::string_view needed : {"parent", "child"}) {
      if (element.child(needed)) continue;
      reporter_.refuse(element.name_span(), "`joint` needs `<" + std::string(needed) + ">`",
                       "name the link or the frame there");
    }
  }
  if (known.name == "light" && known.attribute("type") != nullptr) {
    const Attribute* type = element.attribute("type");
    if (type != nullptr && !is_one_of(type->value(), {"point", "directional", "spot", ""})) {
      reporter_.refuse(type->value_span(), quoted(type->value()) + " is no type of a light",
                       "write `point`, `directional` or `spot`");
    }
  }
  if (known.name == "script" && element.parent().name() == "material") {
    for (const std::string_view needed : {"uri", "name"}) {
      if (!text_in(element, needed).empty()) continue;
      reporter_.refuse(element.name_span(), "`script` needs `<" + std::string(needed) + ">`",
                       "write it");
    }
  }
  std::map<std::string_view, Span> once;
  for (const View child : element) {
    if (child.name().find(':') != std::string_view::npos) continue;  // for another program
    const Grammar* inner = known.child(child.name());
    if (inner == nullptr) {
      std::vector<std::string_view> names;
      for (const Grammar* one : known.children) names.push_back(one->name);
      const auto near = reporter_.context().sink.suggest(child.name(), names);
      if (!near) continue;  // elements of plugins and of other versions are allowed everywhere
      reporter_
          .report(rules::sml9314_ignored_by_sdformat, child.name_span(),
                  "libsdformat ignores " + quoted(child.name()) + " in " + quoted(element.name()))
          .help("did you mean " + quoted(*near) + "?");
      continue;
    }
    // Of others, such as sensors, there may be several, whatever their descriptions say.
    constexpr std::string_view kSingle[] = {
        "pose",     "inertial", "mass",     "inertia",  "geometry", "parent", "child",
        "axis",     "axis2",    "xyz",      "limit",    "lower",    "upper",  "effort",
        "velocity", "dynamics", "damping",  "friction", "radius",   "length", "size",
        "scale",    "static",   "material", "diffuse"};
    if (std::find(std::begin(kSingle), std::end(kSingle), child.name()) != std::end(kSingle)) {
      const auto [first, is_new] = once.emplace(child.name(), child.name_span());
      if (!is_new) {
        reporter_
            .report(rules::sml9314_ignored_by_sdformat, child.name_span(),
                    "libsdformat reads the first " + quoted(child.name()) + " only")
            .help("delete one of the two")
            .label(first->second, "the first one");
      }
    }
    check(child, *inner, version);
  }
}

}  // namespace smurf::sdformat
