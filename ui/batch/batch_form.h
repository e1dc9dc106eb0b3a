#pragma once

#include "core/batch/batch_request.h"

#include <QWidget>

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

    Line addLine(BatchPath which, const char* name, int row, int column);
    QLineEdit* editOf(BatchPath which) const;
    void retranslate();

    Line input_;
    QPushButton* folder_ = nullptr;
    Line results_;
    QString proposed_;  // for the results, by the list
    Line passports_;
    Line database_;
    Line json_;
    QCheckBox* panel_ = nullptr;
};

}  // namespace vybeg::ui
