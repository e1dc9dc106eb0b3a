#include "ui/settings/estimation_fields.h"

#include "core/analysis/setting_table.h"
#include "core/windows/window_plan.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSignalBlocker>

#include <algorithm>
#include <array>
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

}  // namespace

WindowFields::WindowFields(QWidget* parent) : SettingsFields(parent) {
    // The length in the chosen unit, and below it in the others.
    auto* length = new QWidget(this);
    length_ = makeField(
        {QT_TR_NOOP("Length"), "",
         QT_TR_NOOP("Window of n consecutive samples, the averaging interval T of (7). The slow "
                    "variables are constant inside it. At least 5 samples and three quarters of a "
                    "period. The article varies T from 1 to 10 periods, which may be fractions.")});
    length_->setDigits(6);
    unit_ = withName(new QComboBox(length), "lengthUnit");
    unit_->addItems({QString(), QString(), QString()});
    unit_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    fill(new QHBoxLayout(length), {}, 4, {{length_, 1}, unit_});
    addWide(length);
    addFaults({length_});
    others_ = withName(new QLabel(this), "otherLengths");
    addWide(others_);

    auto* check = new QWidget(this);
    residual_ = withName(new QLabel(check), "residual");
    snap_ = withName(new QPushButton(check), "snap");
    fill(new QHBoxLayout(check), {}, {{residual_, 1}, snap_});
    addWide(check,
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

    connect(length_, &NumberField::valueEdited, this, [this](auto value) { setLength(*value); });
    connect(unit_, &QComboBox::activated, this, &WindowFields::refresh);
    connect(hop_, &NumberField::valueEdited, this, [this](auto value) {
        change([&](Settings& settings) {
            settings.hop = value ? static_cast<std::int64_t>(*value) : 0;
        });
    });
    connect(overlap_, &NumberField::valueEdited, this, [this](auto value) {
        Settings settings = state().settings;
        const double window = static_cast<double>(windowInUse(state()));
        const double hop = std::max(1.0, std::round(window * (1 - *value / 100)));
        settings.hop = *value == 0 ? 0 : static_cast<std::int64_t>(hop);
        emit edited(settings);
    });
    connect(snap_, &QPushButton::clicked, this, &WindowFields::snap);
    keepTranslated(*this, [this] { retranslate(); });
}

WindowFields::Unit WindowFields::unit() const {
    return static_cast<Unit>(unit_->currentIndex());
}

void WindowFields::setLength(double length) {
    if (unit() == Unit::periods) {
        Settings settings = state().settings;
        settings.periods = length;
        settings.snap = false;
        emit edited(settings);
    } else {
        setSamples(unit() == Unit::samples ? length : std::round(length * *state().rate_hz / 1000));
    }
}

void WindowFields::setSamples(double samples) {
    Settings settings = state().settings;
    settings.window = static_cast<std::int64_t>(samples);
    settings.periods.reset();
    settings.snap = false;
    emit edited(settings);
}

void WindowFields::snap() {
    const auto window = snap_window(windowInUse(state()), *state().f0_hz, *state().rate_hz);
    setSamples(static_cast<double>(window));
}

void WindowFields::retranslate() {
    setTexts(*unit_, {tr("samples"), tr("periods"), tr("ms")});
    unit_->setAccessibleName(tr("Unit of the length"));
    unit_->setToolTip(tr("In which unit the length of the window is typed"));
    snap_->setText(tr("Snap"));
    snap_->setToolTip(
        richTip(tr("Moves the window to whole half-periods of the carrier: the n nearest to the "
                   "wish that leaks least.")));
    hop_->setPlaceholderText(tr("= window"));
    SettingsFields::retranslate();
}

void WindowFields::refresh() {
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
            others << QStringLiteral("%1 %2").arg(QLocale().toString(*lengths[k], 'g', 5),
                                                  unit_->itemText(static_cast<int>(k)));
        }
    }
    others_->setText(others.join(QStringLiteral(" · ")));
    others_->setVisible(!others.isEmpty());
    snap_->setEnabled(known);
    hop_->setValue(settings.hop > 0 ? std::optional(static_cast<double>(settings.hop))
                                    : std::nullopt);
    const double hop = settings.hop > 0 ? static_cast<double>(settings.hop) : length;
    overlap_->setValue(std::max(0.0, 100 * (1 - hop / length)));

    if (!known) {
        residual_->setText(tr("leakage %1").arg(QStringLiteral("—")));
        return;
    }
    const double residual = orthogonality_residual(window, *state().f0_hz, *state().rate_hz);
    residual_->setText(
        tr("leakage %1")
            .arg(residual < no_residual
                     ? QStringLiteral("< %1 %").arg(QLocale().toString(100 * no_residual))
                     : QLocale().toString(100 * residual, 'g', 2) + QStringLiteral(" %")));
    QFont font = this->font();
    font.setBold(residual > high_residual);
    residual_->setFont(font);
}

StartFields::StartFields(QWidget* parent) : SettingsFields(parent) {
    start_ = withName(new QComboBox(this), "start");
    start_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    start_->addItems({{}, {}, {}});
    addWide(start_, {QT_TR_NOOP("Start from"), "",
                     QT_TR_NOOP("First guess of the conjugate gradient for each window: the "
                                "closed forms (15), (18) of algorithm 1, the result of the "
                                "window before, or your own values.")});
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
        connect(typed_[k], &NumberField::valueEdited, this, &StartFields::editTyped);
    }
    every_window_ = new QCheckBox(this);
    addWide(every_window_);

    connect(start_, &QComboBox::activated, this, &StartFields::chooseStart);
    connect(every_window_, &QCheckBox::clicked, this, [this](bool every) {
        change([&](Settings& settings) {
            settings.start = every ? StartRule::first : StartRule::previous;
        });
    });
    keepTranslated(*this, [this] { retranslate(); });
}

void StartFields::chooseStart(int start) {
    Settings settings = state().settings;
    settings.start = start == automatic ? StartRule::first : StartRule::previous;
    if (start != typed) {
        settings.initial.reset();
    } else if (!settings.initial) {
        settings.initial = StartValues{{1, 0, 0, 0}, state().f0_hz.value_or(5300)};
    }
    emit edited(settings);
}

void StartFields::editTyped() {
    change([&](Settings& settings) {
        const auto value = [this](std::size_t k) { return *typed_[k]->value(); };
        settings.initial = StartValues{{value(0), value(1), value(2), value(3)}, value(4)};
    });
}

void StartFields::retranslate() {
    setTexts(*start_, {tr("algorithm 1, each window"), tr("previous window"), tr("typed values")});
    every_window_->setText(tr("for every window"));
    every_window_->setToolTip(richTip(
        tr("On: every window starts from the typed values. Off: only the first one, the others "
           "from the result of the window before.")));
    SettingsFields::retranslate();
}

void StartFields::refresh() {
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

}  // namespace vybeg::ui
