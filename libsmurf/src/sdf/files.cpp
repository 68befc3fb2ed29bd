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
#include "sdf/checks.hpp"

namespace smurf::sdformat {

namespace {

constexpr int kNewest = 12;

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
    reporter_.lack_file();
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
  auto document = imports::parse_lenient_xml(source, context);
  if (!document) return nullptr;
  documents_.push_back(*std::move(document));
  SdfFile file{documents_.back().view(), path, std::string(path::parent(path))};
  if (!file.root || !read_version(file)) return nullptr;
  check_elements(file.root, file.version, reporter_);
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
  if (!text.empty() && !sdf::leading_number(text)) {
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
        .report(rules::sml9314_ignored_by_sdformat,
                text.empty() ? version->span() : version->value_span(),
                (text.empty() ? "`version` is empty" : "there is no SDF " + std::string(text)) +
                    ", so the file is read as 1.12")
        .help("write a version from 1.4 to 1.12");
  }
  return true;
}

}  // namespace smurf::sdformat
