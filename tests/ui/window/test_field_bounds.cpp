// Every field for a number takes what core takes, and refuses what core refuses: at its bounds,
// just inside and just outside.
#include "core/analysis/setting_table.h"
#include "core/base/number_text.h"
#include "core/recording/samples/open_table.h"
#include "tests/test_registry.h"
#include "tests/ui/gui_test.h"
#include "ui/import/import_fields.h"
#include "ui/settings/settings_groups.h"

#include <QComboBox>
#include <QSpinBox>
#include <QTest>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace test_field_bounds {

using namespace vybeg;
using namespace vybeg::ui;

namespace {

constexpr double tiny = std::numeric_limits<double>::min();
constexpr double huge = std::numeric_limits<double>::max();

// Numbers about the bounds, in units of core.
std::vector<double> about(const Bounds& bounds, bool whole) {
    std::vector<double> numbers;
    for (const double bound : {bounds.least, bounds.most}) {
        const double step = whole ? 1 : bound == 0 ? 1e-9 : 1e-6 * std::abs(bound);
        if (std::abs(bound) == huge) {
            continue;  // there is nothing beyond
        }
        if (bound == tiny) {
            numbers.insert(numbers.end(), {0, 1e-300, -1});
            continue;
        }
        numbers.insert(numbers.end(), {bound - step, bound, bound + step});
    }
    return numbers;
}

QString typed(double number, bool whole) {
    return whole ? QString::number(static_cast<qint64>(number))
                 : QString::fromStdString(round_trip_text(number));
}

bool takes(NumberField& field, const QString& text) {
    field.setText(text);
    return field.isValid();
}

// A field of the panel for a number of an option.
struct Case {
    const char* field;  // accessible name
    const char* option;
    std::size_t number = 0;    // in the option's value
    double unit = 1;           // units of core that are one of the field
    const char* value = "%1";  // of the option, with the number
    bool whole = false;
};

// What core says of an option's value.
bool coreTakes(const Case& at, double number) {
    const auto& rows = analysis_settings();
    const auto row = std::ranges::find(rows, std::string(at.option), &SettingRow<Settings>::name);
    Settings settings;
    const std::string text = QString(at.value).arg(typed(number, at.whole)).toStdString();
    return row->read(text, settings) && validate(settings);
}

bool coreTakesTolerance(const char* name, double number) {
    return bool(read_tolerance(std::string(name) + "=" + round_trip_text(number)));
}

}  // namespace

class TestFieldBounds : public QObject {
    Q_OBJECT

    // Compares the fields of a group with core; none of them may be forgotten.
    void compare(QWidget& group, const std::vector<Case>& cases, int others = 0) {
        QCOMPARE(group.findChildren<NumberField*>().size(),
                 static_cast<qsizetype>(cases.size()) + others);
        int refused = 0;
        for (const Case& at : cases) {
            NumberField& field = fieldOf(group, at.field);
            for (const double number : about(bounds_of(at.option, at.number), at.whole)) {
                const QString text = typed(number / at.unit, at.whole);
                const bool taken = takes(field, text);
                refused += taken ? 0 : 1;
                QVERIFY2(taken == coreTakes(at, number),
                         qPrintable(QString("%1: %2").arg(at.field, text)));
            }
        }
        QVERIFY(refused > 0);
    }

private slots:
    void those_of_the_range() {
        RangeFields fields;
        compare(fields, {{"Range from", "from"}, {"Range to", "to"}});
    }

    void those_of_the_carrier() {
        CarrierFields fields;
        compare(fields,
                {{"Carrier f₀", "f0"},
                 {"Search from", "band", 0, 1, "%1,1e300"},
                 {"Search to", "band", 1, 1, "-0,%1"},
                 {"Filter from", "filter", 0, 1, "%1,1e300"},
                 {"Filter to", "filter", 1, 1, "-0,%1"}},
                0);
    }

    void those_of_the_calibration() {
        CalibrationFields fields;
        compare(fields,
                {{"Gain ratio κ", "kappa"},
                 {"Offset of C", "offset", 0, 1, "%1,0"},
                 {"Offset of D", "offset", 1, 1, "0,%1"},
                 {"Delay of D", "delay", 0, 1e-6},
                 {"Angle zero", "angle-zero"}},
                8);
        for (const auto& [field, name, unit] :
             {std::tuple{"Tolerance of the gain ratio", "kappa", 1.0},
              std::tuple{"Tolerance of the non-orthogonality", "skew", 1.0},
              std::tuple{"Tolerance of the delay", "delay", 1e-9},
              std::tuple{"Tolerance of the crosstalk", "crosstalk", 1.0},
              std::tuple{"Tolerance of the phase drift", "phase-drift", 1.0},
              std::tuple{"Tolerance of the gain drift", "gain-drift", 1.0},
              std::tuple{"Tolerance of the sample rate", "rate", 1.0},
              std::tuple{"Tolerance of the spread between recordings", "spread", 1.0}}) {
            for (const double number : {-1e-9, 0.0, 1e-12, 0.5, 2.0, 100.0}) {
                QVERIFY2(takes(fieldOf(fields, field), typed(number / unit, false)) ==
                             coreTakesTolerance(name, number),
                         field);
            }
        }
    }

