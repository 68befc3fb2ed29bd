// SPDX-License-Identifier: BSD-3-Clause
// Frames in Lua files of Cartographer.
// Source: cartographer_ros node_options.cpp, trajectory_options.cpp.
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "link/surroundings/frame_names.hpp"

namespace smurf {

bool is_cartographer(std::string_view text) {
  return text.find("tracking_frame") != std::string_view::npos;
}

void visit_lua(const FrameFile& file, const TakeFrame& take) {
  for (const std::string_view key : {"tracking_frame", "published_frame"}) {
    std::size_t at = file.text.find(key);
    if (at == std::string_view::npos) continue;
    at = file.text.find('=', at);
    const std::size_t open = file.text.find_first_of("\"'\n", std::min(at, file.text.size()));
    if (open == std::string_view::npos || file.text[open] == '\n') continue;
    const std::size_t close = file.text.find(file.text[open], open + 1);
    if (close == std::string_view::npos) continue;
    FrameName frame;
    frame.use = FrameName::Use::sensor;
    frame.written = {file.source, static_cast<std::uint32_t>(open + 1),
                     static_cast<std::uint32_t>(close)};
    frame.name = file.text.substr(open + 1, close - open - 1);
    frame.place = {Reference::Notation::program, Reference::kNothing, frame.written, frame.written};
    frame.key = key;
    take(frame);
  }
}

}  // namespace smurf
