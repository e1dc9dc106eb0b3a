// The drift of whole-angle logs against simulated loops.
//
// Statistical model: the coefficients' errors are Gaussian with the covariance told; each is held
// to four and a half of its deviations.
#include "core/base/diagnostic.h"
#include "core/base/error.h"
#include "core/drift/whole_angle_drift.h"
#include "tests/closeness.h"
#include "tests/core/drift/simulated_log.h"
#include "tests/needed.h"
#include "tests/test_registry.h"

#include <QtTest>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace test_whole_angle_drift {

using namespace vybeg;
using namespace vybeg::test;

namespace {

constexpr double pi = std::numbers::pi;

HeldLoop loop_of() {
    HeldLoop loop{.c2 = 2e-4, .s2 = -1e-4, .c4 = 3e-4, .s4 = 1.5e-4, .white = 1e-5};
    return loop;
}

constexpr ChannelTolerance exact{};

WholeAngleDrift drift_of(const std::vector<WholeAngleLog>& logs,
                         const ChannelTolerance& channels = exact) {
    return needed(whole_angle_drift(logs, {}, channels));
}

std::array<double, 5> truth_of(const HeldLoop& loop) {
    return {loop.turn, loop.c2, loop.s2, loop.c4, loop.s4};
}

double worst_deviation(const WholeAngleDrift& found, const HeldLoop& loop, std::size_t from = 0) {
    double worst = 0;
    const std::array<double, 5> truth = truth_of(loop);
    for (std::size_t k = from; k < truth.size(); ++k) {
        worst =
            std::max(worst, std::abs(found.harmonics[k].value - truth[k]) / found.harmonics[k].sd);
    }
    return worst;
}

}  // namespace

class TestWholeAngleDrift : public QObject {
    Q_OBJECT

private slots:
    void the_harmonics_of_a_loop_are_found_in_either_direction() {
        for (const double turn : {0.05, -0.05, 0.5}) {
            HeldLoop loop = loop_of();
            loop.turn = turn;
            const WholeAngleDrift found = drift_of({simulated_log(loop)});
            VYBEG_LESS(worst_deviation(found, loop), 4.5);
            VYBEG_LESS(found.harmonics[3].sd, 1e-6 * std::max(1.0, std::abs(turn) / 0.05));
            QVERIFY(found.warnings.empty());
        }
    }

    // Straight lines between rows made the turn hundreds of its deviations wrong.
    void rows_far_apart_are_as_good() {
        for (const double degrees : {3.0, 10.0, 40.0}) {
            for (const double share : {0.02, 0.1}) {
                HeldLoop loop = loop_of();
                loop.rate_hz = 1;
                loop.seconds = 1000;
                loop.turn = degrees * pi / 180;
                loop.white = 1e-6;
                loop.c2 = share * loop.turn;
                loop.s4 = -share * loop.turn;
                const WholeAngleDrift found = drift_of({simulated_log(loop)});
                VYBEG_LESS(worst_deviation(found, loop), 4.5);
                VYBEG_LESS(found.harmonics[0].sd, 1e-8);
            }
        }
    }

    // A search that ran into noises without digits gave harmonics of a sixth of the turn, with 12
    // digits.
    void a_turn_that_steps_or_turns_back_is_noise_of_the_turn() {
        for (const double then : {0.06, -0.05}) {
            HeldLoop loop = loop_of();
            loop.rate_hz = 2;
            loop.seconds = 1500;
            const WholeAngleDrift found = drift_of({simulated_log_with_turn(loop, then)});
            VYBEG_LESS(worst_deviation(found, loop, 1), 4.5);
            VYBEG_MORE(found.harmonics[0].sd, 1e-3);
        }
    }

