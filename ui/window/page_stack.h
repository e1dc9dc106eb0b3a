#pragma once

#include <QWidget>

#include <optional>

class QLabel;
class QListWidget;
class QPushButton;
class QStackedWidget;
class QTabBar;

namespace vybeg::ui {

// The pages in the order of their tabs.
enum class Page { tracks, samples, residuals, windows, resonator, drift, history };

// The middle of the window in place of a page that has nothing to show: ways to open a recording,
// and the open logs and sets that have another page.
class WelcomePage : public QWidget {
    Q_OBJECT

public:
    explicit WelcomePage(QWidget* parent = nullptr);

    // Paths of the last files, the newest first.
    void setRecent(const QStringList& paths);
    // Rich text, whose links are words of pages; empty: nothing is open.
    void setOpened(const QString& text);

signals:
    void pageWanted(Page page);
    void openWanted();
    void demonstrationWanted();
    void recentChosen(const QString& path);

private:
    void retranslate();

    QLabel* opened_;
    QLabel* text_;
    QPushButton* open_;
    QPushButton* demonstration_;
    QLabel* recent_name_;
    QListWidget* recent_;
};

// What a page shows around itself: a page shows only what acts on it.
struct PageNeeds {
    bool sidebar = false;   // settings of the analysis
    bool ledger = false;    // recordings, analyses and what they read
    bool overview = false;  // of the current recording
    bool wave = false;      // may be shown beside
};

// The word of a page in a session, and the page of a word; nothing for another word.
QString pageWord(Page page);
std::optional<Page> pageOfWord(const QString& word);
// As on its tab.
QString pageTitle(Page page);

// The open data: recordings, sets that show something without them, whole-angle logs, and tracks of
// logs.
struct OpenThings {
    bool recordings = false;
    bool sets = false;
    bool angle_logs = false;
    bool tracks = false;

    friend bool operator==(const OpenThings&, const OpenThings&) = default;
};

// The middle of the window: pages, and their tabs, which are elsewhere. While no recording is
// open, the welcome replaces those about recordings, but for the tracks of logs;
// while nothing is, alone.
class PageStack : public QWidget {
    Q_OBJECT

public:
    explicit PageStack(QWidget* welcome, QWidget* parent = nullptr);

    // Adds the next page in the order of Page.
    void add(QWidget* page);
    void setOpen(const OpenThings& open);
    void showPage(Page page);
    Page page() const;
    // Of the page that is shown; without a recording the settings alone, which sets of logs have.
    PageNeeds needs() const;
    QTabBar* tabs() const { return tabs_; }

signals:
    void pageShown();

private:
    bool isEmpty() const;
    bool welcomes() const;
    void showTab();
    void retranslate();

    QTabBar* tabs_;
    QStackedWidget* stack_;
    OpenThings open_;
};

}  // namespace vybeg::ui
