// SPDX-License-Identifier: BSD-3-Clause
// What the programs have in common that give robots to a reader and say what it made of them:
//   NAME < list of files
//   {"file": ..., "verdict": "takes" | "refuses" | "crashes", "message": ..., "robot": {...}}
// A robot is flat: "what it is about:name", such as "mass:arm", and numbers and words. Each file is
// read by a process of its own, for readers crash and do not come to an end.
#pragma once

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdio>
#include <exception>
#include <fcntl.h>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>

namespace smurf::tests {

using Json = nlohmann::json;

/// The result of reading a file; without a robot if the reader refused it.
struct Reading {
  bool is_taken = false;
  std::string message{};
  Json robot = Json::object();
};

inline std::string dump(const Json& json) {
  return json.dump(-1, ' ', true, Json::error_handler_t::replace);
}

constexpr unsigned kSeconds = 10;  ///< of processor time, after which a reader is hanging
constexpr rlim_t kBytes = rlim_t{4} << 30U;

inline Json read_in_child(const std::string& file,
                          const std::function<Reading(const std::string&)>& read) {
  Json out = {{"file", file}};
  try {
    const Reading reading = read(file);
    out["verdict"] = reading.is_taken ? "takes" : "refuses";
    out["message"] = reading.message.substr(0, reading.message.find('\n'));
    if (reading.is_taken) out["robot"] = reading.robot;
  } catch (const std::exception& error) {  // because this ends the programs that use the reader
    out["verdict"] = "crashes";
    out["message"] = error.what();
  }
  return out;
}

[[noreturn]] inline void be_child(int pipe, const std::string& file,
                                  const std::function<Reading(const std::string&)>& read) {
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  const rlimit seconds{kSeconds, kSeconds + 1};
  const rlimit bytes{kBytes, kBytes};
  const rlimit no_core{0, 0};
  ::setrlimit(RLIMIT_CPU, &seconds);
  ::setrlimit(RLIMIT_AS, &bytes);
  ::setrlimit(RLIMIT_CORE, &no_core);
  ::alarm(6 * kSeconds);
  const std::string text = dump(read_in_child(file, read)) + "\n";
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t count = ::write(pipe, text.data() + done, text.size() - done);
    if (count <= 0) break;
    done += static_cast<std::size_t>(count);
  }
  ::_exit(0);
}

inline std::string read_to_end(int pipe) {
  std::string text;
  std::array<char, 65536> part{};
  for (ssize_t count = 0; (count = ::read(pipe, part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  return text;
}

inline std::string read_apart(const std::string& file,
                              const std::function<Reading(const std::string&)>& read) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return {};
  const pid_t child = ::fork();
  if (child == 0) be_child(ends[1], file, read);
  ::close(ends[1]);
  const std::string text = read_to_end(ends[0]);
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  const bool is_whole = WIFEXITED(status) && WEXITSTATUS(status) == 0 && text.ends_with('\n');
  if (is_whole) return text;
  const std::string how =
      WIFSIGNALED(status) ? "signal " + std::to_string(WTERMSIG(status)) : "ends the process";
  return dump({{"file", file}, {"verdict", "crashes"}, {"message", how}}) + "\n";
}

inline int run_reader(const std::function<Reading(const std::string&)>& read) {
  for (std::string file; std::getline(std::cin, file);) {
    std::fputs(read_apart(file, read).c_str(), stdout);
    std::fflush(stdout);
  }
  return 0;
}

}  // namespace smurf::tests
