#pragma once

#include <QByteArray>
#include <QList>

#include <cmath>
#include <limits>
#include <vector>

namespace vybeg::test {

// A track CSV read by its column names.
class TrackTable {
public:
    explicit TrackTable(const QByteArray& csv) {
        for (const QByteArray& line : csv.split('\n')) {
            if (line.startsWith("# ")) {
                header_.append(line.mid(2));
            } else if (names_.isEmpty()) {
                names_ = line.split(',');
            } else if (!line.isEmpty()) {
                rows_.append(line.split(','));
            }
        }
    }

    const QList<QByteArray>& header() const { return header_; }
    qsizetype rows() const { return rows_.size(); }
    QByteArray text(qsizetype row, const char* name) const {
        return rows_[row].value(names_.indexOf(name));
    }

    std::vector<double> column(const char* name) const {
        std::vector<double> values;
        for (qsizetype row = 0; row < rows(); ++row) {
            bool is_number = false;
            const double value = text(row, name).toDouble(&is_number);
            values.push_back(is_number ? value : std::numeric_limits<double>::quiet_NaN());
        }
        return values;
    }

private:
    QList<QByteArray> header_;
    QList<QByteArray> names_;
    QList<QList<QByteArray>> rows_;
};

}  // namespace vybeg::test
