#include "core/resonator/model/power_run.h"

#include "core/numerics/statistics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <utility>

namespace vybeg {
namespace {

struct Powers {
    double time_s = 0;
    double e = 0;
    double r = 0;
    double s = 0;
    double q = 0;
};

// Means of `merged` rows each.
std::vector<Powers> rows_of(const PowerRun& run, std::size_t most) {
    std::vector<Powers> good;
    for (std::size_t k = 0; k < run.time_s.size(); ++k) {
        const Powers row{run.time_s[k], run.e[k], run.r[k], run.s[k], run.q[k]};
        const double size = std::sqrt(row.r * row.r + row.s * row.s + row.q * row.q);
        if (std::isfinite(row.e + size) && row.e > 0 && size > 0) {
            good.push_back(row);
        }
    }
    const std::size_t merged = (good.size() + most - 1) / most;
    std::vector<Powers> rows;
    for (std::size_t first = 0; merged > 0 && first + merged <= good.size(); first += merged) {
        Powers mean;
        for (std::size_t k = first; k < first + merged; ++k) {
            mean.time_s += good[k].time_s;
            mean.e += good[k].e;
            mean.r += good[k].r;
            mean.s += good[k].s;
            mean.q += good[k].q;
        }
        const auto count = static_cast<double>(merged);
        rows.push_back(
            {mean.time_s / count, mean.e / count, mean.r / count, mean.s / count, mean.q / count});
    }
    return rows;
}

}  // namespace

PowerRun powers_of_waves(std::vector<double> time_s, const std::vector<double>& a_A,
                         const std::vector<double>& a_B, const std::vector<double>& theta_A) {
    PowerRun run;
    for (std::size_t k = 0; k < time_s.size(); ++k) {
        const double linear = a_A[k] * a_A[k] - a_B[k] * a_B[k];
        run.e.push_back(a_A[k] * a_A[k] + a_B[k] * a_B[k]);
        run.r.push_back(linear * std::cos(4 * theta_A[k]));
        run.s.push_back(linear * std::sin(4 * theta_A[k]));
        run.q.push_back(2 * a_A[k] * a_B[k]);
    }
    run.time_s = std::move(time_s);
    return run;
}

PowerMismatch power_mismatch(const PowerRun& run) {
    const std::vector<Powers> rows = rows_of(run, run.time_s.size());
    const auto excess = [&rows](std::size_t k) {
        const Powers& row = rows[k];
        return row.r * row.r + row.s * row.s + row.q * row.q - row.e * row.e;
    };
    // Of the rows [first, end); zero where noise explains it.
    const auto mismatch_of = [&](std::size_t first, std::size_t end) {
        double sum = 0;
        double square = 0;  // of changes from row to row, which hold the noise alone
        double power = 0;
        double others = 0;  // of R, S and Q, of the same size unless units are exchanged
        for (std::size_t k = first; k < end; ++k) {
            sum += excess(k);
            power += rows[k].e * rows[k].e;
            others += excess(k) + rows[k].e * rows[k].e;
            const double change = k > first ? excess(k) - excess(k - 1) : 0;
            square += change * change;
        }
        const auto count = static_cast<double>(end - first);
        const double variance = square / (2 * std::max(count - 1, 1.0));
        // The squares of the noise add to R^2 + S^2 + Q^2: half the variance over E^2.
        const double noise =
            5 * std::sqrt(variance / count) + 2 * variance * count / std::max(power, others);
        const double mean = sum / count;
        return std::abs(mean) > noise ? mean * count / power : 0;
    };
    PowerMismatch found;
    constexpr std::size_t parts = 8;
    if (rows.size() < 2 * parts) {
        return found;
    }
    found.of_all = mismatch_of(0, rows.size());
    for (std::size_t part = 0; part < parts; ++part) {
        const std::size_t first = part * rows.size() / parts;
        const std::size_t end = (part + 1) * rows.size() / parts;
        const double mismatch = mismatch_of(first, end);
        if (std::abs(mismatch) > std::abs(found.worst)) {
            found.worst = mismatch;
            found.at_s = rows[(first + end) / 2].time_s;
        }
    }
    return found;
}

PhasorRun phasors_without_phase(const PowerRun& powers, std::size_t most) {
    const std::vector<Powers> rows = rows_of(powers, most);
    PhasorRun run;
    run.phase_lost = true;
    run.two_theta_zero = powers.two_theta_zero;
    std::vector<double> steps;
    double square = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Powers& row = rows[k];
        const double to_e = row.e / std::sqrt(row.r * row.r + row.s * row.s + row.q * row.q);
        const double r = to_e * row.r;
        const std::complex<double> cross(to_e * row.s, -to_e * row.q);  // 2 conj(c) d
        // The larger of both is real.
        if (r >= 0) {
            const double c = std::sqrt((row.e + r) / 2);
            run.c.emplace_back(c);
            run.d.push_back(cross / (2 * c));
        } else {
            const double d = std::sqrt((row.e - r) / 2);
            run.c.push_back(std::conj(cross) / (2 * d));
            run.d.emplace_back(d);
        }
        run.time_s.push_back(row.time_s - powers.time_s.front());
        if (k > 0) {
            steps.push_back(row.time_s - rows[k - 1].time_s);
        }
        if (k > 2) {
            // Third differences of white noise have twenty times its variance.
            for (const double Powers::*power : {&Powers::e, &Powers::r, &Powers::s, &Powers::q}) {
                const double third = rows[k].*power - 3 * rows[k - 1].*power +
                                     3 * rows[k - 2].*power - rows[k - 3].*power;
                square += third * third / 80;
            }
        }
    }
    run.window_s = median(std::move(steps));
    const double sd = std::sqrt(square / std::max(static_cast<double>(rows.size()) - 3, 1.0));
    for (const Powers& row : rows) {
        constexpr double least = 1e-15;  // of the wave: digits of a file without noise
        run.sd.push_back(std::max(sd / (2 * std::sqrt(row.e)), least * std::sqrt(row.e)));
    }
    return run;
}

}  // namespace vybeg
