#include "ui/import/open_options_json.h"

#include "ui/values/json_fields.h"

namespace vybeg::ui {

QJsonObject optionsToJson(const OpenOptions& options) {
    QJsonObject json;
    describe(JsonWriter(json), options);
    return json;
}

OpenOptions optionsFromJson(const QJsonObject& json) {
    OpenOptions options;
    describe(JsonReader(json), options);
    // Earlier versions kept the scale with the layout or the choice.
    for (const char* part : {"raw", "text"}) {
        options.scale *= json[QLatin1String(part)].toObject()[QStringLiteral("scale")].toDouble(1);
    }
    return options;
}

}  // namespace vybeg::ui
