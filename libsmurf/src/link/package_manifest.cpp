// SPDX-License-Identifier: BSD-3-Clause
// Source: REP 149.
#include "link/package_manifest.hpp"

#include <utility>

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytesOfManifest = 1U << 20U;

}  // namespace

PackageManifest read_manifest(const xml::Document& document) {
  PackageManifest manifest;
  const xml::View root = document.view();
  if (!root || root.name() != "package") return manifest;
  manifest.root_span = root.name_span();
  bool has_type = false, needs_ament = false;
  for (const xml::View child : root) {
    std::string content(trimmed(child.text()));
    if (child.name() == "name" && manifest.name.empty()) {
      manifest.name = std::move(content);
      manifest.name_span = child.text_span();
    } else if (child.name().ends_with("depend")) {
      needs_ament = needs_ament || content.starts_with("ament");
      manifest.dependencies.try_emplace(std::move(content), child.text_span());
    } else if (child.name() == "export") {
      manifest.export_span = child.name_span();
      for (const xml::View one : child) {
        if (one.name() == "gazebo_ros") manifest.has_model_path = true;
        if (one.name() != "build_type") continue;
        has_type = true;
        manifest.is_ament = manifest.is_ament || trimmed(one.text()).starts_with("ament");
      }
    }
  }
  manifest.is_ament = manifest.is_ament || (!has_type && needs_ament);
  return manifest;
}

PackageManifest read_manifest(std::string_view text) {
  if (text.empty()) return {};
  SourceMap sources;
  DiagnosticSink ignored;
  const SourceId source = sources.add(std::string(kPackageFile), std::string(text));
  const auto document = parse_xml(sources, source, Limits{}, ignored);
  return document ? read_manifest(*document) : PackageManifest{};
}

PackageManifest manifest_in(const std::string& folder, const FileReader& files) {
  const FileContent content =
      files.read(path::join(folder, std::string(kPackageFile)), kMostBytesOfManifest);
  if (content.status != ReadStatus::ok) return {};
  PackageManifest manifest = read_manifest(content.text);
  manifest.exists = true;
  return manifest;
}

}  // namespace smurf
