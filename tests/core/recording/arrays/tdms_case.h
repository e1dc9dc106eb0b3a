#pragma once

#include "tests/core/recording/arrays/tdms_file.h"
#include "tests/core/recording/recording_files.h"

#include <functional>

// Files after the published layout of TDMS, each with the samples that it stands for.
namespace vybeg::test {

using Properties = std::vector<std::string>;
using Values = std::vector<double>;

struct TdmsCase {
    std::string bytes;
    Values c;
    Values d;
    std::vector<DiagnosticKind> diagnostics{};
    std::string refusal{};  // code: a word of the sentence; empty: the file is read
};

inline const Values raw_c{0, 1, 2, 3, 4, 5, 6, 7};
inline const Values raw_d{100, 90, 80, 70, 60, 50, 40, 30};

inline Values each(const Values& x, const std::function<double(double)>& f) {
    Values y;
    for (const double value : x) {
        y.push_back(f(value));
    }
    return y;
}

inline std::string of_scale(int index, const std::string& rest) {
    return "NI_Scale[" + std::to_string(index) + "]_" + rest;
}

inline constexpr std::uint32_t raw_numbers = 0xFFFFFFFF;

inline Properties linear(const Tdms& t, int index, double slope, double intercept,
                         std::uint32_t input = raw_numbers) {
    return {t.words(of_scale(index, "Scale_Type"), "Linear"),
            t.real(of_scale(index, "Linear_Slope"), slope),
            t.real(of_scale(index, "Linear_Y_Intercept"), intercept),
            t.count(of_scale(index, "Linear_Input_Source"), input)};
}

inline Properties polynomial(const Tdms& t, int index, const Values& coefficients,
                             std::uint32_t input = raw_numbers, bool with_size = true) {
    Properties all{t.words(of_scale(index, "Scale_Type"), "Polynomial"),
                   t.count(of_scale(index, "Polynomial_Input_Source"), input)};
    if (with_size) {
        all.push_back(t.count(of_scale(index, "Polynomial_Coefficients_Size"),
                              static_cast<std::uint32_t>(coefficients.size())));
    }
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        all.push_back(t.real(of_scale(index, "Polynomial_Coefficients[" + std::to_string(i) + "]"),
                             coefficients[i]));
    }
    return all;
}

inline Properties number_of_scales(const Tdms& t, int count) {
    return {t.words("NI_Scaling_Status", "unscaled"), t.whole("NI_Number_Of_Scales", count)};
}

inline Properties operator+(Properties a, const Properties& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

struct Owners {
    Properties channel{};
    Properties group{};
    Properties root{};
};

// C with the properties, in a group and a file with theirs; D without any. One chunk of raw_c and
// raw_d as 16 bit integers.
inline std::string scaled_file(const Tdms& t, const Owners& owners, bool interleave = false) {
    const std::string metadata = t.metadata(
        {t.object("/", t.no_values(), owners.root), t.object("/'Run'", t.no_values(), owners.group),
         t.object(path_c, t.values(tds_i16, 8),
                  Properties{t.real("wf_increment", 1e-3)} + owners.channel),
         t.object(path_d, t.values(tds_i16, 8), {t.words("NI_Scaling_Status", "scaled")})});
    const std::string raw = interleave ? t.raw<std::int16_t>(interleaved(raw_c, raw_d))
                                       : t.raw<std::int16_t>(raw_c) + t.raw<std::int16_t>(raw_d);
    return t.segment(first_segment | (interleave ? toc_interleaved : 0), metadata, raw);
}

inline const char* order_of(bool big_endian) {
    return big_endian ? "big endian" : "little endian";
}

inline void add(const QString& name, const TdmsCase& row) {
    QTest::newRow(qPrintable(name)) << row;
}

inline QString list_text(const Values& values) {
    QStringList texts;
    for (const double value : values) {
        texts << QString::number(value, 'g', 17);
    }
    return texts.join(' ');
}

// Within a few units of the last place of the largest value: scales may be folded into one.
inline bool near(const Values& a, const Values& b) {
    double largest = 0;
    for (const double value : b) {
        largest = std::max(largest, std::abs(value));
    }
    return worst_difference(a, b) <= 4e-15 * largest;
}

// Opens the file of a row and compares what comes out.
inline void check(const Folder& folder, const TdmsCase& row) {
    const auto recording = open(folder.write("run.tdms", row.bytes));
    if (!row.refusal.empty()) {
        const std::size_t colon = row.refusal.find(':');
        QVERIFY2(!recording, "The file was read.");
        const std::string sentence = english(recording.error());
        QVERIFY2(code_name(recording.error().code) == row.refusal.substr(0, colon),
                 sentence.c_str());
        QVERIFY2(sentence.find(row.refusal.substr(colon + 1)) != sentence.npos, sentence.c_str());
        return;
    }
    QVERIFY2(recording, recording ? "" : english(recording.error()).c_str());
    const Samples read = read_all(*recording);
    QVERIFY2(near(read.c, row.c), qPrintable(list_text(read.c) + " is not " + list_text(row.c)));
    QVERIFY2(near(read.d, row.d), qPrintable(list_text(read.d) + " is not " + list_text(row.d)));
    std::vector<DiagnosticKind> kinds;
    QString told;
    for (const Diagnostic& diagnostic : recording->diagnostics) {
        kinds.push_back(diagnostic.kind);
        told += QString::fromStdString(english(diagnostic)) + '\n';
    }
    QVERIFY2(kinds == row.diagnostics, qPrintable(told));
    QCOMPARE(recording->rate_hz, 1000.0);
    QVERIFY(same_however_cut(*recording->source, 3));
}

}  // namespace vybeg::test

Q_DECLARE_METATYPE(vybeg::test::TdmsCase)
