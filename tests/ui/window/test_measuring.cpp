// Cursors that measure: set by key, mouse and typing, read in the table, drawn, copied.
#include "core/resonator/runs/mode_beat.h"
#include "core/track/trend.h"
#include "tests/closeness.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/panels/ledger.h"
#include "ui/plots/track_view.h"
#include "ui/window/main_window.h"
#include "ui/window/tracks_page.h"
#include "ui/words/rich_text.h"

#include <QAction>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QTest>
#include <QToolButton>
#include <qcustomplot.h>

namespace test_measuring {

using namespace vybeg;
using namespace vybeg::ui;

struct MenuText {
    static QString tr(const char* text) {
        return QCoreApplication::translate("vybeg::ui::WindowMenus", text);
    }
};

class TestMeasuring : public QObject, private WindowTest {
    Q_OBJECT

    Ledger& ledger() { return the<Ledger>(); }
    const Analysis& analysis() { return *window_->document().analyses().front().shown.analysis; }

    // Chooses by mouse where the columns read.
    void read(const char* button) {
        auto& choice = childOf<QToolButton>(ledger(), button);
        QVERIFY(choice.isEnabled());
        QTest::mouseClick(&choice, Qt::LeftButton);
    }

    // The power of ten in the head of a column: "ω_cp/2π, mHz/s", "a_A, ×10⁻³ 1/s".
    double scaleOf(SlowVariable variable) {
        const QString head =
            ledger().headerItem()->text(ledger().columnOf(variable)).section(", ", 1);
        for (const auto& [text, factor] :
             {std::pair{"×10⁻³", 1e-3}, std::pair{"×10⁻⁶", 1e-6}, std::pair{"×10⁻⁹", 1e-9},
              std::pair{"mHz", 1e-3}, std::pair{"µHz", 1e-6}, std::pair{"nHz", 1e-9}}) {
            if (head.startsWith(QString::fromUtf8(text))) {
                return factor;
            }
        }
        return 1;
    }

    QString cell(SlowVariable variable) {
        return ledger().topLevelItem(0)->text(ledger().columnOf(variable));
    }

    // "1.234 ± 0.005" or "1.234(5)" as its two numbers.
    std::pair<double, double> number(SlowVariable variable) {
        QString text = cell(variable).replace(QChar(0x2212), '-');
        const double scale = scaleOf(variable);
        const qsizetype bracket = text.indexOf('(');
        QStringList parts = text.split(QStringLiteral("±"));
        if (bracket > 0) {
            const qsizetype dot = text.indexOf('.');
            const QString digits = text.mid(bracket + 1, text.indexOf(')') - bracket - 1);
            const qsizetype decimals = dot < 0 ? 0 : bracket - dot - 1;
            parts = {text.left(bracket),
                     QString::number(digits.toDouble() * std::pow(10., -double(decimals)), 'g', 9)};
        }
        const auto value = readNumber(parts.value(0).trimmed());
        const auto sd = readNumber(parts.value(1).trimmed());
        return {scale * value.value_or(std::nan("")), scale * sd.value_or(std::nan(""))};
    }

    // A cell shows a value and its deviation, with the digits of a quantity.
    void compare(SlowVariable variable, double value, double sd) {
        const auto [shown, shown_sd] = number(variable);
        VYBEG_WITHIN(shown, value, 0.6 * sd, qPrintable(cell(variable)));
        VYBEG_CLOSE_RATIO(shown_sd, sd, 0.3, qPrintable(cell(variable)));
    }

    void setCursors(double a_s, double b_s) {
        TrackView& tracks = the<TrackView>();
        tracks.setFocus();
        tracks.setTracker(a_s);
        QTest::keyClick(&tracks, Qt::Key_1);
        tracks.setTracker(b_s);
        QTest::keyClick(&tracks, Qt::Key_2);
    }
    Trend expected(SlowVariable variable, double from_s, double to_s, TrendOf of = TrendOf::value) {
        return *line_trend(analysis().track, variable, from_s, to_s,
                           windows_apart(analysis().plan.length, analysis().plan.hop), of);
    }

private slots:
    void init() {
        window_ = shownWindow();
        window_->document().open({home_.recording("demo.wav")});
        QTRY_VERIFY(!window_->document().busy() && window_->document().analyses().size() == 1);
    }

