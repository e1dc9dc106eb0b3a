// DAQmx raw data, channels of unequal length, short last segments, other values beside.
#include "tests/core/recording/arrays/tdms_case.h"
#include "tests/test_registry.h"

namespace test_tdms_layouts {

using namespace vybeg;
using namespace vybeg::test;

namespace {

// Two channels of DAQmx in one buffer, C first.
std::string daqmx_head(const Tdms& t, std::uint32_t type, std::uint32_t width, std::uint64_t count,
                       const Properties& properties = {}) {
    return t.metadata(
        {t.object("/", t.no_values()), t.object("/'Run'", t.no_values()),
         t.object(path_c, t.daqmx(count, {t.scaler(type, 0)}, {2 * width}),
                  Properties{t.real("wf_increment", 1e-3)} + properties),
         t.object(path_d, t.daqmx(count, {t.scaler(type, width)}, {2 * width}), properties)});
}

template <class Number>
void add_daqmx_type(std::uint32_t code, const char* name) {
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const Values low =
            each(raw_c, [](double x) { return std::is_signed_v<Number> ? x - 4 : x; });
        add(QString("DAQmx, %1, %2").arg(name, order_of(big_endian)),
            {t.segment(first_segment | toc_daqmx, daqmx_head(t, code, sizeof(Number), 8),
                       t.raw<Number>(interleaved(low, raw_d))),
             low, raw_d});
    }
}

void add_daqmx_layouts() {
    const Tdms t;
    constexpr std::uint32_t i8 = 1, i16 = 3, i32 = 5;
    constexpr std::uint32_t toc = first_segment | toc_daqmx;
    const std::string rows = t.raw<std::int16_t>(interleaved(raw_c, raw_d));
    const auto scaler_of = [&](const Properties& scales) {
        return t.segment(toc, daqmx_head(t, i16, 2, 8, scales), rows);
    };
    const auto doubled = [](double x) { return 2 * x + 1; };
    add("DAQmx, a scale of scaler 0", {scaler_of(number_of_scales(t, 2) + linear(t, 1, 2, 1, 0)),
                                       each(raw_c, doubled), each(raw_d, doubled)});
    const auto bent = [](double x) { return 1e-3 + 0.5 * x + 1e-6 * x * x * x; };
    add("DAQmx, a polynomial of scaler 0",
        {scaler_of(number_of_scales(t, 2) + polynomial(t, 1, {1e-3, 0.5, 0, 1e-6}, 0)),
         each(raw_c, bent), each(raw_d, bent)});
    add("DAQmx, a scale of the raw numbers",
        {scaler_of(number_of_scales(t, 1) + linear(t, 0, 2, 1)), each(raw_c, doubled),
         each(raw_d, doubled)});
    add("DAQmx, a thermocouple",
        {scaler_of(number_of_scales(t, 2) +
                   Properties{t.words(of_scale(1, "Scale_Type"), "Thermocouple"),
                              t.count(of_scale(1, "Thermocouple_Input_Source"), 0)}),
         {},
         {},
         {},
         "format-unsupported:Thermocouple"});

    const auto pair = [&](const std::string& c, const std::string& d) {
        return t.metadata(
            {t.object(path_c, c, {t.real("wf_increment", 1e-3)}), t.object(path_d, d)});
    };
    add("DAQmx, channels of different widths",
        {t.segment(toc,
                   pair(t.daqmx(2, {t.scaler(i8, 0)}, {7}), t.daqmx(2, {t.scaler(i32, 3)}, {7})),
                   std::string("\1\0\0\x21\0\0\0\2\0\0\x22\0\0\0\3\0\0\x23\0\0\0\4\0\0\x24\0\0\0"
                               "\5\0\0\x25\0\0\0\6\0\0\x26\0\0\0",
                               42)),
         {1, 2, 3, 4, 5, 6},
         {0x21, 0x22, 0x23, 0x24, 0x25, 0x26}});
    const std::string each_alone = t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(raw_d);
    add("DAQmx, a buffer for each channel",
        {t.segment(toc,
                   pair(t.daqmx(8, {t.scaler(i16, 0)}, {2, 2}),
                        t.daqmx(8, {t.scaler(i16, 0, 0, 1)}, {2, 2})),
                   each_alone),
         raw_c, raw_d});
    const Values short_d{1, 2, 3, 4, 5};
    add("DAQmx, buffers of different lengths",
        {t.segment(toc,
                   pair(t.daqmx(8, {t.scaler(i16, 0)}, {2, 2}),
                        t.daqmx(5, {t.scaler(i16, 0, 0, 1)}, {2, 2})),
                   t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(short_d)),
         part(raw_c, 0, 5),
         short_d,
         {DiagnosticKind::channels_unequal}});
    // Both numbers of a row belong to both channels; the scale says which one is meant.
    const std::vector<std::string> both{t.scaler(i16, 0, 0), t.scaler(i16, 2, 1)};
    const auto takes = [&](std::uint32_t scaler) {
        return number_of_scales(t, 3) + linear(t, 2, 1, 0, scaler);
    };
    add("DAQmx, one of two scalers",
        {t.segment(toc,
                   t.metadata({t.object(path_c, t.daqmx(8, both, {4}),
                                        Properties{t.real("wf_increment", 1e-3)} + takes(1)),
                               t.object(path_d, t.daqmx(8, both, {4}), takes(0))}),
                   rows),
         raw_d, raw_c});
    add("DAQmx, two scalers and no scale",
        {t.segment(toc, pair(t.daqmx(8, both, {4}), t.daqmx(8, both, {4})), rows),
         {},
         {},
         {},
         "format-unsupported:describe"});
    add("DAQmx, the type of the values told twice",
        {t.segment(toc,
                   pair(t.daqmx(8, {t.scaler(i16, 0)}, {4}, 0x1269, tds_i16),
                        t.daqmx(8, {t.scaler(i16, 2)}, {4}, 0x1269, tds_i16)),
                   rows),
         raw_c, raw_d});
    for (const std::uint32_t kind : {0x126Au, 0x1369u}) {
        const auto lines = t.object("/'Run'/'Lines'", t.daqmx(8, {t.line(0, 32)}, {5}, kind));
        std::string with_lines;
        for (std::size_t i = 0; i < 8; ++i) {
            with_lines += t.raw<std::int16_t>({raw_c[i], raw_d[i]}) + "\1";
        }
        add(QString("DAQmx, digital lines (%1) beside").arg(kind, 0, 16),
            {t.segment(toc,
                       t.metadata({lines,
                                   t.object(path_c, t.daqmx(8, {t.scaler(i16, 0)}, {5}),
                                            {t.real("wf_increment", 1e-3)}),
                                   t.object(path_d, t.daqmx(8, {t.scaler(i16, 2)}, {5}))}),
                       with_lines),
             raw_c, raw_d});
    }
    const std::string head = daqmx_head(t, i16, 2, 8);
    const Values c_twice = interleaved(raw_c, raw_c), d_twice = interleaved(raw_d, raw_d);
    add("DAQmx, two chunks", {t.segment(toc, head, rows + rows),
                              [&] {
                                  Values v = raw_c;
                                  v.insert(v.end(), raw_c.begin(), raw_c.end());
                                  return v;
                              }(),
                              [&] {
                                  Values v = raw_d;
                                  v.insert(v.end(), raw_d.begin(), raw_d.end());
                                  return v;
                              }()});
    add("DAQmx, two segments",
        {t.segment(toc, head, rows) + t.segment(toc_raw | toc_daqmx, "", rows.substr(0, 20)),
         [&] {
             Values v = raw_c;
             v.insert(v.end(), raw_c.begin(), raw_c.begin() + 5);
             return v;
         }(),
         [&] {
             Values v = raw_d;
             v.insert(v.end(), raw_d.begin(), raw_d.begin() + 5);
             return v;
         }()});
    add("DAQmx, a last chunk of six rows",
        {t.segment(toc, head, rows.substr(0, 24)), part(raw_c, 0, 6), part(raw_d, 0, 6)});
    add("DAQmx, never closed",
        {t.lead_in(toc, ~std::uint64_t{0}, head.size()) + head + rows.substr(0, 26),
         part(raw_c, 0, 6),
         part(raw_d, 0, 6),
         {DiagnosticKind::file_not_closed}});
    add("DAQmx, rows of different widths",
        {t.segment(toc,
                   pair(t.daqmx(8, {t.scaler(i16, 0)}, {4}), t.daqmx(8, {t.scaler(i16, 2)}, {5})),
                   rows),
         {},
         {},
         {},
         "format-damaged:width"});
    add("DAQmx, a number beyond its row",
        {t.segment(toc,
                   pair(t.daqmx(8, {t.scaler(i16, 0)}, {4}), t.daqmx(8, {t.scaler(i16, 3)}, {4})),
                   rows),
         {},
         {},
         {},
         "format-damaged:index"});
    add("DAQmx beside other channels",
        {t.segment(toc, pair(t.daqmx(8, {t.scaler(i16, 0)}, {4}), t.values(tds_i16, 8)), rows),
         {},
         {},
         {},
         "format-unsupported:DAQmx"});
    add("DAQmx without any description",
        {t.segment(toc, pair(t.values(tds_i16, 8), t.values(tds_i16, 8)), rows),
         {},
         {},
         {},
         "format-unsupported:DAQmx"});
    add("DAQmx, an index that is cut",
        {t.segment(
             toc, t.metadata({t.object(path_c, t.daqmx(8, {t.scaler(i16, 0)}, {4}).substr(0, 40))}),
             rows),
         {},
         {},
         {},
         "format-damaged:index"});
}

void add_unequal_lengths() {
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const auto name = [&](const char* what) {
            return QString("%1, %2").arg(what, order_of(big_endian));
        };
        const auto head = [&](std::uint64_t c, std::uint64_t d) {
            return t.metadata(
                {t.object(path_c, t.values(tds_i16, c), {t.real("wf_increment", 1e-3)}),
                 t.object(path_d, t.values(tds_f64, d))});
        };
        const auto raw = [&](std::size_t c, std::size_t d) {
            return t.raw<std::int16_t>(part(raw_c, 0, c)) + t.raw<double>(part(raw_d, 0, d));
        };
        const std::vector<DiagnosticKind> unequal{DiagnosticKind::channels_unequal};
        add(name("C is longer"), {t.segment(first_segment, head(8, 6), raw(8, 6)),
                                  part(raw_c, 0, 6), part(raw_d, 0, 6), unequal});
        add(name("D is longer"), {t.segment(first_segment, head(5, 8), raw(5, 8)),
                                  part(raw_c, 0, 5), part(raw_d, 0, 5), unequal});
        add(name("D goes on in a segment of its own"),
            {t.segment(first_segment, head(6, 6), raw(6, 6)) +
                 t.segment(first_segment, t.metadata({t.object(path_d, t.values(tds_f64, 2))}),
                           t.raw<double>({1, 2})),
             part(raw_c, 0, 6), part(raw_d, 0, 6), unequal});
        add(name("D begins in the second segment"),
            {t.segment(first_segment,
                       t.metadata({t.object(path_c, t.values(tds_i16, 3),
                                            {t.real("wf_increment", 1e-3)})}),
                       t.raw<std::int16_t>({1, 2, 3})) +
                 t.segment(first_segment, head(5, 8), raw(5, 8)),
             {1, 2, 3, 0, 1, 2, 3, 4},
             raw_d,
             {}});
        add(name("lengths by turns that come out equal"),
            {t.segment(first_segment, head(8, 4), raw(8, 4)) +
                 t.segment(first_segment, head(4, 8), raw(4, 8)),
             {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3},
             {100, 90, 80, 70, 100, 90, 80, 70, 60, 50, 40, 30}});
    }
}

