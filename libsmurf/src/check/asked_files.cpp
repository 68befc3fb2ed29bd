// SPDX-License-Identifier: BSD-3-Clause
#include "check/asked_files.hpp"

#include <utility>

namespace smurf {
namespace {

constexpr std::size_t kShort = 16;  // bytes of a digest
// Where packages are looked for in a whole workspace, to ask again takes as long as a check.
constexpr std::size_t kMostPaths = 2'000;
constexpr std::size_t kMostFolders = 1'000;  // whose digests are remembered

std::string in_a_letter(bool is_true) { return is_true ? "y" : "n"; }

/// A file that the system did not let us read may be readable the next time, without a change.
constexpr char kRefused = '!';

std::string answer_of(const FileContent& content, const Digest& digest, const std::string& path,
                      const FileReader& files) {
  const bool is_refused = content.status == ReadStatus::denied && !files.is_denied(path);
  const char letter =
      is_refused ? kRefused : static_cast<char>('0' + static_cast<int>(content.status));
  return letter + hex_of(digest, kShort);
}

Digest digest_of(const FileContent& content) {
  return smurf::digest_of(content.status == ReadStatus::ok ? content.text : content.reason);
}

bool is_refused(const AskedQuestion& question) {
  return question.kind == AskedKind::content && question.answer.starts_with(kRefused);
}

/// Numbers identities, which differ from machine to machine: equal ones get equal numbers.
class Identities {
 public:
  std::string number_of(const std::string& identity) {
    return std::to_string(numbers_.emplace(identity, numbers_.size()).first->second);
  }

 private:
  std::map<std::string, std::size_t> numbers_;
};

std::string ask(const AskedQuestion& question, const std::string& path, const FileReader& files) {
  switch (question.kind) {
  case AskedKind::content: {
    const FileContent content = files.read(path, question.max_bytes);
    return answer_of(content, digest_of(content), path, files);
  }
  case AskedKind::is_file: return in_a_letter(files.is_file(path));
  case AskedKind::is_denied: return in_a_letter(files.is_denied(path));
  case AskedKind::list:
  case AskedKind::identity: break;
  }
  return {};
}

bool has_same_identities(const std::vector<AskedPath>& asked, const FileReader& files) {
  Identities identities;
  for (const AskedPath& one : asked) {
    for (const AskedQuestion& question : one.questions) {
      if (question.kind != AskedKind::identity) continue;
      if (identities.number_of(files.identity(one.path)) != question.answer) return false;
    }
  }
  return true;
}

}  // namespace

std::string ListDigests::of(const std::string& folder, const std::string& scope,
                            const FileReader& files) {
  const std::pair key(folder, scope);
  {
    const std::lock_guard lock(mutex_);
    if (const auto known = known_.find(key); known != known_.end()) return known->second;
  }
  std::string digest = digest_of_names(files.list(folder));
  const std::lock_guard lock(mutex_);
  if (known_.size() >= kMostFolders) known_.clear();
  return known_.emplace(key, std::move(digest)).first->second;
}

/// Call it before a question is asked: the stamp must not be newer than the answer.
void AskedFiles::begin(const std::string& path) const {
  const auto [known, is_new] = asked_.try_emplace(path);
  if (is_new) known->second = {path, stamps_.of(path), {}};
  if (asked_.size() <= kMostPaths) return;
  notes_all_ = false;
  is_complete_ = false;
  asked_.clear();
}

void AskedFiles::note(AskedKind kind, const std::string& path, std::uint64_t max_bytes,
                      std::string answer) const {
  const auto one = asked_.find(path);
  if (one == asked_.end()) return;  // there are too many
  for (const AskedQuestion& known : one->second.questions) {
    if (known.kind != kind || known.max_bytes != max_bytes) continue;
    is_complete_ = is_complete_ && known.answer == answer;
    return;
  }
  one->second.questions.push_back({kind, max_bytes, std::move(answer)});
}

FileContent AskedFiles::read(const std::string& path, std::uint64_t max_bytes) const {
  if (notes_all_) begin(path);
  FileContent content = files_.read(path, max_bytes);
  const bool is_own = path == own_ && content.status == ReadStatus::ok;
  if (!notes_all_ && !is_own) return content;
  const Digest digest = digest_of(content);
  if (is_own) own_digest_ = digest;
  if (notes_all_)
    note(AskedKind::content, path, max_bytes, answer_of(content, digest, path, files_));
  return content;
}

bool AskedFiles::is_file(const std::string& path) const {
  if (notes_all_) begin(path);
  const bool answer = files_.is_file(path);
  if (notes_all_) note(AskedKind::is_file, path, 0, in_a_letter(answer));
  return answer;
}

std::vector<std::string> AskedFiles::list(const std::string& folder) const {
  if (notes_all_) begin(folder);
  std::vector<std::string> names = files_.list(folder);
  if (notes_all_) note(AskedKind::list, folder, 0, digest_of_names(names));
  return names;
}

void AskedFiles::rely_on_list(const std::string& folder, const std::string& digest) const {
  if (!notes_all_) return;
  begin(folder);
  note(AskedKind::list, folder, 0, digest);
}

bool AskedFiles::is_denied(const std::string& path) const {
  if (notes_all_) begin(path);
  const bool answer = files_.is_denied(path);
  if (notes_all_) note(AskedKind::is_denied, path, 0, in_a_letter(answer));
  return answer;
}

std::string AskedFiles::identity(const std::string& path) const {
  if (notes_all_) begin(path);
  std::string answer = files_.identity(path);
  if (notes_all_) note(AskedKind::identity, path, 0, answer);
  return answer;
}

std::optional<std::vector<AskedPath>> AskedFiles::asked() const {
  if (!is_complete_) return std::nullopt;
  Identities identities;
  std::vector<AskedPath> all;
  for (const auto& [path, one] : asked_) {
    AskedPath& copy = all.emplace_back(one);
    for (AskedQuestion& question : copy.questions) {
      if (question.kind == AskedKind::identity) {
        question.answer = identities.number_of(question.answer);
      }
      if (is_refused(question)) copy.stamp.text.clear();
    }
  }
  return all;
}

AskedAgain ask_again(std::vector<AskedPath>& asked, const FileReader& files, ListDigests& lists,
                     const std::string& scope) {
  PlaceStamps stamps(files);
  bool has_new_stamps = false;
  bool has_new_identity = false;  // perhaps
  for (AskedPath& one : asked) {
    PlaceStamp now = stamps.of(one.path);
    if (now.place != one.stamp.place) return AskedAgain::other;
    const bool is_same = !now.text.empty() && now.text == one.stamp.text;
    bool is_any_refused = false;
    for (const AskedQuestion& question : one.questions) {
      is_any_refused = is_any_refused || is_refused(question);
      if (question.kind == AskedKind::identity) {
        has_new_identity = has_new_identity || !is_same;
      } else if (question.kind == AskedKind::list) {
        // Not every file system changes the time of a folder with its names.
        const bool is_missing_as_before = is_same && now.is_missing();
        if (!is_missing_as_before && lists.of(one.path, scope, files) != question.answer) {
          return AskedAgain::other;
        }
      } else if (!is_same && ask(question, one.path, files) != question.answer) {
        return AskedAgain::other;
      }
    }
    if (is_same) continue;
    if (is_any_refused) now.text.clear();
    has_new_stamps = has_new_stamps || now.text != one.stamp.text;
    one.stamp = std::move(now);
  }
  if (has_new_identity && !has_same_identities(asked, files)) return AskedAgain::other;
  return has_new_stamps ? AskedAgain::same_with_new_stamps : AskedAgain::same;
}

}  // namespace smurf