    void keys_place_cursors_and_the_columns_read_them() {
        QVERIFY(ledger().isVisibleTo(window_.get()));
        QVERIFY(!childOf<QToolButton>(ledger(), "readDifference").isEnabled());
        setCursors(0.5, 1.5);
        QCOMPARE(fieldOf(*window_, "Time of cursor A").value(), std::optional(0.5));
        QCOMPARE(fieldOf(*window_, "Time of cursor B").value(), std::optional(1.5));
        // a_A: its values, their difference and its rate.
        const Track& track = analysis().track;
        const auto times = track.time_s();
        const auto row = [&](double time_s) {
            return static_cast<std::size_t>(
                std::ranges::min_element(times, {},
                                         [&](double t) { return std::abs(t - time_s); }) -
                times.begin());
        };
        const auto values = track.values(SlowVariable::a_A);
        constexpr SlowVariable a_A = SlowVariable::a_A;
        read("readA");
        VYBEG_WITHIN(number(a_A).first, values[row(0.5)], number(a_A).second);
        read("readB");
        VYBEG_WITHIN(number(a_A).first, values[row(1.5)], number(a_A).second);
        read("readDifference");
        VYBEG_WITHIN(number(a_A).first, values[row(1.5)] - values[row(0.5)], number(a_A).second);
        constexpr double degrees = 180 / std::numbers::pi;  // the unit of the first start
        const Trend angle = expected(SlowVariable::two_theta_A, 0.5, 1.5);
        read("readRate");
        compare(SlowVariable::two_theta_A, angle.slope_per_s * degrees,
                angle.sd_slope_per_s * degrees);
        QVERIFY(ledger().currentAnalysis() != AnalysisId::none);
        // The cell of the row says decay time and drift.
        const Trend decay = expected(a_A, 0.5, 1.5, TrendOf::logarithm);
        const auto tau = decay_time(decay);
        const QString told = ledger().topLevelItem(0)->text(Ledger::trend);
        QVERIFY2(!tau || told.contains(conciseText(tau->tau_s, tau->sd_s)), qPrintable(told));
        QVERIFY2(told.contains("°/h"), qPrintable(told));
    }

    void a_deviation_in_brackets_counts_the_last_digit() {
        QCOMPARE(conciseText(5300.00012, 0.00071), QStringLiteral("5300.0001(7)"));
        QCOMPARE(conciseText(-0.02196, 0.00012), QStringLiteral("−0.021\u202f96(12)"));
        QCOMPARE(conciseText(123.4, 1.2), QStringLiteral("123.4(12)"));
        QCOMPARE(conciseText(std::nan(""), 1), QStringLiteral("—"));
    }

    void trends_are_drawn_and_go_with_the_cursors() {
        TrackView& tracks = the<TrackView>();
        QVERIFY(tracks.content().trends.empty());
        setCursors(1.6, 0.4);  // in any order
        const std::vector<TrendCurve> curves = tracks.content().trends;
        VYBEG_AT_LEAST(curves.size(), 5);
        const Trend f = expected(SlowVariable::f, 0.4, 1.6);
        const auto drawn = std::ranges::find(curves, SlowVariable::f, &TrendCurve::variable);
        QVERIFY(drawn != curves.end());
        QCOMPARE(drawn->time_s.front(), 0.4);
        VYBEG_CLOSE(drawn->time_s.back(), 1.6, 1e-9);
        VYBEG_CLOSE(drawn->value.back(), f.at(1.6), 1e-9);
        QTest::keyClick(&tracks, Qt::Key_0);
        QVERIFY(tracks.content().trends.empty());
        QVERIFY(!childOf<QToolButton>(ledger(), "readRate").isEnabled());
        QVERIFY(ledger().readAt() == ReadAt::mouse);
    }

    // The trends know their analysis, whose row reads them.
    void readings_and_trends_say_whose_they_are() {
        setCursors(0.5, 1.5);
        const ShownAnalysis& first = window_->document().analyses().front().shown;
        QCOMPARE(ledger().topLevelItem(0)->text(Ledger::name), first.name);
        for (const TrendCurve& curve : the<TrackView>().content().trends) {
            QCOMPARE(curve.of, first.id);
        }
        window_->document().renameAnalysis(first.id, QStringLiteral("warm"));
        QTRY_COMPARE(ledger().topLevelItem(0)->text(Ledger::name), QStringLiteral("warm"));
    }

