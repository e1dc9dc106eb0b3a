#include "ui/resonator/run_text.h"

#include "core/output/identify_json.h"
#include "core/resonator/results/resonator_parameters.h"
#include "ui/plots/axis_ticks.h"
#include "ui/resonator/parameter_text.h"
#include "ui/words/error_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace vybeg::ui {

namespace {

QString columnName(const Shown& shown, int power) {
    return withUnit(shown.title, scaledUnit(shown.unit, shown.unit == unitText("Hz"), power));
}

QuantityCell columnCell(const Estimate& estimate, double factor, int power) {
    QuantityCell cell = cellOf(estimate, factor);
    cell.tip = std::exchange(
        cell.text, estimate.given()
                       ? conciseText(factor * estimate.value, std::abs(factor) * estimate.sd, power)
                       : QStringLiteral("—"));
    cell.concise.clear();
    if (estimate.given()) {
        const double in_column = factor * std::pow(10., -power);
        cell.exact = valueCell(in_column * estimate.value, std::abs(in_column) * estimate.sd,
                               std::abs(in_column) * estimate.u)
                         .exact;
    }
    return cell;
}

// Values of the recordings.
QuantityRow runsRow(const Shown& shown, const std::vector<Estimate>& estimates, RunForm form) {
    QuantityRow row = rowOf(shown);
    double most = 0;
    for (const Estimate& estimate : estimates) {
        if (estimate.given()) {
            most = std::max({most, std::abs(shown.factor * estimate.value),
                             std::abs(shown.factor * estimate.sd)});
        }
    }
    constexpr int most_digits = 7;
    const int power = columnPower(most, most_digits);
    const bool column = form == RunForm::column;
    row.name = column ? columnName(shown, power) : row.name;
    for (const Estimate& estimate : estimates) {
        row.cells.push_back(column ? columnCell(estimate, shown.factor, power)
                                   : cellOf(estimate, shown.factor));
    }
    return row;
}

}  // namespace

