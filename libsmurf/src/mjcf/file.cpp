// SPDX-License-Identifier: BSD-3-Clause
#include "mjcf/file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/text/lists.hpp"
#include "base/text/quoted.hpp"

namespace smurf::mjcf {
namespace {

constexpr std::string_view kActuators[] = {"motor",       "position", "velocity", "intvelocity",
                                           "orientation", "pid",      "damper",   "cylinder",
                                           "muscle",      "adhesion", "dcmotor",  "plugin"};
constexpr std::string_view kEqualities[] = {"connect", "weld", "flex", "flexstrain", "equality"};

template <std::size_t N>
bool is_among(std::string_view text, const std::string_view (&texts)[N]) {
  return std::find(std::begin(texts), std::end(texts), text) != std::end(texts);
}

}  // namespace

std::string_view record_of(std::string_view element) {
  return is_among(element, kActuators)    ? "general"
         : is_among(element, kEqualities) ? "equality"
                                          : element;
}

ModelFile::ModelFile(SourceId root, Reporter& reporter)
    : reporter_(reporter),
      source_(root),
      folder_(path::parent(reporter.context().sources.path(root))) {}

bool ModelFile::parse(SourceId source, View& root) {
  Context& context = reporter_.context();
  auto document = imports::parse_lenient_xml(source, context);
  if (!document) return false;
  documents_.push_back(*std::move(document));
  root = documents_.back().view();
  return static_cast<bool>(root);
}

bool ModelFile::read() {
  files_.emplace(path::normalize(reporter_.context().sources.path(source_)), Span{});
  if (!parse(source_, root_)) return false;
  if (root_.name() == "mujocoinclude") {
    reporter_.refuse(root_.name_span(), "the root of a model is `mujoco`",
                     "name the file that includes this one");
    return false;
  }
  if (root_.name() != "mujoco") {
    reporter_.refuse(root_.name_span(), quoted(root_.name()) + " is not the root of a model",
                     "write `<mujoco>` around it");
    return false;
  }
  // Documents are added while includes are read, so their tree is walked before all else.
  for (std::size_t i = 0; i < documents_.size(); ++i) {
    const xml::Document& document = documents_[i];
    for (std::uint32_t at = 0; at < document.elements.size(); ++at) {
      if (document.elements[at].name() == "include") include(View(document, xml::ElementId{at}));
    }
  }
  check(root_, grammar(), false);
  each(root_, [&](View one) {
    if (one.name() == "compiler") read_compiler(one);
  });
  DefaultClass& main = classes_["main"];
  main.name = "main";
  main.place = root_.name_span();
  each(root_, [&](View one) {
    if (one.name() == "default") read_default(one, nullptr);
  });
  return true;
}

void ModelFile::include(View element) {
  const Attribute* file = element.attribute("file");
  if (file == nullptr) {
    reporter_.refuse(element.name_span(), "`include` needs a `file`", "write the path of the file");
    return;
  }
  Context& context = reporter_.context();
  std::string path = path::join(folder_, file->value());
  if (!context.files.is_file(path)) {
    // MuJoCo also looks beside the file that includes.
    const std::string& here = context.sources.path(element.span().source);
    const std::string beside = path::join(path::parent(here), file->value());
    if (context.files.is_file(beside)) path = beside;
  }
  const auto [known, is_new] = files_.emplace(path, file->value_span());
  if (!is_new) {
    Diagnostic& found =
        reporter_.refuse(file->value_span(), quoted(file->value()) + " is included already",
                         "delete one of the two, or name a copy");
    if (!known->second.empty()) found.label(known->second, "included here before");
    return;
  }
  if (files_.size() > context.limits.xacro_files) {
    reporter_.exceed(file->value_span(),
                     "the model includes more than " + std::to_string(context.limits.xacro_files) +
                         " files",
                     "xacro-files");
    return;
  }
  FileContent content = context.files.read(path, context.limits.file_bytes);
  if (content.status != ReadStatus::ok) {
    reporter_.lack_file();
    reporter_.refuse(file->value_span(), "cannot read " + quoted(path) + ": " + content.reason,
                     "correct the path, which begins at the folder of the main file");
    return;
  }
  const SourceId source = context.sources.add(path, std::move(content.text));
  include_places_.emplace(source, file->value_span());
  View root;
  if (parse(source, root)) {
    included_.emplace(std::pair{&element.document(), element.id()}, root);
  } else {
    reporter_.refuse(file->value_span(), quoted(path) + " is no XML", "correct it");
  }
}

void ModelFile::check_value(const Attribute& attribute, const Value& value) {
  switch (value.kind) {
  case Value::Kind::text: return;
  case Value::Kind::number: numbers_of(attribute, value.least, value.most, reporter_); return;
  case Value::Kind::integer: integers_of(attribute, value.least, value.most, reporter_); return;
  case Value::Kind::word: word_of(attribute, value.words, reporter_); return;
  }
}

void ModelFile::check_attributes(View element, const Grammar& known, bool is_loose) {
  for (const Attribute& one : element.attributes()) {
    if (const Value* value = known.attribute(one.name())) {
      check_value(one, *value);
      continue;
    }
    const bool has_own = known.attributes.empty() && known.name != "worldbody";
    if (one.name().starts_with("xmlns") || has_own) continue;
    const std::string message =
        known.name == "worldbody" ? "the world has no attribute " + quoted(one.name())
                                  : quoted(known.name) + " has no attribute " + quoted(one.name());
    Diagnostic& found =
        is_loose ? reporter_.report(rules::sml9306_ignored_by_mujoco, one.name_span(),
                                    message + ", and MuJoCo ignores it inside of a frame")
                 : reporter_.refuse(one.name_span(), message, "");
    std::vector<std::string_view> names;
    for (const Value& value : known.attributes) names.push_back(value.name);
    const auto near = reporter_.context().sink.suggest(one.name(), names);
    found.help(near ? "did you mean " + quoted(*near) + "?" : "delete it");
  }
}

void ModelFile::check_needs(View element, const Grammar& known) {
  const auto is_written = [&](std::string_view one) { return element.attribute(one) != nullptr; };
  for (const Value& one : known.attributes) {
    if (!one.is_required || is_written(one.name)) continue;
    reporter_.refuse(element.name_span(), quoted(known.name) + " has no " + quoted(one.name),
                     "write `" + std::string(one.name) + "=\"...\"`");
  }
  for (const Need& need : known.needs) {
    bool has_whole = false, has_some = false;
    std::vector<std::string> wanted;
    for (const auto& group : need.groups) {
      has_whole = has_whole || std::all_of(group.begin(), group.end(), is_written);
      has_some = has_some || std::any_of(group.begin(), group.end(), is_written);
      wanted.push_back(enumerated(all_quoted(group)));
    }
    if (has_whole || (need.groups.size() == 1 && !has_some)) continue;
    const std::string names = enumerated(wanted, ", or ");
    reporter_.refuse(element.name_span(), quoted(known.name) + " needs " + names, "write " + names);
  }
}

void ModelFile::check(View element, const Grammar& known, bool is_loose) {
  check_attributes(element, known, is_loose);
  check_needs(element, known);
  // MuJoCo compares nothing with its schema inside of these.
  is_loose = is_loose || known.name == "frame" || known.name == "replicate";
  std::map<std::string_view, Span> once;
  each(element, [&](View child) {
    const Grammar* inner = known.child(child.name());
    if (inner == nullptr) {
      std::vector<std::string_view> names;
      for (const Grammar* one : known.children) names.push_back(one->name);
      Diagnostic& found = reporter_.refuse(
          child.name_span(), quoted(known.name) + " has no element " + quoted(child.name()), "");
      const auto near = reporter_.context().sink.suggest(child.name(), names);
      found.help(near ? "did you mean " + quoted(*near) + "?" : "delete it");
      return;
    }
    if (inner->count == '?') {
      const auto [first, is_new] = once.emplace(child.name(), child.name_span());
      if (!is_new) {
        reporter_
            .refuse(child.name_span(), quoted(known.name) + " has a second " + quoted(child.name()),
                    "delete one of the two")
            .label(first->second, "the first one");
      }
    }
    check(child, *inner, is_loose);
  });
}

void ModelFile::read_compiler(View element) {
  Compiler& c = compiler_;
  const auto flag = [&](std::string_view name, bool& value) {
    if (const Attribute* one = element.attribute(name))
      value = truth_of(*one, reporter_).value_or(value);
  };
  const auto number = [&](std::string_view name, double& value) {
    if (const Attribute* one = element.attribute(name)) {
      const auto numbers = numbers_of(*one, 1, 1, reporter_);
      if (!numbers.empty()) value = numbers.front();
    }
  };
  const auto text = [&](std::string_view name, std::string& value) {
    if (const Attribute* one = element.attribute(name)) value = one->value();
  };
  if (const Attribute* angle = element.attribute("angle")) {
    constexpr std::string_view kWords[] = {"radian", "degree"};
    c.is_degree = word_of(*angle, kWords, reporter_).value_or(1) == 1;
    c.angle_place = angle->value_span();
  }
  if (const Attribute* seq = element.attribute("eulerseq")) {
    const std::string_view value = seq->value();
    if (value.size() != 3 || value.find_first_not_of("xyzXYZ") != std::string_view::npos) {
      reporter_.refuse(seq->value_span(), "`eulerseq` is three of the letters x, y, z, X, Y and Z",
                       "write `xyz`");
    } else {
      c.eulerseq = value;
    }
  }
  if (const Attribute* one = element.attribute("inertiafromgeom")) {
    c.inertiafromgeom = static_cast<InertiaFromGeom>(auto_of(*one, reporter_));
  }
  if (const Attribute* one = element.attribute("inertiagrouprange")) {
    const auto range = numbers_of(*one, 2, 2, reporter_);
    if (range.size() == 2) c.inertiagrouprange = {range[0], range[1]};
  }
  if (const Attribute* one = element.attribute("coordinate")) {
    constexpr std::string_view kWords[] = {"local", "global"};
    if (word_of(*one, kWords, reporter_).value_or(0) == 1) {
      reporter_.refuse(one->value_span(), "global coordinates are gone since 2.3.4",
                       "save the model with MuJoCo 2.3.3, which writes local ones");
    }
  }
  flag("autolimits", c.autolimits);
  flag("balanceinertia", c.balanceinertia);
  flag("fusestatic", c.fusestatic);
  flag("discardvisual", c.discardvisual);
  flag("alignfree", c.alignfree);
  flag("fitaabb", c.fitaabb);
  flag("strippath", c.strippath);
  number("boundmass", c.boundmass);
  number("boundinertia", c.boundinertia);
  number("settotalmass", c.settotalmass);
  text("assetdir", c.meshdir);
  text("assetdir", c.texturedir);
  text("meshdir", c.meshdir);
  text("texturedir", c.texturedir);
}

const DefaultClass* ModelFile::find_class(std::string_view name) const {
  const auto found = classes_.find(name);
  return found != classes_.end() ? &found->second : nullptr;
}

const DefaultClass* ModelFile::named_class(const Attribute& name) const {
  const DefaultClass* found = find_class(name.value());
  if (found == nullptr)
    reporter_.refuse_name(name.value_span(), "there is no class " + quoted(name.value()),
                          "write the name of a class of `<default>`");
  return found;
}

const DefaultClass* ModelFile::class_of(View element, const DefaultClass* other) const {
  if (const Attribute* name = element.attribute("class")) other = named_class(*name);
  return other != nullptr ? other : find_class("main");
}

void ModelFile::report_unused_classes() const {
  std::set<std::string, std::less<>> used{"main"};
  for (const xml::Document& document : documents_) {
    for (std::uint32_t at = 0; at < document.elements.size(); ++at) {
      const View element(document, xml::ElementId{at});
      if (element.name() == "default") continue;
      for (const std::string_view key : {"class", "childclass"}) {
        const Attribute* one = element.attribute(key);
        auto found = one != nullptr ? classes_.find(one->value()) : classes_.end();
        for (; found != classes_.end(); found = classes_.find(found->second.outer)) {
          if (!used.insert(found->first).second) break;
        }
      }
    }
  }
  for (const auto& [name, one] : classes_) {
    if (used.contains(name)) continue;
    reporter_
        .report(rules::sml9307_class_without_use, one.place,
                "nothing uses the class " + quoted(name))
        .help("name it at an element as `class` or `childclass`, or delete it");
  }
}

void ModelFile::read_default(View element, const DefaultClass* outer) {
  const Attribute* name = element.attribute("class");
  DefaultClass* own = nullptr;
  if (outer == nullptr) {
    if (name != nullptr && name->value() != "main") {
      reporter_.refuse(name->value_span(),
                       "the outermost class cannot have the name " + quoted(name->value()),
                       "write `main`, or put the class into another `<default>`");
    }
    own = &classes_["main"];
  } else {
    if (name == nullptr || name->value().empty()) {
      reporter_.refuse(element.name_span(), "a class inside of another needs a name",
                       "write `class=\"...\"`");
      return;
    }
    const auto [place, is_new] = classes_.emplace(name->value(), *outer);
    if (!is_new) {
      reporter_
          .refuse(name->value_span(), "there is a class " + quoted(name->value()) + " already",
                  "rename one of the two")
          .label(place->second.place, "the first one");
      return;
    }
    own = &place->second;
    own->name = name->value();
    own->outer = outer->name;
    own->place = name->value_span();
  }
  each(element, [&](View one) {
    if (one.name() == "default") return;
    auto& list = own->elements[record_of(one.name())];
    for (const Attribute& attribute : one.attributes()) list.push_back(&attribute);
  });
  each(element, [&](View one) {
    if (one.name() == "default") read_default(one, own);
  });
}

Settings::Settings(View element, const DefaultClass* of_class)
    : element_(element), class_(of_class) {
  if (class_ == nullptr) return;
  const auto found = class_->elements.find(record_of(element.name()));
  if (found != class_->elements.end()) layers_ = &found->second;
}

const Attribute* Settings::find(std::string_view name) const {
  if (const Attribute* own = element_.attribute(name)) return own;
  if (layers_ == nullptr) return nullptr;
  const auto last = std::find_if(layers_->rbegin(), layers_->rend(),
                                 [&](const Attribute* one) { return one->name() == name; });
  return last != layers_->rend() ? *last : nullptr;
}

std::string_view Settings::text(std::string_view name) const {
  const Attribute* found = find(name);
  return found != nullptr ? found->value() : std::string_view();
}

std::size_t Settings::numbers(std::string_view name, std::span<double> values, std::size_t least,
                              Reporter& reporter) const {
  std::size_t count = 0;
  const auto take = [&](const Attribute& attribute) {
    const auto numbers = numbers_of(attribute, least, values.size(), reporter);
    std::copy(numbers.begin(), numbers.end(), values.begin());
    count = std::max(count, numbers.size());
  };
  if (layers_ != nullptr) {
    for (const Attribute* one : *layers_) {
      if (one->name() == name) take(*one);
    }
  }
  if (const Attribute* own = element_.attribute(name)) take(*own);
  return count;
}

double Settings::number(std::string_view name, double usual, Reporter& reporter) const {
  const Attribute* found = find(name);
  if (found == nullptr) return usual;
  const auto numbers = numbers_of(*found, 1, 1, reporter);
  return numbers.empty() ? usual : numbers.front();
}

std::int32_t Settings::integer(std::string_view name, std::int32_t usual,
                               Reporter& reporter) const {
  const double value = number(name, usual, reporter);
  return std::fabs(value) <= kLargestInteger ? static_cast<std::int32_t>(value) : usual;
}

Place Settings::place(std::initializer_list<std::string_view> names) const {
  for (const std::string_view name : names) {
    if (const Attribute* found = find(name)) return {found->value_span(), element_.tag_span()};
  }
  return {element_.name_span(), element_.tag_span()};
}

}  // namespace smurf::mjcf