    void typed_times_place_cursors() {
        typeInto(fieldOf(*window_, "Time of cursor A"), "0,25");
        typeInto(fieldOf(*window_, "Time of cursor B"), "1.75");
        const TrackView& tracks = the<TrackView>();
        QCOMPARE(tracks.cursor(Cursor::a), std::optional(0.25));
        QCOMPARE(tracks.cursor(Cursor::b), std::optional(1.75));
        QVERIFY(!tracks.content().trends.empty());
        NumberField& b = fieldOf(*window_, "Time of cursor B");
        b.clear();
        b.commit();
        QVERIFY(!tracks.cursor(Cursor::b));
        QVERIFY(tracks.content().trends.empty());
        QVERIFY(!childOf<QToolButton>(ledger(), "readB").isEnabled());
        QVERIFY(childOf<QToolButton>(ledger(), "readA").isEnabled());
    }

    void a_dragged_cursor_measures() {
        setCursors(0.5, 1.0);
        TrackView& tracks = the<TrackView>();
        read("readRate");
        const QString before = cell(SlowVariable::f);
        const auto rect = childOf<QCustomPlot>(tracks).axisRects().front()->rect();
        const auto pixel = [&](double time_s) {
            const AxisRange shown = tracks.timeRange();
            return QPoint(
                qRound(rect.left() + (time_s - shown.lower) / shown.span() * rect.width()),
                rect.center().y());
        };
        QTest::mousePress(&tracks, Qt::LeftButton, {}, pixel(1.0));
        QTest::mouseMove(&tracks, pixel(1.5));
        QTest::mouseRelease(&tracks, Qt::LeftButton, {}, pixel(1.5));
        VYBEG_CLOSE(*tracks.cursor(Cursor::b), 1.5, 0.02);
        QTRY_VERIFY(cell(SlowVariable::f) != before);
    }

    void the_table_is_copied_with_all_digits() {
        setCursors(0.5, 1.5);
        QTest::keyClick(window_.get(), Qt::Key_T, Qt::ControlModifier | Qt::ShiftModifier);
        const QStringList lines = QGuiApplication::clipboard()->text().split('\n');
        const auto head = std::ranges::find_if(
            lines, [](const QString& line) { return line.contains("A = 0.5 s\t"); });
        QVERIFY(head != lines.end());
        const QStringList first = (head + 1)->split('\t');
        QCOMPARE(first.size(), 9);
        const Trend a_A = expected(SlowVariable::a_A, 0.5, 1.5, TrendOf::logarithm);
        const double rate = a_A.slope_per_s * std::exp(a_A.value);
        VYBEG_CLOSE_RATIO(first[7].toDouble(), rate, 1e-9);
        VYBEG_CLOSE_RATIO(first[8].toDouble(), a_A.sd_slope_per_s * std::exp(a_A.value), 1e-9);
    }

    void a_beat_is_offered() {
        auto& kind = childOf<QComboBox>(ledger(), "trend");
        QVERIFY(!kind.isVisible());
        setCursors(0.5, 1.5);
        read("readRate");
        kind.setFocus();
        QTest::keyClick(&kind, Qt::Key_End);
        QVERIFY(ledger().trendKind() == TrendKind::beat);
        for (const SlowVariable variable : main_slow_variables) {
            const QString head = ledger().headerItem()->text(ledger().columnOf(variable));
            QVERIFY2(head.endsWith("Hz"), qPrintable(head));
            const auto beat = find_beat(analysis().track, variable, 0.5, 1.5,
                                        windows_apart(analysis().plan.length, analysis().plan.hop));
            if (beat) {
                compare(variable, beat->frequency_hz, beat->sd_frequency_hz);
            } else {
                QCOMPARE(cell(variable), QStringLiteral("—"));
            }
        }
    }

