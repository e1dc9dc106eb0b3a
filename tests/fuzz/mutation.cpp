#include "tests/fuzz/mutation.h"

#include "core/recording/bytes/number_type.h"

#include <algorithm>
#include <limits>
#include <random>
#include <string_view>

namespace vybeg::fuzz {
namespace {

constexpr std::size_t edge_bytes = 600;  // the head and the tail that are hit most

class Mutator {
public:
    Mutator(std::string bytes, std::uint64_t seed) : bytes_(std::move(bytes)), random_(seed) {}

    void apply(Damage damage) {
        switch (damage) {
            case Damage::cut: bytes_.resize(place()); return;
            case Damage::bits: return flip_bits();
            case Damage::bytes: return write(anything(1 + below(16)));
            case Damage::length: return write(length());
            case Damage::real: return write(real());
            case Damage::digits: return write_digits();
            case Damage::moved: return move();
            case Damage::missing: bytes_.erase(place(), 1 + below(64)); return;
            case Damage::zeros: return write(std::string(1 + below(64), '\0'));
        }
    }

    std::uint64_t below(std::uint64_t end) { return random_() % end; }
    std::string take() { return std::move(bytes_); }

private:
    // Of a byte; 0 where there is none.
    std::size_t place() {
        const std::size_t size = bytes_.size();
        if (size == 0) {
            return 0;
        }
        const std::size_t edge = std::min(size, edge_bytes);
        switch (below(4)) {
            case 0: return below(size);
            case 1: return size - 1 - below(edge);
            default: return below(edge);
        }
    }

    void flip_bits() {
        for (std::uint64_t flips = 1 + below(3); flips > 0 && !bytes_.empty(); --flips) {
            const std::size_t at = place();
            bytes_[at] = static_cast<char>(bytes_[at] ^ (1 << below(8)));
        }
    }

    std::string anything(std::size_t size) {
        std::string bytes(size, '\0');
        for (char& byte : bytes) {
            byte = static_cast<char>(random_());
        }
        return bytes;
    }

    // Over what stands there, as far as the file goes; mostly where fields begin.
    void write(const std::string& bytes) {
        if (bytes.empty()) {
            return;
        }
        std::size_t at = place();
        at -= below(2) == 0 ? at % std::min<std::size_t>(bytes.size(), 4) : 0;
        const std::size_t count = std::min(bytes.size(), bytes_.size() - at);
        bytes_.replace(at, count, bytes, 0, count);
    }

    std::string length() {
        constexpr std::uint64_t one = 1;
        constexpr std::array<std::uint64_t, 16> values{0,
                                                       1,
                                                       (one << 15) - 1,
                                                       one << 15,
                                                       (one << 16) - 1,
                                                       (one << 31) - 1,
                                                       one << 31,
                                                       one << 28,
                                                       (one << 32) - 1,
                                                       one << 32,
                                                       one << 40,
                                                       one << 60,
                                                       one << 62,
                                                       one << 63,
                                                       (one << 63) - 1,
                                                       ~std::uint64_t{0}};
        const std::uint64_t value = values[below(values.size())];
        const bool big_endian = below(3) == 0;
        switch (below(3)) {
            case 0: return store(static_cast<std::uint16_t>(value), big_endian);
            case 1: return store(static_cast<std::uint32_t>(value), big_endian);
            default: return store(value, big_endian);
        }
    }

    std::string real() {
        using Limits = std::numeric_limits<double>;
        constexpr std::array<double, 9> values{Limits::quiet_NaN(),
                                               Limits::infinity(),
                                               -Limits::infinity(),
                                               0,
                                               -1,
                                               1e300,
                                               -1e-300,
                                               Limits::denorm_min(),
                                               1e-30};
        const double value = values[below(values.size())];
        const bool big_endian = below(3) == 0;
        return below(3) == 0 ? store(static_cast<float>(value), big_endian)
                             : store(value, big_endian);
    }

    // The number in letters at or behind a place.
    void write_digits() {
        constexpr std::string_view digits = "0123456789";
        constexpr std::array<const char*, 14> values{"9223372036854775808",
                                                     "18446744073709551615",
                                                     "-1",
                                                     "0",
                                                     "nan",
                                                     "inf",
                                                     "1e999",
                                                     "1e-999",
                                                     "4294967296",
                                                     "1e9",
                                                     "1.5",
                                                     "",
                                                     "--1",
                                                     "1e300"};
        const std::size_t begin = bytes_.find_first_of(digits, place());
        if (begin == std::string::npos) {
            return;
        }
        const std::size_t end = std::min(bytes_.find_first_not_of(digits, begin), bytes_.size());
        bytes_.replace(begin, end - begin, values[below(values.size())]);
    }

    void move() {
        const std::string piece = bytes_.substr(place(), 1 + below(200));
        if (below(2) == 0) {
            bytes_.insert(place(), piece);
        } else {
            write(piece);
        }
    }

    std::string bytes_;
    std::mt19937_64 random_;
};

}  // namespace

Mutation mutated(const std::vector<std::string>& files, std::uint64_t seed) {
    Mutator mutator(files[seed % files.size()], seed);
    Mutation mutation;
    const std::uint64_t damages = 1 + (mutator.below(4) == 0 ? 1 : 0);
    for (std::uint64_t i = 0; i < damages; ++i) {
        const auto kind = mutator.below(damage_names.size());
        mutator.apply(static_cast<Damage>(kind));
        mutation.what += (i > 0 ? ", " : "") + std::string(damage_names[kind]);
    }
    mutation.bytes = mutator.take();
    return mutation;
}

}  // namespace vybeg::fuzz
