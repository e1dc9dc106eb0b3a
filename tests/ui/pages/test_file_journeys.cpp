// From files as laboratories have them to the split in the window, counting what a person does:
// dropping, choosing, pressing. At most four actions for each kind of file.
#include "core/simulation/free_decay.h"
#include "core/simulation/simulate.h"
#include "tests/app/phasor_logs.h"
#include "tests/closeness.h"
#include "tests/core/drift/simulated_log.h"
#include "tests/data/trade_files.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/import/import_dialog.h"
#include "ui/import/log_dialog.h"
#include "ui/window/file_commands.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QtTest>

#include <cmath>
#include <complex>
#include <numbers>

namespace test_file_journeys {

using namespace vybeg;
using namespace vybeg::ui;
using test::Complex;

namespace {

constexpr double split_hz = 1;
constexpr int most_actions = 4;
constexpr int longest_ms = 60000;

FreeDecay decay() {
    FreeDecay decay;
    decay.seconds = 3;
    decay.rate_hz = test::rate_hz;
    decay.f0_hz = test::f_ref_hz - 0.1;
    decay.a_B = 0;
    decay.two_theta_A = 0.9;
    decay.split_hz = split_hz;
    decay.theta_w = 0.1;
    decay.tau_s = 30;
    decay.noise = 1e-3;
    return decay;
}

QByteArray rowOf(std::initializer_list<double> values, char delimiter = ',') {
    QByteArray row;
    for (const double value : values) {
        row += QByteArray::number(value, 'g', 16) + delimiter;
    }
    row.back() = '\n';
    return row;
}

}  // namespace

class TestFileJourneys : public QObject, private WindowTest {
    Q_OBJECT

    struct Row {
        double t;
        Complex c;
        Complex d;
    };

    std::vector<double> c_;
    std::vector<double> d_;
    std::vector<Row> phasors_;  // a log of them, without the filter's delay
    int actions_ = 0;

    void drop(const QStringList& files) {
        ++actions_;
        QVERIFY(dropFiles(*window_, files));
    }

    // Presses Open of a dialog as soon as it can be pressed.
    template <class Dialog>
    void pressOpen() {
        ++actions_;
        Dialog* dialog = nullptr;
        QTRY_VERIFY_WITH_TIMEOUT((dialog = window_->findChild<Dialog*>()), longest_ms);
        auto* button = childOf<QDialogButtonBox>(*dialog).button(QDialogButtonBox::Open);
        QTRY_VERIFY_WITH_TIMEOUT(button->isEnabled(), longest_ms);
        QTest::mouseClick(button, Qt::LeftButton);
    }

    void choose(const char* list, int entry) {
        ++actions_;
        QTRY_VERIFY_WITH_TIMEOUT(window_->findChild<LogDialog*>(), longest_ms);
        auto& box = childOf<QComboBox>(*window_->findChild<LogDialog*>(), QLatin1String(list));
        QTRY_VERIFY_WITH_TIMEOUT(box.isVisible(), longest_ms);
        box.setCurrentIndex(entry);
        emit box.activated(entry);
    }

    // By the command, once everything is open.
    void identify() {
        ++actions_;
        QTRY_VERIFY_WITH_TIMEOUT(window_->action(Command::identify)->isEnabled(), longest_ms);
        window_->action(Command::identify)->trigger();
    }

    void showsSplit() {
        const auto result = [this] {
            const RecordingSet* set = document().sets().current();
            return set ? document().sets().outcome(*set) : nullptr;
        };
        QTRY_VERIFY_WITH_TIMEOUT(result(), longest_ms);
        const Estimate& split = result()->identification.fit.resonator.split_hz;
        QVERIFY(split.given());
        VYBEG_CLOSE(split.value, split_hz, 4 * split.sd);
        VYBEG_LESS(split.sd, 0.01 * split_hz);
        VYBEG_AT_MOST(actions_, most_actions);
    }

    QString phasorTable(const QString& name) const {
        QByteArray text = "t,Xc,Yc,Xd,Yd,F (Hz)\n";
        for (const Row& row : phasors_) {
            text += rowOf(
                {row.t, row.c.real(), row.c.imag(), row.d.real(), row.d.imag(), test::f_ref_hz});
        }
        return home_.file(name, text);
    }

private slots:
    void initTestCase() {
        const auto samples = simulate(decay(), {});
        QVERIFY(samples);
        c_ = samples->c;
        d_ = samples->d;
        const test::LockIn filter{4, 100, 100};
        const std::vector<Complex> c = test::demodulated(c_, filter);
        const std::vector<Complex> d = test::demodulated(d_, filter);
        for (std::size_t k = filter.settling(); k < c.size(); ++k) {
            phasors_.push_back(
                {static_cast<double>(k) * filter.samples / test::rate_hz, c[k], d[k]});
        }
    }
    void init() {
        window_ = shownWindow();
        actions_ = 0;
    }
    void cleanup() { window_.reset(); }

