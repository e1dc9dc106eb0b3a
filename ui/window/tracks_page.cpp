#include "ui/window/tracks_page.h"

#include "core/numerics/statistics.h"
#include "ui/document/document.h"
#include "ui/plots/plot_stack.h"
#include "ui/plots/track_view.h"
#include "ui/widgets/number_field.h"
#include "ui/widgets/page_parts.h"
#include "ui/words/display_units.h"
#include "ui/words/error_text.h"
#include "ui/words/rich_text.h"
#include "ui/words/settings_text.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace vybeg::ui {

namespace {

// Of what is typed.
constexpr int input_digits = 12;

QString settingsText(const AnalysisEntry& entry) {
    const Analysis& analysis = *entry.shown.analysis;
    QString text = TracksPage::tr("%1: %2; window %3, step %4 samples; f0 = %5 Hz")
                       .arg(entry.shown.recording, algorithmText(analysis.settings.algorithm))
                       .arg(analysis.plan.length)
                       .arg(analysis.plan.hop)
                       .arg(numberLabel(analysis.f0_hz(), 3));
    if (const auto& band = analysis.settings.filter) {
        text += TracksPage::tr("; filter %1 to %2 Hz")
                    .arg(shortNumberText(band->low_hz, input_digits),
                         shortNumberText(band->high_hz, input_digits));
    }
    return text;
}

// "σ(2θ_A) = 0.011°": the standard deviation of a window in the middle of the track, which shows
// the cost of a column's length of window.
QString scatterText(const Analysis& analysis, const DisplayUnits& units) {
    constexpr SlowVariable variable = SlowVariable::two_theta_A;
    std::vector<double> sds(analysis.track.sds(variable).begin(),
                            analysis.track.sds(variable).end());
    std::erase_if(sds, [](double sd) { return !std::isfinite(sd); });
    if (sds.empty()) {
        return {};
    }
    const QString unit = displayUnit(variable, units, {});
    return QStringLiteral("σ(%1) = %2%3")
        .arg(displaySymbol(variable, units),
             shortNumberText(displayScale(variable, units, 0).sd(0, median(std::move(sds))), 2),
             unit == QStringLiteral("°") ? unit : ' ' + unit);
}

// Neither hidden nor of another unit or length.
bool isDrawn(const TrackView& tracks, const ShownAnalysis& shown) {
    const auto found = std::ranges::find(tracks.analyses(), shown.id, &ShownAnalysis::id);
    return found != tracks.analyses().end() && found->visible;
}

}  // namespace

TracksPage::TracksPage(Document& document, QWidget* parent)
    : MeasuredPage(parent),
      document_(document),
      log_tracks_(document.sets(), document.drift()),
      logs_(sentence(this, "tracks_of_logs")),
      tracks_(new TrackView(this)) {
    // Where the page is too low for all plots.
    auto* scroll = scrolled(tracks_, this);
    scroll->setFocusPolicy(Qt::NoFocus);
    fill(new QVBoxLayout(this), {}, 0, {logs_, {scroll, 1}});
    connect(&document_, &Document::analysesChanged, this, &TracksPage::showAnalyses);
    connect(&document_, &Document::liveChanged, this, &TracksPage::showAnalyses);
    connect(&log_tracks_, &LogTracks::changed, this, &TracksPage::showAnalyses);
    showAnalyses();
}

void TracksPage::showAnalyses() {
    std::vector<ShownAnalysis> analyses = document_.plottedAnalyses();
    const auto of_ledger = static_cast<std::ptrdiff_t>(analyses.size());
    std::ranges::copy(log_tracks_.shown(), std::back_inserter(analyses));
    int unlike = drawnWith(chosen_, analyses);
    // Logs, which the ledger does not name, are not missed there.
    unlike -=
        static_cast<int>(std::count_if(analyses.begin() + of_ledger, analyses.end(),
                                       [](const ShownAnalysis& log) { return !log.visible; }));
    tracks_->setAnalyses(std::move(analyses), unlike);
    nameLogs();
}

// The ledger names the analyses; logs are not in it.
void TracksPage::nameLogs() {
    QStringList names;
    for (const ShownAnalysis& log : log_tracks_.shown()) {
        if (!isDrawn(*tracks_, log)) {
            continue;
        }
        names << QStringLiteral("<span style=\"color:%1\">■</span> %2")
                     .arg(readable(log.color, theme(), log.shade).name(), log.name.toHtmlEscaped());
    }
    logs_->setText(names.isEmpty()
                       ? QString()
                       : tr("Tracks of logs: %1").arg(names.join(QStringLiteral("  "))));
    logs_->setVisible(!names.isEmpty());
}

void TracksPage::setAnalysis(AnalysisId id) {
    if (id != chosen_) {
        chosen_ = id;
        showAnalyses();
    }
    std::vector<double> crossings;
    const AnalysisEntry* entry = document_.analysis(id);
    if (entry && entry->shown.visible) {
        for (const Event& event : entry->events) {
            if (!event.flag) {
                crossings.push_back(event.time_s);
            }
        }
    }
    tracks_->setMarks(std::move(crossings));
}

void TracksPage::goToEvent(double time_s, double seconds) {
    const double span = std::max(tracks_->timeRange().span(), 3 * seconds);
    const double middle = time_s + seconds / 2;
    tracks_->setTimeRange({middle - span / 2, middle + span / 2});
    tracks_->setTracker(time_s);
}

