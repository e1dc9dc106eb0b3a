#pragma once

#include "tests/core/recording/recording_files.h"

#include <QElapsedTimer>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

// What every reader must stand: files cut at any byte, and files with wrong bits.
namespace vybeg::test {

struct DamageCount {
    int refused = 0;       // the file did not open
    int unreadable = 0;    // it opened, and a read further in failed
    int read = 0;          // it opened, and all of its frames could be read
    int wrong_status = 0;  // an error that is not of the input group
    int too_long = 0;      // more frames than its bytes can hold
    qint64 slowest_ms = 0;
};

// Opens the file, reads it through and removes it: overwriting it would wait for the disk each
// time. `most_frames` is what the undamaged file could hold at most.
inline void try_damaged(const std::filesystem::path& path, const OpenOptions& options,
                        std::int64_t most_frames, DamageCount& count) {
    QElapsedTimer timer;
    timer.start();
    const auto recording = open(path, options);
    if (!recording) {
        ++count.refused;
        count.wrong_status += exit_status(recording.error().code) == 3 ? 0 : 1;
    } else if (recording->frames() > most_frames || recording->frames() < 5) {
        ++count.too_long;
    } else {
        constexpr std::int64_t step = 1000;
        std::vector<double> c(step), d(step);
        Status status;
        for (std::int64_t at = 0; status && at < recording->frames(); at += step) {
            const auto length = static_cast<std::size_t>(std::min(step, recording->frames() - at));
            status =
                recording->source->read(at, std::span(c).first(length), std::span(d).first(length));
        }
        ++(status ? count.read : count.unreadable);
        count.wrong_status += status || exit_status(status.error().code) == 3 ? 0 : 1;
    }
    std::filesystem::remove(path);
    count.slowest_ms = std::max(count.slowest_ms, timer.elapsed());
}

// The file cut after each of its bytes but the last.
inline DamageCount cut_everywhere(const Folder& folder, std::string_view bytes,
                                  const OpenOptions& options, std::int64_t most_frames) {
    DamageCount count;
    for (std::size_t length = 1; length < bytes.size(); ++length) {
        try_damaged(folder.write("cut", bytes.substr(0, length)), options, most_frames, count);
    }
    return count;
}

// The file with one to three wrong bits among its first `head` bytes and its last `tail` bytes.
inline DamageCount flip_bits(const Folder& folder, std::string_view bytes, std::size_t head,
                             std::size_t tail, const OpenOptions& options, std::int64_t most_frames,
                             int files = 2000) {
    DamageCount count;
    std::mt19937_64 random(20201);
    head = std::min(head, bytes.size());
    for (int file = 0; file < files; ++file) {
        std::string damaged(bytes);
        for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips) {
            const std::size_t place = random() % (head + tail);
            const std::size_t at = place < head ? place : bytes.size() - 1 - (place - head);
            damaged[at] = static_cast<char>(damaged[at] ^ (1 << random() % 8));
        }
        try_damaged(folder.write("flipped", damaged), options, most_frames, count);
    }
    return count;
}

}  // namespace vybeg::test
