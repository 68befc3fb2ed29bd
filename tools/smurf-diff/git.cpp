// SPDX-License-Identifier: BSD-3-Clause
#include "smurf-diff/git.hpp"

#include <utility>

#include "common/input.hpp"
#include "common/models_around.hpp"
#include "common/output.hpp"
#include "render/printable.hpp"
#include "smurf-diff/versions.hpp"
#include "smurf/confine.hpp"

namespace smurf::tools {
namespace {

constexpr std::string_view kTool = "smurf-diff";
constexpr std::string_view kNothing = "/dev/null";

struct GitFile {
  std::string path;  ///< in the working tree
  std::string file;  ///< with the content; kNothing: there is none
  std::string mode;

  bool exists() const { return file != kNothing; }
  /// No symbolic link and no submodule.
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
    const TextStyle style = style_for(Stream::output, options_.color);
    const std::string text = heading_of(before_, after_) + "\n" + indented(body(style));
    return write_output(kTool, options_.output, text) ? kDone : kFailed;
  }

 private:
  std::string body(const TextStyle& style) {
    if (!before_.is_regular() || !after_.is_regular()) return "no file: not compared\n";
    if (!before_.exists() || !after_.exists()) return "as a whole\n";
    const FileContent old_content = disk_.read(before_.file, options_.limits.file_bytes);
    const FileContent new_content = disk_.read(after_.file, options_.limits.file_bytes);
    for (const FileContent* one : {&old_content, &new_content}) {
      if (one->status != ReadStatus::ok) return "cannot be read: it " + one->reason + "\n";
    }
    const std::string model = model_of(after_.path, disk_);
    const bool is_part = model != after_.path;
    const Version before{is_part ? model : before_.path, before_.path, before_.path,
                         old_content.text};
    const Version after{model, after_.path, after_.path, new_content.text};
    const Compared compared = compare_versions(session_, before, after, options_);
    if (compared.is_known()) {
      return render_diff(compared.differences, session_.loaded_sources(), style);
    }
    std::string text = "cannot be compared\n" + compared.problem;
    for (const Diagnostic& finding : compared.trouble) {
      text += render_concise(finding, session_.loaded_sources(), style);
    }
    return text;
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
    return write_output(kTool, options.output, text) ? kDone : kFailed;
  }
  const std::string& new_path = operands.size() > 7 ? operands[7] : operands[0];
  return GitDiff(options, {operands[0], operands[1], operands[3]},
                 {new_path, operands[4], operands[6]})
      .run();
}

}  // namespace smurf::tools
