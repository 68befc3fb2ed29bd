// SPDX-License-Identifier: BSD-3-Clause
// Our readers find the parts of a file; mutations are byte edits there. So most mutated models can
// still be read, and the code after the readers is tested, too. libFuzzer mutates unreadable bytes,
// and every third input.
#include "fuzz/mutator.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <optional>

#include "fuzz/parts.hpp"
#include "fuzz/xacro_changes.hpp"

namespace smurf::test {
namespace {

// Replacements for numbers, names, paths and values.
constexpr std::string_view kNasty[] = {
    "nan",  "-inf",  ".nan", "1e400",      "-1e308",      "1e-400",     "-0",
    "0x10", "1,5",   "1.5.", "٣",          "−1",          "1e18",       "4294967296",
    "+1",   "1_000", "0o17", "2147483648", "-2147483649", "1kg",        "18446744073709551616",
    "",     "~",     "true", "[]",         "{}",          "parent",     "a::b",
    "..",   "/",     "*",    "é",          "&amp;",       "1 2 3 4 5 6"};

class Mutation {
 public:
  Mutation(const std::string& bundle, const std::string& other, Random& random)
      : text_(bundle), here_(bundle), there_(other), random_(random) {}

  /// None if the random change does not fit the random part.
  std::optional<std::string> run() {
    if (here_.parts.empty()) return std::nullopt;
    using Change = bool (Mutation::*)();
    static constexpr Change kChanges[] = {
        &Mutation::remove,      &Mutation::repeat,    &Mutation::swap,      &Mutation::swap,
        &Mutation::graft,       &Mutation::graft,     &Mutation::rename,    &Mutation::take_value,
        &Mutation::take_value,  &Mutation::take_name, &Mutation::take_name, &Mutation::take_file,
        &Mutation::put_nasty,   &Mutation::put_nasty, &Mutation::refer,     &Mutation::wrap,
        &Mutation::change_files};
    if (!(this->*kChanges[random_.below(std::size(kChanges))])()) return std::nullopt;
    return text_;
  }

 private:
  using Test = std::function<bool(const Part&)>;

  /// A random item that passes the test; null if none was found.
  const Part* draw(const Parts& from, const Test& test) {
    for (int tries = 0; tries < 30 && !from.parts.empty(); ++tries) {
      const Part& part = from.parts[random_.below(from.parts.size())];
      if (test(part)) return &part;
    }
    return nullptr;
  }
  const Part& any() { return here_.parts[random_.below(here_.parts.size())]; }
  const Parts& anywhere() { return random_.one_in(2) ? here_ : there_; }
  const Part* with_value() {
    return draw(here_, [](const Part& part) { return !part.value.empty(); });
  }

  void replace(Range range, std::string_view by) {
    text_.replace(range.begin, range.end - range.begin, by);
  }

  /// Removes a part from a list or mapping, with its separator.
  bool remove() {
    const Part& part = any();
    Range range = part.whole;
    if (part.is_flow) {
      const std::size_t next = text_.find_first_not_of(kBlanks, range.end);
      if (next != std::string::npos && text_[next] == ',') range.end = next + 1;
    }
    replace(range, "");
    return true;
  }

  /// Indents a part, as returned by `Parts::dedented`, to a column; not its first line.
  static std::string indented(std::string part, std::size_t column) {
    const std::string line = "\n" + std::string(column, ' ');
    for (std::size_t at = part.find('\n'); at != std::string::npos;
         at = part.find('\n', at + line.size())) {
      part.replace(at, 1, line);
    }
    return part;
  }

  /// Inserts a part, as returned by `Parts::dedented`, after a part of the same kind.
  bool put_behind(const Part& place, const std::string& part) {
    const bool has_lines = part.find('\n') != std::string::npos;
    if (place.is_flow && has_lines) return false;
    const std::size_t column = here_.column(place.whole.begin);
    const std::string separator = place.kind == PartKind::element     ? ""
                                  : place.kind == PartKind::attribute ? " "
                                  : place.is_flow                     ? ", "
                                                  : "\n" + std::string(column, ' ');
    text_.insert(place.whole.end, separator + indented(part, column));
    return true;
  }

