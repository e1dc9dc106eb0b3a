// Scales of channels, groups and files, one after the other, and those that are refused.
#include "tests/core/recording/arrays/tdms_case.h"
#include "tests/test_registry.h"

namespace test_tdms_scales {

using namespace vybeg;
using namespace vybeg::test;

namespace {

void add_scales_by_place() {
    struct Kind {
        const char* name;
        std::function<Properties(const Tdms&)> properties;
        std::function<double(double)> value;
    };
    const std::vector<Kind> kinds{{"linear", [](const Tdms& t) { return linear(t, 0, 0.25, -1); },
                                   [](double x) { return 0.25 * x - 1; }},
                                  {"polynomial",
                                   [](const Tdms& t) {
                                       return polynomial(t, 0, {10, 1, -2, 3});
                                   },
                                   [](double x) { return 10 + x - 2 * x * x + 3 * x * x * x; }}};
    for (const Kind& kind : kinds) {
        for (const bool big_endian : {false, true}) {
            const Tdms t{big_endian};
            const Properties scale = number_of_scales(t, 1) + kind.properties(t);
            for (const bool interleave : {false, true}) {
                const auto row = [&](const char* place, const Owners& owners) {
                    add(QString("%1 scale of the %2, %3, %4")
                            .arg(kind.name, place, order_of(big_endian),
                                 interleave ? "interleaved" : "contiguous"),
                        {scaled_file(t, owners, interleave), each(raw_c, kind.value), raw_d});
                };
                row("channel", {.channel = scale});
                row("group", {.group = scale});
                row("root", {.root = scale});
            }
        }
    }
}

void add_precedence() {
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const auto by = [&](double slope) {
            return number_of_scales(t, 1) + linear(t, 0, slope, 0);
        };
        const Properties scaled{t.words("NI_Scaling_Status", "scaled")};
        const auto row = [&](const char* name, const Owners& owners, double slope) {
            add(QString("%1, %2").arg(name, order_of(big_endian)),
                {scaled_file(t, owners), each(raw_c, [=](double x) { return slope * x; }), raw_d});
        };
        row("channel before group and root", {by(2), by(3), by(5)}, 2);
        row("group before root", {{}, by(3), by(5)}, 3);
        row("a scaled channel in a group with scales", {scaled, by(3), {}}, 1);
        row("a scaled group in a file with scales", {{}, scaled, by(5)}, 1);
        row("no scales at all", {Properties{t.whole("NI_Number_Of_Scales", 0)}, {}, {}}, 1);
    }
}

void add_chains() {
    const Tdms t;
    const auto row = [&](const char* name, const Properties& scales,
                         const std::function<double(double)>& value) {
        add(name, {scaled_file(t, {.channel = scales}), each(raw_c, value), raw_d});
    };
    const auto two = number_of_scales(t, 2);
    const auto three = number_of_scales(t, 3);
    row("linear of linear", two + linear(t, 0, 2, 1) + linear(t, 1, -3, 4, 0),
        [](double x) { return -3 * (2 * x + 1) + 4; });
    row("polynomial of linear", two + linear(t, 0, 0.5, 1) + polynomial(t, 1, {1, 0, 2}, 0),
        [](double x) { return 1 + 2 * (0.5 * x + 1) * (0.5 * x + 1); });
    row("linear of polynomial", two + polynomial(t, 0, {1, 0, 2}) + linear(t, 1, 0.5, 1, 0),
        [](double x) { return 0.5 * (1 + 2 * x * x) + 1; });
    row("polynomial of polynomial of linear",
        three + linear(t, 0, 1, 1) + polynomial(t, 1, {2, 0, 1}, 0) +
            polynomial(t, 2, {1, 0, 0, 1}, 1),
        [](double x) { return 1 + std::pow(2 + (x + 1) * (x + 1), 3); });
    row("the second of three is not on the way",
        three + linear(t, 0, 2, 0) + linear(t, 1, 1e9, 0, 0) + linear(t, 2, 5, 1, 0),
        [](double x) { return 10 * x + 1; });
    row("the last of two takes the raw numbers", two + linear(t, 0, 1e9, 0) + linear(t, 1, 5, 1),
        [](double x) { return 5 * x + 1; });
    Properties bare = linear(t, 0, 3, 1);
    bare.pop_back();  // without its input source
    row("no input source", number_of_scales(t, 1) + bare, [](double x) { return 3 * x + 1; });
    row("no number of scales", linear(t, 0, 2, 1) + linear(t, 1, -3, 4, 0),
        [](double x) { return -3 * (2 * x + 1) + 4; });
    row("polynomial of four coefficients without their number",
        number_of_scales(t, 1) + polynomial(t, 0, {1, 2, 3, 4}, raw_numbers, false),
        [](double x) { return 1 + 2 * x + 3 * x * x + 4 * x * x * x; });
    row("polynomial of one coefficient", number_of_scales(t, 1) + polynomial(t, 0, {7}),
        [](double) { return 7.0; });
}

void add_refused_scales() {
    const Tdms t;
    const auto row = [&](const QString& name, const std::string& refusal,
                         const Properties& scales) {
        add(name, {scaled_file(t, {.channel = scales}), {}, {}, {}, refusal});
    };
    const auto one = number_of_scales(t, 1);
    for (const char* sensor :
         {"Table", "Thermocouple", "RTD", "Strain", "Thermistor", "Add", "Subtract"}) {
        row(QString("a %1 scale").arg(sensor), std::string("format-unsupported:") + sensor,
            one + Properties{t.words(of_scale(0, "Scale_Type"), sensor)});
        row(QString("a %1 scale before a linear one").arg(sensor),
            std::string("format-unsupported:") + sensor,
            number_of_scales(t, 2) + Properties{t.words(of_scale(0, "Scale_Type"), sensor)} +
                linear(t, 1, 2, 0, 0));
    }
    row("a scale without description", "format-unsupported:describe", one);
    row("a linear scale without slope", "format-damaged:slope",
        one + Properties{t.words(of_scale(0, "Scale_Type"), "Linear"),
                         t.real(of_scale(0, "Linear_Y_Intercept"), 1)});
    Properties polynomial_cut = polynomial(t, 0, {1, 2, 3});
    polynomial_cut.pop_back();
    row("a polynomial without its last coefficient", "format-damaged:coefficients",
        one + polynomial_cut);
    row("scales in a ring", "format-damaged:input",
        number_of_scales(t, 2) + linear(t, 0, 1, 0, 1) + linear(t, 1, 1, 0, 0));
    row("an input that does not exist", "format-damaged:input", one + linear(t, 0, 1, 0, 7));
    row("two thousand million scales", "format-damaged:number",
        number_of_scales(t, 2000000000) + linear(t, 0, 1, 0));
}

// Units of the channels and of the axis of times.
void add_units() {
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const auto file = [&](const char* unit_d, double step, const Properties& axis) {
            Properties of_c{t.real("wf_increment", step), t.words("unit_string", "V")};
            of_c.insert(of_c.end(), axis.begin(), axis.end());
            return t.segment(first_segment,
                             t.metadata({t.object(path_c, t.values(tds_i16, 8), of_c),
                                         t.object(path_d, t.values(tds_i16, 8),
                                                  {t.words("unit_string", unit_d)})}),
                             t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(raw_d));
        };
        const auto name = [&](const char* what) {
            return QString("%1, %2").arg(what, order_of(big_endian));
        };
        add(name("D in mV, C in V"), {file("mV", 1e-3, {}),
                                      raw_c,
                                      each(raw_d, [](double x) { return 1e-3 * x; }),
                                      {DiagnosticKind::unit_converted}});
        add(name("D in m/s^2, C in V"),
            {file("m/s^2", 1e-3, {}), raw_c, raw_d, {DiagnosticKind::units_differ}});
        add(name("steps in ms"), {file("V", 1, {t.words("wf_xunit_string", "ms")}), raw_c, raw_d});
        add(name("times beside the channels"),
            {t.segment(
                 first_segment,
                 t.metadata({t.object("/'Run'/'Time (ms)'", t.values(tds_i16, 8)),
                             t.object(path_c, t.values(tds_i16, 8), {t.real("wf_increment", 1e-3)}),
                             t.object(path_d, t.values(tds_i16, 8))}),
                 t.raw<std::int16_t>({0, 1, 2, 3, 4, 5, 6, 7}) + t.raw<std::int16_t>(raw_c) +
                     t.raw<std::int16_t>(raw_d)),
             raw_c, raw_d});
        add(name("steps in s"), {file("V", 1e-3, {t.words("wf_xunit_string", "s")}), raw_c, raw_d});
    }
}

}  // namespace

class TestTdmsScales : public QObject {
    Q_OBJECT

private slots:
    void a_file_is_read_as_its_layout_says_data() {
        QTest::addColumn<TdmsCase>("row");
        add_scales_by_place();
        add_precedence();
        add_chains();
        add_refused_scales();
        add_units();
    }

    void a_file_is_read_as_its_layout_says() {
        QFETCH(TdmsCase, row);
        check(folder_, row);
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestTdmsScales)

}  // namespace test_tdms_scales

#include "test_tdms_scales.moc"