std::vector<QuantityRow> waveRows(const Identification& found, const DisplayUnits& units,
                                  RunForm form) {
    // As wave_parameters.
    static constexpr std::array<std::pair<const char*, const char*>, 4> texts{{
        {QT_TRANSLATE_NOOP("Resonator", "Frequency of the wave"),
         QT_TRANSLATE_NOOP("Resonator", "Mean rate of its phase, by power of both channels")},
        {QT_TRANSLATE_NOOP("Resonator", "Decay time of the wave"),
         QT_TRANSLATE_NOOP("Resonator", "Of √(a_A² + a_B²)")},
        {QT_TRANSLATE_NOOP("Resonator", "Drift dθ_A/dt"),
         QT_TRANSLATE_NOOP("Resonator", "Mean rate of the angle of the working wave")},
        {QT_TRANSLATE_NOOP("Resonator", "Quadrature growth d(a_B/a_A)/dt"),
         QT_TRANSLATE_NOOP("Resonator", "Mean rate of the ratio of both waves")},
    }};
    static_assert(texts.size() == wave_parameters.size());
    std::vector<QuantityRow> rows;
    for (std::size_t k = 0; k < wave_parameters.size(); ++k) {
        const WaveParameter& parameter = wave_parameters[k];
        Shown shown = shownAs(parameter.name, parameter.unit, units);
        shown.title = ResonatorWords::tr(texts[k].first);
        shown.tip = ResonatorWords::tr(texts[k].second);
        std::vector<Estimate> estimates;
        for (const IdentifiedRun& run : found.runs) {
            estimates.push_back(run.wave.*parameter.member);
        }
        rows.push_back(runsRow(shown, estimates, form));
    }
    const auto& fitted = found.fit.runs;
    if (form == RunForm::column && std::ranges::any_of(fitted, [](const RunEstimate& run) {
            return std::isfinite(run.chi2_per_dof);
        })) {
        QuantityRow row{QStringLiteral("χ²/ν"),
                        ResonatorWords::tr("Squared residuals of its windows in the fit of all, in "
                                           "units of their noise; about 1 where there is nothing "
                                           "but noise"),
                        {}};
        for (const RunEstimate& run : fitted) {
            row.cells.push_back(
                {numberLabel(run.chi2_per_dof, 2), {exactText(run.chi2_per_dof)}, {}});
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

std::vector<QuantityRow> runRows(const Identification& found, const DisplayUnits& units,
                                 RunForm form) {
    const QString hertz = unitText("Hz");
    const QString amplitude = ResonatorWords::tr("rec. units");
    std::vector<QuantityRow> rows;
    const auto add = [&](const QString& title, const QString& unit, const QString& tip,
                         const auto& cell) {
        QuantityRow row{withUnit(title, unit), tip, {}};
        for (std::size_t k = 0; k < found.runs.size(); ++k) {
            row.cells.push_back(cell(k));
        }
        rows.push_back(std::move(row));
    };
    const auto fitted = [&](const Shown& shown, Estimate RunEstimate::*member) {
        std::vector<Estimate> estimates;
        for (const RunEstimate& run : found.fit.runs) {
            estimates.push_back(run.*member);
        }
        rows.push_back(runsRow(shown, estimates, form));
    };
    fitted({ResonatorWords::tr("Frequency offset"),
            ResonatorWords::tr("From the mean frequency of the recordings"), hertz},
           &RunEstimate::f_offset_hz);
    fitted({ResonatorWords::tr("Start angle θ_A"),
            ResonatorWords::tr("Angle of the working wave at the start"), angleUnit(units),
            angleFactor(units) / 2},
           &RunEstimate::two_theta_A_rad);
    fitted({QStringLiteral("a_A"), ResonatorWords::tr("Amplitude of the working wave at the start"),
            amplitude},
           &RunEstimate::a_A);
    fitted({QStringLiteral("a_B"),
            ResonatorWords::tr("Amplitude of the quadrature wave at the start"), amplitude},
           &RunEstimate::a_B);
    fitted({QStringLiteral("Δf sin 4(θ_A − θ_w)"),
            ResonatorWords::tr(
                "What of the frequency split makes the quadrature of this recording grow"),
            hertz},
           &RunEstimate::split_sin_hz);
    const QString direction =
        ResonatorWords::tr("Of a wave that stays in the direction in which this one starts");
    fitted({ResonatorWords::tr("f of this direction"), direction, hertz},
           &RunEstimate::direction_f_hz);
    fitted({ResonatorWords::tr("τ of this direction"), direction, unitText("s")},
           &RunEstimate::direction_tau_s);
    fitted({ResonatorWords::tr("Q of this wave"),
            ResonatorWords::tr(
                "Of its envelope alone: the power of this recording. Q of the resonator "
                "is the mean of all directions"),
            {}},
           &RunEstimate::q_envelope);
    const bool varies = std::ranges::any_of(
        found.fit.runs, [](const RunEstimate& run) { return run.law && run.q_envelope.given(); });
    if (varies) {
        add(ResonatorWords::tr("Q over the amplitude"), {},
            ResonatorWords::tr("Amplitude at which Q of this wave holds; Q at the largest and at "
                               "the smallest amplitude"),
            [&found](std::size_t k) {
                const RunEstimate& run = found.fit.runs[k];
                if (!run.law || !run.q_envelope.given()) {
                    return sentenceCell({});
                }
                const QBand band = q_band(*run.law, run.q_envelope.value);
                const auto text = [](double x) { return groupedDigits(shortNumberText(x, 3)); };
                return sentenceCell(ResonatorWords::tr("at %1; %2 at %3, %4 at %5")
                                        .arg(text(band.amplitude), text(band.q_at_largest),
                                             text(band.largest), text(band.q_at_smallest),
                                             text(band.smallest)));
            });
    }
    if (found.fit.model == ResonatorModel::structured && form == RunForm::apart) {
        add(ResonatorWords::tr("Q coherent"), {},
            ResonatorWords::tr("Quality factor from the coherent fit of all recordings"),
            [&found](std::size_t) { return cellOf(found.fit.resonator.q); });
    }
    fitted({ResonatorWords::tr("Frequency drift"),
            ResonatorWords::tr("Of this recording, over time"), hertz + "/" + unitText("s")},
           &RunEstimate::drift_hz_per_s);
    add(ResonatorWords::tr("Noise σ"), amplitude,
        ResonatorWords::tr("Standard deviation per sample and channel"), [&found](std::size_t k) {
            const double sd = found.runs[k].noise_sd;
            return QuantityCell{threeDigits(sd), {exactText(sd), QString(), QString()}, {}};
        });
    add(ResonatorWords::tr("Windows used"), {},
        ResonatorWords::tr("Without gaps and faults, of all; samples in each"),
        [&found, form](std::size_t k) {
            const IdentifiedRun& run = found.runs[k];
            const QString used = countLabel(run.windows_used);
            const QString all = countLabel(run.windows);
            return sentenceCell(
                form == RunForm::column
                    ? ResonatorWords::tr("%1 of %2").arg(used, all).replace(' ', QChar(0xa0))
                    : ResonatorWords::tr("%1 of %2, n = %3")
                          .arg(used, all, countLabel(run.window)));
        });
    if (form == RunForm::column) {
        add(QStringLiteral("n"), {}, ResonatorWords::tr("Samples in each window"),
            [&found](std::size_t k) { return sentenceCell(countLabel(found.runs[k].window)); });
    }
    return rows;
}

}  // namespace vybeg::ui
