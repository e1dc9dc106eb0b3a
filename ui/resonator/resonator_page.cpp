#include "ui/resonator/resonator_page.h"

#include "ui/resonator/outcome_views.h"
#include "ui/resonator/set_panel.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/error_text.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QScrollArea>
#include <QTabWidget>
#include <QVBoxLayout>

namespace vybeg::ui {

ResonatorPage::ResonatorPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      set_(new SetPanel(document, this)),
      state_(sentence(this, "state")),
      numbers_(withPart(new NumbersView(document, this))),
      figures_(withPart(new FiguresView(document, this))),
      comparison_(withPart(new ComparisonView(document, this))) {
    balance_tab_ = numbers_->addTab(figures_->balance());
    comparison_tab_ = numbers_->addTab(comparison_);
    // The sets, their numbers, and the figures.
    constexpr int sets_width = 216;
    constexpr int least_figures_width = 300;
    auto* left = new QWidget(this);
    left->setFixedWidth(sets_width);
    fill(new QVBoxLayout(left), {}, 0, {set_, state_, LayoutPart(1)});
    middle_ = scrolled(fill(new QVBoxLayout, {LayoutPart(numbers_, 1)}));
    auto* figures = scrolled(fill(new QVBoxLayout, {LayoutPart(figures_, 1)}));
    figures->setMinimumWidth(least_figures_width);
    fill(new QHBoxLayout(this), {}, 4, {left, {middle_, 5}, {figures, 2}});
    connect(numbers_, &NumbersView::calibrationChosen, this, &ResonatorPage::calibrate);
    connect(&document_.sets(), &SetStore::changed, this, &ResonatorPage::refresh);
    connect(&document_, &Document::recordingChanged, this, &ResonatorPage::refresh);
    connect(&document_, &Document::busyChanged, this,
            [this] { showState(document_.sets().current()); });
    connect(&document_.passport(), &PassportStore::changed, this, &ResonatorPage::showTabs);
    guardFromWheel(*this);
    retranslate();
}

void ResonatorPage::retranslate() {
    QTabWidget& tabs = *numbers_->tabs();
    tabs.setTabText(balance_tab_, tr("Channel balance"));
    tabs.setTabToolTip(balance_tab_, tr("Condition (30) of the article, recording by recording"));
    tabs.setTabText(comparison_tab_, tr("Passport"));
    tabs.setTabToolTip(comparison_tab_, tr("What has changed since the passport was made"));
    rebuild();
}

// Those that have something to show.
void ResonatorPage::showTabs() {
    QTabWidget& tabs = *numbers_->tabs();
    tabs.setTabVisible(balance_tab_,
                       shown_ && shown_->identification.fit.model == ResonatorModel::structured);
    const bool compared = document_.passport().content() != nullptr;
    tabs.setTabVisible(comparison_tab_, compared);
    numbers_->setVisible(compared || !numbers_->isEmpty());
    // The hint in the place of the figures then has all the page.
    middle_->setVisible(compared || !numbers_->isEmpty());
    // The current tab of a bar whose tabs come and go may be hidden.
    for (int tab = 0; tab < tabs.count() && !tabs.isTabVisible(tabs.currentIndex()); ++tab) {
        if (tabs.isTabVisible(tab)) {
            tabs.setCurrentIndex(tab);
        }
    }
}

FigureSource ResonatorPage::figures() const {
    return figures_->figures();
}

void ResonatorPage::showComparison() {
    numbers_->tabs()->setCurrentIndex(comparison_tab_);
}

// Of the panel; where a list says how the set is calibrated, of the set and of its rows.
void ResonatorPage::calibrate(const QString& offer, const FoundCalibration& found) {
    const auto change = [&](Calibration& calibration, double earlier_s) {
        if (offer == QStringLiteral("kappa") && found.kappa) {
            calibration.kappa = found.kappa->value;
        } else if (offer == QStringLiteral("delay") && found.delay_d_s) {
            calibration.delay_d_s += *found.delay_d_s - earlier_s;
        } else if (offer == QStringLiteral("offset") && found.offsets &&
                   calibration.offset_c == 0 && calibration.offset_d == 0) {
            calibration.offset_auto = true;
        }
    };
    const auto narrow = [&](Tolerance& tolerance) {
        if (offer == QStringLiteral("kappa") && found.kappa) {
            tolerance[kappa_error] = found.kappa->uncertainty() / found.kappa->value;
        }
    };
    const RecordingSet* set = document_.sets().current();
    if (set && set->listed && !set->by_panel) {
        MeasurementSet listed = *set->listed;
        // The calibration found is that of the first recording; delays of the others keep their
        // distance.
        const double earlier_s = listed.settings.signal_of(0).calibration.delay_d_s;
        change(listed.settings.signal.calibration, earlier_s);
        for (SignalSettings& each : listed.settings.of_recordings) {
            change(each.calibration, earlier_s);
        }
        narrow(listed.settings.tolerance);
        if (listed.settings != set->listed->settings) {
            document_.sets().changeListed(set->id, std::move(listed));
        }
        return;
    }
    Settings settings = document_.settings();
    change(settings.calibration, settings.calibration.delay_d_s);
    Tolerance tolerance = document_.tolerance();
    narrow(tolerance);
    document_.setTolerance(tolerance);
    document_.setSettings(settings);
}

// Changes of the settings, many per second during a drag, affect only the state of the result.
void ResonatorPage::refresh() {
    const RecordingSet* set = document_.sets().current();
    const bool same = (set ? document_.sets().outcome(*set) : nullptr) == shown_ &&
                      (set ? set->kept : nullptr) == kept_;
    if (same) {
        showState(set);
    } else {
        rebuild();
    }
}

void ResonatorPage::rebuild() {
    const RecordingSet* set = document_.sets().current();
    shown_ = set ? document_.sets().outcome(*set) : nullptr;
    kept_ = set ? set->kept : nullptr;
    showState(set);
    const bool from_session = !shown_ && kept_ && !kept_->fault;
    numbers_->setOutcome(from_session ? kept_ : shown_);
    figures_->setOutcome(shown_);
    comparison_->setOutcome(shown_);
    showTabs();
    emit figuresChanged();
}

void ResonatorPage::showState(const RecordingSet* set) {
    QString text = stateText(set);
    if (!set) {
        state_->setText(text);
        return;
    }
    const bool out_of_date =
        shown_ ? document_.sets().outOfDate(*set, *shown_) : kept_ && !set->kept_up_to_date;
    if (out_of_date) {
        text = QStringLiteral("<b style=\"color:%1\">⚠ %2</b> %3")
                   .arg(readable(theme().warning, theme()).name(), tr("Out of date."),
                        tr("The set or its settings have changed since: identify again.")) +
               QStringLiteral("<br>") + text;
    }
    if (const QStringList absent = absentFiles(*set); !absent.isEmpty()) {
        text +=
            QStringLiteral("<br>") + tr("⚠ Without these recordings of the measurement list: %1.")
                                         .arg(absent.join(QStringLiteral(", ")).toHtmlEscaped());
    }
    state_->setText(text);
}

QString ResonatorPage::stateText(const RecordingSet* set) const {
    if (shown_) {
        return tr("%1; %n recording(s)", nullptr, static_cast<int>(shown_->set.recordings.size()))
            .arg(fitText(shown_->identification.fit));
    }
    if (set && kept_) {
        if (kept_->fault) {
            return errorText(*kept_->fault);
        }
        QStringList names;
        for (const RecordingRef& recording : kept_->set.recordings) {
            names << QString::fromStdString(recording.name()).toHtmlEscaped();
        }
        return tr("Result of the session, identified by %1 from %2. %3. The motion of the waves, "
                  "the plots and the report need the recordings.")
            .arg(QString::fromStdString(kept_->program).toHtmlEscaped(),
                 names.join(QStringLiteral(", ")), fitText(kept_->identification.fit));
    }
    return set && document_.sets().identifying(set->id) ? tr("Being identified…")
           : document_.sets().canIdentify()
               ? tr("Nothing identified yet.")
               : tr("Open recordings of a free decay to identify the resonator.");
}

}  // namespace vybeg::ui

#include "moc_resonator_page.cpp"
