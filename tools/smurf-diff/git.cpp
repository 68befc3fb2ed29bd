// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-diff/git.hpp"

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

#include "common/files/input.hpp"
#include "common/files/output.hpp"
#include "plan/models_around.hpp"
#include "render/printable.hpp"
#include "smurf-diff/versions.hpp"
#include "smurf/confine.hpp"

namespace smurf::tools {
namespace {

constexpr std::string_view kNothing = "/dev/null";

struct GitFile {
  std::string path;  ///< in the working tree
  std::string file;  ///< with the content; kNothing: there is none
  std::string mode;

  bool exists() const { return file != kNothing; }
  /// Neither a symbolic link nor a submodule.
  bool is_regular() const { return !exists() || mode.starts_with("100"); }
};

std::string indented(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (end > 0) out.append("  ").append(text.substr(0, end));
    out += '\n';
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return out;
}

/// The model that an annotation file is a part of; else the file itself.
std::string model_of(const std::string& path, const FileReader& files) {
  if (input_kind(path) != InputKind::annotation) return path;
  const std::vector<std::string> models = ModelsAround(files).listing(path);
  return models.empty() ? path : models.front();
}

std::string heading_of(const GitFile& before, const GitFile& after) {
  std::string heading = before.path;
  if (before.path != after.path) heading += " -> " + after.path;
  if (!before.exists()) heading += " (new)";
  if (!after.exists()) heading += " (deleted)";
  return render::escape(heading);
}

/// Colours for a terminal, or for the pager that git has started for a terminal.
TextStyle style_for_git(ColorChoice choice) {
  const char* has_pager = std::getenv("GIT_PAGER_IN_USE");
  const char* no_color = std::getenv("NO_COLOR");
  const bool is_wanted = has_pager != nullptr && (no_color == nullptr || *no_color == '\0');
  if (choice == ColorChoice::automatic && is_wanted) choice = ColorChoice::always;
  return style_for(Stream::output, choice);
}

class GitDiff {
 public:
  GitDiff(const Options& options, GitFile before, GitFile after)
      : options_(options), before_(std::move(before)), after_(std::move(after)) {
    const std::vector<std::string> inputs{before_.path, after_.path};
    confine(disk_, inputs, options.packages, options.allow_outside);
    for (const GitFile* one : {&before_, &after_}) {
      if (one->exists()) disk_.allow(one->file);
    }
  }

  ExitCode run() {
    TextStyle style = style_for_git(options_.color);
    style.width = 78;  // less than 80, because the text is indented
    const std::string text = heading_of(before_, after_) + "\n" + indented(body(style));
    write_output(kSmurfDiff, options_.output, text);  // users may quit a pager at any time
    return kDone;
  }

 private:
  std::string body(const TextStyle& style) {
    if (!before_.is_regular() || !after_.is_regular()) return "no file: not compared\n";
    const bool is_annotation = input_kind(after_.path) == InputKind::annotation;
    if (!is_annotation && (!before_.exists() || !after_.exists())) return "not compared\n";
    const auto old_text = read(before_);
    const auto new_text = read(after_);
    if (!old_text || !new_text) return "cannot be read\n";
    const std::string model = model_of(after_.path, disk_);
    const bool is_part = model != after_.path;
    InputVersion before{is_part ? model : before_.path, before_.path, before_.path, *old_text};
    InputVersion after{model, after_.path, after_.path, *new_text};
    Compared compared = compare_versions(session_, before, after, options_);
    if (is_part && !compared.is_known()) {  // another part of the model is broken
      before.path = before_.path;
      after.path = after_.path;
      compared = compare_versions(session_, before, after, options_);
    }
    const SourceMap& sources = session_.loaded_sources();
    std::string text = compared.is_known() ? render_diff(compared.differences, sources, style)
                                           : "cannot be compared\n";
    if (!compared.problem.empty()) text += render::escape(compared.problem) + "\n";
    for (const auto* findings : {&compared.trouble, &compared.remarks}) {
      for (const Diagnostic& one : *findings) text += render_concise(one, sources, style);
    }
    return text;
  }

  /// A missing annotation file is empty.
  std::optional<std::string> read(const GitFile& file) const {
    if (!file.exists()) return "";
    FileContent content = disk_.read(file.file, options_.limits.file_bytes);
    if (content.status != ReadStatus::ok) return std::nullopt;
    return std::move(content.text);
  }

  const Options& options_;
  GitFile before_, after_;
  ConfinedFiles disk_;
  Session session_{disk_, options_.limits};
};

}  // namespace

ExitCode compare_for_git(const Options& options) {
  const std::vector<std::string>& operands = options.operands;
  if (operands.size() == 1) {
    const std::string text = render::escape(operands[0]) + "\n  not merged\n";
    write_output(kSmurfDiff, options.output, text);
    return kDone;
  }
  const std::string& new_path = operands.size() > 7 ? operands[7] : operands[0];
  return GitDiff(options, {operands[0], operands[1], operands[3]},
                 {new_path, operands[4], operands[6]})
      .run();
}

}  // namespace smurf::tools
