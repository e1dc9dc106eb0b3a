#include "ui/window/commands.h"

#include "ui/widgets/theme.h"

#include <QAction>
#include <QWidget>

#include <utility>

namespace vybeg::ui {

Commands::Commands(std::vector<CommandRow> rows, QWidget* window)
    : QObject(window), rows_(std::move(rows)) {
    for (const CommandRow& row : rows_) {
        auto* action = new QAction(window);
        action->setShortcuts(row.keys);
        if (row.switched) {
            action->setCheckable(true);
            connect(action, &QAction::triggered, window, row.switched);
        } else {
            connect(action, &QAction::triggered, window, row.act);
        }
        actions_[static_cast<std::size_t>(row.id)] = action;
    }
}

void Commands::refresh() {
    for (const CommandRow& row : rows_) {
        if (row.enabled) {
            action(row.id)->setEnabled(row.enabled());
        }
        if (row.object) {
            const QString object = row.object();
            action(row.id)->setText(WindowCommands::tr(row.text) +
                                    (object.isEmpty() ? object : QStringLiteral(": ") + object));
        }
    }
}

void Commands::retranslate() {
    for (const CommandRow& row : rows_) {
        QAction& shown = *action(row.id);
        shown.setText(WindowCommands::tr(row.text));
        QString tip = row.tip != nullptr ? WindowCommands::tr(row.tip)
                                         : shown.text().remove(QLatin1Char('&'));
        if (!shown.shortcut().isEmpty()) {
            tip += QStringLiteral(" (%1)").arg(shown.shortcut().toString(QKeySequence::NativeText));
        }
        shown.setToolTip(tip);
    }
    refresh();
}

void Commands::setIcons(const QPalette& palette) {
    for (const CommandRow& row : rows_) {
        if (row.icon != nullptr) {
            action(row.id)->setIcon(themedIcon(QLatin1String(row.icon), palette));
        }
    }
}

}  // namespace vybeg::ui

#include "moc_commands.cpp"
