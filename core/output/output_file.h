#pragma once

#include "core/base/job_control.h"
#include "core/base/message_arg.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

namespace vybeg {

struct OpenOptions;

// The place of a file at the end of links, whether the file exists or not: the last folder of its
// path that exists, by device and inode, and the rest of the path.
struct FilePlace {
    dev_t device;
    ino_t folder;
    std::filesystem::path name;

    // NOLINTNEXTLINE(modernize-use-nullptr): which clang-tidy 14 sees in each comparison
    friend auto operator<=>(const FilePlace&, const FilePlace&) = default;
};

// Empty: the links have no end.
std::optional<FilePlace> place_of(const std::filesystem::path& path);

// Whether two paths lead to one file: by device and inode where both exist (including both kinds of
// links), otherwise by the folder of the new file, also by device and inode (a folder that is
// mounted at two places is one), and its name. "-" is standard output. The null device
// is never the same file, because its output is discarded on purpose.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

// The ending of a file's name with its point, in small letters (of A to Z): ".csv".
std::string file_ending(const std::filesystem::path& path);

// Whether a file's ending is one of these; "" among them: it may have none. Errors:
// output_format_unknown, with what can be written.
Status check_ending(const std::filesystem::path& path,
                    std::initializer_list<std::string_view> endings);

// A file that is read; `taken` says so of an output that leads there, e.g. "it is the recording
// itself".
struct InputPath {
    std::string path;
    MessageArg taken;
};

// Adds a recording and its further files: they are read as it is.
void add_recording_files(std::vector<InputPath>& inputs, const std::filesystem::path& recording,
                         const OpenOptions& open);

// A file that is written, "-" for standard output; empty: not asked for.
struct OutputPath {
    std::string option;
    std::string path;
    MessageArg taken;  // of a later output that leads here, e.g. "the result goes there already"
};

// An output replaces neither an input nor another output, whatever their paths are called. Errors:
// setting_invalid.
Status check_outputs(const std::vector<OutputPath>& outputs, const std::vector<InputPath>& inputs);

// A file under a temporary name, `.vybeg-PID-START-N.part`, with the process that writes it and the
// time at which that process began, in the system's clock ticks. The descriptor is locked (flock)
// until it is closed.
struct TemporaryFile {
    Descriptor descriptor;  // none: it could not be made
    int error = 0;          // the system's number, why
    std::filesystem::path path;
};

// Makes one in `folder`, readable and writable, with the permissions of the umask. The name is
// short, so that it fits wherever the target's name does.
TemporaryFile make_temporary(const std::filesystem::path& folder);

// Removes abandoned temporary files in `folder` (after SIGKILL or loss of power). A file stays
// while its process runs on this machine, or while it is locked, for example by a process of
// another machine or container that shares the folder.
void remove_abandoned(const std::filesystem::path& folder);

// A file that appears complete or not at all. It is written beside its target under a temporary
// name; commit() renames it. Without commit() the temporary is removed and the target unchanged. A
// target that is no regular file (a device, a pipe) is written directly. Every write checks the
// stop token, also while the reader of a pipe is blocked. Errors: output_failed, interrupted;
// output_incomplete and interrupted_partly after a part of the bytes went to a device or a pipe.
class OutputFile {
public:
    // Opens the temporary, so that a missing folder or permission is reported before the work. An
    // existing target keeps its permissions; links are followed. Removes abandoned temporaries in
    // the folder.
    static Result<OutputFile> create(const std::filesystem::path& target, const JobControl& job);

    // Writes to an open descriptor and leaves it open; `name` is for error messages.
    static OutputFile onto(int descriptor, std::string name, const JobControl& job);

    OutputFile(OutputFile&& other) noexcept;
    OutputFile& operator=(OutputFile&&) = delete;
    ~OutputFile();

    // Buffers about 1 MiB; writes large pieces at once.
    Status write(std::string_view bytes);
    Status flush();

    // Flushes, waits for the disk (fsync) and renames the file to its target.
    Status commit();
    // The same for several files: all are complete on disk before the first rename; if one rename
    // fails, the earlier ones are undone. The last check of the stop token precedes the first
    // rename.
    static Status commit_together(std::span<OutputFile* const> files);

    // Descriptor for libraries that write themselves. Preconditions: flush(), seekable().
    int descriptor() const { return descriptor_; }
    bool seekable() const { return !temporary_.empty(); }
    const std::string& name() const { return name_; }
    // Folder for intermediate files: that of the file, on its disk; the system's temporary folder
    // for files written directly, empty if there is none.
    std::filesystem::path spool_folder() const;

    // output_failed for this file with a reason in words; output_incomplete after bytes were
    // written directly.
    Error failure(MessageArg reason) const;
    // `error`, but interrupted_partly for an interruption that leaves a part of the output.
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
    Descriptor own_;  // descriptor_, where this object closes it
    std::string name_;
    std::filesystem::path target_;
    std::filesystem::path temporary_;  // empty: written directly, or already in place
    std::string buffer_;
    std::int64_t bytes_out_ = 0;
    std::int64_t sent_to_disk_ = 0;  // bytes of them passed to sync_file_range()
    // State of a file in place while others of its group are not: location of the old file.
    enum class Placed { no, new_name, exchanged, for_good };
    Placed placed_ = Placed::no;
    JobControl job_;
};

// A file, or standard output for "-".
Result<OutputFile> open_output(const std::string& name, const JobControl& job);

// Writes a whole file from memory and renames it. Errors: those of OutputFile.
Status write_file(const std::filesystem::path& target, std::string_view bytes,
                  const JobControl& job);

}  // namespace vybeg
