#include "core/estimators/batch/projection_kernels.h"

#include <algorithm>
#include <cmath>

namespace vybeg {
namespace {

// One window's series: eight orders side by side.
struct Series {
    Vec8 c_cos{};
    Vec8 c_sin{};
    Vec8 d_cos{};
    Vec8 d_sin{};
};

VYBEG_INLINED inline void project_sample(Series& sum, SampleColumns of, std::int64_t j,
                                         Vec8 cosines, Vec8 sines) {
    sum.c_cos += of.c[j] * cosines;
    sum.c_sin += of.c[j] * sines;
    sum.d_cos += of.d[j] * cosines;
    sum.d_sin += of.d[j] * sines;
}

VYBEG_INLINED inline void project(Series& sum, SampleColumns of, std::int64_t length,
                                  const double* row) {
    for (std::int64_t j = 0; j < length; ++j, row += 2 * taylor_orders) {
        project_sample(sum, of, j, load(row), load(row + taylor_orders));
    }
}

// Two sums at a time, because the processor would otherwise wait for each sum before the next
// addition.
VYBEG_INLINED inline void project(Series& sum_a, SampleColumns a, Series& sum_b, SampleColumns b,
                                  std::int64_t length, const double* row) {
    for (std::int64_t j = 0; j < length; ++j, row += 2 * taylor_orders) {
        const Vec8 cosines = load(row);
        const Vec8 sines = load(row + taylor_orders);
        project_sample(sum_a, a, j, cosines, sines);
        project_sample(sum_b, b, j, cosines, sines);
    }
}

VYBEG_INLINED inline void add_products(SampleProducts& sum, SampleColumns of, std::int64_t length) {
    Vec8 cc{};
    Vec8 dd{};
    Vec8 cd{};
    std::int64_t j = 0;
    constexpr auto lanes = static_cast<std::int64_t>(lane_count);
    for (; j + lanes <= length; j += lanes) {
        const Vec8 c = load(of.c + j);
        const Vec8 d = load(of.d + j);
        cc += c * c;
        dd += d * d;
        cd += c * d;
    }
    for (; j < length; ++j) {
        sum.cc += of.c[j] * of.c[j];
        sum.dd += of.d[j] * of.d[j];
        sum.cd += of.c[j] * of.d[j];
    }
    if (length >= lanes) {
        sum.cc += total(cc);
        sum.dd += total(dd);
        sum.cd += total(cd);
    }
    if (of.delayed != nullptr) {
        Vec8 cq{};
        for (j = 0; j + lanes <= length; j += lanes) {
            cq += load(of.c + j) * load(of.delayed + j);
        }
        for (; j < length; ++j) {
            sum.cq += of.c[j] * of.delayed[j];
        }
        sum.cq += total(cq);
    }
}

// sum += shift times part, each a series.
VYBEG_INLINED inline void add_shifted(Series& sum, const Series& part, const CentreShift& shift) {
    Lanes c_cos;
    Lanes c_sin;
    Lanes d_cos;
    Lanes d_sin;
    store(part.c_cos, c_cos);
    store(part.c_sin, c_sin);
    store(part.d_cos, d_cos);
    store(part.d_sin, d_sin);
    for (std::size_t j = 0; j < taylor_orders; ++j) {
        const Vec8 re = load(shift.re.data() + taylor_orders - j);
        const Vec8 im = load(shift.im.data() + taylor_orders - j);
        sum.c_cos += c_cos[j] * re - c_sin[j] * im;
        sum.c_sin += c_cos[j] * im + c_sin[j] * re;
        sum.d_cos += d_cos[j] * re - d_sin[j] * im;
        sum.d_sin += d_cos[j] * im + d_sin[j] * re;
    }
}

VYBEG_INLINED inline Series sum_of_segments(SampleColumns of, const SampleCut& cut,
                                            const TaylorBasis& basis) {
    Series sum;
    const std::int64_t step = basis.segment();
    const double* row = basis.row(0);
    std::int64_t j = 0;
    std::size_t segment = 0;
    for (; j + 2 * step <= cut.length; j += 2 * step, segment += 2) {
        Series a;
        Series b;
        project(a, of.from(j), b, of.from(j + step), step, row);
        add_shifted(sum, a, cut.shifts[segment]);
        add_shifted(sum, b, cut.shifts[segment + 1]);
    }
    for (; j < cut.length; j += step, ++segment) {
        Series a;
        project(a, of.from(j), std::min(step, cut.length - j), row);
        add_shifted(sum, a, cut.shifts[segment]);
    }
    return sum;
}

// Order k of a series times that of e^{iyx}, of which `powers` are y^m/m!, from its order `first`
// on: the powers of i are 1, i, -1, -i, ...
template <class Power>
VYBEG_INLINED inline void add_times_powers(const std::array<Power, taylor_orders>& powers,
                                           std::size_t first,
                                           const std::array<Vec8, taylor_orders>& re,
                                           const std::array<Vec8, taylor_orders>& im, std::size_t k,
                                           Vec8& cosine, Vec8& sine) {
#pragma GCC unroll 8
    for (std::size_t m = first; m <= k; ++m) {
        const Power power = m % 4 < 2 ? powers[m] : -powers[m];
        if (m % 2 == 0) {
            cosine += power * re[k - m];
            sine += power * im[k - m];
        } else {
            cosine -= power * im[k - m];
            sine += power * re[k - m];
        }
    }
}

// Series of one channel of eight hop sums, moved to another centre and added: cos is the real, sin
// the imaginary part of the sum of s e^{iwu}.
VYBEG_INLINED inline void add_shifted_channel(double* to, std::size_t to_pitch, const double* from,
                                              std::size_t from_pitch, const CentreShift& shift) {
    std::array<Vec8, taylor_orders> re;
    std::array<Vec8, taylor_orders> im;
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        const Vec8 cosine = load(from + k * from_pitch);
        const Vec8 sine = load(from + (taylor_orders + k) * from_pitch);
        re[k] = cosine * shift.turn_cos - sine * shift.turn_sin;
        im[k] = cosine * shift.turn_sin + sine * shift.turn_cos;
    }
#pragma GCC unroll 8
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        Vec8 cosine = load(to + k * to_pitch);
        Vec8 sine = load(to + (taylor_orders + k) * to_pitch);
        add_times_powers(shift.powers, 0, re, im, k, cosine, sine);
        __builtin_memcpy(to + k * to_pitch, &cosine, sizeof cosine);
        __builtin_memcpy(to + (taylor_orders + k) * to_pitch, &sine, sizeof sine);
    }
}

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
    std::array<Vec8, taylor_orders> powers;
    powers[0] = Vec8{} + 1.0;
    for (std::size_t m = 1; m < taylor_orders; ++m) {
        powers[m] = powers[m - 1] * y / static_cast<double>(m);
    }