    // A reference that is set anew, a false row: they made the deviations a thousand times larger.
    void an_angle_that_jumps_is_told_and_left_out() {
        for (const double jump : {pi, pi / 2, 0.2, -0.05}) {
            for (const bool row_alone : {false, true}) {
                HeldLoop loop = loop_of();
                WholeAngleLog log = simulated_log(loop, "jumps.csv");
                const WholeAngleDrift whole = drift_of({log});
                const std::size_t at = 2100;
                for (std::size_t k = at; k < (row_alone ? at + 1 : log.theta.size()); ++k) {
                    log.theta[k] += jump;
                }
                const WholeAngleDrift found = drift_of({log});
                // After another step the harmonics are those of another angle.
                if (row_alone || jump == pi) {
                    VYBEG_LESS(worst_deviation(found, loop), 4.5);
                    VYBEG_LESS(found.harmonics[0].sd, 3 * whole.harmonics[0].sd);
                }
                QCOMPARE(found.warnings.size(), std::size_t{1});
                QVERIFY(found.warnings[0].kind == DiagnosticKind::angle_jumps);
                QCOMPARE(found.warnings[0].args[0], MessageArg("jumps.csv"));
                VYBEG_LESS(std::abs(std::stod(english(found.warnings[0].args[2])) - log.time_s[at]),
                           0.11);
                QCOMPARE(found.warnings[0].args[3], count_arg(row_alone ? 2 : 1));
            }
        }
        // A digit is none, however rarely it changes.
        WholeAngleLog coarse;
        for (int k = 0; k < 6000; ++k) {
            coarse.time_s.push_back(0.1 * k);
            coarse.theta.push_back(std::round(0.0012 * 0.1 * k / 0.01) * 0.01 * pi / 180);
        }
        const UnwrappedAngle rounded = unwrapped_angle(coarse);
        QCOMPARE(rounded.warnings.size(), std::size_t{1});
        QVERIFY(rounded.warnings[0].kind == DiagnosticKind::angle_coarse);
        QCOMPARE(english(rounded.warnings[0].args[0]), std::string("0.01"));
        // A wave that stands still at the end is none.
        HeldLoop loop = loop_of();
        WholeAngleLog log = simulated_log(loop);
        for (std::size_t k = log.theta.size() - 60; k < log.theta.size(); ++k) {
            log.theta[k] = log.theta[log.theta.size() - 61];
        }
        QVERIFY(std::ranges::none_of(drift_of({log}).warnings, [](const Diagnostic& told) {
            return told.kind == DiagnosticKind::angle_jumps;
        }));
    }

    void a_whole_angle_may_go_far_from_row_to_row_and_a_wrapped_one_may_not() {
        HeldLoop loop = loop_of();
        loop.rate_hz = 1;
        loop.turn = 1;  // 57 degrees
        loop.white = 1e-6;
        const WholeAngleLog whole = simulated_log(loop, "fast.csv");
        const WholeAngleDrift found = drift_of({whole});
        VYBEG_LESS(worst_deviation(found, loop), 4.5);
        QVERIFY(found.warnings.empty());
        for (const double period : {2 * pi, pi}) {
            const Result<WholeAngleDrift> refused =
                whole_angle_drift(std::vector{wrapped(whole, period)}, {}, exact);
            QVERIFY(!refused);
            QCOMPARE(refused.error().code, ErrorCode::turn_too_fast);
            QCOMPARE(QString::fromStdString(english(refused.error())),
                     QString("fast.csv: the wave turns by 45 degrees or more from row to row, and "
                             "its angle is wrapped: how far it turned is unknown. Log it faster, "
                             "or write down the whole angle."));
        }
        loop.turn = 0.75;  // 43 degrees
        const WholeAngleLog slower = simulated_log(loop);
        for (const double period : {2 * pi, pi, pi / 2}) {
            VYBEG_LESS(worst_deviation(drift_of({wrapped(slower, period)}), loop), 4.5);
        }
    }

    // Degrees taken for radians, and the other way round.
    void an_angle_that_wraps_elsewhere_has_another_unit() {
        const WholeAngleLog right = simulated_log(loop_of(), "log.csv");
        for (const double unit : {180 / pi, pi / 180, 2.0, 1000.0}) {
            for (const double period : {2 * pi, pi, pi / 2}) {
                if (unit == 2 && period < 6) {
                    continue;  // then it wraps at twice a half or a quarter, which may be
                }
                WholeAngleLog log = wrapped(right, period);
                for (double& theta : log.theta) {
                    theta *= unit;
                }
                const Result<WholeAngleDrift> refused =
                    whole_angle_drift(std::vector{log}, {}, exact);
                QVERIFY(!refused);
                QCOMPARE(refused.error().code, ErrorCode::angle_unit_wrong);
                const double told = std::stod(refused.error().args.at(0).text);
                VYBEG_CLOSE(told * pi / 180, unit * period, 0.05 * unit * period);
            }
        }
    }