    void those_of_the_window() {
        WindowFields fields;
        SettingsState state;
        state.rate_hz = 20000;
        state.f0_hz = 5000;
        fields.setState(state);
        compare(fields, {{"Length", "window", 0, 1, "%1", true}, {"Step", "hop", 0, 1, "%1", true}},
                1);
        auto& unit = childOf<QComboBox>(fields, QStringLiteral("lengthUnit"));
        unit.setCurrentIndex(1);
        emit unit.activated(1);
        compare(fields, {{"Length", "periods"}}, 2);
        unit.setCurrentIndex(2);
        emit unit.activated(2);
        // The others are of the same window: what they take, core takes.
        Settings last;
        connect(&fields, &SettingsFields::edited, this,
                [&last](const Settings& settings) { last = settings; });
        for (const char* text : {"0", "0.2", "0.2499", "0.25", "0.26", "5e10", "6e13"}) {
            NumberField& field = fieldOf(fields, "Length");
            field.setText(text);
            field.setModified(true);
            const bool taken = field.isValid();
            last = {};
            field.commit();
            QVERIFY2(bool(validate(last)), text);
            QCOMPARE(taken, QString(text).toDouble() >= 0.25 && QString(text).toDouble() <= 5e13);
        }
        for (const char* text : {"0", "50", "99.999"}) {
            NumberField& field = fieldOf(fields, "Overlap");
            field.setText(text);
            field.setModified(true);
            field.commit();
            QVERIFY2(bool(validate(last)), text);
        }
    }

    void those_of_the_start_values() {
        StartFields fields;
        compare(fields, {{"a_A", "initial", 0, 1, "%1,0,0,0,5300"},
                         {"a_B", "initial", 1, 1, "1,%1,0,0,5300"},
                         {"2θ_A", "initial", 2, 1, "1,0,%1,0,5300"},
                         {"α", "initial", 3, 1, "1,0,0,%1,5300"},
                         {"f", "initial", 4, 1, "1,0,0,0,%1"}});
    }

    void those_of_the_import() {
        ImportFields fields;
        const auto core_takes = [](bool raw, const std::string& option, double number, bool whole) {
            OpenOptions options;
            if (raw) {
                options.raw = RawLayout{};
            }
            for (const SettingRow<OpenOptions>& row : open_settings()) {
                if (row.name == option && !row.read(typed(number, whole).toStdString(), options)) {
                    return false;
                }
            }
            return bool(check_options(options));
        };
        for (const auto& [name, option, raw, whole] :
             {std::tuple{"rate", "rate", false, false}, std::tuple{"scale", "scale", false, false},
              std::tuple{"skip_lines", "skip-lines", false, true},
              std::tuple{"raw_skip", "skip", true, true}}) {
            auto& field = childOf<NumberField>(fields, QString::fromLatin1(name));
            for (const double number : about(bounds_in(open_settings(), option), whole)) {
                QVERIFY2(
                    takes(field, typed(number, whole)) == core_takes(raw, option, number, whole),
                    qPrintable(QString("%1: %2").arg(name).arg(number)));
            }
        }
        QCOMPARE(fields.findChildren<NumberField*>().size(), 4);
        for (const double scale : {0.0, -1.0, 1e-300}) {
            const OpenOptions options{.scale = scale};
            fields.setOptions(options);
            QCOMPARE(fields.isValid(), bool(check_options(options)));
        }
        const auto& channels = childOf<QSpinBox>(fields, QStringLiteral("raw_channels"));
        for (const int number : {channels.minimum() - 1, channels.minimum(), channels.maximum(),
                                 channels.maximum() + 1}) {
            QCOMPARE(core_takes(true, "raw-channels", number, true),
                     number >= channels.minimum() && number <= channels.maximum());
        }
    }
};

VYBEG_TEST(TestFieldBounds)

}  // namespace test_field_bounds

#include "test_field_bounds.moc"
