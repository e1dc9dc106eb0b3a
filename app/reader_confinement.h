#pragma once

#include <cstdint>

namespace vybeg {

// What vybeg-reader gives up before it looks at a file: new privileges, memory beyond the file's
// size and 64 MB (until allow_memory()) and 6 pieces of most_packed_bytes at all, writing to files,
// more than 8 descriptors, other processes and threads, core dumps, and more than ten hours of
// processor time in all.
void give_up_resources();

// So many bytes more, for the pieces that the file says it is packed in.
void allow_memory(std::int64_t bytes);

// From here on, a system call that reading from open files, memory and the socket does not need
// ends the process (SIGSYS). False where the system has no seccomp, or on another processor than
// x86-64 and ARM64. With AddressSanitizer, which itself opens files, it forbids nothing and returns
// true: such a build is for tests.
bool forbid_system_calls();

}  // namespace vybeg
