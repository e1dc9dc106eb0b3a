#include "ui/report/options_text.h"

#include "core/analysis/setting_table.h"

#include <QStringList>

#include <algorithm>
#include <initializer_list>
#include <string_view>

namespace vybeg::ui {

namespace {

// `listed`: as settings_list().
template <class S>
QString rowsText(const std::vector<SettingRow<S>>& rows, const std::vector<NamedValue>& listed,
                 std::initializer_list<std::string_view> left_out = {}) {
    const S defaults;
    QStringList options;
    for (const SettingRow<S>& row : rows) {
        const auto value = std::ranges::find(listed, row.name, &NamedValue::first);
        if (value == listed.end()) {
            continue;
        }
        const std::string& text = value->second;
        if (text == row.text(defaults) || std::ranges::find(left_out, row.name) != left_out.end()) {
            continue;
        }
        const QString option = QString::fromStdString(row.option());
        const bool is_switch = row.placeholder.empty() && text.find(';') == std::string::npos;
        options << (is_switch ? option : option + QLatin1Char(' ') + QString::fromStdString(text));
    }
    return options.join(QLatin1Char(' '));
}

}  // namespace

QString optionsText(const Settings& settings) {
    return rowsText(analysis_settings(), settings_list(settings),
                    {"algorithm", "window", "hop", "f0"});
}

QString optionsText(const DriftSettings& settings) {
    std::vector<NamedValue> listed;
    for (const SettingRow<DriftSettings>& row : drift_settings()) {
        listed.emplace_back(row.name, row.text(settings));
    }
    return rowsText(drift_settings(), listed);
}

QString optionsText(const IdentifySettings& settings) {
    return rowsText(identify_settings(), settings_list(settings));
}

}  // namespace vybeg::ui
