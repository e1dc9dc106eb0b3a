#include "core/recording/arrays/tdms_scale.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <string_view>
#include <utility>

namespace vybeg {
namespace {

constexpr double raw_numbers = 0xFFFFFFFF;  // as the input source of a scale
constexpr double most_scales = 1000;
constexpr std::string_view count_name = "NI_Number_Of_Scales";

std::string scale_name(int index, std::string_view rest) {
    return "NI_Scale[" + std::to_string(index) + "]_" + std::string(rest);
}

// The scales of one object.
class Scales {
public:
    Scales(const FileBytes& file, const TdmsObject& channel, const TdmsObject& owner)
        : file_(file), channel_(channel), owner_(owner) {}

    std::optional<double> number(const std::string& name) const {
        const auto found = owner_.properties.find(name);
        return found == owner_.properties.end() ? std::nullopt : found->second.number;
    }

    std::string text(const std::string& name) const {
        const auto found = owner_.properties.find(name);
        return found == owner_.properties.end() ? "" : found->second.text;
    }

    // Number of scales by the file, otherwise of those described.
    double count() const {
        if (const auto told = number(std::string(count_name))) {
            return *told;
        }
        int found = 0;
        while (found < most_scales && !text(scale_name(found, "Scale_Type")).empty()) {
            ++found;
        }
        return found;
    }

    Result<TdmsScaling> read() const {
        const double scales = count();
        if (!(scales <= most_scales)) {
            return damaged(
                VYBEG_MESSAGE("Words", "the channel %1 has an impossible number of scales"));
        }
        TdmsScaling scaling;
        // From the last scale back to the raw numbers; the step found first is applied last.
        auto index = static_cast<int>(scales) - 1;
        for (int seen = 0;; ++seen) {
            const std::string type = text(scale_name(index, "Scale_Type"));
            if (type.empty()) {  // raw number of DAQmx with this id
                scaling.scaler = static_cast<std::uint32_t>(index);
                break;
            }
            if (seen > scales) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has scales that are each other's input"));
            }
            TRY(take(type, index, scaling));
            const double input =
                number(scale_name(index, type + "_Input_Source")).value_or(raw_numbers);
            if (input == raw_numbers || input == -1) {
                break;
            }
            if (!(input >= 0 && input < scales)) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has a scale whose input does not exist"));
            }
            index = static_cast<int>(input);
        }
        std::reverse(scaling.steps.begin(), scaling.steps.end());
        fold(scaling);
        return scaling;
    }

private:
    Status take(const std::string& type, int index, TdmsScaling& scaling) const {
        if (type == "Linear") {
            const auto slope = number(scale_name(index, "Linear_Slope"));
            const auto intercept = number(scale_name(index, "Linear_Y_Intercept"));
            if (!slope || !intercept) {
                return damaged(VYBEG_MESSAGE(
                    "Words", "the channel %1 has a linear scale without slope or intercept"));
            }
            scaling.steps.emplace_back(TdmsPolynomial{{*intercept, *slope}});
        } else if (type == "Polynomial") {
            constexpr double usual = 4;
            const double size =
                number(scale_name(index, "Polynomial_Coefficients_Size")).value_or(usual);
            const auto coefficients = list(scale_name(index, "Polynomial_Coefficients"), size);
            if (!coefficients) {
                return damaged(VYBEG_MESSAGE(
                    "Words",
                    "the channel %1 has a polynomial scale without all of its coefficients"));
            }
            scaling.steps.emplace_back(TdmsPolynomial{*coefficients});
        } else if (type == "Table") {
            return take_table(index, scaling);
        } else {
            return file_.error(
                ErrorCode::format_unsupported,
                {"TDMS", words(VYBEG_MESSAGE("Words", "a scale of the kind \"%1\" (channel %2)"),
                               {type, channel_.channel})});
        }
        return {};
    }

    // "Scaled values" of the properties are the input, "pre-scaled" the output.
    Status take_table(int index, TdmsScaling& scaling) const {
        const double size = number(scale_name(index, "Table_Scaled_Values_Size")).value_or(0);
        auto x = list(scale_name(index, "Table_Scaled_Values"), size);
        auto y = list(scale_name(index, "Table_Pre_Scaled_Values"), size);
        const auto falls = [](const std::vector<double>& values) {
            return std::adjacent_find(values.begin(), values.end(), std::less_equal<double>()) ==
                   values.end();
        };
        if (!x || !y || x->empty() ||
            number(scale_name(index, "Table_Pre_Scaled_Values_Size")).value_or(size) != size) {
            return damaged(VYBEG_MESSAGE(
                "Words", "the channel %1 has a table scale without all of its values"));
        }
        if (x->size() > 1 && falls(*x)) {
            std::reverse(x->begin(), x->end());
            std::reverse(y->begin(), y->end());
        }
        if (std::adjacent_find(x->begin(), x->end(), [](double a, double b) { return !(a < b); }) !=
            x->end()) {
            return damaged(VYBEG_MESSAGE(
                "Words", "the channel %1 has a table scale that neither rises nor falls"));
        }
        scaling.steps.emplace_back(TdmsTable{std::move(*x), std::move(*y)});
        return {};
    }

