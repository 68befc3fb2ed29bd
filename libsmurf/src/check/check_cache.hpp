// SPDX-License-Identifier: BSD-3-Clause
// Answers about the results of checks, each with the questions about files on which it depends.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "check/asked_files.hpp"
#include "check/cache_file.hpp"
#include "smurf/check.hpp"
#include "smurf/limits.hpp"
#include "smurf/plan.hpp"

namespace smurf {

/// Several threads may use it.
class CheckCache {
 public:
  /// `form` says what the answers are.
  CheckCache(const std::string& folder, const std::string& form, const CheckSettings& settings,
             const Limits& limits);

  /// A digest of everything on which the result of the check of a plan depends, without the files:
  /// program, settings, current folder, environment, and what may be read.
  Digest key_of(const Plan& plan, const std::string& scope) const;
  std::optional<std::string> find(const Digest& key, const FileReader& files,
                                  const std::string& scope);
  void add(const Digest& key, const std::vector<AskedPath>& asked, std::string_view answer);
  std::string problem() const;

 private:
  std::string common_;  ///< of all keys
  std::optional<CacheFile> file_;
  std::string problem_;
  ListDigests lists_;
};

}  // namespace smurf
