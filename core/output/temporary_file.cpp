#include "core/output/temporary_file.h"

#include "core/base/number_text.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <fcntl.h>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <sys/file.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace vybeg {
namespace {

constexpr std::string_view prefix = ".vybeg-";
constexpr std::string_view ending = ".part";

std::optional<std::int64_t> number_of(std::string_view text) {
    std::int64_t number = 0;
    const char* const end = text.data() + text.size();
    const auto parsed = std::from_chars(text.data(), end, number);
    return parsed.ec == std::errc{} && parsed.ptr == end && number >= 0 ? std::optional(number)
                                                                        : std::nullopt;
}

// Start of a process in clock ticks since the system's; empty without such a process or without
// /proc. It is the 22nd field of `stat`, the 20th after the name in brackets.
std::optional<std::int64_t> start_of(std::int64_t process) {
    std::ifstream file("/proc/" + integer_text(process) + "/stat");
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    std::size_t at = text.rfind(')');
    for (int field = 0; field < 20 && at != std::string::npos; ++field) {
        at = text.find(' ', at + 1);
    }
    if (at == std::string::npos) {
        return {};
    }
    return number_of(std::string_view(text).substr(at + 1, text.find(' ', at + 1) - at - 1));
}

struct Owner {
    std::int64_t process = 0;
    std::optional<std::int64_t> start;  // none in names of earlier versions: PID-N
};

// Owner of a temporary file by its name; empty for other names.
std::optional<Owner> owner_of(std::string_view name) {
    if (!name.starts_with(prefix) || !name.ends_with(ending)) {
        return {};
    }
    name.remove_prefix(prefix.size());
    name.remove_suffix(ending.size());
    std::vector<std::int64_t> numbers;
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find('-', begin), name.size());
        const auto number = number_of(name.substr(begin, end - begin));
        if (!number) {
            return {};
        }
        numbers.push_back(*number);
        begin = end + 1;
    }
    if (numbers.size() == 2) {
        return Owner{numbers[0], {}};
    }
    return numbers.size() == 3 ? std::optional(Owner{numbers[0], numbers[1]}) : std::nullopt;
}

bool lives(const Owner& owner) {
    // A process of another user exists as well (EPERM).
    if (owner.process > 0 && kill(static_cast<pid_t>(owner.process), 0) != 0 && errno == ESRCH) {
        return false;
    }
    const auto start = start_of(owner.process);
    return !owner.start || !start || *owner.start == 0 || *owner.start == *start;
}

}  // namespace

TemporaryFile make_temporary(const std::filesystem::path& folder) {
    const std::int64_t process = getpid();
    const std::string own = std::string(prefix) + integer_text(process) + "-" +
                            integer_text(start_of(process).value_or(0)) + "-";
    for (std::int64_t attempt = 0;; ++attempt) {
        TemporaryFile file{-1, 0, folder / (own + integer_text(attempt) + std::string(ending))};
        file.descriptor = open(file.path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file.descriptor < 0) {
            if (errno == EEXIST) {
                continue;
            }
            file.error = errno;
            return file;
        }
        // On a file system without locks the process number alone decides.
        flock(file.descriptor, LOCK_EX | LOCK_NB);
        struct stat status {};
        if (fstat(file.descriptor, &status) == 0 && status.st_nlink > 0) {
            return file;
        }
        close(file.descriptor);  // removed as abandoned before it was locked
    }
}

void remove_abandoned(const std::filesystem::path& folder) {
    std::error_code failed;
    std::filesystem::directory_iterator entries(folder.empty() ? "." : folder, failed);
    for (; !failed && entries != std::filesystem::directory_iterator(); entries.increment(failed)) {
        const std::filesystem::path path = entries->path();
        const auto owner = owner_of(path.filename().string());
        if (!owner || lives(*owner)) {
            continue;
        }
        const int descriptor = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
        if (descriptor < 0) {
            continue;
        }
        struct stat status {};
        if (fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
            flock(descriptor, LOCK_EX | LOCK_NB) == 0) {
            unlink(path.c_str());
        }
        close(descriptor);
    }
}

}  // namespace vybeg
