#include "core/output/spool.h"

#include "core/base/message_arg.h"
#include "core/output/temporary_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace vybeg {
namespace {

constexpr std::size_t most_in_memory = std::size_t{1} << 23;
constexpr std::size_t piece = std::size_t{1} << 20;  // bytes between two checks of the stop token

}  // namespace

Spool::~Spool() {
    if (descriptor_ >= 0) {
        close(descriptor_);
    }
}

Error Spool::failed(int error) const {
    return output_.failure(system_reason(error));
}

Status Spool::create() {
    const std::filesystem::path folder = output_.spool_folder();
    descriptor_ = open(folder.c_str(), O_TMPFILE | O_RDWR | O_CLOEXEC, 0600);
    if (descriptor_ < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL)) {
        // For a file system without unnamed files.
        const TemporaryFile named = make_temporary(folder);
        if (named.descriptor < 0) {
            return failed(named.error);
        }
        unlink(named.path.c_str());
        descriptor_ = named.descriptor;
    }
    return descriptor_ >= 0 ? Status{} : failed(errno);
}

Status Spool::write(std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (spilled_ > 0 && memory_.empty() && text.size() >= least_direct) {
        return write_out(text);
    }
    memory_.append(text);
    return memory_.size() < most_in_memory ? Status{} : spill();
}

Status Spool::spill() {
    if (descriptor_ < 0) {
        TRY(create());
    }
    TRY(write_out(memory_));
    memory_.clear();
    return {};
}

Status Spool::write_out(std::string_view left) {
    while (!left.empty()) {
        TRY(job_.go_on());
        const ssize_t written = ::write(descriptor_, left.data(), std::min(left.size(), piece));
        if (written < 0 && errno != EINTR) {
            return failed(errno);
        }
        left.remove_prefix(static_cast<std::size_t>(std::max<ssize_t>(written, 0)));
        spilled_ += std::max<ssize_t>(written, 0);
    }
    return {};
}

Status Spool::read(std::int64_t from, std::span<std::byte> to) const {
    while (!to.empty() && from < spilled_) {
        TRY(job_.go_on());
        const auto wanted = std::min(static_cast<std::size_t>(spilled_ - from), to.size());
        const ssize_t got = pread(descriptor_, to.data(), wanted, from);
        if (got <= 0 && errno != EINTR) {
            return failed(got == 0 ? EIO : errno);
        }
        from += std::max<ssize_t>(got, 0);
        to = to.subspan(static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
    }
    if (!to.empty()) {
        std::memcpy(to.data(), memory_.data() + (from - spilled_), to.size());
    }
    return {};
}

}  // namespace vybeg
