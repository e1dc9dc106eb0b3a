#pragma once

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <sys/mman.h>
#include <unistd.h>

namespace vybeg::fuzz {

inline void write_all(int descriptor, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
        if (written <= 0) {
            std::perror("a file to be tried");
            std::abort();
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

// A file in memory: no disk to wait for, and a path to open it by while the object lives.
class MemoryFile {
public:
    explicit MemoryFile(std::string_view bytes) : descriptor_(memfd_create("fuzz", MFD_CLOEXEC)) {
        write_all(descriptor_, bytes);
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() { ::close(descriptor_); }

    std::string path() const { return "/proc/self/fd/" + std::to_string(descriptor_); }

private:
    int descriptor_;
};

// A file in the folder for temporary ones, for HDF5, which wants to know its real path.
class NamedFile {
public:
    explicit NamedFile(std::string_view bytes)
        : path_(std::filesystem::temp_directory_path() / "vybeg-fuzz-XXXXXX") {
        const int descriptor = mkstemp(path_.data());
        write_all(descriptor, bytes);
        ::close(descriptor);
    }
    NamedFile(const NamedFile&) = delete;
    NamedFile& operator=(const NamedFile&) = delete;
    ~NamedFile() { ::unlink(path_.c_str()); }

    const std::string& path() const { return path_; }

private:
    std::string path_;
};

}  // namespace vybeg::fuzz