  bool repeat() {
    const Part& part = any();
    const std::string copy = here_.dedented(part);
    const bool is_often = random_.one_in(8) && copy.size() < 100;
    for (std::size_t times = is_often ? 200 : 1 + random_.below(2); times > 0; --times) {
      if (!put_behind(part, copy)) return false;
    }
    return true;
  }

  bool graft() {
    const Parts& from = anywhere();
    const Part& place = any();
    const Part* part = draw(from, [&](const Part& one) { return one.kind == place.kind; });
    if (part == nullptr) return false;
    const std::string copy = from.dedented(*part);
    const Range old = part->whole;
    const bool is_apart = old.begin >= place.whole.end || old.end <= place.whole.begin;
    const bool is_moved = &from == &here_ && is_apart && random_.one_in(2);
    if (is_moved && old.end > place.whole.end) replace(old, "");
    if (!put_behind(place, copy)) return false;
    if (is_moved && old.end <= place.whole.begin) replace(old, "");
    return true;
  }

  bool swap() {
    const Part& one = any();
    const bool only_values = random_.one_in(2);
    const Part* other = draw(here_, [&](const Part& part) {
      if (part.kind != one.kind || part.is_flow != one.is_flow) return false;
      return !only_values || here_.at(part.name) == here_.at(one.name);
    });
    if (other == nullptr) return false;
    const bool is_first = one.whole.begin < other->whole.begin;
    const Part* left = is_first ? &one : other;
    const Part* right = is_first ? other : &one;
    const Range a = only_values ? left->value : left->whole;
    const Range b = only_values ? right->value : right->whole;
    if (a.end > b.begin || a.empty() || b.empty()) return false;
    const auto of = [&](const Part& part, const Part& place) {
      return only_values ? std::string(here_.at(part.value))
                         : indented(here_.dedented(part), here_.column(place.whole.begin));
    };
    replace(b, of(*left, *right));
    replace(a, of(*right, *left));
    return true;
  }

  bool rename() {
    const Part* part = draw(here_, [](const Part& one) { return !one.name.empty(); });
    const Parts& from = anywhere();
    const Part* other = draw(from, [](const Part& one) { return !one.name.empty(); });
    if (part == nullptr || other == nullptr) return false;
    const std::string name(from.at(other->name));
    if (part->kind == PartKind::element) {
      const Range end_tag{part->whole.end - 1 - (part->name.end - part->name.begin),
                          part->whole.end - 1};
      if (here_.at(end_tag) == here_.at(part->name)) replace(end_tag, name);
    }
    replace(part->name, name);
    return true;
  }

  bool take(const Part* place, const Parts& from, const Part* part) {
    if (place == nullptr || part == nullptr) return false;
    const std::string value(from.at(part->value));
    replace(place->value, value);
    return true;
  }

  bool take_value() {
    const Part* place = with_value();
    const Parts& from = anywhere();
    return take(place, from, draw(from, [](const Part& part) { return !part.value.empty(); }));
  }

  /// Replaces a name by the name of another thing, possibly of another kind.
  bool take_name() {
    const Part* place = with_value();
    const Parts& from = anywhere();
    return take(place, from, draw(from, [&](const Part& part) {
                  return !part.value.empty() &&
                         from.at(part.name).find("name") != std::string::npos;
                }));
  }

  /// Replaces a file name by one of the bundle, so that files name each other or themselves.
  bool take_file() {
    const Part* place = draw(here_, [&](const Part& part) {
      const std::string_view value = here_.at(part.value);
      return value.size() < 200 && value.find('.') != std::string_view::npos &&
             value.find_first_not_of("0123456789.- ") != std::string_view::npos;
    });
    if (place == nullptr) return false;
    const Range name = here_.files[random_.below(here_.files.size())].name;
    const std::string value(here_.at(name));
    replace(place->value, value);
    return true;
  }

  /// Replaces a value, or one number in it.
  bool put_nasty() {
    const Part* place = with_value();
    if (place == nullptr) return false;
    const std::string_view value = here_.at(place->value);
    Range range = place->value;
    if (value.find_first_of("<\n") == std::string_view::npos) {
      const std::size_t blank = value.find(' ', random_.below(value.size()));
      if (blank != std::string_view::npos) {
        range.begin += blank + 1;
        range.end = place->value.begin + std::min(value.find(' ', blank + 1), value.size());
      }
    }
    replace(range, kNasty[random_.below(std::size(kNasty))]);
    return true;
  }

