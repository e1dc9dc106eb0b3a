#pragma once

#include "ui/plots/plot_file.h"
#include "ui/window/commands.h"
#include "ui/window/page_stack.h"
#include "ui/words/display_units.h"

#include <functional>
#include <vector>

namespace vybeg::ui {

class BatchCommands;
class Document;
class FileCommands;
class Ledger;
class SettingsPanel;
class StatusLine;
class TrackView;

// What the commands act on; all of it lives as long as the window.
struct CommandTargets {
    Document& document;
    TrackView& tracks;
    Ledger& ledger;
    SettingsPanel& settings;
    StatusLine& status;
    FileCommands& files;
    BatchCommands& batch;
    // What the window itself does.
    std::function<void(const DisplayUnits&)> set_units;
    std::function<void(Page)> show_page;
    std::function<void(bool)> show_sidebar;
    std::function<void(bool)> show_wave;
    std::function<void(bool)> show_fitted_wave;
    std::function<Page()> page;             // that is shown
    std::function<FigureSource()> figures;  // of that page
    std::function<FigureSource()> article_figure;
    std::function<void()> show_help;
    std::function<void()> show_about;
    std::function<QString()> diagnostics;
    std::function<void()> close;
};

// The table of all commands of the window.
std::vector<CommandRow> windowCommands(const CommandTargets& to);

}  // namespace vybeg::ui
