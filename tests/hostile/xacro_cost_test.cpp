// SPDX-License-Identifier: BSD-3-Clause
// Every function, method and operator of expressions with its largest operands: what it takes is
// what it counts. The names come from the tables of the program, so that none can be left out.
#include <doctest/doctest.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <new>
#include <string>
#include <vector>

#include "smurf/limits.hpp"
#include "xacro/evaluator.hpp"

namespace {

std::atomic<std::size_t> allocated = 0;       // bytes
std::atomic<std::size_t> most_allocated = 0;  // bytes at once

constexpr std::size_t kHeader = alignof(std::max_align_t);

void* take(std::size_t size) {
  auto* const block = static_cast<std::size_t*>(std::malloc(size + kHeader));
  if (block == nullptr) throw std::bad_alloc();
  *block = size;
  allocated += size;
  if (allocated > most_allocated) most_allocated = allocated.load();
  return reinterpret_cast<char*>(block) + kHeader;
}

void give_back(void* place) {
  if (place == nullptr) return;
  auto* const block = reinterpret_cast<std::size_t*>(static_cast<char*>(place) - kHeader);
  allocated -= *block;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return take(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return take(size); }
void operator delete(void* place) noexcept { give_back(place); }
void operator delete(void* place, std::size_t) noexcept { give_back(place); }
void operator delete(void* place, const std::nothrow_t&) noexcept { give_back(place); }

namespace smurf::xacro {
namespace {

/// Has no files, packages and arguments.
class NoHost final : public Host {
 public:
  Value resolve(Table&, Table::Entry& entry, std::string_view) override { return entry.value; }
  Value load_yaml(const std::string&) override { return {}; }
  std::string whole_path(const std::string& path) override { return path; }
  Value argument(const std::string&) override { return {}; }
  Value environment(const std::string&, const Value*) override { return {}; }
  Value find_package(const std::string&) override { return {}; }
  void say(std::string_view, const std::string&) override {}
  void assign(Table&, std::string_view, const Value&) override {}
};

/// The largest values of each kind that the limits allow, and the smallest.
constexpr std::pair<std::string_view, std::string_view> kOperands[] = {
    {"long_text", "'a'*999999"},
    {"nearly", "'a'*500000+'b'"},
    {"period", "('a'*999+'b')*999"},
    {"part", "'a'*300000+'b'"},
    {"wide_text", "'\u00e9'*499999"},
    {"blanks", "'\\t '*499999"},
    {"lines", "'a\\n'*99000"},
    {"digits", "'9'*1299"},
    {"many_digits", "'1'*999999"},
    {"fields", "'{0}{0}{0}{0}'*20000"},
    {"percents", "'%s%s%s%s'*20000"},
    {"short_text", "'a'"},
    {"separator", "','"},
    {"long_list", "[0]*99999"},
    {"reals", "[1e308, -1e308, 1e-300, 1.5]*24999"},
    {"numbers", "list(range(99999))"},
    {"big_list", "[2**4000 + 1]*99999"},
    {"text_list", "['a'*100]*9000"},
    {"same_texts", "['a'*999999]*9000"},
    {"list_of_lists", "[[0]*50000 + [1], [0]*50000 + [2]]*4000"},
    {"pairs", "[(str(i), i) for i in range(60000)]"},
    {"tuple_value", "python.tuple(range(99999))"},
    {"set_value", "python.set(range(60000))"},
    {"text_set", "python.set([str(i)*20 for i in range(20000)])"},
    {"dict_value", "dict([(str(i), i) for i in range(60000)])"},
    {"range_value", "range(10**9)"},
    {"short_range", "range(99999)"},
    {"big", "2**4095 - 1"},
    {"big_odd", "3**2500"},
    {"middle", "2**2048 + 1"},
    {"whole", "4000"},
    {"three", "3"},
    {"minus", "-1"},
    {"zero", "0"},
    {"real", "1.2345678e300"},
    {"function", "(lambda x: x)"},
    {"nothing", "None"},
};
/// Further operands of calls with two and three: all pairs of these with all others.
constexpr std::string_view kSecond[] = {"nearly",     "part",        "digits",     "short_text",
                                        "same_texts", "tuple_value", "set_value",  "middle",
                                        "three",      "whole",       "dict_value", "long_list"};

/// Other parts of the language.
constexpr std::string_view kExpressions[] = {
    "[x for x in numbers]",
    "[x for x in numbers if x > 3 and x < 5]",
    "[y for x in text_list for y in x]",
    "[long_text for x in numbers]",
    "[long_text == x for x in same_texts]",
    "[x in numbers for x in range(50)]",
    "[x[3] for x in same_texts]",
    "[x[::-1] for x in text_list]",
    "wide_text[5]",
    "wide_text[::2]",
    "long_text[::3]",
    "numbers[::-1]",
    "range_value[::3]",
    "dict(**dict_value)",
    "max(*numbers)",
    "[*numbers, *numbers][0:5]",
    "(lambda *x: x)",
    "list(map(lambda x: x + 1, numbers))",
    "python.sum([[0]]*3000, [])",
    "python.sum(numbers)",
    "python.sorted(numbers, key=lambda x: -x)",
    "python.sorted(list_of_lists)",
    "python.sorted(same_texts, reverse=True)",
    "max(numbers, key=lambda x: -x)",
    "list(python.zip(numbers, numbers, numbers))",
    "'%.900f' % real",
    "'%x' % big",
    "'{:,}'.format(big)",
    "'%(a)s'*1000 % dict_value",
    "fields.format(long_text)",
    "fields.format(*numbers)",
    "percents % python.tuple(same_texts)",
    "percents % tuple_value",
    "''.join(text_list)",
    "long_text.join(text_list)",
    "long_text.replace('a', 'bb')",
    "long_text.replace('', 'b')",
    "long_text.replace(part, 'b')",
    "many_digits.zfill(1000000)",
    "'a'.center(1000000, 'b')",
    "long_text.find(nearly, 3, 900000)",
    "same_texts.index(nearly)",
    "text_list.count(long_text)",
    "xacro.tokenize(long_text, 'bcdefghij'*9999)",
    "dict_value | dict_value",
    "dict_value == dict_value",
    "[d.get(long_text) for d in [dict_value]*99]",
    "'{a}{a}{a}'.format(**dict([(str(i), i) for i in range(9999)] + [('a', 1)]))",
    "f'{big}'",
    "big if long_list else 1",
    "[round(real, 2) for x in numbers]",
    "[float(x) for x in [many_digits]*99]",
    "[int(digits) for x in range(999)]",
};

struct Session {
  Session()
      : meter(limits), heap(meter), expressions(heap), evaluator(heap, expressions, limits, host) {
    root = &tables.emplace_back(heap.arena());
    add_functions(*root, heap, tables);
    names = &tables.emplace_back(*root);
    for (const auto& [name, code] : kOperands) {
      const Value value = evaluator.evaluate(code, *names);
      if (value.is_failed()) FAIL(name << ": " << evaluator.failure().message);
      names->set(name, value);
    }
  }

  Limits limits = [] {
    Limits all;
    all.xacro_bytes = 400'000'000;
    return all;
  }();
  NoHost host;
  Meter meter;
  Heap heap;
  Expressions expressions;
  Evaluator evaluator;
  std::deque<Table> tables;
  Table* root = nullptr;
  Table* names = nullptr;
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// What a fixed piece of honest work takes now, against what it takes on the machine where a step
/// has at most 1 us.
double pace() {
  constexpr double kUsual = 0.02;  // s
  const double begin = processor_seconds();
  std::uint64_t sum = 1;
  std::vector<std::uint64_t> values(1U << 16U, 3);
  for (int round = 0; round < 200; ++round) {
    for (std::uint64_t& value : values) sum += value = value * 6364136223846793005U + sum;
  }
  const volatile std::uint64_t kept = sum;  // so that it is computed
  static_cast<void>(kept);
  return std::max(1.0, (processor_seconds() - begin) / kUsual);
}

class Judge {
 public:
  void judge(const std::string& code) {
    ++count_;
    std::string fault;
    for (int attempt = 0; attempt < 3; ++attempt) {
      fault = run(code, attempt);
      if (fault.empty()) return;
    }
    MESSAGE(code << ": " << fault);
    ++faults_;
  }
  /// Makes the operands again, which a method may have changed.
  void renew() { session_.reset(); }
  int count() const { return count_; }
  int faults() const { return faults_; }

 private:
  std::string run(const std::string& code, int attempt) {
    constexpr std::uint64_t kMostSteps = 2'000'000;  // of a call
    constexpr std::uint64_t kMostBytes = 300'000'000;
    const bool is_worn = session_ == nullptr || session_->meter.bytes() > kMostBytes;
    if (is_worn || attempt > 0) {
      session_.reset();
      session_ = std::make_unique<Session>();
    }
    Evaluator& evaluator = session_->evaluator;
    session_->meter.renew(kMostSteps);
    const Meter& meter = session_->meter;
    const std::uint64_t steps = meter.steps();
    const std::uint64_t bytes = meter.bytes();
    const std::size_t before = allocated;
    most_allocated = before;
    const double begin = processor_seconds();
    evaluator.evaluate(code, *session_->names);
    const double seconds = processor_seconds() - begin;
    const std::uint64_t counted = meter.steps() - steps;
    const std::uint64_t kept = meter.most_used() > bytes ? meter.most_used() - bytes : 0;
    const std::size_t taken = most_allocated - before;
    evaluator.take_failure();
    evaluator.remarks().clear();
    constexpr double kFree = 0.003;                 // s: a message of a failure, and the clock
    constexpr std::size_t kFreeBytes = 12'000'000;  // a few copies of the largest text or list
    const double most = static_cast<double>(counted) * 1e-6 + kFree;
    if (seconds > most && seconds > most * pace()) {
      return std::to_string(seconds * 1e3) + " ms for " + std::to_string(counted) + " steps";
    }
    if (taken > 4 * kept + kFreeBytes) {
      return std::to_string(taken) + " bytes, of which " + std::to_string(kept) + " are counted";
    }
    return {};
  }

  std::unique_ptr<Session> session_;
  int count_ = 0;
  int faults_ = 0;
};

/// Calls of a function or a method with no, one, two and three operands.
void judge_calls(Judge& judge, const std::string& called) {
  judge.judge(called + "()");
  for (const auto& [first, code] : kOperands) {
    judge.judge(called + "(" + std::string(first) + ")");
  }
  for (const std::string_view first : kSecond) {
    for (const std::string_view second : kSecond) {
      judge.judge(called + "(" + std::string(first) + ", " + std::string(second) + ")");
    }
  }
  judge.judge(called + "(long_text, part, short_text)");
  judge.judge(called + "(short_text, part, three)");
}

std::vector<std::string> functions() {
  Session session;
  std::vector<std::string_view> names;
  session.root->append_names(names, true);
  std::vector<std::string> all;
  for (const std::string_view name : names) {
    const Value& value = session.root->own(name)->value;
    if (value.kind != Kind::name_space) {
      all.emplace_back(name);
      continue;
    }
    std::vector<std::string_view> inner;
    value.table->append_names(inner, true);
    for (const std::string_view one : inner) {
      if (name != "math" && value.table->own(one) != nullptr)
        all.push_back(std::string(name) + "." + std::string(one));
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

TEST_CASE("functions and types count what they do") {
  Judge judge;
  for (const std::string& name : functions()) judge_calls(judge, name);
  MESSAGE(judge.count() << " calls");
  CHECK(judge.count() > 15'000);
  CHECK(judge.faults() == 0);
}

TEST_CASE("methods count what they do") {
  Judge judge;
  const std::pair<std::span<const Method>, std::vector<std::string>> tables[] = {
      {text_methods(), {"long_text", "nearly", "wide_text", "blanks", "lines", "period"}},
      {list_methods(), {"long_list", "numbers", "same_texts", "list_of_lists", "tuple_value"}},
      {dict_methods(), {"dict_value"}},
      {real_methods(), {"real"}},
      {integer_methods(), {"big", "three"}},
  };
  for (const auto& [rows, values] : tables) {
    REQUIRE(!rows.empty());
    for (const Method& row : rows) {
      for (const std::string& value : values) {
        const std::string called = value + "." + std::string(row.name);
        if (value.ends_with("list") || value == "numbers" || value == "same_texts" ||
            value == "dict_value")
          judge.renew();
        judge.judge(called + "()");
        for (const std::string_view second : kSecond)
          judge.judge(called + "(" + std::string(second) + ")");
        for (const auto& [other, code] : kOperands)
          judge.judge(called + "(" + std::string(other) + ")");
        judge.judge(called + "(part, short_text)");
        judge.judge(called + "(short_text, part)");
        judge.judge(called + "(whole, short_text)");
        judge.judge(called + "(zero, long_text)");
      }
    }
  }
  MESSAGE(judge.count() << " calls");
  CHECK(judge.faults() == 0);
}

TEST_CASE("operators count what they do") {
  Judge judge;
  for (int number = 0; number <= static_cast<int>(Operation::is_not); ++number) {
    const std::string mark(text_of(static_cast<Operation>(number)));
    for (const auto& [left, code] : kOperands) {
      judge.judge(mark + " " + std::string(left));
      for (const auto& [right, other] : kOperands) {
        judge.judge(std::string(left) + " " + mark + " " + std::string(right));
      }
    }
  }
  MESSAGE(judge.count() << " operations");
  CHECK(judge.count() > 20'000);
  CHECK(judge.faults() == 0);
}

TEST_CASE("other expressions count what they do") {
  Judge judge;
  for (const std::string_view code : kExpressions) judge.judge(std::string(code));
  CHECK(judge.faults() == 0);
}

}  // namespace smurf::xacro
