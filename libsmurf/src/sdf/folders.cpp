// SPDX-License-Identifier: BSD-3-Clause
// Where `model://NAME` and other addresses lead: Gazebo looks into the folders of an environment
// variable, and this reader into the folders around the file.
#include <algorithm>

#include "base/files/path.hpp"
#include "base/findings/rules.hpp"
#include "base/numbers/numbers.hpp"
#include "base/text/quoted.hpp"
#include "base/text/words.hpp"
#include "sdf/files.hpp"
#include "syntax/xml_reader.hpp"

namespace smurf::sdformat {
namespace {

constexpr int kMostAbove = 6;                // folders around a file in which models are
constexpr std::size_t kMostSearched = 3000;  // folders below the highest of these
constexpr std::size_t kDeepestFolder = 5;
constexpr int kMostSearches = 200;  // names that are nowhere cost the most
constexpr std::string_view kModelFolders[] = {"", "models", "model"};

bool has_scheme(std::string_view uri) { return uri.find("://") != std::string_view::npos; }

std::string_view after_scheme(std::string_view uri) {
  const std::size_t at = uri.find("://");
  if (at != std::string_view::npos) uri.remove_prefix(at + 3);
  while (uri.starts_with('/')) uri.remove_prefix(1);
  return uri;
}

}  // namespace

bool Files::holds_model(const std::string& folder) {
  const FileReader& files = reporter_.context().files;
  return files.is_file(path::join(folder, "model.config")) ||
         files.is_file(path::join(folder, "model.sdf"));
}

bool Files::is_there(const std::string& path) {
  return reporter_.context().files.is_file(path) || holds_model(path);
}

std::string Files::search_below(const std::string& top, const std::string& name) {
  const FileReader& files = reporter_.context().files;
  struct Folder {
    std::string path;
    std::size_t depth;
  };
  std::deque<Folder> open{{top, 0}};
  for (std::size_t count = 0; !open.empty() && count < kMostSearched; ++count) {
    const Folder at = std::move(open.front());
    open.pop_front();
    std::string here = path::join(at.path, name);
    if (is_there(here)) return here;
    if (at.depth == kDeepestFolder) continue;
    for (const std::string& inner : files.list(at.path)) {
      // Folders have no ending, with few exceptions; hidden ones hold no models.
      if (inner.find('.') != std::string::npos) continue;
      open.push_back({path::join(at.path, inner), at.depth + 1});
    }
  }
  return {};
}

std::string Files::search(const std::string& name, const std::string& near) {
  std::string folder = near;
  std::string highest = near;
  for (int level = 0; level <= kMostAbove; ++level) {
    for (const std::string_view inner : kModelFolders) {
      std::string here = path::join(path::join(folder, inner), name);
      if (is_there(here)) return here;
    }
    if (!reporter_.context().files.list(folder).empty()) highest = folder;
    if (path::normalize(folder) == "/") break;
    folder = path::join(folder.empty() ? "." : folder, "..");
  }
  return search_below(highest, name);
}

const std::string& Files::place_of_name(const std::string& name, const std::string& near) {
  const auto [known, is_new] = places_.emplace(std::pair{name, near}, std::string());
  if (is_new && searches_++ < kMostSearches) {
    known->second = search(name, near);
    if (known->second.empty() && near != folder_) known->second = search(name, folder_);
  }
  return known->second;
}

std::string Files::file_in(const std::string& folder) {
  Context& context = reporter_.context();
  const std::string config = path::join(folder, "model.config");
  FileContent content = context.files.read(config, context.limits.file_bytes);
  std::string best = "model.sdf";
  if (content.status == ReadStatus::ok) {
    const SourceId source = context.sources.add(config, std::move(content.text));
    if (auto document = parse_xml(context.sources, source, context.limits, context.sink)) {
      std::int64_t newest = -1;
      for (const View one : document->view()) {
        if (one.name() != "sdf") continue;
        const std::string_view version = attribute_of(one, "version");
        const auto minor =
            version.starts_with("1.") ? parse_integer(version.substr(2)) : std::nullopt;
        const std::int64_t number = minor.value_or(0);
        if (number <= newest || number > 12) continue;
        newest = number;
        best = text_of(one);
      }
      documents_.push_back(*std::move(document));
    }
  }
  return path::join(folder, best);
}

std::optional<std::string> Files::find_model(const std::string& uri, const SdfFile& from,
                                             Span place) {
  const auto key = std::pair{uri, from.folder};
  const auto known = models_.find(key);
  if (known != models_.end() && known->second) return known->second;
  return models_[key] = search_model(uri, from, place);
}

std::optional<std::string> Files::search_model(const std::string& uri, const SdfFile& from,
                                               Span place) {
  const FileReader& files = reporter_.context().files;
  if (uri.starts_with("http://") || uri.starts_with("https://")) {
    reporter_
        .report(rules::sml9304_lost_in_urdf, place,
                quoted(uri) + " is on a server, and nothing is fetched, so the model is lost")
        .help("download the model, and write `model://` and its name");
    return std::nullopt;
  }
  const std::string_view rest = after_scheme(uri);
  if (!has_scheme(uri) || uri.starts_with("file://")) {
    const std::string here = path::join(from.folder, has_scheme(uri) ? rest : uri);
    if (files.is_file(here)) return path::normalize(here);
    if (holds_model(here)) return path::normalize(file_in(here));
  }
  if (!rest.empty() && !rest.starts_with('.')) {
    const std::string& there = place_of_name(std::string(rest), from.folder);
    if (!there.empty()) return path::normalize(files.is_file(there) ? there : file_in(there));
  }
  if (is_one_of(rest, {"sun", "ground_plane"})) {
    // Nearly every world has them, and no package.
    reporter_
        .report(rules::sml9304_lost_in_urdf, place,
                quoted(uri) + " is one of Gazebo's own models, and not here, so it is lost")
        .help("put its folder, with `model.config`, into `models`");
    return std::nullopt;
  }
  reporter_.lack_file();
  reporter_.miss(place, "there is no model " + quoted(uri),
                 "put its folder, with `model.config`, beside that of this model or into `models`");
  return std::nullopt;
}

std::string Files::path_of(std::string_view uri, const SdfFile& from) {
  const FileReader& files = reporter_.context().files;
  std::string there;
  if (!has_scheme(uri)) {
    there = path::join(from.folder, uri);
  } else if (uri.starts_with("model://") || uri.starts_with("package://")) {
    there = place_of_name(std::string(after_scheme(uri)), from.folder);
  }
  return !there.empty() && files.is_file(there) ? path::normalize(there) : std::string();
}

std::string Files::resource(std::string_view uri, const SdfFile& from) {
  std::string path = path_of(uri, from);
  if (path.empty() && !has_scheme(uri) && !uri.empty())
    path = path::normalize(path::join(from.folder, uri));
  if (path.empty() || path::is_absolute(uri)) return std::string(uri);
  return path::relative(path, folder_.empty() ? "." : folder_);
}

}  // namespace smurf::sdformat
