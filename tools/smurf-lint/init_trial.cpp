// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-lint/init_trial.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "base/files/path.hpp"
#include "base/files/places.hpp"
#include "common/files/input.hpp"
#include "smurf-lint/settings.hpp"
#include "smurf/check.hpp"
#include "smurf/config.hpp"
#include "smurf/readers.hpp"
#include "smurf/verdict.hpp"

namespace smurf::tools {
namespace {

/// Which finding it is, whatever its severity.
using Key = std::pair<std::string, std::string>;  // file and rule

class Trial {
 public:
  Trial(const std::string& folder, const LintOptions& options)
      : folder_(folder),
        config_(path::normalize(path::join(folder, kConfigName))),
        settings_(check_settings(options)),
        session_(options.limits) {}

  void check(const std::string& text) {
    session_.set_text(config_, text);
    found_ = session_.check(std::span(&folder_, 1), settings_).diagnostics;
  }

  const std::vector<Diagnostic>& found() const { return found_; }

  Key key_of(const Diagnostic& one) const {
    const std::string& path = session_.sources().path(one.span.source);
    const std::string inside = places::relative(identity(path), identity(folder_));
    return {inside.empty() ? path : inside, std::string(one.rule->id)};
  }

 private:
  const std::string folder_, config_;
  const CheckSettings settings_;
  Session session_;
  std::vector<Diagnostic> found_;
};

/// How many of these findings are errors for a reader.
std::size_t refusals_of(const Reader& reader, const std::vector<const Diagnostic*>& found) {
  return static_cast<std::size_t>(
      std::count_if(found.begin(), found.end(), [&](const Diagnostic* one) {
        const Fact* fact = find_fact(reader, *one);
        return fact != nullptr && fact->effect >= Effect::breaks;
      }));
}

/// The first release with the fewest errors; the name itself if the oldest is one of these.
std::string best_release(const std::string& name, const std::vector<const Diagnostic*>& found) {
  const Reader* reader = find_target(name);
  if (reader == nullptr) return name;
  std::string best = name;
  std::size_t fewest = refusals_of(*reader, found);
  for (const Reader* release : reader->releases) {
    const std::size_t count = refusals_of(*release, found);
    if (count >= fewest) continue;
    fewest = count;
    best = release->name;
  }
  return best;
}

}  // namespace

InitTargets try_targets(const std::string& folder, const std::vector<std::string>& names,
                        const std::function<std::string(const InitTargets&)>& text_of,
                        const LintOptions& options) {
  Trial trial(folder, options);
  std::map<Key, Severity> without;  // the worst of each
  // The rest of the configuration first makes robots readable: what is wrong in them is no matter
  // of targets.
  for (const std::string& text : {std::string("{}\n"), text_of({})}) {
    trial.check(text);
    std::map<Key, Severity> worst;
    for (const Diagnostic& one : trial.found()) {
      const auto [known, is_new] = worst.try_emplace(trial.key_of(one), one.severity);
      known->second = std::max(known->second, one.severity);
    }
    without.merge(worst);
  }
  InitTargets targets{names, {}};
  std::vector<const Diagnostic*> raised;
  const auto look = [&] {
    trial.check(text_of(targets));
    raised.clear();
    for (const Diagnostic& one : trial.found()) {
      const auto known = without.find(trial.key_of(one));
      // Where the same rule reports an error anyway, the file fails with and without targets.
      const bool was_error = known != without.end() && known->second == Severity::error;
      if (one.severity == Severity::error && !was_error) raised.push_back(&one);
    }
  };
  look();
  for (std::string& name : targets.names) name = best_release(name, raised);
  if (targets.names != names) look();
  std::set<Key> seen;
  for (const Diagnostic* one : raised) {
    const Key key = trial.key_of(*one);
    if (!seen.insert(key).second) continue;
    const auto known = without.find(key);
    const Severity before = known == without.end() ? Severity::warning : known->second;
    targets.raised.push_back({key.first, key.second, std::string(to_string(before))});
  }
  return targets;
}

}  // namespace smurf::tools
