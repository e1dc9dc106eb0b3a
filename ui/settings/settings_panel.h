#pragma once

#include "ui/settings/settings_fields.h"

#include <vector>

class QAction;
class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace vybeg::ui {

class Document;
class Section;

// The analysis panel: algorithm, window, start values, range, carrier and filter, calibration, the
// switch Live and the button that keeps an analysis. Every edit goes to the document, with undo. A
// line says where the plots are older than the settings.
class SettingsPanel : public QWidget {
    Q_OBJECT

public:
    explicit SettingsPanel(Document& document, QWidget* parent = nullptr);

    // Analyses with the values of the fields. A field with a fault gets the focus instead.
    void analyse();

    // A row with the button of a command, at the foot.
    QWidget* addTool(QAction* action);

signals:
    void visibleRangeWanted();
    // A field with a fault is to be seen.
    void wanted();

private:
    struct Group {
        Section* section;
        SettingsFields* fields;
        const char* title;
        bool folds = false;  // begins folded
    };

    void add(SettingsFields* fields, const char* title, bool open);
    void refresh();
    void showStaleness();
    void unfold();
    void fitWidth();
    void retranslate();

    Document& document_;
    QComboBox* algorithm_;
    QLabel* stale_;
    QCheckBox* live_;
    QPushButton* analyse_;
    std::vector<Group> groups_;
    QVBoxLayout* sections_;
    QScrollArea* scroll_;
    bool folded_by_person_ = false;
};

}  // namespace vybeg::ui
