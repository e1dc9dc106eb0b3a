#pragma once

#include "core/recording/bytes/file_bytes.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/core/recording/python_script.h"
#include "tests/core/recording/recording_files.h"
#include "tests/needed.h"

// The demonstration decay for other programs to write in their formats.
namespace vybeg::test {

// One second of it.
inline Samples demo_second() {
    FreeDecay decay = demo_decay();
    decay.seconds = 1;
    auto simulated = needed(simulate(decay, {}));
    return {std::move(simulated.c), std::move(simulated.d)};
}

// Runs a script that finds the samples as the NumPy vectors c and d, and their rate as fs.
inline void write_with_python(const Folder& folder, const Samples& samples, const QString& script) {
    const auto bytes = [](const std::vector<double>& x) {
        return std::string_view(reinterpret_cast<const char*>(x.data()), x.size() * sizeof x[0]);
    };
    folder.write("c.f64", bytes(samples.c));
    folder.write("d.f64", bytes(samples.d));
    run_python(folder.file(""),
               "c, d, fs = np.fromfile('c.f64'), np.fromfile('d.f64'), 33333.0\n" + script);
}

// Writes them as HDF5: run.h5 as they are, packed.h5 in pieces.
inline const char* const plain_and_packed = R"(
import h5py
with h5py.File('run.h5', 'w') as plain, h5py.File('packed.h5', 'w') as packed:
    for name, x in (('C', c), ('D', d)):
        plain.create_dataset(name, data=x)
        packed.create_dataset(name, data=x, chunks=(1000,), compression='gzip')
    plain.attrs['fs'] = packed.attrs['fs'] = fs
)";

inline std::shared_ptr<const FileBytes> file_at(const std::filesystem::path& path) {
    return needed(FileBytes::open(path));
}

// Every sample rounded to 32 bit float.
inline std::vector<double> as_float(std::vector<double> x) {
    for (double& sample : x) {
        sample = static_cast<double>(static_cast<float>(sample));
    }
    return x;
}

// Every sample as the whole number of 16 bits that np.round(1000 * x) makes of it.
inline std::vector<double> as_counts(std::vector<double> x) {
    for (double& sample : x) {
        sample = std::nearbyint(1000 * sample);
    }
    return x;
}

// What a file keeps of the samples.
enum class Rounding { none, to_float, to_counts };

inline Samples rounded(const Samples& samples, Rounding rounding) {
    const auto kept = [&](const std::vector<double>& x) {
        return rounding == Rounding::none       ? x
               : rounding == Rounding::to_float ? as_float(x)
                                                : as_counts(x);
    };
    return {kept(samples.c), kept(samples.d)};
}

}  // namespace vybeg::test