    // name[0], name[1], ...; empty if one is missing.
    std::optional<std::vector<double>> list(const std::string& name, double size) const {
        std::vector<double> values;
        for (int i = 0; i < size; ++i) {
            const auto value = number(name + "[" + std::to_string(i) + "]");
            if (!value || !std::isfinite(*value)) {
                return std::nullopt;
            }
            values.push_back(*value);
        }
        return values;
    }

    // Moves linear steps at the beginning into the scale of the decoder.
    static void fold(TdmsScaling& scaling) {
        auto& steps = scaling.steps;
        while (!steps.empty()) {
            const auto* line = std::get_if<TdmsPolynomial>(&steps.front());
            if (!line || line->coefficients.size() != 2) {
                return;
            }
            const double offset = line->coefficients[0];
            const double slope = line->coefficients[1];
            scaling.linear.gain *= slope;
            scaling.linear.offset = scaling.linear.offset * slope + offset;
            steps.erase(steps.begin());
        }
    }

    // %1 stands for the channel.
    Error damaged(const char* text) const {
        return file_.error(ErrorCode::format_damaged, {"TDMS", words(text, {channel_.channel})});
    }

    const FileBytes& file_;
    const TdmsObject& channel_;
    const TdmsObject& owner_;
};

double value_at(const TdmsPolynomial& polynomial, double x) {
    double y = 0;
    for (auto c = polynomial.coefficients.rbegin(); c != polynomial.coefficients.rend(); ++c) {
        y = y * x + *c;
    }
    return y;
}

double value_at(const TdmsTable& table, double x) {
    const auto next = std::upper_bound(table.x.begin(), table.x.end(), x);
    if (next == table.x.begin() || std::isnan(x)) {
        return std::isnan(x) ? x : table.y.front();
    }
    if (next == table.x.end()) {
        return table.y.back();
    }
    const auto i = static_cast<std::size_t>(next - table.x.begin());
    const double part = (x - table.x[i - 1]) / (table.x[i] - table.x[i - 1]);
    return table.y[i - 1] + part * (table.y[i] - table.y[i - 1]);
}

class ScaledSource final : public SampleSource {
public:
    ScaledSource(std::shared_ptr<const SampleSource> source, TdmsScaling c, TdmsScaling d)
        : source_(std::move(source)), c_(std::move(c)), d_(std::move(d)) {}

    std::int64_t frames() const override { return source_->frames(); }
    bool seeks() const override { return source_->seeks(); }

    Status read(std::int64_t first, std::span<double> c, std::span<double> d) const override {
        TRY(source_->read(first, c, d));
        apply(c_, c);
        apply(d_, d);
        return {};
    }

private:
    static void apply(const TdmsScaling& scaling, std::span<double> samples) {
        for (const auto& step : scaling.steps) {
            std::visit(
                [&](const auto& function) {
                    for (double& sample : samples) {
                        const double y = value_at(function, sample);
                        sample = std::isfinite(y) && !std::isnan(sample)
                                     ? y
                                     : std::numeric_limits<double>::quiet_NaN();
                    }
                },
                step);
        }
    }

    std::shared_ptr<const SampleSource> source_;
    TdmsScaling c_;
    TdmsScaling d_;
};

}  // namespace

Result<TdmsScaling> tdms_scaling(const FileBytes& file,
                                 const std::vector<const TdmsObject*>& nearest_first) {
    for (const TdmsObject* owner : nearest_first) {
        const Scales scales(file, *nearest_first.front(), *owner);
        if (scales.text("NI_Scaling_Status") == "scaled") {
            return TdmsScaling{};
        }
        if (scales.count() >= 1) {
            return scales.read();
        }
    }
    return TdmsScaling{};
}

std::shared_ptr<const SampleSource> scaled_by(std::shared_ptr<const SampleSource> source,
                                              const TdmsScaling& c, const TdmsScaling& d) {
    if (c.steps.empty() && d.steps.empty()) {
        return source;
    }
    return std::make_shared<ScaledSource>(std::move(source), c, d);
}

}  // namespace vybeg