void add_short_last_segments() {
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const auto name = [&](const char* what) {
            return QString("a closed segment that is short: %1, %2")
                .arg(what, order_of(big_endian));
        };
        const auto head = [&](std::uint32_t type_c, std::uint64_t c, std::uint32_t type_d,
                              std::uint64_t d) {
            return t.metadata(
                {t.object(path_c, t.values(type_c, c), {t.real("wf_increment", 1e-3)}),
                 t.object(path_d, t.values(type_d, d))});
        };
        const std::string whole = t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(raw_d);
        const std::string six =
            t.raw<std::int16_t>(part(raw_c, 0, 6)) + t.raw<std::int16_t>(part(raw_d, 0, 6));
        // Six of eight values of both, one channel after the other.
        add(name("the only chunk"), {t.segment(first_segment, head(tds_i16, 8, tds_i16, 8), six),
                                     part(raw_c, 0, 6), part(raw_d, 0, 6)});
        add(name("after a whole chunk"),
            {t.segment(first_segment, head(tds_i16, 8, tds_i16, 8), whole + six),
             {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5},
             {100, 90, 80, 70, 60, 50, 40, 30, 100, 90, 80, 70, 60, 50}});
        add(name("a segment as the one before"),
            {t.segment(first_segment, head(tds_i16, 8, tds_i16, 8), whole) +
                 t.segment(toc_raw, "", six),
             {0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5},
             {100, 90, 80, 70, 60, 50, 40, 30, 100, 90, 80, 70, 60, 50}});
        add(name("numbers of different widths"),
            {t.segment(first_segment, head(tds_i16, 8, tds_f64, 8),
                       t.raw<std::int16_t>(part(raw_c, 0, 6)) + t.raw<double>(part(raw_d, 0, 6))),
             part(raw_c, 0, 6), part(raw_d, 0, 6)});
        add(name("seven of eight, a byte over"),
            {t.segment(first_segment, head(tds_i16, 8, tds_i16, 8),
                       t.raw<std::int16_t>(part(raw_c, 0, 7)) +
                           t.raw<std::int16_t>(part(raw_d, 0, 7)) + "x"),
             part(raw_c, 0, 7), part(raw_d, 0, 7)});
        add(name("interleaved"),
            {t.segment(first_segment | toc_interleaved, head(tds_i16, 8, tds_i16, 8),
                       t.raw<std::int16_t>(interleaved(part(raw_c, 0, 6), part(raw_d, 0, 6)))),
             part(raw_c, 0, 6), part(raw_d, 0, 6)});
        // Not shared out: the file is cut, and its header says how much there was.
        const std::string cut_head = head(tds_i16, 8, tds_i16, 8);
        add(name("cut, not short"),
            {t.lead_in(first_segment, cut_head.size() + whole.size(), cut_head.size()) + cut_head +
                 whole.substr(0, 28),
             part(raw_c, 0, 6),
             part(raw_d, 0, 6),
             {DiagnosticKind::file_ends_early}});
    }
}