FigureSource TracksPage::figures() const {
    PlotContent content = tracks_->content();
    content.unlike = 0;  // no note about what the window does
    FigureSource source;
    QStringList recordings;
    QStringList settings;
    for (const AnalysisEntry& entry : document_.analyses()) {
        if (isDrawn(*tracks_, entry.shown)) {
            recordings << entry.shown.recording;
            settings << settingsText(entry);
        }
    }
    for (const ShownAnalysis& log : log_tracks_.shown()) {
        if (isDrawn(*tracks_, log)) {
            recordings << log.recording;
        }
    }
    recordings.removeDuplicates();
    if (recordings.isEmpty()) {
        return source;
    }
    for (const SlowVariable variable : content.variables) {
        source.plots << indexPlain(displaySymbol(variable, content.units));
    }
    source.figure = [content](const std::vector<int>& places) {
        PlotContent some = content;
        some.variables = atPlaces(content.variables, places);
        return plotsFigure(some);
    };
    source.title = recordings.join(QStringLiteral(", "));
    source.settings = settings.join(QStringLiteral("; "));
    return source;
}

FigureSource TracksPage::articleFigure() const {
    const DisplayUnits& units = tracks_->units();
    std::vector<FigureColumn> columns;
    for (const ShownAnalysis& shown : tracks_->analyses()) {
        if (shown.visible && shown.analysis) {
            columns.push_back({QStringLiteral("n = %1, %2")
                                   .arg(shown.analysis->plan.length)
                                   .arg(scatterText(*shown.analysis, units)),
                               shown});
        }
    }
    FigureSource source;
    if (columns.empty()) {
        return source;
    }
    for (const SlowVariable variable : tracks_->shownVariables()) {
        source.plots << indexPlain(displaySymbol(variable, units));
    }
    source.figure = [columns, units,
                     variables = tracks_->shownVariables()](const std::vector<int>& places) {
        return ui::articleFigure(columns, atPlaces(variables, places), units);
    };
    const FigureSource plots = figures();
    source.title = plots.title;
    source.settings = plots.settings;
    return source;
}

void TracksPage::setUnits(const DisplayUnits& units) {
    tracks_->setUnits(units);
}

AxisLimitsDialog::AxisLimitsDialog(TrackView& tracks, SlowVariable variable, QWidget* parent)
    : QDialog(parent),
      tracks_(tracks),
      variable_(variable),
      lower_(withName(new NumberField(this), "axisLower")),
      upper_(withName(new NumberField(this), "axisUpper")),
      fault_(withName(new QLabel(this), "axisFault")) {
    setAttribute(Qt::WA_DeleteOnClose);
    const QString symbol = displaySymbol(variable, tracks.units());
    setWindowTitle(tr("Limits of the axis of %1").arg(indexPlain(symbol)));
    const auto& fixed = tracks.zoom().current().fixed;
    const auto typed = fixed.find(variable);
    const AxisRange shown = tracks.valueRange(variable);
    QStringList file_units;
    for (const ShownAnalysis& each : tracks.analyses()) {
        if (each.visible) {
            file_units << each.unit;
        }
    }
    auto* form = new QFormLayout;
    const auto add = [&](NumberField* field, const QString& label, double end) {
        constexpr int digits = 8;
        constexpr int shown_digits = 6;
        field->setOptional(true);
        field->setDigits(digits);
        field->setUnit(displayUnit(variable, tracks.units(), commonUnit(file_units)));
        field->setMinimumWidth(200);
        field->setPlaceholderText(shortNumberText(end, shown_digits));
        addRow(*form, label, field, tr("Empty: as the data are"));
        if (typed != fixed.end()) {
            field->setValue(end);
        }
        connect(field, &NumberField::valueEdited, this, &AxisLimitsDialog::check);
        connect(field, &NumberField::faultChanged, this, &AxisLimitsDialog::check);
    };
    add(lower_, tr("From"), shown.lower);
    add(upper_, tr("To"), shown.upper);
    auto* meaning = sentence(this, "axisMeaning", QMargins());
    meaning->setText(tr("Empty: as the data are. Fit and Zoom back remove the limits."));
    fault_->setWordWrap(true);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    ok_ = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        apply();
        accept();
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    fill(new QVBoxLayout(this), {form, meaning, fault_, buttons});
    check();
}

void AxisLimitsDialog::check() {
    const bool logarithmic = variable_ == SlowVariable::a_A && tracks_.units().log_a_A &&
                             tracks_.units().amplitude != AmplitudeUnit::decibels;
    const AxisRange shown = tracks_.valueRange(variable_);
    const double lower = lower_->value().value_or(shown.lower);
    const double upper = upper_->value().value_or(shown.upper);
    QString fault;
    if (!lower_->isValid() || !upper_->isValid()) {
        fault = lower_->isValid() ? upper_->fault() : lower_->fault();
    } else if (lower >= upper) {
        fault = tr("The upper end lies at or below the lower one.");
    } else if (logarithmic && lower <= 0) {
        fault = tr("A logarithmic axis begins above zero.");
    }
    fault_->setText(fault);
    ok_->setEnabled(fault.isEmpty() && lower_->isValid() && upper_->isValid());
}

void AxisLimitsDialog::apply() {
    const AxisRange shown = tracks_.valueRange(variable_);
    if (!lower_->value() && !upper_->value()) {
        tracks_.setValueRange(variable_, std::nullopt);
    } else {
        tracks_.setValueRange(variable_, AxisRange{lower_->value().value_or(shown.lower),
                                                   upper_->value().value_or(shown.upper)});
    }
}

void askForAxisLimits(TrackView& tracks, QWidget* window) {
    if (const auto variable = tracks.chosenVariable()) {
        (new AxisLimitsDialog(tracks, *variable, window))->open();
    }
}

}  // namespace vybeg::ui

#include "moc_tracks_page.cpp"
