#pragma once

#include "ui/document/document.h"
#include "ui/plots/plot_view.h"

#include <cstddef>
#include <functional>
#include <memory>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace vybeg::ui {

class FileList;
class NumberField;
class QuantityTable;
class Section;
class WarningList;

// Whole-angle logs, how they are read, and the tolerances of their channels. Each change of a
// setting is a step of undo.
class DriftPanel : public QWidget {
    Q_OBJECT

public:
    explicit DriftPanel(Document& document, QWidget* parent = nullptr);

signals:
    void openWanted();

private:
    NumberField* makeNumber(const char* name);
    QComboBox* makeList(const char* name, std::size_t entries);
    void edit(const std::function<void(DriftSettings&)>& change);
    // Changes how a text file is read; a choice without any part is none.
    void editText(const std::function<void(TextChoice&)>& change);
    void editColumns();
    void showFault(const QString& sentence);
    void refreshLogs();
    void refresh();
    void retranslate();

    Document& document_;
    FileList* logs_;
    QPushButton* open_;
    QPushButton* remove_;
    QFormLayout* form_;
    QLineEdit* columns_;
    QString columns_shown_;
    QLabel* fault_;
    QComboBox* angle_unit_;
    QComboBox* time_unit_;
    QComboBox* delimiter_;
    QComboBox* decimal_;
    NumberField* skip_lines_;
    NumberField* time_column_;
    NumberField* rate_;
    NumberField* kappa_;
    NumberField* skew_;
};

// The drift of whole-angle logs: logs and settings at the left, the drift against the angle in the
// middle, harmonics and resonator at the right. While a newer drift is computed, the one before is
// shown.
class DriftPage : public MeasuredPage {
    Q_OBJECT

public:
    explicit DriftPage(Document& document, QWidget* parent = nullptr);

    FigureSource figures() const override;

signals:
    void openWanted();
    void exportResultWanted();

private:
    QWidget* buildContent();
    void refresh();
    void showFound();
    QString stateText() const;
    void showAgain() override { showFound(); }
    void retranslate() override;

    Document& document_;
    std::shared_ptr<const DriftOutcome> shown_;
    DriftPanel* panel_;
    QPushButton* export_;
    QLabel* state_;
    QLabel* hint_;
    QWidget* content_ = nullptr;
    XYPlotView* plot_ = nullptr;
    WarningList* warnings_ = nullptr;
    Section* harmonics_section_ = nullptr;
    QuantityTable* harmonics_ = nullptr;
    QLabel* agreement_ = nullptr;
    Section* resonator_section_ = nullptr;
    QuantityTable* resonator_ = nullptr;
    QLabel* statistical_ = nullptr;
};

}  // namespace vybeg::ui
