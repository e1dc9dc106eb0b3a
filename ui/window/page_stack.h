#pragma once

#include <QWidget>

#include <optional>

class QStackedWidget;
class QTabBar;

namespace vybeg::ui {

// The pages in the order of their tabs. All but the last are about the open recordings.
enum class Page { tracks, samples, residuals, windows, resonator, history };

// The word of a page in a session, and the page of a word; nothing for another word.
QString pageWord(Page page);
std::optional<Page> pageOfWord(const QString& word);

// The middle of the window: pages, and their tabs, which stand elsewhere. While no recording is
// open, the welcome stands in the place of those about recordings.
class PageStack : public QWidget {
    Q_OBJECT

public:
    explicit PageStack(QWidget* welcome, QWidget* parent = nullptr);

    // Adds the next page in the order of Page. `title`: a text of context "Pages".
    void add(QWidget* page, const char* title);
    void setWelcome(bool shown);
    void showPage(Page page);
    Page page() const;
    // The welcome stands in the page's place.
    bool welcomes() const;
    QTabBar* tabs() const { return tabs_; }

signals:
    void pageShown();

protected:
    void changeEvent(QEvent* event) override;

private:
    void showTab();
    void retranslate();

    QTabBar* tabs_;
    QStackedWidget* stack_;
    QList<const char*> titles_;
    bool welcome_ = true;
};

}  // namespace vybeg::ui
