#include "core/resonator/model/power_run.h"

#include "core/numerics/median.h"

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

PhasorRun phasors_without_phase(const PowerRun& powers, std::size_t most) {
    const std::vector<Powers> rows = rows_of(powers, most);
    PhasorRun run;
    run.phase_lost = true;
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
