#include "ui/settings/settings_groups.h"

#include "core/analysis/setting_table.h"
#include "core/windows/window_plan.h"
#include "ui/words/display_units.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>

#include <algorithm>
#include <cmath>

namespace vybeg::ui {

namespace {

// Residual from which on a warning is shown; algorithms 1 to 4 have a relative error of about this
// size.
constexpr double high_residual = 0.01;
// Below this the residual is negligible for any recording.
constexpr double no_residual = 1e-5;

// Window of an analysis with this state, samples.
std::int64_t windowInUse(const SettingsState& state) {
    std::int64_t window = state.settings.window;
    if (!state.f0_hz || !state.rate_hz) {
        return window;
    }
    if (state.settings.periods) {
        window = window_of_periods(*state.settings.periods, *state.f0_hz, *state.rate_hz);
    }
    return state.settings.snap ? snap_window(window, *state.f0_hz, *state.rate_hz) : window;
}

std::array<Bounds, 2> boundsOfBoth(const char* option) {
    return {bounds_of(option, 0), bounds_of(option, 1)};
}

}  // namespace

WindowFields::WindowFields(QWidget* parent) : SettingsFields(parent) {
    // The length in the chosen unit, and below it in the others.
    length_ = makeField(
        {QT_TR_NOOP("Length"), "",
         QT_TR_NOOP("Window of n consecutive samples, the averaging interval T of (7). The slow "
                    "variables are constant inside it. At least 5 samples and three quarters of a "
                    "period. The article varies T from 1 to 10 periods, which may be fractions.")});
    length_->setDigits(6);
    unit_ = withName(new QComboBox(this), "lengthUnit");
    unit_->addItems({QString(), QString(), QString()});
    unit_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    addRow({{length_, 1}, unit_}, 4);
    addFaults({length_});
    others_ = withName(new QLabel(this), "otherLengths");
    addWide(others_);

    residual_ = withName(new QLabel(this), "residual");
    snap_ = withTexts(
        withName(new QPushButton(this), "snap"),
        {QT_TR_NOOP("Snap"), "",
         QT_TR_NOOP("Moves the window to whole half-periods of the carrier: the n nearest to the "
                    "wish that leaks least.")});
    withTexts(addRow({{residual_, 1}, snap_}),
              {QT_TR_NOOP("Leakage"), "",
               QT_TR_NOOP("What the window leaves of ⟨cos 2ωt⟩ = ⟨sin 2ωt⟩ = 0, the condition "
                          "below (7). Algorithms 1 to 4 are exact only where it is zero; 5 and 6 "
                          "are exact for every window.")});

    hop_ = addField({QT_TR_NOOP("Step"), QT_TR_NOOP("samples"),
                     QT_TR_NOOP("Samples between the starts of windows. Empty: windows one after "
                                "the other (discrete identification); less than the window: "
                                "sliding.")},
                    bounds_of("hop"));
    overlap_ = addField({QT_TR_NOOP("Overlap"), QT_TR_NOOP("%"),
                         QT_TR_NOOP("The same as a share of the window that the next one "
                                    "repeats.")},
                        Bounds{0, 99.999});
    hop_->setInteger(true);
    hop_->setOptional(true);
    overlap_->setDigits(4);
    overlap_->setStep(10);

    connect(length_, &NumberField::valueEdited, this, [this](auto value) {
        if (unit() == Unit::periods) {
            change([value](Settings& settings) {
                settings.periods = value;
                settings.snap = false;
            });
        } else {
            setSamples(unit() == Unit::samples ? *value
                                               : std::round(*value * *state().rate_hz / 1000));
        }
    });
    connect(unit_, &QComboBox::activated, this, &WindowFields::showState);
    connect(hop_, &NumberField::valueEdited, this, [this](auto value) {
        change([&](Settings& settings) {
            settings.hop = value ? static_cast<std::int64_t>(*value) : 0;
        });
    });
    connect(overlap_, &NumberField::valueEdited, this, [this](auto value) {
        change([&](Settings& settings) {
            const double window = static_cast<double>(windowInUse(state()));
            const double hop = std::max(1.0, std::round(window * (1 - *value / 100)));
            settings.hop = *value == 0 ? 0 : static_cast<std::int64_t>(hop);
        });
    });
    connect(snap_, &QPushButton::clicked, this, [this] {
        const auto window = snap_window(windowInUse(state()), *state().f0_hz, *state().rate_hz);
        setSamples(static_cast<double>(window));
    });
    whenShown([this] { showState(); });
    begin();
}

WindowFields::Unit WindowFields::unit() const {
    return static_cast<Unit>(unit_->currentIndex());
}

void WindowFields::setSamples(double samples) {
    change([samples](Settings& settings) {
        settings.window = static_cast<std::int64_t>(samples);
        settings.periods.reset();
        settings.snap = false;
    });
}

void WindowFields::showState() {
    setTexts(*unit_, {tr("samples"), tr("periods"), tr("ms")});
    unit_->setAccessibleName(tr("Unit of the length"));
    unit_->setToolTip(tr("In which unit the length of the window is typed"));
    hop_->setPlaceholderText(tr("= window"));
    const Settings& settings = state().settings;
    const bool known = state().f0_hz && state().rate_hz;
    const std::int64_t window = windowInUse(state());
    const double length = static_cast<double>(window);

    const std::array<std::optional<double>, 3> lengths{
        length,
        settings.periods ? settings.periods
        : known          ? std::optional(length * *state().f0_hz / *state().rate_hz)
                         : std::nullopt,
        state().rate_hz ? std::optional(1000 * length / *state().rate_hz) : std::nullopt};
    const auto shown = static_cast<std::size_t>(unit_->currentIndex());
    length_->setInteger(unit() == Unit::samples);
    if (unit() == Unit::periods) {
        length_->setLimits(bounds_of("periods"));
    } else {
        length_->setLimits(bounds_of("window"),
                           unit() == Unit::samples ? 1 : state().rate_hz.value_or(1000) / 1000);
    }
    length_->setEnabled(lengths[shown].has_value());
    length_->setValue(lengths[shown]);
    QStringList others;
    for (std::size_t k = 0; k < lengths.size(); ++k) {
        if (k != shown && lengths[k]) {
            others << QStringLiteral("%1 %2").arg(
                k == 0 ? countLabel(window) : shortNumberText(*lengths[k], 5),
                unit_->itemText(static_cast<int>(k)));
        }
    }
    others_->setText(others.join(QStringLiteral(" · ")));
    others_->setVisible(!others.isEmpty());
    hop_->setValue(settings.hop > 0 ? std::optional(static_cast<double>(settings.hop))
                                    : std::nullopt);
    const double hop = settings.hop > 0 ? static_cast<double>(settings.hop) : length;
    overlap_->setValue(std::max(0.0, 100 * (1 - hop / length)));
    snap_->setEnabled(known);
    showResidual(window);
}

void WindowFields::showResidual(std::int64_t window) {
    if (!state().f0_hz || !state().rate_hz) {
        residual_->setText(tr("leakage %1").arg(QStringLiteral("—")));
        return;
    }
    const double residual = orthogonality_residual(window, *state().f0_hz, *state().rate_hz);
    residual_->setText(
        tr("leakage %1")
            .arg(residual < no_residual
                     ? QStringLiteral("< %1 %").arg(shortNumberText(100 * no_residual, 2))
                     : shortNumberText(100 * residual, 2) + QStringLiteral(" %")));
    QFont font = this->font();
    font.setBold(residual > high_residual);
    residual_->setFont(font);
}

RangeFields::RangeFields(QWidget* parent) : SettingsFields(parent) {
    const auto ends = addPair(
        {QT_TR_NOOP("From, to"), QT_TR_NOOP("s"),
         QT_TR_NOOP("Part of the recording to analyse, from its start."), QT_TR_NOOP("Range from")},
        QT_TR_NOOP("Range to"), {bounds_of("from"), bounds_of("to")});
    follow(ends[0], &Settings::from_s);
    follow(ends[1], &Settings::to_s);
    for (NumberField* field : ends) {
        field->setDigits(7);
    }
    auto* whole = withTexts(new QPushButton(this),
                            {QT_TR_NOOP("Whole"), "", QT_TR_NOOP("Analyse the whole recording")});
    auto* visible = withTexts(
        new QPushButton(this),
        {QT_TR_NOOP("As visible"), "", QT_TR_NOOP("Analyse the time range that the plots show")});
    addRow({{whole, 1}, {visible, 1}});
    connect(whole, &QPushButton::clicked, this, [this] {
        change([](Settings& settings) { settings.from_s = settings.to_s = std::nullopt; });
    });
    connect(visible, &QPushButton::clicked, this, &RangeFields::visibleRangeWanted);
    whenShown([this, ends] {
        ends[0]->setPlaceholderText(QStringLiteral("0"));
        ends[1]->setPlaceholderText(state().seconds ? shortNumberText(*state().seconds, 6)
                                                    : QString());
    });
    begin();
}

CarrierFields::CarrierFields(QWidget* parent) : SettingsFields(parent) {
    NumberField* f0 =
        addField({QT_TR_NOOP("Carrier f₀"), QT_TR_NOOP("Hz"),
                  QT_TR_NOOP("Carrier of the whole recording, around which each window looks "
                             "for its ω by (7), (25). Empty: the peak common to both channels' "
                             "spectra.")},
                 bounds_of("f0"));
    follow(f0, &Settings::f0_hz);
    bands_[0] = {&Settings::band,
                 addPair({QT_TR_NOOP("Search"), QT_TR_NOOP("Hz"),
                          QT_TR_NOOP("Look for the carrier between these frequencies. Empty: "
                                     "everywhere. Both are needed."),
                          QT_TR_NOOP("Search from")},
                         QT_TR_NOOP("Search to"), boundsOfBoth("band")),
                 std::nullopt};
    bands_[1] = {
        &Settings::filter,
        addPair({QT_TR_NOOP("Filter"), QT_TR_NOOP("Hz"),
                 QT_TR_NOOP("Zero-phase band-pass before everything, for raw recordings with other "
                            "modes, hum or offset: (1) presumes signals of the second angular "
                            "harmonic alone. Empty: none. Both are needed."),
                 QT_TR_NOOP("Filter from")},
                QT_TR_NOOP("Filter to"), boundsOfBoth("filter")),
        std::nullopt};
    for (BandFields& fields : bands_) {
        for (NumberField* field : fields.ends) {
            field->setOptional(true);
            field->setStep(10);
            connect(field, &NumberField::valueEdited, this, [this, &fields] { editBand(fields); });
            // A field restored to its old value emits no edit, but its band may have changed.
            connect(field, &NumberField::editingFinished, this,
                    [this, &fields] { editBand(fields); });
        }
        whenShown([this, &fields] { showBand(fields); });
    }
    whenShown([this, f0] {
        f0->setPlaceholderText(state().f0_hz ? numberLabel(*state().f0_hz, 3) : tr("auto"));
    });
    begin();
}

bool CarrierFields::BandFields::isFaulty() const {
    return !ends[0]->fault().isEmpty() || !ends[1]->fault().isEmpty();
}

void CarrierFields::editBand(const BandFields& fields) {
    showConflict(fields);
    if (!fields.isFaulty()) {
        const auto low = fields.ends[0]->value();
        const auto high = fields.ends[1]->value();
        change([&](Settings& settings) {
            settings.*fields.member = low ? std::optional(Band{*low, *high}) : std::nullopt;
        });
    }
}

// Incomplete and reversed bands are not applied; they stay in the fields, with the reason.
void CarrierFields::showConflict(const BandFields& fields) {
    const auto low = fields.ends[0]->value();
    const auto high = fields.ends[1]->value();
    QString sentence;
    if (low.has_value() != high.has_value()) {
        sentence = tr("Both frequencies are needed.");
    } else if (low && *low >= *high) {
        sentence = tr("The second frequency must be above the first.");
    }
    fields.ends[1]->setConflict(sentence);
}

void CarrierFields::showBand(BandFields& fields) {
    const std::optional<Band>& band = state().settings.*fields.member;
    // A band with a fault waits for its correction, unless undo changes the band.
    if (!fields.isFaulty() || band != fields.shown) {
        fields.ends[0]->setValue(band ? std::optional(band->low_hz) : std::nullopt);
        fields.ends[1]->setValue(band ? std::optional(band->high_hz) : std::nullopt);
    }
    fields.shown = band;
    fields.ends[0]->setPlaceholderText(tr("from"));
    fields.ends[1]->setPlaceholderText(tr("to"));
    showConflict(fields);
}

StartFields::StartFields(QWidget* parent) : SettingsFields(parent) {
    start_ = withTexts(withName(new QComboBox(this), "start"),
                       {QT_TR_NOOP("Start from"), "",
                        QT_TR_NOOP("First guess of the conjugate gradient for each window: the "
                                   "closed forms (15), (18) of algorithm 1, the result of the "
                                   "window before, or your own values.")});
    start_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    start_->addItems({{}, {}, {}});
    addWide(start_);
    const char* tip =
        QT_TR_NOOP("Start value of the functional F's parameter, in the notation of (6).");
    const std::array<Texts, 5> texts{
        Texts{QT_TR_NOOP("a_A"), "", tip}, Texts{QT_TR_NOOP("a_B"), "", tip},
        Texts{QT_TR_NOOP("2θ_A"), QT_TR_NOOP("rad"), tip},
        Texts{QT_TR_NOOP("α"), QT_TR_NOOP("rad"),
              QT_TR_NOOP("Phase at the centre of the first window; it is carried on to the others "
                         "with the frequency.")},
        Texts{QT_TR_NOOP("f"), QT_TR_NOOP("Hz"), tip}};
    for (std::size_t k = 0; k < typed_.size(); ++k) {
        typed_[k] = addField(texts[k], bounds_of("initial", k));
        typed_[k]->setStep(0.1);
        connect(typed_[k], &NumberField::valueEdited, this, [this] {
            const auto value = [this](std::size_t of) { return *typed_[of]->value(); };
            change([&](Settings& settings) {
                settings.initial = StartValues{{value(0), value(1), value(2), value(3)}, value(4)};
            });
        });
    }
    every_window_ = withTexts(
        new QCheckBox(this),
        {QT_TR_NOOP("for every window"), "",
         QT_TR_NOOP("On: every window starts from the typed values. Off: only the first one, the "
                    "others from the result of the window before.")});
    addWide(every_window_);

    connect(start_, &QComboBox::activated, this, [this](int start) {
        change([&](Settings& settings) {
            settings.start = start == automatic ? StartRule::first : StartRule::previous;
            if (start != typed) {
                settings.initial.reset();
            } else if (!settings.initial) {
                settings.initial = StartValues{{1, 0, 0, 0}, state().f0_hz.value_or(5300)};
            }
        });
    });
    connect(every_window_, &QCheckBox::clicked, this, [this](bool every) {
        change([&](Settings& settings) {
            settings.start = every ? StartRule::first : StartRule::previous;
        });
    });
    whenShown([this] { showState(); });
    begin();
}

QString StartFields::summary() const {
    return state().settings.algorithm == Algorithm::conjugate_gradient ? start_->currentText()
                                                                       : tr("of algorithm 5 alone");
}

void StartFields::showState() {
    setTexts(*start_, {tr("algorithm 1, each window"), tr("previous window"), tr("typed values")});
    const Settings& settings = state().settings;
    setEnabled(settings.algorithm == Algorithm::conjugate_gradient);
    const bool own = settings.initial.has_value();
    start_->setCurrentIndex(own                                     ? typed
                            : settings.start == StartRule::previous ? previous
                                                                    : automatic);
    const StartValues shown = settings.initial.value_or(StartValues{});
    const std::array values{shown.state.a_A, shown.state.a_B, shown.state.two_theta_A,
                            shown.state.alpha, shown.f_hz};
    for (std::size_t k = 0; k < typed_.size(); ++k) {
        typed_[k]->setEnabled(own);
        typed_[k]->setOptional(!own);
        typed_[k]->setValue(own ? std::optional(values[k]) : std::nullopt);
    }
    every_window_->setEnabled(own);
    every_window_->setChecked(own && settings.start == StartRule::first);
}

CalibrationFields::CalibrationFields(QWidget* parent) : SettingsFields(parent) {
    const auto of_calibration = [](auto Calibration::*member) {
        return [member](auto& settings) -> auto& {
            return settings.calibration.*member;
        };
    };
    NumberField* kappa = addField(
        {QT_TR_NOOP("Gain ratio κ"), "",
         QT_TR_NOOP("Channel D is recorded as D/κ, the scaling below (30): κ = 1 for balanced "
                    "channels.")},
        bounds_of("kappa"));
    kappa->setStep(0.001);
    follow(kappa, of_calibration(&Calibration::kappa));
    const auto offsets = addPair(
        {QT_TR_NOOP("Offset C, D"), "",
         QT_TR_NOOP("Constant in each channel, recording units; it is subtracted. The averages of "
                    "(13), (15) presume none."),
         QT_TR_NOOP("Offset of C")},
        QT_TR_NOOP("Offset of D"), boundsOfBoth("offset"));
    follow(offsets[0], of_calibration(&Calibration::offset_c));
    follow(offsets[1], of_calibration(&Calibration::offset_d));
    auto* automatic = withTexts(
        new QCheckBox(this), {QT_TR_NOOP("Take the offsets from the signals"), "",
                              QT_TR_NOOP("Each channel's mean over whole periods of the carrier")});
    addWide(automatic);
    follow(automatic, of_calibration(&Calibration::offset_auto));
    whenShown([this, offsets] {
        for (NumberField* field : offsets) {
            field->setEnabled(!state().settings.calibration.offset_auto);
        }
    });
    NumberField* delay =
        addField({QT_TR_NOOP("Delay of D"), QT_TR_NOOP("µs"),
                  QT_TR_NOOP("By how much channel D is sampled later than C. It would otherwise "
                             "count as Δφ_CD of (9).")},
                 bounds_of("delay"), 1e-6);
    follow(delay, of_calibration(&Calibration::delay_d_s), 1e6);
    NumberField* zero =
        addField({QT_TR_NOOP("Angle zero"), QT_TR_NOOP("°"),
                  QT_TR_NOOP("Angle of the first electrode, subtracted from θ_A of (2): the "
                             "article counts the angle from there.")},
                 bounds_of("angle-zero"));
    follow(zero, of_calibration(&Calibration::angle_zero_deg));
    auto* repair = withTexts(
        new QCheckBox(this),
        {QT_TR_NOOP("Make gaps of lost samples"), "",
         QT_TR_NOOP("Where the recording check finds lost samples, as many missing ones are put "
                    "in, so that time runs on behind them. Windows over them have no values.")});
    addWide(repair);
    follow(repair, &Settings::repair_lost);
    auto* title = withTexts(new QLabel(this),
                            {QT_TR_NOOP("How well the channels and the clock are known, for u. "
                                        "Empty: the number in grey is assumed; 0: exact."),
                             "", ""});
    title->setWordWrap(true);
    addWide(title);
    addTolerance({QT_TR_NOOP("κ ±"), "",
                  QT_TR_NOOP("How well the gain ratio is known: relative standard deviation."),
                  QT_TR_NOOP("Tolerance of the gain ratio")},
                 kappa_error, 0.001);
    addTolerance({QT_TR_NOOP("Non-orthogonality ε ±"), QT_TR_NOOP("°"),
                  QT_TR_NOOP("Non-orthogonality of the pick-offs: D holds sin ε of C."),
                  QT_TR_NOOP("Tolerance of the non-orthogonality")},
                 skew_error, 0.1);
    addTolerance({QT_TR_NOOP("Delay ±"), QT_TR_NOOP("ns"),
                  QT_TR_NOOP("Of D against C, beyond the delay above."),
                  QT_TR_NOOP("Tolerance of the delay")},
                 delay_error, 1);
    addTolerance({QT_TR_NOOP("Crosstalk ±"), "",
                  QT_TR_NOOP("Of C into D with its phase turned by 90 degrees, relative."),
                  QT_TR_NOOP("Tolerance of the crosstalk")},
                 crosstalk_error, 1e-4);
    addTolerance({QT_TR_NOOP("Phase drift ±"), QT_TR_NOOP("rad"),
                  QT_TR_NOOP("Of D against C over a recording, in proportion to time."),
                  QT_TR_NOOP("Tolerance of the phase drift")},
                 phase_drift_error, 1e-4);
    addTolerance({QT_TR_NOOP("Gain drift ±"), "",
                  QT_TR_NOOP("Of D against C over a recording, relative, in proportion to time."),
                  QT_TR_NOOP("Tolerance of the gain drift")},
                 gain_drift_error, 1e-4);
    addTolerance({QT_TR_NOOP("Clock ±"), QT_TR_NOOP("ppm"),
                  QT_TR_NOOP("Of the recorder's sample rate, for absolute frequencies and decay "
                             "times."),
                  QT_TR_NOOP("Tolerance of the sample rate")},
                 rate_error, 1);
    addTolerance(
        {QT_TR_NOOP("Spread ±"), "",
         QT_TR_NOOP(
             "Of the decay rate between the recordings of a set, relative; of the split 2.5 times "
             "it, of the gain ratio a tenth of it. Empty: what two or three recordings cannot "
             "show."),
         QT_TR_NOOP("Tolerance of the spread between recordings")},
        spread_error, 1e-3);
    begin();
}

QString CalibrationFields::summary() const {
    const double kappa = state().settings.calibration.kappa;
    const auto tolerance = [&](ErrorSource source) {
        return shortNumberText(state().tolerance[source].value_or(assumed_tolerance(source, kappa)),
                               3);
    };
    return QStringLiteral("κ %1 ± %2, ε ± %3°")
        .arg(shortNumberText(kappa, 6), tolerance(kappa_error), tolerance(skew_error));
}

void CalibrationFields::addTolerance(const Texts& texts, ErrorSource source, double step) {
    const double scale = tolerated_errors[source].shown;
    NumberField* field = addField(texts, tolerance_bounds, scale);
    field->setOptional(true);
    field->setStep(step);
    connect(field, &NumberField::valueEdited, this, [this, source, scale](auto value) {
        Tolerance tolerance = state().tolerance;
        tolerance[source] = value ? std::optional(*value * scale) : std::nullopt;
        emit toleranceEdited(tolerance);
    });
    whenShown([this, field, source, scale] {
        const std::optional<double>& told = state().tolerance[source];
        field->setValue(told ? std::optional(*told / scale) : std::nullopt);
        const bool none = source >= channel_error_count;
        const double assumed =
            assumed_tolerance(source, state().settings.calibration.kappa) / scale;
        field->setPlaceholderText(none ? QString() : shortNumberText(assumed, 6));
    });
}

}  // namespace vybeg::ui

#include "moc_settings_groups.cpp"
