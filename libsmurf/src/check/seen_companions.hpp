// SPDX-License-Identifier: BSD-3-Clause
// The companions of a plan: which robots are loaded for them, and which were not compared.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/files/canonical_paths.hpp"
#include "check/pipeline.hpp"
#include "check/written_names.hpp"
#include "link/package_search.hpp"
#include "smurf/plan.hpp"

namespace smurf {

class SeenCompanions {
 public:
  SeenCompanions(const CheckContext& context, PackageSearch& search)
      : context_(context), search_(search) {}

  /// Looks which files of the plan are companions. Call it before robots are loaded.
  void read(const Plan& plan);
  /// Tells the companions of a search what is near. Equal texts mean the same.
  void tell(CompanionLibrary& library) const;
  const std::string& near() const { return near_; }

  /// Whether the plan has this file, by identity.
  bool is_asked_for(const std::string& file) const { return files_.contains(file); }

  void add_rejected(const std::string& file, const RejectedCompanion& one);
  void add_unknown_robot(const std::string& path) { unknown_robots_.insert(path); }

  /// Robots that may have the files which no robot has, neither of which is in `known`. `ties` are
  /// those of each configuration.
  std::vector<PlannedFile> helpers(const std::set<std::string>& known,
                                   const std::vector<std::vector<CompanionTie>>& ties) const;
  /// Reports those that cannot be parsed; robots report the ones in `known`.
  void report_broken(const std::set<std::string>& known, SourceMap& sources,
                     std::vector<Judged>& found);
  /// Reports misspelt names in files whose robots could not be expanded.
  void report_misspelt(const std::set<std::string>& known,
                       const std::vector<std::vector<CompanionTie>>& ties, SourceMap& sources,
                       std::vector<Judged>& found) const;
  /// The files that are not in `known`, with reasons.
  std::vector<NotCompared> not_compared(const std::set<std::string>& known,
                                        const std::vector<std::vector<CompanionTie>>& ties) const;

 private:
  struct File {
    PlannedFile planned;
    const SeenCompanion* seen = nullptr;
  };
  std::string id_of(const std::string& path) const {
    return identity(path, context_.paths, context_.files);
  }
  /// Whether no robot has the file, although it can be read.
  bool is_open(const std::string& id, const File& file, const std::set<std::string>& known) const;
  /// `likely`: robots that may have the file, and could not be expanded; `near`: one in its
  /// package, or in a related one.
  NotCompared judge(const std::string& id, const File& file, const std::vector<std::string>& likely,
                    const std::string& near) const;

  const CheckContext& context_;
  PackageSearch& search_;
  std::map<std::string, File> files_;  ///< by identity
  std::map<std::string, RejectedCompanion> rejected_;
  std::set<std::string> unknown_robots_, named_robots_;
  std::set<std::string> broken_;  ///< reported, by identity
  std::string near_;
};

}  // namespace smurf
