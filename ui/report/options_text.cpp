#include "ui/report/options_text.h"

#include "core/analysis/setting_table.h"

#include <QStringList>

#include <algorithm>
#include <array>
#include <string_view>

namespace vybeg::ui {

namespace {

constexpr std::array<std::string_view, 4> told_elsewhere{"algorithm", "window", "hop", "f0"};

// `listed`: of the rows that have a part, in their order, as settings_list().
template <class S>
QString textOf(const std::vector<SettingRow<S>>& rows, const std::vector<NamedValue>& listed) {
    const S defaults;
    QStringList options;
    auto value = listed.begin();
    for (const SettingRow<S>& row : rows) {
        if (!row.has_part) {
            continue;
        }
        const std::string& text = (value++)->second;
        if (text != row.text(defaults)) {
            const bool is_switch = row.placeholder.empty() && text.find(';') == std::string::npos;
            const QString option = QString::fromStdString(row.option());
            options << (is_switch ? option
                                  : option + QLatin1Char(' ') + QString::fromStdString(text));
        }
    }
    return options.join(QLatin1Char(' '));
}

}  // namespace

QString optionsText(const Settings& settings) {
    std::vector<SettingRow<Settings>> rows = analysis_settings();
    std::vector<NamedValue> listed = settings_list(settings);
    std::erase_if(rows, [](const SettingRow<Settings>& row) {
        return std::ranges::find(told_elsewhere, row.name) != told_elsewhere.end();
    });
    std::erase_if(listed, [](const NamedValue& each) {
        return std::ranges::find(told_elsewhere, each.first) != told_elsewhere.end();
    });
    return textOf(rows, listed);
}

QString optionsText(const IdentifySettings& settings) {
    return textOf(identify_settings(), settings_list(settings));
}

}  // namespace vybeg::ui
