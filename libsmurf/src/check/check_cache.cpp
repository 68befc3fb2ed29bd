// SPDX-License-Identifier: BSD-3-Clause
#include "check/check_cache.hpp"

#include <cstdlib>
#include <utility>

#include "base/files/places.hpp"
#include "base/files/system.hpp"
#include "base/numbers/bits.hpp"
#include "base/numbers/numbers.hpp"

namespace smurf {
namespace {

/// Values, one after the other, so that different ones have different texts.
class KeyText {
 public:
  void add(std::string_view value) {
    text_ += std::to_string(value.size());
    (text_ += ':') += value;
  }
  void add(const std::string& value) { add(std::string_view(value)); }
  void add(bool value) { text_ += value ? 'y' : 'n'; }
  void add(std::uint64_t value) { (text_ += std::to_string(value)) += ';'; }
  void add(double value) { add(bit_cast<std::uint64_t>(value)); }
  void add(Severity value) { add(static_cast<std::uint64_t>(value)); }
  void add(const Reader* value) { add(value->name); }
  template <class First, class Second>
  void add(const std::pair<First, Second>& pair) {
    add(pair.first);
    add(pair.second);
  }
  template <class List>
  void add_all(const List& list) {
    add(static_cast<std::uint64_t>(list.size()));
    for (const auto& one : list) add(one);
  }
  std::string take() { return std::move(text_); }

