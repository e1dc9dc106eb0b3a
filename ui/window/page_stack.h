#pragma once

#include <QWidget>

#include <optional>

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;
class QTabBar;

namespace vybeg::ui {

// What stands in the middle of the window while no recording is open: ways to open one.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

    // Paths of the last files, the newest first.
    void setRecent(const QStringList& paths);

signals:
    void openWanted();
    void demonstrationWanted();
    void recentChosen(const QString& path);

private:
    void retranslate();

    QLabel* text_;
    QPushButton* open_;
    QPushButton* demonstration_;
    QLabel* recent_name_;
    QListWidget* recent_;
};

// The pages in the order of their tabs. All but the last two are about the open recordings.
enum class Page { tracks, samples, residuals, windows, resonator, drift, history };

// What a page shows around itself: a page shows only what acts on it.
struct PageNeeds {
    bool sidebar = false;   // settings of the analysis
    bool ledger = false;    // recordings, analyses and what they read
    bool overview = false;  // of the current recording
    bool wave = false;      // may stand beside
};

// The word of a page in a session, and the page of a word; nothing for another word.
QString pageWord(Page page);
std::optional<Page> pageOfWord(const QString& word);

// The middle of the window: pages, and their tabs, which stand elsewhere. While no recording is
// open, the welcome stands in the place of those about recordings.
class PageStack : public QWidget {
    Q_OBJECT

public:
    explicit PageStack(QWidget* welcome, QWidget* parent = nullptr);

    // Adds the next page in the order of Page.
    void add(QWidget* page);
    void setWelcome(bool shown);
    void showPage(Page page);
    Page page() const;
    // Of the page that is shown; the welcome, which may stand in its place, needs nothing.
    PageNeeds needs() const;
    QTabBar* tabs() const { return tabs_; }

signals:
    void pageShown();

private:
    bool welcomes() const;
    void showTab();
    void retranslate();

    QTabBar* tabs_;
    QStackedWidget* stack_;
    bool welcome_ = true;
};

}  // namespace vybeg::ui
