#include "core/recording/variables/hdf5_reader.h"

#include "core/recording/variables/variable_reader.h"
#include "core/recording/variables/variable_recording.h"

#include <array>
#include <utility>

namespace vybeg {
namespace {

constexpr std::string_view hdf5_signature("\x89HDF\r\n\x1a\n", 8);
constexpr std::string_view matlab_signature = "MATLAB 7.3 MAT-file";

}  // namespace

bool is_hdf5(std::string_view head, const FileBytes& file) {
    if (head.starts_with(matlab_signature)) {
        return true;
    }
    std::array<char, hdf5_signature.size()> bytes{};
    for (std::int64_t at = 0; at < file.size(); at = at == 0 ? 512 : 2 * at) {
        const auto got = file.read(at, bytes);
        if (got && std::string_view(bytes.data(), bytes.size()) == hdf5_signature) {
            return true;
        }
    }
    return false;
}

Result<Recording> open_hdf5(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                            const JobControl& job) {
    const auto head = TRY(file->text(0, std::ssize(matlab_signature)));
    const bool matlab = head == matlab_signature;
    const LibraryFormat format =
        matlab ? LibraryFormat{"mat73", "MAT 7.3"} : LibraryFormat{"hdf5", "HDF5"};
    auto process = TRY(ReaderProcess::start(file, format.kind, format.name));
    VariableFile variables;
    variables.file = file;
    variables.catalogue = process->catalogue();
    variables.reader = std::make_shared<LibraryVariables>(file, format, std::move(process));
    return open_variables(variables, options, job);
}

}  // namespace vybeg
