// SPDX-License-Identifier: BSD-3-Clause
#include "check/snapshot.hpp"

#include <algorithm>

#include "base/files/path.hpp"

namespace smurf {
namespace {

// Texts of models are much smaller. Many meshes are larger, but their facts are kept instead.
constexpr std::uint64_t kMostOfFile = 8ULL << 20U;
constexpr std::uint64_t kMostOfAll = 64ULL << 20U;

std::string yes_or_no(bool is_true) { return is_true ? "yes" : "no"; }

/// The names in a folder as one text.
std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(name).append("/");
  return text;
}

std::string answer_to(const Recorder::Question& question, const Snapshot& files) {
  switch (question.kind) {
  case Recorder::Kind::content: return std::to_string(files.version(question.path));
  case Recorder::Kind::is_file: return yes_or_no(files.is_file(question.path));
  case Recorder::Kind::list: return std::to_string(files.list_version(question.path));
  case Recorder::Kind::is_denied: return yes_or_no(files.is_denied(question.path));
  case Recorder::Kind::identity: return files.identity(question.path);
  }
  return {};
}

}  // namespace

Snapshot::Known& Snapshot::know(const std::string& path) const {
  Known& known = known_[path];
  if (known.version != 0 && known.round == round_) return known;
  known.round = round_;
  FileStamp now = stamp_of_(path);
  const bool is_same = !now.text.empty() && known.stamp.is_settled && now.text == known.stamp.text;
  if (!is_same && (known.content || now.text.empty())) {
    compare(path, known);
  } else if (!is_same) {
    known.version = ++last_version_;
  }
  known.stamp = std::move(now);
  return known;
}

void Snapshot::compare(const std::string& path, Known& known) const {
  FileContent content = files_.read(path, kMostOfFile);
  const bool is_same = known.content && known.content->status == content.status &&
                       known.content->text == content.text &&
                       known.content->reason == content.reason;
  if (is_same) return;
  known.version = ++last_version_;
  keep(std::move(content), known);
}

void Snapshot::keep(FileContent content, Known& known) const {
  if (known.content) kept_bytes_ -= known.content->text.size();
  known.content.reset();
  const std::uint64_t size = content.text.size();
  if (content.status == ReadStatus::too_large || size > kMostOfFile) return;
  if (kept_bytes_ + size > kMostOfAll) return;
  known.content = std::move(content);
  kept_bytes_ += size;
}

std::uint64_t Snapshot::version(const std::string& path) const {
  const std::lock_guard lock(mutex_);
  return know(path).version;
}

/// One folder may contain thousands of models.
std::uint64_t Snapshot::list_version(const std::string& folder) const {
  const std::lock_guard lock(mutex_);
  KnownList& known = known_lists_[folder];
  if (known.version != 0 && known.round == round_) return known.version;
  known.round = round_;
  std::string now = joined(files_.list(folder));
  if (known.version != 0 && known.text == now) return known.version;
  known.text = std::move(now);
  return known.version = ++last_version_;
}

FileContent Snapshot::read(const std::string& path, std::uint64_t max_bytes) const {
  {
    const std::lock_guard lock(mutex_);
    const Known& known = know(path);
    if (known.content && known.content->text.size() <= max_bytes) return *known.content;
  }
  FileContent content = files_.read(path, max_bytes);
  const std::lock_guard lock(mutex_);
  keep(content, know(path));
  return content;
}

FileContent Recorder::read(const std::string& path, std::uint64_t max_bytes) const {
  note(Kind::content, path, std::to_string(files_.version(path)));
  return files_.read(path, max_bytes);
}

bool Recorder::is_file(const std::string& path) const {
  const bool answer = files_.is_file(path);
  note(Kind::is_file, path, yes_or_no(answer));
  return answer;
}

std::vector<std::string> Recorder::list(const std::string& folder) const {
  note(Kind::list, folder, std::to_string(files_.list_version(folder)));
  return files_.list(folder);
}

bool Recorder::is_denied(const std::string& path) const {
  const bool answer = files_.is_denied(path);
  note(Kind::is_denied, path, yes_or_no(answer));
  return answer;
}

std::string Recorder::identity(const std::string& path) const {
  std::string answer = files_.identity(path);
  note(Kind::identity, path, answer);
  return answer;
}

void Recorder::note(Kind kind, const std::string& path, std::string text) const {
  Answer& answer = answers_[{kind, path}];
  if (answer.count++ == 0) answer.text = std::move(text);
}

bool is_unchanged(const Recorder::Answers& answers, const Snapshot& files) {
  return std::all_of(answers.begin(), answers.end(), [&](const auto& known) {
    return answer_to(known.first, files) == known.second.text;
  });
}

bool is_of_source(const Recorder::Question& question, const Recorder::Answer& answer,
                  const SourceMap& sources) {
  if (question.kind != Recorder::Kind::content) return false;
  const std::string wanted = path::normalize(question.path);
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < sources.size(); ++i) count += sources.path(SourceId{i}) == wanted;
  return count == answer.count;
}

}  // namespace smurf