    // No damped sinusoid follows a large swing; the modes of the resonator do, and say so.
    void a_large_swing_beats_as_its_modes() {
        FreeDecay decay;
        decay.seconds = 2;
        decay.rate_hz = 8000;
        decay.f0_hz = 1000;
        decay.a_B = -0.4;
        decay.two_theta_A = 0.9;
        decay.split_hz = 3;
        decay.tau_s = 3;
        decay.noise = 1e-3;
        window_->document().closeRecording(window_->document().recordings().front().id);
        window_->document().open({home_.recording("swing.wav", decay)});
        QVERIFY(idle(1));
        ledger().setTrendKind(TrendKind::beat);
        setCursors(0.2, 1.8);
        read("readRate");
        const std::size_t apart = windows_apart(analysis().plan.length, analysis().plan.hop);
        const auto modes = find_mode_beat(analysis().track, analysis().f0_hz(), 0, 0.2, 1.8, apart);
        QVERIFY(modes);
        VYBEG_WITHIN(modes->frequency_hz, decay.split_hz, 4 * modes->sd_frequency_hz);
        for (const SlowVariable variable : {SlowVariable::a_B, SlowVariable::two_theta_A}) {
            QVERIFY(!find_beat(analysis().track, variable, 0.2, 1.8, apart));
            compare(variable, modes->frequency_hz, modes->sd_frequency_hz);
        }
        for (const char* language : {"ru", "en"}) {
            window_->setLanguage(language);
            QTest::qWait(1);
            const QTreeWidgetItem& row = *ledger().topLevelItem(0);
            QVERIFY2(
                row.text(Ledger::trend).contains("a_B") && row.text(Ledger::trend).contains("2θ_A"),
                qPrintable(row.text(Ledger::trend)));
            const QString value = valueText(modes->frequency_hz, modes->sd_frequency_hz);
            QVERIFY2(row.toolTip(Ledger::trend).contains(richText(value)),
                     qPrintable(row.toolTip(Ledger::trend)));
        }
        // The curves lie on the windows.
        const auto& trends = the<TrackView>().content().trends;
        for (const SlowVariable variable : {SlowVariable::a_B, SlowVariable::two_theta_A}) {
            const auto drawn = std::ranges::find(trends, variable, &TrendCurve::variable);
            QVERIFY(drawn != trends.end());
            const DisplayScale scale = displayScale(variable, the<TrackView>().units(), 0);
            for (std::size_t k = 0; k < drawn->time_s.size(); ++k) {
                const auto values = analysis().track.values(variable);
                const std::size_t row = nearestRow(analysis().track, drawn->time_s[k]);
                const auto around = values.subspan(row - 1, 3);
                VYBEG_MORE(drawn->value[k], scale.value(std::ranges::min(around) - 0.01));
                VYBEG_LESS(drawn->value[k], scale.value(std::ranges::max(around) + 0.01));
            }
        }
    }

    // A choice of the window: plots, ledger, cursors, figures and what is copied agree.
    void the_angle_of_the_wave_is_read_on_the_chosen_branch() {
        constexpr SlowVariable angle = SlowVariable::two_theta_A;
        constexpr double degrees = 180 / std::numbers::pi;
        const auto choose = [this](const QString& text) {
            const auto actions = window_->findChildren<QAction*>();
            const auto found = std::ranges::find(actions, text, &QAction::text);
            QVERIFY(found != actions.end());
            (*found)->trigger();
        };
        setCursors(0.5, 1.5);
        read("readA");
        const auto [doubled, sd] = number(angle);
        const double stored = analysis().track.values(angle)[nearestRow(analysis().track, 0.5)];
        VYBEG_WITHIN(doubled, stored * degrees, sd);
        const auto top = [this] { return the<TrackView>().valueRange(angle).upper; };
        const double high = top();
        for (const char* language : {"ru", "en"}) {
            window_->setLanguage(language);
            QTest::qWait(1);
            choose(MenuText::tr("θ_A from 0° to 90°"));
            VYBEG_CLOSE(number(angle).first, doubled / 2, 0.6 * sd);
            VYBEG_CLOSE_RATIO(number(angle).second, sd / 2, 0.3);
            QCOMPARE(ledger().headerItem()->text(ledger().columnOf(angle)),
                     QStringLiteral("θA, °"));
            VYBEG_CLOSE_RATIO(top(), high / 2, 1e-6);
            QVERIFY(the<TracksPage>().figures().plots.contains(QStringLiteral("θA")));
            QVERIFY(the<TracksPage>().articleFigure().plots.contains(QStringLiteral("θA")));
            const QString copied = ledger().tableText();
            QVERIFY(copied.contains("\nθ_A, °\t") && !copied.contains("2θ_A"));
            // The rate of the trend is half of it, too; the drift in words is that of θ_A always.
            read("readRate");
            const Trend trend = expected(angle, 0.5, 1.5);
            compare(angle, trend.slope_per_s * degrees / 2, trend.sd_slope_per_s * degrees / 2);
            read("readA");
            choose(MenuText::tr("2θ_A"));
            QCOMPARE(number(angle).first, doubled);
        }
    }

