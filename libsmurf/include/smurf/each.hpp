// SPDX-License-Identifier: BSD-3-Clause
// Robots and scenes of a data set, each of which is checked by itself.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "smurf/check.hpp"

namespace smurf {

/// One robot or scene of a plan.
struct EachFile {
  const PlannedFile* planned = nullptr;
  bool is_scene = false;
};

/// The check of one of them. Use it in one thread.
class EachCheck {
 public:
  ~EachCheck();
  EachCheck(EachCheck&&) noexcept;

  /// What keep() was given after an earlier check, if it has a cache and everything on which the
  /// result depends is as it was.
  std::optional<std::string> known();
  /// The texts of the findings are in sources(). The report is empty, and is_only_part() true, for
  /// a file that was found in a folder and is only a part of robots.
  Report check();
  bool is_only_part() const;
  const SourceMap& sources() const;
  /// The digest of the bytes of the file, as `b2sum --length 256` prints it; "" if it was not read.
  std::string digest() const;
  /// Keeps an answer about the result of check() in the cache.
  void keep(std::string_view answer);

 private:
  friend class EachChecks;
  struct State;
  explicit EachCheck(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// The checks of all files of a plan. Several threads may use it.
class EachChecks {
 public:
  /// The plan must outlive it.
  EachChecks(const Plan& plan, const CheckSettings& settings, const Limits& limits);
  ~EachChecks();
  EachChecks(const EachChecks&) = delete;
  EachChecks& operator=(const EachChecks&) = delete;

  /// Call these two before all others. A text that replaces that of a file; nothing is then kept in
  /// a cache.
  void set_text(const std::string& path, std::string text);
  /// Keeps answers in files of a folder, which is made. `form` says what they are: those of another
  /// form are not found.
  void use_cache(const std::string& folder, const std::string& form);
  /// Why the cache is not used, or not added to: "cannot write 'x/y': No space left on device".
  std::string cache_problem() const;

  /// Sorted by path.
  const std::vector<EachFile>& files() const;
  /// Leaves out files.
  void leave_out(const std::function<bool(const PlannedFile&)>& is_left_out);
  /// The check of one of the files.
  EachCheck of(std::size_t index) const;

 private:
  friend struct EachCheck::State;
  struct State;
  std::unique_ptr<State> state_;
};

/// Calls `check(index)` for every index below `count` on `jobs` threads (0: one for each
/// processor), and then `take(index)`, in the order of the indices and one at a time, until it
/// returns false.
void for_each_of(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& check,
                 const std::function<bool(std::size_t)>& take);

}  // namespace smurf