#pragma GCC unroll 8
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        Vec8 sum_re = re[k];
        Vec8 sum_im = im[k];
        add_times_powers(powers, 1, re, im, k, sum_re, sum_im);
        __builtin_memcpy(to + k * to_pitch, &sum_re, sizeof sum_re);
        __builtin_memcpy(to + (taylor_orders + k) * to_pitch, &sum_im, sizeof sum_im);
    }
}

// Rows processed together, so that their sums do not wait for each other.
constexpr std::size_t together = 4;
static_assert(batch_numbers % together == 0);

}  // namespace

VYBEG_DISPATCHED
void sum_cuts(SampleColumns samples, std::int64_t hop, std::size_t count, const SampleCut& cut,
              const TaylorBasis& basis, ProjectionBatch& batch) {
    const auto at = [&](std::size_t lane) {
        return samples.from(static_cast<std::int64_t>(lane) * hop + cut.first);
    };
    std::array<Series, lane_count> by_lane;
    if (cut.shifts.empty()) {
        const double* row = basis.row(cut.first);
        for (std::size_t lane = 0; lane < count; lane += 2) {
            Series a;
            Series b;
            const std::size_t other = std::min(lane + 1, count - 1);
            project(a, at(lane), b, at(other), cut.length, row);
            by_lane[lane] = a;
            by_lane[lane + 1] = b;
        }
    } else {
        for (std::size_t lane = 0; lane < count; ++lane) {
            by_lane[lane] = sum_of_segments(at(lane), cut, basis);
        }
    }
    for (std::size_t lane = 0; lane < lane_count; ++lane) {
        SampleProducts products;
        if (lane < count) {
            add_products(products, at(lane), cut.length);
        } else {
            products = {batch.cc[lane - 1], batch.dd[lane - 1], batch.cd[lane - 1],
                        batch.cq[lane - 1]};
            by_lane[lane] = by_lane[lane - 1];
        }
        batch.cc[lane] = products.cc;
        batch.dd[lane] = products.dd;
        batch.cd[lane] = products.cd;
        batch.cq[lane] = products.cq;
    }
    const auto put = [&](Vec8 Series::*kind, TaylorSums& by_order) VYBEG_INLINED {
        std::array<Vec8, lane_count> orders;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            orders[lane] = by_lane[lane].*kind;
        }
        transpose(orders);
        for (std::size_t k = 0; k < taylor_orders; ++k) {
            store(orders[k], by_order[k]);
        }
    };
    put(&Series::c_cos, batch.c_cos);
    put(&Series::c_sin, batch.c_sin);
    put(&Series::d_cos, batch.d_cos);
    put(&Series::d_sin, batch.d_sin);
}

VYBEG_DISPATCHED
void add_shifted_runs(HopSums& to, const HopSums& from, std::size_t first, std::size_t count,
                      const CentreShift& shift) {
    double* const sums = to.numbers.data();
    const double* const parts = from.numbers.data() + first;
    // `from` may be `to` at a later position: eight sums are read before they are written.
    for (std::size_t run = 0; run < count; run += lane_count) {
        for (const std::size_t channel : {std::size_t{0}, 2 * taylor_orders}) {
            add_shifted_channel(sums + channel * to.pitch + run, to.pitch,
                                parts + channel * from.pitch + run, from.pitch, shift);
        }
        for (std::size_t kind = batch_coefficients; kind < batch_numbers; ++kind) {
            const Vec8 sum =
                load(sums + kind * to.pitch + run) + load(parts + kind * from.pitch + run);
            __builtin_memcpy(sums + kind * to.pitch + run, &sum, sizeof sum);
        }
    }
}

void HopSums::reset(std::size_t runs) {
    pitch = runs + 2 * lane_count;
    numbers.resize(std::max(numbers.size(), batch_numbers * pitch));
}

CentreShift centre_shift(const TaylorBasis& basis, double distance) {
    CentreShift shift;
    shift.turn_cos = std::cos(basis.w0() * distance);
    shift.turn_sin = std::sin(basis.w0() * distance);
    const double y = 2 * distance / static_cast<double>(basis.length());
    double power = 1;
    // Times 1, i, -1, -i, ...
    const std::array<double, 4> turned{shift.turn_cos, -shift.turn_sin, -shift.turn_cos,
                                       shift.turn_sin};
    for (std::size_t k = 0; k < taylor_orders; ++k) {
        shift.powers[k] = power;
        shift.re[taylor_orders + k] = power * turned[k % 4];
        shift.im[taylor_orders + k] = power * turned[(k + 3) % 4];
        power *= y / static_cast<double>(k + 1);
    }
    return shift;
}

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