    void a_cursor_outside_the_run_reads_nothing() {
        constexpr SlowVariable a_A = SlowVariable::a_A;
        setCursors(0.5, 1.5);
        read("readA");
        const QString inside = cell(a_A);
        typeInto(fieldOf(*window_, "Time of cursor B"), "7");  // the recording ends at 2 s
        QCOMPARE(cell(a_A), inside);
        for (const char* at : {"readB", "readDifference", "readRate"}) {
            read(at);
            QVERIFY2(std::isnan(number(a_A).first), qPrintable(cell(a_A)));
        }
        QVERIFY(ledger().topLevelItem(0)->text(Ledger::trend).contains("no windows"));
        QVERIFY(childOf<QLabel>(*window_, "cursorDifference").text().contains("no windows"));
        QVERIFY(the<TrackView>().content().trends.empty());
        QVERIFY(!ledger().tableText().contains("B = 7"));
    }

    void a_unit_that_the_file_names_stands_in_the_ledger_and_its_table() {
        QFile plain(home_.recording("plain.csv"));
        QVERIFY(plain.open(QIODevice::ReadOnly));
        const QByteArray rows = plain.readAll();
        window_->document().open(
            {home_.file("volts.csv", "t [s],C [V],D [V]\n" + rows.mid(rows.indexOf('\n') + 1))});
        QVERIFY(idle(2));
        const auto head = [this](SlowVariable variable) {
            return ledger().headerItem()->text(ledger().columnOf(variable));
        };
        // The other recording has none.
        QVERIFY2(!head(SlowVariable::a_A).endsWith('V'), qPrintable(head(SlowVariable::a_A)));
        window_->document().setAnalysisVisible(window_->document().analyses().front().shown.id,
                                               false);
        QVERIFY2(head(SlowVariable::a_A).endsWith('V'), qPrintable(head(SlowVariable::a_A)));
        QVERIFY2(head(SlowVariable::a_B).endsWith('V'), qPrintable(head(SlowVariable::a_B)));
        QVERIFY(!head(SlowVariable::two_theta_A).endsWith('V'));
        QVERIFY(ledger().tableText().contains(", V\t"));
    }

    void a_recording_tells_its_set_where_there_are_two() {
        window_->document().open({home_.recording("other.wav")});
        QVERIFY(idle(2));
        SetStore& sets = window_->document().sets();
        const auto told = [this](int row) {
            return ledger().topLevelItem(row)->toolTip(Ledger::name).contains("Set: ");
        };
        while (!sets.all().empty()) {
            sets.remove(sets.all().front().id);
        }
        sets.add({ids()[0]});
        QVERIFY(!told(0) && !told(1));
        const int narrow = ledger().columnWidth(Ledger::name);
        sets.rename(sets.add({ids()[1]}), "the other one");
        QVERIFY(!told(0) && told(1));  // the first set has the name of its recording
        QVERIFY(ledger().topLevelItem(1)->toolTip(Ledger::name).contains("the other one"));
        VYBEG_MORE(ledger().columnWidth(Ledger::name), narrow);  // it stands beside the name
        QVERIFY(!ledger().topLevelItem(1)->text(Ledger::name).contains("the other one"));
    }

    void without_a_mouse_the_first_windows_are_read() {
        const auto& first = childOf<QToolButton>(ledger(), "readMouse");
        ledger().setMouse(0.5);
        QCOMPARE(first.text(), QStringLiteral("mouse"));
        const int width = first.width();
        ledger().setMouse(std::nullopt);
        QCOMPARE(first.text(), QStringLiteral("start"));
        QCOMPARE(first.width(), width);
    }

    void a_hidden_run_is_not_measured() {
        setCursors(0.5, 1.5);
        window_->document().setAnalysisVisible(window_->document().analyses().front().shown.id,
                                               false);
        read("readA");
        QVERIFY(std::isnan(number(SlowVariable::a_A).first));
        QVERIFY(ledger().topLevelItem(0)->text(Ledger::trend).isEmpty());
        QVERIFY(the<TrackView>().content().trends.empty());
    }
};

VYBEG_TEST(TestMeasuring)

}  // namespace test_measuring

#include "test_measuring.moc"
