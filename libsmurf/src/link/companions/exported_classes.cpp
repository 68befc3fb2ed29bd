// SPDX-License-Identifier: BSD-3-Clause
// Source: pluginlib class_loader_imp.hpp processSingleXMLPluginFile.
#include "link/companions/exported_classes.hpp"

#include <algorithm>
#include <set>
#include <string>
#include <string_view>

#include "base/files/path.hpp"
#include "base/text/words.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostFilesOfPackage = 20;  // of XML in a package
constexpr std::uint64_t kMostBytesOfDescription = 1U << 18U;
constexpr int kDeepestType = 6;  // of a `type` in a parameter file

using PackageNames = std::set<std::string, std::less<>>;

/// "arm_driver" of "arm_driver/Arm"
void add_package(std::string_view name, PackageNames& packages) {
  name = trimmed(name);
  const std::size_t slash = name.find('/');
  if (slash != std::string_view::npos) packages.emplace(name.substr(0, slash));
}

void add_types(yaml::View value, int level, PackageNames& packages) {
  if (!value || !value.is_mapping() || level > kDeepestType) return;
  for (const yaml::View member : value) {
    if (member.is_scalar() && member.key() == "type") add_package(member.text(), packages);
    if (!member.is_repeated()) add_types(member, level + 1, packages);
  }
}

PackageNames packages_named_in(const LinkedModel& model, const Companions& companions) {
  PackageNames packages;
  for (const xml::ElementId id : model.robot->extensions) {
    const xml::View element(model.robot->document, id);
    if (element.name() != "ros2_control") continue;
    for (const xml::View hardware : element) {
      if (hardware.name() != "hardware") continue;
      for (const xml::View plugin : hardware) {
        if (plugin.name() == "plugin") add_package(plugin.text(), packages);
      }
    }
  }
  for (const Companion& one : companions.files) {
    if (one.kind != CompanionKind::controllers || !one.document) continue;
    add_types(one.document->view(), 0, packages);
  }
  return packages;
}

/// The value of an attribute in a tag; "" if it is missing.
std::string_view attribute_in(std::string_view tag, std::string_view name) {
  for (std::size_t at = tag.find(name); at != std::string_view::npos; at = tag.find(name, at + 1)) {
    if (at == 0 || !is_blank(tag[at - 1])) continue;
    std::string_view rest = trimmed(tag.substr(at + name.size()));
    if (!rest.starts_with('=')) continue;
    rest = trimmed(rest.substr(1));
    if (rest.empty() || (rest.front() != '"' && rest.front() != '\'')) continue;
    const std::size_t close = rest.find(rest.front(), 1);
    if (close != std::string_view::npos) return trimmed(rest.substr(1, close - 1));
  }
  return {};
}

std::string without_comments(std::string_view xml) {
  std::string plain;
  while (!xml.empty()) {
    const std::size_t open = std::min(xml.find("<!--"), xml.size());
    plain += xml.substr(0, open);
    const std::size_t close = xml.find("-->", open);
    xml.remove_prefix(close == std::string_view::npos ? xml.size() : close + 3);
  }
  return plain;
}

/// Reads a plugin description. It may have several elements `library` and no root, which is not
/// XML, but which pluginlib reads.
void add_classes(const std::string& package, std::string_view xml,
                 std::vector<ExportedClass>& classes) {
  const std::string text = without_comments(xml);
  for (std::size_t at = text.find("<class"); at != std::string::npos;
       at = text.find("<class", at + 1)) {
    const std::size_t end = text.find('>', at);
    if (end == std::string::npos) return;
    const std::string_view tag = std::string_view(text).substr(at, end - at);
    const std::string_view base = attribute_in(tag, "base_class_type");
    std::string_view name = attribute_in(tag, "name");
    if (name.empty()) name = attribute_in(tag, "type");
    if (base.empty() || name.empty()) continue;
    classes.push_back({package, std::string(name), std::string(base)});
  }
}

void add_classes_of(const NearPackage& package, const FileReader& files,
                    std::vector<ExportedClass>& classes) {
  std::size_t count = 0;
  for (const std::string_view folder : {"", "plugins", "plugin", "resource", "config"}) {
    const std::string place = folder.empty() ? package.folder : path::join(package.folder, folder);
    for (const std::string& name : files.list(place)) {
      if (!name.ends_with(".xml") || name == "package.xml" || ++count > kMostFilesOfPackage)
        continue;
      const FileContent content = files.read(path::join(place, name), kMostBytesOfDescription);
      if (content.status == ReadStatus::ok) add_classes(package.name, content.text, classes);
    }
  }
}

}  // namespace

std::vector<ExportedClass> exported_classes(const LinkedModel& model, const Companions& companions,
                                            const std::vector<NearPackage>& packages,
                                            const FileReader& files) {
  std::vector<ExportedClass> classes;
  if (!model.robot) return classes;
  const PackageNames named = packages_named_in(model, companions);
  if (named.empty()) return classes;
  for (const NearPackage& one : packages) {
    if (named.contains(one.name)) add_classes_of(one, files, classes);
  }
  return classes;
}

}  // namespace smurf