    void a_log_named_twice_is_refused() {
        WholeAngleLog log = simulated_log(loop_of(), "a.csv");
        log.sha256 = "12";
        const Result<WholeAngleDrift> found = whole_angle_drift(std::vector{log, log}, {}, exact);
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::same_recording);
    }

    void a_wrapped_angle_is_the_same_log() {
        const HeldLoop loop = loop_of();
        const WholeAngleLog whole = simulated_log(loop);
        const WholeAngleDrift expected = drift_of({whole});
        for (const double period : {2 * pi, pi, pi / 2}) {
            const WholeAngleDrift found = drift_of({wrapped(whole, period)});
            for (std::size_t k = 0; k < found.harmonics.size(); ++k) {
                VYBEG_CLOSE(found.harmonics[k].value, expected.harmonics[k].value, 1e-12);
            }
            QCOMPARE(found.warnings.size(), std::size_t{period < 2 ? 1U : 0U});
        }
    }

    void gaps_are_left_out_short_and_long() {
        const HeldLoop loop = loop_of();
        WholeAngleLog log = wrapped(simulated_log(loop), pi);
        for (std::size_t k = 0; k < log.theta.size(); ++k) {
            const bool brief = k % 97 < 5;
            const bool long_one = k > 2000 && k < 2900;  // 4.5 rad, more than a period
            if (brief || long_one) {
                log.theta[k] = std::numeric_limits<double>::quiet_NaN();
            }
        }
        const WholeAngleDrift found = drift_of({log});
        VYBEG_LESS(worst_deviation(found, loop), 4.5);
        QVERIFY(found.logs.front().missing > 1000);
    }

    void too_short_a_turn_is_refused_in_words() {
        HeldLoop loop = loop_of();
        loop.seconds = 10;  // half a radian
        const Result<WholeAngleDrift> found =
            whole_angle_drift(std::vector{simulated_log(loop, "short.csv")}, {});
        QVERIFY(!found);
        QCOMPARE(found.error().code, ErrorCode::turn_too_short);
        QCOMPARE(QString::fromStdString(english(found.error())),
                 QString("short.csv: the wave turns by 28.5 degrees, too little to tell the second "
                         "and the fourth harmonic of the drift from the turn itself. Let it turn "
                         "by 180 degrees or more."));
        loop.seconds = pi / loop.turn * 1.01;
        QVERIFY(whole_angle_drift(std::vector{simulated_log(loop)}, {}));
    }

    void logs_of_unlike_lengths_and_turns_have_common_harmonics() {
        HeldLoop loop = loop_of();
        std::vector<WholeAngleLog> logs;
        for (const auto& [turn, seconds] :
             {std::pair{0.05, 300.0}, std::pair{-0.08, 700.0}, std::pair{0.2, 120.0}}) {
            loop.turn = turn;
            loop.seconds = seconds;
            ++loop.seed;
            logs.push_back(simulated_log(loop));
        }
        const WholeAngleDrift found = drift_of(logs);
        VYBEG_LESS(worst_deviation(found, loop, 1), 4.5);
        QVERIFY(found.warnings.empty());
        QCOMPARE(found.harmonics[0].reason.code, ReasonCode::logs_differ);
        for (const LogDrift& log : found.logs) {
            VYBEG_LESS(found.harmonics[3].sd, std::sqrt(log.covariance(3, 3)));
        }
    }

    void two_logs_that_differ_in_a_harmonic_are_told_so() {
        HeldLoop loop = loop_of();
        const WholeAngleLog first = simulated_log(loop, "a.csv");
        loop.c4 += 3e-5;
        loop.seed = 2;
        const WholeAngleDrift found = drift_of({first, simulated_log(loop, "b.csv")});
        QCOMPARE(found.warnings.size(), std::size_t{1});
        QCOMPARE(found.warnings[0].kind, DiagnosticKind::logs_differ);
        QCOMPARE(found.warnings[0].args[0].text, std::string("4"));
        QVERIFY(english(found.warnings[0]).find("a.csv, b.csv") != std::string::npos);
        QCOMPARE(found.harmonics[3].reason.code, ReasonCode::logs_differ);
        QVERIFY(found.harmonics[1].given());
        QVERIFY(!found.resonator.tau_s.given());
    }

    void of_three_logs_the_one_that_differs_is_left_out() {
        HeldLoop loop = loop_of();
        std::vector<WholeAngleLog> logs;
        for (unsigned k = 0; k < 3; ++k) {
            HeldLoop one = loop;
            one.seed = 10 + k;
            one.s2 += k == 1 ? 5e-5 : 0;
            logs.push_back(simulated_log(one, "log" + std::to_string(k)));
        }
        const WholeAngleDrift found = drift_of(logs);
        QCOMPARE(found.left_out, std::optional<std::size_t>(1));
        QCOMPARE(found.warnings.at(0).kind, DiagnosticKind::log_left_out);
        VYBEG_LESS(worst_deviation(found, loop), 4.5);
    }

    void efforts_tell_the_resonator_without_a_ring_down() {
        HeldLoop loop = loop_of();
        loop.effort_noise = 0.01;
        const WholeAngleDrift found = drift_of({simulated_log(loop)});
        const HeldResonator& resonator = found.resonator;
        const double g = 4 * std::hypot(loop.c4, loop.s4);
        const double theta_tau = std::atan2(-loop.c4, loop.s4) / 4;
        const auto is = [](const Estimate& estimate, double truth) {
            VYBEG_LESS(std::abs(estimate.value - truth) / estimate.sd, 4.5);
            VYBEG_LESS(estimate.sd / std::abs(truth), 0.02);
        };
        is(resonator.damping_anisotropy_per_s, g);
        is(resonator.theta_tau_rad, theta_tau);
        is(resonator.tau_s, loop.tau_s);
        is(resonator.split_hz, loop.split_hz);
        is(resonator.theta_w_rad, loop.theta_w);
    }

    void without_efforts_or_with_another_axis_tau_is_refused() {
        HeldLoop loop = loop_of();
        WholeAngleLog log = simulated_log(loop);
        log.amplitude_effort.clear();
        QCOMPARE(drift_of({log}).resonator.tau_s.reason.code, ReasonCode::effort_missing);
        QVERIFY(drift_of({log}).resonator.damping_anisotropy_per_s.given());
        HeldLoop other = loop;
        other.c4 = -loop.c4;  // another axis of damping
        log.amplitude_effort = simulated_log(other).amplitude_effort;
        QCOMPARE(drift_of({log}).resonator.tau_s.reason.code, ReasonCode::effort_axis_apart);
        QVERIFY(!drift_of({log}).resonator.split_hz.given());
    }

    // A controller's effort that comes late turns its axis; u of tau holds as much.
    void an_effort_that_is_late_widens_tau() {
        HeldLoop loop = loop_of();
        loop.turn = 0.02;
        const WholeAngleLog log = simulated_log(loop);
        for (const std::size_t rows : {1, 2, 40}) {
            WholeAngleLog late = log;
            for (std::vector<double>* effort : {&late.amplitude_effort, &late.quadrature_effort}) {
                std::rotate(effort->begin(), effort->end() - static_cast<std::ptrdiff_t>(rows),
                            effort->end());
                std::fill_n(effort->begin(), rows, (*effort)[rows]);
            }
            const HeldResonator found = drift_of({late}).resonator;
            const double turned = 4 * loop.turn * static_cast<double>(rows) / loop.rate_hz;
            VYBEG_EQUAL(found.tau_s.given(), turned < 0.02, qPrintable(QString::number(rows)));
            if (found.tau_s.given()) {
                VYBEG_LESS(std::abs(found.tau_s.value - loop.tau_s) / found.tau_s.u, 3);
                VYBEG_LESS(found.tau_s.u / found.tau_s.value, 2 * turned + 0.01);
                VYBEG_LESS(std::abs(found.split_hz.value - loop.split_hz) / found.split_hz.u, 4.5);
                VYBEG_LESS(std::abs(found.theta_w_rad.value - loop.theta_w) / found.theta_w_rad.u,
                           3);
            }
        }
    }

    // Of a turn of one direction u holds what two directions tell apart.
    void channels_within_their_tolerance_are_no_drift() {
        int seed = 40;
        for (const double kappa : {0.99, 1.002, 1.01}) {
            for (const double skew : {-1e-3, 2e-3}) {
                HeldLoop loop = loop_of();
                loop.kappa = kappa;
                loop.skew = skew;
                loop.seed = static_cast<unsigned>(++seed);
                const WholeAngleLog forth = simulated_log(loop, "forth");
                loop.turn = -0.08;
                const WholeAngleLog back = simulated_log(loop, "back");
                const WholeAngleDrift alone = drift_of({forth}, usual_pick_offs());
                const WholeAngleDrift both = drift_of({forth, back}, usual_pick_offs());
                std::array<double, 5> truth = truth_of(loop);
                for (std::size_t term = 1; term < 5; ++term) {
                    const Estimate& one = alone.harmonics[term];
                    VYBEG_LESS(std::abs(one.value - truth[term]) / one.u, 3.0);
                    VYBEG_MORE(one.u, term < 3 ? one.sd : 0.05 * 1e-3);
                    const Estimate& two = both.harmonics[term];
                    VYBEG_LESS(std::abs(two.value - truth[term]), 4.5 * two.u);
                    VYBEG_LESS(two.u, 3 * two.sd);
                }
                truth[0] = 0.05;
                VYBEG_LESS(std::abs(alone.harmonics[0].value - truth[0]) / alone.harmonics[0].u,
                           3.0);
                QCOMPARE(alone.warnings.size(), std::size_t{1});
                QCOMPARE(alone.warnings[0].kind, DiagnosticKind::turn_one_way);
                QVERIFY(both.warnings.empty());
                const Estimate& g = alone.resonator.damping_anisotropy_per_s;
                const double true_g = 4 * std::hypot(loop.c4, loop.s4);
                VYBEG_LESS(std::abs(g.value - true_g) / g.u, 3.0);
            }
        }
    }

    // The turn and the second harmonic had the deviation of their noise alone: 28 and 55 of them
    // off.
    void one_log_with_the_gain_one_tolerance_off_is_within_u() {
        for (const double turn : {0.5, -0.5, 2.0}) {
            for (const double kappa : {0.99, 1.01}) {
                HeldLoop loop = loop_of();
                loop.rate_hz = 50;
                loop.turn = turn;
                loop.c2 = 2e-2;
                loop.s2 = -1e-2;
                loop.kappa = kappa;
                loop.skew = 1e-3;
                const WholeAngleDrift found = drift_of({simulated_log(loop)}, usual_pick_offs());
                const std::array<double, 5> truth = truth_of(loop);
                double worst = 0;
                for (std::size_t term = 0; term < truth.size(); ++term) {
                    const Estimate& each = found.harmonics[term];
                    VYBEG_LESS(std::abs(each.value - truth[term]) / each.u, 2.0);
                    worst = std::max(worst,
                                     term < 3 ? std::abs(each.value - truth[term]) / each.sd : 0);
                }
                VYBEG_MORE(worst, 20.0);
            }
        }
    }

    // 4600 times too small was the bound, by the noise alone, and u of the axis 67 of its periods.
    void the_bound_of_a_damping_that_channels_hide_holds_it() {
        HeldLoop loop = loop_of();
        loop.turn = 2;
        loop.rate_hz = 50;
        loop.kappa = 1.01;
        loop.c4 = -loop.turn * 0.01;  // as much as the gain makes: none is seen
        loop.s4 = 0;
        const HeldResonator found = drift_of({simulated_log(loop)}, usual_pick_offs()).resonator;
        const double truth = 4 * std::abs(loop.c4);
        const Estimate& g = found.damping_anisotropy_per_s;
        if (g.given()) {
            VYBEG_LESS(std::abs(g.value - truth) / g.u, 2.0);
        } else {
            VYBEG_MORE(std::stod(g.reason.args.at(0).text), truth);
        }
        if (found.theta_tau_rad.given()) {
            VYBEG_LESS(found.theta_tau_rad.u, pi / 4);
        }
    }

    void efforts_of_the_other_sign_are_told() {
        HeldLoop loop = loop_of();
        loop.effort_noise = 0.01;
        WholeAngleLog log = simulated_log(loop);
        for (double& effort : log.amplitude_effort) {
            effort = -effort;
        }
        const HeldResonator found = drift_of({log}).resonator;
        QCOMPARE(found.tau_s.reason.code, ReasonCode::effort_negative);
        QCOMPARE(found.split_hz.reason.code, ReasonCode::effort_negative);
    }

    void an_effort_that_was_not_connected_is_none() {
        WholeAngleLog log = simulated_log(loop_of());
        std::ranges::fill(log.amplitude_effort, 0.0);
        QCOMPARE(drift_of({log}).resonator.tau_s.reason.code, ReasonCode::effort_missing);
    }

    void the_bins_lie_on_the_curve() {
        HeldLoop loop = loop_of();
        const WholeAngleDrift one = drift_of({simulated_log(loop)});
        // What channels make of two unlike turns of one direction is in neither.
        loop.kappa = 1.01;
        loop.skew = 1e-3;
        const WholeAngleLog slow = simulated_log(loop, "slow");
        loop.turn *= 2;
        const WholeAngleDrift two =
            drift_of({slow, simulated_log(loop, "fast")}, usual_pick_offs());
        for (const WholeAngleDrift* found : {&one, &two}) {
            QCOMPARE(found->bins.size(), std::size_t{36});
            double square = 0;
            for (const LogBin& bin : found->bins) {
                const double off = (bin.rate - found->rate(bin.theta)) / bin.sd;
                VYBEG_LESS(std::abs(off), 5.0);
                square += off * off;
            }
            VYBEG_LESS(square / 36, 2.0);
            VYBEG_MORE(square / 36, 0.4);
        }
    }
};

VYBEG_TEST(TestWholeAngleDrift)

}  // namespace test_whole_angle_drift

#include "test_whole_angle_drift.moc"
