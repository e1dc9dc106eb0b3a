#pragma once

#include "core/base/job_control.h"
#include "core/base/result.h"
#include "core/recording/bytes/file_bytes.h"
#include "core/recording/bytes/number_type.h"
#include "core/recording/samples/open_options.h"
#include "core/recording/samples/recording.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace vybeg {

// Number type of the samples of a layout.
NumberType number_type(RawType type);

// Headerless interleaved samples by options.raw, read on demand; one count is `scale` recording
// units. Bytes after the last whole frame are ignored. Precondition: options.raw is set. Errors:
// setting_invalid, too_few_channels, channel_out_of_range, too_few_frames, rate_unknown.
Result<Recording> open_raw(std::shared_ptr<const FileBytes> file, const OpenOptions& options);

// What the file beside the samples says of them.
struct ZetlabHeader {
    double rate_hz = 0;
    double scale = 1;  // units per unit of the samples
    std::string unit{};
    std::string name{};
};

// The text of an .anp file ("FRQ 25000", "ABSVOLT 1.5e-5", "CONVERT mV", "NAME ...") or an .xml
// file
// (<Signal frequency="25000" minlevel="1.5e-5" conversion="mV" name="..."/>), in UTF-8 or
// Windows-1251. Nothing where it states no rate.
std::optional<ZetlabHeader> parse_zetlab_header(std::string_view text);

// By its name, NAME.ana: it holds samples and nothing else.
bool is_zetlab(std::string_view head, const FileBytes& file);

// 32 bit floats of one channel, described by NAME.xml or NAME.anp beside them, which then belongs
// to the recording. Errors: too_few_channels where two are wanted; header_missing; those of
// complete_recording().
Result<Recording> open_zetlab(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                              const JobControl& job);

}  // namespace vybeg
