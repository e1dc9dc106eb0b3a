#pragma once

#include "core/base/result.h"
#include "core/recording/file_bytes.h"
#include "core/recording/reader_protocol.h"

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <sys/types.h>

namespace vybeg {

// A vybeg-reader that has a file open: libmatio and HDF5 crash, hang or take all memory on some
// damaged files, and there they do it alone. Not for several threads at once.
class ReaderProcess {
public:
    // Starts vybeg-reader, which lies beside the running program, on a file of the given kind
    // ("mat", "mat73", "hdf5"); `format` names it in errors. Errors: format_damaged,
    // format_unsupported; file_read_failed, where the helper itself cannot be had.
    static Result<std::unique_ptr<ReaderProcess>> start(std::shared_ptr<const FileBytes> file,
                                                        const std::string& kind,
                                                        const std::string& format);

    ReaderProcess(const ReaderProcess&) = delete;
    ReaderProcess& operator=(const ReaderProcess&) = delete;
    ~ReaderProcess();

    const Catalogue& catalogue() const { return catalogue_; }
    pid_t id() const { return id_; }

    // Precondition: fits(request, catalogue()), and `out` has request.count places. Errors:
    // format_damaged, also where the helper died; it is of no use afterwards.
    Status read(const SampleRequest& request, std::span<double> out);

private:
    ReaderProcess(std::shared_ptr<const FileBytes> file, std::string format, int socket, pid_t id);

    Status take_catalogue();
    void allow(int seconds);
    std::optional<std::string> receive_text(const Reply& reply);
    Error failed_reply(const Reply& reply, int seconds);
    Error broken_off(int seconds);
    int end();
    Error damaged(const std::string& reason) const;

    std::shared_ptr<const FileBytes> file_;
    std::string format_;
    int socket_;
    pid_t id_;
    Catalogue catalogue_;
};

}  // namespace vybeg