void add_other_values() {
    for (const bool big_endian : {false, true}) {
        const Tdms t{big_endian};
        const auto name = [&](const char* what) {
            return QString("%1, %2").arg(what, order_of(big_endian));
        };
        const auto beside = [&](const std::string& other) {
            return t.metadata(
                {t.object(path_c, t.values(tds_i16, 8), {t.real("wf_increment", 1e-3)}), other,
                 t.object(path_d, t.values(tds_i16, 8))});
        };
        const std::string texts = t.number(std::uint32_t{3}) + t.number(std::uint32_t{5}) + "abcde";
        const std::string c = t.raw<std::int16_t>(raw_c), d = t.raw<std::int16_t>(raw_d);
        add(name("texts between"),
            {t.segment(first_segment, beside(t.object("/'Run'/'Note'", t.strings(2, 13))),
                       c + texts + d),
             raw_c, raw_d});
        add(name("times between"),
            {t.segment(first_segment, beside(t.object("/'Run'/'Stamp'", t.values(tds_time, 3))),
                       c + std::string(48, '\7') + d),
             raw_c, raw_d});
        std::string rows;
        for (std::size_t i = 0; i < 8; ++i) {
            rows += t.raw<std::int16_t>({raw_c[i]}) + std::string(16, '\7') +
                    t.raw<std::int16_t>({raw_d[i]});
        }
        add(name("times in each row"),
            {t.segment(first_segment | toc_interleaved,
                       beside(t.object("/'Run'/'Stamp'", t.values(tds_time, 8))), rows),
             raw_c, raw_d});
        add(name("texts before a last chunk that is short"),
            {t.segment(first_segment, beside(t.object("/'Run'/'Note'", t.strings(2, 13))),
                       c + texts + d + c.substr(0, 12) + texts + d.substr(0, 12)),
             raw_c,
             raw_d,
             {DiagnosticKind::file_ends_early}});
    }
}

}  // namespace

