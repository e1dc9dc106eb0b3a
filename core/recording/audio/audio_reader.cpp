#include "core/recording/audio/audio_reader.h"

#include "core/recording/audio/audio_extent.h"
#include "core/recording/samples/column_source.h"
#include "core/recording/samples/reader_rules.h"
#include "core/recording/variables/library_variables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace vybeg {
namespace {

// In place, at the speed of memory and for several threads at once.
Result<Recording> open_plain(const std::shared_ptr<const FileBytes>& file,
                             const AudioExtent& header, const OpenOptions& options) {
    const PlainSamples& plain = *header.plain;
    TRY(check_channels(*file, plain.channels, options));
    FoundSamples found;
    found.format = {FormatPart::name(plain.container), FormatPart::words(plain.type_name),
                    FormatPart::channels(plain.channels)};
    found.channels = numbered_channels(plain.channels);
    found.own_rate = SampleRate{static_cast<double>(plain.rate_hz), RateOrigin::file};
    found.start = plain.start;
    found.present_frames = plain.frames;
    found.promised_frames = std::max(header.promised_frames.value_or(0), plain.frames);
    found.never_closed = header.never_closed;
    found.source = interleaved_source(file, plain, options.channel_c, options.channel_d);
    return complete_recording(*file, std::move(found), options);
}

// Number of frames that can be decoded from the start. If the last frame of the header cannot be
// decoded, only decoding shows the number.
Result<std::int64_t> count_frames(const VariableReader& reader, std::int64_t promised,
                                  const JobControl& job) {
    constexpr std::int64_t large_step = 4096;
    std::array<double, large_step> samples{};
    const std::span all(samples);
    if (promised == 0 || reader.read({}, promised - 1, all.first(1))) {
        return promised;
    }
    std::int64_t frames = 0;
    // In large steps to the damage, then frame by frame up to it.
    for (const std::int64_t step : {large_step, std::int64_t{1}}) {
        while (frames < promised) {
            TRY(job.go_on());
            const std::int64_t count = std::min(step, promised - frames);
            if (!reader.read({}, frames, all.first(static_cast<std::size_t>(count)))) {
                break;
            }
            frames += count;
        }
    }
    return frames;
}

Result<Recording> open_decoded(const std::shared_ptr<const FileBytes>& file,
                               const std::string& container, const AudioExtent& header,
                               const OpenOptions& options, const JobControl& job) {
    const LibraryFormat format{"audio", container, true};
    auto process = TRY(ReaderProcess::start(file, format.kind, format.name));
    const Catalogue catalogue = process->catalogue();
    if (catalogue.variables.size() != 1) {
        return file->damaged(container, VYBEG_MESSAGE("Words", "its library returned nonsense"));
    }
    const FileVariable& samples = catalogue.variables.front();
    const auto channels = static_cast<int>(samples.channels);
    TRY(check_channels(*file, channels, options));
    SampleRate own{header.rate_is_zero ? 0.0 : samples.rate_hz.value_or(0), RateOrigin::file};
    if (header.rate_hz && std::abs(*header.rate_hz - own.hz) < 1) {
        own.hz = *header.rate_hz;
    }
    // Checked before frames are counted.
    TRY(choose_rate(*file, own, options));
    const auto reader = std::make_shared<LibraryVariables>(file, format, std::move(process));
    const auto frames = TRY(count_frames(*reader, samples.frames, job));
    FoundSamples found;
    found.format = {FormatPart::name(catalogue.format), FormatPart::words(samples.type),
                    FormatPart::channels(channels)};
    found.channels = numbered_channels(channels);
    found.own_rate = own;
    found.start = catalogue.start;
    found.present_frames = frames;
    // A FLAC stream without its number of frames has the greatest one here.
    const bool is_open = samples.frames == std::numeric_limits<std::int64_t>::max();
    found.promised_frames =
        std::max(header.promised_frames.value_or(0), is_open ? 0 : samples.frames);
    found.never_closed = header.never_closed;
    auto source =
        TRY(reader->source({0, options.channel_c - 1}, {0, options.channel_d - 1}, frames));
    found.source = std::move(source);
    return complete_recording(*file, std::move(found), options);
}

}  // namespace

Result<Recording> open_audio(std::shared_ptr<const FileBytes> file, const OpenOptions& options,
                             const JobControl& job) {
    const auto head = TRY(file->text(0, 16));
    const auto header = TRY(audio_extent(*file));
    constexpr int most_bits = 32;
    if (header.bits > most_bits && !header.plain) {
        return file->error(
            ErrorCode::format_limit,
            {words(VYBEG_MESSAGE("Words", "audio")),
             words(VYBEG_MESSAGE("Words", "integers of %1 bits; up to %2, and 64 in WAV, are read"),
                   {count_arg(header.bits), count_arg(most_bits)}),
             words(VYBEG_MESSAGE("Words", "Save the recording with 32 bits or as floats"))});
    }
    const std::string container = audio_container(head);
    return header.plain
               ? open_plain(file, header, options)
               : open_decoded(file, container.empty() ? "FLAC" : container, header, options, job);
}

}  // namespace vybeg
