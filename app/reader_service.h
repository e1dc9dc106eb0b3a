#pragma once

#include <functional>
#include <string_view>

namespace vybeg {

// The whole of vybeg-reader: opens the file at the descriptor reader_file, whose kind is "mat73" or
// "hdf5", sends its catalogue through reader_socket and answers requests until the program hangs
// up. Before it opens the file, it gives up what reading does not need; after that, nearly all
// system calls. Then it calls `once_confined`, where there is one, after the catalogue: tests
// misbehave there. Returns the exit status.
int serve_file(std::string_view kind, const std::function<void()>& once_confined = {});

}  // namespace vybeg
