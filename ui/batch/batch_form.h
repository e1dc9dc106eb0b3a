#pragma once

#include "core/base/error.h"
#include "core/batch/batch_request.h"

#include <QWidget>

#include <array>
#include <cstddef>
#include <cstdint>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace vybeg::ui {

// What a batch reads and writes; a list or a folder is its input.
enum class BatchPath : std::uint8_t { list, folder, results, passports, database, json };

// The fields in which an engineer names the files of a batch.
class BatchForm : public QWidget {
    Q_OBJECT

public:
    explicit BatchForm(QWidget* parent = nullptr);

    // With a list or a folder goes a proposal for the results, where none are named.
    void setPath(BatchPath which, const QString& path);
    QString path(BatchPath which) const;
    // Input and results are named.
    bool isComplete() const;
    // Whether settings of the panel hold where the list has none.
    bool takesPanel() const;
    // The files, made absolute; all else is as usual.
    BatchRequest request() const;
    // The sentence of an error that ends a batch, with fields of the form in place of options.
    static QString errorText(Error error);

    static constexpr std::size_t lines = 5;

signals:
    void changed();
    // The engineer wants to choose it among files.
    void pathWanted(vybeg::ui::BatchPath which);

private:
    struct Line {
        QLabel* label = nullptr;
        QLineEdit* edit = nullptr;
        QPushButton* choose = nullptr;
    };

    QLineEdit& editOf(BatchPath which) const;
    void retranslate();

    std::array<Line, lines> lines_;
    QPushButton* folder_ = nullptr;
    QString proposed_;  // for the results, by the list
    QCheckBox* panel_ = nullptr;
};

}  // namespace vybeg::ui
