#include "ui/settings/signal_fields.h"

#include "core/analysis/setting_table.h"
#include "ui/widgets/page_parts.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>

#include <algorithm>

namespace vybeg::ui {

RangeFields::RangeFields(QWidget* parent) : SettingsFields(parent) {
    const auto pair = addPair(
        {QT_TR_NOOP("From, to"), QT_TR_NOOP("s"),
         QT_TR_NOOP("Part of the recording to analyse, from its start."), QT_TR_NOOP("Range from")},
        {"", QT_TR_NOOP("s"), QT_TR_NOOP("Part of the recording to analyse, from its start."),
         QT_TR_NOOP("Range to")});
    from_ = pair.first;
    to_ = pair.second;
    auto* buttons = new QWidget(this);
    whole_ = new QPushButton(buttons);
    visible_ = new QPushButton(buttons);
    fill(new QHBoxLayout(buttons), {}, {{whole_, 1}, {visible_, 1}});
    addWide(buttons);
    for (NumberField* field : {from_, to_}) {
        field->setLimits(bounds_of(field == from_ ? "from" : "to"));
        field->setDigits(7);
    }
    follow(from_, &Settings::from_s);
    follow(to_, &Settings::to_s);
    connect(whole_, &QPushButton::clicked, this, [this] {
        change([](Settings& settings) { settings.from_s = settings.to_s = std::nullopt; });
    });
    connect(visible_, &QPushButton::clicked, this, &RangeFields::visibleRangeWanted);
    keepTranslated(*this, [this] { retranslate(); });
}

void RangeFields::retranslate() {
    whole_->setText(tr("Whole"));
    whole_->setToolTip(tr("Analyse the whole recording"));
    visible_->setText(tr("As visible"));
    visible_->setToolTip(tr("Analyse the time range that the plots show"));
    SettingsFields::retranslate();
}

void RangeFields::refresh() {
    from_->setValue(state().settings.from_s);
    to_->setValue(state().settings.to_s);
    from_->setPlaceholderText(QStringLiteral("0"));
    to_->setPlaceholderText(state().seconds ? QLocale().toString(*state().seconds, 'g', 6)
                                            : QString());
}

CarrierFields::CarrierFields(QWidget* parent) : SettingsFields(parent) {
    f0_ = addField({QT_TR_NOOP("Carrier f₀"), QT_TR_NOOP("Hz"),
                    QT_TR_NOOP("Carrier of the whole recording, around which each window looks "
                               "for its ω by (7), (25). Empty: the peak common to both channels' "
                               "spectra.")},
                   bounds_of("f0"));
    follow(f0_, &Settings::f0_hz);
    const char* band_tip = QT_TR_NOOP(
        "Look for the carrier between these frequencies. Empty: everywhere. Both are needed.");
    const auto band =
        addPair({QT_TR_NOOP("Search"), QT_TR_NOOP("Hz"), band_tip, QT_TR_NOOP("Search from")},
                {"", QT_TR_NOOP("Hz"), band_tip, QT_TR_NOOP("Search to")});
    const char* filter_tip = QT_TR_NOOP(
        "Zero-phase band-pass before everything, for raw recordings with other modes, hum or "
        "offset: (1) presumes signals of the second angular harmonic alone. Empty: none. Both "
        "are needed.");
    const auto filter =
        addPair({QT_TR_NOOP("Filter"), QT_TR_NOOP("Hz"), filter_tip, QT_TR_NOOP("Filter from")},
                {"", QT_TR_NOOP("Hz"), filter_tip, QT_TR_NOOP("Filter to")});
    bands_ = {BandFields{"band", &Settings::band, band.first, band.second, std::nullopt},
              BandFields{"filter", &Settings::filter, filter.first, filter.second, std::nullopt}};
    for (const BandFields& fields : bands_) {
        for (NumberField* field : {fields.low, fields.high}) {
            field->setOptional(true);
            field->setLimits(bounds_of(fields.option, field == fields.low ? 0 : 1));
            field->setStep(10);
            connect(field, &NumberField::valueEdited, this, [this, &fields] { editBand(fields); });
            // A field restored to its old value emits no edit, but its band may have changed.
            connect(field, &NumberField::editingFinished, this,
                    [this, &fields] { editBand(fields); });
        }
    }
    keepTranslated(*this, [this] { retranslate(); });
}

void CarrierFields::editBand(const BandFields& fields) {
    showConflict(fields);
    if (!fields.low->fault().isEmpty() || !fields.high->fault().isEmpty()) {
        return;
    }
    const auto low = fields.low->value();
    const auto high = fields.high->value();
    change([&](Settings& settings) {
        settings.*fields.member = low ? std::optional(Band{*low, *high}) : std::nullopt;
    });
}

// Incomplete and reversed bands are not applied; they stay in the fields, with the reason.
void CarrierFields::showConflict(const BandFields& fields) {
    const auto low = fields.low->value();
    const auto high = fields.high->value();
    QString sentence;
    if (low.has_value() != high.has_value()) {
        sentence = tr("Both frequencies are needed.");
    } else if (low && *low >= *high) {
        sentence = tr("The second frequency must be above the first.");
    }
    fields.high->setConflict(sentence);
}

void CarrierFields::showBand(BandFields& fields) {
    const std::optional<Band>& band = state().settings.*fields.member;
    // A band with a fault waits for its correction, unless undo changes the band.
    const bool waits = !fields.low->fault().isEmpty() || !fields.high->fault().isEmpty();
    if (!waits || band != fields.shown) {
        fields.low->setValue(band ? std::optional(band->low_hz) : std::nullopt);
        fields.high->setValue(band ? std::optional(band->high_hz) : std::nullopt);
    }
    fields.shown = band;
    showConflict(fields);
}

void CarrierFields::retranslate() {
    for (const BandFields& fields : bands_) {
        fields.low->setPlaceholderText(tr("from"));
        fields.high->setPlaceholderText(tr("to"));
    }
    SettingsFields::retranslate();
}

void CarrierFields::refresh() {
    const Settings& settings = state().settings;
    f0_->setValue(settings.f0_hz);
    f0_->setPlaceholderText(state().f0_hz ? QLocale().toString(*state().f0_hz, 'f', 3)
                                          : tr("auto"));
    for (BandFields& fields : bands_) {
        showBand(fields);
    }
}

CalibrationFields::CalibrationFields(QWidget* parent) : SettingsFields(parent) {
    // `per_unit`: units of the field in one of the setting.
    const auto show = [this](NumberField* field, double Calibration::*member, double per_unit = 1) {
        numbers_.push_back({field, member, per_unit});
        connect(field, &NumberField::valueEdited, this, [this, member, per_unit](auto value) {
            change([&](Settings& settings) { settings.calibration.*member = *value / per_unit; });
        });
    };
    NumberField* kappa = addField(
        {QT_TR_NOOP("Gain ratio κ"), "",
         QT_TR_NOOP("Channel D is recorded as D/κ, the scaling below (30): κ = 1 for balanced "
                    "channels.")},
        bounds_of("kappa"));
    kappa->setStep(0.001);
    show(kappa, &Calibration::kappa);
    const char* offset_tip = QT_TR_NOOP(
        "Constant in each channel, recording units; it is subtracted. The averages of (13), (15) "
        "presume none.");
    const auto offsets =
        addPair({QT_TR_NOOP("Offset C, D"), "", offset_tip, QT_TR_NOOP("Offset of C")},
                {"", "", offset_tip, QT_TR_NOOP("Offset of D")});
    offset_c_ = offsets.first;
    offset_d_ = offsets.second;
    offset_c_->setLimits(bounds_of("offset", 0));
    offset_d_->setLimits(bounds_of("offset", 1));
    show(offset_c_, &Calibration::offset_c);
    show(offset_d_, &Calibration::offset_d);
    offset_auto_ = new QCheckBox(this);
    addWide(offset_auto_);
    show(addField({QT_TR_NOOP("Delay of D"), QT_TR_NOOP("µs"),
                   QT_TR_NOOP("By how much channel D is sampled later than C. It would otherwise "
                              "count as Δφ_CD of (9).")},
                  bounds_of("delay"), 1e-6),
         &Calibration::delay_d_s, 1e6);
    show(addField({QT_TR_NOOP("Angle zero"), QT_TR_NOOP("°"),
                   QT_TR_NOOP("Angle of the first electrode, subtracted from θ_A of (2): the "
                              "article counts the angle from there.")},
                  bounds_of("angle-zero")),
         &Calibration::angle_zero_deg);
    connect(offset_auto_, &QCheckBox::clicked, this, [this](bool automatic) {
        change([&](Settings& settings) { settings.calibration.offset_auto = automatic; });
    });
    repair_lost_ = new QCheckBox(this);
    addWide(repair_lost_);
    connect(repair_lost_, &QCheckBox::clicked, this, [this](bool wanted) {
        change([&](Settings& settings) { settings.repair_lost = wanted; });
    });
    addTolerances();
    keepTranslated(*this, [this] { retranslate(); });
}

void CalibrationFields::addTolerances() {
    tolerances_title_ = new QLabel(this);
    tolerances_title_->setWordWrap(true);
    addWide(tolerances_title_);
    const auto add = [this](const Texts& texts, std::optional<double> Tolerance::*member,
                            double scale, double step) {
        NumberField* field = addField(texts, tolerance_bounds, scale);
        field->setOptional(true);
        field->setStep(step);
        tolerances_.push_back({field, member, scale});
        connect(field, &NumberField::valueEdited, this, [this, member, scale](auto value) {
            Tolerance tolerance = state().tolerance;
            tolerance.*member = value ? std::optional(*value * scale) : std::nullopt;
            emit toleranceEdited(tolerance);
        });
    };
    add({QT_TR_NOOP("κ ±"), "",
         QT_TR_NOOP("How well the gain ratio is known: relative standard deviation."),
         QT_TR_NOOP("Tolerance of the gain ratio")},
        &Tolerance::kappa, 1, 0.001);
    add({QT_TR_NOOP("Non-orthogonality ε ±"), QT_TR_NOOP("°"),
         QT_TR_NOOP("Non-orthogonality of the pick-offs: D holds sin ε of C."),
         QT_TR_NOOP("Tolerance of the non-orthogonality")},
        &Tolerance::skew_deg, 1, 0.1);
    add({QT_TR_NOOP("Delay ±"), QT_TR_NOOP("ns"),
         QT_TR_NOOP("Of D against C, beyond the delay above."),
         QT_TR_NOOP("Tolerance of the delay")},
        &Tolerance::delay_s, 1e-9, 1);
    add({QT_TR_NOOP("Crosstalk ±"), "",
         QT_TR_NOOP("Of C into D with its phase turned by 90 degrees, relative."),
         QT_TR_NOOP("Tolerance of the crosstalk")},
        &Tolerance::crosstalk, 1, 1e-4);
    add({QT_TR_NOOP("Phase drift ±"), QT_TR_NOOP("rad"),
         QT_TR_NOOP("Of D against C over a recording, in proportion to time."),
         QT_TR_NOOP("Tolerance of the phase drift")},
        &Tolerance::phase_drift_rad, 1, 1e-4);
    add({QT_TR_NOOP("Gain drift ±"), "",
         QT_TR_NOOP("Of D against C over a recording, relative, in proportion to time."),
         QT_TR_NOOP("Tolerance of the gain drift")},
        &Tolerance::gain_drift, 1, 1e-4);
    add({QT_TR_NOOP("Clock ±"), QT_TR_NOOP("ppm"),
         QT_TR_NOOP("Of the recorder's sample rate, for absolute frequencies and decay times."),
         QT_TR_NOOP("Tolerance of the sample rate")},
        &Tolerance::rate_ppm, 1, 1);
    add({QT_TR_NOOP("Spread ±"), "",
         QT_TR_NOOP(
             "Of the decay rate between the recordings of a set, relative; of the split 2.5 times "
             "it, of the gain ratio a tenth of it. Empty: what two or three recordings cannot "
             "show."),
         QT_TR_NOOP("Tolerance of the spread between recordings")},
        &Tolerance::spread, 1, 1e-3);
}

void CalibrationFields::showTolerances() {
    const Tolerance& tolerance = state().tolerance;
    const double kappa = state().settings.calibration.kappa;
    for (const ToleranceField& each : tolerances_) {
        const std::optional<double>& told = tolerance.*each.member;
        each.field->setValue(told ? std::optional(*told / each.scale) : std::nullopt);
        const auto row =
            std::ranges::find(tolerance_parameters, each.member, &ToleranceParameter::member);
        const double assumed = assumed_tolerance(row->source, kappa) / each.scale;
        const bool none = row->source == rate_error || row->source == spread_error;
        each.field->setPlaceholderText(none ? QString() : QLocale().toString(assumed));
    }
}

void CalibrationFields::retranslate() {
    offset_auto_->setText(tr("Take the offsets from the signals"));
    offset_auto_->setToolTip(tr("Each channel's mean over whole periods of the carrier"));
    repair_lost_->setText(tr("Make gaps of lost samples"));
    repair_lost_->setToolTip(
        tr("Where the recording check finds lost samples, as many missing ones are put in, so that "
           "time runs on behind them. Windows over them have no values."));
    tolerances_title_->setText(
        tr("How well the channels and the clock are known, for u. Empty: the number in "
           "grey is assumed; 0: exact."));
    SettingsFields::retranslate();
}

void CalibrationFields::refresh() {
    showTolerances();
    repair_lost_->setChecked(state().settings.repair_lost);
    const Calibration& calibration = state().settings.calibration;
    for (const CalibrationField& each : numbers_) {
        each.field->setValue(calibration.*each.member * each.per_unit);
    }
    offset_c_->setEnabled(!calibration.offset_auto);
    offset_d_->setEnabled(!calibration.offset_auto);
    offset_auto_->setChecked(calibration.offset_auto);
}

}  // namespace vybeg::ui
