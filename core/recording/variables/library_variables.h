#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/variables/reader_protocol.h"
#include "core/recording/variables/variable_recording.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <sys/types.h>

namespace vybeg {

// A vybeg-reader that has a file open: a library (HDF5, of audio) crashes, hangs or takes all
// memory on some damaged files, and there it does so alone. Not for several threads at once.
class ReaderProcess {
public:
    // Starts vybeg-reader (or another program, in tests), which lies beside the running one or,
    // installed, in libexec/vybeg, on a file of the given kind ("mat73", "hdf5", "audio"); `format`
    // names it in errors. Errors: format_damaged, format_unsupported; reader_not_started, where the
    // helper itself cannot be had; file_read_failed, where it cannot confine itself.
    static Result<std::unique_ptr<ReaderProcess>> start(
        std::shared_ptr<const FileBytes> file, const std::string& kind, const std::string& format,
        const std::string& program = "vybeg-reader");

    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;
    ~ReaderProcess();

    const Catalogue& catalogue() const { return catalogue_; }
    pid_t id() const { return id_; }

    // Precondition: fits(request, catalogue()), and `out` has request.count places. The helper has
    // seconds_allowed(request) of processor time, however busy the machine and slow the disk; one
    // that uses none for 20 s is given up, too. Errors: format_damaged, also where the helper died;
    // it is of no use afterwards.
    Status read(const SampleRequest& request, std::span<double> out);

private:
    ReaderProcess(std::shared_ptr<const FileBytes> file, std::string format, Descriptor socket,
                  pid_t id);

    Status take_catalogue();
    enum class Wait { ready, used_up, idle };

    void allow(int seconds);
    double processor_s() const;
    Wait wait();
    bool receive(std::span<char> bytes);
    bool receive(Reply& reply) { return receive({reinterpret_cast<char*>(&reply), sizeof reply}); }
    std::optional<std::string> receive_text(const Reply& reply);
    Error failed_reply(const Reply& reply);
    Error broken_off();
    int end();

    std::shared_ptr<const FileBytes> file_;
    std::string format_;
    Descriptor socket_;
    pid_t id_;
    int seconds_ = 0;          // of processor time for this answer
    double used_up_at_s_ = 0;  // by the helper's processor clock
    Wait last_wait_ = Wait::ready;
    Catalogue catalogue_;
};

// The variables of a file that vybeg-reader reads. Starts a helper as ReaderProcess::start() does;
// one that died or was given up is replaced at the next read: a damaged segment does not cost the
// rest of the recording. Errors: those of ReaderProcess.
Result<std::shared_ptr<const VariableReader>> open_library(
    const std::shared_ptr<const FileBytes>& file, const std::string& kind,
    const std::string& format);

// Whether a file with these first bytes is of HDF5, as MATLAB's are from level 7.3 on. The
// signature may also be at 512, 1024, 2048, ...
bool is_hdf5(std::string_view head, const FileBytes& file);

// A MAT 7.3 or HDF5 file, read on demand by vybeg-reader. Errors: those of open_variables() and
// ReaderProcess.
Result<Recording> open_hdf5(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

}  // namespace vybeg