class TestTdmsLayouts : public QObject {
    Q_OBJECT

private slots:
    void a_file_is_read_as_its_layout_says_data() {
        QTest::addColumn<TdmsCase>("row");
        add_daqmx_type<std::uint8_t>(0, "8 bit unsigned");
        add_daqmx_type<std::int8_t>(1, "8 bit");
        add_daqmx_type<std::uint16_t>(2, "16 bit unsigned");
        add_daqmx_type<std::int16_t>(3, "16 bit");
        add_daqmx_type<std::uint32_t>(4, "32 bit unsigned");
        add_daqmx_type<std::int32_t>(5, "32 bit");
        add_daqmx_type<std::uint64_t>(6, "64 bit unsigned");
        add_daqmx_type<std::int64_t>(7, "64 bit");
        add_daqmx_type<float>(8, "32 bit float");
        add_daqmx_type<double>(9, "64 bit float");
        add_daqmx_layouts();
        add_unequal_lengths();
        add_short_last_segments();
        add_other_values();
    }

    void a_file_is_read_as_its_layout_says() {
        QFETCH(TdmsCase, row);
        check(folder_, row);
    }

    void unequal_lengths_are_said_with_names_and_numbers() {
        const Tdms t;
        const Recording recording = opened(folder_.write(
            "unequal.tdms",
            t.segment(
                first_segment,
                t.metadata({t.object(path_c, t.values(tds_i16, 8), {t.real("wf_increment", 1)}),
                            t.object(path_d, t.values(tds_i16, 6))}),
                t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(part(raw_d, 0, 6)))));
        const Diagnostic* unequal = find(recording, DiagnosticKind::channels_unequal);
        QVERIFY(unequal);
        QCOMPARE(unequal->args, (std::vector<MessageArg>{"C", "8", "D", "6"}));
    }

    void names_units_and_starts_are_plain_text() {
        const Tdms t;
        const std::string escape = "\x1b[31m";
        const Recording recording = opened(folder_.write(
            "escapes.tdms",
            t.segment(
                first_segment,
                t.metadata({t.object("/'Run'/'C" + escape + "'", t.values(tds_i16, 8),
                                     {t.real("wf_increment", 1), t.words("unit_string", "V\n")}),
                            t.object("/'Run'/'" + std::string("D\xE2\x80\xAE") + "'",
                                     t.values(tds_i16, 8))}),
                t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(raw_d))));
        QCOMPARE(recording.channels[0], (Channel{"C\\x1b[31m", "V\\x0a"}));
        QCOMPARE(recording.channels[1].name, std::string("D\\u202e"));
    }

private:
    Folder folder_;
};

VYBEG_TEST(TestTdmsLayouts)

}  // namespace test_tdms_layouts

#include "test_tdms_layouts.moc"
