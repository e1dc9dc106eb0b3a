#pragma once

#include <QString>

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// Files as the programs of Russian converters write them, after their layouts.
namespace vybeg::test {

// Cyrillic letters, and Latin ones as they are.
inline std::string windows_1251(const QString& text) {
    std::string bytes;
    for (const QChar letter : text) {
        const int code = letter.unicode();
        bytes += static_cast<char>(code >= 0x410 && code <= 0x44F ? code - 0x410 + 0xC0 : code);
    }
    return bytes;
}

// With a byte order mark.
inline std::string utf16(const std::string& utf8, bool big_endian) {
    std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
    for (const QChar letter : QString::fromStdString(utf8)) {
        const auto low = static_cast<char>(letter.unicode() & 0xFF);
        const auto high = static_cast<char>(letter.unicode() >> 8);
        bytes += big_endian ? std::string{high, low} : std::string{low, high};
    }
    return bytes;
}

// The text export of L-Card's LGraph2.
struct LGraphText {
    QString time_unit;         // of the markers; empty: no times
    double time_step = 0;      // in that unit
    double rate_khz = 33.333;  // as the header states it
    int decimation = 1;
    bool older = false;            // "Kadrs Number :" in place of "Number of frames:"
    std::vector<QString> names{};  // a second line of them; empty: none
};

inline QString lgraph_text(const LGraphText& layout,
                           const std::vector<std::vector<double>>& channels) {
    const auto frames = channels.front().size();
    QString text = "Oscilloscope Data File\r\nExperiment Time :   25-08-2022 21:25:32\r\n";
    text += (layout.older ? "Kadrs Number : " : "Number of frames: ") + QString::number(frames) +
            "\r\n\r\nModule: E-502 (5R385464)\r\n\r\nNumber Of Channels : " +
            QString::number(channels.size()) +
            "\r\nInput Rate In kHz: " + QString::number(layout.rate_khz, 'f', 6) +
            "\r\nInput Time In Sec: " +
            QString::number(static_cast<double>(frames) / layout.rate_khz / 1e3, 'f', 6) +
            "\r\nDecimation: " + QString::number(layout.decimation) + "\r\nData Format: Volts\r\n";
    if (!layout.time_unit.isEmpty()) {
        text += "Time markers scale: " + layout.time_unit + "\r\n";
    }
    text += "Segments: 1\r\nData as Time Sequence:\r\n               ";
    for (std::size_t k = 0; k < channels.size(); ++k) {
        text += QString("     Ch %1").arg(k + 1, 2);
    }
    text += "  \r\n";
    if (!layout.names.empty()) {
        text += "               ";
        for (const QString& name : layout.names) {
            text += "    " + name;
        }
        text += "   \r\n";
    }
    text += "\r\n";
    for (std::size_t i = 0; i < frames; ++i) {
        if (!layout.time_unit.isEmpty()) {
            text += QString("%1").arg(layout.time_step * static_cast<double>(i), 14, 'f', 8);
        }
        for (const std::vector<double>& channel : channels) {
            text += QString("%1").arg(channel[i], 14, 'f', 8);
        }
        text += "\r\n";
    }
    return text;
}

// The samples of one channel as ZETLAB stores them, in its units.
inline std::string zetlab_ana(const std::vector<double>& channel, double minlevel) {
    std::string bytes;
    for (const double sample : channel) {
        const auto bits = std::bit_cast<std::uint32_t>(static_cast<float>(sample / minlevel));
        for (int byte = 0; byte < 4; ++byte) {
            bytes += static_cast<char>(bits >> (8 * byte));
        }
    }
    return bytes;
}

inline std::string zetlab_anp(double sampling_hz, double minlevel, const QString& name,
                              std::string_view unit = "mV") {
    return windows_1251(QString("DAT 25.08.2022\r\nTIM 21:25:32\r\nFRQ %1\r\nABSVOLT %2\r\n"
                                "CONVERT %3\r\nNAME %4\r\n")
                            .arg(sampling_hz, 0, 'f', 6)
                            .arg(minlevel, 0, 'e', 9)
                            .arg(QString::fromUtf8(unit.data(), qsizetype(unit.size())), name));
}

inline std::string zetlab_xml(double sampling_hz, double minlevel, const QString& name,
                              std::string_view unit = "V") {
    return windows_1251(
        QString("<?xml version=\"1.0\" encoding=\"windows-1251\"?>\r\n<Config>\r\n <Signal "
                "name=\"%4\" frequency=\"%1\"\r\n  minlevel=\"%2\" conversion=\"%3\"/>\r\n"
                "</Config>\r\n")
            .arg(sampling_hz, 0, 'f', 6)
            .arg(minlevel, 0, 'e', 9)
            .arg(QString::fromUtf8(unit.data(), qsizetype(unit.size())), name));
}

}  // namespace vybeg::test
