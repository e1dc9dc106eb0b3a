#include "core/estimators/batch/moved_hops.h"

#include <cmath>

namespace vybeg {
namespace {

// binomial(m, k) x^(m - k): coefficients of a polynomial about another point.
struct Reexpansion {
    std::array<std::array<double, taylor_orders>, taylor_orders> by{};

    explicit Reexpansion(double x) {
        for (std::size_t m = 0; m < taylor_orders; ++m) {
            double binomial = 1;
            double power = 1;
            for (std::size_t k = m + 1; k-- > 0;) {
                by[m][k] = binomial * power;
                power *= x;
                binomial *= static_cast<double>(k) / static_cast<double>(m - k + 1);
            }
        }
    }
};

struct Turn {
    Vec8 cosine;
    Vec8 sine;
};

// cos and sin of w distance in each lane.
VYBEG_INLINED inline Turn turn_of(Vec8 angle) {
    Turn turn{};
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        turn.cosine[lane] = std::cos(angle[lane]);
        turn.sine[lane] = std::sin(angle[lane]);
    }
    return turn;
}

VYBEG_INLINED inline void move_channel(double* to, std::size_t to_pitch, const double* from,
                                       std::size_t from_pitch, const Reexpansion* about,
                                       const Turn& turn, Vec8 y) {
    std::array<Vec8, taylor_orders> cosine;
    std::array<Vec8, taylor_orders> sine;
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        cosine[k] = load(from + k * from_pitch);
        sine[k] = load(from + (taylor_orders + k) * from_pitch);
    }
    if (about != nullptr) {
#pragma GCC unroll 8
        for (std::size_t k = 0; k < taylor_orders; ++k) {
#pragma GCC unroll 8
            for (std::size_t m = k + 1; m < taylor_orders; ++m) {
                cosine[k] += about->by[m][k] * cosine[m];
                sine[k] += about->by[m][k] * sine[m];
            }
        }
    }
    std::array<Vec8, taylor_orders> re;
    std::array<Vec8, taylor_orders> im;
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        re[k] = cosine[k] * turn.cosine - sine[k] * turn.sine;
        im[k] = cosine[k] * turn.sine + sine[k] * turn.cosine;
    }
    // Times (i y)^m/m!: 1, i, -1, -i, ...
    std::array<Vec8, taylor_orders> powers;
    powers[0] = Vec8{} + 1.0;
    for (std::size_t m = 1; m < taylor_orders; ++m) {
        powers[m] = powers[m - 1] * y / static_cast<double>(m);
    }
#pragma GCC unroll 8
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        Vec8 sum_re = re[k];
        Vec8 sum_im = im[k];
#pragma GCC unroll 8
        for (std::size_t m = 1; m <= k; ++m) {
            const Vec8 power = m % 4 < 2 ? powers[m] : -powers[m];
            if (m % 2 == 0) {
                sum_re += power * re[k - m];
                sum_im += power * im[k - m];
            } else {
                sum_re -= power * im[k - m];
                sum_im += power * re[k - m];
            }
        }
        __builtin_memcpy(to + k * to_pitch, &sum_re, sizeof sum_re);
        __builtin_memcpy(to + (taylor_orders + k) * to_pitch, &sum_im, sizeof sum_im);
    }
}

// Rows processed together, so that their sums do not wait for each other.
constexpr std::size_t together = 4;
static_assert(batch_numbers % together == 0);

}  // namespace

VYBEG_DISPATCHED
void move_hops(HopSums& to, const HopSums& from, std::size_t first, std::size_t count,
               const HopMove& move) {
    const Reexpansion about(move.x);
    const Reexpansion* const changed = move.x == 0 ? nullptr : &about;
    Vec8 lane{};
    for (std::size_t k = 0; k < lane_count; ++k) {
        lane[k] = static_cast<double>(k);
    }
    // The rotation is updated from eight hop sums to the next and recomputed at intervals.
    constexpr std::size_t afresh = 128;
    const double by_eight = move.w * move.step * static_cast<double>(lane_count);
    const double carry_cos = std::cos(by_eight);
    const double carry_sin = std::sin(by_eight);
    Turn turn{};
    for (std::size_t run = 0; run < count; run += lane_count) {
        const Vec8 distance = move.distance + move.step * (lane + static_cast<double>(run));
        if (run % afresh == 0) {
            turn = turn_of(move.w * distance);
        } else {
            const Vec8 cosine = turn.cosine * carry_cos - turn.sine * carry_sin;
            turn.sine = turn.cosine * carry_sin + turn.sine * carry_cos;
            turn.cosine = cosine;
        }
        const Vec8 y = distance * (2 / move.n);
        double* const sums = to.numbers.data() + run;
        const double* const parts = from.numbers.data() + first + run;
        for (const std::size_t channel : {std::size_t{0}, 2 * taylor_orders}) {
            move_channel(sums + channel * to.pitch, to.pitch, parts + channel * from.pitch,
                         from.pitch, changed, turn, y);
        }
        for (std::size_t kind = batch_coefficients; kind < batch_numbers; ++kind) {
            __builtin_memcpy(sums + kind * to.pitch, parts + kind * from.pitch, sizeof(Vec8));
        }
    }
}

void sum_windows(HopSums& windows, const HopSums& terms, const HopSums& heads, bool has_heads,
                 std::size_t whole, std::size_t count) {
    for (std::size_t kind = 0; kind < batch_numbers; kind += together) {
        std::array<const double*, together> term{};
        std::array<const double*, together> head{};
        std::array<double*, together> window{};
        std::array<double, together> sum{};
        for (std::size_t row = 0; row < together; ++row) {
            term[row] = &terms.numbers[(kind + row) * terms.pitch];
            head[row] = has_heads ? &heads.numbers[(kind + row) * heads.pitch] : nullptr;
            window[row] = &windows.numbers[(kind + row) * windows.pitch];
        }
        // The part common to all windows, then the part of each window on its left.
        for (std::size_t k = count - 1; k < whole; ++k) {
            for (std::size_t row = 0; row < together; ++row) {
                sum[row] += term[row][k];
            }
        }
        for (std::size_t k = count; k-- > 0;) {
            for (std::size_t row = 0; row < together; ++row) {
                sum[row] += k + 1 < count ? term[row][k] : 0;
                window[row][k] = sum[row];
            }
        }
        sum = {};
        for (std::size_t k = 1; k < count; ++k) {
            for (std::size_t row = 0; row < together; ++row) {
                sum[row] += term[row][whole + k - 1];
                window[row][k] += sum[row];
            }
        }
        for (std::size_t k = 0; has_heads && k < count; ++k) {
            for (std::size_t row = 0; row < together; ++row) {
                window[row][k] += head[row][k];
            }
        }
    }
}

}  // namespace vybeg
