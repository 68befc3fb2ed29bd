// SPDX-License-Identifier: BSD-3-Clause
#include "smurf/each.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "base/files/path.hpp"
#include "check/asked_files.hpp"
#include "check/check_cache.hpp"
#include "check/parallel.hpp"
#include "link/companions/library.hpp"
#include "smurf/companions.hpp"
#include "smurf/confine.hpp"

namespace smurf {
namespace {

std::vector<EachFile> each_file(const Plan& plan) {
  std::vector<EachFile> files;
  for (const PlannedFile& one : plan.scenes) files.push_back({&one, true});
  for (const auto* planned : {&plan.models, &plan.others}) {
    for (const PlannedFile& one : *planned) {
      const bool is_beside =
          input_kind(one.path) == InputKind::annotation || is_companion_path(one.path);
      if (!is_beside) files.push_back({&one, false});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const EachFile& a, const EachFile& b) { return a.planned->path < b.planned->path; });
  return files;
}

/// The part of a plan that is about this file.
Plan plan_of(const EachFile& file, const Plan& plan) {
  Plan alone;
  alone.configs = plan.configs;
  (file.is_scene ? alone.scenes : alone.models).push_back(*file.planned);
  return alone;
}

}  // namespace

/// What the checks of files in one folder share: each of them would list it again, which takes a
/// time that grows with the square of their number. Several threads may use it.
class SharedFolder {
 public:
  std::shared_ptr<CompanionFolders> of(const std::string& path) {
    const std::string_view folder = path::parent(path);
    const std::lock_guard lock(mutex_);
    if (shared_ == nullptr || folder_ != folder) {
      folder_ = folder;
      shared_ = std::make_shared<CompanionFolders>();
    }
    return shared_;
  }

 private:
  std::mutex mutex_;
  std::string folder_;
  std::shared_ptr<CompanionFolders> shared_;
};

struct EachChecks::State {
  State(const Plan& of_files, const CheckSettings& of_user, const Limits& most)
      : plan(of_files), settings(of_user), limits(most), files(each_file(of_files)) {
    settings.jobs = 1;
    settings.remembers = false;
  }

  const Plan& plan;
  CheckSettings settings;
  Limits limits;
  std::vector<EachFile> files;
  std::unique_ptr<CheckCache> cache;
  std::string text_path, text;  ///< that replaces a file
  bool has_text = false;
  mutable SharedFolder folder;
};

struct EachCheck::State {
  State(const EachChecks::State& of_all, const EachFile& file)
      : all(of_all),
        planned(*file.planned),
        plan(plan_of(file, of_all.plan)),
        cache(of_all.has_text ? nullptr : of_all.cache.get()),
        asked(files, file.planned->path, cache != nullptr) {
    std::vector<std::string> inputs = plan.configs;
    inputs.push_back(planned.path);
    confine(files, inputs, all.settings.packages, all.settings.allows_outside);
    files.allow(all.settings.config);
    files.allow(all.settings.baseline);
    if (cache == nullptr) return;
    scope = files.scope();
    key = cache->key_of(plan, scope);
  }

  const EachChecks::State& all;
  const PlannedFile& planned;
  Plan plan;
  CheckCache* cache;  ///< may be null
  // A reader of its own: what it remembers about folders and links would grow with the robots.
  ConfinedFiles files;
  AskedFiles asked;
  std::string scope;
  Digest key{};
  std::optional<Session> session;
  bool may_keep = false;
  bool is_only_part = false;
};

EachCheck::EachCheck(std::unique_ptr<State> state) : state_(std::move(state)) {}
EachCheck::~EachCheck() = default;
EachCheck::EachCheck(EachCheck&&) noexcept = default;

std::optional<std::string> EachCheck::known() {
  if (state_->cache == nullptr) return std::nullopt;
  return state_->cache->find(state_->key, state_->files, state_->scope);
}

Report EachCheck::check() {
  const auto& all = state_->all;
  Session& session = state_->session.emplace(state_->asked, all.limits);
  if (all.has_text) session.set_text(all.text_path, all.text);
  CheckSettings settings = all.settings;
  settings.folders = all.folder.of(state_->planned.path);
  Report report = session.check(state_->plan, settings);
  state_->may_keep = !report.is_stopped;
  state_->is_only_part =
      state_->planned.may_be_part && report.summary.models == 0 && report.diagnostics.empty();
  return report;
}

bool EachCheck::is_only_part() const { return state_->is_only_part; }
const SourceMap& EachCheck::sources() const { return state_->session->sources(); }

std::string EachCheck::digest() const {
  const auto& digest = state_->asked.own_digest();
  return digest ? hex_of(*digest) : std::string();
}

void EachCheck::keep(std::string_view answer) {
  if (state_->cache == nullptr || !state_->may_keep) return;
  const auto asked = state_->asked.asked();
  if (asked) state_->cache->add(state_->key, *asked, answer);
}

EachChecks::EachChecks(const Plan& plan, const CheckSettings& settings, const Limits& limits)
    : state_(std::make_unique<State>(plan, settings, limits)) {}
EachChecks::~EachChecks() = default;

void EachChecks::set_text(const std::string& path, std::string text) {
  state_->text_path = path;
  state_->text = std::move(text);
  state_->has_text = true;
}

void EachChecks::use_cache(const std::string& folder, const std::string& form) {
  state_->cache = std::make_unique<CheckCache>(folder, form, state_->settings, state_->limits);
}

std::string EachChecks::cache_problem() const {
  return state_->cache == nullptr ? std::string() : state_->cache->problem();
}

const std::vector<EachFile>& EachChecks::files() const { return state_->files; }

void EachChecks::leave_out(const std::function<bool(const PlannedFile&)>& is_left_out) {
  std::erase_if(state_->files, [&](const EachFile& one) { return is_left_out(*one.planned); });
}

EachCheck EachChecks::of(std::size_t index) const {
  return EachCheck(std::make_unique<EachCheck::State>(*state_, state_->files.at(index)));
}

void for_each_of(std::size_t count, unsigned jobs, const std::function<void(std::size_t)>& check,
                 const std::function<bool(std::size_t)>& take) {
  for_each_in_order(
      count, count_of_jobs(jobs), [&](std::size_t, std::size_t i) { check(i); }, take);
}

}  // namespace smurf
