#pragma once

#include "core/recording/bytes/number_type.h"
#include "tests/core/recording/recording_files.h"

#include <cstdint>
#include <string>
#include <vector>

// TDMS files as National Instruments published their layout.
namespace vybeg::test {

// Types of values.
inline constexpr std::uint32_t tds_i8 = 1, tds_i16 = 2, tds_i32 = 3, tds_i64 = 4, tds_u8 = 5,
                               tds_u16 = 6, tds_u32 = 7, tds_f32 = 9, tds_f64 = 10,
                               tds_string = 0x20, tds_boolean = 0x21, tds_time = 0x44;

// Bits of a segment's table of contents.
inline constexpr std::uint32_t toc_metadata = 2, toc_new_list = 4, toc_raw = 8,
                               toc_interleaved = 32, toc_big_endian = 64, toc_daqmx = 128;

// Writes the parts of a file in one byte order.
struct Tdms {
    bool big_endian = false;

    template <class Number>
    std::string number(Number value) const {
        return store(value, big_endian);
    }

    std::string text(const std::string& t) const {
        return number(static_cast<std::uint32_t>(t.size())) + t;
    }

    // Properties.
    std::string real(const std::string& name, double value) const {
        return text(name) + number(tds_f64) + number(value);
    }
    std::string whole(const std::string& name, std::int32_t value) const {
        return text(name) + number(tds_i32) + number(value);
    }
    std::string count(const std::string& name, std::uint32_t value) const {
        return text(name) + number(std::uint32_t{7}) + number(value);
    }
    std::string words(const std::string& name, const std::string& value) const {
        return text(name) + number(tds_string) + text(value);
    }
    std::string time(const std::string& name, std::int64_t seconds, std::uint64_t fraction) const {
        const std::string parts[] = {number(fraction), number(seconds)};
        return text(name) + number(tds_time) + parts[big_endian ? 1 : 0] +
               parts[big_endian ? 0 : 1];
    }

    // Raw data indices of an object.
    std::string values(std::uint32_t type, std::uint64_t count) const {
        return number(std::uint32_t{20}) + number(type) + number(std::uint32_t{1}) + number(count);
    }
    std::string strings(std::uint64_t count, std::uint64_t bytes) const {
        return number(std::uint32_t{28}) + number(tds_string) + number(std::uint32_t{1}) +
               number(count) + number(bytes);
    }
    // A scaler of DAQmx: the type's code in its own numbering, where its numbers stand, and the
    // scale that takes them.
    std::string scaler(std::uint32_t type, std::uint32_t offset, std::uint32_t id = 0,
                       std::uint32_t buffer = 0) const {
        return number(type) + number(buffer) + number(offset) + number(std::uint32_t{0}) +
               number(id);
    }
    // A digital line, which counts its place in bits.
    std::string line(std::uint32_t type, std::uint32_t bit, std::uint32_t id = 0) const {
        return number(type) + number(std::uint32_t{0}) + number(bit) + std::string(1, '\0') +
               number(id);
    }
    std::string daqmx(std::uint64_t count, const std::vector<std::string>& scalers,
                      const std::vector<std::uint32_t>& widths, std::uint32_t kind = 0x1269,
                      std::uint32_t type = 0xFFFFFFFF) const {
        std::string bytes = number(kind) + number(type) + number(std::uint32_t{1}) + number(count) +
                            number(static_cast<std::uint32_t>(scalers.size()));
        for (const std::string& scaler : scalers) {
            bytes += scaler;
        }
        bytes += number(static_cast<std::uint32_t>(widths.size()));
        for (const std::uint32_t width : widths) {
            bytes += number(width);
        }
        return bytes;
    }
    std::string as_before() const { return number(std::uint32_t{0}); }
    std::string no_values() const { return number(~std::uint32_t{0}); }

    std::string object(const std::string& path, const std::string& index,
                       const std::vector<std::string>& properties = {}) const {
        std::string bytes =
            text(path) + index + number(static_cast<std::uint32_t>(properties.size()));
        for (const std::string& property : properties) {
            bytes += property;
        }
        return bytes;
    }

    std::string metadata(const std::vector<std::string>& objects) const {
        std::string bytes = number(static_cast<std::uint32_t>(objects.size()));
        for (const std::string& object : objects) {
            bytes += object;
        }
        return bytes;
    }

    std::string lead_in(std::uint32_t contents, std::uint64_t next, std::uint64_t raw) const {
        return "TDSm" + store(contents | (big_endian ? toc_big_endian : 0), false) +
               number(std::uint32_t{4713}) + number(next) + number(raw);
    }

    std::string segment(std::uint32_t contents, const std::string& metadata,
                        const std::string& raw) const {
        return lead_in(contents, metadata.size() + raw.size(), metadata.size()) + metadata + raw;
    }

    // Numbers as raw data.
    template <class Number>
    std::string raw(const std::vector<double>& samples) const {
        std::string bytes;
        for (const double sample : samples) {
            bytes += number(static_cast<Number>(sample));
        }
        return bytes;
    }
};

// What the tests of the reader share: the channels C and D of a group.
inline constexpr const char* path_c = "/'Run'/'C'";
inline constexpr const char* path_d = "/'Run'/'D'";
inline constexpr std::uint32_t first_segment = toc_metadata | toc_new_list | toc_raw;

inline std::vector<double> part(const std::vector<double>& x, std::size_t first,
                                std::size_t count) {
    return {x.begin() + static_cast<std::ptrdiff_t>(first),
            x.begin() + static_cast<std::ptrdiff_t>(first + count)};
}

inline std::vector<double> interleaved(const std::vector<double>& c, const std::vector<double>& d) {
    std::vector<double> both;
    for (std::size_t i = 0; i < c.size(); ++i) {
        both.insert(both.end(), {c[i], d[i]});
    }
    return both;
}

// Whole numbers from 0 to 100, C and D different.
inline Samples whole_numbers(std::size_t count) {
    Samples samples;
    for (std::size_t i = 0; i < count; ++i) {
        samples.c.push_back(static_cast<double>(7 * i % 101));
        samples.d.push_back(static_cast<double>(5 * i % 97));
    }
    return samples;
}

// The metadata of C and D with so many values each in a chunk.
inline std::string both_channels(const Tdms& t, std::uint32_t type, std::uint64_t count) {
    return t.metadata({t.object("/", t.no_values()), t.object("/'Run'", t.no_values()),
                       t.object(path_c, t.values(type, count),
                                {t.real("wf_increment", 3e-5), t.words("unit_string", "V")}),
                       t.object(path_d, t.values(type, count), {t.words("unit_string", "V")})});
}

// One segment of one chunk.
inline std::string small_file(const Samples& samples, const Tdms& t = {}) {
    return t.segment(first_segment, both_channels(t, tds_f64, samples.c.size()),
                     t.raw<double>(samples.c) + t.raw<double>(samples.d));
}

}  // namespace vybeg::test
