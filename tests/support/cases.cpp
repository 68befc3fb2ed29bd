// SPDX-License-Identifier: BSD-3-Clause
// The tools in one process, for tests with thousands of cases: reads command lines from standard
// input and answers with what the tool of each wrote. cases.py speaks with it.
//
//   request  ARGUMENTS INPUT '\n'    numbers of bytes, then the bytes: the current folder and the
//                                    arguments, each ended by a zero byte; and standard input
//   answer   CODE OUTPUT ERROR '\n'  the exit code and two numbers of bytes, then the bytes of
//                                    standard output and of standard error
//
// Standard error must be a file: it holds the last words of a tool that ends this process.
#include <sys/mman.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "common/cli/tools_in_one.hpp"

namespace {

/// Then SIGALRM ends this process.
constexpr unsigned kSecondsPerCase = 120;

[[noreturn]] void fail(const char* what) {
  std::perror(what);
  std::exit(2);
}

/// A standard stream that is a file.
class Stream {
 public:
  explicit Stream(int descriptor) : descriptor_(descriptor) {}

  /// Replaces the standard stream by a file in memory.
  static Stream in_memory(int descriptor) {
    const int file = ::memfd_create("stream", MFD_CLOEXEC);
    if (file < 0 || ::dup2(file, descriptor) < 0) fail("streams");
    return Stream(descriptor);
  }

  void set(const std::string& text) const {
    if (::ftruncate(descriptor_, 0) != 0 || ::lseek(descriptor_, 0, SEEK_SET) != 0) fail("streams");
    const auto size = static_cast<ssize_t>(text.size());
    if (size > 0 && ::pwrite(descriptor_, text.data(), text.size(), 0) != size) fail("streams");
  }

  std::string text() const {
    const off_t size = ::lseek(descriptor_, 0, SEEK_END);
    std::string text(static_cast<std::size_t>(size), '\0');
    if (::pread(descriptor_, text.data(), text.size(), 0) != size) fail("streams");
    return text;
  }

 private:
  int descriptor_;
};

std::string read_bytes(std::FILE* from, std::size_t size) {
  std::string bytes(size, '\0');
  if (std::fread(bytes.data(), 1, size, from) != size) fail("half a request");
  return bytes;
}

/// The parts of a text in which each ends with a zero byte.
std::vector<char*> parts_of(std::string& text) {
  std::vector<char*> parts;
  for (std::size_t at = 0; at < text.size(); at += std::strlen(text.data() + at) + 1) {
    parts.push_back(text.data() + at);
  }
  return parts;
}

int run(int argc, char** argv) {
  const auto tool = smurf::tools::find_tool(argv[0]);
  if (tool == nullptr) fail(argv[0]);
  ::alarm(kSecondsPerCase);
  const int code = tool(argc, argv);
  ::alarm(0);
  return code;
}

}  // namespace

int main() {
  std::FILE* const requests = ::fdopen(::dup(0), "rb");
  std::FILE* const answers = ::fdopen(::dup(1), "wb");
  if (requests == nullptr || answers == nullptr) fail("streams");
  const Stream input = Stream::in_memory(0);
  const Stream output = Stream::in_memory(1);
  const Stream error(2);
  std::size_t argument_bytes = 0;
  std::size_t input_bytes = 0;
  while (std::fscanf(requests, "%zu %zu", &argument_bytes, &input_bytes) == 2) {
    std::fgetc(requests);  // the end of the line
    std::string request = read_bytes(requests, argument_bytes);
    input.set(read_bytes(requests, input_bytes));
    output.set({});
    error.set({});
    std::vector<char*> words = parts_of(request);
    if (words.size() < 2 || ::chdir(words.front()) != 0) fail("request");
    const int argc = static_cast<int>(words.size()) - 1;
    words.push_back(nullptr);
    const int code = run(argc, words.data() + 1);
    const std::string written = output.text();
    const std::string complained = error.text();
    std::fprintf(answers, "%d %zu %zu\n", code, written.size(), complained.size());
    std::fwrite(written.data(), 1, written.size(), answers);
    std::fwrite(complained.data(), 1, complained.size(), answers);
    std::fflush(answers);
  }
  return 0;
}
