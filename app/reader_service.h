#pragma once

#include <functional>
#include <string_view>

namespace vybeg {

// The whole of vybeg-reader: reads the file at the descriptor reader_file, whose kind is "mat73",
// "hdf5" or "audio", sends its catalogue through reader_socket and answers requests until the
// program hangs up. Before the first byte of the file it gives up what reading does not need, with
// nearly all system calls; where it cannot, it says so and reads nothing. Then it calls
// `once_confined`, where there is one: tests misbehave there. Returns the exit status.
int serve_file(std::string_view kind, const std::function<void()>& once_confined = {});

}  // namespace vybeg
