// SPDX-License-Identifier: BSD-3-Clause
// The files of a model: the main one, those that it includes, and where `model://` leads.
#pragma once

#include <cstddef>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "sdf/reading.hpp"
#include "sdf/schema.hpp"

namespace smurf::sdformat {

/// A file that was read and compared with the schema.
struct SdfFile {
  View root;
  std::string path, folder;
  int version = 12;  ///< the minor number: 4 for 1.4
};

class Files {
 public:
  Files(SourceId root, Reporter& reporter);

  /// Null if it cannot be read, which has been reported.
  const SdfFile* main();
  /// A file that an include at `place` names.
  const SdfFile* open(const std::string& path, Span place);
  /// The file of the model that `<uri>` of a file names; reports one that is not there.
  std::optional<std::string> find_model(const std::string& uri, const SdfFile& from, Span place);
  /// The address of a mesh or picture, from the folder of the main file if it is known.
  std::string resource(std::string_view uri, const SdfFile& from);
  /// The same as a path that can be opened; "" if there is no such file.
  std::string path_of(std::string_view uri, const SdfFile& from);
  std::deque<xml::Document>& documents() { return documents_; }
  Reporter& reporter() { return reporter_; }

 private:
  const SdfFile* parse(SourceId source, const std::string& path);
  bool read_version(SdfFile& file);
  /// The file or the folder of a model that `NAME/REST` names; "" if there is none.
  const std::string& place_of_name(const std::string& name, const std::string& near);
  bool is_there(const std::string& path);
  std::optional<std::string> search_model(const std::string& uri, const SdfFile& from, Span place);
  std::string search(const std::string& name, const std::string& near);
  std::string search_below(const std::string& top, const std::string& name);
  bool holds_model(const std::string& folder);
  /// The file that model.config names for the newest known version.
  std::string file_in(const std::string& folder);

  Reporter& reporter_;
  SourceId source_;
  std::string folder_;  ///< of the main file
  std::deque<xml::Document> documents_;
  std::map<std::string, SdfFile> files_;
  std::map<std::string, bool> broken_;
  std::map<std::pair<std::string, std::string>, std::string> places_;
  int searches_ = 0;
  std::map<std::pair<std::string, std::string>, std::optional<std::string>> models_;
};

}  // namespace smurf::sdformat
