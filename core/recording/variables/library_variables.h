#pragma once

#include "core/base/guarded.h"
#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"
#include "core/recording/variables/reader_process.h"
#include "core/recording/variables/variable_recording.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace vybeg {

// A file of MATLAB's or HDF5's, or audio; vybeg-reader knows the kinds "mat73", "hdf5" and "audio".
struct LibraryFormat {
    std::string kind;
    std::string name;    // "MAT 7.3", ...
    bool seeks = false;  // as SampleSource::seeks(); a packed variable is unpacked from its start
};

// Variables read by vybeg-reader. A helper that died or was given up is replaced at the next read:
// a damaged segment does not cost the rest of the recording. Errors: those of ReaderProcess.
class LibraryVariables final : public VariableReader,
                               public std::enable_shared_from_this<LibraryVariables> {
public:
    LibraryVariables(std::shared_ptr<const FileBytes> file, LibraryFormat format,
                     std::unique_ptr<ReaderProcess> process);

    Status read(const ChannelPlace& place, std::int64_t first,
                std::span<double> out) const override;
    Result<std::shared_ptr<const SampleSource>> source(const ChannelPlace& c, const ChannelPlace& d,
                                                       std::int64_t frames) const override;

private:
    std::shared_ptr<const FileBytes> file_;
    LibraryFormat format_;
    Guarded<std::unique_ptr<ReaderProcess>> process_;
};

// Whether a file with these first bytes is of HDF5, as MATLAB's are from level 7.3 on. The
// signature may also stand at 512, 1024, 2048, ...
bool is_hdf5(std::string_view head, const FileBytes& file);

// A MAT 7.3 or HDF5 file, read on demand by vybeg-reader. Errors: those of open_variables() and
// ReaderProcess.
Result<Recording> open_hdf5(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job);

}  // namespace vybeg
