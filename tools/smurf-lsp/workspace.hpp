// SPDX-License-Identifier: BSD-3-Clause
// The open documents: their findings, and the models and scenes that read them.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "common/rename/loaded_names.hpp"
#include "common/rename/xacro_names.hpp"
#include "common/rename/xacro_rename.hpp"
#include "plan/xacro_files.hpp"
#include "smurf-lint/lint_plan.hpp"
#include "smurf-lsp/positions.hpp"
#include "smurf/check.hpp"

namespace smurf::lsp {

struct OpenDocument {
  std::string uri;  ///< as written by the client
  std::int64_t version = 0;
  std::string text;
};

/// A file in one model or scene that reads it.
struct FileView {
  std::size_t part = 0;  ///< index in LoadedNames
  SourceId source{};
  const LinkedModel* model = nullptr;    ///< null: a scene file
  const LinkedScene* scene = nullptr;    ///< null: a model that was loaded alone
  const yaml::Document* yaml = nullptr;  ///< with `xml`: null when it could not be read
  const xml::Document* xml = nullptr;
  const LaunchFile* launch = nullptr;  ///< of views_around() only
};

/// Processor time for a request about open files, and for each file of one about folders: whoever
/// types waits for no more.
inline constexpr std::uint64_t kSecondsInEditor = 30;

/// A part of one model or scene.
bool is_same_thing(const Reference& a, const Reference& b);

CheckSettings settings_of_check();

class Workspace {
 public:
  void set_folders(std::vector<std::string> folders);
  const std::vector<std::string>& folders() const { return folders_; }

  /// Changes of documents that are not open are ignored.
  void open(const std::string& path, OpenDocument document);
  void change(const std::string& path, std::int64_t version, const Json& changes,
              Encoding encoding);
  void close(const std::string& path);
  /// Call it when files on the disk have changed.
  void forget_files();

  const std::map<std::string, OpenDocument>& documents() const { return documents_; }
  const OpenDocument* document(const std::string& path) const;
  /// The URI of a file; the client's spelling if it is open.
  std::string uri_of(const std::string& path) const;

  /// Whether report() is up to date.
  bool is_checked() const { return is_checked_; }
  /// The findings of smurf-lint in the open documents and the models around them.
  const Report& report();
  const SourceMap& sources() const { return session_.sources(); }
  /// The findings in the folders; they point into `sources` until the next check of the folders.
  struct FolderReport {
    Report report;
    const SourceMap* sources = nullptr;
  };
  FolderReport check_folders(std::function<void(std::size_t, std::size_t)> on_progress,
                             std::function<bool()> is_cancelled);

  /// All definitions in the folders and the open documents: a name, its kind, and its place.
  struct Definition {
    std::string name;
    NameKind kind{};
    std::string path;
    Span span;
  };
  struct Definitions {
    std::vector<Definition> list;
    const SourceMap* sources = nullptr;
  };
  Definitions definitions();

  /// The models and scenes of the open documents.
  const tools::LoadedNames& names();
  const SourceMap& loaded_sources() const { return session_.loaded_sources(); }
  /// Makes the names in an open launch file, or another file around robots, known to names(): loads
  /// what is around the robots, and if no robot of the file is open, those that it is about.
  void look_around(const std::string& path);
  /// Makes the names in all files around the robots known.
  void look_around();
  /// The views of an open file around robots, one for each of them.
  std::vector<FileView> views_around(const std::string& path);
  /// What is around the robot of a view.
  const Surroundings& surroundings_of(const FileView& view);
  /// The views of an open file, one for every model and scene that reads it; scenes last.
  std::vector<FileView> views(const std::string& path);
  /// The same for another text of an open document.
  std::vector<FileView> views_with(const std::string& path, std::string text);
  /// Whether the file exists in the projects of the editor: those of its folders and documents.
  bool is_changeable(const std::string& path) const;
  /// An open xacro and the files of its robots; null for other documents.
  const tools::XacroFamily* xacro_family(const std::string& path);
  /// The files that an include in an open xacro may mean.
  std::vector<std::string> xacro_files_meant(const std::string& written, const std::string& from);
  /// The folder of a package with xacro files that an open file names; none if it is unknown.
  std::optional<std::string> package_folder(const std::string& name, const std::string& from);
  /// An expanded robot that contains a file, and the sources of the file in it.
  struct Expanded {
    const xacro::Expansion* expansion = nullptr;
    std::set<SourceId> sources;
  };
  /// Those of the open documents.
  std::vector<Expanded> expansions_of(const std::string& path);
  const FileReader& files() const { return session_.files(); }
  const Limits& limits() const { return session_.limits(); }

  /// A model or scene as a page to look at, with the open documents as they are.
  struct Picture {
    std::string page;               ///< "" when there is none
    std::optional<Diagnostic> why;  ///< the first error of reading; points into loaded_sources()
  };
  /// `path`: a scene, a model, a URDF, or an annotation file, of which the model is shown. Releases
  /// all loaded files.
  Picture picture(const std::string& path);

  /// Renames things, also in the folders. Edits point into loaded_sources() until the next change.
  Renamed rename(std::size_t part, const Reference& reference, const std::string& to);
  /// The same for a name of xacro in an open document; the robots stay as they are.
  tools::RenamedXacro rename_xacro(const std::string& path, const tools::XacroRename& rename);

 private:
  /// Includes of an edited xacro may mean other files than before.
  void forget_xacro_files();
  const XacroFiles& xacro_files_around(const std::string& path);
  tools::LintPlan make_plan(const std::vector<std::string>& paths) const;
  std::vector<std::string> checkable_documents() const;
  /// The URDF files that open SRDF files may be about.
  std::vector<std::string> robots_of_srdfs() const;
  const Plan& plan();
  /// The robots that an open file is about.
  const std::vector<std::string>& robots_about(const std::string& path);
  void put_texts();
  /// Gives the session of the folders the texts of the open documents, and no others.
  Session& folder_session();
  void load();
  void touch(const std::string& path);
  std::string place_of_definition(std::size_t part, const Reference& reference);
  void confine_changes(ConfinedFiles& changeable) const;
  /// The models and scenes that a rename changes.
  Plan plan_of_rename(const std::string& defined_in, const Rename& rename);

  std::vector<std::string> folders_;
  std::map<std::string, OpenDocument> documents_;  ///< by path
  Session session_;
  std::optional<Session>
      folder_session_;                  ///< separate, so that typing does not wait for the folders
  std::set<std::string> folder_texts_;  ///< documents whose texts that session has
  std::set<std::string> changed_;       ///< documents whose new text the session does not have yet
  std::optional<Plan> plan_;
  Report report_;
  bool is_checked_ = false;
  std::optional<tools::LoadedNames> names_;
  tools::LoadedNames::Reach reach_ = tools::LoadedNames::Reach::companions;  ///< of these
  std::set<std::string> needs_around_;   ///< documents around robots
  std::set<std::string> looked_around_;  ///< documents whose robots are loaded for them
  std::map<std::string, std::vector<std::string>> robots_about_;  ///< by document
  std::map<std::string, XacroFiles> xacro_files_;                 ///< by project
  std::map<std::string, tools::XacroFamily> xacro_families_;      ///< by document
  std::optional<tools::LoadedNames> folder_names_;                ///< loaded by folder_session_
};

}  // namespace smurf::lsp
