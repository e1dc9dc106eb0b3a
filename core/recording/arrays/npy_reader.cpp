#include "core/recording/arrays/npy_reader.h"

#include "core/base/translatable.h"
#include "core/recording/arrays/npy_array.h"
#include "core/recording/samples/reader_rules.h"

#include <utility>

namespace vybeg {

Result<Recording> open_npy(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                           const JobControl& /*job*/) {
    const auto bytes = file_part(file, 0, file->size());
    const auto array = TRY(read_npy_header(*file, *bytes, "NPY"));
    const auto channels = static_cast<int>(array.channels());
    TRY(check_channels(*file, channels, options));
    FoundSamples found;
    found.format = {FormatPart::name("NPY"), FormatPart::words(name_of(array.type)),
                    byte_order_part(array.big_endian),
                    FormatPart::words(array.fortran_order ? VYBEG_MESSAGE("Format", "Fortran order")
                                                          : VYBEG_MESSAGE("Format", "C order")),
                    FormatPart::channels(channels)};
    found.channels = numbered_channels(channels);
    found.promised_frames = array.frames();
    found.source = column_source(npy_column(array, bytes, options.channel_c - 1),
                                 npy_column(array, bytes, options.channel_d - 1));
    found.frames = found.source->frames();
    return complete_recording(*file, std::move(found), options);
}

}  // namespace vybeg
