#include "core/recording/bytes/file_bytes.h"

#include "core/base/message_arg.h"

#include <cerrno>
#include <fcntl.h>
#include <unistd.h>

namespace vybeg {
namespace {

Error failure(const std::filesystem::path& path, int number) {
    switch (number) {
        case ENOENT:
        case ENOTDIR: return {ErrorCode::file_missing, path.string(), {}};
        case EACCES:
        case EPERM: return {ErrorCode::file_permission, path.string(), {}};
        case EISDIR: return {ErrorCode::file_is_directory, path.string(), {}};
        default: break;
    }
    return {ErrorCode::file_read_failed, path.string(), {system_reason(number)}};
}

}  // namespace

int Descriptor::close() {
    const int number = std::exchange(number_, -1);
    return number < 0 ? 0 : ::close(number);
}

std::int64_t read_at(int descriptor, std::int64_t offset, std::span<char> out) {
    std::size_t done = 0;
    while (done < out.size()) {
        const ssize_t got = ::pread(descriptor, out.data() + done, out.size() - done,
                                    offset + static_cast<std::int64_t>(done));
        if (got < 0 && errno != EINTR) {
            return -1;
        }
        if (got == 0) {
            break;
        }
        done += static_cast<std::size_t>(got > 0 ? got : 0);
    }
    return static_cast<std::int64_t>(done);
}

Result<std::shared_ptr<const FileBytes>> FileBytes::open(const std::filesystem::path& path) {
    // Without O_NONBLOCK, opening a named pipe would block until it has a writer.
    Descriptor descriptor(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    return descriptor ? adopt(path, std::move(descriptor)) : failure(path, errno);
}

Result<std::shared_ptr<const FileBytes>> FileBytes::adopt(const std::filesystem::path& path,
                                                          Descriptor descriptor) {
    struct stat status {};
    if (::fstat(descriptor.get(), &status) != 0) {
        return failure(path, errno);
    }
    const std::shared_ptr<const FileBytes> file(new FileBytes(path, std::move(descriptor), status));
    if (S_ISDIR(status.st_mode)) {
        return file->error(ErrorCode::file_is_directory);
    }
    if (!S_ISREG(status.st_mode)) {
        return file->error(ErrorCode::file_not_regular);
    }
    if (status.st_size == 0) {
        return file->error(ErrorCode::file_empty);
    }
    return file;
}

FileBytes::FileBytes(std::filesystem::path path, Descriptor descriptor, const struct stat& status)
    : path_(std::move(path)), descriptor_(std::move(descriptor)), status_(status) {}

Status FileBytes::unchanged() const {
    struct stat status {};
    if (::fstat(descriptor_.get(), &status) != 0) {
        return failure(path_, errno);
    }
    const auto same_time = [](const timespec& a, const timespec& b) {
        return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
    };
    const bool names_or_rights = status.st_nlink != status_.st_nlink ||
                                 status.st_mode != status_.st_mode ||
                                 status.st_uid != status_.st_uid || status.st_gid != status_.st_gid;
    const bool same = status.st_size == status_.st_size &&
                      same_time(status.st_mtim, status_.st_mtim) &&
                      (names_or_rights || same_time(status.st_ctim, status_.st_ctim));
    return same ? Status{} : error(ErrorCode::file_changed);
}

Error FileBytes::error(ErrorCode code, std::vector<MessageArg> args) const {
    return {code, path_.string(), std::move(args)};
}

Error FileBytes::damaged(const std::string& format, const char* text,
                         std::vector<MessageArg> args) const {
    return error(ErrorCode::format_damaged, {format, words(text, std::move(args))});
}

Error FileBytes::unsupported(const std::string& format, const char* text,
                             std::vector<MessageArg> args) const {
    return error(ErrorCode::format_unsupported, {format, words(text, std::move(args))});
}

Result<std::int64_t> FileBytes::read(std::int64_t offset, std::span<char> out) const {
    const std::int64_t got = read_at(descriptor_.get(), offset, out);
    return got < 0 ? Result<std::int64_t>(failure(path_, errno)) : got;
}

Result<std::string> FileBytes::text(std::int64_t offset, std::int64_t size) const {
    std::string bytes(static_cast<std::size_t>(size), '\0');
    const auto got = TRY(read(offset, bytes));
    bytes.resize(static_cast<std::size_t>(got));
    return bytes;
}

Result<std::string> own_file_text(const std::filesystem::path& path) {
    constexpr std::int64_t most_mib = 64;
    const auto file = TRY(FileBytes::open(path));
    if (file->size() > most_mib << 20) {
        return file->error(ErrorCode::format_limit,
                           {"text", Phrase::tr("it has more than %1 MiB", {count_arg(most_mib)}),
                            Phrase::tr("Choose a smaller file")});
    }
    return file->text(0, file->size());
}

Error too_many_parts(const std::string& where, const std::string& format, const char* text,
                     std::size_t most) {
    return {ErrorCode::format_limit,
            where,
            {format, words(text, {count_arg(most)}),
             Phrase::tr("Save the recording in a file of its own")}};
}

namespace {

class FilePart final : public ByteSource {
public:
    FilePart(std::shared_ptr<const FileBytes> file, std::int64_t offset, std::int64_t size)
        : file_(std::move(file)), offset_(offset), size_(size) {}

    std::int64_t size() const override { return size_; }

    Status read(std::int64_t offset, std::span<char> out) const override {
        const auto got = TRY(file_->read(offset_ + offset, out));
        if (got < static_cast<std::int64_t>(out.size())) {
            return file_->error(ErrorCode::file_read_failed,
                                {Phrase::tr("the file became shorter while it was read")});
        }
        return {};
    }

private:
    std::shared_ptr<const FileBytes> file_;
    std::int64_t offset_;
    std::int64_t size_;
};

}  // namespace

std::shared_ptr<const ByteSource> file_part(std::shared_ptr<const FileBytes> file,
                                            std::int64_t offset, std::int64_t size) {
    return std::make_shared<FilePart>(std::move(file), offset, size);
}

}  // namespace vybeg
