// SPDX-License-Identifier: BSD-3-Clause
// Source: REP 149.
#include "link/package_manifest.hpp"

#include "base/files/path.hpp"
#include "base/text/words.hpp"
#include "smurf/diagnostic.hpp"
#include "smurf/xml.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf {
namespace {

constexpr std::uint64_t kMostBytesOfManifest = 1U << 20U;

}  // namespace

PackageManifest read_manifest(std::string_view text) {
  PackageManifest manifest;
  if (text.empty()) return manifest;
  SourceMap sources;
  DiagnosticSink ignored;
  const SourceId source = sources.add(std::string(kPackageFile), std::string(text));
  const auto document = parse_xml(sources, source, Limits{}, ignored);
  const xml::View root = document ? document->view() : xml::View();
  if (!root || root.name() != "package") return manifest;
  for (const xml::View child : root) {
    const std::string content(trimmed(child.text()));
    if (child.name() == "name" && manifest.name.empty()) manifest.name = content;
    if (child.name().ends_with("depend")) manifest.dependencies.insert(content);
    if (child.name() == "buildtool_depend" && content.starts_with("ament")) {
      manifest.is_ament = true;
    }
    if (child.name() != "export") continue;
    for (const xml::View one : child) {
      if (one.name() == "build_type" && trimmed(one.text()).starts_with("ament")) {
        manifest.is_ament = true;
      }
    }
  }
  return manifest;
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
