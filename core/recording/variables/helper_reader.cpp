#include "core/recording/variables/helper_reader.h"

#include "core/recording/variables/mat_format.h"
#include "core/recording/variables/mat_reader.h"
#include "core/recording/variables/variable_recording.h"

#include <array>
#include <utility>

namespace vybeg {
namespace {

constexpr const char* mat_kind = "mat";  // of level 4 and 5
constexpr std::string_view hdf5_signature("\x89HDF\r\n\x1a\n", 8);

bool is_hdf5(const FileBytes& file) {
    std::array<char, hdf5_signature.size()> bytes{};
    for (std::int64_t at = 0; at < file.size(); at = at == 0 ? 512 : 2 * at) {
        const auto got = file.read(at, bytes);
        if (got && std::string_view(bytes.data(), bytes.size()) == hdf5_signature) {
            return true;
        }
    }
    return false;
}

}  // namespace

std::optional<LibraryFormat> library_format(std::string_view head, const FileBytes& file) {
    if (is_mat5(head)) {
        return LibraryFormat{mat_kind, "MAT 5"};
    }
    if (head.starts_with("MATLAB 7.3 MAT-file")) {
        return LibraryFormat{"mat73", "MAT 7.3"};
    }
    if (is_hdf5(file)) {
        return LibraryFormat{"hdf5", "HDF5"};
    }
    if (is_mat4(head, file.size())) {
        return LibraryFormat{mat_kind, "MAT 4"};
    }
    return {};
}

Result<Recording> open_with_library(std::shared_ptr<const FileBytes> file,
                                    const LibraryFormat& format, const OpenOptions& options,
                                    const JobControl& job) {
    if (format.kind == mat_kind) {
        return open_mat(std::move(file), options, job);
    }
    auto process = TRY(ReaderProcess::start(file, format.kind, format.name));
    VariableFile variables;
    variables.file = file;
    variables.format = format.name;
    variables.catalogue = process->catalogue();
    variables.reader = std::make_shared<LibraryVariables>(file, format, std::move(process));
    variables.source = [reader = variables.reader](const ChannelPlace& c, const ChannelPlace& d,
                                                   std::int64_t frames) {
        return variable_source(reader, c, d, frames);
    };
    return open_variables(variables, options, job);
}

}  // namespace vybeg