  /// Inserts an anchor, and an alias after it or in it.
  bool refer() {
    const Part* anchored = draw(here_, [](const Part& part) {
      return part.kind == PartKind::member && !part.value.empty();
    });
    if (anchored == nullptr) return false;
    const Part* alias = draw(here_, [&](const Part& part) {
      const bool is_yaml = part.kind == PartKind::member || part.kind == PartKind::item;
      return is_yaml && part.file == anchored->file && !part.value.empty() &&
             part.value.begin > anchored->value.begin;
    });
    const std::size_t colon = text_.find(':', anchored->name.end);
    if (alias == nullptr || colon >= alias->value.begin) return false;
    replace(alias->value, "*m");
    text_.insert(colon + 1, " &m");
    return true;
  }

  /// Wraps a value in a list or a mapping, or an element in an element of the same name.
  bool wrap() {
    const Part& part = any();
    if (part.kind == PartKind::attribute) return false;
    if (part.kind == PartKind::element) {
      const std::string name(here_.at(part.name));
      text_.insert(part.whole.end, "</" + name + ">");
      text_.insert(part.whole.begin, "<" + name + ">");
      return true;
    }
    const std::string_view value = here_.at(part.value);
    if (value.empty() || value.find('\n') != std::string_view::npos) return false;
    const bool is_list = random_.one_in(2);
    text_.insert(part.value.end, is_list ? "]" : "}");
    text_.insert(part.value.begin, is_list ? "[" : "{name: ");
    return true;
  }

  /// Two files exchange their contents or their names, or one file is renamed.
  bool change_files() {
    const std::size_t count = here_.files.size();
    if (count < 2) return false;
    const std::size_t first = random_.below(count - 1);
    const File& a = here_.files[first];
    const File& b = here_.files[first + 1 + random_.below(count - first - 1)];
    const std::string name(here_.at(a.name));
    const std::string text(here_.at(a.text));
    switch (random_.below(3)) {
    case 0:
      if (b.name.empty()) return false;
      replace(b.name, name);
      return true;
    case 1: replace(b.text, text); return true;
    default:
      const std::string other(here_.at(b.text));
      replace(b.text, text);
      replace(a.text, other);
      return true;
    }
  }

  std::string text_;
  Parts here_;  ///< from the text before the change
  Parts there_;
  Random& random_;
};

}  // namespace

std::string mutated_bundle(const std::string& bundle, const std::string& other, std::size_t most,
                           Random& random) {
  std::string result = bundle;
  for (std::size_t changes = 1 + random.below(3); changes > 0; --changes) {
    std::string xacro = result;
    if (random.one_in(2) && XacroChange(xacro, random).run()) {
      if (xacro.size() <= most) result = std::move(xacro);
      continue;
    }
    auto changed = Mutation(result, other, random).run();
    if (changed && changed->size() <= most) result = std::move(*changed);
  }
  return result;
}

}  // namespace smurf::test

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned seed) {
  static const bool only_bytes = std::getenv("SMURF_FUZZ_BYTES") != nullptr;
  smurf::test::Random random(seed);
  const std::string bundle(reinterpret_cast<const char*>(data), size);
  if (only_bytes || random.one_in(3)) return LLVMFuzzerMutate(data, size, most);
  const std::string result = smurf::test::mutated_bundle(bundle, bundle, most, random);
  if (result == bundle) return LLVMFuzzerMutate(data, size, most);
  std::copy(result.begin(), result.end(), data);
  return result.size();
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* data, std::size_t size,
                                                 const std::uint8_t* other, std::size_t other_size,
                                                 std::uint8_t* out, std::size_t most,
                                                 unsigned seed) {
  smurf::test::Random random(seed);
  const std::string result =
      smurf::test::mutated_bundle({reinterpret_cast<const char*>(data), size},
                                  {reinterpret_cast<const char*>(other), other_size}, most, random);
  std::copy(result.begin(), result.end(), out);
  return result.size();
}
