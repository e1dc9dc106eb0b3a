#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

// A file that appears complete or not at all: it is written beside its target under a temporary
// name and renamed over it by commit(); without commit() the temporary is removed and the target
// stays as it was. A target that is no regular file (a device, a pipe) is written to directly.
// Every write hears the stop token, also while a pipe's reader stands still. Errors:
// output_failed, interrupted; where a part of the bytes has gone out to a device or a pipe, which
// nothing can take back, output_incomplete and interrupted_partly.
class OutputFile {
public:
    // Opens the temporary, so that a missing folder or permission shows before the work is done. A
    // target that exists keeps its permissions; a link is followed. Temporaries that processes left
    // in the folder which are gone are removed.
    static Result<OutputFile> create(const std::filesystem::path& target, const JobControl& job);

    // Writes to an open descriptor, which stays open; `name` is for error messages.
    static OutputFile onto(int descriptor, std::string name, const JobControl& job);

    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    // Bytes are gathered to about 1 MiB before they go out; large pieces go out at once.
    Status write(std::string_view bytes);
    Status flush();

    // Flushes, waits for the disk (fsync) and puts the file in its place.
    Status commit();
    // The same for several: all are whole on their disks before the first takes its place, and
    // where one cannot, those before it go back. Past the last look at the stop token, which comes
    // before the first, all of them appear.
    static Status commit_together(std::span<OutputFile* const> files);

    // Compares the file with `bytes`, after flush(): what the disk gives back is what was written.
    // Nothing to compare with where it is written to directly.
    Status compare(std::string_view bytes) const;

    // For libraries that write by themselves, after flush(); only where seekable() says that they
    // may go back and forth.
    int descriptor() const { return descriptor_; }
    bool seekable() const { return !temporary_.empty(); }
    const std::string& name() const { return name_; }
    // Where there is room for what the file is made from: its own folder, where its disk is; the
    // system's for temporary files where it is written to directly, and empty where there is none.
    std::filesystem::path spool_folder() const;

    // output_failed for this file with a reason in words; output_incomplete where bytes went out.
    Error failure(MessageArg reason) const;
    // `error`, except that an interruption after which a part stands becomes interrupted_partly.
    Error as_it_stands(const Error& error) const;

private:
    OutputFile(int descriptor, std::string name, const JobControl& job)
        : descriptor_(descriptor), name_(std::move(name)), job_(job) {}

    Status wait_until_writable() const;
    Status write_out(std::string_view bytes);
    Status settle();
    Status take_place(bool returnable);
    void leave_place() noexcept;
    void discard() noexcept;
    bool partly_out() const { return !seekable() && bytes_out_ > 0; }
    Error failed(int error) const;

    int descriptor_ = -1;
    bool owned_ = false;  // closed by this object
    std::string name_;
    std::filesystem::path target_;
    std::filesystem::path temporary_;  // empty: written to directly, or already in its place
    std::string buffer_;
    std::int64_t bytes_out_ = 0;
    std::int64_t sent_to_disk_ = 0;  // of them, those whose writing has begun
    // Of a file that took its place while others of its group had not: where the old one is.
    enum class Placed { no, new_name, exchanged, for_good };
    Placed placed_ = Placed::no;
    JobControl job_;
};

// Writes a whole file: once, from memory, compared with what the disk gives back, renamed. Errors:
// those of OutputFile.
Status write_file(const std::filesystem::path& target, std::string_view bytes,
                  const JobControl& job);

}  // namespace vybeg
