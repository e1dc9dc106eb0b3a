#include "tests/tools/pictures/simulated_recordings.h"

#include "core/base/error.h"
#include "core/base/number_text.h"
#include "core/output/output_file.h"
#include "core/output/sample_files.h"
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/core/drift/simulated_log.h"

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
                                         in_memory(samples->c, samples->d, decay.rate_hz, {}));
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

QStringList write_simulated_logs(const QDir& folder) {
    QStringList paths;
    for (const double turn : {0.05, -0.04, 0.08}) {
        HeldLoop loop;
        loop.turn = turn;
        loop.c2 = 4e-6;
        loop.s2 = -2e-6;
        loop.c4 = 1.2e-5;
        loop.s4 = 2.5e-5;
        loop.white = 2e-5;
        loop.walk = 2e-6;
        loop.effort_noise = 1e-3;
        loop.seed = static_cast<unsigned>(paths.size()) + 1;
        const WholeAngleLog log = simulated_log(loop);
        std::string text = "t_s,theta_rad,amplitude,quadrature\n";
        for (std::size_t k = 0; k < log.time_s.size(); ++k) {
            for (const double value : {log.time_s[k], log.theta[k], log.amplitude_effort[k]}) {
                append_round_trip(text, value);
                text += ',';
            }
            append_round_trip(text, log.quadrature_effort[k]);
            text += '\n';
        }
        const QString path =
            folder.filePath(QStringLiteral("HRG-17_turn_%1.csv").arg(paths.size() + 1));
        if (const Status written = write_file(path.toStdString(), text, JobControl()); !written) {
            throw std::runtime_error(english(written.error()));
        }
        paths << path;
    }
    return paths;
}

}  // namespace vybeg::test
