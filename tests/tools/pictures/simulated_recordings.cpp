#include "tests/tools/pictures/simulated_recordings.h"

#include "core/base/messages.h"
#include "core/output/output_file.h"
#include "core/output/sample_files.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"

#include <cstdint>
#include <numbers>
#include <stdexcept>

namespace vybeg::test {
namespace {

Status write_recording(const FreeDecay& decay, const QString& path) {
    const auto samples = simulate(decay, JobControl());
    if (!samples) {
        return samples.error();
    }
    auto file = OutputFile::create(path.toStdString(), JobControl());
    if (!file) {
        return file.error();
    }
    const Status written = write_samples(*file, SampleFormat::wav,
                                         {samples->c, samples->d, decay.rate_hz}, JobControl());
    return written ? file->commit() : written;
}

QString recording(const FreeDecay& decay, const QString& path) {
    if (const Status written = write_recording(decay, path); !written) {
        throw std::runtime_error(english(written.error()));
    }
    return path;
}

}  // namespace

QString write_demonstration(const QDir& folder) {
    return recording(demo_decay(), folder.filePath(QStringLiteral("demonstration.wav")));
}

QStringList write_simulated_set(const QDir& folder) {
    QStringList paths;
    for (int k = 0; k < 4; ++k) {
        FreeDecay decay;
        decay.seconds = 28;
        decay.f0_hz = 5300 + 0.01 * k;
        decay.two_theta_A = k * std::numbers::pi / 4;
        decay.split_hz = 2e-3;
        decay.theta_w = 0.35;
        decay.tau_s = 30;
        decay.damping_anisotropy_per_s = 2e-4;
        decay.theta_tau = -0.2;
        decay.noise = 1e-3;
        decay.seed = static_cast<std::uint64_t>(k) + 1;
        paths << recording(decay, folder.filePath(QStringLiteral("HRG-17_%1.wav").arg(22.5 * k)));
    }
    return paths;
}

}  // namespace vybeg::test
