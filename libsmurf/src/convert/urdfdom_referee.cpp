// SPDX-License-Identifier: BSD-3-Clause
// urdfdom checks exported URDFs; it is never used as the parser. Its messages go through the
// process-wide handler of console_bridge, which is replaced during the call.
#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <mutex>

#include "smurf/convert.hpp"

namespace smurf {
namespace {

class CapturedMessages final : public console_bridge::OutputHandler {
 public:
  CapturedMessages() { console_bridge::useOutputHandler(this); }
  ~CapturedMessages() override { console_bridge::restorePreviousOutputHandler(); }
  CapturedMessages(const CapturedMessages&) = delete;
  CapturedMessages& operator=(const CapturedMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_WARN) messages += text + "\n";
  }

  std::string messages;
};

}  // namespace

RefereeVerdict ask_urdfdom(const std::string& urdf) {
  // urdfdom 3.0.1 overflows its stack in the destructor of a chain of 100,000 to 200,000 links
  // and uses URDF text as a printf format.
  constexpr std::size_t kMostBytes = 32U << 20U;
  RefereeVerdict verdict;
  if (urdf.size() > kMostBytes || urdf.find('%') != std::string::npos) return verdict;
  static std::mutex one_at_a_time;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  CapturedMessages captured;
  verdict.was_asked = true;
  try {
    const ::urdf::ModelInterfaceSharedPtr model = ::urdf::parseURDF(urdf);
    verdict.accepts = model != nullptr;
  } catch (const std::exception& error) {
    captured.messages += std::string(error.what()) + "\n";
  }
  verdict.messages = captured.messages;
  return verdict;
}

}  // namespace smurf
