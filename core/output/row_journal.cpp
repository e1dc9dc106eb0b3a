#include "core/output/row_journal.h"

#include "core/base/message_arg.h"
#include "core/recording/bytes/sha256.h"

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

namespace vybeg {
namespace {

// The first line. Another one means another file, which is not to be lost.
constexpr std::string_view head = "# rows of an unfinished vybeg batch, 1\n";
constexpr std::size_t hash_digits = 16;

// A line of the file: the hash of the rest, the key, the row.
Result<std::string> line_of(const std::string& key, std::string_view row) {
    const std::string rest = key + " " + std::string(row);
    Result<std::string> hash = text_sha256(rest);
    return hash ? hash->substr(0, hash_digits) + " " + rest + "\n" : hash;
}

// The name of a new file outlives a loss of power once its folder is on the disk, too. Some file
// systems refuse this, and keep the name anyway.
void keep_name(const std::filesystem::path& path) {
    const std::filesystem::path folder = path.parent_path();
    const Descriptor opened(
        ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    fsync(opened.get());
}

}  // namespace

Result<RowJournal> RowJournal::open(const std::filesystem::path& path, bool resume) {
    RowJournal journal(path);
    if (path.empty()) {
        return journal;
    }
    for (;;) {
        journal.descriptor_ = Descriptor(
            ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0666));
        if (!journal.descriptor_) {
            return journal.failed(errno);
        }
        // A file system without locks lets two processes pass, as it does elsewhere.
        if (flock(journal.descriptor_.get(), LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            return Error{ErrorCode::output_failed,
                         path.string(),
                         {Phrase::tr("another program is writing it")}};
        }
        struct stat status {};
        if (fstat(journal.descriptor_.get(), &status) == 0 && status.st_nlink > 0) {
            break;
        }
        // It was removed by its owner before it was locked.
    }
    TRY(journal.begin(resume));
    return journal;
}

Status RowJournal::begin(bool resume) {
    const auto first = TRY(read(0, head.size()));
    // A part of the first line is that of a run that ended while it wrote it.
    if (!head.starts_with(first)) {
        return Error{
            ErrorCode::output_failed, path_.string(), {Phrase::tr("it is another kind of file")}};
    }
    if (first == head) {
        Status found = find_rows();
        if (!resume) {
            found_ = places_.size();
            rows_.clear();
            places_.clear();
        }
        return found;
    }
    if (ftruncate(descriptor_.get(), 0) != 0) {
        return failed(errno);
    }
    Status written = write(head);
    if (written) {
        keep_name(path_);
    } else {
        remove();
    }
    return written;
}

Status RowJournal::find_rows() {
    end_ = static_cast<std::int64_t>(head.size());
    struct stat status {};
    if (fstat(descriptor_.get(), &status) != 0) {
        return failed(errno);
    }
    const auto text = TRY(read(end_, static_cast<std::size_t>(status.st_size - end_)));
    std::size_t feed = 0;
    for (std::size_t begin = 0; (feed = text.find('\n', begin)) != std::string::npos;
         begin = feed + 1) {
        const std::string line = text.substr(begin, feed + 1 - begin);
        const std::size_t key_end = line.find(' ', hash_digits + 1);
        if (line.size() > hash_digits && key_end != std::string::npos) {
            const std::string key = line.substr(hash_digits + 1, key_end - hash_digits - 1);
            const std::string row = line.substr(key_end + 1, line.size() - key_end - 2);
            const auto whole = TRY(line_of(key, row));
            if (whole == line) {
                add(key, row);
            }
        }
        end_ += static_cast<std::int64_t>(line.size());
    }
    // Otherwise the next row would continue a half one.
    return ftruncate(descriptor_.get(), end_) == 0 ? Status() : failed(errno);
}

Result<std::string> RowJournal::read(std::int64_t offset, std::size_t size) const {
    std::string text(size, '\0');
    const std::int64_t got = read_at(descriptor_.get(), offset, text);
    if (got < 0) {
        return Error{ErrorCode::file_read_failed, path_.string(), {system_reason(errno)}};
    }
    text.resize(static_cast<std::size_t>(got));
    return text;
}

Status RowJournal::append(const std::string& key, std::string_view row) {
    if (descriptor_) {
        const auto line = TRY(line_of(key, row));
        TRY(write(line));
    }
    add(key, row);
    return {};
}

void RowJournal::add(const std::string& key, std::string_view row) {
    places_[key] = rows_.size();
    rows_.push_back({key, std::string(row)});
}

Status RowJournal::write(std::string_view bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const ssize_t written = pwrite(descriptor_.get(), bytes.data() + at, bytes.size() - at,
                                       static_cast<off_t>(end_) + static_cast<off_t>(at));
        if (written < 0 && errno != EINTR) {
            const Error error = failed(errno);
            // Half a row is cut off; where even that fails, its hash does not fit.
            [[maybe_unused]] const int cut = ftruncate(descriptor_.get(), end_);
            return error;
        }
        at += static_cast<std::size_t>(std::max<ssize_t>(written, 0));
    }
    if (fdatasync(descriptor_.get()) != 0) {
        return failed(errno);
    }
    end_ += static_cast<std::int64_t>(bytes.size());
    return {};
}

void RowJournal::remove() noexcept {
    if (!path_.empty()) {
        unlink(path_.c_str());
    }
}

Error RowJournal::failed(int error) const {
    return {ErrorCode::output_failed, path_.string(), {system_reason(error)}};
}

}  // namespace vybeg