    void a_file_for_each_channel() {
        const auto write = [this](const char* name, const std::vector<double>& channel) {
            QByteArray text = "t,U\n";
            for (std::size_t k = 0; k < channel.size(); ++k) {
                text += rowOf({static_cast<double>(k) / test::rate_hz, channel[k]});
            }
            return home_.file(name, text);
        };
        drop({write("run_C.csv", c_), write("run_D.csv", d_)});
        pressOpen<ImportDialog>();
        identify();
        showsSplit();
    }

    void a_text_of_lgraph() {
        const QString text = test::lgraph_text({}, {c_, d_});
        drop({home_.file("lgraph.txt", QByteArray::fromStdString(test::windows_1251(text)))});
        identify();
        showsSplit();
    }

    void a_pair_of_zetlab() {
        QStringList files;
        for (const auto& [name, channel] : {std::pair{"sig0001", &c_}, std::pair{"sig0002", &d_}}) {
            files << home_.file(QString(name) + ".ana",
                                QByteArray::fromStdString(test::zetlab_ana(*channel, 1e-6)));
            home_.file(QString(name) + ".anp", QByteArray::fromStdString(test::zetlab_anp(
                                                   test::rate_hz, 1e-6, QString(name), "V")));
        }
        drop(files);
        pressOpen<ImportDialog>();
        identify();
        showsSplit();
    }

    // The frame follows from the columns.
    void a_phasemeter_of_moku() {
        QByteArray text =
            "% Moku:Pro Phasemeter\r\n% Acquisition rate: 3.3333e+02 Hz\r\n% Time (s)";
        for (const QByteArray input : {"Input 1", "Input 2"}) {
            for (const char* column :
                 {"Set Frequency (Hz)", "Frequency (Hz)", "Phase (cyc)", "I (V)", "Q (V)"}) {
                text += ", " + input + ' ' + column;
            }
        }
        text += "\r\n";
        for (const Row& row : phasors_) {
            const double of_c = 0.3 * std::sin(0.4 * row.t);
            const double of_d = of_c + 0.11 * row.t;
            const Complex c = row.c * std::polar(1.0, -2 * test::pi * of_c);
            const Complex d = row.d * std::polar(1.0, -2 * test::pi * of_d);
            text += rowOf({row.t, test::f_ref_hz, test::f_ref_hz, of_c, c.real(), c.imag(),
                           test::f_ref_hz, test::f_ref_hz, of_d, d.real(), d.imag()});
        }
        drop({home_.file("MokuPhasemeterData.csv", text)});
        choose("y_sign", 1);
        choose("amplitude", 1);
        pressOpen<LogDialog>();
        showsSplit();
    }

    void phasors_of_any_table() {
        drop({phasorTable("lockin.csv")});
        choose("y_sign", 1);
        choose("amplitude", 1);
        pressOpen<LogDialog>();
        showsSplit();
    }

    void powers_of_a_controller() {
        QByteArray text = "t,E,R,S,Q\n";
        for (const Row& row : phasors_) {
            const Complex both = row.c * std::conj(row.d);
            const double of_c = std::norm(row.c);
            const double of_d = std::norm(row.d);
            text += rowOf({row.t, of_c + of_d, of_c - of_d, 2 * both.real(), 2 * both.imag()});
        }
        drop({home_.file("controller.csv", text)});
        pressOpen<LogDialog>();
        showsSplit();
    }

    // Dropped, its columns are numbers over time, and it is a recording: the menu takes it for a
    // log.
    void a_track_of_vybeg() {
        home_.recording("tracked.wav", decay());
        const auto made = test::run_cli(
            {"analyze", "tracked.wav", "-o", "tracked.csv", "--window", "400"}, home_.path({}));
        QCOMPARE(made.status, 0);
        actions_ += 2;  // the command and its file
        window_->files().openLogs({home_.path("tracked.csv")});
        pressOpen<LogDialog>();
        showsSplit();
    }

    // Its split is that of the quadrature effort.
    void a_log_of_a_wave_that_is_held() {
        const test::HeldLoop loop{
            .c4 = 3e-4, .s4 = -2e-4, .white = 1e-5, .effort_noise = 1e-3, .seed = 3};
        const WholeAngleLog log = test::simulated_log(loop);
        QByteArray text = "t_s,theta_rad,amplitude,quadrature\n";
        for (std::size_t k = 0; k < log.time_s.size(); ++k) {
            text += rowOf(
                {log.time_s[k], log.theta[k], log.amplitude_effort[k], log.quadrature_effort[k]});
        }
        drop({home_.file("held.csv", text)});
        QTRY_VERIFY_WITH_TIMEOUT(document().drift().outcome(), longest_ms);
        const Estimate& split = document().drift().outcome()->drift.resonator.split_hz;
        QVERIFY(split.given());
        VYBEG_CLOSE(split.value, loop.split_hz, 4 * split.uncertainty());
        VYBEG_AT_MOST(actions_, most_actions);
    }
};

VYBEG_TEST(TestFileJourneys)

}  // namespace test_file_journeys

#include "test_file_journeys.moc"
