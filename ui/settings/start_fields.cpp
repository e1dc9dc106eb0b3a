#include "ui/settings/start_fields.h"

#include "core/analysis/setting_table.h"
#include "ui/widgets/keep_translated.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/rich_text.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>

namespace vybeg::ui {

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
    a_A_ = addField({QT_TR_NOOP("a_A"), "", tip});
    a_B_ = addField({QT_TR_NOOP("a_B"), "", tip});
    two_theta_A_ = addField({QT_TR_NOOP("2θ_A"), QT_TR_NOOP("rad"), tip});
    alpha_ = addField({QT_TR_NOOP("α"), QT_TR_NOOP("rad"),
                       QT_TR_NOOP("Phase at the centre of the first window; it is carried on to "
                                  "the others with the frequency.")});
    f_ = addField({QT_TR_NOOP("f"), QT_TR_NOOP("Hz"), tip});
    every_window_ = new QCheckBox(this);
    addWide(every_window_);

    connect(start_, &QComboBox::activated, this, &StartFields::chooseStart);
    std::size_t number = 0;
    for (NumberField* field : {a_A_, a_B_, two_theta_A_, alpha_, f_}) {
        field->setLimits(bounds_of("initial", number++));
        field->setStep(0.1);
        connect(field, &NumberField::valueEdited, this, &StartFields::editTyped);
    }
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
        settings.initial =
            StartValues{{*a_A_->value(), *a_B_->value(), *two_theta_A_->value(), *alpha_->value()},
                        *f_->value()};
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
    const auto show = [own](NumberField* field, double value) {
        field->setEnabled(own);
        field->setOptional(!own);
        field->setValue(own ? std::optional(value) : std::nullopt);
    };
    show(a_A_, shown.state.a_A);
    show(a_B_, shown.state.a_B);
    show(two_theta_A_, shown.state.two_theta_A);
    show(alpha_, shown.state.alpha);
    show(f_, shown.f_hz);
    every_window_->setEnabled(own);
    every_window_->setChecked(own && settings.start == StartRule::first);
}

}  // namespace vybeg::ui
