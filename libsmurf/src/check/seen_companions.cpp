// SPDX-License-Identifier: BSD-3-Clause
#include "check/seen_companions.hpp"

#include <algorithm>

#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "link/companions/library.hpp"
#include "plan/companion_robots.hpp"
#include "syntax/yaml_reader.hpp"

namespace smurf {
namespace {

constexpr std::size_t kMostHelpers = 24;

}  // namespace

void SeenCompanions::read(const Plan& plan) {
  for (const auto* robots : {&plan.models, &plan.others}) {
    for (const PlannedFile& one : *robots) {
      if (!one.is_named || is_companion_path(one.path)) continue;
      named_robots_.insert(id_of(one.path));
      near_ += one.path + "\n";
    }
  }
  const auto add = [&](const PlannedFile& one) {
    const SeenCompanion& seen = search_.companions->look_at(one.path, context_.files);
    if (seen.what.spec == nullptr) return;
    near_ += one.path + (one.is_named ? "\t\n" : "\n");
    files_.emplace(id_of(one.path), File{one, &seen});
  };
  for (const PlannedFile& one : plan.companions) add(one);
  // An SRDF is checked alone as well, if no robot has it.
  for (const PlannedFile& one : plan.others) {
    if (is_companion_path(one.path)) add(one);
  }
  tell(*search_.companions);
}

void SeenCompanions::tell(CompanionLibrary& library) const {
  library.named_robots = named_robots_;
  library.near.clear();
  for (const auto& [id, file] : files_) {
    library.near.push_back({file.planned.path, file.planned.is_named});
  }
}

void SeenCompanions::add_rejected(const std::string& file, const RejectedCompanion& one) {
  const auto [known, is_new] = rejected_.emplace(file, one);
  if (!is_new && known->second.known_names < one.known_names) known->second = one;
}

bool SeenCompanions::is_open(const std::string& id, const File& file,
                             const std::set<std::string>& known) const {
  return !known.contains(id) && !file.seen->what.spec->is_xml &&
         file.seen->what.state != CompanionState::a_template;
}

std::vector<PlannedFile>
SeenCompanions::helpers(const std::set<std::string>& known,
                        const std::vector<std::vector<CompanionTie>>& ties) const {
  std::vector<PlannedFile> found;
  std::set<std::string> seen = known;
  CompanionRobots robots(context_.files, context_.limits);
  for (const auto& [id, file] : files_) {
    if (!is_open(id, file, known)) continue;
    for (const std::string& path :
         robots.of(file.planned.path, *file.seen, ties[file.planned.config])) {
      if (found.size() >= kMostHelpers || !seen.insert(id_of(path)).second) continue;
      PlannedFile& helper = found.emplace_back();
      helper.path = path;
      helper.config = file.planned.config;
      helper.may_be_part = xacro::is_xacro_file(path);
      helper.is_helper = true;
    }
  }
  return found;
}

NotCompared SeenCompanions::judge(const std::string& id, const File& file,
                                  const std::vector<std::string>& likely,
                                  const std::string& near) const {
  NotCompared one{file.planned.path, file.seen->what.spec->title, "", ""};
  const std::string tie = "tie it to its robot with `companions` in .smurf-lint.yaml";
  const auto rejected = rejected_.find(id);
  if (file.seen->what.state == CompanionState::a_template) {
    one.reason = "it is a template, which a launch file fills in";
    one.next = "name the file that is made of it";
  } else if (!likely.empty()) {
    const std::string& robot = likely.front();
    one.reason = likely.size() == 1 ? quoted(robot) + " could not be expanded here"
                                    : counted(likely.size(), "robot") + ", such as " +
                                          quoted(robot) + ", could not be expanded here";
    one.next = "--min-severity info says what each of them needs";
  } else if (rejected != rejected_.end() && rejected->second.names > 0) {
    const RejectedCompanion& best = rejected->second;
    one.reason = best.known_names == 0
                     ? (best.names == 1 ? std::string("its only name")
                                        : "none of its " + counted(best.names, "name")) +
                           (best.names == 1 ? " is not known here" : " is known here")
                     : "no robot here has more than " + std::to_string(best.known_names) +
                           " of its " + counted(best.names, "name");
    one.next = tie;
  } else if (!near.empty()) {
    one.reason = file.seen->what.spec->is_xml
                     ? "it describes neither " + quoted(near) + " nor another robot here"
                 : file.seen->names.empty()
                     ? "it names no joint, and no SRDF beside it belongs to a robot here"
                     : quoted(near) + " has no links with which to compare it";
    one.next = tie;
  } else {
    one.reason = "no robot was found in its package, or in a package that names this one in its "
                 "package.xml";
    one.next = "name the robot as well, or " + tie;
  }
  return one;
}

void SeenCompanions::report_broken(const std::set<std::string>& known, SourceMap& sources,
                                   std::vector<Judged>& found) {
  for (const auto& [id, file] : files_) {
    if (file.seen->what.state != CompanionState::broken || known.contains(id)) continue;
    const FileContent content = context_.files.read(file.planned.path, context_.limits.file_bytes);
    if (content.status != ReadStatus::ok) continue;
    const SourceId source = sources.add(file.planned.path, content.text);
    DiagnosticSink sink(context_.limits);
    parse_yaml(sources, source, context_.limits, sink);
    append(sink.take(), found[file.planned.config].diagnostics);
    broken_.insert(id);
  }
}

void SeenCompanions::report_misspelt(const std::set<std::string>& known,
                                     const std::vector<std::vector<CompanionTie>>& ties,
                                     SourceMap& sources, std::vector<Judged>& found) const {
  if (unknown_robots_.empty()) return;
  CompanionRobots robots(context_.files, context_.limits);
  std::set<std::string> unknown;
  for (const std::string& one : unknown_robots_) unknown.insert(id_of(one));
  for (const auto& [id, file] : files_) {
    if (!is_open(id, file, known) || file.seen->names.empty()) continue;
    const std::string& path = file.planned.path;
    std::vector<std::string> likely = robots.of(path, *file.seen, ties[file.planned.config]);
    std::erase_if(likely, [&](const std::string& one) { return !unknown.contains(id_of(one)); });
    const MisspeltNames misspelt = find_misspelt(path, *file.seen, likely, robots);
    if (misspelt.names.empty()) continue;
    const FileContent content = context_.files.read(path, context_.limits.file_bytes);
    if (content.status != ReadStatus::ok) continue;
    Companion companion;
    companion.kind = file.seen->what.spec->kind;
    companion.source = sources.add(path, content.text);
    DiagnosticSink ignored(context_.limits), sink(context_.limits);
    companion.document = parse_yaml(sources, companion.source, context_.limits, ignored);
    report_written(companion, misspelt, sink);
    append(sink.take(), found[file.planned.config].diagnostics);
  }
}

std::vector<NotCompared>
SeenCompanions::not_compared(const std::set<std::string>& known,
                             const std::vector<std::vector<CompanionTie>>& ties) const {
  std::vector<NotCompared> found;
  CompanionRobots robots(context_.files, context_.limits);
  std::set<std::string> unknown;
  for (const std::string& one : unknown_robots_) unknown.insert(id_of(one));
  for (const auto& [id, file] : files_) {
    if (known.contains(id) || broken_.contains(id)) continue;
    std::vector<std::string> likely;
    if (!unknown.empty()) {
      likely = robots.of(file.planned.path, *file.seen, ties[file.planned.config]);
      std::erase_if(likely, [&](const std::string& one) { return !unknown.contains(id_of(one)); });
    }
    found.push_back(judge(id, file, likely, robots.near(file.planned.path)));
  }
  std::sort(found.begin(), found.end(),
            [](const NotCompared& a, const NotCompared& b) { return a.path < b.path; });
  return found;
}

}  // namespace smurf
