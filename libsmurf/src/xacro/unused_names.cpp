// SPDX-License-Identifier: BSD-3-Clause
// Names that the file of a robot defines, and that nothing uses.
#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "base/findings/rules.hpp"
#include "base/text/counted.hpp"
#include "base/text/quoted.hpp"
#include "xacro/expander.hpp"
#include "xacro/whole_word.hpp"

namespace smurf::xacro {
namespace {

enum class Defined : std::uint8_t { macro, parameter, property, argument };
constexpr std::array<std::string_view, 4> kTitles = {"macro", "parameter", "property", "argument"};

struct Definition {
  Defined kind{};
  std::string_view name;
  Span place;  ///< the value of the attribute
};

/// "radius:=1" as `radius`, "*block" as `block`
std::string_view parameter_name(std::string_view written) {
  while (written.starts_with('*')) written.remove_prefix(1);
  const auto end = std::find_if_not(written.begin(), written.end(), is_of_name);
  return written.substr(0, static_cast<std::size_t>(end - written.begin()));
}

void collect(const Node& node, std::vector<Definition>& all) {
  const NodeAttribute* name = node.attribute("name");
  if (name != nullptr && node.name.starts_with("xacro:")) {
    const std::string_view element = node.name.substr(6);
    const Definition one{{}, name->text.value, name->text.whole.use};
    if (element == "property") all.push_back({Defined::property, one.name, one.place});
    if (element == "arg") all.push_back({Defined::argument, one.name, one.place});
    if (element == "macro") all.push_back({Defined::macro, one.name, one.place});
    const NodeAttribute* parameters = node.attribute("params");
    if (element == "macro" && parameters != nullptr) {
      const std::string_view text = parameters->text.value;
      // A default may contain blanks and names; its words are taken for parameters only if they
      // are found nowhere, and then they are none.
      for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \t\r\n", at), text.size());
        const std::string_view written = text.substr(at, end - at);
        at = end + 1;
        if (written.find_first_of("'\"") != std::string_view::npos) break;
        if (written.ends_with(',')) continue;  // SML3411
        const std::string_view word = parameter_name(written);
        if (!word.empty()) all.push_back({Defined::parameter, word, parameters->text.whole.use});
      }
    }
  }
  for (const Node* child : node.children) {
    if (child->kind == NodeKind::element) collect(*child, all);
  }
}

/// Where a name is defined as one kind of thing, and whether something uses it.
struct Use {
  std::map<std::pair<SourceId, std::uint32_t>, std::uint32_t> places;  ///< begin and end
  bool is_used = false;

  bool defines(SourceId source, std::size_t begin, std::size_t end) const {
    auto after = places.upper_bound({source, static_cast<std::uint32_t>(begin)});
    if (after == places.begin()) return false;
    --after;
    return after->first.first == source && end <= after->second;
  }
};

/// The names that are defined, and their uses in texts.
class Uses {
 public:
  explicit Uses(const std::vector<Definition>& all) {
    for (const Definition& one : all) {
      const bool is_computed = one.name.find('$') != std::string_view::npos;
      if (one.name.empty() || is_computed) continue;
      const auto [found, is_new] = names_.try_emplace(one.name);
      if (is_new) add(one.name);
      auto& use = found->second[static_cast<std::size_t>(one.kind)];
      if (!use) {
        use.emplace();
        ++unused_;
      }
      std::uint32_t& end = use->places[{one.place.source, one.place.begin}];
      end = std::max(end, one.place.end);
    }
  }

  bool has_unused() const { return unused_ > 0; }
  bool is_unused(const Definition& one) const {
    const auto found = names_.find(one.name);
    if (found == names_.end()) return false;
    const auto& use = found->second[static_cast<std::size_t>(one.kind)];
    return use && !use->is_used;
  }

  void mark_all(std::string_view text, SourceId source) {
    const char* const stop = text.data() + text.size();
    for (const char* at = text.data(); at < stop;) {
      const char* const begin = at;
      while (at < stop && kIsOfName[static_cast<unsigned char>(*at)]) ++at;
      const auto size = static_cast<std::size_t>(at - begin);
      if (size > 0 && may_be_name(*begin, size) && words_[hash({begin, size})]) {
        const auto place = static_cast<std::size_t>(begin - text.data());
        mark(text, source, place, place + size);
        if (!has_unused()) return;
      }
      ++at;
    }
    mark_odd_names(text, source);
  }