 private:
  std::string text_;
};

/// The bindings name all members: a new one does not compile until somebody decides whether results
/// depend on it.
void add_settings(const CheckSettings& settings, KeyText& key) {
  const auto& [config, is_isolated, formats, selection, packages, package_folders, xacro,
               opens_meshes, allows_outside, heeds_comments, heeds_baseline, baseline, jobs,
               max_seconds, remembers, folders, on_progress, is_cancelled] = settings;
  key.add(config);
  key.add(is_isolated);
  key.add_all(formats);
  const auto& [select, ignore, severities, targets, tolerances, paths] = selection;
  key.add_all(select);
  key.add_all(ignore);
  key.add_all(severities);
  key.add_all(targets);
  key.add_all(tolerances);
  key.add_all(packages);
  key.add_all(package_folders);
  const auto& [arguments, environment, needs_origins] = xacro;
  key.add_all(arguments);
  key.add(static_cast<std::uint64_t>(environment.size()));
  for (const std::string& name : environment) {
    const char* const value = std::getenv(name.c_str());
    key.add(name);
    key.add(value != nullptr);
    key.add(std::string_view(value == nullptr ? "" : value));
  }
  key.add(needs_origins);
  key.add(opens_meshes);
  key.add(allows_outside);
  key.add(heeds_comments);
  key.add(heeds_baseline);
  key.add(baseline);
  key.add(max_seconds);
}

void add_planned(const PlannedFile& planned, KeyText& key) {
  const auto& [path, config, may_be_part, is_named, is_helper, arguments] = planned;
  key.add(path);
  key.add(std::uint64_t{config});
  key.add(may_be_part);
  key.add(is_named);
  key.add(is_helper);
  key.add(arguments != nullptr);
  if (arguments == nullptr) return;
  const auto& [values, shown] = *arguments;
  key.add_all(values);
  key.add(shown);
}

// Fields of a line are separated by tabs.
void append_field(std::string_view field, std::string& line) {
  for (const char c : field) {
    switch (c) {
    case '\t': line += "\x01t"; break;
    case '\n': line += "\x01n"; break;
    case '\x01': line += "\x01\x01"; break;
    default: line += c;
    }
  }
  line += '\t';
}

/// Takes the next field; none at the end, or if there is something else.
std::optional<std::string> take_field(std::string_view& line) {
  const std::size_t end = line.find('\t');
  if (end == std::string_view::npos) return std::nullopt;
  std::string_view left = line.substr(0, end);
  line.remove_prefix(end + 1);
  std::string field;
  std::size_t escape = 0;
  while ((escape = left.find('\x01')) != std::string_view::npos && escape + 1 < left.size()) {
    const char next = left[escape + 1];
    (field += left.substr(0, escape)) += next == 't' ? '\t' : next == 'n' ? '\n' : '\x01';
    left.remove_prefix(escape + 2);
  }
  return field += left;
}

std::string line_of(const std::vector<AskedPath>& asked, std::string_view answer) {
  std::string line;
  append_field(answer, line);
  for (const AskedPath& one : asked) {
    append_field(one.path, line);
    append_field(one.stamp.place, line);
    append_field(one.stamp.text, line);
    std::string questions;
    for (const AskedQuestion& question : one.questions) {
      questions += static_cast<char>(question.kind);
      questions += std::to_string(question.max_bytes) + '=' + question.answer + ' ';
    }
    append_field(questions, line);
  }
  return line;
}

bool read_questions(std::string_view text, std::vector<AskedQuestion>& questions) {
  while (!text.empty()) {
    const std::size_t equals = text.find('='), end = text.find(' ');
    if (equals == text.npos || end == text.npos || equals == 0 || end < equals + 2) return false;
    AskedQuestion& question = questions.emplace_back();
    question.kind = static_cast<AskedKind>(text[0]);
    const auto bytes = parse_integer(text.substr(1, equals - 1));
    if (!bytes || *bytes < 0 || std::string_view("cfldi").find(text[0]) == text.npos) return false;
    question.max_bytes = static_cast<std::uint64_t>(*bytes);
    question.answer = text.substr(equals + 1, end - equals - 1);
    text.remove_prefix(end + 1);
  }
  return true;
}

/// None if the line is no line of a cache.
std::optional<std::vector<AskedPath>> read_asked(std::string_view line) {
  std::vector<AskedPath> asked;
  while (!line.empty()) {
    auto path = take_field(line), place = take_field(line), stamp = take_field(line),
         questions = take_field(line);
    if (!questions) return std::nullopt;
    AskedPath& one = asked.emplace_back();
    one.path = *std::move(path);
    one.stamp = {*std::move(place), *std::move(stamp)};
    if (!read_questions(*questions, one.questions)) return std::nullopt;
  }
  return asked;
}

}  // namespace

CheckCache::CheckCache(const std::string& folder, const std::string& form,
                       const CheckSettings& settings, const Limits& limits) {
  const std::string program = sys::program_identity();
  if (program.empty()) {
    problem_ = "this program cannot be told from other versions of it";
    return;
  }
  if (!settings.selection.paths.empty()) {
    problem_ = "the settings have functions, which cannot be compared";
    return;
  }
  KeyText key;
  key.add(program);
  key.add(form);
  add_settings(settings, key);
  static_assert(sizeof(Limits) == kLimits.size() * sizeof(std::uint64_t));
  for (const LimitInfo& limit : kLimits) key.add(limits.*limit.value);
  key.add(places::absolute("."));
  common_ = key.take();
  constexpr std::size_t kBytesOfName = 8;
  file_.emplace(folder, hex_of(digest_of(program), kBytesOfName) + ".smurf-checks");
}

Digest CheckCache::key_of(const Plan& plan, const std::string& scope) const {
  KeyText key;
  key.add(common_);
  key.add(scope);
  const auto& [scenes, models, others, companions, configs, problems] = plan;
  for (const auto* planned : {&scenes, &models, &others, &companions}) {
    key.add(static_cast<std::uint64_t>(planned->size()));
    for (const PlannedFile& one : *planned) add_planned(one, key);
  }
  key.add_all(configs);
  key.add_all(problems);
  return digest_of(key.take());
}

std::optional<std::string> CheckCache::find(const Digest& key, const FileReader& files,
                                            const std::string& scope) {
  const std::optional<std::string> line = file_ ? file_->find(key) : std::nullopt;
  if (!line) return std::nullopt;
  std::string_view left = *line;
  std::optional<std::string> answer = take_field(left);
  std::optional<std::vector<AskedPath>> asked = read_asked(left);
  if (!answer || !asked) return std::nullopt;
  const AskedAgain again = ask_again(*asked, files, lists_, scope);
  if (again == AskedAgain::other) return std::nullopt;
  if (again == AskedAgain::same_with_new_stamps) add(key, *asked, *answer);
  return answer;
}

void CheckCache::add(const Digest& key, const std::vector<AskedPath>& asked,
                     std::string_view answer) {
  if (file_) file_->add(key, line_of(asked, answer));
}

std::string CheckCache::problem() const {
  return !problem_.empty() || !file_ ? problem_ : file_->problem();
}

}  // namespace smurf