 private:
  static constexpr std::size_t kHashes = 4096;
  /// Few of the words of a file are names: these tell most others apart for little.
  static std::uint32_t bit_of(std::size_t size) {
    return std::uint32_t{1} << std::min<std::size_t>(size, 31);
  }
  bool may_be_name(char first, std::size_t size) const {
    return (sizes_[static_cast<unsigned char>(first)] & bit_of(size)) != 0;
  }
  static std::size_t hash(std::string_view word) {
    const auto letter = [&](std::size_t at) { return static_cast<unsigned char>(word[at]); };
    return (letter(0) * 5U + letter(word.size() / 2) * 67U + letter(word.size() - 1) * 331U +
            word.size() * 1021U) %
           kHashes;
  }
  static constexpr auto kIsOfName = [] {
    std::array<bool, 256> table{};
    for (std::size_t c = 0; c < table.size(); ++c) table[c] = is_of_name(static_cast<char>(c));
    return table;
  }();

  void add(std::string_view name) {
    if (std::all_of(name.begin(), name.end(), is_of_name)) {
      words_.set(hash(name));
      sizes_[static_cast<unsigned char>(name.front())] |= bit_of(name.size());
    } else {
      odd_.push_back(name);
    }
  }

  /// A name that occurs as a word, which is no name of an attribute.
  void mark(std::string_view text, SourceId source, std::size_t begin, std::size_t end) {
    const auto found = names_.find(text.substr(begin, end - begin));
    if (found == names_.end()) return;
    const std::size_t next = std::min(text.find_first_not_of(" \t\r\n", end), text.size());
    if (text.substr(next, 1) == "=" && text.substr(next, 2) != "==") return;
    for (auto& use : found->second) {
      if (!use || use->is_used || use->defines(source, begin, end)) continue;
      use->is_used = true;
      --unused_;
    }
  }

  /// Names with characters that are not of words are searched one by one.
  void mark_odd_names(std::string_view text, SourceId source) {
    constexpr std::size_t kMost = 200;  // each costs a pass over the file
    for (std::size_t i = 0; i < odd_.size(); ++i) {
      const std::string_view name = odd_[i];
      auto& kinds = names_.at(name);
      const auto is_open = [&] {
        return std::any_of(kinds.begin(), kinds.end(),
                           [](const auto& use) { return use && !use->is_used; });
      };
      for (auto& use : kinds) {
        if (!use || use->is_used || i < kMost) continue;
        use->is_used = true;  // not known
        --unused_;
      }
      for (std::size_t at = is_open() ? find_name(text, name) : text.npos;
           at != text.npos && is_open(); at = find_name(text, name, at + 1)) {
        mark(text, source, at, at + name.size());
      }
    }
  }

  std::unordered_map<std::string_view, std::array<std::optional<Use>, kTitles.size()>> names_;
  std::size_t unused_ = 0;
  std::bitset<kHashes> words_;
  std::array<std::uint32_t, 256> sizes_{};  ///< of names, by their first letter
  std::vector<std::string_view> odd_;
};

}  // namespace

/// Only in the file of a robot: libraries have names for others.
void Expander::check_unused(const Node& in, const Node& out) {
  const bool is_robot = std::any_of(out.children.begin(), out.children.end(),
                                    [](const Node* child) { return child->name == "link"; });
  if (!is_robot || has_failed_) return;
  std::vector<Definition> all;
  collect(in, all);
  Uses uses(all);
  // Most names are used in the file that defines them.
  if (uses.has_unused()) uses.mark_all(context_.sources.text(result_.root), result_.root);
  for (const auto& [path, file] : files_) {
    if (!uses.has_unused()) return;
    if (file->source != result_.root) {
      uses.mark_all(context_.sources.text(file->source), file->source);
    }
  }
  for (std::size_t kind = 0; kind < kTitles.size(); ++kind) {
    std::set<std::string_view> seen;
    Diagnostic* first = nullptr;
    std::string others;
    for (const Definition& one : all) {
      if (static_cast<std::size_t>(one.kind) != kind || !seen.insert(one.name).second) continue;
      if (!uses.is_unused(one)) continue;
      if (first != nullptr) {
        others += (others.empty() ? "" : ", ") + quoted(one.name);
        continue;
      }
      first = &context_.sink.report(rules::sml3413_xacro_unused_name, one.place,
                                    "nothing uses the " + std::string(kTitles[kind]) + " " +
                                        quoted(one.name));
      first->help("delete it");
    }
    if (!others.empty()) first->note("this also applies to " + shortened(others, 200));
  }
}

}  // namespace smurf::xacro
